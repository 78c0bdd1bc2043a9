#include "nacre/render/direction_distribution.h"

#include <gtest/gtest.h>

#include <cmath>

#include "nacre/render/environment.h"
#include "nacre/render/sampler.h"
#include "nacre/testing/statistics.h"

namespace nacre::render {
namespace {

/// A dim sky, a bright spot near a pole and one on the seam of the azimuth, and a black part.
float brightness(Vec3f d) {
    if (d.z < -0.6f) return 0;
    const Vec3f pole = normalize(Vec3f{0.1f, 0.05f, 1});
    const Vec3f seam{1, 0, 0};
    return 0.2f + 30 * std::exp(40 * (dot(d, pole) - 1)) + 10 * std::exp(60 * (dot(d, seam) - 1));
}

DirectionDistribution table() { return DirectionDistribution(64, 32, brightness); }

/// Evenly spread directions with z and azimuth as coordinates, which the table does not use.
Vec3f spherical(double u, double v) {
    const double z = 1 - 2 * v, r = std::sqrt(1 - z * z), a = 2 * M_PI * u;
    return {static_cast<float>(r * std::cos(a)), static_cast<float>(r * std::sin(a)),
            static_cast<float>(z)};
}

TEST(DirectionDistribution, SquareAndSphereMapBackAndForth) {
    for (int i = 0; i < 1000; ++i) {
        const auto u = PathSampler(0, 0, i).draw(0);
        const Vec3f d = DirectionDistribution::from_square(Vec2f{u[0], u[1]});
        EXPECT_NEAR(length(d), 1, 1e-6);
        const Vec2f back = DirectionDistribution::to_square(d);
        EXPECT_NEAR(back.y, u[1], 1e-6);
        // Near the poles the azimuth loses digits in proportion.
        EXPECT_NEAR(back.x, u[0], 1e-6 / std::max(1e-2f, std::hypot(d.x, d.y)));
    }
}

// Midpoints of a 2000 x 2000 grid. The density jumps at the 64 + 32 edges of cells, each of which
// the grid places to half a step: a few parts in 1000 where a bright cell has such an edge.
TEST(DirectionDistribution, PdfIntegratesToOne) {
    const DirectionDistribution t = table();
    constexpr int kSide = 2000;
    double sum = 0;
    for (int i = 0; i < kSide * kSide; ++i) {
        sum += t.pdf(spherical((i % kSide + 0.5) / kSide, (i / kSide + 0.5) / kSide));
    }
    EXPECT_NEAR(sum * 4 * M_PI / (kSide * kSide), 1, 5e-3);
}

TEST(DirectionDistribution, EightSamplesAreThoseOfEach) {
    const DirectionDistribution t = table();
    for (std::uint32_t i = 0; i < 1000; ++i) {
        const PathSampler::Threes u = PathSampler(0, 2, i).draw_refined(0);
        const DirectionSample<FloatLanes> eight = t.sample({u.x, u.y});
        for (int k = 0; k < kLanes; ++k) {
            const DirectionSample<float> one = t.sample({u.x[k], u.y[k]});
            EXPECT_LT(length(lane(eight.direction, k) - one.direction), 1e-6f);
            EXPECT_NEAR(eight.pdf[k], one.pdf, 1e-5f * one.pdf);
        }
    }
}

TEST(DirectionDistribution, SampleReportsThePdfOfItsDirection) {
    const DirectionDistribution t = table();
    int inside = 0;
    constexpr int kCount = 10000;
    for (int i = 0; i < kCount; ++i) {
        const auto u = PathSampler(0, 3, i).draw(0);
        const DirectionSample<float> s = t.sample({u[0], u[1]});
        EXPECT_GT(s.pdf, 0);
        // On an edge between cells rounding may look up the neighbour.
        inside += std::abs(t.pdf(s.direction) - s.pdf) < 1e-3f * s.pdf;
    }
    EXPECT_GT(inside, 0.995 * kCount);
}

// Pearson's chi-square over 16 x 8 cells of azimuth and height with 2^16 independent samples: the
// statistic has mean k - 1 and variance 2 (k - 1); 5 standard deviations, with a fixed seed.
TEST(DirectionDistribution, SamplesFollowThePdf) {
    const DirectionDistribution t = table();
    constexpr int kColumns = 16, kRows = 8, kSub = 40, kCount = 1 << 16;
    std::vector<double> expected(kColumns * kRows), seen(kColumns * kRows);
    for (int i = 0; i < kColumns * kSub * kRows * kSub; ++i) {
        const int x = i % (kColumns * kSub), y = i / (kColumns * kSub);
        expected[y / kSub * kColumns + x / kSub] +=
            t.pdf(spherical((x + 0.5) / (kColumns * kSub), (y + 0.5) / (kRows * kSub))) * 4 * M_PI *
            kCount / (kColumns * kSub * kRows * kSub);
    }
    for (int i = 0; i < kCount; ++i) {
        // Of a fresh pixel each: independent, not low-discrepancy, as the statistic assumes.
        const auto u = PathSampler(1, i, 0).draw(0);
        const Vec3f d = t.sample({u[0], u[1]}).direction;
        double azimuth = std::atan2(d.y, d.x) / (2 * M_PI);
        if (azimuth < 0) azimuth += 1;
        const int x = std::min(static_cast<int>(azimuth * kColumns), kColumns - 1);
        const int y = std::min(static_cast<int>((1 - d.z) / 2 * kRows), kRows - 1);
        seen[y * kColumns + x] += 1;
    }
    double statistic = 0;
    int cells = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        if (expected[i] < 5) {
            // The black part: no more than the seam of a cell may leak into it.
            EXPECT_LT(seen[i], 20);
            continue;
        }
        statistic += (seen[i] - expected[i]) * (seen[i] - expected[i]) / expected[i];
        ++cells;
    }
    ASSERT_GT(cells, 90);
    EXPECT_LT(statistic, cells - 1 + 5 * std::sqrt(2.0 * (cells - 1)));
}

// A hard-edged lamp in the dark, moved in steps over a cell (360 / 64 deg by 1 / 16 in height): wherever
// it shines there is density, if only that of its corner that is next to one of a cell's 25 points.
TEST(DirectionDistribution, FindsTheRimOfAHardLamp) {
    for (int step = 0; step < 20; ++step) {
        const float shift = 0.0025f * static_cast<float>(step);
        const auto lamp = [shift](Vec3f d) {
            return d.x > 0 && std::abs(d.y - 0.3f - shift) < 0.14f && std::abs(d.z - shift) < 0.09f
                       ? 1.0f
                       : 0.0f;
        };
        const DirectionDistribution t(64, 32, lamp);
        float worst = 0, sum = 0;
        constexpr int kSide = 400;
        for (int i = 0; i < kSide * kSide; ++i) {
            const float y = 0.3f + shift + 0.28f * ((i % kSide + 0.5f) / kSide - 0.5f),
                        z = shift + 0.18f * ((i / kSide + 0.5f) / kSide - 0.5f);
            const float x = std::sqrt(1 - y * y - z * z);
            const float pdf = t.pdf(Vec3f{x, y, z});
            ASSERT_GT(pdf, 0) << step;
            const float weight = 1 / pdf;  // per solid angle of dy dz / x
            worst = test::worse(worst, weight);
            sum += 1 / x;
        }
        const float lamp_sr = sum * 0.28f * 0.18f / (kSide * kSide);
        EXPECT_LT(worst, 25 * 1.6f * lamp_sr) << step;
    }
}

TEST(DirectionDistribution, BlackEnvironmentIsSampledUniformly) {
    const DirectionDistribution t(8, 4, [](Vec3f) { return 0.0f; });
    EXPECT_EQ(t.mean_brightness(), 0);
    const DirectionSample<float> s = t.sample({0.3f, 0.7f});
    EXPECT_GT(s.pdf, 0);
    EXPECT_NEAR(length(s.direction), 1, 1e-6);
}

// The density is not: it goes with the map to the square, by a factor of two within a cell.
TEST(DirectionDistribution, AnEvenSkyIsEven) {
    const DirectionDistribution t(1, 1, [](Vec3f) { return 3.0f; });
    for (std::uint32_t i = 0; i < 100; ++i) {
        const auto u = PathSampler(0, 4, i).draw(0);
        const DirectionSample<float> s = t.sample({u[0], u[1]});
        EXPECT_FLOAT_EQ(s.brightness, 3);
        EXPECT_FLOAT_EQ(t.brightness(s.direction), 3);
    }
}

TEST(DirectionDistribution, MeanBrightnessIsTheMeanOverTheSphere) {
    const DirectionDistribution t(64, 64, [](Vec3f d) { return d.z * d.z; });
    EXPECT_NEAR(t.mean_brightness(), 1.0 / 3, 1e-3);
}

}  // namespace
}  // namespace nacre::render
