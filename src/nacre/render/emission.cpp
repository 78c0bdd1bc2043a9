#include "nacre/render/emission.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "nacre/spectra/colour.h"

namespace nacre::render {
namespace {

constexpr double kLaneSpacing_nm = (kFilmLast_nm - kFilmFirst_nm) / kLanes;

/// Int f(lambda) y_bar(lambda) d lambda over the film's range, trapezoidal in 1 nm steps.
template <class F>
double integrate_with_luminosity(F&& f) {
    double sum = 0;
    const int steps = static_cast<int>(kFilmLast_nm - kFilmFirst_nm);
    for (int i = 0; i <= steps; ++i) {
        const double nm = kFilmFirst_nm + i;
        const double end = i == 0 || i == steps ? 0.5 : 1.0;
        sum += end * f(nm) * spectra::colour_matching(spectra::Observer::cie1931_2deg, nm)[1];
    }
    return sum;
}

/// Of the whole numbers without a common divisor with `count`, so that its multiples meet all places, the one
/// nearest to the golden section of it.
std::uint32_t lattice_step(std::uint32_t count) {
    const double golden = 0.61803398874989484820 * count;  // (sqrt(5) - 1) / 2
    const auto below = static_cast<std::uint32_t>(golden);
    for (std::uint32_t away = 0; away <= below; ++away) {
        const std::uint32_t down = below - away, up = below + 1 + away;
        const bool up_is_nearer = up - golden < golden - down;
        for (const std::uint32_t step : {up_is_nearer ? up : down, up_is_nearer ? down : up}) {
            if (std::gcd(step, count) == 1) return step;
        }
    }
    return 1;
}

double luminosity_integral() {
    static const double integral = integrate_with_luminosity([](double) { return 1.0; });
    return integral;
}

}  // namespace

bsdf::Wavelengths film_wavelengths(std::uint32_t pass, std::uint32_t passes) {
    const std::uint64_t place = pass * std::uint64_t{lattice_step(passes)} % passes;
    const double offset = (static_cast<double>(place) + 0.5) / passes;
    bsdf::Wavelengths nm;
    for (int i = 0; i < kLanes; ++i) nm[i] = kFilmFirst_nm + (i + offset) * kLaneSpacing_nm;
    return nm;
}

XyzWeights film_xyz_weights(const bsdf::Wavelengths& wavelengths_nm) {
    XyzWeights weights;
    for (int i = 0; i < kLanes; ++i) {
        const auto xyz =
            spectra::colour_matching(spectra::Observer::cie1931_2deg, wavelengths_nm[i]);
        for (int c = 0; c < 3; ++c) {
            weights[c][i] = static_cast<float>(xyz[c] * kLaneSpacing_nm / luminosity_integral());
        }
    }
    return weights;
}

double film_luminance(const spectra::Spectrum& radiance) {
    return integrate_with_luminosity([&](double nm) { return radiance(nm); }) /
           luminosity_integral();
}

namespace {

using spectra::Spectrum;

/// Tabulates f over the film's range.
template <class F>
Spectrum tabulate(double step_nm, F&& f) {
    std::vector<double> nm, values;
    const int steps = static_cast<int>((kFilmLast_nm - kFilmFirst_nm) / step_nm);
    for (int i = 0; i <= steps; ++i) {
        nm.push_back(kFilmFirst_nm + i * step_nm);
        values.push_back(f(nm.back()));
    }
    return Spectrum(nm, values);
}

}  // namespace

int EmissionBasis::add(const Spectrum& spectrum) {
    const auto found = std::find(spectra_.begin(), spectra_.end(), spectrum);
    if (found != spectra_.end()) return static_cast<int>(found - spectra_.begin());
    spectra_.push_back(spectrum);
    return size() - 1;
}

std::vector<FloatLanes> EmissionBasis::at(const bsdf::Wavelengths& wavelengths_nm) const {
    std::vector<FloatLanes> lanes;
    lanes.reserve(spectra_.size());
    for (const Spectrum& spectrum : spectra_) {
        lanes.push_back(
            make_lanes([&](int i) { return static_cast<float>(spectrum(wavelengths_nm[i])); }));
    }
    return lanes;
}

Spectrum unit_illuminant(spectra::Illuminant illuminant) {
    // 5 nm: the step of the CIE's own tables, between which the illuminants are linear.
    const auto power = [&](double nm) { return spectra::illuminant_power(illuminant, nm); };
    const double luminance = film_luminance(tabulate(5, power));
    return tabulate(5, [&](double nm) { return power(nm) / luminance; });
}

std::vector<Spectrum> rec709_light_basis() {
    const Spectrum d65 = unit_illuminant(spectra::Illuminant::D65);
    std::vector<Spectrum> basis;
    for (const Vec3d& primary : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}}) {
        const Spectrum reflectance = spectra::reflectance_from_rec709(primary);
        basis.push_back(tabulate(5, [&](double nm) { return reflectance(nm) * d65(nm); }));
    }
    return basis;
}

std::vector<Spectrum> daylight_basis() {
    constexpr int kCount = 31;
    constexpr double kBasis[3][kCount] = {
        {94.8,  104.8, 105.9, 96.8,  113.9, 125.6, 125.5, 121.3, 121.3, 113.5, 113.1,
         110.8, 106.5, 108.8, 105.3, 104.4, 100.0, 96.0,  95.1,  89.1,  90.5,  90.3,
         88.4,  84.0,  85.1,  81.9,  82.6,  84.9,  81.3,  71.9,  74.3},
        {43.4, 46.3, 43.9,  37.1,  36.7,  35.9,  32.6,  27.9,  24.3, 20.1, 16.2,
         13.2, 8.6,  6.1,   4.2,   1.9,   0.0,   -1.6,  -3.5,  -3.5, -5.8, -7.2,
         -8.6, -9.5, -10.9, -10.7, -12.0, -14.0, -13.6, -12.0, -13.3},
        {-1.1, -0.5, -0.7, -1.2, -2.6, -2.9, -2.8, -2.6, -2.6, -1.8, -1.5,
         -1.3, -1.2, -1.0, -0.5, -0.3, 0.0,  0.2,  0.5,  2.1,  3.2,  4.1,
         4.7,  5.1,  6.7,  7.3,  8.6,  9.8,  10.2, 8.3,  9.6}};
    std::vector<Spectrum> basis;
    for (const auto& row : kBasis) {
        basis.push_back(tabulate(
            10, [&](double nm) { return row[static_cast<int>((nm - kFilmFirst_nm) / 10 + 0.5)]; }));
    }
    return basis;
}

}  // namespace nacre::render
