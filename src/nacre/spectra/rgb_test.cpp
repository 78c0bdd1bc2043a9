#include "nacre/spectra/rgb.h"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <cmath>
#include <limits>

#include "nacre/core/error.h"
#include "nacre/spectra/lab.h"
#include "nacre/spectra/xyz.h"

namespace nacre::spectra {
namespace {

// colour-science 0.4.7: normalised_primary_matrix([[.64, .33], [.3, .6], [.15, .06]],
// [.3127, .3290]), printed with eight decimals.
TEST(Rec709, MatrixMatchesColourScience) {
    const double matrix[3][3] = {{0.4123908, 0.35758434, 0.18048079},
                                 {0.21263901, 0.71516868, 0.07219232},
                                 {0.01933082, 0.11919478, 0.95053215}};
    for (int j = 0; j < 3; ++j) {
        Vec3d primary{};
        primary[j] = 1;
        const Vec3d xyz = linear_rec709_to_xyz(primary);
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(xyz[i], matrix[i][j], 5e-9) << i << j;
    }
}

TEST(Rec709, EqualAmountsMakeTheWhiteOfTheStandardAndPrimariesKeepTheirChromaticity) {
    const Vec3d white = linear_rec709_to_xyz({1, 1, 1});
    EXPECT_NEAR(white[1], 1, 1e-15);
    EXPECT_NEAR(white[0] / (white[0] + white[1] + white[2]), kRec709White[0], 1e-15);
    EXPECT_NEAR(white[1] / (white[0] + white[1] + white[2]), kRec709White[1], 1e-15);
    for (int j = 0; j < 3; ++j) {
        Vec3d rgb{};
        rgb[j] = 0.7;
        const Vec3d xyz = linear_rec709_to_xyz(rgb);
        EXPECT_NEAR(xyz[0] / (xyz[0] + xyz[1] + xyz[2]), kRec709Primaries[j][0], 1e-15);
        EXPECT_NEAR(xyz[1] / (xyz[0] + xyz[1] + xyz[2]), kRec709Primaries[j][1], 1e-15);
    }
}

TEST(Rec709, ThereAndBackIsTheIdentityOutsideTheGamutToo) {
    for (double r : {-0.5, 0.0, 0.3, 1.0, 20.0}) {
        for (double g : {-0.1, 0.5, 1.0}) {
            for (double b : {0.0, 0.25, 3.0}) {
                const Vec3d rgb = {r, g, b};
                const Vec3d back = xyz_to_linear_rec709(linear_rec709_to_xyz(rgb));
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

// Linear Rec. 709 relative to the white of the same sums, independent of rec709_weights().
Vec3d rgb_of(const Spectrum& reflectance) {
    const Vec3d white = white_point(Illuminant::D65, Observer::cie1931_2deg);
    const Vec3d rec709_white = linear_rec709_to_xyz({1, 1, 1});
    Vec3d xyz = reflectance_to_xyz(reflectance, Illuminant::D65, Observer::cie1931_2deg);
    for (int c = 0; c < 3; ++c) xyz[c] *= rec709_white[c] / white[c];
    return xyz_to_linear_rec709(xyz);
}

Spectrum combine(const Vec3d& rgb) {
    const auto& basis = linear_rec709_basis();
    std::vector<double> values;
    for (std::size_t i = 0; i < basis[0].values().size(); ++i) {
        values.push_back(rgb[0] * basis[0].values()[i] + rgb[1] * basis[1].values()[i] +
                         rgb[2] * basis[2].values()[i]);
    }
    return Spectrum(basis[0].wavelengths_nm(), values);
}

TEST(RgbBasis, ColoursOfTheBasisAreTheUnits) {
    for (int j = 0; j < 3; ++j) {
        const Vec3d rgb = rgb_of(linear_rec709_basis()[j]);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(rgb[c], c == j, kRec709BasisError);
    }
}

TEST(RgbBasis, EveryColourComesBackThoseOutsideTheGamutToo) {
    for (const Vec3d& rgb : {Vec3d{0.2, 0.5, 0.9}, Vec3d{1, 0, 0.3}, Vec3d{3, -0.4, 0.01}}) {
        const Vec3d found = rgb_of(combine(rgb));
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], rgb[c], 4 * kRec709BasisError);
    }
}

TEST(RgbBasis, IsAPartitionOfUnityWithinZeroAndOne) {
    const auto& basis = linear_rec709_basis();
    for (double nm = 350; nm <= 790; nm += 2.5) {
        double sum = 0;
        for (const Spectrum& b : basis) {
            EXPECT_GE(b(nm), 0) << nm;
            sum += b(nm);
        }
        EXPECT_NEAR(sum, 1, 1e-15) << nm;
    }
}

TEST(RgbBasis, HasTheLeastSlope) {
    double sum = 0;
    for (const Spectrum& b : linear_rec709_basis()) {
        const std::vector<double>& v = b.values();
        for (std::size_t i = 1; i < v.size(); ++i) sum += (v[i] - v[i - 1]) * (v[i] - v[i - 1]);
    }
    // The same programme by scipy.optimize.minimize (method SLSQP, ftol 1e-15, SciPy 1.17.1).
    EXPECT_NEAR(sum, 0.74966212040693, 1e-9);
}

// The basis minimises the sum of squared slopes subject to b_1 + b_2 + b_3 = 1 at each wavelength,
// b_j >= 0, and the colours of red and green; that of blue follows, since the white has its own.
// With multipliers y_red and y_green for the colours the derivative of the Lagrangian by b_j(i) is
//
//     p_j(i) = 2 (2 b_j(i) - b_j(i-1) - b_j(i+1)) + y_j . w(i),     y_blue = 0.
//
// At the optimum p_j(i) is the same for all channels with b_j(i) > 0 and not smaller for the others
// (Karush, Kuhn and Tucker). The programme is convex: sum_ij b_j(i) (p_j(i) - min_k p_k(i)) bounds
// how far the sum of squared slopes is above its minimum.     [nocedal-wright-2006, chapter 16]
TEST(RgbBasis, MeetsTheConditionsOfOptimality) {
    const auto& basis = linear_rec709_basis();
    const std::vector<Vec3d> weights = rec709_weights(basis[0].wavelengths_nm());
    const int count = static_cast<int>(weights.size());
    ASSERT_EQ(count, 43);
    const auto slope = [&](int j, int i) {
        const auto& b = basis[j].values();
        return 2 * ((i > 0 ? b[i] - b[i - 1] : 0) + (i + 1 < count ? b[i] - b[i + 1] : 0));
    };
    // Equations p_j = p_largest wherever a second channel is above 1e-3.
    std::vector<Eigen::Matrix<double, 1, 6>> rows;
    std::vector<double> right;
    const auto multiplier_row = [&](int j, int i) {
        Eigen::Matrix<double, 1, 6> row = Eigen::Matrix<double, 1, 6>::Zero();
        for (int c = 0; j < 2 && c < 3; ++c) row[3 * j + c] = weights[i][c];
        return row;
    };
    for (int i = 0; i < count; ++i) {
        int largest = 0;
        for (int j = 1; j < 3; ++j) {
            if (basis[j].values()[i] > basis[largest].values()[i]) largest = j;
        }
        for (int j = 0; j < 3; ++j) {
            if (j == largest || basis[j].values()[i] < 1e-3) continue;
            rows.push_back(multiplier_row(j, i) - multiplier_row(largest, i));
            right.push_back(slope(largest, i) - slope(j, i));
        }
    }
    ASSERT_GT(rows.size(), 12u);
    Eigen::MatrixXd matrix(rows.size(), 6);
    for (std::size_t r = 0; r < rows.size(); ++r) matrix.row(r) = rows[r];
    const Eigen::VectorXd y = matrix.colPivHouseholderQr().solve(
        Eigen::Map<const Eigen::VectorXd>(right.data(), right.size()));

    double gap = 0;
    for (int i = 0; i < count; ++i) {
        double p[3], least = INFINITY;
        for (int j = 0; j < 3; ++j) {
            p[j] = slope(j, i) + multiplier_row(j, i) * y;
            least = std::min(least, p[j]);
        }
        for (int j = 0; j < 3; ++j) gap += basis[j].values()[i] * (p[j] - least);
    }
    EXPECT_GE(gap, 0);
    EXPECT_LT(gap, 1e-9);
}

TEST(RgbBasis, WeightsGiveTheColourOfAnySampledSpectrum) {
    std::vector<double> nm, value;
    Vec3d sum{};
    for (int i = 0; i <= 30; ++i) {
        nm.push_back(400 + 10 * i);
        value.push_back(0.5 + 0.4 * std::sin(0.3 * i));
    }
    const std::vector<Vec3d> weights = rec709_weights(nm);
    for (int i = 0; i <= 30; ++i) {
        for (int c = 0; c < 3; ++c) sum[c] += weights[i][c] * value[i];
    }
    const Vec3d expected = rgb_of(Spectrum(nm, value));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(sum[c], expected[c], 1e-13);

    const std::vector<Vec3d> one = rec709_weights({550});
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(one[0][c], 1, 1e-14);  // constant: white
    EXPECT_THROW(rec709_weights({}), DomainError);
    EXPECT_THROW(rec709_weights({500, 400}), DomainError);
}

// Rendered, or summed at 10 nm, over 400-700 nm only, the colours of the basis change by less than
// 0.3.
TEST(RgbBasis, ColourHardlyDependsOnTheEndsOfTheSpectrum) {
    std::vector<double> nm;
    for (int i = 0; i <= 30; ++i) nm.push_back(400 + 10 * i);
    const Vec3d white = white_point(nm, Illuminant::D65, Observer::cie1931_2deg);
    for (int j = 0; j < 3; ++j) {
        std::vector<double> value;
        for (double w : nm) value.push_back(linear_rec709_basis()[j](w));
        const Vec3d short_sum =
            reflectance_to_xyz(nm, value, Illuminant::D65, Observer::cie1931_2deg);
        const Vec3d all =
            reflectance_to_xyz(linear_rec709_basis()[j], Illuminant::D65, Observer::cie1931_2deg);
        EXPECT_LT(
            delta_e_2000(xyz_to_lab(short_sum, white),
                         xyz_to_lab(all, white_point(Illuminant::D65, Observer::cie1931_2deg))),
            0.3);
    }
}

TEST(Rgb, CssColoursAreClippedToTheGamut) {
    EXPECT_EQ(css_colour({0, 0.5, 1}), "#0080ff");
    EXPECT_EQ(css_colour({-1, 2, std::numeric_limits<double>::quiet_NaN()}), "#00ff00");
    EXPECT_EQ(css_colour({std::numeric_limits<double>::infinity(),
                          -std::numeric_limits<double>::infinity(), 1.0 / 255}),
              "#ff0001");
}

// White stays white, each primary has its own chromaticity, and one way undoes the other.
TEST(Gamut, IsByItsChromaticities) {
    for (const Gamut gamut : {Gamut::rec709, Gamut::display_p3, Gamut::rec2020}) {
        const Vec3d white = rec709_to(gamut, {1, 1, 1});
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(white[c], 1, 1e-14);
            Vec3d one{};
            one[c] = 1;
            const Vec3d xyz = linear_rec709_to_xyz(to_rec709(gamut, one));
            const double sum = xyz[0] + xyz[1] + xyz[2];
            EXPECT_NEAR(xyz[0] / sum, primaries(gamut)[c][0], 1e-14);
            EXPECT_NEAR(xyz[1] / sum, primaries(gamut)[c][1], 1e-14);
            const Vec3d back = rec709_to(gamut, to_rec709(gamut, one));
            for (int d = 0; d < 3; ++d) EXPECT_NEAR(back[d], one[d], 1e-14);
        }
    }
}

TEST(Adaptation, TurnsOneWhiteIntoTheOther) {
    const Vec3d a{109.85, 100, 35.585}, d65{95.047, 100, 108.883};
    const Vec3d white = adapted(a, a, d65), grey = adapted(0.2 * a, a, d65);
    const Vec3d same = adapted({30, 40, 50}, d65, d65);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(white[c], d65[c], 1e-9);
        EXPECT_NEAR(grey[c], 0.2 * d65[c], 1e-9);
        EXPECT_NEAR(same[c], Vec3d(30, 40, 50)[c], 1e-9);
    }
}

TEST(Adaptation, FromD50ToD65HasTheMatrixOfTheProfiles) {
    // The matrix that is in use for D50 to D65, to the digits in which it is published.
    const Vec3d d50{0.96422, 1, 0.82521}, d65{0.95047, 1, 1.08883};
    const double expected[3][3] = {{0.9555766, -0.0230393, 0.0631636},
                                   {-0.0282895, 1.0099416, 0.0210077},
                                   {0.0122982, -0.0204830, 1.3299098}};
    for (int column = 0; column < 3; ++column) {
        Vec3d unit{};
        unit[column] = 1;
        const Vec3d out = adapted(unit, d50, d65);
        for (int row = 0; row < 3; ++row) EXPECT_NEAR(out[row], expected[row][column], 1e-5);
    }
}

TEST(Adaptation, RefusesAWhiteThatIsNone) {
    EXPECT_THROW(adapted({1, 1, 1}, {1, 1, 0}, {1, 1, 1}), DomainError);
}

}  // namespace
}  // namespace nacre::spectra
