#include "nacre/study/flakes.h"

#include <fmt/format.h>

#include "nacre/core/atomic_file.h"
#include "nacre/io/version.h"
#include "nacre/study/flakes_parts.h"
#include "nacre/study/mir_parts.h"

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
                               kEyeDeg, kLampDeg, kLampSizeDeg)},
         {"Contrast",
          "standard deviation of the pixels' luminance over its mean, from two "
          "renderings of the same flakes with independent noise, by their covariance"},
         {"Errors", "one standard error, by the jackknife over 16 pieces of the picture"},
         {"Program", fmt::format("nacre {}, seed {}", io::version(), context.settings.seed)}});
}

void add_verdicts(FlakesContext& context, const std::vector<FlakesVerdict>& verdicts) {
    context.report.heading(1, "All together", "all");
    report::Table table{
        .columns = {"recipe", "flakes deep", "diameter, um", "flakes a mm²", "mean, hashed / discs",
                    "... without diffraction", "contrast, hashed / discs", "farthest from 1",
                    "mean, with hot spot", "contrast, with hot spot", "ΔE of the means",
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
             report::number_cell(fmt::format("{} ± {}", number(v.mean_ratio_hot_spot.value),
                                             number(v.mean_ratio_hot_spot.standard_error, 1))),
             report::number_cell(number(v.contrast_ratio_hot_spot)),
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
        {"*The mean*, where opaque flakes are as wide as the layer is thick: the hot spot. The "
         "mean "
         "of the hashed flakes is that of the equation of transfer, by construction; discs are "
         "brighter. The model's own hot spot dims each flake as discs do on average. It does not "
         "take from what is scattered again the light that has then left already, so that it ends "
         "up somewhat too bright.",
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
         "The model's lobe ends; it has the pattern's contrast under a point of light, and some "
         "per cent more under a lamp that is about as wide as the lobe.",
         "*Dark pixels*: between flakes that answer, discs leave gaps that are darker than the "
         "model's, which spreads all light that met more than one flake evenly.",
         "*Crescents* in close-ups: a disc cut off by another, which the model does not know."});
}

}  // namespace

std::filesystem::path run_flakes(const FlakesSettings& settings, const Stage& stage) {
    const CloseUps close_ups(settings.folder, stage);
    report::Report report("Flakes, one by one",
                          "The model `nacre` against explicit discs: mean, contrast, histogram and "
                          "colour");
    nlohmann::json results = {{"study", "flakes"},
                              {"version", io::version()},
                              {"seed", settings.seed},
                              {"quick", settings.quick}};
    FlakesContext context{settings, close_ups, report, results};
    add_introduction(context);
    stage("what hides a flake", [&](const Progress&) { add_hiding(context); });
    std::vector<FlakesVerdict> verdicts;
    for (const char* file : kRecipes) {
        FlakePaint paint(file, settings.seed);
        verdicts.push_back(add_flake_paint(context, paint));
        if (settings.quick && verdicts.size() == 2) break;
    }
    add_verdicts(context, verdicts);
    const std::filesystem::path page = settings.folder / "index.html";
    write_file_atomically(settings.folder / "results.json", results.dump(2) + "\n");
    write_file_atomically(page, report.html());
    return page;
}

}  // namespace nacre::study
