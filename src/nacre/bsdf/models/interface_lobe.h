#pragma once

#include <vector>

#include "nacre/bsdf/bsdf.h"
#include "nacre/bsdf/flake_lobe.h"
#include "nacre/bsdf/models/direction_tables.h"
#include "nacre/core/lanes.h"
#include "nacre/core/vec.h"

namespace nacre::bsdf {

/// What the rough interface of a coat reflects of light from outside, at eight wavelengths: the lobe of
/// its facets, and evenly what they mask (solver::RoughInterface). Directions are in the frame of the
/// interface, whose normal is z; those below it reflect nothing.
class InterfaceLobe {
 public:
    /// @param roughness  Beckmann alpha, in (0, 1]
    /// @param ior        of the coat, each in (1, 3]
    /// @param mean_ior   by which directions are refracted
    /// @throws DomainError as solver::RoughInterface
    InterfaceLobe(double roughness, const FloatLanes& ior, float mean_ior);

    /// BRDF in 1/sr.
    FloatLanes eval(Vec3f wi, Vec3f wo) const;
    FloatLanes eval(const Ray& i, const Ray& o) const;
    /// Draws a direction of the facets' lobe, by three numbers in [0, 1); it may point downwards.
    Vec3f sample(Vec3f wi, float u_sign, Vec2f u) const { return lobe_.sample(wi, u_sign, u); }
    /// Density of sample() per solid angle.
    float pdf(Vec3f wi, Vec3f wo) const { return wi.z > 0 && wo.z > 0 ? lobe_.pdf(wi, wo) : 0; }
    FloatLanes pdf(Vec3f wi, const Vec3Lanes& wo) const { return lobe_.pdf(wi, wo); }
    /// Fraction of the light from outside that it lets into the coat.
    /// @param cosine  of the angle to its normal, outside, in [0, 1]
    FloatLanes transmittance(float cosine) const;

 private:
    FlakeLobe lobe_;
    FloatLanes ior_;
    float inverse_mean_ior_, inverse_alpha2_;
    // By direction: masking over the cosine, the fraction that is masked, and what is let in.
    std::vector<float> masking_;
    std::vector<FloatLanes> masked_, transmittance_;
    FloatLanes diffuse_scale_;
};

}  // namespace nacre::bsdf
