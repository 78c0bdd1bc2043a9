#include "nacre/measure/sparkle_scale.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/core/parallel.h"

namespace nacre::measure {
namespace {

// Beyond so many standard deviations the eye's Gaussian is cut off; it holds all but 6e-5 of it.
constexpr double kReach = 4;
constexpr int kLeastPixels = 16;

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

struct Sums {
    double pixels = 0, above = 0, spots = 0, decades = 0;

    friend Sums operator+(const Sums& a, const Sums& b) {
        return {a.pixels + b.pixels, a.above + b.above, a.spots + b.spots, a.decades + b.decades};
    }
    friend Sums operator-(const Sums& a, const Sums& b) {
        return {a.pixels - b.pixels, a.above - b.above, a.spots - b.spots, a.decades - b.decades};
    }
};

}  // namespace

RetinalPicture retinal_picture(const PanelPicture& picture, const Viewing& viewing) {
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
    if (seen.width < kLeastPixels || seen.height < kLeastPixels) {
        throw DomainError(
            fmt::format("of a picture of {} x {} pixels the eye's blur of {:.3g} pixels leaves {} "
                        "x {}: must be "
                        "at least {} a side; needs a larger field or a smaller distance",
                        picture.width, picture.height, seen.blur_mm / picture.pixel_mm,
                        std::max(0, seen.width), std::max(0, seen.height), kLeastPixels));
    }
    // About the first pixel, as in mean_luminance(): an even picture stays even to the last bit.
    const double first = picture.luminance(0);
    std::vector<double> sharp(picture.pixel_count());
    for (std::size_t p = 0; p < sharp.size(); ++p) sharp[p] = picture.luminance(p) - first;
    const std::size_t from = picture.width, to = seen.width;
    std::vector<double> rows(to * picture.height);
    parallel_for(0, picture.height, [&](std::size_t y) {
        for (std::size_t x = 0; x < to; ++x) {
            rows[y * to + x] = blurred(&sharp[y * from + x + margin], 1, kernel);
        }
    });
    seen.y.resize(to * seen.height);
    parallel_for(0, seen.height, [&](std::size_t y) {
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
    // A point whose excess of Y times area is 1 mm^2 sends E/pi candela per mm^2 of distance.
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

Sparkle sparkle(const PanelPicture& picture, const Viewing& viewing) {
    const RetinalPicture seen = retinal_picture(picture, viewing);
    Sparkle result;
    result.mean_y = mean_luminance(picture);
    result.pixel_contrast = pixel_contrast(picture, picture);
    result.background = background(seen, viewing);
    result.blur_mm = seen.blur_mm;
    result.area_mm2 = (seen.width - 2) * (seen.height - 2) * seen.pixel_mm * seen.pixel_mm;
    std::array<Sums, kPicturePieces> pieces{};
    // Where a maximum can be told from a slope: not along the edge.
    for (int y = 1; y + 1 < seen.height; ++y) {
        for (int x = 1; x + 1 < seen.width; ++x) {
            Sums& sums = pieces[piece_of(x, y, seen.width, seen.height)];
            const double excess =
                seen.y[static_cast<std::size_t>(y) * seen.width + x] - result.background.y;
            sums.pixels += 1;
            sums.above += excess >= result.background.threshold ? 1 : 0;
        }
    }
    const std::vector<Spot> spots = visible_spots(seen, result.background);
    for (const Spot& spot : spots) {
        Sums& sums = pieces[piece_of(spot.x, spot.y, seen.width, seen.height)];
        sums.spots += 1;
        sums.decades += std::log10(spot.visibility);
    }
    const double pixels_per_cm2 = 100 / (seen.pixel_mm * seen.pixel_mm);
    result.density_per_cm2 =
        jackknife(pieces, [&](const Sums& s) { return s.spots / s.pixels * pixels_per_cm2; });
    result.sparkle_per_cm2 =
        jackknife(pieces, [&](const Sums& s) { return s.decades / s.pixels * pixels_per_cm2; });
    result.area_share = jackknife(pieces, [](const Sums& s) { return s.above / s.pixels; });
    if (spots.empty()) {
        // As if there had been one: that none was met does not say that there are none.
        result.density_per_cm2.standard_error = 100 / result.area_mm2;
    } else {
        // The error of the logarithm, carried over: that of few spots stays sound.
        const Estimate decades =
            jackknife(pieces, [](const Sums& s) { return s.decades / s.spots; });
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

}  // namespace nacre::measure
