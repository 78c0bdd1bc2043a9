#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "nacre/discs/disc.h"
#include "nacre/discs/visibility.h"
#include "nacre/flakes/beckmann.h"
#include "nacre/study/flakes_parts.h"
#include "nacre/study/mir_parts.h"

// What hides a flake: explicit discs against attenuation.

namespace nacre::study {
namespace {

constexpr double kAlpha = 0.1, kIndex = 1.5, kLayerUm = 15;

layers::Recipe opaque_flakes(double depth, double diameter_um) {
    layers::FlakeSpecies species;
    species.amount = layers::AreaDensity{depth / kLayerUm};
    species.diameter_um = diameter_um;
    species.orientation.beckmann_alpha = kAlpha;
    species.body = layers::PrescribedFlake{0.6, 0.0, 0.3};
    layers::Layer layer;
    layer.thickness_um = kLayerUm;
    layer.flakes.push_back(species);
    layers::Recipe recipe;
    recipe.name = "opaque flakes";
    recipe.clearcoat.emplace();
    recipe.clearcoat->thickness_um = 50;
    recipe.layers.push_back(layer);
    return recipe;
}

/// Cosine inside of a direction outside, and the unit vector.
Vec3f inside(double outer_deg, double side) {
    const double sine = std::sin(outer_deg * std::numbers::pi / 180) / kIndex;
    return {static_cast<float>(side * sine), 0, static_cast<float>(std::sqrt(1 - sine * sine))};
}

}  // namespace

void add_hiding(FlakesContext& context) {
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
    const Vec3f eye = inside(kEyeDeg, 1), lamp = inside(kLampDeg, -1);
    const std::size_t flakes = context.settings.quick ? 2000 : 100000;
    for (const double diameter : {2.0, 20.0, 100.0}) {
        for (const double depth : {0.5, 1.25, 2.0, 4.0}) {
            const layers::Recipe recipe = opaque_flakes(depth, diameter);
            const double per_um2 = discs::expected_discs(recipe, {1e3, 1e3}) / 1e6;
            const double side = std::sqrt(static_cast<double>(flakes) / per_um2);
            const discs::Tile tile{side, side};
            const discs::DiscScene scene(
                discs::draw_discs(recipe, tile, {1}, context.settings.seed), tile);
            const discs::Visibility v =
                discs::flake_visibility(scene, lamp, eye, context.settings.seed);
            const double tau = depth * (flakes::projected_area(eye.z, kAlpha) / eye.z +
                                        flakes::projected_area(lamp.z, kAlpha) / lamp.z);
            const double mean = -std::expm1(-tau) / tau;
            const double dimmed = -std::expm1(-2 * tau) / (2 * tau) / (mean * mean);
            const double contrast = v.mean_square / (v.lit_and_seen * v.lit_and_seen);
            table.rows.push_back(
                {report::number_cell(number(diameter)), report::number_cell(number(depth)),
                 report::number_cell(number(v.lit_and_seen)), report::number_cell(number(mean)),
                 report::number_cell(number(contrast)), report::number_cell(number(dimmed)),
                 report::number_cell(number(1 / mean))});
            context.results["hiding"].push_back({{"diameter_um", diameter},
                                                 {"depth", depth},
                                                 {"mean_discs", v.lit_and_seen},
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
