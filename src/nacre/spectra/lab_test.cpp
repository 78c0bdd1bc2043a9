#include "nacre/spectra/lab.h"

#include <gtest/gtest.h>

#include <cmath>

#include "nacre/core/error.h"
#include "nacre/core/random.h"

namespace nacre::spectra {
namespace {

constexpr Vec3d kWhite = {95.046506, 100, 108.897024};

TEST(Lab, WhiteBlackAndGreys) {
    const Vec3d white = xyz_to_lab(kWhite, kWhite);
    EXPECT_NEAR(white[0], 100, 1e-12);
    EXPECT_NEAR(white[1], 0, 1e-12);
    EXPECT_NEAR(white[2], 0, 1e-12);
    const Vec3d black = xyz_to_lab({0, 0, 0}, kWhite);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(black[c], 0, 1e-12);
    const Vec3d grey = xyz_to_lab({0.125 * kWhite[0], 12.5, 0.125 * kWhite[2]}, kWhite);
    EXPECT_NEAR(grey[0], 116 * 0.5 - 16, 1e-12);
    EXPECT_NEAR(grey[1], 0, 1e-12);
}

// colour-science 0.4.7: XYZ_to_Lab(XYZ, CCS_ILLUMINANTS["CIE 1931 2 Degree Standard Observer"]
// ["D65"]): the white with x = 0.3127, y = 0.3290.
TEST(Lab, MatchesColourScience) {
    const Vec3d white = {0.3127 / 0.3290, 1, (1 - 0.3127 - 0.3290) / 0.3290};
    const Vec3d light = xyz_to_lab({0.2, 0.3, 0.4}, white);
    EXPECT_NEAR(light[0], 61.65422221, 1e-8);
    EXPECT_NEAR(light[1], -37.31986865, 1e-8);
    EXPECT_NEAR(light[2], -9.34309034, 1e-8);
    const Vec3d dark = xyz_to_lab({0.002, 0.003, 0.001}, white);  // the linear part
    EXPECT_NEAR(dark[0], 2.70988889, 1e-8);
    EXPECT_NEAR(dark[1], -3.48760645, 1e-8);
    EXPECT_NEAR(dark[2], 3.24217188, 1e-8);
}

TEST(Lab, ThereAndBackIsTheIdentity) {
    int cases = 0;
    for (double x : {-1.0, 0.0, 0.5, 0.8856, 3.0, 50.0, 150.0}) {
        for (double y : {0.0, 0.1, 0.8857, 20.0, 100.0}) {
            for (double z : {-0.5, 0.0, 1.0, 109.0}) {
                const Vec3d xyz = {x, y, z};
                const Vec3d back = lab_to_xyz(xyz_to_lab(xyz, kWhite), kWhite);
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

TEST(Lab, RefusesAWhiteThatIsNotPositive) {
    EXPECT_THROW(xyz_to_lab({1, 1, 1}, {1, 0, 1}), DomainError);
    EXPECT_THROW(lab_to_xyz({1, 1, 1}, {1, -1, 1}), DomainError);
    EXPECT_THROW(lab_to_xyz({1, 1, 1}, {std::nan(""), 1, 1}), DomainError);
}

// The 34 pairs of [sharma-2005, table 1], rounded there to four decimals. They visit every branch:
// hues on both sides of the wrap, greys, and the discontinuity of the mean hue.
TEST(DeltaE2000, MatchesThePublishedPairs) {
    constexpr double kRounding = 0.5e-4;
    const struct {
        Vec3d lab1, lab2;
        double difference;
    } pairs[] = {
        {{50.0000, 2.6772, -79.7751}, {50.0000, 0.0000, -82.7485}, 2.0425},
        {{50.0000, 3.1571, -77.2803}, {50.0000, 0.0000, -82.7485}, 2.8615},
        {{50.0000, 2.8361, -74.0200}, {50.0000, 0.0000, -82.7485}, 3.4412},
        {{50.0000, -1.3802, -84.2814}, {50.0000, 0.0000, -82.7485}, 1.0000},
        {{50.0000, -1.1848, -84.8006}, {50.0000, 0.0000, -82.7485}, 1.0000},
        {{50.0000, -0.9009, -85.5211}, {50.0000, 0.0000, -82.7485}, 1.0000},
        {{50.0000, 0.0000, 0.0000}, {50.0000, -1.0000, 2.0000}, 2.3669},
        {{50.0000, -1.0000, 2.0000}, {50.0000, 0.0000, 0.0000}, 2.3669},
        {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0009}, 7.1792},
        {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0010}, 7.1792},
        {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0011}, 7.2195},
        {{50.0000, 2.4900, -0.0010}, {50.0000, -2.4900, 0.0012}, 7.2195},
        {{50.0000, -0.0010, 2.4900}, {50.0000, 0.0009, -2.4900}, 4.8045},
        {{50.0000, -0.0010, 2.4900}, {50.0000, 0.0010, -2.4900}, 4.8045},
        {{50.0000, -0.0010, 2.4900}, {50.0000, 0.0011, -2.4900}, 4.7461},
        {{50.0000, 2.5000, 0.0000}, {50.0000, 0.0000, -2.5000}, 4.3065},
        {{50.0000, 2.5000, 0.0000}, {73.0000, 25.0000, -18.0000}, 27.1492},
        {{50.0000, 2.5000, 0.0000}, {61.0000, -5.0000, 29.0000}, 22.8977},
        {{50.0000, 2.5000, 0.0000}, {56.0000, -27.0000, -3.0000}, 31.9030},
        {{50.0000, 2.5000, 0.0000}, {58.0000, 24.0000, 15.0000}, 19.4535},
        {{50.0000, 2.5000, 0.0000}, {50.0000, 3.1736, 0.5854}, 1.0000},
        {{50.0000, 2.5000, 0.0000}, {50.0000, 3.2972, 0.0000}, 1.0000},
        {{50.0000, 2.5000, 0.0000}, {50.0000, 1.8634, 0.5757}, 1.0000},
        {{50.0000, 2.5000, 0.0000}, {50.0000, 3.2592, 0.3350}, 1.0000},
        {{60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}, 1.2644},
        {{63.0109, -31.0961, -5.8663}, {62.8187, -29.7946, -4.0864}, 1.2630},
        {{61.2901, 3.7196, -5.3901}, {61.4292, 2.2480, -4.9620}, 1.8731},
        {{35.0831, -44.1164, 3.7933}, {35.0232, -40.0716, 1.5901}, 1.8645},
        {{22.7233, 20.0904, -46.6940}, {23.0331, 14.9730, -42.5619}, 2.0373},
        {{36.4612, 47.8580, 18.3852}, {36.2715, 50.5065, 21.2231}, 1.4146},
        {{90.8027, -2.0831, 1.4410}, {91.1528, -1.6435, 0.0447}, 1.4441},
        {{90.9257, -0.5406, -0.9208}, {88.6381, -0.8985, -0.7239}, 1.5381},
        {{6.7747, -0.2908, -2.4247}, {5.8714, -0.0985, -2.2286}, 0.6377},
        {{2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}, 0.9082},
    };
    static_assert(std::size(pairs) == 34);
    for (const auto& p : pairs) {
        const auto label = testing::Message() << (&p - pairs + 1);
        EXPECT_NEAR(delta_e_2000(p.lab1, p.lab2), p.difference, kRounding) << label;
        EXPECT_NEAR(delta_e_2000(p.lab2, p.lab1), p.difference, kRounding) << label;
    }
}

// colour-science 0.4.7: delta_E([50, 2.5, 0], [73, 25, -18], method="CIE 2000").
TEST(DeltaE2000, MatchesColourScienceBeyondTheRounding) {
    EXPECT_NEAR(delta_e_2000({50, 2.5, 0}, {73, 25, -18}), 27.149231300746258, 1e-12);
}

// colour-science 0.4.7: delta_E(standard, sample, method="CMC", l=2, c=1), and with l=1.
TEST(DeltaECmc, MatchesColourScience) {
    struct Case {
        Vec3d standard, sample;
        double acceptance, perception;
    };
    const Case cases[] = {
        {{50, 20, -30}, {52, 18, -33}, 2.6074052573293365, 3.054739670971523},
        {{12, 5, 4}, {13, 6, 3}, 2.363746425021626, 2.9085269139548457},
        {{80, -40, 30}, {78, -42, 33}, 1.632954059823028, 2.0714265590780845},
        {{60, 0.5, -0.2}, {61, -0.4, 0.6}, 1.8429905432722022, 1.9805736602648811},
        {{45, 10, 60}, {40, 12, 55}, 3.5141485006960576, 5.486671788343841},
        {{16, -30, -40}, {17, -28, -45}, 2.887956490915409, 3.3481266927379676}};
    for (const Case& c : cases) {
        EXPECT_NEAR(delta_e_cmc(c.standard, c.sample), c.acceptance, 1e-12);
        EXPECT_NEAR(delta_e_cmc(c.standard, c.sample, 1, 1), c.perception, 1e-12);
        EXPECT_EQ(delta_e_cmc(c.standard, c.standard), 0);
        EXPECT_NE(delta_e_cmc(c.standard, c.sample), delta_e_cmc(c.sample, c.standard));
    }
    EXPECT_THROW(delta_e_cmc({50, 0, 0}, {51, 0, 0}, 0, 1), DomainError);
}

// Least squares on the vector are least squares on the difference itself.
TEST(DeltaE2000, IsTheLengthOfItsVector) {
    Rng rng(2000);
    for (int i = 0; i < 1000; ++i) {
        const auto colour = [&] {
            return Vec3d{100 * rng.uniform_double(), 200 * rng.uniform_double() - 100,
                         200 * rng.uniform_double() - 100};
        };
        const Vec3d lab1 = colour(), lab2 = colour(), v = delta_e_2000_vector(lab1, lab2);
        const double difference = delta_e_2000(lab1, lab2);
        EXPECT_NEAR(std::hypot(v[0], v[1], v[2]), difference, 1e-10 * difference);
    }
    EXPECT_EQ(delta_e_2000_vector({50, 20, -30}, {50, 20, -30}), (Vec3d{0, 0, 0}));
}

// Chroma and hue have a corner at grey: the hue turns by 180 deg as a colour passes close to the
// standard. The vector stays linear: here along a*, stretched by 1.5 near the grey axis.
TEST(DeltaE2000, VectorGoesThroughGreysWithoutACorner) {
    const Vec3d grey{50, 0, 0};
    for (double a = -0.3; a < 0.31; a += 0.1) {
        const Vec3d v = delta_e_2000_vector(grey, {50, a, 0.01});
        EXPECT_NEAR(v[1], 1.5 * a, 0.03 * std::abs(a) + 1e-4) << a;  // S_C and S_H: a few per cent
        EXPECT_NEAR(v[2], 0.01, 5e-4) << a;
    }
}

TEST(DeltaE2000, VanishesOnlyForEqualColours) {
    for (const Vec3d& lab : {Vec3d{0, 0, 0}, Vec3d{50, 20, -30}, Vec3d{100, 0, 0}}) {
        EXPECT_EQ(delta_e_2000(lab, lab), 0);
        EXPECT_GT(delta_e_2000(lab, {lab[0], lab[1], lab[2] + 1e-6}), 0);
    }
}

}  // namespace
}  // namespace nacre::spectra
