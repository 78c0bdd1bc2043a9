#include "nacre/io/image_difference.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "nacre/core/error.h"
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

}  // namespace
}  // namespace nacre::io
