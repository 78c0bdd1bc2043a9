#include "nacre/paint/flake_sizes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/core/lru_cache.h"

namespace nacre::paint {
namespace {

double normal_below(double x) { return 0.5 * std::erfc(-x / std::numbers::sqrt2); }

// The x between lo and hi at which an increasing function reaches `value`.
template <class F>
double inverse(const F& f, double value, double lo, double hi) {
    for (int step = 0; step < 60; ++step) {
        const double middle = 0.5 * (lo + hi);
        (f(middle) < value ? lo : hi) = middle;
    }
    return 0.5 * (lo + hi);
}

/// The law of x = ln(d / d50), by any power of the diameter: log-normal on either side, weighted by powers
/// as [hatch-choate-1929] do for one deviation. That ground flakes have it is a choice, which the three
/// stated numbers tie down; beyond d10 and d90 nothing does. The normal law by number of FlakeSizes, for
/// diameters counted under a microscope, is another.
class QuantileLaw {
 public:
    explicit QuantileLaw(const DiameterQuantiles& q)
        : below_(std::log(q.d50_um / q.d10_um) / kDecile),
          above_(std::log(q.d90_um / q.d50_um) / kDecile) {}

    double lo() const { return -kQuantilesCut * below_; }
    double hi() const { return kQuantilesCut * above_; }

    /// Int g(x) e^(-k x) dx from -infinity, g being the density by volume: of d^(3 - k). Completing
    /// the square shifts the normal law by k deviations.
    double below(double x, int k) const {
        const auto part = [&](double deviation, double to) {
            const double shift = k * deviation;
            return std::exp(0.5 * shift * shift) * normal_below(to / deviation + shift);
        };
        return x < 0 ? part(below_, x) : part(below_, 0) + part(above_, x) - part(above_, 0);
    }

 private:
    static constexpr double kDecile = 1.2815515655446004;  // of the standard normal law, at 0.9
    double below_, above_;                                 // deviations of x
};

constexpr int kByNumber = 3, kByArea = 1;

constexpr double kCut = 3;  // standard deviations

using Medians = std::array<double, FlakeSizes::kSizes>;

/// Of equally probable parts of the standard normal law from `lo` to kCut. They are kept, as they take
/// half a millisecond and whoever moves another number of the paint asks for them again and again.
std::shared_ptr<const Medians> normal_medians(double lo) {
    static LruCache<double, Medians> recent(64);
    return recent.get(lo, [lo] {
        const double below = normal_below(lo), inside = normal_below(kCut) - below;
        Medians medians;
        for (int i = 0; i < FlakeSizes::kSizes; ++i) {
            const double p = below + inside * (i + 0.5) / FlakeSizes::kSizes;
            medians[i] = inverse(normal_below, p, lo, kCut);
        }
        return medians;
    });
}

}  // namespace

FlakeSizes::FlakeSizes(double mean_um, double spread_um) {
    require_in_range(mean_um, kFlakeSize_um.lo, kFlakeSize_um.hi, "diameter_um of the flakes");
    require_in_range(spread_um, 0, mean_um, "diameter_spread_um of the flakes");
    constexpr double kMin = 0.25;
    std::shared_ptr<const Medians> medians;
    if (spread_um > 0) medians = normal_medians(std::max(-kCut, (kMin - 1) * mean_um / spread_um));
    double squares = 0;
    for (int i = 0; i < kSizes; ++i) {
        const double x = medians ? (*medians)[i] : 0;
        diameters_um_[i] = static_cast<float>(mean_um + spread_um * x);
        squares += double{diameters_um_[i]} * diameters_um_[i];
    }
    mean_area_um2_ = std::numbers::pi / 4 * squares / kSizes;
}

FlakeSizes::FlakeSizes(const std::array<double, kSizes>& diameters_um) {
    double squares = 0;
    for (int i = 0; i < kSizes; ++i) {
        require_in_range(diameters_um[i], kFlakeSize_um.lo, kFlakeSize_um.hi,
                         "diameter of a flake in um");
        diameters_um_[i] = static_cast<float>(diameters_um[i]);
        squares += double{diameters_um_[i]} * diameters_um_[i];
    }
    mean_area_um2_ = std::numbers::pi / 4 * squares / kSizes;
}

double FlakeSizes::area_weighted_mean_um() const {
    double squares = 0, cubes = 0;
    for (const double d : diameters_um_) {
        squares += d * d;
        cubes += d * d * d;
    }
    return cubes / squares;
}

DiameterQuantiles quantiles_of(const StatedQuantiles& stated) {
    if (const auto* all = std::get_if<DiameterQuantiles>(&stated)) return *all;
    const double d50_um = std::get<MedianDiameter>(stated).d50_um;
    return {d50_um / kTypicalDecileRatio, d50_um, d50_um * kTypicalDecileRatio};
}

std::array<double, 2> size_ends_um(const DiameterQuantiles& quantiles) {
    const QuantileLaw law(quantiles);
    return {quantiles.d50_um * std::exp(law.lo()), quantiles.d50_um * std::exp(law.hi())};
}

std::vector<SizePart> size_parts(const DiameterQuantiles& quantiles) {
    const auto& [d10, d50, d90] = quantiles;
    if (!(d10 > 0 && d50 > d10 && d90 > d50)) {
        throw DomainError(
            fmt::format("diameters d10 = {}, d50 = {}, d90 = {} um: must increase from above 0",
                        d10, d50, d90));
    }
    constexpr double kWidestPart = 2.5;
    const QuantileLaw law(quantiles);
    const int count = std::max(
        1, static_cast<int>(std::ceil((law.hi() - law.lo()) / std::log(kWidestPart) - 1e-9)));
    const auto end = [&](int part) { return law.lo() + (law.hi() - law.lo()) * part / count; };
    const double area = law.below(law.hi(), kByArea) - law.below(law.lo(), kByArea);
    std::vector<SizePart> parts;
    for (int part = 0; part < count; ++part) {
        const double lo = end(part), hi = end(part + 1);
        const double first = law.below(lo, kByNumber);
        const double number = law.below(hi, kByNumber) - first;
        // Each class has the mean area of the flakes in it, so that the mean of all is exact.
        std::array<double, FlakeSizes::kSizes> diameters_um;
        double from = lo;
        for (int i = 0; i < FlakeSizes::kSizes; ++i) {
            const double to =
                i + 1 == FlakeSizes::kSizes
                    ? hi
                    : inverse([&](double x) { return law.below(x, kByNumber) - first; },
                              number * (i + 1) / FlakeSizes::kSizes, from, hi);
            const double flakes = number / FlakeSizes::kSizes;
            const double squares = law.below(to, kByArea) - law.below(from, kByArea);
            diameters_um[i] =
                d50 * std::clamp(std::sqrt(squares / flakes), std::exp(from), std::exp(to));
            from = to;
        }
        parts.push_back(
            {(law.below(hi, kByArea) - law.below(lo, kByArea)) / area, FlakeSizes(diameters_um)});
    }
    return parts;
}

SizePart without_rim(const FlakeSizes& sizes, double rim_um) {
    std::vector<double> left;
    double before = 0, after = 0;
    for (int i = 0; i < FlakeSizes::kSizes; ++i) {
        const double d = sizes.diameter_um(i), inner = d - 2 * rim_um;
        before += d * d;
        if (inner < kFlakeSize_um.lo) continue;
        after += inner * inner;
        left.push_back(inner);
    }
    if (left.empty()) {
        throw DomainError(fmt::format(
            "a rim of {} um takes all of flakes of up to {} um: must be below half of that", rim_um,
            sizes.largest_um()));
    }
    std::array<double, FlakeSizes::kSizes> diameters_um;
    for (int i = 0; i < FlakeSizes::kSizes; ++i) {
        diameters_um[i] = left[i * left.size() / FlakeSizes::kSizes];
    }
    return {after / before, FlakeSizes(diameters_um)};
}

}  // namespace nacre::paint
