#include "nacre/spectra/lab.h"

#include <cmath>

#include "nacre/core/error.h"

namespace nacre::spectra {
namespace {

constexpr double kDelta = 6.0 / 29;

double f(double t) {
    return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3 * kDelta * kDelta) + 4.0 / 29;
}
double f_inverse(double u) { return u > kDelta ? u * u * u : 3 * kDelta * kDelta * (u - 4.0 / 29); }

void require_positive(const Vec3& white) {
    if (!(white[0] > 0 && white[1] > 0 && white[2] > 0)) {
        throw DomainError(fmt::format("the white point ({}, {}, {}) is not positive", white[0],
                                      white[1], white[2]));
    }
}

}  // namespace

Vec3 xyz_to_lab(const Vec3& xyz, const Vec3& white) {
    require_positive(white);
    const double fx = f(xyz[0] / white[0]), fy = f(xyz[1] / white[1]), fz = f(xyz[2] / white[2]);
    return {116 * fy - 16, 500 * (fx - fy), 200 * (fy - fz)};
}

Vec3 lab_to_xyz(const Vec3& lab, const Vec3& white) {
    require_positive(white);
    const double fy = (lab[0] + 16) / 116;
    return {white[0] * f_inverse(fy + lab[1] / 500), white[1] * f_inverse(fy),
            white[2] * f_inverse(fy - lab[2] / 200)};
}

}  // namespace nacre::spectra
