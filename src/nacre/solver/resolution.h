#pragma once

#include "nacre/solver/medium.h"
#include "nacre/solver/solved_paint.h"

namespace nacre::solver {

/// Nodes and orders for a recipe.
struct Resolution {
    int exit_nodes = 0, inner_nodes = 0, orders = 0;
    double lobe_alpha = 0;  ///< roughness of the narrowest scattering lobe, for the azimuth
};

/// What films add at most to the exit nodes.
inline constexpr int kMaxFilmNodes = 16;

/// What the settings say, whatever the recipe.
/// @throws DomainError naming setting, value and range, if one is out of range
void check(const SolverSettings& settings);

/// Chooses from the narrowest flake roughness, the sharpest pigment and how the colours of films change with
/// the angle; what `settings` fixes is taken as it is.
/// @throws DomainError as check()
Resolution choose_resolution(const PaintMedium& medium, const SolverSettings& settings);

/// Largest SolverReport::unresolved_scattering that is not refined. No energy is lost (make_block()
/// changes extinction by as much), and the BRDF errs by a fraction of it.
inline constexpr double kAcceptedUnresolved = 1e-2;

/// Raises nodes and orders after a solution that they did not resolve. False if there is no need,
/// or if what would have to grow is fixed by the settings or has reached its limit: the report then
/// states the error.
bool refine(Resolution& resolution, const SolverSettings& settings, double unresolved,
            double azimuthal_tail);

}  // namespace nacre::solver
