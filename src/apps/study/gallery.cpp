#include "apps/study/gallery.h"

#include <fmt/format.h>

#include <chrono>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <string>

#include "apps/study/folder.h"
#include "nacre/bsdf/tabulated/tabulated.h"
#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/core/sha256.h"
#include "nacre/core/version.h"
#include "nacre/io/brdf_table_file.h"
#include "nacre/io/recipe_file.h"
#include "nacre/io/solved_paint_file.h"
#include "nacre/montecarlo/discs/disc.h"
#include "nacre/render/builtin_scenes.h"
#include "nacre/render/render_image.h"
#include "nacre/solver/solver.h"
#include "nacre/spectra/spectrum.h"

namespace nacre::study {

PeakMemory::PeakMemory() {
    std::ofstream("/proc/self/clear_refs") << "5";  // resets VmHWM: proc(5)
}

double PeakMemory::mebibytes() const {
    std::ifstream status("/proc/self/status");
    std::string word;
    while (status >> word) {
        if (word != "VmHWM:") continue;
        double kibibytes = 0;
        if (status >> kibibytes) return kibibytes / 1024;
    }
    throw Error("the system does not tell how much memory this process uses (/proc/self/status)");
}

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

json description(const PictureJob& job) {
    const render::RenderOptions& r = job.render;
    return {{"version", version()},
            {"scene", job.scene},
            {"scene_scale", job.scene_scale},
            {"model", job.model.text()},
            {"recipe_sha256", io::recipe_hash(recipe_of(job))},
            {"width", r.width},
            {"height", r.height},
            {"samples_per_pixel", r.samples_per_pixel},
            {"footprint_pixels", r.footprint_pixels},
            {"seed", r.seed},
            {"max_depth", r.max_depth}};
}

double seconds_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The surface of a job, made from the files that a user would keep: solved paints and tables are
/// written and read back.
struct Prepared {
    std::shared_ptr<const bsdf::Bsdf> surface;
    std::size_t file_bytes = 0, data_bytes = 0;
};

/// The names of the materials that take the paint.
std::vector<std::string> painted_materials(const render::SceneDescription& scene) {
    std::vector<std::string> names;
    for (const auto& [name, material] : scene.materials) {
        if (std::holds_alternative<render::PaintMaterial>(material)) names.push_back(name);
    }
    return names;
}

/// The model of a job, told what the paint lies on.
bsdf::Model model_on(const render::SceneDescription& scene, const PictureJob& job) {
    std::vector<bsdf::PaintedShape> shapes;
    for (const std::string& material : painted_materials(scene)) {
        for (const bsdf::PaintedShape& shape : render::painted_shapes(scene, material)) {
            shapes.push_back(shape);
        }
    }
    bsdf::Model model = job.model;
    model.lie_on("of the scene " + job.scene, shapes);
    return model;
}

/// Of what is solved for a job.
fs::path table_of(const fs::path& folder, const PictureJob& job) {
    return folder / "tables" / (job.key + ".h5");
}

Prepared prepare(const PictureJob& job, const bsdf::Model& model, const fs::path& file,
                 const Progress& progress) {
    bsdf::ModelInput paint{.recipe = recipe_of(job)};
    Prepared out;
    if (model.info().solution != bsdf::Solution::none) {
        const solver::SolvedPaint solved =
            solver::solve(paint.recipe, spectra::default_wavelengths_nm(), {}, nullptr, progress);
        fs::create_directories(file.parent_path());
        if (const auto table = model.make_table(solved, progress)) {
            std::visit(
                [&](const auto& t) {
                    io::write_brdf_table(file, *t);
                    out.data_bytes = t->bytes();
                },
                *table);
            paint.table = bsdf::shared_brdf_table(io::read_brdf_table(file));
        } else {
            io::write_solved_paint(file, solved);
            paint.solved = std::make_shared<const solver::SolvedPaint>(io::read_solved_paint(file));
        }
        out.file_bytes = fs::file_size(file);
        if (!paint.table) out.data_bytes = out.file_bytes;
    }
    out.surface = model.make(paint, progress);
    return out;
}

render::SceneDescription scene_of(const PictureJob& job) {
    render::SceneDescription scene = render::builtin_scene(job.scene);
    const auto scale = static_cast<float>(job.scene_scale);
    for (render::Shape& shape : scene.shapes) {
        shape.transform.scale *= job.scene_scale;
        shape.transform.translation_mm = scale * shape.transform.translation_mm;
    }
    for (render::Light& light : scene.lights) {
        if (auto* rectangle = std::get_if<render::RectangleLight>(&light)) {
            rectangle->center_mm = scale * rectangle->center_mm;
            rectangle->target_mm = scale * rectangle->target_mm;
            rectangle->width_mm *= job.scene_scale;
            rectangle->height_mm *= job.scene_scale;
        }
    }
    render::Camera& camera = scene.camera;
    camera.position_mm = scale * camera.position_mm;
    camera.target_mm = scale * camera.target_mm;
    camera.aperture_radius_mm *= job.scene_scale;
    camera.focus_distance_mm *= job.scene_scale;
    return scene;
}

}  // namespace

paint::Recipe recipe_of(const PictureJob& job) {
    paint::Recipe recipe = io::read_recipe(job.paint);
    if (job.facet_count > 0) {
        if (!recipe.microfacet || !recipe.microfacet->facets) {
            throw InputError(fmt::format("{}: microfacet.facets: is missing; the study sets count",
                                         job.paint.string()));
        }
        recipe.microfacet->facets->count = job.facet_count;
    }
    for (paint::Layer& layer : recipe.layers) {
        for (paint::FlakeSpecies& flake : layer.flakes) {
            flake.diameter_um *= job.flake_scale;
            flake.diameter_spread_um *= job.flake_scale;
            if (!flake.quantiles) continue;
            if (auto* median = std::get_if<paint::MedianDiameter>(&*flake.quantiles)) {
                median->d50_um *= job.flake_scale;
                continue;
            }
            auto& all = std::get<paint::DiameterQuantiles>(*flake.quantiles);
            for (double* d : {&all.d10_um, &all.d50_um, &all.d90_um}) *d *= job.flake_scale;
        }
    }
    return recipe;
}

double flakes_on_ball(const paint::Recipe& recipe, double radius_mm) {
    constexpr double kUmPerMm = 1e3;
    return montecarlo::expected_discs(recipe, {kUmPerMm, kUmPerMm}) * 4 * std::numbers::pi *
           radius_mm * radius_mm;
}

std::string fingerprint(const PictureJob& job) { return sha256_hex(description(job).dump()); }

Gallery::Gallery(fs::path folder, Stage stage)
    : folder_(std::move(folder)), stage_(std::move(stage)) {
    make_folder(folder_ / "pictures");
}

Picture Gallery::make(const PictureJob& job) const {
    const fs::path base = folder_ / "pictures" / job.key;
    const fs::path exr = fs::path(base).concat(".exr"), png = fs::path(base).concat(".png"),
                   record_file = fs::path(base).concat(".json");
    const std::string print = fingerprint(job);
    const auto load = [&](const json& record) {
        Picture picture;
        picture.image = io::read_image(exr);
        picture.png = read_file(png);
        picture.prepare_s = record.at("prepare_s");
        picture.render_s = record.at("render_s");
        picture.processor_s = record.at("processor_s");
        picture.msamples_per_s = record.at("msamples_per_s");
        picture.peak_mib = record.at("peak_mib");
        picture.file_bytes = record.at("file_bytes");
        picture.data_bytes = record.at("data_bytes");
        return picture;
    };
    try {
        const json record = find_record(record_file, print, {exr, png});
        if (!record.is_null()) return load(record);
    } catch (const json::exception&) {  // a damaged record is no loss: the picture is made again
    }

    check_own(record_file, exr);
    for (const fs::path& file : {exr, png, table_of(folder_, job)}) check_own(file, record_file);
    json record = description(job);
    stage_(job.title, [&](const Progress& progress) {
        const PeakMemory memory;
        const auto start = std::chrono::steady_clock::now();
        const render::SceneDescription scene = scene_of(job);
        const Prepared prepared =
            prepare(job, model_on(scene, job), table_of(folder_, job), progress);
        render::PaintTable paints;
        for (const std::string& name : painted_materials(scene)) paints[name] = prepared.surface;
        const render::Scene compiled(scene, paints);
        const double prepare_s = seconds_since(start);
        const std::clock_t before = std::clock();
        const render::RenderResult result = render::render(compiled, job.render, progress);
        const double processor_s = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
        if (!result.complete) throw Interrupted("stopped");
        const double samples = static_cast<double>(result.samples) * result.width * result.height;
        io::Image image = render::image_of(result, {{"nacre:study", job.title}});
        // Only what the report reads: the pictures of a whole study stay small on disk.
        std::erase_if(image.channels, [](const io::Channel& c) {
            return c.name != "R" && c.name != "G" && c.name != "B" && c.name != "A";
        });
        io::write_exr(exr, image);
        io::write_png(png, image);
        record["title"] = job.title;
        record["prepare_s"] = prepare_s;
        record["render_s"] = result.seconds;
        record["processor_s"] = processor_s;
        record["msamples_per_s"] = samples / result.seconds / 1e6;
        record["peak_mib"] = memory.mebibytes();
        record["file_bytes"] = prepared.file_bytes;
        record["data_bytes"] = prepared.data_bytes;
        write_record(record_file, record, print, {exr, png});
    });
    return load(record);
}

}  // namespace nacre::study
