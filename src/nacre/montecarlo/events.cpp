#include "nacre/montecarlo/events.h"

#include <fmt/format.h>

#include "nacre/core/error.h"
#include "nacre/core/progress.h"

namespace nacre::montecarlo {

void check_patience(std::uint64_t flights) {
    if (interrupt_requested()) throw Stopped("stopped in the middle of a random walk");
    if (flights < kMaxFlights) return;
    throw Error(
        fmt::format("a random walk met {} flakes or pigment particles and was still in the paint: "
                    "it is too thick, and absorbs too little, for the reference to follow light "
                    "through it",
                    kMaxFlights));
}

namespace {

// Turned by the angle of this cosine, at a random azimuth.
Vec3d turn_by(const Vec3d& in, double cosine, RandomStream& random) {
    const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
    const auto [c, sn] = random.cos_sin();
    const Vec3d across = perpendicular(in);
    return normalize(cosine * in + sine * (c * across + sn * cross(in, across)));
}

}  // namespace

Vec3d sample_pigment(const Pigment& pigment, const Vec3d& in, Lanes& weight, RandomStream& random) {
    if (!pigment.phase) return sample_henyey_greenstein(in, pigment.anisotropy, random);
    // One wavelength chooses the direction, as likely as its weight, and the others share it.
    const double total = lane_sum(weight);
    double choice = random.uniform() * total;
    int lane = 0;
    for (int i = 0; i < kLanes; ++i) {
        if (weight[i] <= 0) continue;
        lane = i;
        choice -= weight[i];
        if (choice < 0) break;
    }
    const double cosine = pigment.phase->cosine(lane, random.uniform());
    const Lanes turned = weight * pigment.phase->value(cosine);
    const double sum = lane_sum(turned);
    if (sum > 0) weight = turned * (total / sum);
    return turn_by(in, cosine, random);
}

Vec3d sample_henyey_greenstein(const Vec3d& in, double g, RandomStream& random) {
    const double s = 2 * random.uniform() - 1;
    const double d = 1 + g * s;
    const double cosine = std::clamp(
        (2 * s + g * (s * s + 3) + 2 * g * g * s + g * g * g * (s * s - 1)) / (2 * d * d), -1.0,
        1.0);
    return turn_by(in, cosine, random);
}

const Pigment* draw_pigment(const Slab& slab, Lanes& weight, RandomStream& random) {
    const double total = lane_sum(weight) * slab.pigment_rate_per_um;
    double choice = random.uniform() * total;
    for (const Pigment& pigment : slab.pigments) {
        const Lanes scattered = weight * pigment.scattering_per_um;
        const double sum = lane_sum(scattered);
        if (sum > 0 && choice < sum) {
            weight = scattered * (total / (sum * slab.pigment_rate_per_um));
            return &pigment;
        }
        choice -= sum;
    }
    const Lanes missed = weight * (slab.pigment_rate_per_um - slab.pigment_scattering_per_um);
    const double sum = lane_sum(missed);
    if (sum > 0) weight = missed * (total / (sum * slab.pigment_rate_per_um));
    return nullptr;
}

}  // namespace nacre::montecarlo
