#include "apps/study/flakes_close_up.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "nacre/core/error.h"
#include "nacre/core/random.h"
#include "nacre/testing/statistics.h"

namespace nacre::study {
namespace {

/// Grey pixels of mean 1: exponential "flakes" of a given contrast in 2 x 2 pixels each, and noise
/// of its own.
struct Scene {
    std::vector<double> truth;
    int side;

    Scene(int pixels, double contrast, std::uint64_t seed) : truth(pixels * pixels), side(pixels) {
        Rng rng(seed);
        std::vector<double> flakes(pixels * pixels);
        for (double& f : flakes) f = 1 + contrast * (-std::log(1 - rng.uniform_double()) - 1);
        for (int y = 0; y < pixels; ++y)
            for (int x = 0; x < pixels; ++x) truth[y * pixels + x] = flakes[y / 2 * pixels + x / 2];
    }
    Pixels picture(double noise, std::uint64_t seed) const {
        Rng rng(seed, 1);
        Pixels p{side, side, {}};
        for (double y : truth) {
            const double value = y + noise * std::sqrt(12) * (rng.uniform_double() - 0.5);
            for (int c = 0; c < 3; ++c) p.rgb.push_back(static_cast<float>(value));
        }
        return p;
    }
};

TEST(FlakesStatistics, NoiseDoesNotRaiseContrast) {
    const Scene scene(128, 0.5, 1);
    const auto quiet = contrast(scene.picture(0, 2), scene.picture(0, 3));
    const auto noisy = contrast(scene.picture(0.8, 2), scene.picture(0.8, 3));
    EXPECT_NEAR(quiet.value, 0.5, 4 * quiet.standard_error);
    EXPECT_NEAR(noisy.value, quiet.value, 4 * noisy.standard_error);
    EXPECT_LT(noisy.standard_error, 0.02);
    EXPECT_GT(contrast(scene.picture(0.8, 2), scene.picture(0.8, 2)).value, 0.9) << "its own noise";
}

TEST(FlakesStatistics, JackknifeAllowsForNeighboursThatShareFlakes) {
    // The variance of the means of many pictures against the one that each states.
    test::Sample means, claimed;
    constexpr int kPictures = 4000;
    for (int i = 0; i < kPictures; ++i) {
        const Pixels p = Scene(32, 0.5, 100 + i).picture(0, 0);
        const Estimate m = mean_luminance(p, p);
        means.add(m.value);
        claimed.add(m.standard_error * m.standard_error);
    }
    const double actual = kPictures * std::pow(means.error(), 2), expected = 0.25 / 256;
    // The means are nearly normal: N of them know their variance to sqrt(2 / N), 2 %.
    const double relative_error = std::sqrt(2.0 / kPictures);
    EXPECT_NEAR(actual / expected, 1, test::kWorstZ * relative_error) << "of 256 flakes";
    EXPECT_NEAR(claimed.mean() / expected, 1, test::kWorstZ * claimed.error() / expected);
}

TEST(FlakesStatistics, HistogramHoldsEveryPixel) {
    Pixels p = Scene(32, 0.9, 5).picture(0, 0);
    p.rgb[0] = p.rgb[1] = p.rgb[2] = 0;  // black
    const Histogram h = histogram(p);
    ASSERT_EQ(h.fraction.size(), h.centre.size());
    EXPECT_NEAR(std::accumulate(h.fraction.begin(), h.fraction.end(), 0.0), 1, 1e-9);
    EXPECT_GE(h.fraction.front(), 1 / 1024.0);
    Pixels flat{8, 8, std::vector<float>(192, 0.25f)};
    const Histogram one = histogram(flat);
    const auto largest = std::max_element(one.fraction.begin(), one.fraction.end());
    EXPECT_NEAR(*largest, 1, 1e-9);
    EXPECT_NEAR(std::log2(one.centre[largest - one.fraction.begin()]), 0, 1 / 3.0);
}

TEST(FlakesStatistics, ColourSpreadIsThatOfThePixels) {
    Pixels grey{8, 8, std::vector<float>(192, 0.6f)};
    const ColourSpread none = colour_spread(grey, 0.6);
    EXPECT_NEAR(none.mean_lab[0], 61.65, 0.01) << "L* of Y = 0.3";
    EXPECT_NEAR(none.mean_lab[1], 0, 1e-3);
    EXPECT_NEAR(none.a_deviation + none.b_deviation, 0, 1e-3);
    for (int p = 0; p < 64; p += 2) grey.rgb[3 * p] = 0.9f;
    const ColourSpread red = colour_spread(grey, 0.6);
    EXPECT_GT(red.a_deviation, 5);
    ASSERT_EQ(red.ab.size(), 64u);
    EXPECT_NEAR(red.a_deviation, std::abs(red.ab[0][0] - red.ab[1][0]) / 2, 1e-9);
}

TEST(FlakesStatistics, RefusesPicturesThatCannotBeCompared) {
    const Pixels a{8, 8, std::vector<float>(192, 1)}, b{4, 8, std::vector<float>(96, 1)},
        tiny{2, 2, std::vector<float>(12, 1)};
    EXPECT_THROW(contrast(a, b), DomainError);
    EXPECT_THROW(contrast(tiny, tiny), DomainError);
    EXPECT_EQ(
        contrast(Pixels{8, 8, std::vector<float>(192, 0)}, Pixels{8, 8, std::vector<float>(192, 0)})
            .value,
        0)
        << "an unlit picture";
}

}  // namespace
}  // namespace nacre::study
