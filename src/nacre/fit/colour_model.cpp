#include "nacre/fit/colour_model.h"

#include <algorithm>

#include "nacre/core/error.h"
#include "nacre/core/parallel.h"

namespace nacre::fit {

namespace {

/// Of the unit cube. The function is smooth over a hundredth (a hue turns over a tenth), and the
/// solver's own error is below 1e-4 Delta E: 0.05 Delta E for all of the cube's width, while
/// sensitivities are of order 1 to 100.
constexpr double kStep = 2e-3;

// By detail. What a solver's tolerance of the BRDF's peak does to colours far from the peak, and
// what fewer cosines do to films with resonances at grazing incidence, which contribute little:
// docs/fit.md.
constexpr double kTolerance[] = {1e-4, 1e-5, 1e-6};
constexpr int kCosines[] = {33, 65, 129};

constexpr std::size_t kFilmsKept = 64;

}  // namespace

ColourModel::ColourModel(const FreeNumbers& numbers, const Target& target)
    : numbers_(numbers),
      target_(target),
      films_{layers::FilmCache{kFilmsKept, kCosines[0]}, layers::FilmCache{kFilmsKept, kCosines[1]},
             layers::FilmCache{kFilmsKept, kCosines[2]}} {}

std::size_t ColourModel::films() const {
    std::size_t sum = 0;
    for (const layers::FilmCache& films : films_) sum += films.computed();
    return sum;
}

std::string ColourModel::first_failure() const {
    const std::lock_guard lock(mutex_);
    return first_failure_;
}

std::optional<ColourModel::Evaluation> ColourModel::evaluate(
    std::span<const double> x, Detail detail, const layers::SolverSettings* settings) const {
    if (stopped_) return std::nullopt;
    try {
        layers::SolverSettings chosen;
        if (settings) chosen = *settings;
        chosen.tolerance = kTolerance[static_cast<int>(detail)];
        ++solves_;
        const layers::SolvedPaint paint =
            layers::solve(numbers_.at(x), target_.wavelengths_nm(detail), chosen,
                          &films_[static_cast<int>(detail)]);
        chosen.exit_nodes = paint.report.exit_nodes;
        chosen.inner_nodes = paint.report.inner_nodes;
        chosen.most_orders = paint.report.orders;
        return Evaluation{target_.residuals(paint, detail), chosen};
    } catch (const Error& error) {
        const std::lock_guard lock(mutex_);
        if (first_failure_.empty()) first_failure_ = error.what();
        return std::nullopt;
    }
}

bool ColourModel::column(std::span<const double> x, const Evaluation& at_x, Detail detail,
                         std::size_t number, Steps steps, std::span<double> jacobian) const {
    const auto beside = [&](double step) -> std::optional<Evaluation> {
        if (step == 0) return at_x;
        std::vector<double> moved(x.begin(), x.end());
        moved[number] += step;
        return evaluate(moved, detail, &at_x.settings);
    };
    const auto behind = beside(-steps.back), ahead = beside(steps.ahead);
    if (!behind || !ahead) return false;
    for (std::size_t row = 0; row < at_x.residuals.size(); ++row) {
        jacobian[row * numbers_.size() + number] =
            (ahead->residuals[row] - behind->residuals[row]) / (steps.ahead + steps.back);
    }
    return true;
}

std::optional<std::vector<double>> ColourModel::differences(std::span<const double> x,
                                                            const Evaluation& at_x, Detail detail,
                                                            bool central) const {
    std::vector<double> jacobian(at_x.residuals.size() * numbers_.size(), 0.0);
    std::atomic<bool> failed = false;
    parallel_for_ranges(0, numbers_.size(), 1, [&](std::size_t i, std::size_t) {
        const double room_ahead = 1 - x[i], room_behind = x[i];
        const Steps forward{0, kStep}, backward{kStep, 0}, both{kStep, kStep};
        const auto try_column = [&](Steps steps) {
            return steps.ahead <= room_ahead && steps.back <= room_behind &&
                   column(x, at_x, detail, i, steps, jacobian);
        };
        if (central && try_column(both)) return;
        if (!try_column(forward) && !try_column(backward)) failed = true;
    });
    if (failed) return std::nullopt;
    return jacobian;
}

std::optional<std::vector<double>> ColourModel::jacobian(std::span<const double> x,
                                                         const Evaluation& at_x,
                                                         Detail detail) const {
    return differences(x, at_x, detail, false);
}

std::optional<std::vector<double>> ColourModel::central_jacobian(std::span<const double> x,
                                                                 const Evaluation& at_x,
                                                                 Detail detail) const {
    return differences(x, at_x, detail, true);
}

}  // namespace nacre::fit
