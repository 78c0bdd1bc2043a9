#include "nacre/fit/remedy.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "nacre/core/error.h"
#include "nacre/core/parallel.h"
#include "nacre/fit/effect.h"
#include "nacre/fit/search.h"

namespace nacre::fit {

namespace {

/// Places at which a number is tried alone: hues turn over a tenth of the cube.
constexpr std::size_t kPlaces = 10;
constexpr std::size_t kMaxRemedies = 3;
/// A remedy must leave this part of the difference or less.
constexpr double kWorthSaying = 0.9;
constexpr double kWider = 3;
constexpr DescentLimits kRemedyLimits{8, 1e-3, 1e-4, 0.1};

/// A number to try, as the only free one of a paint.
struct Trial {
    Trial(const Target& target, const paint::Recipe& paint, const paint::ParameterBounds& bounds,
          bool widens, SharedProgress& work)
        : widens(widens), numbers(paint, {bounds.key}, {bounds}), model(numbers, target, work) {}

    const FreeNumber& number() const { return numbers[0]; }
    double min_rms() const { return rms_delta_e[best]; }

    bool widens;
    FreeNumbers numbers;
    ColourModel model;
    std::vector<double> rms_delta_e = std::vector<double>(kPlaces, INFINITY);
    std::size_t best = 0;
};

double place(std::size_t i) { return (static_cast<double>(i) + 0.5) / kPlaces; }

/// Three times as wide where the number ended; as they were where there is no more room.
paint::ParameterBounds widened(const paint::Recipe& recipe, const FittedParameter& fitted) {
    paint::ParameterBounds bounds = fitted.number.bounds;
    const Range range = paint::find_parameter(recipe, bounds.key).range;
    if (fitted.at_upper_bound && bounds.hi > 0) bounds.hi = std::min(range.hi, kWider * bounds.hi);
    if (fitted.at_lower_bound && bounds.lo > 0) bounds.lo = std::max(range.lo, bounds.lo / kWider);
    return range.contains(bounds.lo) && range.contains(bounds.hi) ? bounds : fitted.number.bounds;
}

using Trials = std::vector<std::unique_ptr<Trial>>;

/// The numbers of the paint that was found, each also in the paint from which the fit started: what
/// was free may have gone far astray in place of the number that was not.
Trials trials_of(const Target& target, const paint::Recipe& found, const paint::Recipe& start,
                 const std::vector<FittedParameter>& free, SharedProgress& work) {
    Trials trials;
    const EffectOnColours effect(found, target.hot_spot(), work);
    for (const paint::RecipeParameter& number : paint::recipe_parameters(found)) {
        const auto fitted = std::ranges::find_if(
            free, [&](const auto& f) { return f.number.bounds.key == number.key; });
        try {
            const bool widens = fitted != free.end();
            const paint::ParameterBounds bounds =
                widens ? widened(found, *fitted) : default_bounds(found, number.key);
            if (widens && bounds == fitted->number.bounds) continue;
            auto trial = std::make_unique<Trial>(target, found, bounds, widens, work);
            if (!effect.of(trial->number())) continue;
            trials.push_back(std::move(trial));
            trials.push_back(std::make_unique<Trial>(target, start, bounds, widens, work));
        } catch (const DomainError&) {  // it has no bounds in which to be tried
        }
    }
    return trials;
}

void try_places(const Trials& trials, const Target& target) {
    parallel_for_ranges(0, trials.size() * kPlaces, 1, [&](std::size_t t, std::size_t) {
        // Waiting for a solve, a thread must not begin another one.
        tbb::this_task_arena::isolate([&] {
            Trial& trial = *trials[t / kPlaces];
            const double x = place(t % kPlaces);
            if (const auto seen = trial.model.evaluate(std::span(&x, 1), Detail::screening)) {
                trial.rms_delta_e[t % kPlaces] = target.rms_delta_e(seen->values);
            }
        });
    });
    for (const auto& trial : trials) {
        const auto least = std::ranges::min_element(trial->rms_delta_e);
        trial->best = static_cast<std::size_t>(least - trial->rms_delta_e.begin());
    }
}

/// The trial's number with the free ones, from its best place.
std::optional<Remedy> descended(const Trial& trial, const Target& target,
                                const std::vector<FittedParameter>& free, SharedProgress& work,
                                int& solves) {
    std::vector<std::string> keys = {trial.number().bounds.key};
    std::vector<paint::ParameterBounds> bounds = {trial.number().bounds};
    for (const FittedParameter& other : free) {
        if (other.number.bounds.key == keys[0] || keys.size() == FreeNumbers::kMax) continue;
        keys.push_back(other.number.bounds.key);
        bounds.push_back(other.number.bounds);
    }
    const FreeNumbers numbers(trial.numbers.start(), keys, bounds);
    const ColourModel model(numbers, target, work);
    std::vector<double> x = numbers.start_point();
    x[0] = place(trial.best);
    const Descent descent = descend(model, x, Detail::screening, kRemedyLimits);
    const auto colours = model.colours(descent.x);
    solves += model.solves();
    if (!colours) return std::nullopt;
    return Remedy{keys[0], trial.widens, bounds[0], numbers[0].from_unit(descent.x[0]),
                  target.difference(*colours).mean_delta_e_2000};
}

}  // namespace

std::vector<Remedy> find_remedies(const Target& target, const paint::Recipe& found,
                                  const paint::Recipe& start,
                                  const std::vector<FittedParameter>& free, double mean_now,
                                  SharedProgress& work, int& solves) {
    Trials trials = trials_of(target, found, start, free, work);
    try_places(trials, target);
    if (trials.empty()) return {};
    const auto now = trials[0]->model.evaluate(trials[0]->numbers.start_point(), Detail::screening);
    const double rms_now = now ? target.rms_delta_e(now->values) : INFINITY;
    std::ranges::stable_sort(trials, {}, [](const auto& trial) { return trial->min_rms(); });
    std::vector<Remedy> remedies;
    std::vector<std::string> tried;
    for (const auto& trial : trials) {
        solves += trial->model.solves();
        const std::string& key = trial->number().bounds.key;
        if (tried.size() == kMaxRemedies || trial->min_rms() >= rms_now ||
            std::ranges::find(tried, key) != tried.end()) {
            continue;
        }
        tried.push_back(key);
        const auto remedy = descended(*trial, target, free, work, solves);
        if (remedy && remedy->mean_delta_e_2000 <= kWorthSaying * mean_now) {
            remedies.push_back(*remedy);
        }
    }
    std::ranges::stable_sort(remedies, {}, &Remedy::mean_delta_e_2000);
    return remedies;
}

}  // namespace nacre::fit
