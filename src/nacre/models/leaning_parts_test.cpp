#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <vector>

#include "nacre/bsdf/leaning_flakes.h"
#include "nacre/bsdf/models/nacre.h"
#include "nacre/core/estimate.h"
#include "nacre/core/math.h"
#include "nacre/core/parallel.h"
#include "nacre/core/random.h"
#include "nacre/montecarlo/discs/disc_scene.h"
#include "nacre/optics/fresnel.h"
#include "nacre/solver/solver.h"
#include "nacre/testing/directions.h"

// Where the light of leaning flakes comes from: what met one flake, what was scattered again without
// having met the interface, and what the interface had sent back. By the model nacre, with the hot spot,
// and by a walk of its own among explicit discs, which tells them apart.

namespace nacre::models {
namespace {

using test::direction;

constexpr double kPartsIndex = 1.5, kPartsTilt_deg = 6, kPartsLamp_deg = 45,
                 kPartsWavelength_nm = 550;
constexpr double kPartsCoat_um = 50, kPartsFlakes_um = 15;  // as much below: no disc is moved
constexpr double kPartsLobe = 0.3;  // slopes of half vectors about the flakes' mean, two alphas
constexpr double kPartsLeastCosine = 0.42;  // seen within 65 deg
constexpr double kPartsLamps_deg[] = {0, 90, 180};

enum Part { kOnce, kUnreturned, kReturned, kPartCount };
/// Flux into the lobe per incident flux, of three lamps together.
using Parts = std::array<double, kPartCount>;

paint::Recipe opaque_parts(double diameter_um, double tilt_deg) {
    paint::FlakeSpecies flakes;
    flakes.amount = paint::AreaDensity{2 / kPartsFlakes_um};
    flakes.diameter_um = diameter_um;
    flakes.orientation.beckmann_alpha = 0.15;
    flakes.body = paint::PrescribedFlake{0.9, 0, 0.3};
    paint::Recipe recipe;
    recipe.clearcoat = paint::Clearcoat{kPartsCoat_um, 0.0, 0};
    recipe.layers = {paint::Layer{kPartsFlakes_um, {flakes}, {}},
                     paint::Layer{kPartsCoat_um, {}, {}}};
    recipe.substrate_reflectance = 0;
    if (tilt_deg > 0) recipe.lean = paint::FlakeLean{tilt_deg, 0};
    return recipe;
}

bsdf::LeaningFlakes::Lean lean_of(double tilt_deg) {
    return bsdf::LeaningFlakes::Lean({static_cast<float>(std::tan(tilt_deg * kDegree)), 0});
}

Vec3d inside_of(const Vec3d& w) {
    const double x = w.x / kPartsIndex, y = w.y / kPartsIndex;
    return {x, y, std::sqrt(1 - x * x - y * y)};
}

double passes(double cosine_outside) {
    return 1 - optics::dielectric_reflectance(1.0, kPartsIndex, cosine_outside);
}

bool in_lobe(const Vec3d& inside_i, const Vec3d& inside_o, const bsdf::LeaningFlakes::Lean& lean) {
    const Vec3d h = inside_i + inside_o;
    const double z = dot(h, to_double(lean.n));
    return std::hypot(dot(h, to_double(lean.s)), dot(h, to_double(lean.t))) < kPartsLobe * z &&
           1 - kPartsIndex * kPartsIndex * (1 - inside_o.z * inside_o.z) >
               kPartsLeastCosine * kPartsLeastCosine;
}

/// Adds what one walk among opaque discs leaves in the lobe.
void walk_among_opaque(const montecarlo::DiscScene& discs, double lamp_deg,
                       const bsdf::LeaningFlakes::Lean& lean, Rng& rng, double scale, Parts& sum) {
    const montecarlo::Tile& tile = discs.tile();
    const double bottom = -(kPartsCoat_um + kPartsFlakes_um + kPartsCoat_um);
    const Vec3d wi = to_double(direction(kPartsLamp_deg, lamp_deg)), in = inside_of(wi);
    Vec3d place{tile.width_um * rng.uniform_double(), tile.height_um * rng.uniform_double(), 0};
    Vec3d travel = -in;
    double weight = scale * passes(wi.z);
    int met = 0, returns = 0;
    std::uint32_t leaving = montecarlo::DiscScene::kNone;
    while (weight > 1e-4 * scale) {
        const double to_end = std::max(0.0, ((travel.z < 0 ? bottom : 0) - place.z) / travel.z);
        const double to_edge = tile.to_edge(place.x, place.y, travel.x, travel.y);
        double distance = std::min(to_end, to_edge);
        const auto hit = discs.intersect(to_float(place), to_float(travel),
                                         static_cast<float>(distance), leaving);
        if (hit) distance = hit->distance_um;
        place += distance * travel;
        leaving = hit ? hit->disc : montecarlo::DiscScene::kNone;
        if (hit) {
            const Vec3d m = normalize(to_double(discs[hit->disc].normal));
            travel = normalize(travel - 2 * dot(travel, m) * m);
            weight *= 0.9;
            ++met;
        } else if (to_end <= to_edge) {
            if (travel.z < 0) return;
            const double back = optics::dielectric_reflectance(kPartsIndex, 1.0, travel.z);
            if (in_lobe(in, travel, lean)) {
                sum[returns > 0 ? kReturned : met > 1 ? kUnreturned : kOnce] += weight * (1 - back);
            }
            weight *= back;
            ++returns;
            place.z = 0;
            travel.z = -travel.z;
        } else {
            tile.step_over(place.x, place.y, travel.x, travel.y);
        }
    }
}

Parts among_discs(const paint::Recipe& recipe, double tilt_deg, std::uint64_t seed) {
    constexpr double kFlakes = 30'000;
    constexpr int kWalks = 12'000;
    const double side_um = std::sqrt(kFlakes / montecarlo::expected_discs(recipe, {1, 1}));
    const montecarlo::Tile tile{side_um, side_um};
    const montecarlo::DiscScene discs(montecarlo::draw_discs(recipe, tile, {1}, seed, nullptr),
                                      tile);
    const auto lean = lean_of(tilt_deg);
    Parts sum{};
    Rng rng(seed);
    for (const double lamp_deg : kPartsLamps_deg) {
        for (int n = 0; n < kWalks; ++n)
            walk_among_opaque(discs, lamp_deg, lean, rng, 1.0 / kWalks, sum);
    }
    return sum;
}

Parts by_nacre(double diameter_um, double tilt_deg) {
    // That of a paint that leans, whose parts it tells, but for its lean.
    const auto solved = std::make_shared<const solver::SolvedPaint>(
        solver::solve(opaque_parts(diameter_um, kPartsTilt_deg), {kPartsWavelength_nm}));
    bsdf::Wavelengths eight;
    eight.fill(kPartsWavelength_nm);
    const auto flat = bsdf::Nacre(solved, {.specimen = 1}).bind(eight);
    const auto lean = lean_of(tilt_deg), twice = lean.twice();
    const bsdf::LeaningFlakes leaning(*flat, lean);
    const auto seen_flat = [](const bsdf::LeaningFlakes::Lean& frame, const Vec3d& inside) {
        const Vec3f w = frame.to_flakes(to_float(inside));
        const auto n = static_cast<float>(kPartsIndex);
        const float x = n * w.x, y = n * w.y;
        return Vec3f{x, y, std::sqrt(std::max(1e-8f, 1 - x * x - y * y))};
    };
    Parts sum{};
    constexpr int kPoints = 20'000;
    for (const double lamp_deg : kPartsLamps_deg) {
        const Vec3f wi = direction(kPartsLamp_deg, lamp_deg);
        const Vec3d in = inside_of(to_double(wi));
        for (int k = 0; k < kPoints; ++k) {  // evenly by cosine, on a spiral by the golden angle
            const double u = (k + 0.5) / kPoints, turn = 2.399963 * k, sine = std::sqrt(u);
            const Vec3f wo{static_cast<float>(sine * std::cos(turn)),
                           static_cast<float>(sine * std::sin(turn)),
                           static_cast<float>(std::sqrt(1 - u))};
            const Vec3d out = inside_of(to_double(wo));
            if (!in_lobe(in, out, lean)) continue;
            // The interface that light crosses in truth over the one of the paint that is asked.
            const auto told = [&](const bsdf::LeaningFlakes::Lean& frame, const auto& part) {
                const Vec3f i = seen_flat(frame, in), o = seen_flat(frame, out);
                const bsdf::MultiplyScattered again = flat->multiply_scattered(i, o);
                return double{part(again)[0]} * passes(wi.z) * passes(wo.z) /
                       (passes(i.z) * passes(o.z));
            };
            const double no_internal_reflection = told(
                lean, [](const bsdf::MultiplyScattered& a) { return a.no_internal_reflection; });
            const double returned = told(twice, [](const bsdf::MultiplyScattered& a) {
                return a.all - a.no_internal_reflection;
            });
            const double flux = std::numbers::pi / kPoints;
            sum[kUnreturned] += flux * no_internal_reflection;
            sum[kReturned] += flux * returned;
            sum[kOnce] +=
                flux * (double{leaning.eval(wi, wo)[0]} - no_internal_reflection - returned);
        }
    }
    return sum;
}

// Four standard errors of sixteen specimens hold with a confidence of 99.9 %.
TEST(LeaningParts, AreThoseOfDiscs) {
    constexpr int kSpecimens = 16;
    for (const double diameter_um : {5.0, 20.0}) {
        std::array<double, 2> ratio{}, ratio_error{};
        for (const int leans : {0, 1}) {
            const double tilt_deg = leans * kPartsTilt_deg;
            const paint::Recipe recipe = opaque_parts(diameter_um, tilt_deg);
            std::vector<Parts> specimens(kSpecimens);
            parallel_for(0, kSpecimens, [&](std::size_t n) {
                specimens[n] = among_discs(recipe, tilt_deg, hash_of(std::uint64_t{77}, n));
            });
            const auto estimate = [&](const auto& value) {
                double sum = 0, squares = 0;
                for (const Parts& parts : specimens) {
                    sum += value(parts);
                    squares += value(parts) * value(parts);
                }
                return estimate_of_mean(sum, squares, kSpecimens);
            };
            const auto total = [](const Parts& p) {
                return p[kOnce] + p[kUnreturned] + p[kReturned];
            };
            const Parts nacre = by_nacre(diameter_um, tilt_deg);
            const Estimate all = estimate(total);
            std::printf("[ measured ] %g um, %g deg, of all light in the lobe, nacre and discs:",
                        diameter_um, tilt_deg);
            for (const Part part : {kOnce, kUnreturned, kReturned}) {
                const Estimate discs = estimate([&](const Parts& p) { return p[part]; });
                std::printf(" %.4f %.4f+-%.4f", nacre[part] / all.value, discs.value / all.value,
                            discs.standard_error / all.value);
                EXPECT_NEAR(nacre[part], discs.value, 0.015 * all.value + 4 * discs.standard_error)
                    << diameter_um << " um, " << tilt_deg << " deg, part " << part;
            }
            ratio[leans] = total(nacre) / all.value;
            ratio_error[leans] = ratio[leans] * all.standard_error / all.value;
            std::printf("; all of it %.4f+-%.4f\n", ratio[leans], ratio_error[leans]);
        }
        // As right as without the lean.
        EXPECT_NEAR(ratio[1], ratio[0], 0.01 + 4 * std::hypot(ratio_error[0], ratio_error[1]))
            << diameter_um << " um";
    }
}

}  // namespace
}  // namespace nacre::models
