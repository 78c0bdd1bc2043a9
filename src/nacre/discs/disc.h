#pragma once

#include <cstdint>
#include <vector>

#include "nacre/core/vec.h"
#include "nacre/discs/tile.h"
#include "nacre/layers/recipe.h"

// The flakes of a paint as what they are: discs at places of their own.

namespace nacre::discs {

/// One flake. The order of its parts is that of Embree's buffers (disc_scene.cpp).
struct Disc {
    Vec3f centre_um;  ///< z = 0 is the interface with the air, z < 0 below it
    float radius_um;
    Vec3f normal;           ///< unit, upwards
    std::uint16_t film;     ///< in FlakeFilms of its species
    std::uint16_t species;  ///< counted through all layers from the top down
};

/// Some 150 bytes each, with what finds them.
inline constexpr double kMostDiscs = 8e6;

/// Clearcoat and layers.
double paint_thickness_um(const layers::Recipe& recipe);

/// How many discs a tile holds on average: rho H area, over all species.
double expected_discs(const layers::Recipe& recipe, const Tile& tile);

/// Draws the flakes of a recipe: of each species a Poisson number, centres even over the tile and
/// the thickness of their layer, Gaussian slopes of variance alpha^2 / 2 per component, diameters
/// by sparkle::FlakeSizes; rho is c over the mean area.
///
/// Flakes may cut through each other, as in the equation of transfer, and reach into neighbouring
/// layers, but not out of the paint: a flake that would stick out of the interface or into the
/// ground is moved up or down until it does not. One that is taller than the paint is thick is
/// centred in it, and sticks out at both ends; no light gets there.
///
/// @param film_counts  FlakeFilms::count() by species
/// @throws DomainError naming the number of discs if it exceeds kMostDiscs
std::vector<Disc> draw_discs(const layers::Recipe& recipe, const Tile& tile,
                             const std::vector<int>& film_counts, std::uint64_t seed);

}  // namespace nacre::discs
