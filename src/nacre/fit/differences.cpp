#include "nacre/fit/differences.h"

#include <atomic>

#include "nacre/bsdf/models/hot_spot_brdf.h"
#include "nacre/core/parallel.h"
#include "nacre/measure/instrument.h"
#include "nacre/solver/solver.h"

namespace nacre::fit {

Solution solve_alike(const paint::Recipe& recipe, const std::vector<double>& wavelengths_nm,
                     double tolerance, const solver::SolverSettings* like, solver::FilmCache& films,
                     SharedProgress& work) {
    solver::SolverSettings chosen;
    if (like) chosen = *like;
    chosen.tolerance = tolerance;
    solver::SolvedPaint paint = solver::solve(recipe, wavelengths_nm, chosen, &films,
                                              [&work](double) { return work.keep_going(); });
    chosen.exit_nodes = paint.report.exit_nodes;
    chosen.inner_nodes = paint.report.inner_nodes;
    chosen.max_orders = paint.report.orders;
    return {std::move(paint), chosen};
}

measure::Measurement read_solution(const solver::SolvedPaint& paint, bool hot_spot,
                                   const std::vector<measure::Geometry>& geometries,
                                   const measure::Conditions& conditions) {
    measure::Brdf brdf = [&](double theta_i, double theta_o, double phi) {
        return paint.brdf(theta_i, theta_o, phi);
    };
    if (hot_spot) brdf = bsdf::HotSpotBrdf(paint);
    return measure::measure(paint.recipe.name, brdf, paint.wavelengths_nm(), geometries,
                            conditions);
}

namespace {

/// One column of the derivatives; false where there is no paint.
bool difference_along(const PointFunction& function, std::span<const double> point,
                      const Evaluation& at_point, std::size_t coordinate, double back, double ahead,
                      std::span<double> jacobian) {
    const auto beside = [&](double step) -> std::optional<Evaluation> {
        if (step == 0) return at_point;
        std::vector<double> moved(point.begin(), point.end());
        moved[coordinate] += step;
        return function(moved, &at_point.settings);
    };
    const auto from = beside(-back), to = beside(ahead);
    if (!from || !to) return false;
    for (std::size_t row = 0; row < at_point.values.size(); ++row) {
        jacobian[row * point.size() + coordinate] =
            (to->values[row] - from->values[row]) / (ahead + back);
    }
    return true;
}

}  // namespace

std::optional<std::vector<double>> differences(const PointFunction& function,
                                               std::span<const double> point,
                                               const Evaluation& at_point,
                                               std::span<const StepAlong> steps, bool central) {
    std::vector<double> jacobian(at_point.values.size() * point.size(), 0.0);
    std::atomic<bool> failed = false;
    parallel_for_ranges(0, point.size(), 1, [&](std::size_t i, std::size_t) {
        const StepAlong& along = steps[i];
        const double step = along.step;
        if (step == 0) return;
        const auto try_steps = [&](double back, double ahead) {
            return ahead <= along.room_ahead && back <= along.room_behind &&
                   difference_along(function, point, at_point, i, back, ahead, jacobian);
        };
        if (central && try_steps(step, step)) return;
        if (!try_steps(0, step) && !try_steps(step, 0)) failed = true;
    });
    if (failed) return std::nullopt;
    return jacobian;
}

}  // namespace nacre::fit
