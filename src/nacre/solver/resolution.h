#pragma once

#include "nacre/solver/medium.h"
#include "nacre/solver/solved_paint.h"

namespace nacre::solver {

/// Nodes and orders for a recipe.
struct Resolution {
    int exit_nodes = 0, inner_nodes = 0, orders = 0;
    double lobe_alpha = 0;  ///< roughness of the narrowest scattering lobe, for the azimuth
};

/// Chooses from the narrowest flake roughness and the sharpest pigment; what `settings` fixes is
/// taken as it is.
/// @throws DomainError if a setting is out of range; Error if a lobe is too sharp for any setting
Resolution choose_resolution(const PaintMedium& medium, const SolverSettings& settings);

/// What the nodes may miss of the scattering cross section of an exit direction. It is not lost
/// (the solver gives it back to extinction), and what it errs is a fraction of it.
inline constexpr double kAcceptedUnresolved = 1e-2;

/// Raises nodes and orders after a solution that they did not resolve. False if there is no need,
/// or if the settings fix what would have to grow, or if it has reached its limit: the report then
/// says how far off the solution is.
bool refine(Resolution& resolution, const SolverSettings& settings, double unresolved,
            double azimuthal_tail);

}  // namespace nacre::solver
