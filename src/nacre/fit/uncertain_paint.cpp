#include "nacre/fit/uncertain_paint.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>

#include "nacre/core/parallel.h"
#include "nacre/paint/recipe_parameter.h"

namespace nacre::fit {
namespace {

/// Step of the derivatives, as a fraction of a number or of its deviation if that is more. As wide
/// as those of a fit: 2e-3 of its default bounds, over the logarithm of a ninefold range.
constexpr double kRelativeStep = 4e-3;

}  // namespace

std::vector<double> UncertainPaint::correlated(const std::vector<double>& z) const {
    if (root_.empty()) return z;
    std::vector<double> point(z.size(), 0.0);
    for (std::size_t i = 0; i < z.size(); ++i) {
        for (std::size_t k = 0; k <= i; ++k) point[i] += root_[i * z.size() + k] * z[k];
    }
    return point;
}

bool UncertainPaint::moves_anything(std::size_t direction) const {
    std::vector<double> z(numbers_.size(), 0.0);
    z[direction] = 1;
    const std::vector<double> point = correlated(z);
    for (std::size_t i = 0; i < point.size(); ++i) {
        if (point[i] != 0 && numbers_[i].standard_deviation > 0) return true;
    }
    return false;
}

paint::Recipe UncertainPaint::at(std::span<const double> point) const {
    paint::Recipe recipe = recipe_;
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
        if (point[i] == 0) continue;
        paint::set_parameter(recipe, numbers_[i].key,
                             numbers_[i].value + numbers_[i].standard_deviation * point[i]);
    }
    return recipe;
}

bool UncertainPaint::is_valid(std::span<const double> point) const {
    try {
        paint::validate(at(point), {});
        return true;
    } catch (const DomainError&) {
        return false;
    }
}

std::optional<Evaluation> UncertainPaint::evaluate(std::span<const double> point,
                                                   const solver::SolverSettings* like) {
    if (work_.stopped()) return std::nullopt;
    std::optional<Evaluation> out;
    try {
        // Waiting for parts of a solve, a thread must not begin another paint.
        tbb::this_task_arena::isolate([&] {
            const PaintReading read = reader_(at(point), like, work_);
            out = Evaluation{values_of(read.measurement), read.settings};
        });
    } catch (const Error& error) {
        const std::lock_guard lock(mutex_);
        if (first_failure_.empty()) first_failure_ = error.what();
        return std::nullopt;
    }
    work_.add();
    return out;
}

Sensitivities UncertainPaint::moves(const Evaluation& centre) {
    const std::vector<double> origin(numbers_.size(), 0.0);
    std::vector<StepAlong> steps;
    for (std::size_t i = 0; i < numbers_.size(); ++i) {
        const double value = numbers_[i].value, sigma = numbers_[i].standard_deviation;
        if (sigma == 0) {
            steps.emplace_back();
            continue;
        }
        steps.push_back({kRelativeStep * std::max(std::abs(value) / sigma, 1.0),
                         (value - ranges_[i].lo) / sigma, (ranges_[i].hi - value) / sigma});
    }
    const auto function = [&](std::span<const double> point, const solver::SolverSettings* like) {
        return evaluate(point, like);
    };
    auto jacobian = differences(function, origin, centre, steps, true);
    throw_if_stopped();
    if (!jacobian) {
        throw Error("a number can be moved to neither side: " + first_failure_);
    }
    Sensitivities moves{centre.values, std::move(*jacobian), {}, {}, numbers_.size(), root_};
    add_wide_steps(centre, moves);
    return moves;
}

void UncertainPaint::throw_if_stopped() const {
    if (work_.stopped()) throw Stopped("the uncertainties were stopped before they were done");
}
void UncertainPaint::add_wide_steps(const Evaluation& centre, Sensitivities& moves) {
    const std::size_t count = numbers_.size();
    std::vector<std::vector<std::size_t>> moved;  // directions, at once
    for (std::size_t i = 0; i < count; ++i) moved.push_back({i});
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = i + 1; j < count; ++j) moved.push_back({i, j});
    }
    std::vector<std::optional<Values>> values(2 * moved.size());
    parallel_for_ranges(0, values.size(), 1, [&](std::size_t k, std::size_t) {
        std::vector<double> z(count, 0.0);
        bool uncertain = true;
        for (const std::size_t i : moved[k / 2]) {
            z[i] = k % 2 == 0 ? 1 : -1;
            uncertain = uncertain && moves_anything(i);
        }
        if (!uncertain) {
            if (moved[k / 2].size() == 1) values[k] = centre.values;
            return;
        }
        if (auto beside = evaluate(correlated(z), &centre.settings)) {
            values[k] = std::move(beside->values);
        }
    });
    throw_if_stopped();
    for (std::size_t m = 0; m < moved.size(); ++m) {
        (m < count ? moves.alone : moves.pairs)
            .push_back({std::move(values[2 * m]), std::move(values[2 * m + 1])});
    }
}

}  // namespace nacre::fit
