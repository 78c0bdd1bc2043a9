#include "apps/study/flakes.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "apps/study/folder.h"
#include "apps/study/mir_2022.h"
#include "nacre/bsdf/models/microflake.h"
#include "nacre/bsdf/models/nacre.h"
#include "nacre/core/file.h"
#include "nacre/core/random.h"
#include "nacre/core/version.h"
#include "nacre/io/recipe_file.h"
#include "nacre/montecarlo/discs/disc.h"
#include "nacre/montecarlo/discs/disc_scene.h"
#include "nacre/montecarlo/discs/disc_walk.h"
#include "nacre/paint/beckmann.h"
#include "nacre/solver/solver.h"
#include "nacre/spectra/spectrum.h"

namespace nacre::study {
namespace {

const char* const kRecipes[] = {"sparse-large-aluminium.toml", "dense-aluminium.toml",
                                "small-aluminium.toml", "interference.toml",
                                "sparse-interference.toml"};

void add_introduction(FlakesContext& context) {
    report::Report& report = context.report;
    report.paragraph(
        "The model `nacre` does not store flakes. It asks a hash which flakes lie in a pixel's "
        "footprint, and sums what those send that answer. Here it is held to paint in which every "
        "flake is there: discs of the recipe's sizes, tilts and films, laid out at random in a "
        "slab, "
        "with light traced among them until it leaves through the clearcoat. The two share the "
        "recipe, the optics of films and the law of sizes, and no formula.");
    if (context.settings.quick) {
        report.note("Quick: tiny pictures, two recipes. The numbers mean nothing.");
    }
    report.definitions(
        {{"Scene", fmt::format("a flat panel in a dark room; eye at {}°, lamp at {}° on the other "
                               "side, a square of {}°; so far away that angles hardly differ over "
                               "the picture",
                               kEye_deg, kLamp_deg, kLampSize_deg)},
         {"Contrast",
          "standard deviation of the pixels' luminance over its mean, from two "
          "renderings of the same flakes with independent noise, by their covariance"},
         {"Errors", "one standard error, by the jackknife over 16 pieces of the picture"},
         {"Program", fmt::format("nacre {}, seed {}", version(), context.settings.seed)}});
}

void add_verdicts(FlakesContext& context, const std::vector<FlakesVerdict>& verdicts) {
    context.report.heading(1, "All together", "all");
    report::Table table{
        .columns = {"recipe", "flakes deep", "diameter, um", "flakes a mm²", "mean, hashed / discs",
                    "... without diffraction", "contrast, hashed / discs", "farthest from 1",
                    "mean, without hot spot", "contrast, without hot spot", "ΔE of the means",
                    "spread of a*, ratio", "spread of b*, ratio"}};
    for (const FlakesVerdict& v : verdicts) {
        table.rows.push_back(
            {{v.name},
             report::number_cell(number(v.depth)),
             report::number_cell(number(v.diameter_um)),
             report::number_cell(flake_count(v.flakes_per_mm2)),
             report::number_cell(fmt::format("{} ± {}", number(v.mean_ratio.value),
                                             number(v.mean_ratio.standard_error, 1))),
             report::number_cell(number(v.mean_ratio_mirrors)),
             report::number_cell(number(v.contrast_ratio)),
             report::number_cell(number(v.worst_contrast_ratio)),
             report::number_cell(fmt::format("{} ± {}", number(v.mean_ratio_no_hot_spot.value),
                                             number(v.mean_ratio_no_hot_spot.standard_error, 1))),
             report::number_cell(number(v.contrast_ratio_no_hot_spot)),
             report::number_cell(number(v.mean_delta_e)),
             report::number_cell(number(v.a_ratio)),
             report::number_cell(number(v.b_ratio))});
    }
    context.report.table(table);
    context.report.paragraph(
        "Contrasts are compared at footprints of a quarter of a flake to 256 flakes: their ratio "
        "is "
        "the geometric mean over them. ΔE is CIEDE2000 between the mean colours at equal "
        "luminance. Spreads are standard deviations over the pixels at one flake a pixel, noise "
        "included.");
    context.report.heading(1, "What may differ, and why", "why");
    context.report.bullets(
        {"*The mean without the hot spot*, where opaque flakes are as wide as the layer is thick: "
         "it "
         "is that of the equation of transfer, and discs are brighter. The hot spot takes each "
         "flake "
         "for as lit and seen as discs are on average, and that light from what is scattered "
         "again: "
         "[the mean by direction](#directions).",
         "*The mean of small flakes*: diffraction. Discs with the recipe's tilts mirror into a "
         "lobe "
         "that is wider than that of their normals; the model takes the recipe's roughness for "
         "that "
         "of the whole lobe. Compare *without diffraction*.",
         "*Contrast where pixels are smaller than flakes*: a piece of a flake is lit and seen, or "
         "not, and the model dims it instead. [What hides a flake](#hiding) has the numbers for "
         "whole flakes.",
         "*Contrast under wide lamps*: rings of the diffraction pattern reach beyond the lamp's "
         "image. "
         "The model takes their light for an even background, which is within 5 % of the "
         "pattern's contrast.",
         "*Dark pixels*: between flakes that answer, discs leave gaps that are darker than the "
         "model's, which spreads all light that met more than one flake evenly.",
         "*Crescents* in close-ups: a disc cut off by another, which the model does not know."});
}

}  // namespace

std::filesystem::path run_flakes(const FlakesSettings& settings, const Stage& stage) {
    const FolderLock lock(settings.folder);
    check_page(settings.folder);
    const CloseUps close_ups(settings.folder, stage);
    report::Report report("Flakes, one by one",
                          "The model `nacre` against explicit discs: mean, contrast, histogram and "
                          "colour");
    nlohmann::json results = {{"study", "flakes"},
                              {"version", version()},
                              {"seed", settings.seed},
                              {"quick", settings.quick}};
    FlakesContext context{settings, close_ups, report, results};
    add_introduction(context);
    stage("what hides a flake", [&](const Progress& progress) { add_hiding(context, progress); });
    stage("the mean by direction", [&](const Progress& progress) { add_means(context, progress); });
    std::vector<FlakesVerdict> verdicts;
    for (const char* file : kRecipes) {
        FlakePaint paint(file, settings.seed);
        verdicts.push_back(add_flake_paint(context, paint));
        if (settings.quick && verdicts.size() == 2) break;
    }
    add_verdicts(context, verdicts);
    return write_page(settings.folder, report.html(), results);
}

namespace {

bool is_explicit(Way way) { return way == Way::discs || way == Way::mirrors; }

}  // namespace

std::string name(Way way) {
    switch (way) {
        case Way::discs:
            return "discs";
        case Way::mirrors:
            return "mirrors";
        case Way::hashed:
            return "hashed";
        case Way::no_hot_spot:
            return "no-hot-spot";
        case Way::smooth:
            return "smooth";
    }
    return "";
}

FlakePaint::FlakePaint(const std::string& file, std::uint64_t seed)
    : key_(file.substr(0, file.find('.'))),
      seed_(seed),
      recipe_(io::read_recipe(shipped_file("studies/flakes/" + file))) {}

double FlakePaint::depth() const {
    return species().area_density_per_um() * recipe_.layers[0].thickness_um;
}

double FlakePaint::flakes_per_mm2() const {
    constexpr double kUmPerMm = 1e3;
    return montecarlo::expected_discs(recipe_, {kUmPerMm, kUmPerMm});
}

std::shared_ptr<const bsdf::Bsdf> FlakePaint::surface(Way way, double side_mm,
                                                      const Progress& progress) {
    if (is_explicit(way)) {
        // With one seed the same arrangement would appear at every size, larger or smaller.
        const auto seed = hash_of(seed_, std::llround(1e6 * side_mm));
        return std::make_shared<const montecarlo::DiscWalk>(
            recipe_, montecarlo::ExplicitFlakesModel{side_mm, side_mm, seed, way == Way::discs},
            spectra::default_wavelengths_nm(), progress);
    }
    if (!solved_) {
        solved_ = std::make_shared<const solver::SolvedPaint>(
            solver::solve(recipe_, spectra::default_wavelengths_nm(), {}, nullptr, progress));
    }
    auto& made = way == Way::hashed ? hashed_ : way == Way::no_hot_spot ? no_hot_spot_ : smooth_;
    if (!made) {
        const bsdf::Model model =
            way == Way::smooth
                ? bsdf::Model(bsdf::MicroflakeModel{})
                : bsdf::NacreModel{.specimen = seed_, .hot_spot = way == Way::hashed};
        made = model.make({recipe_, solved_}, progress);
    }
    return made;
}

std::string FlakePaint::identity(Way way, double side_mm) const {
    const char* gaps = way == Way::hashed ? " hot spot" : "";
    return fmt::format("{} {}{} seed {} side {}", io::recipe_hash(recipe_), name(way), gaps, seed_,
                       is_explicit(way) ? side_mm : 0);
}

// What hides a flake: explicit discs against attenuation.

namespace {

constexpr double kAlpha = 0.1, kIndex = 1.5, kLayer_um = 15;

paint::Recipe opaque_flakes(double depth, double diameter_um) {
    paint::FlakeSpecies species;
    species.amount = paint::AreaDensity{depth / kLayer_um};
    species.diameter_um = diameter_um;
    species.orientation.beckmann_alpha = kAlpha;
    species.body = paint::PrescribedFlake{0.6, 0.0, 0.3};
    paint::Layer layer;
    layer.thickness_um = kLayer_um;
    layer.flakes.push_back(species);
    paint::Recipe recipe;
    recipe.name = "opaque flakes";
    recipe.clearcoat.emplace();
    recipe.clearcoat->thickness_um = 50;
    recipe.layers.push_back(layer);
    return recipe;
}

/// The unit vector inside the paint of a direction outside; side: 1 towards +x, -1 towards -x.
Vec3f inside(double outer_deg, double side) {
    const double sine = std::sin(outer_deg * std::numbers::pi / 180) / kIndex;
    return {static_cast<float>(side * sine), 0, static_cast<float>(std::sqrt(1 - sine * sine))};
}

}  // namespace

void add_hiding(FlakesContext& context, const Progress& progress) {
    report::Report& report = context.report;
    report.heading(1, "What hides a flake", "hiding");
    report.paragraph(
        "A flake is dimmed by those above it. The equation of transfer knows only the mean: "
        "*exp(-κz)* for a flake at depth *z*. The model gives this to every flake. Discs hide each "
        "other in part: from the share *v* of a flake's area that is both lit and seen follow the "
        "mean of the paint, E[v], and its contrast, E[v²]/E[v]². For opaque flakes in 15 um, from "
        "straight ways among discs that are laid out explicitly, lamp and eye as in all of this "
        "page:");
    report::Table table{.columns = {"diameter, um", "flakes deep", "E[v], discs", "E[v], equation",
                                    "E[v²]/E[v]², discs", "each dimmed by its mean",
                                    "each seen whole or not"}};
    const Vec3f eye = inside(kEye_deg, 1), lamp = inside(kLamp_deg, -1);
    const std::size_t flakes = context.settings.quick ? 2000 : 100000;
    SharedProgress work(progress, 12);
    for (const double diameter : {2.0, 20.0, 100.0}) {
        for (const double depth : {0.5, 1.25, 2.0, 4.0}) {
            const paint::Recipe recipe = opaque_flakes(depth, diameter);
            const double per_um2 = montecarlo::expected_discs(recipe, {1e3, 1e3}) / 1e6;
            const double side = std::sqrt(static_cast<double>(flakes) / per_um2);
            const montecarlo::Tile tile{side, side};
            const montecarlo::DiscScene scene(
                montecarlo::draw_discs(recipe, tile, {1}, context.settings.seed, &work), tile,
                &work);
            const montecarlo::Visibility v =
                montecarlo::flake_visibility(scene, lamp, eye, context.settings.seed);
            work.add();
            work.throw_if_stopped("the study");
            const double tau = depth * (paint::projected_area(eye.z, kAlpha) / eye.z +
                                        paint::projected_area(lamp.z, kAlpha) / lamp.z);
            const double mean = -std::expm1(-tau) / tau;
            const double dimmed = -std::expm1(-2 * tau) / (2 * tau) / (mean * mean);
            const double contrast = v.mean_square / (v.bidirectional * v.bidirectional);
            table.rows.push_back(
                {report::number_cell(number(diameter)), report::number_cell(number(depth)),
                 report::number_cell(number(v.bidirectional)), report::number_cell(number(mean)),
                 report::number_cell(number(contrast)), report::number_cell(number(dimmed)),
                 report::number_cell(number(1 / mean))});
            context.results["hiding"].push_back({{"diameter_um", diameter},
                                                 {"depth", depth},
                                                 {"mean_discs", v.bidirectional},
                                                 {"mean_error", v.standard_error},
                                                 {"mean_equation", mean},
                                                 {"mean_square_discs", v.mean_square},
                                                 {"contrast_discs", contrast},
                                                 {"contrast_dimmed", dimmed},
                                                 {"contrast_hidden", 1 / mean}});
        }
    }
    report.table(table);
    report.paragraph(
        "Attenuation is much nearer to the discs than flakes seen whole or not at all. What "
        "differs "
        "is the mean: where flakes are as wide as the layer is thick, light leaves past the same "
        "flakes between which it came in, and more of it than the equation says. That is the *hot "
        "spot*; the equation of transfer, and any model whose mean is its solution, neglects it.");
}

}  // namespace nacre::study
