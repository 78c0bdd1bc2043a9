#include "nacre/spectra/rgb.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nacre::spectra {
namespace {

// colour-science 0.4.7: normalised_primary_matrix([[.64, .33], [.3, .6], [.15, .06]],
// [.3127, .3290]), printed with eight decimals.
TEST(Rec709, MatrixMatchesColourScience) {
    const double matrix[3][3] = {{0.4123908, 0.35758434, 0.18048079},
                                 {0.21263901, 0.71516868, 0.07219232},
                                 {0.01933082, 0.11919478, 0.95053215}};
    for (int j = 0; j < 3; ++j) {
        Vec3 primary{};
        primary[j] = 1;
        const Vec3 xyz = linear_rec709_to_xyz(primary);
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(xyz[i], matrix[i][j], 5e-9) << i << j;
    }
}

TEST(Rec709, EqualAmountsMakeTheWhiteOfTheStandardAndPrimariesKeepTheirChromaticity) {
    const Vec3 white = linear_rec709_to_xyz({1, 1, 1});
    EXPECT_NEAR(white[1], 1, 1e-15);
    EXPECT_NEAR(white[0] / (white[0] + white[1] + white[2]), kRec709White[0], 1e-15);
    EXPECT_NEAR(white[1] / (white[0] + white[1] + white[2]), kRec709White[1], 1e-15);
    for (int j = 0; j < 3; ++j) {
        Vec3 rgb{};
        rgb[j] = 0.7;
        const Vec3 xyz = linear_rec709_to_xyz(rgb);
        EXPECT_NEAR(xyz[0] / (xyz[0] + xyz[1] + xyz[2]), kRec709Primaries[j][0], 1e-15);
        EXPECT_NEAR(xyz[1] / (xyz[0] + xyz[1] + xyz[2]), kRec709Primaries[j][1], 1e-15);
    }
}

TEST(Rec709, ThereAndBackIsTheIdentityOutsideTheGamutToo) {
    for (double r : {-0.5, 0.0, 0.3, 1.0, 20.0}) {
        for (double g : {-0.1, 0.5, 1.0}) {
            for (double b : {0.0, 0.25, 3.0}) {
                const Vec3 rgb = {r, g, b};
                const Vec3 back = xyz_to_linear_rec709(linear_rec709_to_xyz(rgb));
                for (int c = 0; c < 3; ++c) EXPECT_NEAR(back[c], rgb[c], 1e-13);
            }
        }
    }
}

TEST(Srgb, KnownValues) {
    EXPECT_EQ(srgb_encode(0), 0);
    EXPECT_NEAR(srgb_encode(1), 1, 1e-15);
    EXPECT_NEAR(srgb_decode(1), 1, 1e-15);
    EXPECT_DOUBLE_EQ(srgb_encode(0.002), 0.02584);
    EXPECT_DOUBLE_EQ(srgb_decode(0.02584), 0.002);
    // By hand: 1.055 * 0.5^(1 / 2.4) - 0.055 and ((0.5 + 0.055) / 1.055)^2.4.
    EXPECT_NEAR(srgb_encode(0.5), 0.735356983052, 1e-12);
    EXPECT_NEAR(srgb_decode(0.5), 0.214041140482, 1e-12);
}

TEST(Srgb, EncodingIsOddIncreasingAndUndoneByDecoding) {
    double last = -1.1;
    for (int i = -1000; i <= 1000; ++i) {
        const double x = i / 1000.0;
        EXPECT_GT(srgb_encode(x), last);
        last = srgb_encode(x);
        EXPECT_EQ(srgb_encode(-x), -srgb_encode(x));
        EXPECT_EQ(srgb_decode(-x), -srgb_decode(x));
        // Near the joint a value may come back through the other branch, 3e-8 away.
        EXPECT_NEAR(srgb_decode(srgb_encode(x)), x, 3e-8);
    }
}

}  // namespace
}  // namespace nacre::spectra
