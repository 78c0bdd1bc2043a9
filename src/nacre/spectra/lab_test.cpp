#include "nacre/spectra/lab.h"

#include <gtest/gtest.h>

#include <cmath>

#include "nacre/core/error.h"

namespace nacre::spectra {
namespace {

constexpr Vec3 kWhite = {95.046506, 100, 108.897024};

TEST(Lab, WhiteBlackAndGreys) {
    const Vec3 white = xyz_to_lab(kWhite, kWhite);
    EXPECT_NEAR(white[0], 100, 1e-12);
    EXPECT_NEAR(white[1], 0, 1e-12);
    EXPECT_NEAR(white[2], 0, 1e-12);
    const Vec3 black = xyz_to_lab({0, 0, 0}, kWhite);
    for (double x : black) EXPECT_NEAR(x, 0, 1e-12);
    const Vec3 grey = xyz_to_lab({0.125 * kWhite[0], 12.5, 0.125 * kWhite[2]}, kWhite);
    EXPECT_NEAR(grey[0], 116 * 0.5 - 16, 1e-12);
    EXPECT_NEAR(grey[1], 0, 1e-12);
}

// colour-science 0.4.7: XYZ_to_Lab(XYZ, CCS_ILLUMINANTS["CIE 1931 2 Degree Standard Observer"]
// ["D65"]): the white with x = 0.3127, y = 0.3290.
TEST(Lab, MatchesColourScience) {
    const Vec3 white = {0.3127 / 0.3290, 1, (1 - 0.3127 - 0.3290) / 0.3290};
    const Vec3 light = xyz_to_lab({0.2, 0.3, 0.4}, white);
    EXPECT_NEAR(light[0], 61.65422221, 1e-8);
    EXPECT_NEAR(light[1], -37.31986865, 1e-8);
    EXPECT_NEAR(light[2], -9.34309034, 1e-8);
    const Vec3 dark = xyz_to_lab({0.002, 0.003, 0.001}, white);  // the linear part
    EXPECT_NEAR(dark[0], 2.70988889, 1e-8);
    EXPECT_NEAR(dark[1], -3.48760645, 1e-8);
    EXPECT_NEAR(dark[2], 3.24217188, 1e-8);
}

TEST(Lab, ThereAndBackIsTheIdentity) {
    int cases = 0;
    for (double x : {-1.0, 0.0, 0.5, 0.8856, 3.0, 50.0, 150.0}) {
        for (double y : {0.0, 0.1, 0.8857, 20.0, 100.0}) {
            for (double z : {-0.5, 0.0, 1.0, 109.0}) {
                const Vec3 xyz = {x, y, z};
                const Vec3 back = lab_to_xyz(xyz_to_lab(xyz, kWhite), kWhite);
                for (int c = 0; c < 3; ++c) EXPECT_NEAR(back[c], xyz[c], 1e-12 * 150);
                ++cases;
            }
        }
    }
    EXPECT_EQ(cases, 140);
}

TEST(Lab, IsContinuousWhereItsBranchesMeet) {
    const double t = std::pow(6.0 / 29, 3);
    const double below = xyz_to_lab({0, t * (1 - 1e-12), 0}, {1, 1, 1})[0];
    const double above = xyz_to_lab({0, t * (1 + 1e-12), 0}, {1, 1, 1})[0];
    EXPECT_NEAR(below, 8, 1e-9);
    EXPECT_NEAR(above, 8, 1e-9);
}

TEST(Lab, RefusesAWhiteThatIsNone) {
    EXPECT_THROW(xyz_to_lab({1, 1, 1}, {1, 0, 1}), DomainError);
    EXPECT_THROW(lab_to_xyz({1, 1, 1}, {1, -1, 1}), DomainError);
    EXPECT_THROW(lab_to_xyz({1, 1, 1}, {std::nan(""), 1, 1}), DomainError);
}

}  // namespace
}  // namespace nacre::spectra
