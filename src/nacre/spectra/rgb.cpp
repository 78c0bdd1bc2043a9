#include "nacre/spectra/rgb.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "nacre/core/error.h"
#include "nacre/spectra/xyz.h"

namespace nacre::spectra {
namespace {

using Matrix = std::array<Vec3d, 3>;  // rows

constexpr Vec3d multiply(const Matrix& m, const Vec3d& v) {
    return {dot(m[0], v), dot(m[1], v), dot(m[2], v)};
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
    for (Vec3d& row : r) row = row / determinant;
    return r;
}

// XYZ of a chromaticity at Y = 1.
constexpr Vec3d xyz_of(const double (&xy)[2]) {
    return {xy[0] / xy[1], 1, (1 - xy[0] - xy[1]) / xy[1]};
}

// Columns are the primaries, scaled so that equal amounts make white.
constexpr Matrix derive_rgb_to_xyz(const double (&primaries)[3][2]) {
    Matrix m{};
    for (int j = 0; j < 3; ++j) {
        const Vec3d primary = xyz_of(primaries[j]);
        for (int i = 0; i < 3; ++i) m[i][j] = primary[i];
    }
    const Vec3d amounts = multiply(inverse(m), xyz_of(kRec709White));
    for (Vec3d& row : m) row = row * amounts;
    return m;
}

constexpr double kDisplayP3Primaries[3][2] = {{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}};
constexpr double kRec2020Primaries[3][2] = {{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}};

constexpr Matrix kRgbToXyz = derive_rgb_to_xyz(kRec709Primaries);
constexpr Matrix kXyzToRgb = inverse(kRgbToXyz);

// By Gamut; the first is not asked.
constexpr Matrix kGamutToXyz[] = {kRgbToXyz, derive_rgb_to_xyz(kDisplayP3Primaries),
                                  derive_rgb_to_xyz(kRec2020Primaries)};
constexpr Matrix kXyzToGamut[] = {kXyzToRgb, inverse(kGamutToXyz[1]), inverse(kGamutToXyz[2])};

}  // namespace

Vec3d xyz_to_linear_rec709(const Vec3d& xyz) { return multiply(kXyzToRgb, xyz); }
Vec3d linear_rec709_to_xyz(const Vec3d& rgb) { return multiply(kRgbToXyz, rgb); }

Vec3d adapted(const Vec3d& xyz, const Vec3d& from, const Vec3d& to) {
    for (const Vec3d& white : {from, to}) {
        if (!(white.x > 0 && white.y > 0 && white.z > 0)) {
            throw DomainError("a white to adapt to must have positive X, Y and Z");
        }
    }
    constexpr Matrix kResponses = {
        {{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}};
    constexpr Matrix kBack = inverse(kResponses);
    const Vec3d before = multiply(kResponses, from), after = multiply(kResponses, to);
    Vec3d response = multiply(kResponses, xyz);
    for (int c = 0; c < 3; ++c) response[c] *= after[c] / before[c];
    return multiply(kBack, response);
}

Vec3d rec709_to(Gamut gamut, const Vec3d& linear_rec709) {
    if (gamut == Gamut::rec709) return linear_rec709;
    return multiply(kXyzToGamut[static_cast<int>(gamut)], linear_rec709_to_xyz(linear_rec709));
}

Vec3d to_rec709(Gamut gamut, const Vec3d& linear) {
    if (gamut == Gamut::rec709) return linear;
    return xyz_to_linear_rec709(multiply(kGamutToXyz[static_cast<int>(gamut)], linear));
}

const double (&primaries(Gamut gamut))[3][2] {
    switch (gamut) {
        case Gamut::display_p3:
            return kDisplayP3Primaries;
        case Gamut::rec2020:
            return kRec2020Primaries;
        case Gamut::rec709:
            break;
    }
    return kRec709Primaries;
}

double srgb_encode(double linear) {
    const double x = std::abs(linear);
    return std::copysign(x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055, linear);
}

double srgb_decode(double encoded) {
    const double x = std::abs(encoded);
    return std::copysign(x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4), encoded);
}

std::vector<Vec3d> rec709_weights(const std::vector<double>& wavelengths_nm) {
    // The tabulated D65 differs from the rounded chromaticity of Rec. 709 by 9e-5 in Z.
    const Vec3d white = white_point(Illuminant::D65, Observer::cie1931_2deg);
    const Vec3d rec709_white = linear_rec709_to_xyz({1, 1, 1});
    std::vector<Vec3d> weights;
    std::vector<double> hat(wavelengths_nm.size(), 0.0);
    for (double& sample : hat) {
        sample = 1;
        Vec3d xyz = reflectance_to_xyz(Spectrum(wavelengths_nm, hat), Illuminant::D65,
                                       Observer::cie1931_2deg);
        sample = 0;
        for (int c = 0; c < 3; ++c) xyz[c] *= rec709_white[c] / white[c];
        weights.push_back(xyz_to_linear_rec709(xyz));
    }
    if (weights.empty()) throw DomainError("a colour needs at least one wavelength");
    return weights;
}

namespace {

struct BasisRow {
    double wavelength_nm, value[3];
};
constexpr BasisRow kBasis[] = {
#include "rec709_basis.inc"
};

Spectrum basis_spectrum(int channel) {
    std::vector<double> wavelengths_nm, values;
    for (const BasisRow& row : kBasis) {
        wavelengths_nm.push_back(row.wavelength_nm);
        values.push_back(row.value[channel]);
    }
    return {std::move(wavelengths_nm), std::move(values)};
}

}  // namespace

const std::array<Spectrum, 3>& linear_rec709_basis() {
    static const std::array<Spectrum, 3> basis = {basis_spectrum(0), basis_spectrum(1),
                                                  basis_spectrum(2)};
    return basis;
}

std::string css_colour(const Vec3d& srgb) {
    std::string text = "#";
    for (const double component : {srgb.x, srgb.y, srgb.z}) {
        // max(0, NaN) is 0.
        const double clipped = std::min(1.0, std::max(0.0, component));
        text += fmt::format("{:02x}", std::lround(255 * clipped));
    }
    return text;
}

}  // namespace nacre::spectra
