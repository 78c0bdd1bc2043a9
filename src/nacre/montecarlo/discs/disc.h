#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/core/progress.h"
#include "nacre/core/vec.h"
#include "nacre/paint/recipe.h"

namespace nacre::montecarlo {

/// A rectangle of paint with periodic boundary conditions: light that leaves it at one edge enters
/// it at the opposite one.
struct Tile {
    double width_um = 0, height_um = 0;

    /// Moves a position into the tile.
    void wrap(double& x, double& y) const {
        x = modulo(x, width_um);
        y = modulo(y, height_um);
    }
    /// Distance along a ray until it leaves the tile; infinite along the normal.
    double to_edge(double x, double y, double dx, double dy) const {
        return std::min(along(x, dx, width_um), along(y, dy, height_um));
    }
    /// Out at the edge that the ray has come to, in at the opposite one.
    void step_over(double& x, double& y, double dx, double dy) const {
        over(x, dx, width_um);
        over(y, dy, height_um);
    }

 private:
    static double modulo(double x, double period) {
        const double rest = x - period * std::floor(x / period);
        return rest < period ? rest : 0;
    }
    static double along(double x, double direction, double side) {
        if (direction == 0) return std::numeric_limits<double>::infinity();
        return std::max(0.0, ((direction > 0 ? side : 0) - x) / direction);
    }
    static void over(double& x, double direction, double side) {
        const double near = 1e-9 * side;  // rounding of the distance to the edge
        if (direction > 0 && x >= side - near) {
            x = 0;
        } else if (direction < 0 && x <= near) {
            x = side;
        }
    }
};

inline constexpr Range kTileSide{.lo = 0.01, .hi = 1000, .unit = "mm"};

// The flakes of a paint as discs at explicit positions.

/// One flake. The order of its parts is that of Embree's buffers (disc_scene.cpp).
struct Disc {
    Vec3f centre_um;  ///< z = 0 is the interface with the air, z < 0 below it
    float radius_um;
    Vec3f normal;           ///< unit, upwards
    std::uint16_t film;     ///< in DiscFilms of its species
    std::uint16_t species;  ///< counted through all layers from the top down
};

inline constexpr double kMaxDiscs = 8e6;

/// Of memory that a disc takes, Embree's acceleration structure included.
inline constexpr double kBytesPerDisc = 150;

/// Mean number of discs in a tile: rho H area, summed over all species.
double expected_discs(const paint::Recipe& recipe, const Tile& tile);
/// Mean number of discs with their copies from the tiles around that reach into it: many more where
/// flakes are wider than the tile.
double expected_copies(const paint::Recipe& recipe, const Tile& tile);

/// What draw_discs() refuses, before any work.
/// @throws DomainError naming the number of discs if it exceeds kMaxDiscs, or that of their copies
///         if it exceeds twice as many
/// @throws Error if the machine has less memory than they take
void require_discs(const paint::Recipe& recipe, const Tile& tile);

/// Draws the flakes of a recipe: of each species a Poisson number, centres uniform over the tile
/// and the thickness of their layer, Gaussian slopes of variance alpha^2 / 2 per component,
/// diameters by paint::FlakeSizes; rho is c over the mean area. Species are those of
/// paint::expanded().
///
/// Flakes may intersect each other, as in the equation of transfer, and reach into neighbouring
/// layers, but not out of the paint: a flake that would cross the interface or the substrate is
/// moved up or down until it does not. One that is taller than the paint is thick is centred in it
/// and crosses both; no light reaches its ends.
///
/// @param film_counts  DiscFilms::count() by species
/// @throws DomainError, Error as require_discs()
/// @throws Stopped if `work`, which may be null, asks to stop
std::vector<Disc> draw_discs(const paint::Recipe& recipe, const Tile& tile,
                             const std::vector<int>& film_counts, std::uint64_t seed,
                             SharedProgress* work = nullptr);

}  // namespace nacre::montecarlo
