#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "nacre/bsdf/models/hot_spot.h"
#include "nacre/core/quadrature.h"
#include "nacre/optics/fresnel.h"
#include "nacre/solver/solved_paint.h"
#include "nacre/sparkle/coat_tilt.h"

namespace nacre::bsdf {

/// Of light on its way from the layers to the interface, what is not there to be scattered again:
/// all but what the interface sends back through the cover.
/// @param clear, transmittance  of the cover and of the interface
template <class T>
T lost_at_interface(const T& clear, const T& transmittance) {
    return 1 - clear * clear * (1 - transmittance);
}

/// A paint at the eight wavelengths of a block, for what is worked out once a paint about its hot
/// spot. Light here has entered the coat, and directions are those of a smooth interface.
class HotSpotBlock {
 public:
    /// @param paint, tables  outlive this
    HotSpotBlock(const solver::SolvedPaint& paint, const HotSpotTables& tables, int block);

    HotSpot::Pair pair(const Ray& i, const Ray& o) const { return {hot_spot_, i, o}; }
    /// @param theta  outside
    Ray ray(double theta, double phi = 0) const;
    FloatLanes transmittance(const Ray& ray) const {
        return 1.0f - optics::dielectric_reflectance(splat(1.0f), ior_, splat(ray.outside.z));
    }
    FloatLanes inverse_ior2() const { return 1.0f / (ior_ * ior_); }
    /// Of the cover, along a ray: of the clearcoat and of the layers below it that only absorb.
    FloatLanes clear_transmittance(const Ray& ray) const;

    /// Of all layers and the clearcoat.
    FloatLanes transmittance_of_layers(const Ray& ray) const;

    /// Of the light that has just entered the coat from one direction.
    struct Budget {
        /// Phi: is there to be scattered again, by the equation of transfer.
        FloatLanes rescattered{};
        /// dPhi: of it, what leaves with the hot spot.
        FloatLanes hot_spot{};
    };
    /// A direction that light leaves in which is scattered evenly.
    struct Exit {
        Ray ray;
        FloatLanes solid_angle;  ///< inside, projected, and of the other half of the azimuths too
        FloatLanes ground_lost;  ///< of it, the fraction of the ground's light that lost() takes
    };
    /// @param polar  nodes of the angle outside
    /// @return none where all is flakes
    std::vector<Exit> exits(const Quadrature& polar) const;
    Budget budget(const Ray& i, std::span<const Exit> exits) const;

    /// Fraction of the light from i that is scattered at all, by a flake, a pigment or the ground.
    FloatLanes scattered_once(const Ray& i) const;
    /// lost_at_interface() of a smooth one.
    FloatLanes lost(const Ray& o) const;
    /// Single scattering in the layers with the hot spot over that without it; 1 where there is
    /// none. Under a rough clearcoat half vectors are spread as sparkle::CoatTilt says.
    /// @param phi   azimuth of o from that of i
    /// @param both  pair(i, o)
    FloatLanes single_gain(const Ray& i, const Ray& o, double phi, const HotSpot::Pair& both) const;

 private:
    FloatLanes lanes(const std::vector<double>& values) const;
    /// kappa: 1/um along the way in and out together.
    FloatLanes rate(std::size_t layer, const Ray& i, const Ray& o) const;
    void add_flakes(const Ray& i, Budget& sum) const;
    void add_others(const Ray& i, std::span<const Exit> exits, Budget& sum) const;
    void add_once(std::size_t layer, const Ray& i, const Ray& o, const FloatLanes& per_um,
                  Budget& sum) const;

    const solver::PaintMedium& medium_;
    int block_;
    std::array<WavelengthPosition, kLanes> where_;
    HotSpot hot_spot_;
    sparkle::CoatTilt coat_;
    float mean_ior_;
    FloatLanes ior_, ground_reflectance_;
    std::vector<std::vector<FloatLanes>> extinction_;  // by layer and direction
    std::size_t first_ = 0;   // layer that scatters; those above it are of the cover
    FloatLanes cover_depth_;  // along the normal
};

}  // namespace nacre::bsdf
