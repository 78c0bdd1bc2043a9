#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <numbers>

#include "apps/cli/info_facts.h"
#include "apps/cli/options.h"
#include "apps/cli/paint_options.h"
#include "nacre/core/file.h"
#include "nacre/core/text.h"
#include "nacre/io/brdf_table_file.h"
#include "nacre/io/file_kind.h"
#include "nacre/io/image.h"
#include "nacre/io/measured_brdf_file.h"
#include "nacre/io/measurement_file.h"
#include "nacre/io/recipe_file.h"
#include "nacre/io/solved_paint_file.h"
#include "nacre/io/toml_document.h"
#include "nacre/measure/image_clarity.h"
#include "nacre/nacre.h"
#include "nacre/paint/expansion.h"
#include "nacre/paint/orientation.h"
#include "nacre/render/mesh_file.h"
#include "nacre/render/scene_file.h"
#include "nacre/render/shard_file.h"

namespace nacre::cli {

namespace {

struct InfoOptions : CommonOptions {
    std::string file;
};

std::string diameter_text(const paint::FlakeSpecies& flakes) {
    if (!flakes.quantiles) return fmt::format("diameter {} um", flakes.diameter_um);
    const auto& [d10, d50, d90] = paint::quantiles_of(*flakes.quantiles);
    const bool typical = std::holds_alternative<paint::MedianDiameter>(*flakes.quantiles);
    return fmt::format("diameters d10 {}, d50 {}, d90 {} um{}", d10, d50, d90,
                       typical ? " (d10 and d90 typical)" : "");
}

std::string orientation_text(const paint::Orientation& orientation) {
    using Law = paint::Orientation::Law;
    if (orientation.law == Law::tabulated) {
        return fmt::format("tabulated tilts, half within {:.3g} deg",
                           paint::median_tilt_deg(orientation));
    }
    return fmt::format(
        "{}roughness {}{}", orientation.law == Law::ggx ? "GGX " : "", orientation.beckmann_alpha,
        orientation.alpha_bottom > 0 ? fmt::format(" to {} at the bottom", orientation.alpha_bottom)
                                     : "");
}

/// Species of flakes that were one in the recipe, or one face of it.
struct SolvedFlakes {
    std::string name;
    int count = 0;
    double smallest_um = INFINITY, largest_um = 0, flattest = INFINITY, steepest = 0, deep = 0;

    void add(const paint::FlakeSpecies& flakes, double thickness_um) {
        const paint::FlakeSizes sizes = flakes.sizes();
        ++count;
        smallest_um = std::min(smallest_um, sizes.smallest_um());
        largest_um = std::max(largest_um, sizes.largest_um());
        flattest = std::min(flattest, flakes.surface_alpha());
        steepest = std::max(steepest, flakes.surface_alpha());
        deep += flakes.area_density_per_um() * thickness_um;
    }
};

std::string solved_name(const paint::FlakeSpecies& flakes) {
    using Face = optics::Platelet::Face;
    const auto* platelet = std::get_if<optics::Platelet>(&flakes.body);
    const Face face = platelet ? platelet->face : Face::any;
    return fmt::format("{}{}", flakes.name.empty() ? "unnamed" : flakes.name,
                       face == Face::bare     ? ", bare side"
                       : face == Face::coated ? ", coated side"
                                              : "");
}

/// What is solved in place of a recipe that is not plain.
void describe_expansion(Facts& facts, const paint::Recipe& recipe) {
    if (paint::is_plain(recipe)) return;
    const paint::Recipe whole = paint::expanded(recipe);
    for (std::size_t i = 0; i < whole.layers.size(); ++i) {
        const paint::Layer& layer = whole.layers[i];
        facts.add(fmt::format("solved layer[{}]", i),
                  "{:.6g} um, {} species of flakes, {} pigments", layer.thickness_um,
                  layer.flakes.size(), layer.pigments.size());
        std::vector<SolvedFlakes> groups;
        for (const paint::FlakeSpecies& flakes : layer.flakes) {
            const std::string name = solved_name(flakes);
            if (groups.empty() || groups.back().name != name) groups.push_back({.name = name});
            groups.back().add(flakes, layer.thickness_um);
        }
        for (const SolvedFlakes& group : groups) {
            facts.add(fmt::format("solved layer[{}]", i),
                      "{} ({} species, diameters {:.4g} to {:.4g} um, roughness {:.4g} to {:.4g}, "
                      "{:.4g} flakes deep)",
                      group.name, group.count, group.smallest_um, group.largest_um, group.flattest,
                      group.steepest, group.deep);
        }
        for (const paint::Pigment& pigment : layer.pigments) {
            facts.add(fmt::format("solved layer[{}]", i), "{}",
                      pigment.name.empty() ? "unnamed pigment" : pigment.name);
        }
    }
}

void describe_recipe(Facts& facts, const paint::Recipe& recipe) {
    facts.add("name", "{}", recipe.name);
    facts.add("recipe SHA-256", "{}", io::recipe_hash(recipe));
    facts.add("binder", "{}", recipe.binder.name());
    if (const auto lean = recipe.flake_lean()) {
        facts.add("lean of the flakes", "{} deg towards the azimuth {} deg", lean->tilt_deg,
                  lean->azimuth_deg);
    }
    if (recipe.clearcoat) {
        facts.add("clearcoat", "{} um, roughness {}", recipe.clearcoat->thickness_um,
                  recipe.clearcoat->roughness);
    }
    if (const double spread = recipe.coat_spread(); spread > 0) {
        facts.add("coat thickness", "spread by {} um over the panel, {:.3g} % of the mean",
                  recipe.clearcoat->thickness_spread_um, 100 * spread);
    }
    if (const auto peel = recipe.orange_peel()) {
        std::string bands;
        for (const paint::WaveBand& band : paint::kWaveBands) {
            bands += fmt::format("{} {}, ", band.key, *peel.*band.slope);
        }
        facts.add("orange peel", "{}slope of all {:.4g}", bands, peel->slope());
        const double facets = recipe.clearcoat->roughness / std::numbers::sqrt2;
        facts.add("image clarity", "a mirrored grille of {:.3g} deg keeps half its contrast",
                  measure::half_contrast_period_deg(std::hypot(peel->slope(), facets)));
    }
    for (std::size_t i = 0; i < recipe.layers.size(); ++i) {
        const paint::Layer& layer = recipe.layers[i];
        facts.add(fmt::format("layer[{}]", i), "{} um, {} species of flakes, {} pigments",
                  layer.thickness_um, layer.flakes.size(), layer.pigments.size());
        for (std::size_t j = 0; j < layer.flakes.size(); ++j) {
            const paint::FlakeSpecies& flakes = layer.flakes[j];
            const double density = flakes.area_density_per_um();
            facts.add(fmt::format("layer[{}].flakes[{}]", i, j),
                      "{} (thickness {:.6g} um, {}, {}, area density {:.6g} per um, {:.4g} flakes "
                      "deep)",
                      flakes.name.empty() ? "unnamed" : flakes.name, flakes.thickness_um(),
                      diameter_text(flakes), orientation_text(flakes.orientation), density,
                      density * layer.thickness_um);
        }
    }
    describe_expansion(facts, recipe);
    if (recipe.microfacet) {
        facts.add("microfacet", "roughness {}, film {} nm of index {}, base {} + {}i",
                  recipe.microfacet->alpha, recipe.microfacet->film_thickness_nm,
                  recipe.microfacet->film_ior, recipe.microfacet->base_ior,
                  recipe.microfacet->base_extinction);
    }
}

void describe_solution(Facts& facts, const solver::SolvedPaint& paint) {
    facts.add("wavelengths", "{} from {} to {} nm", paint.wavelengths_nm().size(),
              paint.wavelengths_nm().front(), paint.wavelengths_nm().back());
    facts.add("nodes", "{} that leave the coat, {} beyond the critical angle",
              paint.report.exit_nodes, paint.report.inner_nodes);
    facts.add("azimuthal orders", "{}, tail {:.2g} of the peak", paint.report.orders,
              paint.report.azimuthal_tail);
    facts.add("unresolved scattering", "{:.2g}", paint.report.unresolved_scattering);
    facts.add("multiple scattering", "rank {}, {} coefficients", paint.multiple_scattering.rank(),
              paint.multiple_scattering.coefficient.size());
}

/// A recipe, or a solved paint.
void describe_paint(const InfoOptions& options, Facts& facts, io::TypedFile file) {
    const std::size_t bytes = file.bytes.size();
    const Paint paint = open_typed(std::move(file));
    const bool solved = paint.kind() == Kind::solved_paint;
    if (solved) {
        facts.add("kind", "solved paint (HDF5, format {})", io::kSolvedPaintFormatVersion);
        facts.add("bytes", "{}", bytes);
    } else {
        facts.add("kind", "recipe");
    }
    describe_recipe(facts, paint.recipe());
    if (solved) describe_solution(facts, *paint.solved());
    warn_of_implausible(options, paint);
}

void describe_brdf_table(Facts& facts, const std::string& bytes, const std::string& name) {
    const io::BrdfTable table = io::parse_brdf_table(bytes, name);
    facts.add("kind", "BRDF table, {} (HDF5, format {})", table.index() == 0 ? "raw" : "svd",
              io::kBrdfTableFormatVersion);
    facts.add("bytes", "{}", bytes.size());
    std::visit(
        [&](const auto& t) {
            facts.add("name", "{}", t.paint);
            facts.add("nodes", "{} polar angles, {} azimuths", t.grid.angles, t.grid.azimuths);
            facts.add("values", "{} bytes", t.bytes());
        },
        table);
    if (const auto* svd = std::get_if<bsdf::CompressedBrdfTable>(&table)) {
        facts.add("terms", "{}, {}, {} for red, green, blue", svd->rank[0], svd->rank[1],
                  svd->rank[2]);
    }
}

void describe_rgl(Facts& facts, const std::string& bytes, const std::string& name) {
    const bsdf::RglTable table = io::parse_rgl(bytes, name);
    const auto degrees = [](float rad) { return rad * 180 / std::numbers::pi; };
    facts.add("kind", "measured BRDF, adaptive parameterization (RGL, .bsdf)");
    facts.add("bytes", "{}", bytes.size());
    facts.add("description", "{}", table.description);
    facts.add("surface", "{}", table.isotropic() ? "isotropic" : "anisotropic");
    facts.add("phi_i", "{} from {:.4g} to {:.4g} deg", table.phi_i.size(),
              degrees(table.phi_i.front()), degrees(table.phi_i.back()));
    facts.add("theta_i", "{} from {:.4g} to {:.4g} deg", table.theta_i.size(),
              degrees(table.theta_i.front()), degrees(table.theta_i.back()));
    facts.add("points", "{} x {}", table.resolution, table.resolution);
    facts.add("ndf", "{} x {}", table.ndf.rows, table.ndf.columns);
    facts.add("vndf", "{} x {}", table.vndf_rows, table.vndf_columns);
    if (table.is_rgb()) {
        facts.add("colour", "linear RGB");
    } else {
        facts.add("wavelengths", "{} from {} to {} nm", table.wavelengths.size(),
                  table.wavelengths.front(), table.wavelengths.back());
    }
    facts.add("jacobian", "{}", table.jacobian ? "yes" : "no");
    facts.add("not measured", "{:.4g} % of the points (luminance 0)",
              100.0 * std::count(table.luminance.begin(), table.luminance.end(), 0.0f) /
                  static_cast<double>(table.luminance.size()));
}

void describe_merl(Facts& facts, const std::string& bytes, const std::string& name) {
    const bsdf::MerlTable table = io::parse_merl(bytes, name);
    facts.add("kind", "measured BRDF, half and difference angles (MERL, .binary)");
    facts.add("bytes", "{}", bytes.size());
    facts.add("cells", "{} theta_half, {} theta_difference, {} phi_difference", table.half,
              table.difference, table.azimuths);
    const auto missing =
        std::count_if(table.values.begin(), table.values.end(), [](double v) { return v < 0; });
    facts.add("not measured", "{:.4g} % of the values (negative)",
              100.0 * static_cast<double>(missing) / static_cast<double>(table.values.size()));
    for (int c = 0; c < 3; ++c) {
        const auto first = table.values.begin() + static_cast<std::ptrdiff_t>(c * table.cells());
        const double largest =
            *std::max_element(first, first + static_cast<std::ptrdiff_t>(table.cells()));
        facts.add(std::string("largest ") + (c == 0   ? "red"
                                             : c == 1 ? "green"
                                                      : "blue"),
                  "{:.6g} per sr", largest * bsdf::MerlTable::kScale[c]);
    }
}

void describe_image(Facts& facts, const std::string& bytes, const std::string& name) {
    const io::Image image = io::parse_image(bytes, name);
    facts.add("kind", "picture");
    facts.add("bytes", "{}", bytes.size());
    facts.add("size", "{} x {} pixels", image.width, image.height);
    for (const io::Channel& channel : image.channels) {
        double sum = 0, smallest = INFINITY, largest = -INFINITY;
        std::size_t finite = 0;
        for (float v : channel.pixels) {
            if (!std::isfinite(v)) continue;
            ++finite;
            sum += v;
            smallest = std::min<double>(smallest, v);
            largest = std::max<double>(largest, v);
        }
        facts.add("channel " + channel.name, "mean {:.6g}, from {:.6g} to {:.6g}, {} not finite",
                  sum / static_cast<double>(std::max<std::size_t>(finite, 1)), smallest, largest,
                  channel.pixels.size() - finite);
    }
    for (const auto& [key, value] : image.metadata) facts.add(key, "{}", value);
}

void describe_picture_shard(Facts& facts, const std::string& bytes, const std::string& name) {
    const render::PictureShard shard = render::parse_shard(bytes, name);
    facts.add("kind", "shard {}/{} of a picture (HDF5, format {}); nacre merge puts all together",
              shard.shard.number, shard.shard.count, render::kShardFormatVersion);
    facts.add("bytes", "{}", bytes.size());
    facts.add("samples", "{} of {} per pixel", shard.sums.picture.passes.count,
              shard.options.samples_per_pixel);
    facts.add("seconds", "{:.3g}", shard.sums.seconds);
    for (const auto& [key, value] : render::identity_of(shard)) facts.add(key, "{}", value);
    facts.add("nacre:scene", "{}", shard.metadata.at("nacre:scene"));
}

/// So that no output is a file that one of its recipes names: nothing else of theirs is asked.
void read_recipes_of(const render::SceneDescription& scene) {
    for (const auto& [name, material] : scene.materials) {
        const auto* paint = std::get_if<render::PaintMaterial>(&material);
        if (!paint || paint->recipe.empty()) continue;
        try {
            io::parse_recipe(read_file(paint->recipe, io::kMaxTextBytes), paint->recipe.string(),
                             scene.references.beside(paint->recipe));
        } catch (const InputError&) {  // whoever renders the scene says what is wrong
        }
    }
}

/// The recipe of the file with the values of --set.
std::string describe_changed(const InfoOptions& options) {
    const Paint paint = open_paint(options, options.file);
    Facts facts;
    facts.add("file", "{}", options.file);
    facts.add("kind", "recipe, changed by --set");
    describe_recipe(facts, paint.recipe());
    return facts.text();
}

std::string describe(const InfoOptions& options) {
    if (!options.set.empty()) return describe_changed(options);
    const io::SampleName name = io::split_sample_name(find_paint(options.file).string());
    const std::string path = name.file.string();
    constexpr std::size_t kMaxBytes =
        std::max({io::kMaxImageFileBytes, io::kMaxMeasuredBytes, render::kMaxMeshBytes});
    io::TypedFile file =
        io::typed_file(read_file(path, kMaxBytes), path, references_of(options, path));
    Facts facts;
    facts.add("file", "{}", options.file);
    if (!name.sample.empty() && file.kind != io::FileKind::measured_colours) {
        throw InputError(fmt::format("{}: is {}; only measured colours have samples", file.name,
                                     io::words_for(file.kind)));
    }
    switch (file.kind) {
        case io::FileKind::recipe:
        case io::FileKind::solved_paint:
            describe_paint(options, facts, std::move(file));
            break;
        case io::FileKind::picture:
            describe_image(facts, file.bytes, file.name);
            break;
        case io::FileKind::brdf_table:
            describe_brdf_table(facts, file.bytes, file.name);
            break;
        case io::FileKind::picture_shard:
            describe_picture_shard(facts, file.bytes, file.name);
            break;
        case io::FileKind::rgl:
            describe_rgl(facts, file.bytes, file.name);
            break;
        case io::FileKind::merl:
            describe_merl(facts, file.bytes, file.name);
            break;
        case io::FileKind::measured_colours:
            for (const std::string& line : describe_measured_colours(facts, file, name.sample)) {
                warn(options, line);
            }
            break;
        case io::FileKind::scene: {
            const render::SceneDescription scene = render::parse_scene(file);
            if (!options.output.empty()) read_recipes_of(scene);
            describe_scene(facts, scene);
            break;
        }
        default:
            describe_other(facts, file);
    }
    return facts.text();
}

}  // namespace

Command add_info(CLI::App& program) {
    auto options = std::make_shared<InfoOptions>();
    CLI::App* info = program.add_subcommand("info", "Say what is in a file");
    info->add_option("FILE", options->file,
                     "Any that Nacre reads or writes; FILE#SAMPLE for one of several measured")
        ->required();
    add_set(*info, *options);
    add_input_options(*info, *options);
    add_quiet(*info, *options);
    add_output(*info, *options);
    info->footer(
        "Checks the file on the way: a solved paint against its checksum, a recipe or a scene "
        "key by key, the meshes of a scene.\n\n"
        "Example:\n  nacre info gold.h5");
    return {info, [options] { return files_of(*options, {options->file}); },
            [options] {
                emit(*options, describe(*options));
                return ExitStatus::ok;
            }};
}

}  // namespace nacre::cli
