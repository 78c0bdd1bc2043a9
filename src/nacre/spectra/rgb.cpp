#include "nacre/spectra/rgb.h"

#include <cmath>

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

}  // namespace nacre::spectra
