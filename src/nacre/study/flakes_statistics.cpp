#include "nacre/study/flakes_statistics.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "nacre/core/error.h"
#include "nacre/spectra/lab.h"
#include "nacre/spectra/rgb.h"

namespace nacre::study {
namespace {

constexpr int kPiecesAcross = 4;
constexpr int kPieces = kPiecesAcross * kPiecesAcross;

struct Sums {
    double n = 0, a = 0, b = 0, ab = 0;

    friend Sums operator+(const Sums& x, const Sums& y) {
        return {x.n + y.n, x.a + y.a, x.b + y.b, x.ab + y.ab};
    }
    friend Sums operator-(const Sums& x, const Sums& y) {
        return {x.n - y.n, x.a - y.a, x.b - y.b, x.ab - y.ab};
    }
};

/// Sums over each piece of the picture.
std::array<Sums, kPieces> sum_pieces(const Pixels& a, const Pixels& b) {
    if (a.width != b.width || a.height != b.height || a.width < kPiecesAcross ||
        a.height < kPiecesAcross) {
        throw DomainError(
            fmt::format("pictures of {} x {} and {} x {} pixels: must be alike and at least {} a "
                        "side",
                        a.width, a.height, b.width, b.height, kPiecesAcross));
    }
    const auto y_a = luminance(a), y_b = luminance(b);
    std::array<Sums, kPieces> sums{};
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width; ++x) {
            const int piece =
                y * kPiecesAcross / a.height * kPiecesAcross + x * kPiecesAcross / a.width;
            const std::size_t p = static_cast<std::size_t>(y) * a.width + x;
            Sums& s = sums[piece];
            s.n += 1;
            s.a += y_a[p];
            s.b += y_b[p];
            s.ab += y_a[p] * y_b[p];
        }
    }
    return sums;
}

/// A statistic of the sums over all pieces, with the jackknife's error.
template <class Statistic>
Measured jackknife(const std::array<Sums, kPieces>& pieces, Statistic&& statistic) {
    Sums total;
    for (const Sums& s : pieces) total = total + s;
    std::array<double, kPieces> values;
    double mean = 0, variance = 0;
    for (int i = 0; i < kPieces; ++i) {
        values[i] = statistic(total - pieces[i]);
        mean += values[i] / kPieces;
    }
    for (double value : values) variance += (value - mean) * (value - mean) / kPieces;
    return {statistic(total), std::sqrt((kPieces - 1) * variance)};
}

// Steps of the histogram: three in each factor of two, over a factor of 2^12.
constexpr int kStepsPerOctave = 3, kOctavesBelow = 7, kOctavesAbove = 5;

}  // namespace

std::vector<double> luminance(const Pixels& picture) {
    std::vector<double> y(picture.rgb.size() / 3);
    for (std::size_t p = 0; p < y.size(); ++p) {
        const float* c = &picture.rgb[3 * p];
        y[p] = spectra::linear_rec709_to_xyz({c[0], c[1], c[2]})[1];
    }
    return y;
}

Measured mean_luminance(const Pixels& a, const Pixels& b) {
    return jackknife(sum_pieces(a, b), [](const Sums& s) { return 0.5 * (s.a + s.b) / s.n; });
}

Measured contrast(const Pixels& a, const Pixels& b) {
    return jackknife(sum_pieces(a, b), [](const Sums& s) {
        const double mean_a = s.a / s.n, mean_b = s.b / s.n, product = mean_a * mean_b;
        // An unlit picture has none.
        return product > 0 ? std::sqrt(std::max(0.0, s.ab / s.n / product - 1)) : 0.0;
    });
}

Histogram histogram(const Pixels& picture) {
    constexpr int kSteps = kStepsPerOctave * (kOctavesBelow + kOctavesAbove);
    const auto y = luminance(picture);
    double mean = 0;
    for (double v : y) mean += v / static_cast<double>(y.size());
    Histogram h;
    h.share.resize(kSteps);
    for (int i = 0; i < kSteps; ++i)
        h.centre.push_back(std::exp2((i + 0.5) / kStepsPerOctave - kOctavesBelow));
    for (double v : y) {
        const double octaves = std::log2(std::max(v, 1e-30 * mean) / mean);
        const double step = std::floor((octaves + kOctavesBelow) * kStepsPerOctave);
        h.share[static_cast<int>(std::clamp(step, 0.0, kSteps - 1.0))] +=
            1 / static_cast<double>(y.size());
    }
    return h;
}

ColourSpread colour_spread(const Pixels& picture, double mean_luminance) {
    constexpr double kShown = 0.3;
    const double scale = kShown / mean_luminance;
    const spectra::Vec3 white = spectra::linear_rec709_to_xyz({1, 1, 1});
    const auto lab = [&](double r, double g, double b) {
        return spectra::xyz_to_lab(spectra::linear_rec709_to_xyz({scale * r, scale * g, scale * b}),
                                   white);
    };
    ColourSpread spread;
    const std::size_t count = picture.rgb.size() / 3;
    const double n = static_cast<double>(count);
    double rgb[3] = {}, a = 0, b = 0, aa = 0, bb = 0;
    for (std::size_t p = 0; p < count; ++p) {
        const float* c = &picture.rgb[3 * p];
        for (int i = 0; i < 3; ++i) rgb[i] += c[i] / n;
        const auto colour = lab(c[0], c[1], c[2]);
        spread.ab.push_back({colour[1], colour[2]});
        a += colour[1] / n;
        b += colour[2] / n;
        aa += colour[1] * colour[1] / n;
        bb += colour[2] * colour[2] / n;
    }
    spread.mean_lab = lab(rgb[0], rgb[1], rgb[2]);
    spread.a_deviation = std::sqrt(std::max(0.0, aa - a * a));
    spread.b_deviation = std::sqrt(std::max(0.0, bb - b * b));
    return spread;
}

}  // namespace nacre::study
