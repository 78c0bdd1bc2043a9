#include "nacre/measure/acquire_merl.h"

#include <gtest/gtest.h>

#include "nacre/bsdf/measured_merl.h"
#include "nacre/bsdf/test_support.h"
#include "nacre/core/error.h"
#include "nacre/measure/analytic_brdf_test_support.h"
#include "nacre/measure/table_error.h"

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

TEST(AcquireMerl, AWhiteDiffuserComesBack) {
    const auto bound = bsdf::MeasuredMerl(table_of(lambertian({1, 1, 1}))).bind(kLanesAt);
    for (const double theta_i : {0.5, 30.0, 60.0, 80.0}) {
        const Vec3f wi = direction(theta_i, 20);
        EXPECT_NEAR(bound->albedo(wi)[3], 1, 5e-3);  // midpoints near the horizon
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
                const auto vec = [](const std::array<double, 3>& w) {
                    return Vec3f{static_cast<float>(w[0]), static_cast<float>(w[1]),
                                 static_cast<float>(w[2])};
                };
                const double value = table.values[table.cell(h, d, a)];
                if (pair.wi[2] <= 0 || pair.wo[2] <= 0) {
                    EXPECT_EQ(value, -1);
                    continue;
                }
                const double wanted = value / 1500;
                // At the first middles of theta_half rounding moves phi_d.
                EXPECT_NEAR(bound->eval(vec(pair.wi), vec(pair.wo))[3], wanted, 2e-3 * wanted);
                EXPECT_NEAR(bound->eval(vec(pair.wo), vec(pair.wi))[3], wanted, 2e-3 * wanted);
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

}  // namespace
}  // namespace nacre::measure
