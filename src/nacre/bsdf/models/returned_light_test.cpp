#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nacre/bsdf/models/hot_spot.h"
#include "nacre/core/math.h"
#include "nacre/paint/beckmann.h"
#include "nacre/solver/solver.h"
#include "nacre/testing/nacre_model.h"

// What the hot spot gives to light that the interface had sent back, where flakes lean. Against explicit
// discs: models/leaning_parts_test.cpp.

namespace nacre::bsdf {
namespace {

constexpr double kReturningDepth = 2, kReturningMetal_um = 15, kReturningAlpha = 0.1;

paint::Recipe leaning_metal(double diameter_um) {
    paint::Recipe recipe = paint_of({metal_flake(diameter_um, 0.9, kReturningAlpha)});
    recipe.layers[0].flakes[0].amount = paint::AreaDensity{kReturningDepth / kReturningMetal_um};
    recipe.lean = paint::FlakeLean{5, 0};
    return recipe;
}

// Gain of single scattering between a direction at this angle outside and the critical angle on the other
// side: E[V] / E[exp(-kappa z)], as in hot_spot.h, over u = z / H; delta is g here.    [kuusk-1985]
double gain_towards_critical(double diameter_um, double theta) {
    const double sine = std::sin(theta) / 1.5, mu = std::sqrt(1 - sine * sine);
    const double critical = std::sqrt(1 - 1 / (1.5 * 1.5));
    const double q_i = paint::projected_area(mu, kReturningAlpha) / mu,
                 q_o = paint::projected_area(critical, kReturningAlpha) / critical;
    const double g = sine / mu + 1 / 1.5 / critical;
    constexpr int kSteps = 20'000;
    double hot = 0, plain = 0, overlap = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double u = (i + 0.5) / kSteps, x = g * kReturningMetal_um * u / diameter_um;
        const double o =
            x < 1 ? 2 / std::numbers::pi * (std::acos(x) - x * std::sqrt(1 - x * x)) : 0;
        const double met = kReturningDepth * (q_i + q_o) * u;
        hot +=
            std::exp(-met + kReturningDepth * std::sqrt(q_i * q_o) * (overlap + o / (2 * kSteps)));
        plain += std::exp(-met);
        overlap += o / kSteps;
    }
    return hot / plain;
}

TEST(ReturnedLight, GainsAsLightThatMetOneFlakeDoesTowardsTheCriticalAngle) {
    for (const double diameter_um : {0.02, 5.0, 20.0, 9000.0}) {
        const HotSpotTables tables(solver::solve(leaning_metal(diameter_um), {550}));
        ASSERT_EQ(tables.returned().size(), kDirectionIntervals + 1u);
        for (const int row : {0, 30, 60, 90, 120}) {
            const double gain = std::pow(tables.returned()[row], 2);
            const double expected = gain_towards_critical(diameter_um, direction_angle(row));
            EXPECT_NEAR(gain, expected, 2e-3 * expected) << diameter_um << " um, row " << row;
            if (diameter_um < 1) {
                EXPECT_NEAR(gain, 1, 2e-3) << row;
            } else {
                EXPECT_GT(gain, 1.05) << row;
            }
        }
    }
    EXPECT_GT(gain_towards_critical(9000, 0.5), gain_towards_critical(20, 0.5));
    EXPECT_GT(gain_towards_critical(20, 0.1),
              gain_towards_critical(20, 1.2));  // ways farther apart
}

TEST(ReturnedLight, IsNotToldApartWhereNoFlakesLean) {
    paint::Recipe recipe = leaning_metal(20);
    recipe.lean.reset();
    EXPECT_TRUE(HotSpotTables(solver::solve(recipe, {550})).returned().empty());
}

// The light of flakes that lie flat, with and without a hot spot, in which parts are told apart: with
// several layers, a pigment and a bright ground, too.
TEST(ReturnedLight, ComesFromTheRestOfWhatWasScatteredAgain) {
    paint::Recipe rich = recipe_with_every_feature();
    rich.lean = paint::FlakeLean{5, 0};
    int less = 0;
    for (const paint::Recipe& recipe : {leaning_metal(20), leaning_metal(0.01), rich}) {
        paint::Recipe upright = recipe;
        upright.lean.reset();
        const SparklingModel hot(recipe, {.specimen = 1}), plain(recipe);
        const SparklingModel whole(upright, {.specimen = 1});
        const bool small = recipe.layers[0].flakes[0].diameter_um < 1;
        for (const double theta_i : {5.0, 30.0, 50.0}) {
            for (const double theta_o : {0.0, 20.0, 45.0, 65.0}) {
                for (const double phi : {0.0, 110.0, 180.0}) {
                    const Vec3f wi = direction(theta_i, 0), wo = direction(theta_o, phi);
                    const MultiplyScattered with = hot.bound->multiply_scattered(wi, wo),
                                            without = plain.bound->multiply_scattered(wi, wo),
                                            back = hot.bound->multiply_scattered(wo, wi);
                    const FloatLanes f = hot.bound->eval(wi, wo), same = whole.bound->eval(wi, wo);
                    for (int lane = 0; lane < kLanes; ++lane) {
                        const float all = with.all[lane], first = with.no_internal_reflection[lane];
                        // What is told apart changes nothing in the whole, to the last bit.
                        EXPECT_EQ(f[lane], same[lane]);
                        EXPECT_GE(first, 0);
                        EXPECT_LE(first + with.from_ground[lane], 1.001f * all);
                        EXPECT_NEAR(first, back.no_internal_reflection[lane], 1e-4f * all);
                        if (small) {
                            EXPECT_NEAR(first, without.no_internal_reflection[lane], 0.01f * all);
                        } else {
                            less += first < 0.9f * without.no_internal_reflection[lane] * all /
                                                without.all[lane];
                        }
                    }
                }
            }
        }
    }
    EXPECT_GT(less, 300);  // of 576
}

}  // namespace
}  // namespace nacre::bsdf
