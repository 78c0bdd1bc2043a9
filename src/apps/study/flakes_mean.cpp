#include "apps/study/flakes_mean.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "apps/study/flakes.h"
#include "apps/study/mir_2022.h"
#include "nacre/bsdf/models/hot_spot_brdf.h"
#include "nacre/core/math.h"
#include "nacre/core/parallel.h"
#include "nacre/core/random.h"
#include "nacre/montecarlo/discs/disc_walk.h"
#include "nacre/solver/rough_interface.h"
#include "nacre/solver/solver.h"

namespace nacre::study {
namespace {

constexpr double kPaintThickness_um = 15, kWavelength_nm = 550;
constexpr double kUmPerMm = 1e3;

Vec3d direction_at(double theta_deg, double phi_deg) {
    const double theta = theta_deg * kDegree, phi = phi_deg * kDegree;
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

std::vector<MeanRatios> exits_of(double incidence_deg) {
    std::vector<MeanRatios> exits;
    for (const auto& [theta, phi] : {std::pair{incidence_deg, 180.0},
                                     {incidence_deg + 10, 180},
                                     {incidence_deg - 15, 180},
                                     {incidence_deg, 155},
                                     {incidence_deg, 90},
                                     {std::max(0.0, incidence_deg - 35), 180}}) {
        exits.push_back({.theta_deg = theta, .phi_deg = phi});
    }
    return exits;
}

/// Flux within a cone about each exit, per flux that comes in, of one specimen.
std::vector<double> flux_of_discs(const paint::Recipe& recipe, double side_mm, double incidence_deg,
                                  const std::vector<MeanRatios>& exits, int walks,
                                  std::uint64_t seed, SharedProgress& work) {
    const montecarlo::DiscWalk paint(recipe, {side_mm, side_mm, seed, false}, {kWavelength_nm});
    bsdf::Wavelengths wavelengths;
    wavelengths.fill(kWavelength_nm);
    const auto bound = paint.bind(wavelengths);
    const Vec3f wi = to_float(direction_at(incidence_deg, 0));
    const double edge = std::cos(kExitCone_deg * kDegree);
    std::vector<double> flux(exits.size(), 0.0);
    Rng rng(seed);
    for (int n = 0; n < walks; ++n) {
        if (n % 4096 == 0) work.throw_if_stopped("the study");
        const auto sample =
            bound->sample(wi, rng.uniform_float(), {rng.uniform_float(), rng.uniform_float()});
        if (!sample || sample->kind == bsdf::SampleKind::specular) continue;
        const Vec3d wo{sample->wo.x, sample->wo.y, sample->wo.z};
        for (std::size_t e = 0; e < exits.size(); ++e) {
            // The paint is symmetric about the plane of incidence: twice the directions.
            for (const double side : {-1.0, 1.0}) {
                const Vec3d middle = direction_at(exits[e].theta_deg, side * exits[e].phi_deg);
                if (dot(wo, middle) > edge) flux[e] += 0.5 * sample->weight[0] / walks;
            }
        }
    }
    return flux;
}

/// Integrals of f cos over a cone.
template <class Brdf>
double flux_in_cone(const Brdf& brdf, const Vec3d& middle) {
    constexpr int kRings = 10, kSectors = 10;
    const double height = 1 - std::cos(kExitCone_deg * kDegree);
    const Vec3d s = perpendicular(middle), t = cross(middle, s);
    double sum = 0;
    for (int ring = 0; ring < kRings; ++ring) {
        const double cosine = 1 - height * (ring + 0.5) / kRings;
        const double sine = std::sqrt(1 - cosine * cosine);
        for (int sector = 0; sector < kSectors; ++sector) {
            const double turn = 2 * std::numbers::pi * (sector + 0.5 * (ring % 2)) / kSectors;
            const Vec3d wo = cosine * middle + sine * (std::cos(turn) * s + std::sin(turn) * t);
            if (wo.z > 0) sum += brdf(std::acos(wo.z), std::atan2(wo.y, wo.x)) * wo.z;
        }
    }
    return 2 * std::numbers::pi * height * sum / (kRings * kSectors);
}

}  // namespace

paint::Recipe recipe_of(const MeanCase& paint) {
    paint::FlakeSpecies species;
    species.amount = paint::AreaDensity{paint.depth / kPaintThickness_um};
    species.diameter_um = paint.diameter_um;
    species.orientation.beckmann_alpha = paint.alpha;
    species.body = paint::PrescribedFlake{paint.reflectance, paint.transmittance, 0.3};
    paint::Layer layer;
    layer.thickness_um = kPaintThickness_um;
    layer.flakes.push_back(species);
    paint::Recipe recipe;
    recipe.name =
        fmt::format("{} deep, {} um, alpha {}", paint.depth, paint.diameter_um, paint.alpha);
    recipe.clearcoat.emplace();
    recipe.clearcoat->thickness_um = 50;
    recipe.clearcoat->roughness = paint.roughness;
    recipe.layers.push_back(layer);
    recipe.substrate_reflectance = paint.ground;
    return recipe;
}

std::vector<MeanRatios> compare_means(const MeanCase& paint, double incidence_deg, int walks,
                                      std::uint64_t seed, const Progress& progress) {
    // So many that those that mirror light into a cone are thousands.
    constexpr double kFlakes = 120000;
    const paint::Recipe recipe = recipe_of(paint);
    std::vector<MeanRatios> exits = exits_of(incidence_deg);
    const double side_mm =
        std::sqrt(kFlakes / montecarlo::expected_discs(recipe, {kUmPerMm, kUmPerMm}));
    SharedProgress work(progress, kMeanSpecimens);
    std::vector<std::vector<double>> flux(kMeanSpecimens);
    parallel_for(0, kMeanSpecimens, [&](std::size_t n) {
        flux[n] = flux_of_discs(recipe, side_mm, incidence_deg, exits, walks / kMeanSpecimens,
                                hash_of(seed, n), work);
        work.add();
    });
    work.throw_if_stopped("the study");

    const solver::SolvedPaint solved = solver::solve(recipe, {kWavelength_nm});
    const bsdf::HotSpotBrdf hot(solved);
    const double theta_i = incidence_deg * kDegree;
    for (std::size_t e = 0; e < exits.size(); ++e) {
        MeanRatios& exit = exits[e];
        const Vec3d middle = direction_at(exit.theta_deg, exit.phi_deg);
        // The interface's lobe, which all of them have alike.
        const double interface = flux_in_cone(
            [&](double theta_o, double phi) {
                return paint.roughness > 0
                           ? solver::rough_interface_brdf(solved.medium.ior[0], paint.roughness,
                                                          theta_i, theta_o, phi)
                           : 0.0;
            },
            middle);
        double sum = 0, squares = 0;
        for (const auto& specimen : flux) {
            sum += specimen[e] - interface;
            squares += (specimen[e] - interface) * (specimen[e] - interface);
        }
        const Estimate discs = estimate_of_mean(sum, squares, kMeanSpecimens);
        // Of a model's single and multiple scattering, each with the hot spot or without.
        const auto ratio = [&](bool hot_single, bool hot_multiple) {
            const double value =
                flux_in_cone(
                    [&](double theta_o, double phi) {
                        const auto part = [&](bool with_hot_spot, Part part) {
                            return with_hot_spot ? hot(theta_i, theta_o, phi, part)[0]
                                                 : solved.brdf(theta_i, theta_o, phi, part)[0];
                        };
                        return part(hot_single, Part::single) + part(hot_multiple, Part::multiple);
                    },
                    middle) /
                discs.value;
            return Estimate{value, value * discs.standard_error / discs.value};
        };
        exit.transfer = ratio(false, false);
        exit.gain_only = ratio(true, false);
        exit.nacre = ratio(true, true);
        const double projected = flux_in_cone([](double, double) { return 1.0; }, middle);
        exit.discs = {discs.value / projected, discs.standard_error / projected};
    }
    return exits;
}

namespace {

constexpr MeanCase kMeanCases[] = {
    {},
    {.depth = 0.3},
    {.depth = 3},
    {.diameter_um = 5},
    {.diameter_um = 80},
    {.alpha = 0.05},
    {.alpha = 0.3},
    {.reflectance = 0.6},
    {.depth = 0.3, .diameter_um = 80, .ground = 0.8},
    {.reflectance = 0.4, .transmittance = 0.5},
    {.depth = 3, .reflectance = 0.4, .transmittance = 0.5},
    {.diameter_um = 80, .reflectance = 0.4, .transmittance = 0.5},
    {.depth = 1, .alpha = 0.2, .reflectance = 0.4, .transmittance = 0.5, .ground = 0.8},
    {.roughness = 0.2}};
constexpr double kIncidences_deg[] = {15, 45, 60};
/// Directions that are darker than this over the mirror direction are not compared: there is next
/// to no light that met one flake.
constexpr double kDim = 0.02;

double farther(double a, double b) { return std::abs(std::log(a)) > std::abs(std::log(b)) ? a : b; }

}  // namespace

void add_means(FlakesContext& context, const Progress& progress) {
    report::Report& report = context.report;
    report.heading(1, "The mean by direction", "directions");
    report.paragraph(fmt::format(
        "Light that came in between large flakes finds the same gaps on its way out. From walks "
        "among discs, without diffraction: the light that leaves within {}° of the mirror "
        "direction, of 10° beyond and 15° before it, of 25° and 90° beside it, and of 35° before "
        "it; without the lobe of a rough clear coat. Each model over the discs, in the mirror "
        "direction and where it is farthest from 1 "
        "among those directions that have {} of the mirror direction's light: the equation of "
        "transfer (`microflake`), the hot spot with nothing taken from multiple scattering, and "
        "the hot spot of `nacre`. All layers are {} um thick.",
        kExitCone_deg, kDim, kPaintThickness_um));
    report::Table table{.columns = {"flakes deep", "um", "alpha", "R", "T", "ground", "roughness",
                                    "light", "transfer", "gain alone", "nacre", "standard error",
                                    "farthest: transfer", "gain alone", "nacre"}};
    const bool quick = context.settings.quick;
    const int cases = quick ? 1 : static_cast<int>(std::size(kMeanCases));
    const int lights = quick ? 1 : static_cast<int>(std::size(kIncidences_deg));
    for (int n = 0; n < cases * lights; ++n) {
        const MeanCase& paint = kMeanCases[n / lights];
        const double light = kIncidences_deg[n % lights];
        const auto exits =
            compare_means(paint, light, quick ? 20000 : 1600000, hash_of(context.settings.seed, n),
                          [&](double fraction) {
                              return !progress || progress((n + fraction) / (cases * lights));
                          });
        std::array<double, 3> worst = {1, 1, 1};
        nlohmann::json directions;
        for (const MeanRatios& exit : exits) {
            directions.push_back({{"theta", exit.theta_deg},
                                  {"phi", exit.phi_deg},
                                  {"discs", exit.discs.value},
                                  {"error", exit.discs.standard_error},
                                  {"transfer", exit.transfer.value},
                                  {"gain_alone", exit.gain_only.value},
                                  {"nacre", exit.nacre.value}});
            if (exit.discs.value < kDim * exits[0].discs.value) continue;
            worst[0] = farther(worst[0], exit.transfer.value);
            worst[1] = farther(worst[1], exit.gain_only.value);
            worst[2] = farther(worst[2], exit.nacre.value);
        }
        std::vector<report::Cell> row;
        for (const double value :
             {paint.depth, paint.diameter_um, paint.alpha, paint.reflectance, paint.transmittance,
              paint.ground, paint.roughness, light, exits[0].transfer.value,
              exits[0].gain_only.value, exits[0].nacre.value}) {
            row.push_back(report::number_cell(number(value)));
        }
        row.push_back(report::number_cell(number(exits[0].nacre.standard_error, 1)));
        for (const double value : worst) row.push_back(report::number_cell(number(value)));
        table.rows.push_back(row);
        context.results["directions"].push_back({{"depth", paint.depth},
                                                 {"diameter_um", paint.diameter_um},
                                                 {"alpha", paint.alpha},
                                                 {"reflectance", paint.reflectance},
                                                 {"transmittance", paint.transmittance},
                                                 {"ground", paint.ground},
                                                 {"roughness", paint.roughness},
                                                 {"incidence", light},
                                                 {"exits", directions}});
    }
    report.table(table);
}

}  // namespace nacre::study
