#include "nacre/volume/shell_walker.h"

#include <algorithm>
#include <cmath>

#include "nacre/optics/dielectric.h"
#include "nacre/reference/events.h"
#include "nacre/volume/flake_candidates.h"

namespace nacre::volume {

using reference::Flakes;
using reference::Slab;

std::optional<Escape> ShellWalker::run(const Direction3& travel, const Lanes& weight) {
    position_ = Direction3::Zero();
    travel_ = travel;
    weight_ = weight;
    slab_ = 0;
    slab_top_um_ = depth_um_ = 0;
    alive_ = true;
    escape_.reset();
    for (std::uint64_t flights = 0; alive_; ++flights) {
        if (flights == reference::kMostFlights) reference::throw_endless_walk();
        fly();
    }
    return escape_;
}

// The vector from the centre, over the outer radius: without cancellation, and for any curvature.
Direction3 ShellWalker::normal() const {
    return (Direction3::UnitZ() + outer_curvature_ * position_).normalized();
}

/// To the next candidate or to the edge of the slab, whichever comes first.
void ShellWalker::fly() {
    const Slab& slab = medium_.slabs[slab_];
    const double depth_below_surface = slab_top_um_ + depth_um_;
    const RadialRay ray{outer_curvature_ / (1 - outer_curvature_ * depth_below_surface),
                        travel_.dot(normal())};
    const double outwards = ray.distance_outwards(depth_um_);
    const double inwards = ray.distance_inwards(slab.thickness_um - depth_um_);
    const bool down = inwards < outwards;
    const double to_edge = std::min(outwards, inwards);
    // In a flat slab only: it would stay there for ever.
    if (outer_curvature_ == 0 && std::abs(ray.cosine) <= reference::kHorizontal) {
        alive_ = false;
        return;
    }
    const auto candidate = settings_.tracking == Tracking::delta
                               ? fly_delta(slab, ray, to_edge, random_)
                               : fly_simpson(slab, ray, to_edge, settings_.simpson_panels, random_);
    const double length = candidate ? candidate->distance_um : to_edge;
    position_ += length * travel_;
    if (!reference::is_dark(slab.absorption_per_um)) {
        weight_ *= reference::attenuation(length * slab.absorption_per_um, medium_.lane_count);
        roulette();
        if (!alive_) return;
    }
    if (candidate) {
        depth_um_ = std::clamp(depth_um_ - ray.rise(length), 0.0, slab.thickness_um);
        collide(slab, candidate->lot);
    } else if (down) {
        descend();
    } else {
        ascend();
    }
}

void ShellWalker::collide(const Slab& slab, double lot) {
    const double cosine = travel_.dot(normal());
    for (const Flakes& species : slab.flakes) {
        lot -= species.area_density_per_um * candidate_area(cosine, species.alpha);
        if (lot < 0) return meet_flake(species);
    }
    // Rounding may leave a lot at the very end of the flakes where there are no pigments.
    if (slab.pigments.empty()) return;
    if (const reference::Pigment* pigment = reference::draw_pigment(slab, weight_, random_))
        travel_ = reference::sample_henyey_greenstein(travel_, pigment->anisotropy, random_);
}

void ShellWalker::meet_flake(const Flakes& species) {
    const Direction3 up = normal();
    const double cosine_up = travel_.dot(up);
    const Direction3 across_up = travel_ - cosine_up * up;
    const double sine = across_up.norm();
    const CandidateSlopes slopes = sample_candidate(cosine_up, sine, species.alpha, random_);
    const double upright =
        1 / std::sqrt(1 + slopes.along * slopes.along + slopes.across * slopes.across);
    if (random_.uniform() >= upright) return;  // a candidate that was none
    // Straight down any pair of axes will do.
    constexpr double kVertical = 1e-9;
    const Direction3 along =
        sine > kVertical ? Direction3(across_up / sine) : Direction3(up.unitOrthogonal());
    const Direction3 flake =
        upright * (up - slopes.along * along - slopes.across * up.cross(along));
    const double projection = travel_.dot(flake);
    switch (reference::draw_flake_event(species.optics, std::abs(projection), weight_, random_)) {
        case reference::FlakeEvent::reflected:
            travel_ = reference::mirrored(travel_, projection, flake);
            break;
        case reference::FlakeEvent::passed:
            break;
        case reference::FlakeEvent::absorbed:
            alive_ = false;
            return;
    }
    roulette();
}

void ShellWalker::descend() {
    slab_top_um_ += medium_.slabs[slab_].thickness_um;
    if (slab_ + 1 < medium_.slabs.size()) {
        ++slab_;
        depth_um_ = 0;
        return;
    }
    slab_top_um_ -= medium_.slabs[slab_].thickness_um;
    depth_um_ = medium_.slabs[slab_].thickness_um;
    weight_ *= medium_.substrate_reflectance;
    if (reference::is_dark(weight_)) {
        alive_ = false;
        return;
    }
    const Direction3 up = normal(), local = reference::sample_lambert(random_);
    const Direction3 across = up.unitOrthogonal();
    travel_ = (local.x() * across + local.y() * up.cross(across) + local.z() * up).normalized();
    roulette();
}

void ShellWalker::ascend() {
    if (slab_ > 0) {
        --slab_;
        depth_um_ = medium_.slabs[slab_].thickness_um;
        slab_top_um_ -= depth_um_;
        return;
    }
    depth_um_ = 0;
    const Direction3 up = normal();
    const double cosine = std::max(0.0, travel_.dot(up));
    if (random_.uniform() < optics::dielectric_reflectance(index_, 1.0, cosine)) {
        travel_ = reference::mirrored(travel_, cosine, up);
        return;
    }
    const Direction3 tangential = index_ * (travel_ - cosine * up);
    const double cosine_outside = std::sqrt(std::max(0.0, 1 - tangential.squaredNorm()));
    escape_ = Escape{(tangential + cosine_outside * up).normalized(), position_, weight_};
    alive_ = false;
}

void ShellWalker::roulette() {
    alive_ = alive_ && reference::survives_roulette(weight_, medium_.lane_count, random_);
}

}  // namespace nacre::volume
