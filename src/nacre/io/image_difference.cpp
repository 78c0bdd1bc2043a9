#include "nacre/io/image_difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "nacre/core/error.h"
#include "nacre/core/estimate.h"
#include "nacre/core/parallel.h"
#include "nacre/core/text.h"
#include "nacre/spectra/colour.h"

namespace nacre::io {

namespace {

constexpr std::size_t kPixelsPerPiece = 4096;

Vec3d lab_of(const float* rgb) { return spectra::linear_rec709_to_lab({rgb[0], rgb[1], rgb[2]}); }

std::vector<float> finite_rgb(const Image& image, const std::string& name) {
    std::vector<float> rgb = interleaved_rgb(image, name);
    const auto bad =
        std::count_if(rgb.begin(), rgb.end(), [](float v) { return !std::isfinite(v); });
    if (bad > 0) throw InputError(fmt::format("{}: {} values are not finite", name, bad));
    return rgb;
}

void require_same_size(const Image& a, const Image& b, const std::string& name_a,
                       const std::string& name_b) {
    if (a.width != b.width || a.height != b.height) {
        throw InputError(fmt::format("{} has {} x {} pixels, {} has {} x {}: must be equal", name_a,
                                     a.width, a.height, name_b, b.width, b.height));
    }
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
    require_same_size(a, b, name_a, name_b);
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

std::string standard_error_channel(const std::string& name) { return "stderr." + name; }

namespace {

/// Student's degrees of freedom of a picture's standard errors; infinite if it does not tell.
double degrees_of_freedom(const Image& image, const std::string& name) {
    const auto found = image.metadata.find(kBatchesKey);
    if (found == image.metadata.end()) return std::numeric_limits<double>::infinity();
    const auto batches = parse_number(found->second);
    if (!batches || *batches < 2 || *batches != std::floor(*batches)) {
        throw InputError(fmt::format("{}: {} = {}: must be a whole number >= 2", name, kBatchesKey,
                                     found->second));
    }
    return *batches - 1;
}

}  // namespace

std::optional<ImageZScores> image_z_scores(const Image& a, const Image& b,
                                           const std::string& name_a, const std::string& name_b) {
    require_same_size(a, b, name_a, name_b);
    ImageZScores z;
    double square = 0, above = 0, sum = 0, variance_of_sum = 0;
    for (const Channel& channel : a.channels) {
        const Channel* other = b.find(channel.name);
        const std::string error_name = standard_error_channel(channel.name);
        const Channel *error_a = a.find(error_name), *error_b = b.find(error_name);
        if (!other || (!error_a && !error_b)) continue;
        z.has_error_a |= error_a != nullptr;
        z.has_error_b |= error_b != nullptr;
        z.channels.push_back(channel.name);
        for (std::size_t i = 0; i < channel.pixels.size(); ++i) {
            const double va = channel.pixels[i], vb = other->pixels[i];
            const double error =
                std::hypot(error_a ? error_a->pixels[i] : 0.0, error_b ? error_b->pixels[i] : 0.0);
            const double rounding = ImageZScores::kRounding * std::max(std::abs(va), std::abs(vb));
            if (!(error > 0.1 * rounding) || !std::isfinite(error)) {
                z.unexplained += !(std::abs(va - vb) <= rounding);
                continue;
            }
            const double score = (va - vb) / error;
            square += score * score;
            above += std::abs(score) > 3;
            ++z.values;
            if (z.channels.size() > 3) continue;
            sum += va - vb;
            variance_of_sum += error * error;
        }
    }
    if (z.channels.empty()) return std::nullopt;
    const double nu = std::min(z.has_error_a ? degrees_of_freedom(a, name_a) : 1e300,
                               z.has_error_b ? degrees_of_freedom(b, name_b) : 1e300);
    constexpr double kNearlyNormal = 1e4;
    z.expected_mean_square = nu > 2 ? (nu < kNearlyNormal ? nu / (nu - 2) : 1.0)
                                    : std::numeric_limits<double>::infinity();
    z.expected_fraction_above_3 = student_two_sided(3, std::min(nu, kNearlyNormal));
    if (z.values > 0) {
        z.mean_square = square / static_cast<double>(z.values);
        z.fraction_above_3 = above / static_cast<double>(z.values);
        if (variance_of_sum > 0) z.of_mean = sum / std::sqrt(variance_of_sum);
    }
    return z;
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
