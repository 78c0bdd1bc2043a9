#include "nacre/measure/panel_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "nacre/core/error.h"

namespace nacre::measure {
namespace {

// Summed as differences from the first pixel, so that a uniform picture has its value exactly.
double mean_of(const std::vector<double>& y) {
    if (y.empty()) return 0;
    double sum = 0;
    for (const double value : y) sum += value - y.front();
    return y.front() + sum / static_cast<double>(y.size());
}

LuminancePicture luminance_of(const PanelPicture& picture) {
    LuminancePicture result{picture.width, picture.height, {}};
    for (std::size_t p = 0; p < picture.pixel_count(); ++p) {
        result.y.push_back(picture.luminance(p));
    }
    return result;
}

void require_alike(const LuminancePicture& a, const LuminancePicture& b) {
    if (a.width != b.width || a.height != b.height || a.width < kPiecesAcross ||
        a.height < kPiecesAcross) {
        throw DomainError(fmt::format(
            "pictures of {} x {} and {} x {} pixels: must be alike and at least {} a side", a.width,
            a.height, b.width, b.height, kPiecesAcross));
    }
}

}  // namespace

double mean_luminance(const PanelPicture& picture) { return mean_of(luminance_of(picture).y); }

Estimate mean_luminance(const LuminancePicture& a, const LuminancePicture& b) {
    require_alike(a, b);
    using Sums = std::array<double, 3>;  // number of pixels, sums of their Y in a and b
    std::array<Sums, kPicturePieces> pieces{};
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            const std::size_t p = static_cast<std::size_t>(y) * a.width + x;
            Sums& sums = pieces[piece_of(x, y, a.width, a.height)];
            sums[0] += 1;
            sums[1] += a.y[p];
            sums[2] += b.y[p];
        }
    }
    return jackknife(pieces, [](const Sums& s) { return 0.5 * (s[1] + s[2]) / s[0]; });
}

Estimate pixel_contrast(const PanelPicture& a, const PanelPicture& b) {
    return pixel_contrast(luminance_of(a), luminance_of(b));
}

Estimate pixel_contrast(const LuminancePicture& a, const LuminancePicture& b) {
    require_alike(a, b);
    const double mean_a = mean_of(a.y), mean_b = mean_of(b.y);
    if (!(mean_a > 0 && mean_b > 0)) return {};
    // Number of pixels, sums of their relative deviations in a and b, and of the products of these.
    using Sums = std::array<double, 4>;
    std::array<Sums, kPicturePieces> pieces{};
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            const std::size_t p = static_cast<std::size_t>(y) * a.width + x;
            const double da = a.y[p] / mean_a - 1, db = b.y[p] / mean_b - 1;
            Sums& sums = pieces[piece_of(x, y, a.width, a.height)];
            sums[0] += 1;
            sums[1] += da;
            sums[2] += db;
            sums[3] += da * db;
        }
    }
    return jackknife(pieces, [](const Sums& sums) {
        // Deviations are from the mean of all pixels: where pieces are left out, theirs differs.
        const double a = sums[1] / sums[0], b = sums[2] / sums[0];
        return std::sqrt(std::max(0.0, (sums[3] / sums[0] - a * b) / ((1 + a) * (1 + b))));
    });
}

}  // namespace nacre::measure
