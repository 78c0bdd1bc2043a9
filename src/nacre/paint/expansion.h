#pragma once

#include "nacre/paint/recipe.h"

namespace nacre::paint {

/// The paint in the terms in which it is solved, walked through and shown: plain species of flakes,
/// whose slopes have Beckmann's law throughout their layer, and pigments. What a recipe says beyond
/// that becomes several of them:
///
/// - a law of slopes other than Beckmann's: a species for each component (orientation.h);
/// - alpha that changes with depth: sublayers. That it is linear in depth is a choice of this project;
/// - d10, d50, d90: a species for each part of the sizes (flake_sizes.h);
/// - a coat on one side: half of the flakes lie with it up, half with it down. Light does not tell
///   which flake it meets, so that two species, each with the optics of one face on both sides, are
///   the same paint in the equation of transfer; light that meets one and the same flake twice would
///   see the difference. That as many lie either way is a choice;
/// - an edge: the disc within it, and a pigment that scatters evenly in all directions, without
///   absorbing, with the cross section of the rim face on. No theory of edges is behind that, and no
///   error can be given: it is a choice of this project, with a width to be fitted (docs/flakes.md).
///
/// A recipe without any of these is returned as it is; so is one that has been expanded.
///                                                                       [docs/flakes.md]
/// @param recipe  one that validate() accepts
Recipe expanded(const Recipe& recipe);

/// Whether expanded() changes it.
bool is_plain(const Recipe& recipe);

/// Where alpha changes with depth, the mean of a lobe's peak over a sublayer, which goes with
/// 1 / alpha^2, is exact; at its ends the peak is off by this fraction at most.
inline constexpr double kSublayerError = 0.1;

}  // namespace nacre::paint
