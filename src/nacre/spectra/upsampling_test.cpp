#include "nacre/spectra/upsampling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/core/random.h"
#include "nacre/spectra/lab.h"
#include "nacre/spectra/rgb.h"
#include "nacre/spectra/xyz.h"
#include "nacre/testing/statistics.h"

namespace nacre::spectra {
namespace {

// Linear Rec. 709 under D65, 2 degrees, relative to the perfect diffuser by the same sums.
Vec3d colour_of(const Spectrum& s, double first_nm, double last_nm, double step_nm) {
    std::vector<double> wavelengths, values;
    for (double w = first_nm; w <= last_nm; w += step_nm) {
        wavelengths.push_back(w);
        values.push_back(s(w));
    }
    const auto light = Illuminant::D65;
    const auto observer = Observer::cie1931_2deg;
    Vec3d xyz = reflectance_to_xyz(wavelengths, values, light, observer);
    const Vec3d white = white_point(wavelengths, light, observer);
    const Vec3d rec709_white = linear_rec709_to_xyz({1, 1, 1});
    for (int c = 0; c < 3; ++c) xyz[c] *= rec709_white[c] / white[c];
    return xyz_to_linear_rec709(xyz);
}

double largest_difference(const Vec3d& a, const Vec3d& b) {
    double largest = 0;
    for (int c = 0; c < 3; ++c) largest = test::worse(largest, std::abs(a[c] - b[c]));
    return largest;
}

// A grid of the cube, denser towards its faces, and random points.
std::vector<Vec3d> colours() {
    const double levels[] = {0,   1e-300, 1e-9, 1e-4,     1e-3,     0.02,     0.2,
                             0.5, 0.8,    0.98, 1 - 1e-3, 1 - 1e-4, 1 - 1e-9, 1};
    std::vector<Vec3d> list;
    for (double r : levels) {
        for (double g : levels) {
            for (double b : levels) list.push_back({r, g, b});
        }
    }
    Rng rng(5);
    for (int i = 0; i < 2000; ++i) {
        const double r = rng.uniform_double(), g = rng.uniform_double();
        list.push_back({r, g, rng.uniform_double()});
    }
    return list;
}

TEST(Upsampling, GivesTheColourBackEverywhereInTheCube) {
    for (const Vec3d& rgb : colours()) {
        const Spectrum s = reflectance_from_rec709(rgb);
        EXPECT_LE(largest_difference(colour_of(s, 360, 780, 5), rgb), kUpsamplingError)
            << rgb[0] << " " << rgb[1] << " " << rgb[2];
        EXPECT_GE(s.min(), 0);
        EXPECT_LE(s.max(), 1);
    }
}

// The same on the grid of Nacre's reports, 400-700 nm by 10 nm; docs/colour.md quotes the bound.
TEST(Upsampling, ColourDifferenceOnTheReportingGridIsInvisible) {
    const Vec3d white = linear_rec709_to_xyz({1, 1, 1});
    double largest = 0;
    for (const Vec3d& rgb : colours()) {
        const Vec3d back = colour_of(reflectance_from_rec709(rgb), 400, 700, 10);
        const Vec3d lab1 = xyz_to_lab(linear_rec709_to_xyz(rgb), white);
        const Vec3d lab2 = xyz_to_lab(linear_rec709_to_xyz(back), white);
        largest = test::worse(largest, delta_e_2000(lab1, lab2));
    }
    EXPECT_LT(largest, 0.25);
}

TEST(Upsampling, GreysAreExactlyConstant) {
    for (double grey : {0.0, 1e-5, 0.18, 0.6, 1.0}) {
        EXPECT_EQ(reflectance_from_rec709({grey, grey, grey}), Spectrum(grey));
    }
}

// A tiny change of colour changes the spectrum little, also where the method switches: at greys,
// near black and near white.
TEST(Upsampling, IsContinuous) {
    const double e = 1e-7;
    const Vec3d centres[] = {{0.5, 0.5, 0.5},       {1e-3, 1e-3, 0.2e-3}, {1 - 1e-3, 1, 1 - 0.5e-3},
                             {0.89, 0.0 + e, 0.13}, {1e-3, 1e-3, 1e-3},   {0.2, 0.7, 0.3}};
    for (const Vec3d& c : centres) {
        const Spectrum a = reflectance_from_rec709({c[0] - e, c[1], c[2]});
        const Spectrum b = reflectance_from_rec709({c[0] + e, c[1], c[2]});
        for (double w = 360; w <= 780; w += 5) EXPECT_NEAR(a(w), b(w), 1e-4) << c[0] << " " << w;
    }
}

TEST(Upsampling, IsSymmetricUnderOneMinusTheReflectance) {
    // Burns' functional is symmetric under rho -> 1 - rho.
    const Spectrum a = reflectance_from_rec709({0.7, 0.2, 0.4});
    const Spectrum b = reflectance_from_rec709({0.3, 0.8, 0.6});
    for (double w = 360; w <= 780; w += 10) EXPECT_NEAR(a(w), 1 - b(w), 1e-7) << w;
}

// No other reflectance with the same colour is smoother: any admissible change raises the slope.
TEST(Upsampling, IsTheSmoothestOfItsMetamers) {
    const Spectrum s = reflectance_from_rec709({0.7, 0.2, 0.4});
    const auto slope_squared = [](const std::vector<double>& rho) {
        double sum = 0;
        for (std::size_t i = 1; i < rho.size(); ++i) {
            sum += std::pow(std::atanh(2 * rho[i] - 1) - std::atanh(2 * rho[i - 1] - 1), 2);
        }
        return sum;
    };
    // A metameric black, from random numbers made orthogonal to the three colour weights.
    const std::size_t n = s.values().size();
    std::vector<std::vector<double>> basis;
    const auto project = [&](std::vector<double> v) {
        for (int pass = 0; pass < 2; ++pass) {
            for (const auto& u : basis) {
                double along = 0;
                for (std::size_t i = 0; i < n; ++i) along += u[i] * v[i];
                for (std::size_t i = 0; i < n; ++i) v[i] -= along * u[i];
            }
        }
        return v;
    };
    for (int c = 0; c < 3; ++c) {
        std::vector<double> weights(n);
        for (std::size_t i = 0; i < n; ++i) {
            std::vector<double> unit(n);
            unit[i] = 1;
            weights[i] = colour_of(Spectrum(s.wavelengths_nm(), unit), 360, 780, 5)[c];
        }
        weights = project(weights);
        double norm = 0;
        for (double x : weights) norm += x * x;
        for (double& x : weights) x /= std::sqrt(norm);
        basis.push_back(weights);
    }
    const double least = slope_squared(s.values());
    Rng rng(3);
    for (int trial = 0; trial < 50; ++trial) {
        std::vector<double> change(n);
        for (double& x : change) x = rng.uniform_double() - 0.5;
        change = project(change);
        std::vector<double> other = s.values();
        for (std::size_t i = 0; i < n; ++i) other[i] += 1e-3 * change[i];
        ASSERT_LE(largest_difference(colour_of(Spectrum(s.wavelengths_nm(), other), 360, 780, 5),
                                     {0.7, 0.2, 0.4}),
                  1e-9);
        EXPECT_GT(slope_squared(other), least);
    }
}

TEST(Upsampling, RefusesWhatNoReflectanceCanShow) {
    EXPECT_THROW(reflectance_from_rec709({-0.01, 0.5, 0.5}), DomainError);
    EXPECT_THROW(reflectance_from_rec709({0.5, 1.01, 0.5}), DomainError);
    EXPECT_THROW(reflectance_from_rec709({0.5, 0.5, std::nan("")}), DomainError);
}

}  // namespace
}  // namespace nacre::spectra
