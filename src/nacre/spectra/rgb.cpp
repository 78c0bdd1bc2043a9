#include "nacre/spectra/rgb.h"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "nacre/core/error.h"
#include "nacre/spectra/xyz.h"

namespace nacre::spectra {
namespace {

using Matrix = std::array<Vec3, 3>;  // rows

constexpr Vec3 multiply(const Matrix& m, const Vec3& v) {
    Vec3 r{};
    for (int i = 0; i < 3; ++i) r[i] = m[i][0] * v[0] + m[i][1] * v[1] + m[i][2] * v[2];
    return r;
}

constexpr Matrix inverse(const Matrix& m) {
    Matrix r{};
    for (int i = 0; i < 3; ++i) {
        const int a = (i + 1) % 3, b = (i + 2) % 3;
        for (int j = 0; j < 3; ++j) {
            const int c = (j + 1) % 3, d = (j + 2) % 3;
            r[j][i] = m[a][c] * m[b][d] - m[a][d] * m[b][c];  // cofactor, transposed
        }
    }
    const double determinant = m[0][0] * r[0][0] + m[0][1] * r[1][0] + m[0][2] * r[2][0];
    for (Vec3& row : r) {
        for (double& x : row) x /= determinant;
    }
    return r;
}

// XYZ of a chromaticity at Y = 1.
constexpr Vec3 xyz_of(const double (&xy)[2]) {
    return {xy[0] / xy[1], 1, (1 - xy[0] - xy[1]) / xy[1]};
}

// Columns are the primaries, scaled so that equal amounts make white.
constexpr Matrix derive_rgb_to_xyz() {
    Matrix m{};
    for (int j = 0; j < 3; ++j) {
        const Vec3 primary = xyz_of(kRec709Primaries[j]);
        for (int i = 0; i < 3; ++i) m[i][j] = primary[i];
    }
    const Vec3 amounts = multiply(inverse(m), xyz_of(kRec709White));
    for (Vec3& row : m) {
        for (int j = 0; j < 3; ++j) row[j] *= amounts[j];
    }
    return m;
}

constexpr Matrix kRgbToXyz = derive_rgb_to_xyz();
constexpr Matrix kXyzToRgb = inverse(kRgbToXyz);

}  // namespace

Vec3 xyz_to_linear_rec709(const Vec3& xyz) { return multiply(kXyzToRgb, xyz); }
Vec3 linear_rec709_to_xyz(const Vec3& rgb) { return multiply(kRgbToXyz, rgb); }

double srgb_encode(double linear) {
    const double x = std::abs(linear);
    return std::copysign(x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055, linear);
}

double srgb_decode(double encoded) {
    const double x = std::abs(encoded);
    return std::copysign(x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4), encoded);
}

std::vector<Vec3> rec709_weights(const std::vector<double>& wavelengths_nm) {
    // The tabulated D65 differs from the rounded chromaticity of Rec. 709 by 9e-5 in Z.
    const Vec3 white = white_point(Illuminant::D65, Observer::cie1931_2deg);
    const Vec3 rec709_white = linear_rec709_to_xyz({1, 1, 1});
    std::vector<Vec3> weights;
    std::vector<double> hat(wavelengths_nm.size(), 0.0);
    for (double& sample : hat) {
        sample = 1;
        Vec3 xyz = reflectance_to_xyz(Spectrum(wavelengths_nm, hat), Illuminant::D65,
                                      Observer::cie1931_2deg);
        sample = 0;
        for (int c = 0; c < 3; ++c) xyz[c] *= rec709_white[c] / white[c];
        weights.push_back(xyz_to_linear_rec709(xyz));
    }
    if (weights.empty()) throw DomainError("a colour needs at least one wavelength");
    return weights;
}

namespace {

constexpr double kBasisFirst_nm = 360, kBasisStep_nm = 10;
constexpr int kBasisSamples = 43;  // to 780 nm, where the table of D65 ends
constexpr int kUnknowns = 2 * kBasisSamples, kColours = 6, kBounds = 3 * kBasisSamples;

// minimise x' Q x / 2  subject to  A x = b,  G x <= h.  The unknowns are the red and the green
// spectrum; the blue one is 1 - red - green, and has its colour because white has.
struct Programme {
    Eigen::MatrixXd q = Eigen::MatrixXd::Zero(kUnknowns, kUnknowns);
    Eigen::MatrixXd a = Eigen::MatrixXd::Zero(kColours, kUnknowns);
    Eigen::MatrixXd g = Eigen::MatrixXd::Zero(kBounds, kUnknowns);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(kColours), h = Eigen::VectorXd::Zero(kBounds);

    explicit Programme(const std::vector<double>& wavelengths_nm) {
        Eigen::MatrixXd slope = Eigen::MatrixXd::Zero(kBasisSamples - 1, kBasisSamples);
        for (int i = 0; i + 1 < kBasisSamples; ++i) {
            slope(i, i) = -1;
            slope(i, i + 1) = 1;
        }
        // |D r|^2 + |D g|^2 + |D (1 - r - g)|^2
        const Eigen::MatrixXd roughness = 2 * slope.transpose() * slope;
        q << 2 * roughness, roughness, roughness, 2 * roughness;

        const std::vector<Vec3> weights = rec709_weights(wavelengths_nm);
        const auto identity = Eigen::MatrixXd::Identity(kBasisSamples, kBasisSamples);
        for (int spectrum = 0; spectrum < 2; ++spectrum) {
            for (int c = 0; c < 3; ++c) {
                for (int i = 0; i < kBasisSamples; ++i) {
                    a(3 * spectrum + c, spectrum * kBasisSamples + i) = weights[i][c];
                }
            }
            b[3 * spectrum + spectrum] = 1;
            g.block(spectrum * kBasisSamples, spectrum * kBasisSamples, kBasisSamples,
                    kBasisSamples) = -identity;
            g.block(2 * kBasisSamples, spectrum * kBasisSamples, kBasisSamples, kBasisSamples) =
                identity;
        }
        h.tail(kBasisSamples).setOnes();
    }
};

// The largest step, at most 1, that keeps `x + step dx` above a hundredth of x.
double longest_step(const Eigen::VectorXd& x, const Eigen::VectorXd& dx) {
    double step = 1;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
        if (dx[i] < 0) step = std::min(step, -0.99 * x[i] / dx[i]);
    }
    return step;
}

// A primal-dual interior-point method: Newton's method on the conditions of optimality with the
// complementarity s_i z_i driven to zero.                     [nocedal-wright-2006, chapter 16]
Eigen::VectorXd solve(const Programme& p) {
    Eigen::VectorXd x = Eigen::VectorXd::Constant(kUnknowns, 1.0 / 3);
    Eigen::VectorXd y = Eigen::VectorXd::Zero(kColours);  // multipliers of the colours
    Eigen::VectorXd z = Eigen::VectorXd::Ones(kBounds);   // multipliers of the bounds
    Eigen::VectorXd s = p.h - p.g * x;                    // distances from the bounds
    constexpr double kGap = 1e-12, kCentring = 0.1;
    constexpr int kMaxSteps = 100;
    for (int step = 0; step < kMaxSteps; ++step) {
        const Eigen::VectorXd dual = p.q * x + p.a.transpose() * y + p.g.transpose() * z;
        const Eigen::VectorXd colour = p.a * x - p.b;
        const Eigen::VectorXd bound = p.g * x + s - p.h;
        const double gap = s.dot(z) / kBounds;
        if (gap < kGap && colour.cwiseAbs().maxCoeff() < 0.1 * kRec709BasisError &&
            dual.cwiseAbs().maxCoeff() < 1e-9) {
            return x;
        }
        const Eigen::VectorXd stiffness = z.cwiseQuotient(s);
        const Eigen::VectorXd centre =
            kCentring * gap * s.cwiseInverse() - z + stiffness.cwiseProduct(bound);
        Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(kUnknowns + kColours, kUnknowns + kColours);
        matrix.topLeftCorner(kUnknowns, kUnknowns) =
            p.q + p.g.transpose() * stiffness.asDiagonal() * p.g;
        matrix.topRightCorner(kUnknowns, kColours) = p.a.transpose();
        matrix.bottomLeftCorner(kColours, kUnknowns) = p.a;
        Eigen::VectorXd right(kUnknowns + kColours);
        right << -dual - p.g.transpose() * centre, -colour;
        const Eigen::VectorXd d = matrix.partialPivLu().solve(right);
        const Eigen::VectorXd dx = d.head(kUnknowns);
        const Eigen::VectorXd ds = -bound - p.g * dx;
        const Eigen::VectorXd dz = centre + stiffness.cwiseProduct(p.g * dx);
        const double length = std::min(longest_step(s, ds), longest_step(z, dz));
        x += length * dx;
        y += length * d.tail(kColours);
        s += length * ds;
        z += length * dz;
    }
    throw Error("no RGB basis was found: the interior-point method did not converge");
}

std::array<Spectrum, 3> make_basis() {
    std::vector<double> wavelengths_nm;
    for (int i = 0; i < kBasisSamples; ++i)
        wavelengths_nm.push_back(kBasisFirst_nm + i * kBasisStep_nm);
    const Eigen::VectorXd x = solve(Programme(wavelengths_nm));
    std::array<std::vector<double>, 3> value;
    for (int i = 0; i < kBasisSamples; ++i) {
        // Interior points are above the bounds, by 1e-13 and less: rounding may not show there.
        value[0].push_back(std::max(0.0, x[i]));
        value[1].push_back(std::max(0.0, x[kBasisSamples + i]));
        value[2].push_back(std::max(0.0, 1 - x[i] - x[kBasisSamples + i]));
    }
    return {Spectrum(wavelengths_nm, value[0]), Spectrum(wavelengths_nm, value[1]),
            Spectrum(wavelengths_nm, value[2])};
}

}  // namespace

const std::array<Spectrum, 3>& linear_rec709_basis() {
    static const std::array<Spectrum, 3> basis = make_basis();
    return basis;
}

std::string css_colour(const std::array<double, 3>& srgb) {
    std::string text = "#";
    for (const double component : srgb) {
        // max(0, NaN) is 0.
        const double clipped = std::min(1.0, std::max(0.0, component));
        text += fmt::format("{:02x}", std::lround(255 * clipped));
    }
    return text;
}

}  // namespace nacre::spectra
