#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "nacre/bsdf/rgl_table.h"
#include "nacre/bsdf/square_warp.h"

// From directions to the unit square of an adaptive measurement, and back.   [dupuy-jakob-2018]

namespace nacre::bsdf {

/// Angle from the normal, without the loss of digits that acos has near it.
inline float polar_angle(Vec3f w) {
    const float chord = std::sqrt(w.x * w.x + w.y * w.y + (w.z - 1) * (w.z - 1));
    return 2 * std::asin(std::min(1.0f, 0.5f * chord));
}

/// theta = (pi/2) x^2, phi = (2 y - 1) pi.
inline Vec2f square_point(float theta, float phi) {
    constexpr float kPi = std::numbers::pi_v<float>;
    const float y = (phi + kPi) * (0.5f / kPi);
    return {std::sqrt(theta * (2 / kPi)), y - std::floor(y)};
}

/// The incident side of a lookup.
struct RglIncident {
    Vec3f direction;       ///< turned into the part of the hemisphere that was measured
    float flip_x, flip_y;  ///< what turned it: factors of 1 or -1
    float phi;             ///< azimuth from which those of half vectors count
    float inverse_sigma;
    SliceMix mix;
};

/// A half vector, or the point of the square that stands for it.
struct RglPoint {
    Vec2f sample;   ///< where the measurement is read
    Vec2f half;     ///< theta and phi of the half vector in the square of ndf and vndf
    Vec3f normal;   ///< the half vector
    float density;  ///< of `half` by vndf
};

class RglMap {
 public:
    explicit RglMap(const RglTable& table);

    RglIncident incident(Vec3f wi) const;
    /// The point for a pair of directions; wo in the same frame as i.direction.
    RglPoint towards(const RglIncident& i, Vec3f wo) const;
    /// The half vector for a point at which the measurement is read.
    RglPoint at(const RglIncident& i, Vec2f sample) const;
    /// What turns a value of the table into f cos(theta_o).
    float scale(const RglIncident& i, const RglPoint& point) const;
    /// Density per solid angle of wo, if `sample` is uniform.
    float solid_angle_density(const RglIncident& i, const RglPoint& point) const;

    const SliceGrid& grid() const { return grid_; }

 private:
    bool isotropic_, jacobian_;
    int parts_;  ///< how often the measured azimuths fit into the circle; 1: no symmetry
    SliceGrid grid_;
    SquareTable ndf_, sigma_;
    SquareWarp vndf_;
};

/// Bilinear.
float read_square(const SquareTable& table, Vec2f point);

}  // namespace nacre::bsdf
