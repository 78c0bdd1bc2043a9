#pragma once

#include <vector>

#include "nacre/layers/paint_block.h"
#include "nacre/layers/rough_interface_operators.h"

// One azimuthal order of a paint at eight wavelengths: layers stacked as impedances (impedance.h),
// the interface on top, single scattering taken out.

namespace nacre::layers {

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

/// The same under a rough interface: f_single and the rest, complete, as seen from outside.
void solve_rough_order(const PaintBlock& block, const RoughInterfaceOperators::Order& interface,
                       const Directions& directions, int order, OrderWorkspace& work,
                       DoubleLanes* single, DoubleLanes* rest);

}  // namespace nacre::layers
