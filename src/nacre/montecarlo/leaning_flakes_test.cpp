#include "nacre/bsdf/leaning_flakes.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "nacre/bsdf/models/microflake.h"
#include "nacre/core/math.h"
#include "nacre/montecarlo/reference.h"
#include "nacre/solver/solver.h"
#include "nacre/testing/paints.h"
#include "nacre/testing/statistics.h"

// Flakes that lean: the flat paint, asked in their frame, against walks among flakes that lean.

namespace nacre::montecarlo {
namespace {

constexpr std::array<double, 1> kLeanWavelength = {550};

struct LeanErrors {
    double near = 0;  ///< largest, relative, where light that met one flake is most of it
    double rest = 0;  ///< largest elsewhere, over the mean of all
    int compared = 0;
};

/// @param alpha  how wide the lobe about the lean is
LeanErrors lean_errors_of(const paint::Recipe& flat, double tilt_deg, double alpha,
                          std::uint64_t walks) {
    const auto solved =
        std::make_shared<const solver::SolvedPaint>(solver::solve(flat, {kLeanWavelength[0]}));
    bsdf::Wavelengths eight;
    eight.fill(kLeanWavelength[0]);
    LeanErrors errors;
    for (const auto& [lamp_deg, azimuth_deg] :
         {std::pair{45.0, 0.0}, {45.0, 90.0}, {45.0, 180.0}, {65.0, 0.0}, {65.0, 180.0}}) {
        paint::Recipe recipe = flat;
        recipe.lean = paint::FlakeLean{tilt_deg, azimuth_deg};
        auto leaning = std::make_shared<solver::SolvedPaint>(*solved);
        leaning->recipe = recipe;
        const bsdf::Microflake surface(leaning);
        const auto bound = bsdf::bind_with_lean(surface, eight);
        const std::vector<Direction> incident = {{lamp_deg, 0}};
        std::vector<Direction> outgoing;
        for (const double theta : {0.0, 20.0, 30.0, 60.0, 70.0}) outgoing.push_back({theta, 180});
        outgoing.push_back({35, 150});
        outgoing.push_back({65, 0});
        const auto walked = reference_brdf(recipe, incident, outgoing, kLeanWavelength,
                                           {.samples = walks, .seed = 5});
        double mean = 0;
        for (const Estimate& w : walked) mean += w.value / static_cast<double>(walked.size());
        for (std::size_t k = 0; k < outgoing.size(); ++k) {
            const auto at = [](Direction d) {
                const double t = d.theta_deg * kDegree, p = d.phi_deg * kDegree;
                return Vec3f{static_cast<float>(std::sin(t) * std::cos(p)),
                             static_cast<float>(std::sin(t) * std::sin(p)),
                             static_cast<float>(std::cos(t))};
            };
            const Vec3f wi = at(incident[0]), wo = at(outgoing[k]);
            const double f = bound->eval(wi, wo)[0];
            const double slack = test::kWorstZ * walked[k].standard_error;
            const double off = std::max(0.0, std::abs(f - walked[k].value) - slack);
            // The slope, from the lean, of the flakes that mirror.
            const float n = bound->binder_index().mean;
            const auto inside = [&](Vec3f w) {
                return Vec3f{w.x / n, w.y / n, std::sqrt(1 - (w.x * w.x + w.y * w.y) / (n * n))};
            };
            const Vec3f h = inside(wi) + inside(wo);
            const auto [x, y] = recipe.lean->tangents();
            const double slope = std::hypot(h.x / h.z - x, h.y / h.z - y);
            if (slope < 1.2 * alpha) {
                errors.near = test::worse(errors.near, off / walked[k].value);
            } else {
                errors.rest = test::worse(errors.rest, off / mean);
            }
            ++errors.compared;
        }
    }
    return errors;
}

TEST(LeaningFlakes, AreWhatWalksFindOfThemToFirstOrder) {
    paint::Recipe metallic = test::paint_of(1.5, {test::flake_layer(3, 0.16, 0.85, 0)});
    metallic.clearcoat = paint::Clearcoat{40, 0.0, 0};
    paint::Recipe tinted = metallic;
    tinted.clearcoat = paint::Clearcoat{40, 8.0, 0};
    paint::Recipe over_white = test::paint_of(
        1.5, {test::flake_layer(0.4, 0.12, 0.5, 0.4), test::pigment_layer(0.999, 20, 0.5)}, 0.6);
    const paint::Recipe gaps = test::paint_of(1.5, {test::flake_layer(1, 0.16, 0.85, 0)}, 0.8);
    const paint::Recipe lossless =
        test::paint_of(1.5, {test::flake_layer(1.5, 0.15, 0.7, 0.3)}, 1.0);
    struct LeanCase {
        const char* name;
        paint::Recipe recipe;
        double alpha;
        std::uint64_t walks;  ///< of light that ends soon there are more in the same time
        double near_a_degree = 0.003, rest_a_degree = 0.006;  ///< bounds of LeanErrors
    };
    for (const LeanCase& c :
         {LeanCase{"metallic", metallic, 0.16, 60'000},
          LeanCase{"tinted coat", tinted, 0.16, 60'000},
          LeanCase{"over white", over_white, 0.12, 20'000},
          LeanCase{"gaps over white", gaps, 0.16, 20'000},
          LeanCase{"lossless over white", lossless, 0.15, 20'000, 0.006, 0.009}}) {
        for (const double tilt_deg : {3.0, 6.0, 10.0}) {
            const LeanErrors errors = lean_errors_of(c.recipe, tilt_deg, c.alpha, c.walks);
            std::printf("[ measured ] %s, %g deg: %.4f near, %.4f of the mean elsewhere\n", c.name,
                        tilt_deg, errors.near, errors.rest);
            EXPECT_EQ(errors.compared, 35);
            EXPECT_LT(errors.near, c.near_a_degree * tilt_deg) << c.name << " " << tilt_deg;
            EXPECT_LT(errors.rest, c.rest_a_degree * tilt_deg) << c.name << " " << tilt_deg;
        }
    }
}

}  // namespace
}  // namespace nacre::montecarlo
