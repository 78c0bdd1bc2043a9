#pragma once

#include <span>
#include <vector>

#include "nacre/montecarlo/events.h"
#include "nacre/montecarlo/interface.h"
#include "nacre/montecarlo/medium.h"
#include "nacre/montecarlo/reference.h"
#include "nacre/montecarlo/walker.h"

// The random walk in depth alone: the paint is the same everywhere along its plane. An observer
// decides what is recorded: that of depth_walk.cpp sums contributions to given detectors, that of
// plane_walk.cpp follows one packet of light out of the paint.

namespace nacre::montecarlo {

/// Observer:
///     bool follows(const WalkState&)      whether the walk is worth another flight
///     void on_flight(const WalkState&, const Slab&, double to_edge_um, double rate_per_um)
///                                         before it is known where the flight ends
///     void on_substrate(const Lanes& weight)
///     bool on_substrate_reflection(const Lanes& weight)   false ends the walk
///     void at_interface(WalkState&)       from inside: turns the light or ends the walk
template <class Observer>
class DepthWalk : private Walker {
 public:
    DepthWalk(const Medium& medium, RandomStream& random, Observer& observer)
        : Walker(medium, random), observer_(observer) {}

    /// @param travel  inside the paint, downwards
    void run(const Vec3d& travel, const Lanes& weight) {
        start(travel, weight);
        for (std::uint64_t flights = 0; state_.alive && std::abs(state_.travel.z) > kHorizontal;
             ++flights) {
            if (!observer_.follows(state_)) return;
            count_flight(flights);
            fly();
        }
    }

 private:
    /// To the next candidate or to the edge of the slab, whichever comes first.
    void fly() {
        const Slab& slab = this->slab();
        const bool down = state_.travel.z < 0;
        const double cosine = std::abs(state_.travel.z);
        const double to_edge =
            (down ? slab.thickness_um - state_.depth_um : state_.depth_um) / cosine;
        const double rate = slab.candidate_rate_per_um();
        observer_.on_flight(state_, slab, to_edge, rate);

        const double free_path = rate > 0 ? random_.exponential() / rate : to_edge;
        const bool collides = free_path < to_edge;
        const double length = collides ? free_path : to_edge;
        absorb(slab, length);
        if (!state_.alive) return;
        if (collides) {
            state_.depth_um =
                std::clamp(state_.depth_um - length * state_.travel.z, 0.0, slab.thickness_um);
            collide(slab, rate);
        } else if (down) {
            descend();
        } else {
            ascend();
        }
    }

    void collide(const Slab& slab, double rate) {
        double choice = random_.uniform() * rate;
        for (const Flakes& species : slab.flakes) {
            choice -= species.area_density_per_um;
            if (choice < 0) return collide_with_candidate(species);
        }
        collide_with_pigment(slab);
    }

    void collide_with_candidate(const Flakes& species) {
        const Vec3d normal = sample_beckmann_normal(species.alpha, species.lean, random_);
        const double projection = dot(state_.travel, normal);
        const double cosine = std::abs(projection);
        if (random_.uniform() >= cosine) return;  // not a real flake
        collide_with_flake(species.optics.reflectance(cosine), species.optics.transmittance(cosine),
                           projection, normal);
        roulette();
    }

    void descend() {
        if (state_.slab + 1 < medium_.slabs.size()) {
            ++state_.slab;
            state_.depth_um = 0;
            return;
        }
        observer_.on_substrate(state_.weight);
        if (!reflect_off_substrate()) return;
        if (!observer_.on_substrate_reflection(state_.weight)) {
            state_.alive = false;
            return;
        }
        state_.travel = sample_lambert(random_);
        state_.depth_um = slab().thickness_um;
        roulette();
    }

    void ascend() {
        if (state_.slab > 0) {
            --state_.slab;
            state_.depth_um = slab().thickness_um;
            return;
        }
        observer_.at_interface(state_);
        state_.depth_um = 0;
        state_.unscattered = false;
        roulette();
    }

    Observer& observer_;
};

// One random walk with its contributions to the detectors. The estimators: docs/reference.md.

/// A connection from inside the paint to a detector: the inner direction and the attenuation along
/// it.
class Connection {
 public:
    Connection(const AirInterface::Weighted& inner, const Medium& medium);

    const Vec3d& travel() const { return travel_; }
    bool is_dark() const { return weight_ == 0; }
    /// A bound from below, over the wavelengths, of the optical depth along the connection from
    /// `depth_um` below the top of slab number `slab`.
    double min_optical_depth(std::size_t slab, double depth_um) const {
        return slabs_[slab].min_above + depth_um * slabs_[slab].min_per_um;
    }
    /// Radiance outside per unit power scattered per sr and unit area at `depth_um` below the top
    /// of slab number `slab`: attenuation, 1 / mu and the interface's weight.
    /// @param spared  optical depth that is not counted
    Lanes from_slab(std::size_t slab, double depth_um, double spared = 0) const;
    /// Radiance outside per unit radiance that leaves the substrate.
    const Lanes& from_substrate() const { return from_substrate_; }

 private:
    /// Optical depth along the direction: of what lies above a slab, and per um of depth in it.
    struct Depths {
        Lanes above, per_um;
        double min_above, min_per_um;  ///< over the wavelengths
    };

    Vec3d travel_;
    double weight_;
    int lane_count_;
    std::vector<Depths> slabs_;
    Lanes from_substrate_;
};

/// Receives what a walk contributes.
struct WalkTally {
    std::vector<Lanes> radiance;  ///< per connection, for unit irradiance on the paint
    Lanes reflected{};            ///< power that left upwards, or never came in
    Lanes absorbed_by_substrate{};

    void clear();
};

/// Follows one unit of power from `towards_light` and adds its contributions to `tally`. Reflected
/// and absorbed power are complete only with Part::total.
void walk(const Medium& medium, const AirInterface& interface, const Vec3d& towards_light,
          std::span<const Connection> connections, Part part, RandomStream& random,
          WalkTally& tally);

}  // namespace nacre::montecarlo
