#pragma once

#include <vector>

#include "nacre/solver/medium.h"
#include "nacre/solver/solved_paint.h"

// Adding-doubling for a paint, in the azimuthal Fourier basis, wavelengths as vector lanes.
// docs/solver.md explains the method, its accuracy and where the time goes.

namespace nacre::solver {

/// @param films  cache of the flakes' tables; null: none
/// @throws DomainError as validate() does; Error if the recipe cannot be resolved with the nodes
/// and orders that the settings allow (the message says which and what to do)
SolvedPaint solve(const paint::Recipe& recipe, const std::vector<double>& wavelengths_nm,
                  const SolverSettings& settings = {}, FilmCache* films = nullptr);

}  // namespace nacre::solver
