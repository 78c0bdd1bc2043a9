#pragma once

#include <span>
#include <vector>

#include "nacre/solver/lane_matrix.h"

// Azimuthal orders as samples of a smooth function.
//
// What a pair of nodes reflects into order l is the Fourier integral of a lobe, defined and smooth for
// real l too: a lobe of width s in azimuth falls as exp(-l^2 s^2/2), and nodes at which it is wider
// have no such orders (ActiveNodes). The orders that matter at l therefore change over a distance that
// grows with l, and it is enough to solve them at such distances: all of them up to kDenseOrders, every
// second one up to twice that, every fourth one up to four times, and so on; 94 of 1024. The others
// follow by Lagrange interpolation in l.

namespace nacre::solver {

/// All orders below this are solved. Those between the others are then interpolated to within 2e-8 of
/// order 0 for lobes that are Gaussian in azimuth, of any width, and to within 3e-10 for orders that
/// fall as exp(-a l).
inline constexpr int kDenseOrders = 24;

/// The first order that is solved from this one on.
int next_solved_order(int order);

/// Those below `orders` that are solved; the last one is among them.
std::vector<int> solved_orders(int orders);

/// Of each stretch of orders with one distance between those that are solved: the first that is left
/// out, where interpolation is worst, as lobes are widest. Below `orders`.
std::vector<int> probe_orders(int orders);

/// Values of an order, [pair][block of wavelengths], pairs of nodes i >= j from its first one.
using OrderValues = LaneBuffer;

/// Order l from those of `known` that are a multiple of 2 (l & -l), of which it is the middle of two:
/// six on either side. Where the series has ended, or a node has no such order, they are zero.
/// @param known   by order, from 0 to the last one
/// @param first   by order: the first node that it has; grows, and not between l and the next order
///                that is solved
/// @param nodes   nodes there are
/// @param blocks  blocks of wavelengths
OrderValues interpolate_order(int l, std::span<const OrderValues> known, std::span<const int> first,
                              int nodes, int blocks);

}  // namespace nacre::solver
