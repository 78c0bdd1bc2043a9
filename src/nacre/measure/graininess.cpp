#include "nacre/measure/graininess.h"

#include <fmt/format.h>

#include <algorithm>
#include <complex>
#include <unsupported/Eigen/FFT>
#include <vector>

#include "nacre/core/error.h"

namespace nacre::measure {
namespace {

using Complex = std::complex<double>;

constexpr int kLeastPixels = 16;

// In place, along rows and then along columns; the inverse divides by the number of pixels.
void transform(std::vector<Complex>& values, int width, int height, bool forward) {
    Eigen::FFT<double> fft;
    std::vector<Complex> line, result;
    const auto along = [&](std::size_t first, std::size_t stride, int count) {
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

// The largest length up to this one without prime factors above 7. A transform takes as many steps
// a value as the sum of them: minutes for the whole, where a side is a large prime.
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

struct Sums {
    double pixels = 0, product = 0;

    friend Sums operator+(const Sums& x, const Sums& y) {
        return {x.pixels + y.pixels, x.product + y.product};
    }
    friend Sums operator-(const Sums& x, const Sums& y) {
        return {x.pixels - y.pixels, x.product - y.product};
    }
};

}  // namespace

Graininess graininess(const PanelPicture& a, const PanelPicture& b, const Viewing& viewing) {
    check(viewing);
    if (a.width != b.width || a.height != b.height || a.width < kLeastPixels ||
        a.height < kLeastPixels) {
        throw DomainError(fmt::format(
            "pictures of {} x {} and {} x {} pixels: must be alike and at least {} a side", a.width,
            a.height, b.width, b.height, kLeastPixels));
    }
    const int width = fast_length(a.width), height = fast_length(a.height);
    if (width != a.width || height != a.height) {
        return graininess(top_left(a, width, height), top_left(b, width, height), viewing);
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
    transform(filtered, a.width, a.height, true);
    const double per_degree = mm_per_degree(viewing);
    const double luminance = luminance_cd_m2(viewing, result.mean_y);
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            const double u = cycles(x, a.width) / (a.width * a.pixel_mm) * per_degree;
            const double v = cycles(y, a.height) / (a.height * a.pixel_mm) * per_degree;
            filtered[static_cast<std::size_t>(y) * a.width + x] *=
                contrast_sensitivity(std::hypot(u, v), luminance, kPanelSide_mm / per_degree);
        }
    }
    transform(filtered, a.width, a.height, false);
    // By Parseval's theorem the sum over frequencies is one over pixels.
    std::array<Sums, kPicturePieces> pieces{};
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            const std::size_t p = static_cast<std::size_t>(y) * a.width + x;
            Sums& sums = pieces[piece_of(x, y, a.width, a.height)];
            sums = sums + Sums{1, filtered[p].real() * filtered[p].imag()};
        }
    }
    result.graininess = jackknife(
        pieces, [](const Sums& s) { return std::sqrt(std::max(0.0, 2 * s.product / s.pixels)); });
    result.pixel_contrast = pixel_contrast(a, b);
    return result;
}

}  // namespace nacre::measure
