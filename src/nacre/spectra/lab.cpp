#include "nacre/spectra/lab.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/core/math.h"
#include "nacre/spectra/rgb.h"

namespace nacre::spectra {
namespace {

constexpr double kDelta = 6.0 / 29;

double f(double t) {
    return t > kDelta * kDelta * kDelta ? std::cbrt(t) : t / (3 * kDelta * kDelta) + 4.0 / 29;
}
double f_inverse(double u) { return u > kDelta ? u * u * u : 3 * kDelta * kDelta * (u - 4.0 / 29); }

void require_positive(const Vec3d& white) {
    if (!(white[0] > 0 && white[1] > 0 && white[2] > 0)) {
        throw DomainError(fmt::format("the white point ({}, {}, {}) is not positive", white[0],
                                      white[1], white[2]));
    }
}

}  // namespace

Vec3d xyz_to_lab(const Vec3d& xyz, const Vec3d& white) {
    require_positive(white);
    const double fx = f(xyz[0] / white[0]), fy = f(xyz[1] / white[1]), fz = f(xyz[2] / white[2]);
    return {116 * fy - 16, 500 * (fx - fy), 200 * (fy - fz)};
}

Vec3d lab_to_xyz(const Vec3d& lab, const Vec3d& white) {
    require_positive(white);
    const double fy = (lab[0] + 16) / 116;
    return {white[0] * f_inverse(fy + lab[1] / 500), white[1] * f_inverse(fy),
            white[2] * f_inverse(fy - lab[2] / 200)};
}

Vec3d linear_rec709_to_lab(const Vec3d& rgb) {
    return xyz_to_lab(linear_rec709_to_xyz(rgb), linear_rec709_to_xyz({1, 1, 1}));
}

Vec3d lab_to_linear_rec709(const Vec3d& lab) {
    return xyz_to_linear_rec709(lab_to_xyz(lab, linear_rec709_to_xyz({1, 1, 1})));
}

namespace {

double cos_deg(double degrees) { return std::cos(kDegree * degrees); }
double pow7(double x) { return std::pow(x, 7); }

// sqrt(C^7 / (C^7 + 25^7)), which rises from 0 for greys to 1 for strong colours.
double chroma_weight(double chroma) { return std::sqrt(pow7(chroma) / (pow7(chroma) + pow7(25))); }

// Hue angle in [0, 360); 0 for a grey.
double hue_deg(double a, double b) {
    if (a == 0 && b == 0) return 0;
    return wrapped_deg(std::atan2(b, a) / kDegree);
}

// The terms of the formula: weighted differences of lightness, chroma and hue, the factor of the
// cross term, and what is needed to turn chroma and hue back into a* and b*.
struct Terms {
    double lightness, chroma, hue;  // dL'/S_L, dC'/S_C, dH'/S_H
    double rotation;                // R_T
    double da, db;                  // da' and db*
    double dc, dh;                  // dC' and dH'
};

Terms terms(const Vec3d& lab1, const Vec3d& lab2) {
    // Step 1: chromas and hues with a* stretched near the grey axis (eq. 2-7).
    const double mean_chroma = (std::hypot(lab1[1], lab1[2]) + std::hypot(lab2[1], lab2[2])) / 2;
    const double stretch = 1 + 0.5 * (1 - chroma_weight(mean_chroma));
    const double a1 = stretch * lab1[1], a2 = stretch * lab2[1];
    const double c1 = std::hypot(a1, lab1[2]), c2 = std::hypot(a2, lab2[2]);
    const double h1 = hue_deg(a1, lab1[2]), h2 = hue_deg(a2, lab2[2]);
    const bool has_hues = c1 * c2 != 0;

    // Step 2: differences of lightness, chroma and hue (eq. 8-11).
    double dh = has_hues ? h2 - h1 : 0;
    if (dh > 180) dh -= 360;
    if (dh < -180) dh += 360;
    const double dl = lab2[0] - lab1[0], dc = c2 - c1;
    const double dH = 2 * std::sqrt(c1 * c2) * std::sin(kDegree * dh / 2);

    // Step 3: weights at the means (eq. 12-21).
    const double l = (lab1[0] + lab2[0]) / 2, c = (c1 + c2) / 2;
    double h = h1 + h2;
    if (has_hues) {
        if (std::abs(h1 - h2) > 180) h += h < 360 ? 360 : -360;
        h /= 2;
    }
    const double t = 1 - 0.17 * cos_deg(h - 30) + 0.24 * cos_deg(2 * h) +
                     0.32 * cos_deg(3 * h + 6) - 0.20 * cos_deg(4 * h - 63);
    const double l50 = (l - 50) * (l - 50);
    const double sl = 1 + 0.015 * l50 / std::sqrt(20 + l50);
    const double sc = 1 + 0.045 * c, sh = 1 + 0.015 * c * t;
    const double dtheta = 30 * std::exp(-std::pow((h - 275) / 25, 2));
    const double rt = -std::sin(2 * kDegree * dtheta) * 2 * chroma_weight(c);

    return {dl / sl, dc / sc, dH / sh, rt, a2 - a1, lab2[2] - lab1[2], dc, dH};
}

}  // namespace

double delta_e_cmc(const Vec3d& standard, const Vec3d& sample, double l, double c) {
    if (!(l > 0 && c > 0)) {
        throw DomainError(fmt::format("CMC({}:{}): both numbers must be positive", l, c));
    }
    const double lightness = standard[0], chroma = std::hypot(standard[1], standard[2]);
    const double hue = hue_deg(standard[1], standard[2]);
    const double dl = sample[0] - lightness, dc = std::hypot(sample[1], sample[2]) - chroma;
    const double da = sample[1] - standard[1], db = sample[2] - standard[2];
    const double dh2 = std::max(0.0, da * da + db * db - dc * dc);  // Delta H*^2

    const double sl = lightness < 16 ? 0.511 : 0.040975 * lightness / (1 + 0.01765 * lightness);
    const double sc = 0.0638 * chroma / (1 + 0.0131 * chroma) + 0.638;
    const double c4 = std::pow(chroma, 4), f = std::sqrt(c4 / (c4 + 1900));
    const double t = hue >= 164 && hue <= 345 ? 0.56 + std::abs(0.2 * cos_deg(hue + 168))
                                              : 0.36 + std::abs(0.4 * cos_deg(hue + 35));
    const double sh = sc * (f * t + 1 - f);
    const double x = dl / (l * sl), y = dc / (c * sc);
    return std::sqrt(x * x + y * y + dh2 / (sh * sh));
}

double delta_e_2000(const Vec3d& lab1, const Vec3d& lab2) {
    const Terms t = terms(lab1, lab2);
    return std::sqrt(t.lightness * t.lightness + t.chroma * t.chroma + t.hue * t.hue +
                     t.rotation * t.chroma * t.hue);  // eq. 22
}

Vec3d delta_e_2000_vector(const Vec3d& lab1, const Vec3d& lab2) {
    const Terms t = terms(lab1, lab2);
    // c^2 + h^2 + R c h = (c + R h/2)^2 + (1 - R^2/4) h^2, and |R| <= 2.
    const double u = t.chroma + t.rotation / 2 * t.hue;
    const double v = std::sqrt(std::max(0.0, 1 - t.rotation * t.rotation / 4)) * t.hue;
    // (da', db') and (dC', dH') are equally long: their quotient as complex numbers is a rotation.
    const double length2 = t.dc * t.dc + t.dh * t.dh;
    if (length2 == 0) return {t.lightness, 0, 0};
    double cosine = (t.da * t.dc + t.db * t.dh) / length2;
    double sine = (t.db * t.dc - t.da * t.dh) / length2;
    const double size = std::hypot(cosine, sine);  // 1 but for rounding
    cosine /= size;
    sine /= size;
    return {t.lightness, cosine * u - sine * v, sine * u + cosine * v};
}

}  // namespace nacre::spectra
