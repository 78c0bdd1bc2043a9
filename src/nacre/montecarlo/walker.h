#pragma once

#include <cstddef>
#include <cstdint>

#include "nacre/montecarlo/events.h"
#include "nacre/montecarlo/medium.h"

namespace nacre::montecarlo {

/// Light on its way through the paint.
struct WalkState {
    Vec3d travel = Vec3d{};
    std::size_t slab = 0;
    double depth_um = 0;  ///< below the top of the slab; not used among discs
    Lanes weight{};
    bool unscattered = true;  ///< no flake, pigment, substrate or inner reflection so far
    bool alive = true;
};

/// What all walks share, whether they follow depth alone (depth_walk.h), positions in a shell
/// (shell_walk.h) or positions among discs (discs/disc_walk.h).
class Walker {
 protected:
    Walker(const Medium& medium, RandomStream& random) : medium_(medium), random_(random) {}

    void start(const Vec3d& travel, const Lanes& weight) {
        state_ = {};
        state_.travel = travel;
        state_.weight = weight;
        state_.alive = !is_dark(weight);
    }

    /// The binder's absorption over a piece of path.
    void absorb(const Slab& slab, double length_um) {
        if (is_dark(slab.absorption_per_um)) return;
        state_.weight *= attenuation(length_um * slab.absorption_per_um, medium_.lane_count);
        roulette();
    }

    /// Light meets a flake with this unit normal, of which `projection` is travel.normal.
    FlakeEvent collide_with_flake(const Lanes& reflectance, const Lanes& transmittance,
                                  double projection, const Vec3d& normal) {
        const FlakeEvent event =
            draw_flake_event(reflectance, transmittance, state_.weight, random_);
        if (event == FlakeEvent::reflected) {
            state_.travel = specular_direction(state_.travel, projection, normal);
            state_.unscattered = false;
        }
        if (event == FlakeEvent::absorbed) state_.alive = false;
        return event;
    }

    /// A candidate of slab.pigment_rate_per_um. There are none where rounding leaves a random
    /// number at the very end of the flakes of a slab without pigments.
    void collide_with_pigment(const Slab& slab) {
        if (slab.pigments.empty()) return;
        if (const Pigment* pigment = draw_pigment(slab, state_.weight, random_)) {
            state_.travel = sample_pigment(*pigment, state_.travel, state_.weight, random_);
            state_.unscattered = false;
        }
    }

    /// Reflection by the substrate. @return whether any light is left
    bool reflect_off_substrate() {
        state_.weight *= medium_.substrate_reflectance;
        state_.unscattered = false;
        state_.alive = !is_dark(state_.weight);
        return state_.alive;
    }

    void roulette() {
        state_.alive =
            state_.alive && survives_roulette(state_.weight, medium_.lane_count, random_);
    }

    const Slab& slab() const { return medium_.slabs[state_.slab]; }

    const Medium& medium_;
    RandomStream& random_;
    WalkState state_;
};

}  // namespace nacre::montecarlo
