#include "nacre/bsdf/models/rough_hot_spot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nacre/bsdf/models/hot_spot_brdf.h"
#include "nacre/core/math.h"
#include "nacre/core/quadrature.h"
#include "nacre/sparkle/coat_tilt.h"
#include "nacre/testing/nacre_model.h"
#include "nacre/testing/statistics.h"

// The hot spot under a rough clearcoat. Against explicit discs: apps/study/flakes_mean_test.cpp.

namespace nacre::bsdf {
namespace {

constexpr double kIor = 1.5;

// The tangent of a direction that a facet of Gaussian slopes refracts into the coat, by Snell's law
// for vectors; facets count by the area that is seen of them.
struct Refracted {
    double x, y, weight;
};
Refracted refracted(const Vec3d& w, double roughness, Rng& rng) {
    const double r = roughness * std::sqrt(-std::log(1 - rng.uniform_double()));
    const double turn = 2 * std::numbers::pi * rng.uniform_double();
    const Vec3d m = normalize(Vec3d{r * std::cos(turn), r * std::sin(turn), 1});
    const double cosine = dot(w, m);
    if (cosine <= 0) return {0, 0, 0};
    const double inside = std::sqrt(1 - (1 - cosine * cosine) / (kIor * kIor));
    const Vec3d in = (1 / kIor) * w + (inside - cosine / kIor) * m;
    return {in.x / in.z, in.y / in.z, cosine / (m.z * w.z)};
}

TEST(RoughHotSpot, FacetsTurnRaysApartAsIsStated) {
    struct Case {
        double roughness, theta_i, theta_o, phi;
    };
    for (const Case& c : {Case{0.1, 5, 5, 0}, Case{0.3, 5, 5, 0}, Case{0.2, 30, 30, 180},
                          Case{0.3, 45, 10, 180}, Case{0.3, 45, 45, 0}, Case{0.4, 30, 30, 0}}) {
        SCOPED_TRACE(testing::Message() << c.roughness << ' ' << c.theta_i << ' ' << c.theta_o);
        const auto towards = [](double theta_deg, double phi_deg) {
            const double s = std::sin(theta_deg * kDegree);
            return Vec3d{s * std::cos(phi_deg * kDegree), s * std::sin(phi_deg * kDegree),
                         std::cos(theta_deg * kDegree)};
        };
        const Vec3d wi = towards(c.theta_i, 0), wo = towards(c.theta_o, c.phi);
        Rng rng(3, 1);
        double sum = 0, weights = 0;
        for (int n = 0; n < 100000; ++n) {
            const Refracted i = refracted(wi, c.roughness, rng),
                            o = refracted(wo, c.roughness, rng);
            sum += i.weight * o.weight * std::hypot(i.x - o.x, i.y - o.y);
            weights += i.weight * o.weight;
        }
        const auto tangent = [](const Vec3d& w) {
            const double z = std::sqrt(kIor * kIor - w.x * w.x - w.y * w.y);
            return Vec3d{w.x / z, w.y / z, z / kIor};
        };
        const Vec3d i = tangent(wi), o = tangent(wo);
        const double square = (i.x - o.x) * (i.x - o.x) + (i.y - o.y) * (i.y - o.y);
        const sparkle::CoatTilt coat(c.roughness, kIor);
        EXPECT_NEAR(coat.separation(static_cast<float>(square), static_cast<float>(i.z),
                                    static_cast<float>(o.z)),
                    sum / weights, 0.1 * sum / weights);
    }
    EXPECT_FLOAT_EQ(sparkle::CoatTilt().separation(0.25f, 0.8f, 0.9f), 0.5f);
    EXPECT_LT(sparkle::CoatTilt(0.3, 1 + 1e-8).separation(0, 1, 1), 1e-5f);
}

solver::SolvedPaint solved(paint::Recipe recipe, double roughness) {
    if (!recipe.clearcoat) recipe.clearcoat = paint::Clearcoat{0, spectra::Spectrum(0.0), 0};
    recipe.clearcoat->roughness = roughness;
    return solver::solve(recipe, spectra::default_wavelengths_nm());
}

paint::Recipe dense_flakes(double diameter_um, double reflectance, double alpha = 0.2) {
    paint::Recipe recipe = paint_of({metal_flake(diameter_um, reflectance)});
    recipe.layers[0].flakes[0].orientation.beckmann_alpha = alpha;
    return recipe;
}

// The least roughness that a recipe may have, over flakes whose lobes it widens by less than 1 %.
TEST(RoughHotSpot, IsThatOfASmoothCoatInTheLimit) {
    paint::Recipe recipe = dense_flakes(20, 0.7);
    recipe.substrate_reflectance = 0.6;
    recipe.clearcoat = paint::Clearcoat{30, spectra::Spectrum(4.0), 0};
    const solver::SolvedPaint smooth = solved(recipe, 0), rough = solved(recipe, 0.01);
    const HotSpotBrdf on_smooth(smooth), on_rough(rough);
    for (const Part part : {Part::single, Part::multiple}) {
        double peak = 0, worst = 0, gain = 0;
        for (double theta_o = 0; theta_o < 75; theta_o += 9) {
            for (const double phi : {0.0, 90.0, 170.0, 180.0}) {
                const auto at = [&](auto&& brdf) {
                    return brdf(30 * kDegree, theta_o * kDegree, phi * kDegree, part)[k540];
                };
                const double f = at(on_smooth);
                peak = std::max(peak, f);
                worst = test::worse(worst, std::abs(at(on_rough) - f));
                gain = std::max(gain, std::abs(smooth.brdf(30 * kDegree, theta_o * kDegree,
                                                           phi * kDegree, part)[k540] -
                                               f));
            }
        }
        EXPECT_LT(worst, (part == Part::single ? 1e-3 : 2e-3) * peak);
        EXPECT_GT(gain, 0.1 * peak);
    }
}

TEST(RoughHotSpot, WhiteFlakesOverWhiteGroundLoseNoLight) {
    paint::Recipe recipe = dense_flakes(30, 1);
    recipe.substrate_reflectance = 1;
    const solver::SolvedPaint paint = solved(recipe, 0.2);
    const HotSpotBrdf brdf(paint);
    for (const double theta_deg : {5.0, 45.0, 70.0}) {
        EXPECT_NEAR(albedo_at_540(brdf, theta_deg * kDegree), 1, 1e-4) << theta_deg;
    }
    // And much of it is moved.
    const auto single = [&](auto&& f) { return f(0.5, 0.5, std::numbers::pi, Part::single)[k540]; };
    EXPECT_GT(single(brdf), 1.3 * single([&](double i, double o, double phi, Part part) {
                                return paint.brdf(i, o, phi, part);
                            }));
}

TEST(RoughHotSpot, SmallFlakesLeaveTheEquationOfTransferAsItIs) {
    paint::Recipe recipe = recipe_with_every_feature();
    for (paint::Layer& layer : recipe.layers) {
        layer.flakes[0].diameter_um = 0.01;
        layer.flakes[0].diameter_spread_um = 0;
    }
    const solver::SolvedPaint paint = solved(recipe, 0.12);
    const HotSpotBrdf brdf(paint);
    for (const double theta_o : {0.0, 0.5, 1.2}) {
        const auto f = brdf(0.6, theta_o, 2.5), expected = paint.brdf(0.6, theta_o, 2.5);
        for (std::size_t w = 0; w < f.size(); ++w) {
            EXPECT_NEAR(f[w], expected[w], 5e-3 * expected[w]);
        }
    }
}

TEST(RoughHotSpot, ValuesAreThoseOfTheModel) {
    // Every feature; transparent flakes; black ones; none.
    std::vector<paint::Recipe> recipes = {recipe_with_every_feature(), paint_of({pearl_flake(25)}),
                                          paint_of({metal_flake(20, 0)}), paint_of({})};
    recipes[1].substrate_reflectance = 0.7;
    recipes[3].layers[0].pigments = {{paint::PigmentCoefficients{200.0, 50.0, 0.3}}};
    for (paint::Recipe& recipe : recipes) {
        recipe.clearcoat = paint::Clearcoat{20, spectra::Spectrum(2.0), 0.15};
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
                    EXPECT_NEAR(f, model.bound->eval(wo, wi)[3], 1e-5 * f) << "not reciprocal";
                    peak = std::max(peak, exact);
                    worst = test::worse(worst, std::abs(f - exact));
                }
            }
            EXPECT_LE(worst, kMicroflakeRoughError * peak);
        }
    }
}

TEST(RoughHotSpot, LeavesPaintsUnderASmoothCoatAlone) {
    const solver::SolvedPaint paint = solved(dense_flakes(20, 0.7), 0);
    EXPECT_EQ(with_rough_hot_spot(paint), paint);
}

}  // namespace
}  // namespace nacre::bsdf
