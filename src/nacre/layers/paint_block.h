#pragma once

#include <vector>

#include "nacre/layers/fourier_kernel.h"
#include "nacre/layers/impedance.h"

// A paint on the quadrature nodes, at the eight wavelengths of a block: what every azimuthal order
// starts from.

namespace nacre::layers {

/// One layer.
struct LayerBlock {
    double thickness_um = 0;
    FourierKernel kernel;
    LaneBuffer extinction;     ///< by node; agrees with the kernel's own sum, see make_block
    LaneBuffer single_factor;  ///< by pair of lit nodes: depth integral of single scattering
    int doublings = 0;
};

/// All layers, and what lies above and below.
struct PaintBlock {
    std::vector<LayerBlock> layers;
    LaneBuffer coat;    ///< by node: transmittance of the clearcoat, one way
    LaneBuffer mirror;  ///< by node: reflectance of the interface from inside
    bool coat_absorbs = false;
    DoubleLanes substrate{};
    double unresolved = 0;  ///< as SolverReport::unresolved_scattering
};

/// Single scattering is wanted between the first `lit` nodes: those that light reaches from
/// outside.
///
/// The block keeps sigma_t = (discrete sum of the kernel) + (exact absorption): what the quadrature
/// misses of the scattering cross section is taken from extinction too, so that a flake that
/// absorbs nothing loses nothing. Rescaling the kernel instead would break its symmetry.
PaintBlock make_block(const PaintMedium& medium, const Directions& directions,
                      const ActiveNodes& active, int lit, int block);

}  // namespace nacre::layers
