#include "nacre/optics/phase_function.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "nacre/core/error.h"

namespace nacre::optics {

namespace {

const std::array<double, PhaseFunction::kIntervals + 1>& node_cosines() {
    static const auto cosines = [] {
        std::array<double, PhaseFunction::kIntervals + 1> c;
        for (int i = 0; i <= PhaseFunction::kIntervals; ++i) {
            c[i] = std::cos(std::numbers::pi * i / PhaseFunction::kIntervals);
        }
        return c;
    }();
    return cosines;
}

// By Bonnet's recurrence of Legendre polynomials, from degree 0 up.      [abramowitz-stegun-1964, 8.5.3]
double sum_series(const std::vector<double>& series, double cosine) {
    double sum = 0, p = 1, before = 0;
    for (std::size_t n = 0; n < series.size(); ++n) {
        sum += (2.0 * n + 1) * series[n] * p;
        const double next = ((2.0 * n + 1) * cosine * p - n * before) / (n + 1.0);
        before = p;
        p = next;
    }
    return sum / (4 * std::numbers::pi);
}

}  // namespace

PhaseFunction::PhaseFunction(std::vector<std::vector<double>> legendre)
    : legendre_(std::move(legendre)) {
    if (legendre_.empty()) throw DomainError("a phase function without wavelengths");
    stride_ = (legendre_.size() + kLanes - 1) / kLanes * kLanes;
    table_.resize((kIntervals + 1) * stride_);
    for (std::size_t w = 0; w < stride_; ++w) {
        const std::vector<double>& series = legendre_[std::min(w, legendre_.size() - 1)];
        if (series.empty() || series[0] != 1) {
            throw DomainError("a phase function must begin with chi_0 = 1");
        }
        for (const double chi : series) require_in_range(chi, -1, 1, "chi_n");
        degrees_ = std::max(degrees_, static_cast<int>(series.size()));
        double integral = 0;
        for (int i = 0; i <= kIntervals; ++i) {
            // Where the function is next to nothing, the sum leaves rounding of either sign.
            const double value = std::max(0.0, sum_series(series, node_cosine(i)));
            table_[i * stride_ + w] = value;
            const double reach = node_cosine(std::max(i - 1, 0)) -
                                 node_cosine(std::min(i + 1, PhaseFunction::kIntervals));
            integral += std::numbers::pi * reach * value;
        }
        for (int i = 0; i <= kIntervals; ++i) table_[i * stride_ + w] /= integral;
    }
}

PhaseFunction PhaseFunction::at(const std::vector<int>& wavelengths) const {
    std::vector<std::vector<double>> some;
    for (const int w : wavelengths) some.push_back(legendre_[w]);
    return PhaseFunction(std::move(some));
}

// chi_n = g^n is the series of [henyey-greenstein-1941]. What matters, 1e-5, is a choice.
double PhaseFunction::sharpness() const {
    constexpr double kMatters = 1e-5;
    double g = 0;
    for (const std::vector<double>& series : legendre_) {
        for (std::size_t n = 1; n < series.size(); ++n) {
            const double chi = std::abs(series[n]);
            if ((2.0 * n + 1) * chi > kMatters) g = std::max(g, std::pow(chi, 1.0 / n));
        }
    }
    return g;
}

double PhaseFunction::node_cosine(int node) { return node_cosines()[node]; }

PhaseFunction::Place PhaseFunction::locate(double cosine) {
    const double c = std::clamp(cosine, -1.0, 1.0);
    const double x = std::acos(c) * (kIntervals / std::numbers::pi);
    const int node = std::clamp(static_cast<int>(x), 0, kIntervals - 1);
    const auto& at = node_cosines();
    // Rounding of the arc cosine may name the neighbour.
    return {node, std::clamp((at[node] - c) / (at[node] - at[node + 1]), 0.0, 1.0)};
}

DoubleLanes PhaseFunction::value(double cosine, int block) const {
    const Place place = locate(cosine);
    const double* p = row(place.node) + kLanes * block;
    const DoubleLanes a = load_lanes(p);
    return a + place.fraction * (load_lanes(p + stride_) - a);
}

}  // namespace nacre::optics
