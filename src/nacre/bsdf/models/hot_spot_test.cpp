#include "nacre/bsdf/models/hot_spot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nacre/bsdf/models/hot_spot_brdf.h"
#include "nacre/bsdf/models/hot_spot_compensation.h"
#include "nacre/core/error.h"
#include "nacre/core/lane_math.h"
#include "nacre/core/math.h"
#include "nacre/core/quadrature.h"
#include "nacre/optics/fresnel.h"
#include "nacre/testing/nacre_model.h"
#include "nacre/testing/statistics.h"

// The hot spot of the nacre model, and where its light comes from. Against explicit discs:
// apps/study/flakes_mean_test.cpp.

namespace nacre::bsdf {
namespace {

TEST(DiscOverlap, IntegralIsThatOfTheOverlap) {
    for (const double x : {0.01, 0.3, 0.8, 1.0, 5.0}) {
        const Quadrature rule = gauss_legendre(200, 0, std::min(x, 1.0));
        double sum = 0;
        for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
            const double t = rule.nodes[i];
            sum +=
                rule.weights[i] * 2 / std::numbers::pi * (std::acos(t) - t * std::sqrt(1 - t * t));
        }
        EXPECT_NEAR(disc_overlap_integral(x), sum, 1e-7);  // the rule at the root at 1
    }
}

// The mean over depth of the probability P that an opaque flake is both lit and seen: that of the
// transfer equation times f_single with the hot spot over f_single without it. Of light that is
// scattered again there is next to nothing here.
double bidirectional(double diameter_um, double theta_deg) {
    paint::Recipe recipe = paint_of({metal_flake(diameter_um, 1e-3)});  // nothing twice
    recipe.layers[0].flakes[0].amount = paint::AreaDensity{2.0 / 15};
    const SparklingModel hot(recipe, {.specimen = 1, .hot_spot = true}), plain(recipe);
    const double theta = std::asin(1.5 * std::sin(theta_deg * kDegree)) / kDegree;  // outside
    const Vec3f wi = direction(theta, 0), wo = direction(theta, 180);
    const double single =
        hot.paint->brdf(theta * kDegree, theta * kDegree, std::numbers::pi, Part::single)[9];
    const double gain = hot.bound->eval(wi, wo)[2] - plain.bound->eval(wi, wo)[2];
    // exp(-2 q beta u) over the depth, q = s(mu)/mu = 0.995 for all but grazing directions.
    const double depth = 2 * 2 * 0.995073;
    return -std::expm1(-depth) / depth * (1 + gain / single);
}

// The closed form for these flakes, lit at an angle inside the paint and seen at the same angle
// on the other side: E[V], the mean over the depth u = z / H of the flake, V = exp(-2 q beta u + q beta J(u)),
// beta = c H, q beta = H sigma_b / mu, J = Int_0^u O(delta H u' / d) du', O the overlap of two discs.
// [kuusk-1985]
double closed_form(double diameter_um, double theta_deg) {
    const double q_beta = 0.995073 * 2, g = 2 * std::tan(theta_deg * kDegree);
    constexpr int kSteps = 20000;
    double sum = 0, overlap = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double u = (i + 0.5) / kSteps, x = g * 15 * u / diameter_um;
        const double o =
            x < 1 ? 2 / std::numbers::pi * (std::acos(x) - x * std::sqrt(1 - x * x)) : 0;
        sum += std::exp(-2 * q_beta * u + q_beta * (overlap + o / (2 * kSteps))) / kSteps;
        overlap += o / kSteps;
    }
    return sum;
}

TEST(HotSpot, LargeFlakesAreSeenWhereTheyAreLit) {
    struct Case {
        double diameter_um, theta_deg;
    };
    for (const Case& c : {Case{0.02, 20}, Case{5, 5}, Case{20, 20}, Case{100, 35}}) {
        const double expected = closed_form(c.diameter_um, c.theta_deg);
        EXPECT_NEAR(bidirectional(c.diameter_um, c.theta_deg), expected, 3e-4 * expected)
            << c.diameter_um << " um, " << c.theta_deg << " deg";
    }
    // Counting 20 um discs in 15 um of paint, depth 2, 20 deg inside, gave 0.397, where the
    // transfer equation has 0.247: the closed form agrees within 5 %.
    EXPECT_NEAR(closed_form(20, 20), 0.397, 0.05 * 0.397);
    EXPECT_NEAR(closed_form(0.02, 20), 0.2465, 0.001);
    // Towards the light, and for infinitely large flakes, only the way in is blocked.
    const double once = 2 * 0.995073;
    EXPECT_NEAR(bidirectional(20, 1e-3), -std::expm1(-once) / once, 0.002);
    EXPECT_NEAR(bidirectional(9000, 20), -std::expm1(-once) / once, 0.005);
}

TEST(HotSpot, MeanOverDepthIsTheIntegralOfItsGain) {
    for (const double covered : {0.05, 0.5, 3.0, 20.0}) {
        paint::Recipe recipe = paint_of({metal_flake(20, 1e-3)});
        recipe.layers[0].flakes[0].amount = paint::AreaDensity{covered / 15};
        const solver::SolvedPaint paint = solver::solve(recipe, {550});
        const HotSpotTables tables(paint);
        const HotSpot hot_spot(tables, wavelengths_of_block(1, 0));
        for (const double theta_deg : {5.0, 30.0, 75.0}) {
            const Ray i = make_ray(20 * kDegree, 0, 1 / 1.5f);
            const Ray o = make_ray(theta_deg * kDegree, std::numbers::pi, 1 / 1.5f);
            const HotSpot::Pair pair(hot_spot, i, o);
            // Of each lane a depth of its own, as of wavelengths that films let through.
            FloatLanes depth;
            for (int lane = 0; lane < kLanes; ++lane) {
                depth[lane] = static_cast<float>(covered * (1 / i.inside.z + 1 / o.inside.z) *
                                                 (1 + 0.1 * lane));
            }
            constexpr int kSteps = 4000;
            FloatLanes sum{};
            for (int step = 0; step < kSteps; ++step) {
                const float u = (step + 0.5f) / kSteps;
                sum += exp_lanes(pair.gain(0, u) - depth * u) / kSteps;
            }
            const FloatLanes mean = pair.mean(0, depth);
            for (int lane = 0; lane < kLanes; ++lane) {
                const float exact = sum[lane] * depth[lane] / -std::expm1(-depth[lane]);
                EXPECT_NEAR(mean[lane], exact, 1e-3 * exact) << covered << ' ' << theta_deg;
            }
        }
    }
}

TEST(HotSpot, MeanOverPatchesIsItsOwnMean) {
    for (const double roughness : {0.0, 0.12}) {
        SCOPED_TRACE(roughness);
        paint::Recipe recipe = recipe_with_every_feature();
        recipe.clearcoat->roughness = roughness;
        const SparklingModel model(recipe, {.specimen = 2, .hot_spot = true});
        const Vec3f wi = direction(30, 20), wo = direction(31, 199);
        PatchMemory memory(model.bound->patch_memory_bytes());
        for (const double side : {0.01, 0.5}) {
            test::Sample values;
            Rng rng(21);
            for (int n = 0; n < 60000; ++n) {
                Patch patch = random_square_patch(rng, side);
                memory.forget();
                patch.memory = &memory;
                values.add(model.bound->evaluate_on(patch, wi, wo).f[4]);
            }
            EXPECT_NEAR(values.mean(), model.bound->eval(wi, wo)[4],
                        test::kWorstZ * values.error());
        }
        const SparklingModel& plain = model_with_every_feature(roughness > 0);
        EXPECT_GT(model.bound->eval(wi, wo)[4], 1.1 * plain.bound->eval(wi, wo)[4]);
        EXPECT_GT(model.bound->albedo(wi)[4], 1.02 * plain.bound->albedo(wi)[4]);
        const auto [mean, error] = mean_weight(*model.bound, wi, 4, 40000, 9);
        EXPECT_NEAR(model.bound->albedo(wi)[4], mean, 4 * error + 5e-3);
    }
}

TEST(Balance, FindsTheScalesOfASymmetricMatrix) {
    // C = (2, 3, 1/2) by construction.
    const std::vector<double> m = {0.4, 1, 0.2, 1, 0.1, 3, 0.2, 3, 7}, g = {2, 3, 0.5};
    std::vector<double> sum(3, 0.0);
    for (int a = 0; a < 3; ++a) {
        for (int b = 0; b < 3; ++b) sum[a] += g[a] * m[3 * a + b] * g[b];
    }
    const std::vector<double> found = balance(m, sum);
    for (int a = 0; a < 3; ++a) EXPECT_NEAR(found[a], g[a], 1e-5 * g[a]);
    EXPECT_THAT(balance({0, 0, 0, 2}, {0, 8}),
                testing::ElementsAre(1, testing::DoubleNear(2, 1e-5)));
    // Nothing is left of one of them.
    EXPECT_THAT(balance({1, 2, 2, 3}, {0, 12}),
                testing::ElementsAre(0, testing::DoubleNear(2, 1e-5)));
    // No C: what one of two gets from the other, the other gets from it.
    EXPECT_THROW(balance({0, 1, 1, 0}, {1, 2}), Error);
}

std::shared_ptr<const solver::SolvedPaint> shared_solution(const paint::Recipe& recipe) {
    return std::make_shared<const solver::SolvedPaint>(
        solver::solve(recipe, spectra::default_wavelengths_nm()));
}

paint::Recipe white_paint(double ground) {
    paint::Recipe recipe = paint_of({metal_flake(30, 1)});
    recipe.layers[0].flakes[0].orientation.beckmann_alpha = 0.2;
    recipe.substrate_reflectance = ground;
    return recipe;
}

TEST(HotSpotCompensation, LosesNoLightWhereNothingAbsorbs) {
    for (const bool pigment : {false, true}) {
        for (const double alpha : {0.05, 0.4}) {
            paint::Recipe recipe = white_paint(1);
            recipe.layers[0].flakes[0].orientation.beckmann_alpha = alpha;
            if (pigment) {
                recipe.layers[0].pigments.push_back({paint::PigmentCoefficients{40, 0, 0.5}});
            }
            const auto paint = shared_solution(recipe);
            const HotSpotBrdf brdf(*paint);
            for (const double theta_deg : {2.0, 45.0, 75.0, 86.0}) {
                const double theta = theta_deg * kDegree;
                const double specular = optics::dielectric_reflectance(1.0, 1.5, std::cos(theta));
                EXPECT_NEAR(specular + albedo_at_540(brdf, theta), 1, 1e-4)
                    << pigment << ' ' << alpha << ' ' << theta_deg;
            }
        }
    }
    // Half of what is scattered again was taken from it: without that, far above 1.
    const auto paint = shared_solution(white_paint(1));
    EXPECT_GT(albedo_at_540(HotSpotBrdf(*paint), 30 * kDegree, Part::single), 0.3);
}

TEST(HotSpotCompensation, NoPaintReturnsMoreLightThanItGets) {
    const SparklingModel model(white_paint(0.9), {.specimen = 1});
    for (const double theta : {0.0, 20.0, 45.0, 70.0, 85.0}) {
        EXPECT_LE(model.bound->albedo(direction(theta, 0))[3], 1.0f);
        EXPECT_GE(model.bound->albedo(direction(theta, 0))[3], 0.8f);
    }
}

// Below 150 flakes nothing is seen, and the gain of what lies there is beyond single precision.
TEST(HotSpotCompensation, WhatLiesBelowDeepFlakesIsNotSeen) {
    for (const double roughness : {0.0, 0.2}) {
        paint::Recipe alone = paint_of({metal_flake(20, 0.9)});
        alone.layers[0].flakes[0].amount = paint::AreaDensity{10.0};
        if (roughness > 0) alone.clearcoat = paint::Clearcoat{10, 0.0, roughness};
        paint::Recipe above = alone;
        above.layers.push_back(paint::Layer{30, {}, {{paint::PigmentCoefficients{100, 1, 0}}}});
        above.substrate_reflectance = 0.5;
        const SparklingModel one(alone, {.specimen = 1}), two(above, {.specimen = 1});
        for (const double theta_i : {5.0, 45.0, 80.0}) {
            for (const double theta_o : {0.0, 44.0, 75.0}) {
                for (const double phi : {0.0, 40.0, 180.0}) {
                    const Vec3f wi = direction(theta_i, 0), wo = direction(theta_o, phi);
                    const float expected = one.bound->eval(wi, wo)[3];
                    EXPECT_NEAR(two.bound->eval(wi, wo)[3], expected, 2e-3f * expected)
                        << roughness << ' ' << theta_i << ' ' << theta_o << ' ' << phi;
                }
            }
        }
    }
}

TEST(HotSpotCompensation, ADyeOverTheFlakesDimsAsTheClearcoatDoes) {
    for (const double roughness : {0.0, 0.2}) {
        paint::Recipe in_coat = paint_of({metal_flake(20, 0.9)});
        in_coat.clearcoat = paint::Clearcoat{30, 20.0, roughness};
        paint::Recipe in_layer = in_coat;
        in_layer.clearcoat = paint::Clearcoat{30, 0.0, roughness};
        in_layer.layers.insert(in_layer.layers.begin(),
                               paint::Layer{30, {}, {{paint::PigmentCoefficients{0, 20, 0}}}});
        const SparklingModel coat(in_coat, {.specimen = 1}), layer(in_layer, {.specimen = 1});
        for (const double theta_o : {0.0, 30.0, 60.0}) {
            for (const double phi : {0.0, 180.0}) {
                const Vec3f wi = direction(45, 0), wo = direction(theta_o, phi);
                const float expected = coat.bound->eval(wi, wo)[3];
                EXPECT_NEAR(layer.bound->eval(wi, wo)[3], expected, 2e-3f * expected)
                    << roughness << ' ' << theta_o << ' ' << phi;
            }
        }
    }
}

TEST(HotSpotCompensation, SmallFlakesLeaveTheEquationOfTransferAsItIs) {
    paint::Recipe recipe = recipe_with_every_feature();
    for (paint::Layer& layer : recipe.layers) {
        layer.flakes[0].diameter_um = 0.01;
        layer.flakes[0].diameter_spread_um = 0;
    }
    const auto paint = shared_solution(recipe);
    const HotSpotBrdf brdf(*paint);
    for (const double theta_o : {0.0, 0.5, 1.2}) {
        const auto f = brdf(0.6, theta_o, 2.5), expected = paint->brdf(0.6, theta_o, 2.5);
        for (std::size_t w = 0; w < f.size(); ++w)
            EXPECT_NEAR(f[w], expected[w], 5e-3 * expected[w]);
    }
}

TEST(HotSpotCompensation, WithoutFlakesThereIsNothingToClose) {
    paint::Recipe recipe = paint_of({});
    recipe.layers[0].pigments = {{paint::PigmentCoefficients{200.0, 50.0, 0.3}}};
    recipe.substrate_reflectance = 0.5;
    const SparklingModel hot(recipe, {.specimen = 1}), plain(recipe);
    const Vec3f wi = direction(30, 0), wo = direction(40, 100);
    for (int lane = 0; lane < kLanes; ++lane) {
        // The same sum in two functions, whose products are contracted differently.
        EXPECT_FLOAT_EQ(hot.bound->eval(wi, wo)[lane], plain.bound->eval(wi, wo)[lane]);
    }
}

// Every feature; transparent flakes; no interface; a black paint; two species in one layer.
std::vector<paint::Recipe> various_paints() {
    std::vector<paint::Recipe> all = {
        recipe_with_every_feature(), paint_of({pearl_flake(25)}), paint_of({metal_flake(40, 0.9)}),
        paint_of({metal_flake(20, 0)}), paint_of({metal_flake(20, 0.7), pearl_flake(60)})};
    all[1].substrate_reflectance = 0.7;
    all[2].binder = optics::Material(1.0);
    return all;
}

// As a file may have it that another program wrote.
TEST(HotSpotCompensation, NodesWithoutOrderZeroAreBlack) {
    constexpr std::size_t kFirst = 4;
    const SparklingModel model(paint_of({metal_flake(20, 0.1)}), {.hot_spot = true});
    solver::SolvedPaint zeros = *model.paint, none = zeros;
    solver::MultipleScattering& tensor = none.multiple_scattering;
    const std::size_t pairs = tensor.pair_count();
    const auto rank = static_cast<std::size_t>(tensor.rank());
    const std::size_t nodes = tensor.exit_angle.size();
    std::vector<float> left;
    for (std::size_t k = 0; k < rank; ++k) {
        for (std::size_t i = 0, pair = 0; i < nodes; ++i) {
            for (std::size_t j = 0; j <= i; ++j, ++pair) {
                float& value = zeros.multiple_scattering.coefficient[k * pairs + pair];
                if (j < kFirst) {
                    value = 0;
                } else {
                    left.push_back(value);
                }
            }
        }
    }
    // Of one order, so that the others need no places of their own.
    zeros.multiple_scattering.first = {0};
    std::vector<float> order_0;
    for (std::size_t k = 0; k < rank; ++k) {
        const auto begin = zeros.multiple_scattering.coefficient.begin() + k * pairs;
        order_0.insert(order_0.end(), begin, begin + solver::triangle(nodes));
    }
    zeros.multiple_scattering.coefficient = order_0;
    tensor.first = {static_cast<int>(kFirst)};
    tensor.coefficient = left;
    const std::vector<float> compensation = HotSpotTables(none).compensation();
    EXPECT_EQ(compensation, HotSpotTables(zeros).compensation());
    EXPECT_NE(compensation, HotSpotTables(*model.paint).compensation());
    // Without orders there is nothing to close.
    tensor.first.clear();
    tensor.coefficient.clear();
    EXPECT_THAT(HotSpotTables(none).compensation(), testing::Each(1.0f));
}

TEST(HotSpotCompensation, ValuesAreThoseOfTheModel) {
    for (const paint::Recipe& recipe : various_paints()) {
        const SparklingModel model(recipe, {.specimen = 1});
        const HotSpotBrdf brdf(*model.paint);
        for (const double theta_i : {15.0, 45.0}) {
            double peak = 0, worst = 0;
            for (double theta_o = 0; theta_o < 80; theta_o += 7) {
                for (const double phi : {0.0, 90.0, 160.0, 180.0}) {
                    const Vec3f wi = direction(theta_i, 0), wo = direction(theta_o, phi);
                    const float f = model.bound->eval(wi, wo)[3];
                    const double exact =
                        brdf(theta_i * kDegree, theta_o * kDegree, phi * kDegree)[k540];
                    EXPECT_GE(f, 0);
                    EXPECT_GE(exact, 0);
                    EXPECT_NEAR(f, model.bound->eval(wo, wi)[3], 1e-5 * f) << "not reciprocal";
                    peak = std::max(peak, exact);
                    worst = test::worse(worst, std::abs(f - exact));
                }
            }
            EXPECT_LE(worst, kMicroflakeError * peak);
        }
    }
}

}  // namespace
}  // namespace nacre::bsdf
