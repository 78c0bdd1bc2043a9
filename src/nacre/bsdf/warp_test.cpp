#include "nacre/bsdf/warp.h"

#include <gtest/gtest.h>

#include <cmath>

#include "nacre/core/error.h"
#include "nacre/core/random.h"

namespace nacre::bsdf {
namespace {

SquareWarp random_warp(int slices, int rows, int columns, float zeros = 0) {
    Rng rng(2, 9);
    std::vector<float> values;
    for (int i = 0; i < slices * rows * columns; ++i) {
        const float v = rng.uniform_float();
        values.push_back(v < zeros ? 0 : v * v * v);
    }
    return SquareWarp(values, slices, rows, columns);
}

TEST(SquareWarp, SampleAndInvertUndoEachOther) {
    const SquareWarp warp = random_warp(6, 7, 9);
    const SliceGrid grid({0, 1, 3}, {-1, 1});
    Rng rng(1, 1);
    for (int i = 0; i < 2000; ++i) {
        const SliceMix mix =
            grid.locate(4 * rng.uniform_float() - 0.5f, 3 * rng.uniform_float() - 1.5f);
        const Vec2f u = {rng.uniform_float(), rng.uniform_float()};
        const SquareWarp::Point point = warp.sample(mix, u);
        const SquareWarp::Point back = warp.invert(mix, point.at);
        // Rounding of the distribution functions over the slope there, which is as small as 1e-3.
        ASSERT_NEAR(back.at.x, u.x, 1e-5);
        ASSERT_NEAR(back.at.y, u.y, 1e-5);
        ASSERT_NEAR(back.density, point.density, 2e-3 * point.density + 1e-4);
        ASSERT_NEAR(warp.density(mix, point.at), back.density, 1e-5 * back.density + 1e-6);
    }
}

// Tables are searched eight nodes at a time.
TEST(SquareWarp, TablesOfAnySizeAreSearchedToTheirEnds) {
    Rng rng(7, 1);
    for (const int nodes : {2, 3, 8, 9, 10, 63, 64, 65, 66, 128, 129, 130, 521}) {
        SCOPED_TRACE(nodes);
        const SquareWarp across = random_warp(2, 4, nodes, 0.3f);
        const SquareWarp down = random_warp(2, nodes, 3);
        for (const int slices : {1, 2}) {
            const SliceMix mix{{0, 1}, {slices == 1 ? 1.0f : 0.4f, 0.6f}, slices};
            for (int i = 0; i < 4 * nodes; ++i) {
                const float u = (static_cast<float>(i) + rng.uniform_float()) / (4 * nodes);
                const float v = rng.uniform_float();
                ASSERT_NEAR(across.invert(mix, across.sample(mix, {u, v}).at).at.x, u, 2e-5);
                ASSERT_NEAR(down.invert(mix, down.sample(mix, {v, u}).at).at.y, u, 2e-5);
            }
            for (const SquareWarp* warp : {&across, &down}) {
                const Vec2f first = warp->sample(mix, {0, 0}).at;
                const Vec2f last = warp->sample(mix, {1, 1}).at;
                EXPECT_GE(std::min(first.x, first.y), 0);
                EXPECT_LE(std::max(last.x, last.y), 1);
                EXPECT_LT(first.x, last.x);
                EXPECT_LT(first.y, last.y);
            }
        }
    }
}

// The density is the Jacobian of the inverse: areas of small squares, by finite differences.
TEST(SquareWarp, DensityIsTheJacobianOfTheInverse) {
    const SquareWarp warp = random_warp(2, 5, 4);
    const SliceGrid grid({0}, {0, 1});
    Rng rng(4, 1);
    for (int i = 0; i < 200; ++i) {
        const SliceMix mix = grid.locate(0, rng.uniform_float());
        constexpr float kStep = 0.01f;
        // A small square that stays within a cell, where the density is bilinear.
        const float x =
            (static_cast<int>(3 * rng.uniform_float()) + 0.1f + 0.7f * rng.uniform_float()) / 3;
        const float y =
            (static_cast<int>(4 * rng.uniform_float()) + 0.1f + 0.7f * rng.uniform_float()) / 4;
        const auto at = [&](float a, float b) { return warp.invert(mix, {a, b}).at; };
        const Vec2f p = at(x, y), q = at(x + kStep, y), r = at(x, y + kStep);
        const double area = static_cast<double>(q.x - p.x) * (r.y - p.y) -
                            static_cast<double>(q.y - p.y) * (r.x - p.x);
        const double density = warp.density(mix, Vec2f{x + kStep / 2, y + kStep / 2});
        // Differences to first order of a density that may change by 4 from node to node.
        EXPECT_NEAR(area / (kStep * kStep), density, 0.06 * density + 0.02);
    }
}

TEST(SquareWarp, EverySliceIntegratesToOne) {
    const SquareWarp warp = random_warp(3, 4, 6, 0.5f);
    const SliceGrid grid({0, 1, 2}, {0});
    for (const float place : {0.0f, 0.7f, 2.0f}) {
        const SliceMix mix = grid.locate(place, 0);
        double sum = 0;
        constexpr int kPoints = 300;  // a multiple of the cells: the midpoint rule is then exact
        for (int i = 0; i < kPoints * kPoints; ++i) {
            sum += warp.density(
                mix, Vec2f{(i % kPoints + 0.5f) / kPoints, (i / kPoints + 0.5f) / kPoints});
        }
        EXPECT_NEAR(sum / (kPoints * kPoints), 1, 1e-4);
    }
}

TEST(SquareWarp, ASliceOfZerosIsUniform) {
    const SquareWarp warp(std::vector<float>(12, 0.0f), 1, 3, 4);
    const SliceMix mix = SliceGrid({0}, {0}).locate(5, 5);
    const SquareWarp::Point point = warp.sample(mix, {0.3f, 0.9f});
    EXPECT_NEAR(point.at.x, 0.3, 1e-6);
    EXPECT_NEAR(point.at.y, 0.9, 1e-6);
    EXPECT_NEAR(point.density, 1, 1e-6);
}

TEST(SquareWarp, EmptyPlacesAreNotDrawnAndBreakNothing) {
    const SquareWarp warp = random_warp(1, 9, 9, 0.9f);
    const SliceMix mix = SliceGrid({0}, {0}).locate(0, 0);
    Rng rng(8, 1);
    for (int i = 0; i < 3000; ++i) {
        const SquareWarp::Point p = warp.sample(mix, {rng.uniform_float(), rng.uniform_float()});
        ASSERT_GT(p.density, 0);
        const SquareWarp::Point q = warp.invert(mix, {rng.uniform_float(), rng.uniform_float()});
        ASSERT_TRUE(std::isfinite(q.at.x) && std::isfinite(q.at.y) && q.density >= 0);
    }
}

TEST(SquareWarp, SlicesAreMixedLinearlyAndHeldBeyondTheEnds) {
    const SliceGrid grid({0, 2}, {10, 20, 40});
    const SliceMix mix = grid.locate(0.5f, 35);
    ASSERT_EQ(mix.count, 4);
    EXPECT_EQ(mix.slice[0], 1);
    EXPECT_FLOAT_EQ(mix.weight[0], 0.75f * 0.25f);
    EXPECT_EQ(mix.slice[3], 5);
    EXPECT_FLOAT_EQ(mix.weight[3], 0.25f * 0.75f);
    const SliceMix beyond = grid.locate(-7, 99);
    ASSERT_EQ(beyond.count, 1);
    EXPECT_EQ(beyond.slice[0], 2);
    EXPECT_EQ(beyond.weight[0], 1);
}

TEST(SquareWarp, RefusesSizesThatDoNotFit) {
    EXPECT_THROW(SquareWarp(std::vector<float>(5), 1, 2, 3), DomainError);
    EXPECT_THROW(SquareWarp(std::vector<float>(3), 1, 1, 3), DomainError);
    EXPECT_THROW(SliceGrid({}, {1}), DomainError);
}

}  // namespace
}  // namespace nacre::bsdf
