#include "nacre/measure/acquire.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <numbers>
#include <numeric>
#include <thread>

#include "nacre/bsdf/measured/merl.h"
#include "nacre/bsdf/measured/rgl.h"
#include "nacre/core/error.h"
#include "nacre/core/math.h"
#include "nacre/testing/brdf.h"
#include "nacre/testing/bsdf.h"

namespace nacre::measure {
namespace {

using bsdf::direction;
using testing::ggx;
using testing::kLanesAt;
using testing::kThree;
using testing::lambertian;

bsdf::MerlTable table_of(const Brdf& brdf, const MerlSettings& settings = {}) {
    return acquire_merl(brdf, kThree, settings);
}

TEST(AcquireMerl, ReproducesAWhiteDiffuser) {
    const auto bound = bsdf::MeasuredMerl(table_of(lambertian({1, 1, 1}))).bind(kLanesAt);
    for (const double theta_i : {0.5, 30.0, 60.0, 80.0}) {
        const Vec3f wi = direction(theta_i, 20);
        EXPECT_NEAR(bound->albedo(wi)[3], 1, 5e-3);  // error of midpoints near the horizon
        const auto [mean, error] = bsdf::mean_weight(*bound, wi, 3, 40000, 5);
        EXPECT_NEAR(mean, 1, 4 * error);
        EXPECT_NEAR(bound->eval(wi, direction(70, 140))[3], std::numbers::inv_pi, 1e-6);
    }
}

TEST(AcquireMerl, HoldsAGlossyConductorToAFewPerCent) {
    const Brdf brdf = ggx(0.15, {0.9, 0.9, 0.9});
    const bsdf::MeasuredMerl model(table_of(brdf));
    const TableError error = table_error(model, brdf, kThree, true);
    EXPECT_LT(error.flux, 2e-3);
    EXPECT_LT(error.peak, 2e-2);
    const auto bound = model.bind(kLanesAt);
    for (const double theta_i : {5.0, 45.0, 70.0}) {
        const auto [mean, e] = bsdf::mean_weight(*bound, direction(theta_i, 0), 3, 30000, 5);
        EXPECT_NEAR(bound->albedo(direction(theta_i, 0))[3], mean, 4 * e + 5e-3);
    }
}

// In the middle of a cell the value is that of the cell, as the database's reading code has it.
TEST(AcquireMerl, MiddlesOfCellsHoldTheBrdf) {
    const Brdf brdf = ggx(0.3, {0.9, 0.9, 0.9});
    const bsdf::MerlTable table = table_of(brdf, {20, 18, 24});
    const auto bound = bsdf::MeasuredMerl(table).bind(kLanesAt);
    int compared = 0;
    for (int h = 0; h < 20; ++h) {
        for (int d = 0; d < 18; d += 3) {
            for (int a = 0; a < 24; a += 5) {
                const bsdf::DirectionPair pair = bsdf::directions_of(table.middle(h, d, a));
                const auto vec = [](const Vec3d& w) {
                    return Vec3f{static_cast<float>(w[0]), static_cast<float>(w[1]),
                                 static_cast<float>(w[2])};
                };
                const double value = table.values[table.cell(h, d, a)];
                if (pair.wi[2] <= 0 || pair.wo[2] <= 0) {
                    EXPECT_EQ(value, -1);
                    continue;
                }
                const double wanted = value / 1500;
                // At the first middles of theta_half rounding moves phi_d: found 7e-7.
                EXPECT_NEAR(bound->eval(vec(pair.wi), vec(pair.wo))[3], wanted, 2e-5 * wanted);
                EXPECT_NEAR(bound->eval(vec(pair.wo), vec(pair.wi))[3], wanted, 2e-5 * wanted);
                ++compared;
            }
        }
    }
    EXPECT_GT(compared, 300);
}

TEST(AcquireMerl, SamplesFollowTheDensity) {
    int tests = 0;
    for (const Brdf& brdf : {lambertian({0.5, 0.5, 0.5}), ggx(0.4, {1, 1, 1})}) {
        const auto bound = bsdf::MeasuredMerl(table_of(brdf, {30, 30, 60})).bind(kLanesAt);
        for (const double theta_i : {3.0, 35.0, 65.0}) {
            // Six one-sided tests with fixed seeds: 3.5 deviations are one false alarm in 700.
            EXPECT_LT(bsdf::chi_square_z_score(*bound, direction(theta_i, 70), 31 + tests, 100000),
                      3.5)
                << theta_i;
            ++tests;
        }
    }
    EXPECT_EQ(tests, 6);
}

TEST(AcquireMerl, SampleReportsItsOwnDensityAndWeight) {
    const auto bound = bsdf::MeasuredMerl(table_of(ggx(0.1, {0.9, 0.6, 0.3}))).bind(kLanesAt);
    Rng rng(3, 1);
    int drawn = 0;
    double largest = 0;
    for (int i = 0; i < 4000; ++i) {
        const Vec3f wi = direction(80 * rng.uniform_double(), 40);
        const auto s =
            bound->sample(wi, rng.uniform_float(), {rng.uniform_float(), rng.uniform_float()});
        if (!s) continue;
        ++drawn;
        const bsdf::BsdfValue both = bound->evaluate(wi, s->wo);
        ASSERT_NEAR(s->pdf, both.pdf, 1e-5f * s->pdf);
        ASSERT_NEAR(s->weight[2], both.f[2] * s->wo.z / s->pdf, 1e-4f * s->weight[2] + 1e-6f);
        largest = std::max<double>(largest, lane_max(s->weight));
    }
    EXPECT_GT(drawn, 3000);
    EXPECT_LT(largest, 12);  // lobes of Gaussian slopes have thinner tails than GGX
}

TEST(AcquireMerl, CellsThatWereNotMeasuredTakeNoPart) {
    bsdf::MerlTable table = table_of(lambertian({1, 1, 1}), {12, 10, 8});
    Rng rng(2, 2);
    for (std::size_t i = 0; i < table.cells(); ++i) {
        if (rng.uniform_double() < 0.3) table.values[i + table.cells()] = -1;  // green only
    }
    const auto bound = bsdf::MeasuredMerl(table).bind(kLanesAt);
    for (int i = 0; i < 300; ++i) {
        const double f =
            bound->eval(direction(60 * rng.uniform_double(), 10),
                        direction(60 * rng.uniform_double(), 360 * rng.uniform_double()))[3];
        EXPECT_TRUE(std::abs(f - std::numbers::inv_pi) < 1e-5 || f == 0) << f;
    }
    std::fill(table.values.begin(), table.values.end(), -1.0);
    const auto nothing = bsdf::MeasuredMerl(table).bind(kLanesAt);
    EXPECT_EQ(lane_max(nothing->eval(direction(30, 0), direction(20, 0))), 0);
    EXPECT_EQ(lane_max(nothing->albedo(direction(30, 0))), 0);
}

TEST(AcquireMerl, IsBlackBelowTheHorizonAndFiniteAtItsEdges) {
    const auto bound =
        bsdf::MeasuredMerl(table_of(ggx(0.2, {1, 1, 1}), {12, 10, 8})).bind(kLanesAt);
    const Vec3f down = {0.6f, 0, -0.8f}, up = direction(30, 0);
    EXPECT_EQ(lane_max(bound->eval(up, down)), 0);
    EXPECT_EQ(bound->pdf(down, up), 0);
    EXPECT_FALSE(bound->sample(down, 0.5f, {0.5f, 0.5f}).has_value());
    const Vec3f edges[] = {
        {0, 0, 1}, {1e-30f, 0, 1}, {1, 0, 1e-20f}, {-1, 0, 1e-20f}, {0, 1, 1e-6f}};
    for (const Vec3f& a : edges) {
        for (const Vec3f& b : edges) {
            const bsdf::BsdfValue both = bound->evaluate(a, b);
            ASSERT_TRUE(std::isfinite(both.f[0]) && both.f[0] >= 0);
            ASSERT_TRUE(std::isfinite(both.pdf) && both.pdf >= 0);
        }
    }
}

TEST(AcquireMerl, RefusesSettingsAndValuesOutOfRange) {
    const Brdf white = lambertian({1, 1, 1});
    EXPECT_THROW(table_of(white, {1, 10, 10}), DomainError);
    EXPECT_THROW(table_of(white, {10, 10, 2000}), DomainError);
    EXPECT_THROW(table_of(white, {1024, 1024, 1024}), DomainError);  // 24 GiB
    EXPECT_THROW(table_of(lambertian({1, -1, 1}), {4, 4, 4}), DomainError);
    EXPECT_THROW(acquire_merl(white, kThree, {4, 4, 4}, [](double) { return false; }), Error);
}

using bsdf::direction;
using testing::ggx;
using testing::kLanesAt;
using testing::kThree;
using testing::lambertian;

bsdf::MeasuredRgl measured(const Brdf& brdf, const RglSettings& settings = {}) {
    return bsdf::MeasuredRgl(acquire_rgl("test", brdf, kThree, settings));
}

// The table interpolates f cos(theta_o), which is not linear even here: the tolerance is the error
// of the format.
TEST(AcquireRgl, ReproducesAWhiteDiffuser) {
    const auto bound = measured(lambertian({1, 1, 1})).bind(kLanesAt);
    for (const double theta_i : {0.5, 30.0, 60.0, 80.0}) {
        const Vec3f wi = direction(theta_i, 20);
        EXPECT_NEAR(bound->albedo(wi)[3], 1, 4e-3);
        const auto [mean, error] = bsdf::mean_weight(*bound, wi, 3, 40000, 5);
        EXPECT_NEAR(mean, 1, 4 * error + 4e-3);
        for (const double theta_o : {1.0, 25.0, 50.0, 70.0}) {
            const Vec3f wo = direction(theta_o, 140);
            EXPECT_NEAR(bound->eval(wi, wo)[3] * wo.z, wo.z / std::numbers::pi, 2e-3);
        }
    }
}

TEST(AcquireRgl, TheFacetsOfAMicrofacetSurfaceAreFound) {
    // A fiftieth is uniform (acquire.h). Retroreflection of Smith's model is D masked twice,
    // not once, so that the facets found are those up to 40 deg only.
    const double alpha = 0.2;
    const bsdf::RglTable table = acquire_rgl("test", ggx(alpha, {1, 1, 1}), kThree, {});
    const int n = table.ndf.columns;
    for (int k = 0; k < n; k += 8) {
        const double x = static_cast<double>(k) / (n - 1), theta = 0.5 * std::numbers::pi * x * x;
        if (theta > 0.7) break;
        const double tan2 = std::pow(std::tan(theta), 2), a2 = alpha * alpha;
        const double d =
            a2 / (std::numbers::pi * std::pow(std::cos(theta), 4) * std::pow(a2 + tan2, 2));
        EXPECT_NEAR(table.ndf.values[k], 0.98 * d + 0.02 / std::numbers::pi, 0.03 * d) << theta;
    }
    // The projected area from above is 1 by convention.
    EXPECT_NEAR(table.sigma.values[0], 1, 1e-5);
}

TEST(AcquireRgl, ErrorsFallWithTheResolution) {
    const Brdf brdf = ggx(0.15, {0.9, 0.6, 0.3});
    const TableError coarse =
        table_error(measured(brdf, {16, 16, 256, false}), brdf, kThree, false);
    const TableError fine = table_error(measured(brdf, {64, 64, 256, false}), brdf, kThree, false);
    EXPECT_LT(fine.flux, 2e-3);
    EXPECT_LT(fine.peak, 1.5e-2);
    EXPECT_LT(fine.flux, 0.2 * coarse.flux);  // fourfold nodes; cells at the horizon improve least
}

// About the pole of the half vectors the nodes are evenly spaced in theta_m, so that a lobe's peak is
// rounded and not pointed: the interpolant of (1 - theta/b)-like slopes is exact there.
TEST(AcquireRgl, NodesAreEvenlySpacedAboutTheFlatDirection) {
    const Brdf brdf = ggx(0.15, {0.9, 0.9, 0.9});
    const bsdf::RglTable table = acquire_rgl("test", brdf, kThree, {});
    const bsdf::RglMap map(table);
    int compared = 0;
    for (const double theta_i : {10.0, 60.0, 80.0}) {
        const bsdf::RglIncident i = map.incident(direction(theta_i, 0));
        const auto polar = [&](int node) {
            return bsdf::polar_angle(map.at(i, {node / 63.0f, 0.5f}).normal);
        };
        const float first = polar(1);
        EXPECT_LT(first,
                  0.03);  // of a lobe 0.15 wide; visible facets have their first node at 0.06
        for (int node = 2; node <= 5; ++node) {
            EXPECT_NEAR(polar(node) - polar(node - 1), first, 0.1 * first);
            ++compared;
        }
        // Off the nodes, next to the mirror direction.
        for (const double off : {0.2, 0.5, 1.0}) {
            const double theta_o = theta_i - off;
            const FloatLanes f = bsdf::MeasuredRgl(table).bind(kLanesAt)->eval(
                direction(theta_i, 0), direction(theta_o, 180));
            const double wanted = brdf(theta_i * kDegree, theta_o * kDegree, std::numbers::pi)[0];
            EXPECT_NEAR(f[0], wanted, 0.006 * wanted) << theta_i << " " << off;
            ++compared;
        }
    }
    EXPECT_EQ(compared, 21);
}

TEST(AcquireRgl, ValuesAtTheNodesAreThoseOfTheBrdf) {
    const Brdf brdf = ggx(0.3, {0.9, 0.6, 0.3});
    const RglSettings settings{12, 8, 64, false};
    const bsdf::RglTable table = acquire_rgl("test", brdf, kThree, settings);
    const auto bound = bsdf::MeasuredRgl(table).bind(kLanesAt);
    // A uniform luminance passes samples on: those at nodes of the table stay there.
    bsdf::RglTable even = table;
    std::fill(even.luminance.begin(), even.luminance.end(), 1.0f);
    const auto drawing = bsdf::MeasuredRgl(even).bind(kLanesAt);
    const double theta_i = table.theta_i[3];
    const Vec3f wi = direction(theta_i / kDegree, 0);
    int compared = 0;
    for (int column = 1; column < 11; ++column) {
        for (int row = 1; row < 11; ++row) {
            const auto s = drawing->sample(wi, 0, {column / 11.0f, row / 11.0f});
            if (!s || s->wo.z < 0.05f) continue;
            const auto f = brdf(theta_i, std::acos(s->wo.z), std::atan2(s->wo.y, s->wo.x));
            // Rounding of the position: found 4e-6.
            EXPECT_NEAR(bound->eval(wi, s->wo)[0], f[0], 5e-5 * f[0]);
            EXPECT_NEAR(bound->eval(wi, s->wo)[4], f[1], 5e-5 * f[1]);
            ++compared;
        }
    }
    EXPECT_GT(compared, 60);
}

TEST(AcquireRgl, SamplesFollowTheDensity) {
    int tests = 0;
    for (const Brdf& brdf : {lambertian({0.5, 0.5, 0.5}), ggx(0.4, {1, 1, 1})}) {
        const auto bound = measured(brdf, {32, 24, 128, false}).bind(kLanesAt);
        for (const double theta_i : {3.0, 35.0, 65.0}) {
            // Six one-sided tests with fixed seeds: 3.5 deviations are one false alarm in 700.
            EXPECT_LT(bsdf::chi_square_z_score(*bound, direction(theta_i, 70), 31 + tests, 100000),
                      3.5)
                << theta_i;
            ++tests;
        }
    }
    EXPECT_EQ(tests, 6);
}

TEST(AcquireRgl, SampleReportsItsOwnDensityAndWeight) {
    const auto bound = measured(ggx(0.15, {0.9, 0.6, 0.3})).bind(kLanesAt);
    Rng rng(3, 1);
    int drawn = 0;
    double largest = 0;
    for (int i = 0; i < 3000; ++i) {
        const Vec3f wi = bsdf::direction(85 * rng.uniform_double(), 360 * rng.uniform_double());
        const auto s =
            bound->sample(wi, rng.uniform_float(), {rng.uniform_float(), rng.uniform_float()});
        if (!s || s->wo.z < 1e-3f) continue;
        ++drawn;
        const bsdf::BsdfValue both = bound->evaluate(wi, s->wo);
        // The half vector is found again with the rounding of single precision, the more of it the
        // narrower the lobe.
        ASSERT_NEAR(s->pdf, both.pdf, 5e-3f * s->pdf);
        ASSERT_NEAR(bound->pdf(wi, s->wo), both.pdf, 1e-5f * both.pdf);
        ASSERT_NEAR(s->weight[0], both.f[0] * s->wo.z / s->pdf, 5e-3f * s->weight[0] + 1e-4f);
        largest = std::max<double>(largest, lane_max(s->weight));
    }
    EXPECT_GT(drawn, 2500);
    EXPECT_LT(largest, 3);  // the luminance follows the values: weights are near the albedo
}

TEST(AcquireRgl, DensitiesOfEightDirectionsAreThoseOfEach) {
    bsdf::expect_densities_of_eight(*measured(ggx(0.15, {0.9, 0.6, 0.3})).bind(kLanesAt), 1e-5f);
}

TEST(AcquireRgl, TurningTheSurfaceChangesNothing) {
    const auto bound = measured(ggx(0.3, {0.9, 0.6, 0.3}), {24, 16, 128, false}).bind(kLanesAt);
    for (const double turn : {10.0, 95.0, -170.0}) {
        const FloatLanes a = bound->eval(direction(40, 0), direction(30, 160));
        const FloatLanes b = bound->eval(direction(40, turn), direction(30, 160 + turn));
        EXPECT_NEAR(a[0], b[0], 1e-4 * a[0]);
    }
}

TEST(AcquireRgl, WavelengthsAreLinearBetweenAndConstantBeyond) {
    const auto model = measured(lambertian({0.2, 0.4, 0.8}), {16, 8, 64, false});
    const auto bound = model.bind({300, 450, 500, 550, 575, 650, 700, 1000});
    const FloatLanes f = bound->eval(direction(30, 0), direction(20, 90));
    EXPECT_FLOAT_EQ(f[0], f[1]);
    EXPECT_NEAR(f[2], (f[1] + f[3]) / 2, 1e-6);
    EXPECT_NEAR(f[4], f[3] + 0.25 * (f[5] - f[3]), 1e-6);
    EXPECT_FLOAT_EQ(f[6], f[5]);
    EXPECT_FLOAT_EQ(f[7], f[5]);
}

TEST(AcquireRgl, RgbKeepsGreysGrey) {
    RglSettings settings{32, 16, 128, true};
    const bsdf::RglTable table = acquire_rgl("test", lambertian({0.5, 0.5, 0.5}), kThree, settings);
    EXPECT_TRUE(table.is_rgb());
    const FloatLanes f =
        bsdf::MeasuredRgl(table).bind(kLanesAt)->eval(direction(30, 0), direction(20, 90));
    for (int i = 0; i < kLanes; ++i) EXPECT_NEAR(f[i], 0.5 / std::numbers::pi, 2e-3);
}

TEST(AcquireRgl, ABlackSurfaceIsBlack) {
    const auto bound = measured(lambertian({0, 0, 0}), {16, 8, 64, false}).bind(kLanesAt);
    EXPECT_EQ(lane_max(bound->eval(direction(30, 0), direction(20, 90))), 0);
    EXPECT_EQ(lane_max(bound->albedo(direction(30, 0))), 0);
    EXPECT_GT(bound->pdf(direction(30, 0), direction(20, 90)), 0);
}

TEST(AcquireRgl, IsBlackBelowTheHorizonAndFiniteAtItsEdges) {
    const auto bound = measured(ggx(0.2, {1, 1, 1}), {16, 8, 64, false}).bind(kLanesAt);
    const Vec3f down = {0.6f, 0, -0.8f}, up = direction(30, 0);
    EXPECT_EQ(lane_max(bound->eval(up, down)), 0);
    EXPECT_EQ(bound->pdf(down, up), 0);
    EXPECT_EQ(lane_max(bound->albedo(down)), 0);
    EXPECT_FALSE(bound->sample(down, 0.5f, {0.5f, 0.5f}).has_value());
    const Vec3f edges[] = {{0, 0, 1},       {1e-30f, 0, 1}, {0, -1e-12f, 1},    {1, 0, 1e-20f},
                           {-1, 0, 1e-20f}, {0, 1, 1e-6f},  {0.6f, 0.8f, 1e-4f}};
    for (const Vec3f& a : edges) {
        for (const Vec3f& b : edges) {
            const bsdf::BsdfValue both = bound->evaluate(a, b);
            ASSERT_TRUE(std::isfinite(both.f[0]) && both.f[0] >= 0);
            ASSERT_TRUE(std::isfinite(both.pdf) && both.pdf >= 0);
        }
        for (const float u : {0.0f, 0.3f, 0.999f}) {
            const auto s = bound->sample(a, u, {u, 1 - u});
            if (s) {
                ASSERT_TRUE(std::isfinite(lane_max(s->weight)) && s->pdf > 0);
            }
        }
    }
}

TEST(AcquireRgl, RefusesSettingsAndValuesOutOfRange) {
    const Brdf white = lambertian({1, 1, 1});
    EXPECT_THROW(acquire_rgl("", white, kThree, {3, 8, 64, false}), DomainError);
    EXPECT_THROW(acquire_rgl("", white, kThree, {16, 1, 64, false}), DomainError);
    EXPECT_THROW(acquire_rgl("", white, {550, 450, 650}, {}), DomainError);
    std::vector<double> many(31);
    std::iota(many.begin(), many.end(), 500.0);
    EXPECT_THROW(acquire_rgl("", white, many, {512, 256, 64, false}), DomainError);  // 8 GiB
    EXPECT_THROW(acquire_rgl("", lambertian({1, -1, 1}), kThree, {16, 8, 64, false}), DomainError);
    EXPECT_THROW(acquire_rgl("", lambertian({1, 1}), kThree, {16, 8, 64, false}), DomainError);
    EXPECT_THROW(acquire_rgl("", white, kThree, {16, 8, 64, false}, [](double) { return false; }),
                 Error);
}

// A BRDF may take milliseconds for each pair of directions: a progress that asks to stop is heard
// long before all of them have been compared.
TEST(TableError, StopsWithinTheComparison) {
    const Brdf white = lambertian({1, 1, 1});
    const bsdf::MeasuredMerl table(table_of(white, {8, 8, 8}));
    EXPECT_EQ(table_error(table, white, kThree, true, [](double) { return true; }).flux,
              table_error(table, white, kThree, true).flux);
    std::atomic<int> calls = 0, values = 0;
    const Brdf slow = [&](double theta_i, double theta_o, double phi) {
        ++values;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return white(theta_i, theta_o, phi);
    };
    EXPECT_THROW(table_error(table, slow, kThree, true, [&](double) { return ++calls < 2; }),
                 Stopped);
    EXPECT_EQ(calls, 2);
    EXPECT_GT(values, 0);
}

TEST(AcquireRgl, StopsBeforeItsRows) {
    int values = 0;
    const Brdf white = lambertian({1, 1, 1});
    const Brdf counted = [&](double theta_i, double theta_o, double phi) {
        ++values;
        return white(theta_i, theta_o, phi);
    };
    EXPECT_THROW(acquire_rgl("", counted, kThree, {16, 8, 64, false}, [](double) { return false; }),
                 Stopped);
    EXPECT_EQ(values, 0);
}

}  // namespace
}  // namespace nacre::measure
