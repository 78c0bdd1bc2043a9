#include "nacre/measure/sparkle_measurement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <unsupported/Eigen/FFT>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/core/parallel.h"

namespace nacre::measure {
void check(const Viewing& viewing) {
    require_in_range(viewing.distance_mm, 50, 1e5, "viewing distance in mm");
    require_in_range(viewing.illuminance_lx, 1, 2e5, "illuminance in lx");
}

double luminance_cd_m2(const Viewing& viewing, double y) {
    return viewing.illuminance_lx * y / std::numbers::pi;
}

double mm_per_degree(const Viewing& viewing) {
    return viewing.distance_mm * std::numbers::pi / 180;
}

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
    constexpr double kSignalToNoise = 3, kTime_s = 0.1, kMaxField_deg = 12, kMaxCycles = 15;
    constexpr double kQuantumEfficiency = 0.03, kPhotons = 1.2274e6, kNeuralNoise = 3e-8;
    constexpr double kInhibition_per_deg = 7;
    const double d = pupil_diameter_mm(luminance_cd_m2, field_deg);
    const double sigma = eye_blur_deg(d);
    // In trolands, with the Stiles-Crawford effect.
    const double retinal_illuminance = std::numbers::pi * d * d / 4 * luminance_cd_m2 *
                                       (1 - std::pow(d / 9.7, 2) + std::pow(d / 12.4, 4));
    const double optics =
        std::exp(-2 * std::numbers::pi * std::numbers::pi * sigma * sigma * u * u);
    const double per_area = 1 / (field_deg * field_deg) + 1 / (kMaxField_deg * kMaxField_deg) +
                            u * u / (kMaxCycles * kMaxCycles);
    const double inhibition = -std::expm1(-u * u / (kInhibition_per_deg * kInhibition_per_deg));
    const double noise =
        1 / (kQuantumEfficiency * kPhotons * retinal_illuminance) + kNeuralNoise / inhibition;
    return optics / kSignalToNoise / std::sqrt(2 / kTime_s * per_area * noise);
}

double point_threshold_lx(double background_cd_m2) {
    // In the units of the sources: nanolamberts and foot-candles.
    constexpr double kNanolambertsPerNit = std::numbers::pi * 1e5, kLuxPerFootCandle = 10.76391;
    const double b = background_cd_m2 * kNanolambertsPerNit;
    const bool rods = b < 1500;
    const double c = std::pow(10, rods ? -9.80 : -8.35), k = std::pow(10, rods ? -1.90 : -5.90);
    const double root = 1 + std::sqrt(k * b);
    return c * root * root * kLuxPerFootCandle;
}

namespace {

// The eye's Gaussian is cut off at so many standard deviations, which leaves out 6e-5 of it.
constexpr double kReach = 4;
constexpr int kMinPixelsAcross = 16;

// One side of a kernel that adds up to 1 with the other.
std::vector<double> half_gaussian(double sigma_pixels) {
    std::vector<double> kernel(static_cast<std::size_t>(std::ceil(kReach * sigma_pixels)) + 1);
    double sum = 0;
    for (std::size_t i = 0; i < kernel.size(); ++i) {
        const double x = static_cast<double>(i) / sigma_pixels;
        kernel[i] = std::exp(-0.5 * x * x);
        sum += i == 0 ? kernel[i] : 2 * kernel[i];
    }
    for (double& k : kernel) k /= sum;
    return kernel;
}

// At `at`, along one side of the picture.
double blurred(const double* at, std::ptrdiff_t stride, const std::vector<double>& kernel) {
    double sum = kernel[0] * at[0];
    for (std::size_t i = 1; i < kernel.size(); ++i) {
        const auto offset = static_cast<std::ptrdiff_t>(i) * stride;
        sum += kernel[i] * (at[-offset] + at[offset]);
    }
    return sum;
}

// Brighter than its eight neighbours; of equal ones the first.
bool is_peak(const RetinalPicture& picture, int x, int y) {
    const double* const at = &picture.y[static_cast<std::size_t>(y) * picture.width + x];
    const std::ptrdiff_t w = picture.width;
    return at[0] > at[-w - 1] && at[0] > at[-w] && at[0] > at[-w + 1] && at[0] > at[-1] &&
           at[0] >= at[1] && at[0] >= at[w - 1] && at[0] >= at[w] && at[0] >= at[w + 1];
}

void throw_if_stopped(SharedProgress* work) {
    if (work) work->throw_if_stopped("reading the pictures");
}

// Sums over the pixels of a piece of the picture.
enum Sum { kPixels, kAbove, kSpots, kDecades, kSums };
using SpotSums = std::array<double, kSums>;

}  // namespace

RetinalPicture retinal_picture(const PanelPicture& picture, const Viewing& viewing,
                               SharedProgress* work) {
    check(viewing);
    const double per_degree = mm_per_degree(viewing);
    const double adapted_to = luminance_cd_m2(viewing, std::max(0.0, mean_luminance(picture)));
    RetinalPicture seen;
    seen.pixel_mm = picture.pixel_mm;
    seen.blur_mm =
        per_degree * eye_blur_deg(pupil_diameter_mm(adapted_to, kPanelSide_mm / per_degree));
    if (seen.blur_mm < picture.pixel_mm) {
        throw DomainError(fmt::format(
            "from {} mm the eye resolves {:.3g} um, less than a pixel of {:.3g} um: needs smaller "
            "pixels or a larger distance",
            viewing.distance_mm, 1e3 * seen.blur_mm, 1e3 * picture.pixel_mm));
    }
    const std::vector<double> kernel = half_gaussian(seen.blur_mm / picture.pixel_mm);
    const int margin = static_cast<int>(kernel.size()) - 1;
    seen.width = picture.width - 2 * margin;
    seen.height = picture.height - 2 * margin;
    if (seen.width < kMinPixelsAcross || seen.height < kMinPixelsAcross) {
        throw DomainError(
            fmt::format("of a picture of {} x {} pixels the eye's blur of {:.3g} pixels leaves {} "
                        "x {}: must be "
                        "at least {} a side; needs a larger field or a smaller distance",
                        picture.width, picture.height, seen.blur_mm / picture.pixel_mm,
                        std::max(0, seen.width), std::max(0, seen.height), kMinPixelsAcross));
    }
    // Differences from the first pixel, as in mean_luminance(): a uniform picture stays exactly
    // uniform.
    const double first = picture.luminance(0);
    std::vector<double> sharp(picture.pixel_count());
    for (std::size_t p = 0; p < sharp.size(); ++p) sharp[p] = picture.luminance(p) - first;
    const std::size_t from = picture.width, to = seen.width;
    std::vector<double> rows(to * picture.height);
    parallel_for(0, picture.height, [&](std::size_t y) {
        throw_if_stopped(work);
        for (std::size_t x = 0; x < to; ++x) {
            rows[y * to + x] = blurred(&sharp[y * from + x + margin], 1, kernel);
        }
    });
    seen.y.resize(to * seen.height);
    parallel_for(0, seen.height, [&](std::size_t y) {
        throw_if_stopped(work);
        for (std::size_t x = 0; x < to; ++x) {
            seen.y[y * to + x] = first + blurred(&rows[(y + margin) * to + x],
                                                 static_cast<std::ptrdiff_t>(to), kernel);
        }
    });
    seen.point_area_mm2 = picture.pixel_mm * picture.pixel_mm / (kernel[0] * kernel[0]);
    return seen;
}

Background background(const RetinalPicture& picture, const Viewing& viewing) {
    Background background;
    std::vector<double> sorted = picture.y;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    background.y = std::max(0.0, *middle);
    // lux at the eye of a point whose excess of Y times area is 1 mm^2: E / (pi distance^2).
    const double lux_per_mm2 =
        viewing.illuminance_lx / std::numbers::pi / (viewing.distance_mm * viewing.distance_mm);
    background.threshold = point_threshold_lx(luminance_cd_m2(viewing, background.y)) /
                           (lux_per_mm2 * picture.point_area_mm2);
    return background;
}

std::vector<Spot> visible_spots(const RetinalPicture& picture, const Background& background) {
    std::vector<Spot> spots;
    for (int y = 1; y + 1 < picture.height; ++y) {
        for (int x = 1; x + 1 < picture.width; ++x) {
            const double excess =
                picture.y[static_cast<std::size_t>(y) * picture.width + x] - background.y;
            if (excess < background.threshold || !is_peak(picture, x, y)) continue;
            spots.push_back({x, y, excess, excess / background.threshold});
        }
    }
    return spots;
}

Sparkle sparkle(const PanelPicture& picture, const Viewing& viewing, SharedProgress* work) {
    const RetinalPicture seen = retinal_picture(picture, viewing, work);
    Sparkle result;
    result.mean_y = mean_luminance(picture);
    result.pixel_contrast = pixel_contrast(picture, picture);
    result.background = background(seen, viewing);
    result.blur_mm = seen.blur_mm;
    result.area_mm2 = (seen.width - 2) * (seen.height - 2) * seen.pixel_mm * seen.pixel_mm;
    std::array<SpotSums, kPicturePieces> pieces{};
    // Without the edge, where a local maximum is not defined.
    for (int y = 1; y + 1 < seen.height; ++y) {
        for (int x = 1; x + 1 < seen.width; ++x) {
            SpotSums& sums = pieces[piece_of(x, y, seen.width, seen.height)];
            const double excess =
                seen.y[static_cast<std::size_t>(y) * seen.width + x] - result.background.y;
            sums[kPixels] += 1;
            sums[kAbove] += excess >= result.background.threshold ? 1 : 0;
        }
    }
    const std::vector<Spot> spots = visible_spots(seen, result.background);
    for (const Spot& spot : spots) {
        SpotSums& sums = pieces[piece_of(spot.x, spot.y, seen.width, seen.height)];
        sums[kSpots] += 1;
        sums[kDecades] += std::log10(spot.visibility);
    }
    const double pixels_per_cm2 = 100 / (seen.pixel_mm * seen.pixel_mm);
    result.density_per_cm2 = jackknife(
        pieces, [&](const SpotSums& s) { return s[kSpots] / s[kPixels] * pixels_per_cm2; });
    result.sparkle_per_cm2 = jackknife(
        pieces, [&](const SpotSums& s) { return s[kDecades] / s[kPixels] * pixels_per_cm2; });
    result.area_fraction =
        jackknife(pieces, [](const SpotSums& s) { return s[kAbove] / s[kPixels]; });
    if (spots.empty()) {
        // That of a count of one: the jackknife of a count of zero would be zero.
        result.density_per_cm2.standard_error = 100 / result.area_mm2;
    } else {
        // By the error of the mean logarithm, to first order.
        const Estimate decades =
            jackknife(pieces, [](const SpotSums& s) { return s[kDecades] / s[kSpots]; });
        const double mean = std::pow(10, decades.value);
        result.intensity = Estimate{mean, std::numbers::ln10 * mean * decades.standard_error};
        if (result.background.y > 0) {
            const double per_threshold = result.background.threshold / result.background.y;
            result.contrast = Estimate{per_threshold * result.intensity->value,
                                       per_threshold * result.intensity->standard_error};
        }
    }
    return result;
}

namespace {

using Complex = std::complex<double>;

constexpr int kMinSide = 16;

// In place, along rows and then along columns; the inverse divides by the number of pixels.
void transform(std::vector<Complex>& values, int width, int height, bool forward,
               SharedProgress* work) {
    Eigen::FFT<double> fft;
    std::vector<Complex> line, result;
    const auto along = [&](std::size_t first, std::size_t stride, int count) {
        throw_if_stopped(work);
        line.resize(count);
        for (int i = 0; i < count; ++i) line[i] = values[first + stride * i];
        if (forward) {
            fft.fwd(result, line);
        } else {
            fft.inv(result, line);
        }
        for (int i = 0; i < count; ++i) values[first + stride * i] = result[i];
    };
    for (int y = 0; y < height; ++y) along(static_cast<std::size_t>(y) * width, 1, width);
    for (int x = 0; x < width; ++x) along(x, width, height);
}

// The largest length up to this one without prime factors above 7. The steps of a transform per
// value are the sum of the prime factors: minutes in all where a side is a large prime.
int fast_length(int length) {
    for (;; --length) {
        int rest = length;
        for (int prime : {2, 3, 5, 7}) {
            while (rest % prime == 0) rest /= prime;
        }
        if (rest == 1) return length;
    }
}

PanelPicture top_left(const PanelPicture& picture, int width, int height) {
    PanelPicture part{width, height, picture.pixel_mm, {}};
    for (int y = 0; y < height; ++y) {
        const auto row = picture.xyz.begin() + 3 * static_cast<std::ptrdiff_t>(y) * picture.width;
        part.xyz.insert(part.xyz.end(), row, row + 3 * static_cast<std::ptrdiff_t>(width));
    }
    return part;
}

// Cycles per picture of the i-th coefficient.
double cycles(int i, int count) { return i <= count / 2 ? i : i - count; }

}  // namespace

Graininess graininess(const PanelPicture& a, const PanelPicture& b, const Viewing& viewing,
                      SharedProgress* work) {
    check(viewing);
    if (a.width != b.width || a.height != b.height || a.width < kMinSide || a.height < kMinSide) {
        throw DomainError(fmt::format(
            "pictures of {} x {} and {} x {} pixels: must be alike and at least {} a side", a.width,
            a.height, b.width, b.height, kMinSide));
    }
    const int width = fast_length(a.width), height = fast_length(a.height);
    if (width != a.width || height != a.height) {
        return graininess(top_left(a, width, height), top_left(b, width, height), viewing, work);
    }
    Graininess result;
    const double mean_a = mean_luminance(a), mean_b = mean_luminance(b);
    result.mean_y = mean_a + 0.5 * (mean_b - mean_a);
    if (!(mean_a > 0 && mean_b > 0)) return result;
    // Both pictures in one transform, as real and imaginary part: S is real and even.
    std::vector<Complex> filtered(a.pixel_count());
    for (std::size_t p = 0; p < filtered.size(); ++p) {
        filtered[p] = {(a.luminance(p) - mean_a) / mean_a, (b.luminance(p) - mean_b) / mean_b};
    }
    transform(filtered, a.width, a.height, true, work);
    const double per_degree = mm_per_degree(viewing);
    const double luminance = luminance_cd_m2(viewing, result.mean_y);
    for (int y = 0; y < a.height; ++y) {
        throw_if_stopped(work);
        for (int x = 0; x < a.width; ++x) {
            const double u = cycles(x, a.width) / (a.width * a.pixel_mm) * per_degree;
            const double v = cycles(y, a.height) / (a.height * a.pixel_mm) * per_degree;
            filtered[static_cast<std::size_t>(y) * a.width + x] *=
                contrast_sensitivity(std::hypot(u, v), luminance, kPanelSide_mm / per_degree);
        }
    }
    transform(filtered, a.width, a.height, false, work);
    // By Parseval's theorem the sum over frequencies is one over pixels.
    std::array<std::array<double, 2>, kPicturePieces> pieces{};
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            const std::size_t p = static_cast<std::size_t>(y) * a.width + x;
            auto& [pixels, products] = pieces[piece_of(x, y, a.width, a.height)];
            pixels += 1;
            products += filtered[p].real() * filtered[p].imag();
        }
    }
    result.graininess = jackknife(pieces, [](const std::array<double, 2>& sums) {
        const auto [pixels, products] = sums;
        return std::sqrt(std::max(0.0, 2 * products / pixels));
    });
    result.pixel_contrast = pixel_contrast(a, b);
    return result;
}

SparkleMeasurement measure_pictures(const SparkleCamera& camera, const PanelPictures& pictures,
                                    const Viewing& viewing, const Progress& progress) {
    SharedProgress work(progress, 1);
    work.add(0);
    SparkleMeasurement measurement{camera.lamps_deg, {}, {}};
    for (const PanelPicture& picture : pictures.by_lamp) {
        measurement.by_lamp.push_back(sparkle(picture, viewing, &work));
    }
    if (!pictures.diffuse.empty()) {
        measurement.diffuse = graininess(pictures.diffuse[0], pictures.diffuse[1], viewing, &work);
    }
    return measurement;
}

}  // namespace nacre::measure
