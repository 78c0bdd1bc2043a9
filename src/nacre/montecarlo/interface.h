#pragma once

#include <memory>

#include "nacre/montecarlo/events.h"
#include "nacre/montecarlo/medium.h"

// The boundary between air and the paint, as a random walk uses it: light is sent in from outside,
// meets the boundary from inside, and is connected from inside to a detector outside. One object
// per binder index; all functions may be called from several threads.

namespace nacre::montecarlo {

class AirInterface {
 public:
    /// A direction of travel inside the paint with its weight, which makes the estimate unbiased.
    struct Weighted {
        Vec3d travel;
        double weight = 0;
    };

    /// A direction of travel after a meeting with the boundary, and on which side of it.
    struct Passage {
        Vec3d travel;
        bool inside = false;
    };

    virtual ~AirInterface() = default;

    /// Sends light in. @param towards_light  unit vector outside, z > 0
    /// @return travel inside (z < 0) and the fraction of the incident flux that enters so
    virtual Weighted enter(const Vec3d& towards_light, RandomStream& random) const = 0;

    /// Light that arrives from inside. @param travel  z > 0
    /// @return travel after reflection (z < 0) and the fraction of the flux that is reflected;
    ///         the remainder leaves the paint
    virtual Weighted reflect_inside(const Vec3d& travel, RandomStream& random) const = 0;

    /// The same two at random: all of the light goes one way, reflected or through.
    /// @param towards_light  unit vector outside, z > 0
    virtual Passage sample_from_outside(const Vec3d& towards_light, RandomStream& random) const = 0;
    /// @param travel  inside, z > 0
    virtual Passage sample_from_inside(const Vec3d& travel, RandomStream& random) const = 0;

    /// Connects the inside with a detector. @param towards_detector  unit vector outside, z > 0
    /// @return a direction of travel inside (z > 0) and a weight such that the radiance that leaves
    ///         towards the detector is the mean of  weight * (radiance inside along travel)
    virtual Weighted connect(const Vec3d& towards_detector, RandomStream& random) const = 0;

    /// Whether connect() draws at random, so that each walk needs connections of its own.
    virtual bool scatters() const = 0;

    /// Unbiased estimate of the BRDF of the interface by itself, in 1/sr, without specular
    /// reflection.
    virtual double reflect_outside(const Vec3d& towards_light, const Vec3d& towards_detector,
                                   RandomStream& random) const = 0;
};

/// A flat interface: specular reflection and refraction by Snell and Fresnel.
/// @param index  of the binder, >= 1
std::unique_ptr<const AirInterface> make_smooth_interface(double index);

/// Facets with Beckmann slopes, as solver/rough_interface.h defines them.
/// @param index  of the binder, > 1
/// @param alpha  above 0; masked light is found by trial, which takes some 1/alpha^2 trials
std::unique_ptr<const AirInterface> make_rough_interface(double index, double alpha);

/// The interface of a valid recipe whose binder has this index.
std::unique_ptr<const AirInterface> make_air_interface(const paint::Recipe& recipe, double index);

}  // namespace nacre::montecarlo
