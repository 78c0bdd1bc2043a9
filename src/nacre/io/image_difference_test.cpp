#include "nacre/io/image_difference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/core/random.h"
#include "nacre/spectra/colour.h"

namespace nacre::io {
namespace {

Image flat(int width, int height, float r, float g, float b) {
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    return {width,
            height,
            {{"R", std::vector<float>(pixels, r)},
             {"G", std::vector<float>(pixels, g)},
             {"B", std::vector<float>(pixels, b)}},
            {}};
}

TEST(ImageDifference, OfAPictureAndItselfIsZero) {
    const Image image = flat(4, 4, 0.2f, 0.4f, 3.0f);
    const ImageDifference d = image_difference(image, image, "a", "a");
    EXPECT_EQ(d.mean_square_error, 0);
    EXPECT_EQ(d.psnr_db, std::numeric_limits<double>::infinity());
    EXPECT_EQ(d.relative_error, 0);
    EXPECT_EQ(d.delta_e_max, 0);
}

TEST(ImageDifference, FollowsItsDefinitions) {
    // One value of twelve is off by 0.125 where the reference is 0.5.
    Image a = flat(2, 2, 0.5f, 0.5f, 0.5f);
    a.channels[1].pixels[3] = 0.625f;
    const ImageDifference d = image_difference(a, flat(2, 2, 0.5f, 0.5f, 0.5f), "a", "b");
    EXPECT_DOUBLE_EQ(d.mean_square_error, 0.125 * 0.125 / 12);
    EXPECT_DOUBLE_EQ(d.psnr_db, 10 * std::log10(12 / (0.125 * 0.125)));
    EXPECT_DOUBLE_EQ(d.relative_error, 0.125 / 0.51 / 12);
    EXPECT_FLOAT_EQ(d.picture.find("G")->pixels[3], 0.125f);
    EXPECT_EQ(d.picture.find("R")->pixels[3], 0);
    EXPECT_GT(d.delta_e_max, 5);
    EXPECT_NEAR(d.delta_e_mean, d.delta_e_max / 4, 1e-6 * d.delta_e_max);
    EXPECT_EQ(d.delta_e_95th, 0);  // 3 of 4 pixels are equal, and so is the one below 95 %
}

TEST(ImageDifference, TakesThePerfectDiffuserAsWhite) {
    // Grays of L* = 50 and 51: between neutral colours CIEDE2000 is the difference of L* over S_L,
    // and S_L = 1 + 0.015 (L - 50)^2 / sqrt(20 + (L - 50)^2) at their mean, 50.5.
    const auto gray = [](double lightness) {
        const double y = std::pow((lightness + 16) / 116, 3);
        const auto v = static_cast<float>(y);
        return flat(1, 1, v, v, v);
    };
    const ImageDifference d = image_difference(gray(51), gray(50), "a", "b");
    const double weight = 1 + 0.015 * 0.25 / std::sqrt(20.25);
    EXPECT_NEAR(d.delta_e_mean, 1 / weight, 2e-4);  // float pixels: 1e-7 of L* = 50 and more
}

TEST(ImageDifference, RefusesWhatCannotBeCompared) {
    EXPECT_THROW(image_difference(flat(2, 2, 0, 0, 0), flat(2, 3, 0, 0, 0), "a", "b"), InputError);
    Image depth = flat(2, 2, 0, 0, 0);
    depth.channels = {{"Z", std::vector<float>(4)}};
    EXPECT_THROW(image_difference(depth, depth, "a", "b"), InputError);
    EXPECT_THROW(image_difference(flat(1, 1, NAN, 0, 0), flat(1, 1, 0, 0, 0), "a", "b"),
                 InputError);
}

TEST(DifferenceHeatMap, RunsFromBlackOverRedToWhite) {
    const ImageDifference d =
        image_difference(flat(1, 1, 1, 1, 1), flat(1, 1, 0, 0, 0), "a", "b");  // Delta E = 100
    EXPECT_NEAR(d.delta_e_mean, 100, 0.01);
    const auto colour = [&](double full_scale) {
        const Image map = difference_heat_map(d, full_scale);
        return std::array{map.find("R")->pixels[0], map.find("G")->pixels[0],
                          map.find("B")->pixels[0]};
    };
    EXPECT_EQ(colour(100 * 1000)[1], 0);
    EXPECT_EQ(colour(10), (std::array{1.0f, 1.0f, 1.0f}));
    EXPECT_EQ(colour(300)[2], 0);
    EXPECT_NEAR(colour(300)[0], 1, 1e-3);
}

/// A picture whose values are normal about 1 with the standard deviation `error`, which it tells.
Image noisy_picture(double error, std::uint64_t seed, double shift = 0) {
    constexpr int kSide = 64;
    Image image{kSide, kSide, {}, {}};
    Rng rng(seed, 1);
    for (const char* name : {"R", "G", "B"}) {
        Channel channel{name, {}};
        for (int i = 0; i < kSide * kSide; ++i) {
            // By Box and Muller.
            const double u = 1 - rng.uniform_double(), v = rng.uniform_double();
            const double normal = std::sqrt(-2 * std::log(u)) * std::cos(2 * std::numbers::pi * v);
            channel.pixels.push_back(static_cast<float>(1 + shift + error * normal));
        }
        image.channels.push_back(std::move(channel));
    }
    for (int c = 0; c < 3; ++c) {
        image.channels.push_back({standard_error_channel(image.channels[c].name),
                                  std::vector<float>(kSide * kSide, static_cast<float>(error))});
    }
    return image;
}

TEST(ImageZScores, OfTwoPicturesOfTheSameMeanAreStandardNormal) {
    const Image a = noisy_picture(0.01, 1), b = noisy_picture(0.03, 2);
    const auto z = image_z_scores(a, b, "a", "b");
    ASSERT_TRUE(z);
    EXPECT_TRUE(z->has_error_a && z->has_error_b);
    EXPECT_EQ(z->values, 3u * 64 * 64);
    // The mean square of n normal numbers is 1 +- sqrt(2 / n).
    EXPECT_NEAR(z->mean_square, 1, 4 * std::sqrt(2.0 / 12288));
    EXPECT_NEAR(z->fraction_above_3, 0.0027, 4 * std::sqrt(0.0027 / 12288));
    EXPECT_LT(std::abs(z->of_mean), 4);
    EXPECT_EQ(z->unexplained, 0u);
    EXPECT_EQ(z->expected_mean_square, 1);
    EXPECT_NEAR(z->expected_fraction_above_3, 0.0027, 1e-5);
}

TEST(ImageZScores, FindAShiftThatNoPixelShows) {
    // A tenth of the error: the mean over 12288 values finds it with 11 standard errors.
    const auto z = image_z_scores(noisy_picture(0.01, 1, 0.001), noisy_picture(1e-4, 2), "a", "b");
    ASSERT_TRUE(z);
    EXPECT_NEAR(z->of_mean, 0.1 * std::sqrt(12288.0), 4);
    EXPECT_NEAR(z->mean_square, 1.01, 0.06);
}

TEST(ImageZScores, ExpectStudentsLawOfFewBatches) {
    Image a = noisy_picture(0.01, 1);
    a.metadata[kBatchesKey] = "16";
    const auto z = image_z_scores(a, noisy_picture(0.01, 2), "a", "b");
    ASSERT_TRUE(z);
    EXPECT_NEAR(z->expected_mean_square, 15.0 / 13, 1e-12);
    EXPECT_NEAR(z->expected_fraction_above_3, 0.00897, 1e-5);  // two-sided, 15 degrees of freedom
    a.metadata[kBatchesKey] = "1";
    EXPECT_THROW(image_z_scores(a, a, "a", "b"), InputError);
}

TEST(ImageZScores, AreNotThereWithoutErrorsAndCountWhatNoErrorExplains) {
    Image plain = noisy_picture(0.01, 1);
    plain.channels.resize(3);
    EXPECT_FALSE(image_z_scores(plain, plain, "a", "b"));
    Image exact = noisy_picture(0.01, 1);
    for (int c = 3; c < 6; ++c) exact.channels[c].pixels.assign(64 * 64, 0.0f);
    const auto same = image_z_scores(exact, plain, "a", "b");
    ASSERT_TRUE(same);
    EXPECT_EQ(same->values, 0u);
    EXPECT_EQ(same->unexplained, 0u);
    plain.channels[1].pixels[7] += 0.1f;
    EXPECT_EQ(image_z_scores(exact, plain, "a", "b")->unexplained, 1u);
}

}  // namespace
}  // namespace nacre::io
