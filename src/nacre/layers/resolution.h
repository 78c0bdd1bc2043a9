#pragma once

#include "nacre/layers/medium.h"
#include "nacre/layers/solved_paint.h"

namespace nacre::layers {

/// Nodes and orders for a recipe.
struct Resolution {
    int exit_nodes = 0, inner_nodes = 0, orders = 0;
    double lobe_alpha = 0;  ///< roughness of the narrowest scattering lobe, for the azimuth
};

/// Chooses from the narrowest flake roughness and the sharpest pigment; what `settings` fixes is
/// taken as it is.
/// @throws DomainError if a setting is out of range
Resolution choose_resolution(const PaintMedium& medium, const SolverSettings& settings);

}  // namespace nacre::layers
