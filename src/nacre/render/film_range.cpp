#include "nacre/render/film_range.h"

#include <cmath>

#include "nacre/spectra/colour.h"

namespace nacre::render {
namespace {

constexpr double kLaneSpacingNm = (kFilmLastNm - kFilmFirstNm) / kLanes;

/// Int f(lambda) y_bar(lambda) d lambda over the film's range, trapezoidal in 1 nm steps.
template <class F>
double integrate_with_luminosity(F&& f) {
    double sum = 0;
    const int steps = static_cast<int>(kFilmLastNm - kFilmFirstNm);
    for (int i = 0; i <= steps; ++i) {
        const double nm = kFilmFirstNm + i;
        const double end = i == 0 || i == steps ? 0.5 : 1.0;
        sum += end * f(nm) * spectra::colour_matching(spectra::Observer::cie1931_2deg, nm)[1];
    }
    return sum;
}

double luminosity_integral() {
    static const double integral = integrate_with_luminosity([](double) { return 1.0; });
    return integral;
}

}  // namespace

bsdf::Wavelengths film_wavelengths(std::uint32_t sample_index) {
    constexpr double kGoldenRatio = 0.61803398874989484820;  // (sqrt(5) - 1) / 2
    double whole;
    const double offset = std::modf(0.5 + sample_index * kGoldenRatio, &whole);
    bsdf::Wavelengths nm;
    for (int i = 0; i < kLanes; ++i) nm[i] = kFilmFirstNm + (i + offset) * kLaneSpacingNm;
    return nm;
}

XyzWeights film_xyz_weights(const bsdf::Wavelengths& wavelengths_nm) {
    XyzWeights weights;
    for (int i = 0; i < kLanes; ++i) {
        const auto xyz =
            spectra::colour_matching(spectra::Observer::cie1931_2deg, wavelengths_nm[i]);
        for (int c = 0; c < 3; ++c) {
            weights[c][i] = static_cast<float>(xyz[c] * kLaneSpacingNm / luminosity_integral());
        }
    }
    return weights;
}

double film_luminance(const spectra::Spectrum& radiance) {
    return integrate_with_luminosity([&](double nm) { return radiance(nm); }) /
           luminosity_integral();
}

}  // namespace nacre::render
