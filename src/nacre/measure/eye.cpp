#include "nacre/measure/eye.h"

#include <cmath>
#include <numbers>

#include "nacre/core/error.h"

namespace nacre::measure {
namespace {

constexpr double kPi = std::numbers::pi;

}  // namespace

void check(const Viewing& viewing) {
    require_in_range(viewing.distance_mm, 50, 1e5, "viewing distance in mm");
    require_in_range(viewing.illuminance_lx, 1, 2e5, "illuminance in lx");
}

double luminance_cd_m2(const Viewing& viewing, double y) {
    return viewing.illuminance_lx * y / kPi;
}

double mm_per_degree(const Viewing& viewing) { return viewing.distance_mm * kPi / 180; }

double pupil_diameter_mm(double luminance_cd_m2, double field_deg) {
    // The logarithm of 0 is minus infinity, of which the hyperbolic tangent is -1: a pupil of 8 mm.
    return 5 - 3 * std::tanh(0.4 * std::log10(luminance_cd_m2 * field_deg * field_deg / (40 * 40)));
}

double eye_blur_deg(double pupil_mm) {
    constexpr double kWidth_arcmin = 0.5, kAberration_arcmin_per_mm = 0.08;
    return std::hypot(kWidth_arcmin, kAberration_arcmin_per_mm * pupil_mm) / 60;
}

double contrast_sensitivity(double u, double luminance_cd_m2, double field_deg) {
    if (!(u > 0) || !(luminance_cd_m2 > 0)) return 0;
    // Typical values of [barten-1999, chapter 3]: signal-to-noise ratio, time and angles of
    // integration, quantum efficiency, photons (per s, deg^2 and troland) of a white display,
    // noise of the neurons, and the frequency up to which lateral inhibition works.
    constexpr double kSignalToNoise = 3, kTime_s = 0.1, kLargestField_deg = 12, kMostCycles = 15;
    constexpr double kQuantumEfficiency = 0.03, kPhotons = 1.2274e6, kNeuralNoise = 3e-8;
    constexpr double kInhibition_per_deg = 7;
    const double d = pupil_diameter_mm(luminance_cd_m2, field_deg);
    const double sigma = eye_blur_deg(d);
    // In trolands, with the Stiles-Crawford effect.
    const double retinal_illuminance =
        kPi * d * d / 4 * luminance_cd_m2 * (1 - std::pow(d / 9.7, 2) + std::pow(d / 12.4, 4));
    const double optics = std::exp(-2 * kPi * kPi * sigma * sigma * u * u);
    const double per_area = 1 / (field_deg * field_deg) +
                            1 / (kLargestField_deg * kLargestField_deg) +
                            u * u / (kMostCycles * kMostCycles);
    const double inhibition = -std::expm1(-u * u / (kInhibition_per_deg * kInhibition_per_deg));
    const double noise =
        1 / (kQuantumEfficiency * kPhotons * retinal_illuminance) + kNeuralNoise / inhibition;
    return optics / kSignalToNoise / std::sqrt(2 / kTime_s * per_area * noise);
}

double point_threshold_lx(double background_cd_m2) {
    // In the units of the sources: nanolamberts and foot-candles.
    constexpr double kNanolambertsPerNit = kPi * 1e5, kLuxPerFootCandle = 10.76391;
    const double b = background_cd_m2 * kNanolambertsPerNit;
    const bool rods = b < 1500;
    const double c = std::pow(10, rods ? -9.80 : -8.35), k = std::pow(10, rods ? -1.90 : -5.90);
    const double root = 1 + std::sqrt(k * b);
    return c * root * root * kLuxPerFootCandle;
}

}  // namespace nacre::measure
