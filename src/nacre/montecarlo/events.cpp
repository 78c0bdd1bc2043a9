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

Vec3d sample_henyey_greenstein(const Vec3d& in, double g, RandomStream& random) {
    const double s = 2 * random.uniform() - 1;
    const double d = 1 + g * s;
    const double cosine = std::clamp(
        (2 * s + g * (s * s + 3) + 2 * g * g * s + g * g * g * (s * s - 1)) / (2 * d * d), -1.0,
        1.0);
    const double sine = std::sqrt(1 - cosine * cosine);
    const auto [c, sn] = random.cos_sin();
    const Vec3d across = perpendicular(in);
    return normalize(cosine * in + sine * (c * across + sn * cross(in, across)));
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
