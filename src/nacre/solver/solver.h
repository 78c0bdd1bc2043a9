#pragma once

#include <cstddef>
#include <vector>

#include "nacre/core/progress.h"
#include "nacre/solver/medium.h"
#include "nacre/solver/solved_paint.h"

// Adding-doubling for a paint, in the azimuthal Fourier basis, wavelengths as vector lanes.
// docs/solver.md explains the method, its accuracy and where the time goes.

namespace nacre::solver {

/// @param films     cache of the flakes' tables; null: none
/// @param progress  asked several times a second; the fraction may jump ahead, as the series of
///                  azimuthal orders ends where it has converged
/// @throws DomainError as validate() does; Error if the recipe cannot be resolved with the nodes
/// and orders that the settings allow, if the machine has not the memory that it takes (the message
/// says which and what to do), or if stopped by `progress`
SolvedPaint solve(const paint::Recipe& recipe, const std::vector<double>& wavelengths_nm,
                  const SolverSettings& settings = {}, FilmCache* films = nullptr,
                  const Progress& progress = {});

/// The same paint under a clear coat `factor` times as thick, solved anew from the medium of `paint`.
/// @param factor  >= 0
/// @throws as solve()
SolvedPaint solve_with_coat(const SolvedPaint& paint, double factor, const Progress& progress = {});

/// The same paint under a smooth interface that reflects nothing from inside: of the light in `paint`, that
/// which left the coat when it first met the interface. Solved anew from the medium of `paint`.
/// @throws as solve(); DomainError under a rough interface
SolvedPaint solve_without_internal_reflection(const SolvedPaint& paint,
                                              const Progress& progress = {});

/// The flakes of `paint` alone: without the layers below the lowest of them, over a substrate that reflects
/// nothing. What `paint` has more light the ground has scattered.
PaintMedium without_ground(const PaintMedium& paint);

/// The same, solved anew. The recipe is that of `paint`.
/// @throws as solve()
SolvedPaint solve_without_ground(const SolvedPaint& paint, const Progress& progress = {});

/// The memory in bytes that solve() allocates at its peak with the nodes and orders that it starts
/// with, or less where films do not add all the nodes that they may; more where it finds that they do
/// not resolve the paint.
/// @throws as solve()
std::size_t memory_to_solve(const paint::Recipe& recipe, const std::vector<double>& wavelengths_nm,
                            const SolverSettings& settings = {});

}  // namespace nacre::solver
