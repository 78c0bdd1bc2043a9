#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "nacre/core/lanes.h"
#include "nacre/core/vec.h"
#include "nacre/paint/recipe.h"
#include "nacre/sparkle/plane_waves.h"

namespace nacre::sparkle {

/// The waves of a coat that is not flat, its orange peel, on one specimen.   [docs/orange-peel.md]
///
/// The height above the mean surface is a sum of plane waves in the object space of the shape, hence
/// defined on any shape, without seams and for any number of threads alike: for each band of
/// paint::kWaveBands
///
///     h(x) = sum_j a_j cos(2 pi (k_j.x / lambda_j + phi_j)),  a_j = lambda_j A / (2 pi),
///
/// with the waves of sparkle/plane_waves.h, so that each octave of the band has the same slopes. As the
/// directions k_j come in triples at right angles, the slope of the tangent plane along any line, on a
/// surface of any direction, has the band's root mean square exactly, over a surface that is large.
/// Of waves that run at an angle to the surface, an eighth of the squared slopes of a band looks longer
/// there than its upper end, nearly all of that within a factor of two.
///
/// Slopes are small: the height moves no point of the surface, and what a wave hides is not hidden.
///
/// That heights are a sum of waves of random phase, as noise is [rice-1945], alike in all directions and of
/// the same slope in each octave of a band, is a choice of this project: profiles of coats, and how
/// instruments weigh the bands, are not public.
class CoatWaves {
 public:
    /// @param seed  the specimen
    CoatWaves(const paint::OrangePeel& peel, std::uint64_t seed);

    /// Change of the height by the place, in object space: not yet that along a surface. To a few 1e-7 of
    /// the largest slopes.
    Vec3d gradient(Vec3f position_mm) const;
    double height_mm(Vec3f position_mm) const;

    /// Of the height along the surface.
    /// @param normal, tangent  of the surface, unit vectors at right angles, in object space
    /// @return along the tangent, and along normal x tangent
    Vec2f slope(Vec3f position_mm, Vec3f normal, Vec3f tangent) const;

 private:
    struct Group {  // eight waves
        PlaneWaveLanes waves;
        FloatLanes slope[3];  // A k_j
    };
    /// Calls act(group, its phases at a point in turns, within half a turn) for each.
    template <class Act>
    void for_each(Vec3f position_mm, const Act& act) const;

    std::vector<Group> groups_;
};

}  // namespace nacre::sparkle
