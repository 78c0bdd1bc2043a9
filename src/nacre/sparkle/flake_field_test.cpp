#include "nacre/sparkle/flake_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <memory>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/core/random.h"
#include "nacre/sparkle/flake_field_test_support.h"
#include "nacre/testing/statistics.h"

namespace nacre::sparkle {
namespace {

using testing::kSilver;
using testing::place_factor;
using testing::relative_radiance;
using testing::side_of;
using testing::square_patch;

// The limit of flat flakes, to the bit.
TEST(FlakeField, WithoutWavinessIsFlat) {
    FlakePopulation flat = kSilver, sized = kSilver;
    sized.waviness = 0;
    sized.sizes = paint::FlakeSizes(kSilver.diameter_um, kSilver.diameter_spread_um);
    const FlakeField a(flat, 3), b(sized, 3);
    for (int i = 0; i < 100; ++i) {
        EXPECT_EQ(relative_radiance(a, square_patch(0.1 * i, 0, 0.05), {0.02f, 0}, 0.9f),
                  relative_radiance(b, square_patch(0.1 * i, 0, 0.05), {0.02f, 0}, 0.9f));
    }
}

TEST(FlakeField, FootprintsAddUp) {
    const FlakeField field(kSilver, 1);
    const double side = side_of(1, kSilver);
    Rng rng(4);
    int different = 0;
    for (int i = 0; i < 300; ++i) {
        const double x = 50 * rng.uniform_double(), y = 50 * rng.uniform_double();
        // Wide lobes, so that most patches hold a flake that reflects.
        const Vec2f slope = {0.02f, 0};
        const double whole = relative_radiance(field, square_patch(x, y, side), slope, 0.1f);
        double parts = 0;
        for (double dx : {-0.25, 0.25}) {
            for (double dy : {-0.25, 0.25}) {
                parts +=
                    relative_radiance(field, square_patch(x + dx * side, y + dy * side, side / 2),
                                      slope, 0.1f) /
                    4;
            }
        }
        // A float resolves 1e-7 of 50 mm, discs are 0.02 mm.
        EXPECT_NEAR(whole, parts, 2e-3 * (1 + whole));
        different += whole > 0.01;
    }
    EXPECT_GT(different, 30);
}

TEST(FlakeField, ResolvesEveryFlakeUpToItsExactSide) {
    const auto view = std::make_unique<FlakeView>();
    for (double density : {10.0, 4000.0, 9000.0}) {
        FlakePopulation population = kSilver;
        population.density_per_mm2 = density;
        const FlakeField field(population, 1);
        const double side = field.exact_side_mm();
        ASSERT_GT(side, 0) << density;
        field.query(square_patch(5, 7, side), *view);
        EXPECT_EQ(view->widening, 1) << density;
        EXPECT_EQ(view->background, 0) << density;
        field.query(square_patch(5, 7, 4 * side), *view);
        EXPECT_GT(view->widening, 1) << density;
    }
    // 60 flakes over every point.
    FlakePopulation overlapping = kSilver;
    overlapping.density_per_mm2 = 2e5;
    EXPECT_EQ(FlakeField(overlapping, 1).exact_side_mm(), 0);
}

TEST(FlakeField, ChangesWithoutJumpsFromACloseUpToADistantView) {
    const FlakeField field(kSilver, 1);
    const auto view = std::make_unique<FlakeView>();
    // By how much all weights change together where the patch grows by a hundredth: levels fade
    // over a factor of 2.3 in cells, rims of discs over the patch's own size.
    constexpr double kStep = 1.01, kMaxChange = 0.15;
    std::map<std::uint64_t, double> before;
    double background = 1, worst = 0;
    int levels_faded = 0;
    for (double side = 1e-3; side < 20; side *= kStep) {
        field.query(square_patch(3.3, 4.4, side), *view);
        std::map<std::uint64_t, double> now;
        for (int k = 0; k < view->count; ++k) {
            now[std::uint64_t{view->place[k]} << 32 | view->kind[k]] = view->weight[k];
        }
        double change = std::abs(view->background - background);
        for (const auto& [flake, weight] : now) change += std::abs(weight - before[flake]);
        for (const auto& [flake, weight] : before) {
            if (!now.contains(flake)) change += weight;
        }
        if (side > 1e-3) worst = test::worse(worst, change);
        levels_faded += view->background > 0 && view->background < 0.999;
        before = now;
        background = view->background;
    }
    EXPECT_LT(worst, kMaxChange);
    EXPECT_GT(levels_faded, 100);
}

TEST(FlakeField, FlakesDoNotDependOnTheTangent) {
    const FlakeField field(kSilver, 1);
    const auto view = std::make_unique<FlakeView>(), turned = std::make_unique<FlakeView>();
    ObjectSpaceFootprint patch = square_patch(7, 5, 0.02);
    patch.normal = normalize(Vec3f{0.3f, 0.2f, 0.9f});
    patch.tangent = normalize(cross({0, 1, 0}, patch.normal));
    const Vec3f bitangent = cross(patch.normal, patch.tangent);
    patch.edge_mm[0] = 0.02f * patch.tangent;
    patch.edge_mm[1] = 0.02f * bitangent;
    field.query(patch, *view);
    ObjectSpaceFootprint other = patch;
    const float c = std::cos(1.0f), s = std::sin(1.0f);
    other.tangent = c * patch.tangent + s * bitangent;
    field.query(other, *turned);
    ASSERT_EQ(view->count, turned->count);
    ASSERT_GT(view->count, 0);
    for (int k = 0; k < view->count; ++k) {
        EXPECT_EQ(view->place[k], turned->place[k]);
        EXPECT_EQ(view->kind[k], turned->kind[k]);
        EXPECT_NEAR(view->weight[k], turned->weight[k], 1e-5);
        EXPECT_NEAR(turned->slope_x[k], c * view->slope_x[k] + s * view->slope_y[k], 1e-6);
        EXPECT_NEAR(turned->slope_y[k], -s * view->slope_x[k] + c * view->slope_y[k], 1e-6);
    }
}

TEST(FlakeField, DensityDoesNotDependOnTheOrientationOfTheSurface) {
    const FlakeField field(kSilver, 1);
    const auto view = std::make_unique<FlakeView>();
    Rng rng(8);
    // Facing one side, two sides about equally, three, and on the way between.
    for (const Vec3f direction : {Vec3f{0, 0, 1}, Vec3f{0, -1, 0}, Vec3f{1, 0, 0.97f},
                                  Vec3f{-1, 1, 1}, Vec3f{0.3f, 0.6f, 0.7f}, Vec3f{1, 0.8f, 0}}) {
        const Vec3f n = normalize(direction);
        const Frame frame = Frame::around(n);
        double sum = 0, squares = 0;
        // The variance has a standard error of 0.5 %.
        constexpr int kPatches = 150000;
        for (int i = 0; i < kPatches; ++i) {
            ObjectSpaceFootprint patch;
            patch.normal = n;
            patch.tangent = frame.s;
            patch.position_mm =
                (60 * rng.uniform_float()) * frame.s + (60 * rng.uniform_float()) * frame.t;
            patch.edge_mm[0] = 0.015f * frame.s;
            patch.edge_mm[1] = 0.015f * frame.t;
            field.query(patch, *view);
            const double x = view->background + view->weight_sum;
            sum += x / kPatches;
            squares += x * x / kPatches;
        }
        const double variance = squares - sum * sum;
        EXPECT_NEAR(sum, 1, 4 * std::sqrt(variance / kPatches)) << n.x << ' ' << n.y;
        // Poisson: place_factor / (density area^2) with patches whose flakes are all resolved.
        const double area = std::numbers::pi * 1e-4;
        EXPECT_NEAR(variance, place_factor(0.015, 0.02) / (4000 * area * area), 0.02 * variance)
            << n.x << ' ' << n.y;
    }
}

TEST(FlakeField, SamplesSlopesWithTheDensityItStates) {
    const FlakeField field(kSilver, 1);
    const auto view = std::make_unique<FlakeView>();
    field.query(square_patch(1, 2, 0.04), *view);
    ASSERT_GT(view->count, 2);
    const Vec3f wi = normalize(Vec3f{0.3f, -0.2f, 0.8f});
    // Pearson's statistic over the cells of a grid.
    constexpr int kSide = 40, kSamples = 400000;
    constexpr float kReach = 0.4f;
    std::vector<double> count(kSide * kSide), expected(kSide * kSide);
    Rng rng(6);
    for (int i = 0; i < kSamples; ++i) {
        const Vec2f p = view->sample_slope(field.lobe(), wi, rng.uniform_float(),
                                           {rng.uniform_float(), rng.uniform_float()});
        const int x = static_cast<int>((p.x / kReach + 1) * kSide / 2);
        const int y = static_cast<int>((p.y / kReach + 1) * kSide / 2);
        ASSERT_TRUE(x >= 0 && x < kSide && y >= 0 && y < kSide);
        ++count[y * kSide + x];
    }
    constexpr int kFine = 40;
    for (int y = 0; y < kSide * kFine; ++y) {
        for (int x = 0; x < kSide * kFine; ++x) {
            const auto at = [&](int i) { return kReach * ((i + 0.5f) * 2 / (kSide * kFine) - 1); };
            expected[y / kFine * kSide + x / kFine] +=
                view->slope_pdf(field.lobe(), wi, {at(x), at(y)}) * kSamples *
                std::pow(2 * kReach / (kSide * kFine), 2);
        }
    }
    double chi_square = 0, total = 0;
    int cells = 0;
    for (int i = 0; i < kSide * kSide; ++i) {
        total += expected[i];
        if (expected[i] < 20) continue;
        chi_square += (count[i] - expected[i]) * (count[i] - expected[i]) / expected[i];
        ++cells;
    }
    EXPECT_NEAR(total, kSamples, 1e-5 * kSamples);  // found: 2e-7
    ASSERT_GT(cells, 10);
    EXPECT_LT(chi_square, cells + 4 * std::sqrt(2.0 * cells));
}

TEST(FlakeField, RefusesWhatIsOutOfRange) {
    FlakePopulation population = kSilver;
    population.density_per_mm2 = 0;
    EXPECT_THROW(FlakeField(population, 0), DomainError);
    population = kSilver;
    population.alpha = 2;
    EXPECT_THROW(FlakeField(population, 0), DomainError);
}

TEST(FlakeField, StaysFiniteOnDegeneratePatches) {
    const FlakeField field(kSilver, 1);
    const auto view = std::make_unique<FlakeView>();
    for (float size : {0.0f, 1e-20f, 1e-6f, 1.0f, 1e6f, 1e20f}) {
        for (float thin : {0.0f, 1e-9f, 1.0f}) {
            ObjectSpaceFootprint patch = square_patch(1e5, -1e5, 0);
            patch.edge_mm[0] = {size, 0, 0};
            patch.edge_mm[1] = {size * 0.5f, size * thin, 0};
            field.query(patch, *view);
            EXPECT_TRUE(std::isfinite(view->weight_sum)) << size << ' ' << thin;
            EXPECT_GE(view->background, 0);
        }
    }
}

}  // namespace
}  // namespace nacre::sparkle
