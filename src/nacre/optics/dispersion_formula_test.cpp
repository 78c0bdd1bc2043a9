#include "nacre/optics/dispersion_formula.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace nacre::optics {
namespace {

double index(int number, std::vector<double> coefficients, double wavelength_um) {
    return dispersion_formula(number, coefficients, wavelength_um);
}

// Each formula with a published fit, against the index that is published for the substance.

TEST(DispersionFormula, SellmeierGivesFusedSilica) {
    // I. H. Malitson, J. Opt. Soc. Am. 55, 1205 (1965): n = 1.458464 at the helium d line
    EXPECT_NEAR(index(1, {0, .6961663, .0684043, .4079426, .1162414, .8974794, 9.896161}, .5875618),
                1.458464, 1e-6);
}

TEST(DispersionFormula, SellmeierTwoGivesSchottBk7) {
    // Schott data sheet N-BK7: n_d = 1.51680, n_F = 1.52238, n_C = 1.51432
    const std::vector<double> c{0,           1.03961212, .00600069867, .231792344,
                                .0200179144, 1.01046945, 103.560653};
    EXPECT_NEAR(index(2, c, .5875618), 1.51680, 5e-6);
    EXPECT_NEAR(index(2, c, .4861327), 1.52238, 5e-6);
    EXPECT_NEAR(index(2, c, .6562725), 1.51432, 5e-6);
}

TEST(DispersionFormula, PolynomialGivesSchottBk7) {
    // the older Schott formula in powers of the wavelength, the same glass
    EXPECT_NEAR(index(3,
                      {2.2718929, -1.0108077e-2, 2, 1.0592509e-2, -2, 2.0816965e-4, -4,
                       -7.6472538e-6, -6, 4.9240991e-7, -8},
                      .5875618),
                1.51680, 5e-6);
}

TEST(DispersionFormula, FormulaFourGivesRutile) {
    // J. R. Devore, J. Opt. Soc. Am. 41, 416 (1951), ordinary ray: n = 2.6479 at 550 nm, as in
    // data/materials/TiO2_rutile_o.csv
    EXPECT_NEAR(index(4, {5.913, .2441, 0, .0803, 1}, .55), 2.6479, 1e-4);
    // and its polynomial terms: n^2 = 4 + 2 w^3
    EXPECT_NEAR(index(4, {4, 0, 0, 0, 0, 0, 0, 0, 0, 2, 3}, .5), std::sqrt(4.25), 1e-15);
}

TEST(DispersionFormula, CauchyAddsPowers) {
    EXPECT_NEAR(index(5, {1.5, .004, -2, 1e-4, -4}, .5), 1.5 + .016 + .0016, 1e-15);
}

TEST(DispersionFormula, GasesGiveAir) {
    // P. E. Ciddor, Appl. Opt. 35, 1566 (1996): standard air, (n - 1) 1e8 = 27 717 at 587.6 nm
    EXPECT_NEAR(index(6, {0, .05792105, 238.0185, .00167917, 57.362}, .5876), 1.00027717, 1e-8);
}

TEST(DispersionFormula, HerzbergerGivesSilicon) {
    // D. F. Edwards and E. Ochoa, Appl. Opt. 19, 4130 (1980): 3.4215 at 10 um
    EXPECT_NEAR(index(7, {3.41983, .159906, -.123109, 1.26878e-6, -1.95104e-9, 0}, 10), 3.4215,
                1e-4);
}

TEST(DispersionFormula, RetroGivesSilverBromide) {
    // H. Schroeter, Z. Phys. 67, 24 (1931); n = 2.25 at the sodium line
    EXPECT_NEAR(index(8, {.452505, .09939, .070537, -.00015}, .589), 2.25, 1e-2);
}

TEST(DispersionFormula, ExoticGivesUrea) {
    // M. J. Rosker, K. Cheng and C. L. Tang, IEEE J. Quantum Electron. 21, 1600 (1985): n_e = 1.58
    // at 1064 nm
    EXPECT_NEAR(index(9, {2.51527, .0240, .0300, .0202, 1.52, .08771}, 1.064), 1.58, 1e-2);
}

TEST(DispersionFormula, MissingCoefficientsAreZero) {
    for (int number = 1; number <= kDispersionFormulas; ++number) {
        const double c1 = number == 8 ? .25 : 2.25;
        std::vector<double> padded(kMaxDispersionCoefficients);
        padded[0] = c1;
        EXPECT_DOUBLE_EQ(index(number, {c1}, .6), index(number, padded, .6)) << number;
        EXPECT_TRUE(std::isfinite(index(number, {c1}, .6))) << number;
    }
}

TEST(DispersionFormula, PolesAndNegativeSquaresAreNotFinite) {
    EXPECT_FALSE(std::isfinite(index(1, {0, 1, .5}, .5)));
    EXPECT_TRUE(std::isnan(index(3, {-2}, .5)));
}

}  // namespace
}  // namespace nacre::optics
