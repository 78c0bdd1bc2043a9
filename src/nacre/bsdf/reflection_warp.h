#pragma once

#include <functional>
#include <optional>

#include "nacre/bsdf/warp.h"
#include "nacre/core/vec.h"

namespace nacre::bsdf {

/// Draws directions nearly in proportion to what an isotropic paint under a flat interface
/// reflects, from a table of it: one map of the unit square to directions, without samples lost to
/// total reflection.
///
/// The square's first side is the slope t of the half vector inside, as t / (t + alpha) over its
/// largest value, the other its azimuth from the plane of incidence, both halves alike. So lobes of
/// flakes lie across many cells whatever their roughness. Between the nodes the density is
/// bilinear, and between incident directions linear: it is exact for what sample() draws.
///                                     [tabulated inverse transforms: dupuy-jakob-2018, rosenblatt-1952]
class ReflectionWarp {
 public:
    /// What is reflected from wi towards wo per solid angle, for white light from wi: BRDF times the
    /// cosine of wo; not negative. Called from several threads.
    using Flux = std::function<float(Vec3f wi, Vec3f wo)>;

    /// @param ior    of the coat, at least 1
    /// @param alpha  roughness of the narrowest lobes, inside
    ReflectionWarp(float ior, float alpha, const Flux& flux);

    /// What is known of an incident direction: outside, inside, and tan(theta/2) outside.
    struct Incident {
        Vec3f outside, inside;
        float x;
    };
    /// The direction outside for a point of [0, 1)^2; empty where light cannot leave.
    std::optional<Vec3f> sample(const Incident& i, Vec2f u) const;
    /// Density of sample(), per area of the slopes of half vectors inside.
    /// @param half  sum of both directions inside, of one pair or of eight
    template <class T>
    T slope_pdf(const Incident& i, const Vec3<T>& half) const;

    /// Integral of the flux over all wo: a guide, within a few per cent for paints, within
    /// kWorstAlbedoError at worst.
    float albedo(float x) const;
    static constexpr float kWorstAlbedoError = 0.25f;  ///< relative: of a white diffuser

 private:
    SliceMix slices(float x) const;
    Vec2f direction_of(const Incident& i) const;
    float radius(float u) const { return alpha_ * u / (1 - u); }

    float ior_, alpha_, end_;  // end_: t / (t + alpha) of the largest slope
    std::vector<float> albedo_;
    SquareWarp warp_;
};

template <class T>
T ReflectionWarp::slope_pdf(const Incident& i, const Vec3<T>& half) const {
    const T inverse = 1 / half.z, x = half.x * inverse, y = half.y * inverse;
    const Vec2f e = direction_of(i);
    const T along = -(x * e.x + y * e.y), across = y * e.x - x * e.y;
    // Density over slope is finite at its end.
    const T slope = max_lanes(sqrt_lanes(along * along + across * across), T{} + 1e-6f);
    const T scaled = slope / (slope + alpha_);
    // As the azimuth is laid out: along the sides of |x| + |y| = slope's.
    const T width = max_lanes(along, -along), depth = max_lanes(across, -across);
    const T sum = max_lanes(width + depth, slope);
    const T quarter = 0.5f * depth / sum;
    const T density =
        warp_.density(slices(i.x), Vec2<T>{scaled / end_, along < 0 ? 1 - quarter : quarter});
    const T rest = 1 - scaled;
    // d u / d slope and d v / d azimuth, over the slope.
    const T pdf = density * rest * rest * slope / (4 * alpha_ * end_ * sum * sum);
    return scaled < end_ ? pdf : T{};
}

}  // namespace nacre::bsdf
