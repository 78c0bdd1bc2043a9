#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "nacre/core/progress.h"
#include "nacre/measure/measurement.h"
#include "nacre/paint/recipe.h"
#include "nacre/solver/film_cache.h"
#include "nacre/solver/solved_paint.h"

// What a virtual instrument reads on a paint, as a function of numbers of its recipe, and its
// derivatives by finite differences: for fits and for uncertainties.

namespace nacre::fit {

/// Tolerance of the solver and cosines of its films (paint::FlakeTable) for colours that are to
/// have smooth derivatives.
inline constexpr double kFineTolerance = 1e-6;
inline constexpr int kFineCosines = 129;

struct Solution {
    solver::SolvedPaint paint;
    solver::SolverSettings settings;  ///< with the nodes and orders that were chosen
};

/// Solves a paint with the nodes and orders of a neighbour, so that a difference between both is
/// not that of their resolutions.
/// @param like  settings of the neighbour's Solution; null: chosen for this paint
/// @throws DomainError, Error as solver::solve(), which asks `work` whether to go on
Solution solve_alike(const paint::Recipe& recipe, const std::vector<double>& wavelengths_nm,
                     double tolerance, const solver::SolverSettings* like, solver::FilmCache& films,
                     SharedProgress& work);

/// What an instrument reads on a solved paint.
/// @param hot_spot  with the hot spot of large flakes (bsdf::HotSpotBrdf), else by the equation of
///                  transfer
/// @throws DomainError, Error as measure::measure(); as bsdf::HotSpotBrdf with the hot spot
measure::Measurement read_solution(const solver::SolvedPaint& paint, bool hot_spot,
                                   const std::vector<measure::Geometry>& geometries,
                                   const measure::Conditions& conditions);

/// Values at a point, and how the paint was solved there.
struct Evaluation {
    std::vector<double> values;
    /// Nodes and orders that were chosen for this point. Its neighbours must be solved with the
    /// same, or the function would jump between them.
    solver::SolverSettings settings;
};

/// From a point, some coordinates of the numbers, to values. Safe to call from several threads at
/// once. Empty where there is no paint (numbers that exclude each other, a lobe that the solver
/// cannot resolve), or where the work is stopped.
/// @param like  settings of a neighbour's Evaluation; null: chosen for this point
using PointFunction = std::function<std::optional<Evaluation>(std::span<const double> point,
                                                              const solver::SolverSettings* like)>;

/// A step of differences along one coordinate, and how far the point may move along it. A step of
/// 0: the derivative is not wanted, and is 0.
struct StepAlong {
    double step = 0, room_behind = 0, room_ahead = 0;
};

/// The derivatives of the values, rows of values by columns of coordinates: differences forward,
/// backward where there is no room or no paint ahead, with `central` to both sides where there is
/// room and paint, whose error is of second order in the step. Each coordinate's on a thread of its
/// own. Empty where there is no paint to either side of one of them.
std::optional<std::vector<double>> differences(const PointFunction& function,
                                               std::span<const double> point,
                                               const Evaluation& at_point,
                                               std::span<const StepAlong> steps, bool central);

}  // namespace nacre::fit
