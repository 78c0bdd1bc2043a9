#pragma once

#include <span>
#include <vector>

#include "nacre/solver/fourier_kernel.h"
#include "nacre/solver/impedance.h"
#include "nacre/solver/rough_interface_operators.h"

// A paint on the quadrature nodes, at the eight wavelengths of a block: what every azimuthal order
// starts from.

namespace nacre::solver {

/// One layer.
struct LayerBlock {
    const FourierKernel* kernel;
    int block;
    double thickness_um;
    LaneBuffer extinction;     ///< by node; agrees with the kernel's own sum, see make_block
    LaneBuffer single_factor;  ///< by pair of lit nodes: depth integral of single scattering
    int doublings;

    const FloatLanes* same(int order) const { return kernel->same(block, order); }
    const FloatLanes* opposite(int order) const { return kernel->opposite(block, order); }
};

/// All layers, and what lies above and below.
struct PaintBlock {
    std::vector<LayerBlock> layers;
    LaneBuffer coat;      ///< by node: transmittance of the clearcoat, one way
    LaneBuffer returned;  ///< by node: what a smooth interface sends back, through the coat twice
    bool coat_absorbs = false;
    DoubleLanes substrate{};
    double unresolved = 0;  ///< as SolverReport::unresolved_scattering
};

/// Single scattering is computed between the first `lit` nodes, those that light from outside
/// reaches.
/// @param kernels  by layer; outlive the block
/// @param losses   by layer and node
///
/// The block keeps sigma_t = (discrete sum of the kernel) + (exact absorption): what the quadrature
/// misses of the scattering cross section is taken from extinction too, so that a flake that
/// absorbs nothing loses nothing. Rescaling the kernel instead would break its symmetry.
PaintBlock make_block(const PaintMedium& medium, const Directions& directions,
                      std::span<const FourierKernel> kernels,
                      std::span<const std::vector<Losses>> losses, int lit, int block);

// One azimuthal order of a paint at eight wavelengths: layers stacked as impedances (impedance.h),
// the interface on top, single scattering subtracted.

/// Scratch memory for up to n nodes; allocate once a thread.
struct OrderWorkspace {
    explicit OrderWorkspace(int n)
        : e(n * n), f(n * n), y(n * n), u(n * n), impedance(n), scale(n) {}
    LaneBuffer e, f, y, u;
    ImpedanceWorkspace impedance;
    std::vector<double> scale;
};

/// f_multiple under a smooth interface at the pairs i >= j of active exit nodes, [pair][lane],
/// without Fresnel's transmittances, into out.
void solve_order(const PaintBlock& block, const Directions& directions, const ActiveNodes& active,
                 int order, OrderWorkspace& work, DoubleLanes* out);

/// The same under a rough interface: f_single and f_multiple with the interface's transmission, as
/// seen from outside.
void solve_rough_order(const PaintBlock& block, const RoughInterfaceOperators::Order& interface,
                       const Directions& directions, int order, OrderWorkspace& work,
                       DoubleLanes* single, DoubleLanes* multiple);

}  // namespace nacre::solver
