#include "nacre/fit/sampled_spread.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "nacre/core/parallel.h"
#include "nacre/core/random.h"
#include "nacre/fit/first_order.h"

namespace nacre::fit {
namespace {

/// Two of a normal law with standard deviation 1, by Box and Muller's transform.
std::array<double, 2> normal_pair(Rng& rng) {
    const double radius = std::sqrt(-2 * std::log(1 - rng.uniform_double()));
    const double angle = 2 * std::numbers::pi * rng.uniform_double();
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

constexpr int kMaxRedraws = 1000;  // of one sample
constexpr std::size_t kSamplesAtOnce = 256;

/// A sum over samples of a change, and of its square, by reading.
void add_change(Values& sums, std::size_t r, double d) {
    sums[2 * r] += d;
    sums[2 * r + 1] += d * d;
}

struct Draw {
    std::optional<Values> values;
    int redrawn = 0;
};

/// One paint whose numbers are drawn from their laws, from a stream of its own.
Draw draw_paint(UncertainPaint& paint, std::uint64_t seed, std::size_t sample) {
    Rng rng(seed, sample);
    Draw draw;
    std::vector<double> z(paint.numbers().size()), point;
    for (; draw.redrawn < kMaxRedraws; ++draw.redrawn) {
        for (std::size_t i = 0; i < z.size(); i += 2) {
            const auto [first, second] = normal_pair(rng);
            z[i] = first;
            if (i + 1 < z.size()) z[i + 1] = second;
        }
        point = paint.correlated(z);
        if (paint.is_valid(point)) break;
    }
    if (draw.redrawn == kMaxRedraws) return draw;
    if (auto read = paint.evaluate(point, nullptr)) draw.values = std::move(read->values);
    return draw;
}

}  // namespace

SampledSums::SampledSums(const ValueLayout& layout)
    : layout_(layout),
      sum_(layout.size()),
      squares_(layout.size()),
      products_(3 * layout.readings),
      chroma_(2 * layout.readings),
      hue_(2 * layout.readings) {}

void SampledSums::add(const Values& centre, const Values& values) {
    ++count_;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double d = values[i] - centre[i];
        sum_[i] += d;
        squares_[i] += d * d;
    }
    for (std::size_t r = 0; r < layout_.readings; ++r) {
        const std::size_t at = layout_.lab(r);
        const auto d = [&](std::size_t c) { return values[at + c] - centre[at + c]; };
        products_[3 * r] += d(0) * d(1);
        products_[3 * r + 1] += d(0) * d(2);
        products_[3 * r + 2] += d(1) * d(2);
        const Vec3d here{values[at], values[at + 1], values[at + 2]};
        const Vec3d there{centre[at], centre[at + 1], centre[at + 2]};
        add_change(chroma_, r, measure::chroma(here) - measure::chroma(there));
        add_change(hue_, r, hue_between_deg(there, here));
    }
}

double SampledSums::deviation(std::size_t i) const {
    return std::sqrt(std::max(0.0, covariance(squares_[i], sum_[i], sum_[i])));
}

Spread SampledSums::spread(std::size_t r, const Values& centre) const {
    Spread out;
    const std::size_t at = layout_.lab(r);
    for (std::size_t c = 0; c < 3; ++c) {
        out.mean[static_cast<int>(c)] = centre[at + c] + sum_[at + c] / count_;
        out.covariance[c][static_cast<int>(c)] = deviation(at + c) * deviation(at + c);
    }
    constexpr std::size_t kPairs[3][2] = {{0, 1}, {0, 2}, {1, 2}};
    for (std::size_t k = 0; k < 3; ++k) {
        const auto [i, j] = kPairs[k];
        const double c = covariance(products_[3 * r + k], sum_[at + i], sum_[at + j]);
        out.covariance[i][static_cast<int>(j)] = out.covariance[j][static_cast<int>(i)] = c;
    }
    for (std::size_t k = 0; k < layout_.wavelengths; ++k) {
        out.reflectance_factor.push_back(deviation(layout_.spectrum(r) + k));
    }
    add_chroma_and_hue(out, out.mean);  // says whether they are determined
    const auto own = [&](const Values& of) {
        return std::sqrt(std::max(0.0, covariance(of[2 * r + 1], of[2 * r], of[2 * r])));
    };
    if (out.chroma) out.chroma = own(chroma_);
    if (out.hue_deg) out.hue_deg = own(hue_);
    return out;
}

SampledSums sampled_sums(UncertainPaint& paint, const ValueLayout& layout, const Values& centre,
                         const UncertaintyOptions& options, int& redrawn) {
    SampledSums sums(layout);
    const auto total = static_cast<std::size_t>(options.samples);
    for (std::size_t first = 0; first < total; first += kSamplesAtOnce) {
        const std::size_t count = std::min(kSamplesAtOnce, total - first);
        std::vector<Draw> draws(count);
        parallel_for_ranges(0, count, 1, [&](std::size_t i, std::size_t) {
            draws[i] = draw_paint(paint, options.seed, first + i);
        });
        paint.throw_if_stopped();
        for (const Draw& draw : draws) {
            redrawn += draw.redrawn;
            if (!draw.values) {
                throw Error(fmt::format(
                    "a paint that was drawn from the standard deviations has no colours: {}",
                    draw.redrawn == kMaxRedraws
                        ? fmt::format("none of {} draws was a valid recipe", kMaxRedraws)
                        : paint.first_failure()));
            }
            sums.add(centre, *draw.values);
        }
    }
    return sums;
}

}  // namespace nacre::fit
