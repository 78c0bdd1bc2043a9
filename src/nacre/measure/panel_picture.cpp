#include "nacre/measure/panel_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "nacre/core/error.h"

namespace nacre::measure {
namespace {

// Deviations from the mean, relative to it.
struct DeviationSums {
    double pixels = 0, a = 0, b = 0, ab = 0;

    friend DeviationSums operator+(const DeviationSums& x, const DeviationSums& y) {
        return {x.pixels + y.pixels, x.a + y.a, x.b + y.b, x.ab + y.ab};
    }
    friend DeviationSums operator-(const DeviationSums& x, const DeviationSums& y) {
        return {x.pixels - y.pixels, x.a - y.a, x.b - y.b, x.ab - y.ab};
    }
};

}  // namespace

double mean_luminance(const PanelPicture& picture) {
    // About the first pixel, so that an even picture has its own value, not that of a rounded sum.
    const std::size_t count = picture.pixel_count();
    if (count == 0) return 0;
    const double first = picture.luminance(0);
    double sum = 0;
    for (std::size_t p = 0; p < count; ++p) sum += picture.luminance(p) - first;
    return first + sum / static_cast<double>(count);
}

Estimate pixel_contrast(const PanelPicture& a, const PanelPicture& b) {
    if (a.width != b.width || a.height != b.height || a.width < kPiecesAcross ||
        a.height < kPiecesAcross) {
        throw DomainError(fmt::format(
            "pictures of {} x {} and {} x {} pixels: must be alike and at least {} a side", a.width,
            a.height, b.width, b.height, kPiecesAcross));
    }
    const double mean_a = mean_luminance(a), mean_b = mean_luminance(b);
    if (!(mean_a > 0 && mean_b > 0)) return {};
    std::array<DeviationSums, kPicturePieces> pieces{};
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            const std::size_t p = static_cast<std::size_t>(y) * a.width + x;
            const double da = a.luminance(p) / mean_a - 1, db = b.luminance(p) / mean_b - 1;
            DeviationSums& sums = pieces[piece_of(x, y, a.width, a.height)];
            sums = sums + DeviationSums{1, da, db, da * db};
        }
    }
    return jackknife(pieces, [](const DeviationSums& s) {
        // Deviations are from the mean of all pixels: where pieces are left out, theirs differs.
        const double a = s.a / s.pixels, b = s.b / s.pixels;
        return std::sqrt(std::max(0.0, (s.ab / s.pixels - a * b) / ((1 + a) * (1 + b))));
    });
}

}  // namespace nacre::measure
