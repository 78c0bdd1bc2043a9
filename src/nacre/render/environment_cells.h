#pragma once

#include <vector>

#include "nacre/core/vec.h"
#include "nacre/render/environment.h"

namespace nacre::render {

/// A mip pyramid of an environment over cells of the sphere, for samples that stand for a solid angle:
/// small bright details, which few of them meet, would be fireflies.
class EnvironmentCells {
 public:
    /// @param detail  CompiledEnvironment::detail, > 0
    /// @param picture_width, picture_height  CompiledEnvironment's
    EnvironmentCells(const EnvironmentRadiance& environment, int detail, int picture_width,
                     int picture_height);

    /// The mean over the cell about the direction that is the smallest of at least this solid angle,
    /// if somewhere in it is more than kFireflyRatio times its mean; null if it is even enough, or smaller
    /// than cells get: there the environment stays as it is. Over the sphere, at one solid angle, the
    /// light is as much as without cells.
    const EnvironmentRadiance::Coefficients* spread(Vec3f direction, float solid_angle) const;
    static constexpr float kFireflyRatio = 8;

 private:
    struct Cell {
        EnvironmentRadiance::Coefficients mean{};
        bool has_firefly = false;
    };
    /// Of DirectionDistribution's map, `scale` times as many as the coarsest across and down.
    struct Level {
        int scale;
        std::vector<Cell> cells;
    };

    std::vector<Level> levels_;  // the coarsest first, each twice the scale of the one before
};

}  // namespace nacre::render
