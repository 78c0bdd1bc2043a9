#pragma once

#include "nacre/reference/events.h"

// The walk itself, of which only depth is followed: the paint is the same everywhere along its
// plane. What is done with it is the business of its observer: walk.h gathers statistics for given
// eyes, volume/plane_walk.h follows one packet of light out of the paint.

namespace nacre::reference {

struct WalkState {
    Direction3 travel;
    std::size_t slab = 0;
    double depth_um = 0;  ///< below the top of the slab
    Lanes weight{};
    bool untouched = true;  ///< no flake, pigment, substrate or inner reflection so far
    bool alive = true;
};

/// Observer:
///     bool follows(const WalkState&)      whether the walk is worth another flight
///     void flies(const WalkState&, const Slab&, double to_edge_um, double rate_per_um)
///                                         before it is known where the flight ends
///     void lands(const Lanes& weight)     on the substrate
///     bool lifts(const Lanes& weight)     off the substrate; false ends the walk
///     void surfaces(WalkState&)           at the top, going up: turns the light or ends the walk
template <class Observer>
class DepthWalk {
 public:
    DepthWalk(const Medium& medium, RandomStream& random, Observer& observer)
        : medium_(medium), random_(random), observer_(observer) {}

    /// @param travel  inside the paint, downwards
    void run(const Direction3& travel, const Lanes& weight) {
        state_ = {};
        state_.travel = travel;
        state_.weight = weight;
        state_.alive = !is_dark(weight);
        for (std::uint64_t flights = 0; state_.alive && std::abs(state_.travel.z()) > kHorizontal;
             ++flights) {
            if (!observer_.follows(state_)) return;
            if (flights == kMostFlights) throw_endless_walk();
            fly();
        }
    }

 private:
    /// To the next candidate or to the edge of the slab, whichever comes first.
    void fly() {
        const Slab& slab = medium_.slabs[state_.slab];
        const bool down = state_.travel.z() < 0;
        const double cosine = std::abs(state_.travel.z());
        const double to_edge =
            (down ? slab.thickness_um - state_.depth_um : state_.depth_um) / cosine;
        const double rate = slab.candidate_rate_per_um();
        observer_.flies(state_, slab, to_edge, rate);

        const double free_path = rate > 0 ? random_.exponential() / rate : to_edge;
        const bool collides = free_path < to_edge;
        const double length = collides ? free_path : to_edge;
        if (!is_dark(slab.absorption_per_um)) {
            state_.weight *= attenuation(length * slab.absorption_per_um, medium_.lane_count);
            roulette();
            if (!state_.alive) return;
        }
        if (collides) {
            state_.depth_um =
                std::clamp(state_.depth_um - length * state_.travel.z(), 0.0, slab.thickness_um);
            collide(slab, rate);
        } else if (down) {
            descend();
        } else {
            ascend();
        }
    }

    void collide(const Slab& slab, double rate) {
        double lot = random_.uniform() * rate;
        for (const Flakes& species : slab.flakes) {
            lot -= species.area_density_per_um;
            if (lot < 0) return meet_flake(species);
        }
        // Rounding may leave a lot at the very end of the flakes where there are no pigments.
        if (slab.pigments.empty()) return;
        if (const Pigment* pigment = draw_pigment(slab, state_.weight, random_)) {
            state_.travel = sample_henyey_greenstein(state_.travel, pigment->anisotropy, random_);
            state_.untouched = false;
        }
    }

    void meet_flake(const Flakes& species) {
        const Direction3 normal = sample_beckmann_normal(species.alpha, random_);
        const double projection = state_.travel.dot(normal);
        const double cosine = std::abs(projection);
        if (random_.uniform() >= cosine) return;  // a candidate that is not in the way
        switch (draw_flake_event(species.optics, cosine, state_.weight, random_)) {
            case FlakeEvent::reflected:
                state_.travel = mirrored(state_.travel, projection, normal);
                state_.untouched = false;
                break;
            case FlakeEvent::passed:
                break;
            case FlakeEvent::absorbed:
                state_.alive = false;
        }
        roulette();
    }

    void descend() {
        if (state_.slab + 1 < medium_.slabs.size()) {
            ++state_.slab;
            state_.depth_um = 0;
            return;
        }
        observer_.lands(state_.weight);
        state_.weight *= medium_.substrate_reflectance;
        if (is_dark(state_.weight) || !observer_.lifts(state_.weight)) {
            state_.alive = false;
            return;
        }
        state_.travel = sample_lambert(random_);
        state_.depth_um = medium_.slabs.back().thickness_um;
        state_.untouched = false;
        roulette();
    }

    void ascend() {
        if (state_.slab > 0) {
            --state_.slab;
            state_.depth_um = medium_.slabs[state_.slab].thickness_um;
            return;
        }
        observer_.surfaces(state_);
        state_.depth_um = 0;
        state_.untouched = false;
        roulette();
    }

    void roulette() {
        if (state_.alive && !survives_roulette(state_.weight, medium_.lane_count, random_))
            state_.alive = false;
    }

    const Medium& medium_;
    RandomStream& random_;
    Observer& observer_;
    WalkState state_;
};

}  // namespace nacre::reference
