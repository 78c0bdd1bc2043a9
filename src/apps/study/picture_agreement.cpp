#include "apps/study/picture_agreement.h"

#include <algorithm>
#include <cmath>

#include "nacre/core/error.h"
#include "nacre/core/estimate.h"
#include "nacre/spectra/rgb.h"

namespace nacre::study {
namespace {

struct Moments {
    double mean, variance_of_mean;
};

template <class Value>
Moments moments(std::size_t count, Value&& value) {
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < count; ++i) sum += value(i);
    const double mean = sum / static_cast<double>(count);
    for (std::size_t i = 0; i < count; ++i) squares += (value(i) - mean) * (value(i) - mean);
    const auto n = static_cast<double>(count);
    return {mean, squares / (n - 1) / n};
}

/// Luminance per pixel of each batch.
std::vector<std::vector<double>> luminances(const std::vector<io::Image>& batches,
                                            std::size_t pixels) {
    std::vector<std::vector<double>> out;
    for (const io::Image& image : batches) {
        if (image.pixel_count() != pixels) throw DomainError("batches differ in size");
        const std::vector<float> rgb = io::interleaved_rgb(image, "batch");
        auto& y = out.emplace_back(pixels);
        for (std::size_t i = 0; i < pixels; ++i) {
            y[i] = spectra::rec709_luminance<double>(rgb[3 * i], rgb[3 * i + 1], rgb[3 * i + 2]);
        }
    }
    return out;
}

}  // namespace

PictureAgreement picture_agreement(const std::vector<io::Image>& a,
                                   const std::vector<io::Image>& b) {
    require_in_range(static_cast<double>(a.size()), 4, 1e6, "batches");
    if (a.size() != b.size())
        throw DomainError("the two pictures have different numbers of batches");
    const std::size_t batches = a.size(), pixels = a.front().pixel_count();
    const auto ya = luminances(a, pixels), yb = luminances(b, pixels);

    PictureAgreement out;
    double square_sum = 0;
    int above = 0;
    for (std::size_t p = 0; p < pixels; ++p) {
        const Moments ma = moments(batches, [&](std::size_t i) { return ya[i][p]; });
        const Moments mb = moments(batches, [&](std::size_t i) { return yb[i][p]; });
        const double variance = ma.variance_of_mean + mb.variance_of_mean;
        // Beside the object both pictures show the same background without noise.
        const double scale = std::max(std::abs(ma.mean), std::abs(mb.mean));
        if (variance <= 1e-12 * scale * scale) continue;
        const double z2 = (ma.mean - mb.mean) * (ma.mean - mb.mean) / variance;
        square_sum += z2;
        above += z2 > 9;
        ++out.pixels;
    }
    // Welch's statistic has between n - 1 degrees of freedom (all noise in one picture) and 2 n - 2
    // (the same noise in both); expectations are those of the smaller number.
    const auto nu = static_cast<double>(batches - 1);
    out.expected_mean_square_z = nu / (nu - 2);
    out.expected_fraction_above_3 = student_two_sided(3, nu);
    if (out.pixels > 0) {
        out.mean_square_z = square_sum / out.pixels;
        out.fraction_above_3 = static_cast<double>(above) / out.pixels;
    }
    const auto whole = [&](const std::vector<std::vector<double>>& y) {
        return moments(batches, [&](std::size_t i) {
            double sum = 0;
            for (double v : y[i]) sum += v;
            return sum / static_cast<double>(pixels);
        });
    };
    const Moments wa = whole(ya), wb = whole(yb);
    if (wb.mean != 0) {
        out.relative_difference = (wa.mean - wb.mean) / wb.mean;
        out.relative_standard_error =
            std::sqrt(wa.variance_of_mean + wb.variance_of_mean) / std::abs(wb.mean);
    }
    return out;
}

}  // namespace nacre::study
