#include "nacre/discs/disc_walker.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "nacre/discs/airy_disc.h"
#include "nacre/reference/events.h"

namespace nacre::discs {
namespace {

/// Light that travels more nearly along the layers, one ray in a million, is turned to this cosine:
/// it crosses the tile ten million times at most (kLeastTileShare) before it gets out of a slab
/// without flakes.
constexpr double kGrazing = 1e-6;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Vec3f to_float(const Direction3& v) {
    return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

}  // namespace

std::optional<volume::Escape> DiscWalker::run(double x_um, double y_um, const Direction3& travel,
                                              const Lanes& weight) {
    position_ = {x_um, y_um, 0};
    paint_.discs.tile().wrap(position_.x(), position_.y());
    moved_ = Direction3::Zero();
    travel_ = travel;
    leaving_ = DiscScene::kNone;
    slab_ = 0;
    slab_top_ = 0;
    weight_ = weight;
    alive_ = !reference::is_dark(weight);
    escape_.reset();
    for (std::uint64_t flights = 0; alive_; ++flights) {
        if (flights == reference::kMostFlights) reference::throw_endless_walk();
        fly();
    }
    return escape_;
}

/// To the next disc or pigment particle, or to the edge of the slab or of the tile, whichever comes
/// first.
void DiscWalker::fly() {
    if (std::abs(travel_.z()) < kGrazing) {
        travel_.z() = std::copysign(kGrazing, travel_.z());
        travel_.normalize();
    }
    const reference::Slab& slab = paint_.medium.slabs[slab_];
    const bool down = travel_.z() < 0;
    const double bottom = slab_top_ - slab.thickness_um;
    const double to_slab =
        std::max(0.0, ((down ? bottom : slab_top_) - position_.z()) / travel_.z());
    const Tile& tile = paint_.discs.tile();
    const double to_edge = tile.to_edge(position_.x(), position_.y(), travel_.x(), travel_.y());
    const double to_pigment =
        slab.pigment_rate_per_um > 0 ? random_.exponential() / slab.pigment_rate_per_um : kInfinity;
    double distance = std::min({to_slab, to_edge, to_pigment});
    const auto hit = paint_.discs.intersect(to_float(position_), to_float(travel_),
                                            static_cast<float>(distance), leaving_);
    if (hit) distance = hit->distance_um;
    position_ += distance * travel_;
    moved_ += distance * travel_;
    if (!reference::is_dark(slab.absorption_per_um)) {
        weight_ *=
            reference::attenuation(distance * slab.absorption_per_um, paint_.medium.lane_count);
        roulette();
        if (!alive_) return;
    }
    if (hit) {
        position_.z() = std::clamp(position_.z(), bottom, slab_top_);
        meet_disc(hit->disc);
    } else if (to_slab <= std::min(to_edge, to_pigment)) {
        down ? descend() : ascend();
    } else if (to_edge <= to_pigment) {
        tile.step_over(position_.x(), position_.y(), travel_.x(), travel_.y());
        leaving_ = DiscScene::kNone;
    } else {
        meet_pigment(slab);
    }
}

void DiscWalker::meet_disc(std::uint32_t number) {
    const Disc& disc = paint_.discs[number];
    leaving_ = number;
    const Direction3 normal = Direction3(disc.normal.x, disc.normal.y, disc.normal.z).normalized();
    const double projection = travel_.dot(normal);
    const auto optics =
        paint_.films[disc.species].at(disc.film, std::abs(projection), paint_.places);
    switch (
        reference::draw_flake_event(optics.reflectance, optics.transmittance, weight_, random_)) {
        case reference::FlakeEvent::reflected:
            travel_ = reference::mirrored(travel_, projection, normal);
            if (paint_.diffraction) travel_ = spread(travel_, normal, 2.0 * disc.radius_um);
            break;
        case reference::FlakeEvent::passed:
            break;
        case reference::FlakeEvent::absorbed:
            alive_ = false;
            return;
    }
    roulette();
}

/// The direction of the mirror image, spread by diffraction. What would leave along the disc or not
/// at all is drawn anew: 0.4 % at perpendicular incidence on a flake of 20 um.
Direction3 DiscWalker::spread(const Direction3& mirrored, const Direction3& normal,
                              double diameter_um) {
    const double scale = paint_.wavelength_um / (index_ * std::numbers::pi * diameter_um);
    const double upright = mirrored.dot(normal);
    const Direction3 flat = mirrored - upright * normal;
    const Direction3 across = normal.unitOrthogonal();
    // Flakes as small as the wavelength send out most of what they mirror in any direction: after
    // that many trials the mirror's own is as good.
    constexpr int kTrials = 64;
    for (int i = 0; i < kTrials; ++i) {
        const auto [share, turn] = random_.pair();
        const double q = scale * AiryDisc::radius_of_share(share);
        const double phi = 2 * std::numbers::pi * turn;
        const Direction3 tangential =
            flat + q * (std::cos(phi) * across + std::sin(phi) * normal.cross(across));
        const double rest = 1 - tangential.squaredNorm();
        if (rest > 0)
            return (tangential + std::copysign(std::sqrt(rest), upright) * normal).normalized();
    }
    return mirrored;
}

void DiscWalker::meet_pigment(const reference::Slab& slab) {
    leaving_ = DiscScene::kNone;
    if (const auto* pigment = reference::draw_pigment(slab, weight_, random_))
        travel_ = reference::sample_henyey_greenstein(travel_, pigment->anisotropy, random_);
}

void DiscWalker::descend() {
    const auto& slabs = paint_.medium.slabs;
    position_.z() = slab_top_ - slabs[slab_].thickness_um;
    if (slab_ + 1 < slabs.size()) {
        slab_top_ = position_.z();
        ++slab_;
        return;
    }
    weight_ *= paint_.medium.substrate_reflectance;
    if (reference::is_dark(weight_)) {
        alive_ = false;
        return;
    }
    leaving_ = DiscScene::kNone;
    travel_ = reference::sample_lambert(random_);
    roulette();
}

void DiscWalker::ascend() {
    position_.z() = slab_top_;
    if (slab_ > 0) {
        --slab_;
        slab_top_ += paint_.medium.slabs[slab_].thickness_um;
        return;
    }
    leaving_ = DiscScene::kNone;
    const auto passage = interface_.meet_from_inside(travel_, random_);
    travel_ = passage.travel;
    if (passage.inside) return;
    alive_ = false;
    moved_.z() = 0;
    escape_ = volume::Escape{travel_, moved_, weight_};
}

void DiscWalker::roulette() {
    alive_ = alive_ && reference::survives_roulette(weight_, paint_.medium.lane_count, random_);
}

}  // namespace nacre::discs
