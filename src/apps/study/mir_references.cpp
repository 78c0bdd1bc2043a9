#include "apps/study/mir_references.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "apps/study/folder.h"
#include "nacre/bsdf/models/special_effect.h"
#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/core/progress.h"
#include "nacre/core/random.h"
#include "nacre/core/sha256.h"
#include "nacre/core/version.h"
#include "nacre/io/described_toml.h"
#include "nacre/io/image_difference.h"
#include "nacre/io/recipe_file.h"
#include "nacre/nacre.h"
#include "nacre/render/builtin_scenes.h"
#include "nacre/render/environment.h"
#include "nacre/render/render_image.h"
#include "nacre/render/scene_description.h"

namespace nacre::study {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int kSpectralBins = 30;

struct ReferencePicture {
    const char* name;
    const char* paint;
    bsdf::Model model;
    const char* how;
};

/// quick: two of them, to see that all works.
std::vector<ReferencePicture> all_references(bool quick) {
    const char* walks = "random walks through the layers of the paint, unbiased";
    const char* film = "microfacets under one film, exact at each wavelength";
    const char* mean = "the mean over all facets, by quadrature over thickness and cone";
    const bsdf::Model walk = named_model("walk"), thin_film = named_model("thin-film");
    const bsdf::Model smooth = bsdf::SpecialEffectModel{.smooth_ndf = true};
    std::vector<ReferencePicture> all = {
        {"metallic-gray", "paints/metallic-gray.toml", walk, walks},
        {"cadmium-red", "paints/cadmium-red.toml", walk, walks},
        {"tio2-mica-80", "paints/tio2-mica-80.toml", walk, walks},
        {"tio2-mica-110", "paints/tio2-mica-110.toml", walk, walks},
        {"film-570", "studies/mir-2022/facets-570.toml", thin_film, film},
        {"film-665", "studies/mir-2022/facets-665.toml", thin_film, film},
        {"facets-570", "studies/mir-2022/facets-570.toml", smooth, mean},
        {"facets-665", "studies/mir-2022/facets-665.toml", smooth, mean}};
    if (quick) all = {all[0], all[4]};
    return all;
}

/// The ball in the studio, so that no one needs to know what is built in.
render::SceneDescription scene_with(const std::string& recipe) {
    render::SceneDescription scene = render::builtin_scene("sphere");
    scene.materials.at("paint") = render::PaintMaterial{.recipe = recipe};
    auto& studio = std::get<render::StudioEnvironment>(*scene.environment);
    if (studio.boxes.empty()) studio.boxes = render::studio_soft_boxes();
    return scene;
}

io::Image render_batch(const render::Scene& scene, render::RenderOptions options, int batch,
                       std::uint64_t seed, const Progress& progress) {
    options.seed = hash_of(seed, static_cast<std::uint64_t>(batch));
    const render::RenderResult result = render::render(scene, options, progress);
    if (!result.complete) throw Interrupted("stopped");
    if (result.invalid_paths > 0) {
        throw Error(
            fmt::format("{} paths of a reference picture were not finite", result.invalid_paths));
    }
    io::Image image = render::image_of(result, {});
    std::erase_if(image.channels, [](const io::Channel& c) {
        return c.name.starts_with("albedo.") || c.name.starts_with("normal.");
    });
    return image;
}

/// The files of one reference, but for its record.
std::vector<fs::path> files_of(const fs::path& folder, const ReferencePicture& reference) {
    std::vector<fs::path> files;
    for (const char* ending : {".exr", ".png", ".toml", ".scene.toml"}) {
        files.push_back(folder / (std::string(reference.name) + ending));
    }
    return files;
}

json description_of(const MirSettings& settings, const ReferencePicture& reference) {
    return {{"study", "mir-2022"},
            {"version", version()},
            {"name", reference.name},
            {"model", reference.model.text()},
            {"how", reference.how},
            {"recipe_sha256", io::recipe_hash(io::read_recipe(shipped_file(reference.paint)))},
            {"size", settings.size},
            {"batches", kReferenceBatches},
            {"samples_per_pixel", 4 * settings.samples},
            {"seed", settings.seed},
            {"spectral_bins", kSpectralBins}};
}

void write_reference(const MirSettings& settings, const ReferencePicture& reference,
                     const Stage& stage) {
    const fs::path record_file = settings.folder / (std::string(reference.name) + ".json");
    const std::vector<fs::path> files = files_of(settings.folder, reference);
    json record = description_of(settings, reference);
    const std::string fingerprint = sha256_hex(record.dump());
    if (!find_record(record_file, fingerprint, files).is_null()) return;
    check_own(record_file);
    for (const fs::path& file : files) check_own(file, record_file);

    const paint::Recipe recipe = io::read_recipe(shipped_file(reference.paint));
    const render::SceneDescription scene = scene_with(std::string(reference.name) + ".toml");
    std::vector<io::Image> batches;
    stage(fmt::format("reference: {}", reference.name), [&](const Progress& progress) {
        const render::Scene compiled(
            scene, {{"paint", Paint(recipe).appearance(reference.model, {}, progress)}});
        render::RenderOptions options;
        options.width = options.height = settings.size;
        options.samples_per_pixel = std::max(1, 4 * settings.samples / kReferenceBatches);
        options.spectral_bins = kSpectralBins;
        for (int batch = 0; batch < kReferenceBatches; ++batch) {
            const auto part = [&](double fraction) {
                return !progress || progress((batch + fraction) / kReferenceBatches);
            };
            batches.push_back(render_batch(compiled, options, batch, settings.seed, part));
        }
    });
    io::Image image = mean_with_standard_error(batches);
    image.metadata["nacre:study"] = fmt::format("mir-2022, reference {}", reference.name);
    image.metadata["nacre:samples_per_pixel"] = fmt::format(
        "{}", std::max(1, 4 * settings.samples / kReferenceBatches) * kReferenceBatches);
    io::write_exr(files[0], image);
    io::write_png(files[1], image);
    write_file_atomically(files[2], io::write_recipe(recipe));
    write_file_atomically(files[3], io::write_described(paint::Described::to_inspect(scene)));
    write_record(record_file, record, fingerprint, files);
}

std::string readme(const MirSettings& settings) {
    std::string text = fmt::format(
        "# Reference pictures of the comparison of 2022\n\n"
        "Converged spectral pictures of a ball of 100 mm, {0} x {0} pixels, {1} samples each in "
        "{2} batches, by nacre {3}.\nEach is NAME.exr with its recipe NAME.toml and its scene "
        "NAME.scene.toml, lamps and every default written\nout; NAME.json tells model and "
        "settings. SHA256SUMS has the checksums: `sha256sum -c SHA256SUMS`.\n\n"
        "Channels: R, G, B in linear Rec. 709, 1 being the perfect diffuser in full light of D65; "
        "A, the fraction\nof samples that met the ball; S0.405,000000nm and on, spectral radiance "
        "in bins of 10 nm, in the layout of\nFichet et al. 2021; and of each a channel stderr.NAME "
        "with its standard error, estimated from the batches.\n\n"
        "To compare a picture: `nacre diff PICTURE.exr NAME.exr` reports z-scores.\n\n"
        "| name | model | how |\n| --- | --- | --- |\n",
        settings.size, 4 * settings.samples, kReferenceBatches, version());
    for (const ReferencePicture& reference : all_references(settings.quick)) {
        text += fmt::format("| {} | {} | {} |\n", reference.name, reference.model.info().name,
                            reference.how);
    }
    return text;
}

}  // namespace

io::Image mean_with_standard_error(const std::vector<io::Image>& batches) {
    require_in_range(static_cast<double>(batches.size()), 2, 1e6, "batches");
    io::Image mean = batches.front();
    const auto count = static_cast<double>(batches.size());
    std::vector<io::Channel> errors;
    for (std::size_t c = 0; c < mean.channels.size(); ++c) {
        io::Channel& channel = mean.channels[c];
        io::Channel error{io::standard_error_channel(channel.name),
                          std::vector<float>(mean.pixel_count())};
        for (const io::Image& batch : batches) {
            if (batch.channels.size() != mean.channels.size() ||
                batch.channels[c].name != channel.name || batch.width != mean.width ||
                batch.height != mean.height) {
                throw DomainError("the batches of a picture differ in size or channels");
            }
        }
        for (std::size_t i = 0; i < mean.pixel_count(); ++i) {
            double sum = 0, squares = 0;
            for (const io::Image& batch : batches) sum += batch.channels[c].pixels[i];
            const double m = sum / count;
            for (const io::Image& batch : batches) {
                const double deviation = batch.channels[c].pixels[i] - m;
                squares += deviation * deviation;
            }
            channel.pixels[i] = static_cast<float>(m);
            error.pixels[i] = static_cast<float>(std::sqrt(squares / (count - 1) / count));
        }
        if (channel.name != "A") errors.push_back(std::move(error));
    }
    for (io::Channel& error : errors) mean.channels.push_back(std::move(error));
    mean.metadata[io::kBatchesKey] = fmt::format("{}", batches.size());
    return mean;
}

fs::path write_references(const MirSettings& settings, const Stage& stage) {
    require_valid(settings);
    const FolderLock lock(settings.folder);
    const fs::path sums_file = settings.folder / "SHA256SUMS",
                   about = settings.folder / "README.md";
    std::string sums;
    for (const ReferencePicture& reference : all_references(settings.quick)) {
        write_reference(settings, reference, stage);
        std::vector<fs::path> files = files_of(settings.folder, reference);
        files.push_back(settings.folder / (std::string(reference.name) + ".json"));
        for (const fs::path& file : files) {
            sums += fmt::format("{}  {}\n", sha256_hex(read_file(file, io::kMaxImageFileBytes)),
                                file.filename().string());
        }
    }
    const fs::path first =
        settings.folder / (std::string(all_references(settings.quick)[0].name) + ".json");
    check_own(sums_file, first);
    check_own(about, first);
    write_file_atomically(about, readme(settings));
    sums += fmt::format("{}  README.md\n", sha256_hex(read_file(about, io::kMaxImageFileBytes)));
    write_file_atomically(sums_file, sums);
    return settings.folder;
}

}  // namespace nacre::study
