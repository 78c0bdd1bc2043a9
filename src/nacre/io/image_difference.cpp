#include "nacre/io/image_difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "nacre/core/error.h"
#include "nacre/core/parallel.h"
#include "nacre/spectra/colour.h"

namespace nacre::io {

namespace {

constexpr std::size_t kPixelsPerPiece = 4096;

Vec3d lab_of(const float* rgb) {
    static const Vec3d white = spectra::linear_rec709_to_xyz({1, 1, 1});
    return spectra::xyz_to_lab(spectra::linear_rec709_to_xyz({rgb[0], rgb[1], rgb[2]}), white);
}

std::vector<float> finite_rgb(const Image& image, const std::string& name) {
    std::vector<float> rgb = interleaved_rgb(image, name);
    const auto bad =
        std::count_if(rgb.begin(), rgb.end(), [](float v) { return !std::isfinite(v); });
    if (bad > 0) throw InputError(fmt::format("{}: {} values are not finite", name, bad));
    return rgb;
}

/// The value below which the given fraction of the values lies.
double quantile(std::vector<float> values, double fraction) {
    const auto at = values.begin() +
                    static_cast<std::ptrdiff_t>(fraction * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

}  // namespace

ImageDifference image_difference(const Image& a, const Image& b, const std::string& name_a,
                                 const std::string& name_b) {
    if (a.width != b.width || a.height != b.height) {
        throw InputError(fmt::format("{} has {} x {} pixels, {} has {} x {}: must be equal", name_a,
                                     a.width, a.height, name_b, b.width, b.height));
    }
    const std::vector<float> rgb_a = finite_rgb(a, name_a), rgb_b = finite_rgb(b, name_b);
    const std::size_t pixels = a.pixel_count();

    std::vector<float> delta_e(pixels);
    parallel_for_ranges(0, pixels, kPixelsPerPiece, [&](std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) {
            delta_e[i] = static_cast<float>(
                spectra::delta_e_2000(lab_of(&rgb_a[3 * i]), lab_of(&rgb_b[3 * i])));
        }
    });

    ImageDifference result;
    std::vector<float> signed_difference[3];
    for (auto& channel : signed_difference) channel.resize(pixels);
    double square = 0, relative = 0;
    for (std::size_t i = 0; i < 3 * pixels; ++i) {
        const double difference = static_cast<double>(rgb_a[i]) - rgb_b[i];
        square += difference * difference;
        relative += std::abs(difference) / (std::abs(rgb_b[i]) + ImageDifference::kDarkest);
        signed_difference[i % 3][i / 3] = static_cast<float>(difference);
    }
    const double values = 3.0 * static_cast<double>(pixels);
    result.mean_square_error = square / values;
    result.psnr_db = -10 * std::log10(result.mean_square_error);
    result.relative_error = relative / values;
    result.delta_e_mean =
        std::accumulate(delta_e.begin(), delta_e.end(), 0.0) / static_cast<double>(pixels);
    result.delta_e_95th = quantile(delta_e, 0.95);
    result.delta_e_max = *std::max_element(delta_e.begin(), delta_e.end());
    result.picture = {a.width,
                      a.height,
                      {{"R", std::move(signed_difference[0])},
                       {"G", std::move(signed_difference[1])},
                       {"B", std::move(signed_difference[2])},
                       {"deltaE2000", std::move(delta_e)}},
                      {}};
    return result;
}

Image difference_heat_map(const ImageDifference& difference, double full_scale) {
    Image map = difference.picture;
    const std::vector<float> delta_e = map.channels.back().pixels;
    map.channels.pop_back();
    for (std::size_t c = 0; c < 3; ++c) {
        for (std::size_t i = 0; i < delta_e.size(); ++i) {
            // A third of the scale for each primary: red, then green on top, then blue.
            const double level = 3 * delta_e[i] / full_scale - static_cast<double>(c);
            map.channels[c].pixels[i] =
                static_cast<float>(spectra::srgb_decode(std::clamp(level, 0.0, 1.0)));
        }
    }
    return map;
}

}  // namespace nacre::io
