#include "nacre/paint/orientation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/core/error.h"

namespace nacre::paint {
namespace {

/// Fraction of Beckmann's flakes within a tilt.
double beckmann_within(double tilt_deg, double alpha) {
    if (tilt_deg >= 90) return 1;
    const double slope = std::tan(tilt_deg * std::numbers::pi / 180) / alpha;
    return -std::expm1(-slope * slope);
}

double mixture_within(double tilt_deg, const std::vector<SlopeComponent>& components) {
    double sum = 0;
    for (const SlopeComponent& c : components) {
        sum += c.fraction * beckmann_within(tilt_deg, c.alpha);
    }
    return sum;
}

/// The cumulative law of a table, on a grid finer than its own.
struct CumulativeTilts {
    std::vector<double> tilt_deg, within;

    explicit CumulativeTilts(const std::vector<TiltDensity>& tilts) {
        constexpr int kBins = 400, kMaxRefinement = 8;
        const int finer = std::clamp(kBins / static_cast<int>(tilts.size()), 1, kMaxRefinement);
        double sum = 0;
        add(tilts.front().tilt_deg, 0);
        for (std::size_t i = 1; i < tilts.size(); ++i) {
            const TiltDensity &a = tilts[i - 1], &b = tilts[i];
            const double step = (b.tilt_deg - a.tilt_deg) / finer;
            for (int k = 0; k < finer; ++k) {
                const double middle = (k + 0.5) / finer;
                sum += step * (a.density + middle * (b.density - a.density));
                add(a.tilt_deg + (k + 1) * step, sum);
            }
        }
        for (double& w : within) w /= sum;
    }

 private:
    void add(double tilt, double sum) {
        tilt_deg.push_back(tilt);
        within.push_back(sum);
    }
};

}  // namespace

std::vector<SlopeComponent> ggx_mixture(double alpha) {
    constexpr double kStep = 1.1, kLast = 2.5;  // beyond it exp(2 x - e^x) is below 8e-4
    const double first = 2 * std::log(alpha);   // a = 1
    std::vector<SlopeComponent> components = {{-std::expm1(-std::exp(first + 0.5 * kStep)), 1}};
    double sum = 0;
    for (double x = first + kStep; x <= kLast; x += kStep) {
        const double tau = std::exp(x);
        components.push_back({tau * std::exp(-tau), alpha / std::sqrt(tau)});
        sum += components.back().fraction;
    }
    // So that all are 1: the rule's own error, below 0.2 %.
    const double scale = (1 - components[0].fraction) / sum;
    for (std::size_t i = 1; i < components.size(); ++i) components[i].fraction *= scale;
    return components;
}

// By expectation and maximisation, which keeps fractions positive and their sum.
//                                                                    [dempster-laird-rubin-1977]
TiltFit fit_tilts(const TabulatedTilts& table) {
    const CumulativeTilts law(table.tilts);
    constexpr int kAlphas = 28, kSteps = 1500;
    const Range range = limits::kOrientationAlpha;
    TiltFit fit;
    for (int i = 0; i < kAlphas; ++i) {
        const double at = i / (kAlphas - 1.0);
        fit.components.push_back({1.0 / kAlphas, range.lo * std::pow(range.hi / range.lo, at)});
    }
    // The fractions of the bins between the nodes; the first holds what is below the first node and
    // the last what lies beyond the last.
    const std::size_t bins = law.tilt_deg.size() + 1;
    const auto bin_fractions = [&](const auto& within) {
        std::vector<double> fractions;
        double before = 0;
        for (std::size_t b = 0; b < bins; ++b) {
            const double here = b + 1 < bins ? within(b) : 1.0;
            fractions.push_back(here - before);
            before = here;
        }
        return fractions;
    };
    const std::vector<double> wanted = bin_fractions([&](std::size_t b) { return law.within[b]; });
    const auto improve = [&](int steps) {
        std::vector<std::vector<double>> own;
        for (const SlopeComponent& c : fit.components) {
            own.push_back(bin_fractions(
                [&](std::size_t b) { return beckmann_within(law.tilt_deg[b], c.alpha); }));
        }
        for (int step = 0; step < steps; ++step) {
            std::vector<double> factor(fit.components.size(), 0.0);
            for (std::size_t b = 0; b < bins; ++b) {
                if (wanted[b] <= 0) continue;
                double sum = 0;
                for (std::size_t c = 0; c < own.size(); ++c) {
                    sum += fit.components[c].fraction * own[c][b];
                }
                if (sum <= 0) continue;
                for (std::size_t c = 0; c < own.size(); ++c) {
                    factor[c] += wanted[b] / sum * own[c][b];
                }
            }
            double all = 0;
            for (std::size_t c = 0; c < own.size(); ++c) {
                all += fit.components[c].fraction *= factor[c];
            }
            for (SlopeComponent& c : fit.components) c.fraction /= all;
        }
    };
    improve(kSteps);
    constexpr double kNegligible = 2e-3;
    std::erase_if(fit.components, [](const SlopeComponent& c) { return c.fraction < kNegligible; });
    improve(kSteps);
    for (std::size_t b = 0; b + 1 < bins; ++b) {
        fit.residual =
            std::max(fit.residual,
                     std::abs(mixture_within(law.tilt_deg[b], fit.components) - law.within[b]));
    }
    return fit;
}

std::vector<SlopeComponent> beckmann_mixture(const Orientation& orientation) {
    switch (orientation.law) {
        case Orientation::Law::beckmann:
            break;
        case Orientation::Law::ggx:
            return ggx_mixture(orientation.beckmann_alpha);
        case Orientation::Law::tabulated: {
            TiltFit fit = fit_tilts(orientation.table.value());
            if (fit.residual > kMaxTiltResidual) {
                throw DomainError(fmt::format(
                    "the law of the tilts is no mixture of Gaussian laws of slopes: its cumulative "
                    "law differs by {:.2g} from the nearest; must be at most {}",
                    fit.residual, kMaxTiltResidual));
            }
            return std::move(fit.components);
        }
    }
    return {{1, orientation.beckmann_alpha}};
}

double median_tilt_deg(const Orientation& orientation) {
    const auto degrees = [](double slope) { return std::atan(slope) * 180 / std::numbers::pi; };
    switch (orientation.law) {
        case Orientation::Law::beckmann:
            break;
        case Orientation::Law::ggx:
            return degrees(orientation.beckmann_alpha);
        case Orientation::Law::tabulated: {
            const CumulativeTilts law(orientation.table.value().tilts);
            const auto at = std::lower_bound(law.within.begin(), law.within.end(), 0.5);
            return law.tilt_deg[static_cast<std::size_t>(at - law.within.begin())];
        }
    }
    return degrees(orientation.beckmann_alpha * std::sqrt(std::numbers::ln2));
}

}  // namespace nacre::paint
