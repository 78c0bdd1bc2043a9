#include "nacre/reference/walk.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "nacre/core/error.h"

namespace nacre::reference {
namespace {

/// Below this cosine a direction is taken to stay in the paint for ever; a walk meets such a
/// direction with a probability of the same order.
constexpr double kHorizontal = 1e-12;

/// A walk that takes longer is given up with an error. Light crosses a layer that does not absorb
/// after some square of its optical depth: 3000 is within reach.
constexpr std::uint64_t kMostFlights = 20'000'000;

/// A walk whose mean weight is below this goes on by lot.
constexpr double kRouletteThreshold = 0.1;

/// exp(-depth) in the lanes in use, zero in the others.
Lanes attenuation(const Lanes& depth, int lane_count) {
    Lanes result{};
    for (int i = 0; i < lane_count; ++i) result[i] = std::exp(-depth[i]);
    return result;
}

bool is_dark(const Lanes& lanes) { return lane_max(lanes) <= 0; }

Direction3 sample_beckmann_normal(double alpha, RandomStream& random) {
    const double slope = alpha * std::sqrt(random.exponential());
    const auto [c, s] = random.cos_sin();
    return Direction3(-slope * c, -slope * s, 1).normalized();
}

/// The inversion of Henyey and Greenstein's phase function, without its cancellation at small g.
Direction3 sample_henyey_greenstein(const Direction3& in, double g, RandomStream& random) {
    const double s = 2 * random.uniform() - 1;
    const double d = 1 + g * s;
    const double cosine = std::clamp(
        (2 * s + g * (s * s + 3) + 2 * g * g * s + g * g * g * (s * s - 1)) / (2 * d * d), -1.0,
        1.0);
    const double sine = std::sqrt(1 - cosine * cosine);
    const auto [c, sn] = random.cos_sin();
    const Direction3 across = in.unitOrthogonal();
    return (cosine * in + sine * (c * across + sn * in.cross(across))).normalized();
}

/// One walk. The weight per wavelength, `beta_`, has the mean that remains of the unit of power; an
/// event of probability P_i at wavelength i is drawn with the weighted mean probability
/// sum(beta_i P_i) / sum(beta_i), and multiplies beta_i by P_i over that. This is the balance
/// heuristic over walks for each wavelength by itself, so that no weight exceeds the number of
/// wavelengths.                                                    [wilkie-2014]
class Walker {
 public:
    Walker(const Medium& medium, const AirInterface& interface,
           std::span<const Connection> connections, Part part, RandomStream& random,
           WalkTally& tally)
        : medium_(medium),
          interface_(interface),
          connections_(connections),
          part_(part),
          random_(random),
          tally_(tally) {}

    void run(const Direction3& towards_light) {
        const AirInterface::Weighted entry = interface_.enter(towards_light, random_);
        travel_ = entry.travel;
        for (int i = 0; i < medium_.lane_count; ++i) {
            beta_[i] = entry.weight;
            tally_.reflected[i] += 1 - entry.weight;
        }
        alive_ = entry.weight > 0;
        for (std::uint64_t flights = 0; alive_ && std::abs(travel_.z()) > kHorizontal; ++flights) {
            if (part_ == Part::single && !untouched_) return;
            if (flights == kMostFlights) {
                throw Error(fmt::format(
                    "a random walk met {} flakes or pigment particles and was still in the paint: "
                    "it is too thick, and absorbs too little, for the reference to follow light "
                    "through it",
                    kMostFlights));
            }
            fly();
        }
    }

 private:
    bool counts(Part kind) const { return part_ == Part::total || part_ == kind; }

    /// To the next candidate or to the edge of the slab, whichever comes first.
    void fly() {
        const Slab& slab = medium_.slabs[slab_];
        const bool down = travel_.z() < 0;
        const double cosine = std::abs(travel_.z());
        const double to_edge = (down ? slab.thickness_um - depth_ : depth_) / cosine;
        const double rate = slab.candidate_rate_per_um();
        if (rate > 0 && counts(untouched_ ? Part::single : Part::multiple))
            connect_from_flight(slab, to_edge, rate);

        const double free_path = rate > 0 ? random_.exponential() / rate : to_edge;
        const bool collides = free_path < to_edge;
        const double length = collides ? free_path : to_edge;
        if (!is_dark(slab.absorption_per_um)) {
            beta_ *= attenuation(length * slab.absorption_per_um, medium_.lane_count);
            roulette();
        }
        if (collides) {
            depth_ = std::clamp(depth_ - length * travel_.z(), 0.0, slab.thickness_um);
            collide(slab, rate);
        } else if (down) {
            descend();
        } else {
            ascend();
        }
    }

    /// Next-event estimation with a forced candidate: a place on the flight is drawn from the law
    /// of the first candidate given that there is one, and weighs the probability of that, so that
    /// thin layers are no noisier than thick ones.
    void connect_from_flight(const Slab& slab, double to_edge, double rate) {
        const double probability = -std::expm1(-rate * to_edge);
        const double place = -std::log1p(-random_.uniform() * probability) / rate;
        const double depth = std::clamp(depth_ - place * travel_.z(), 0.0, slab.thickness_um);
        Lanes power = (probability / rate) * beta_;
        if (!is_dark(slab.absorption_per_um))
            power *= attenuation(place * slab.absorption_per_um, medium_.lane_count);
        for (std::size_t j = 0; j < connections_.size(); ++j) {
            if (connections_[j].is_dark()) continue;
            const Lanes scattered = slab.scattering(travel_, connections_[j].travel());
            if (is_dark(scattered)) continue;
            tally_.radiance[j] += power * scattered * connections_[j].from_slab(slab_, depth);
        }
    }

    void collide(const Slab& slab, double rate) {
        double lot = random_.uniform() * rate;
        for (const Flakes& species : slab.flakes) {
            lot -= species.area_density_per_um;
            if (lot < 0) return meet_flake(species);
        }
        // Rounding may leave a lot at the very end of the flakes where there are no pigments.
        if (!slab.pigments.empty()) meet_pigment(slab);
    }

    void meet_flake(const Flakes& species) {
        const Direction3 normal = sample_beckmann_normal(species.alpha, random_);
        const double projection = travel_.dot(normal);
        const double cosine = std::abs(projection);
        if (random_.uniform() >= cosine) return;  // a candidate that is not in the way
        const Lanes reflected = beta_ * species.optics.reflectance(cosine);
        const Lanes passed = beta_ * species.optics.transmittance(cosine);
        const double sum_reflected = lane_sum(reflected), sum_passed = lane_sum(passed);
        const double sum = sum_reflected + sum_passed;
        if (sum <= 0) {
            alive_ = false;
        } else if (random_.uniform() * sum < sum_reflected) {
            beta_ = reflected * (sum / sum_reflected);
            travel_ = (travel_ - 2 * projection * normal).normalized();
            untouched_ = false;
        } else {
            beta_ = passed * (sum / sum_passed);
        }
        roulette();
    }

    void meet_pigment(const Slab& slab) {
        const double total = lane_sum(beta_) * slab.pigment_rate_per_um;
        double lot = random_.uniform() * total;
        for (const Pigment& pigment : slab.pigments) {
            const Lanes scattered = beta_ * pigment.scattering_per_um;
            const double sum = lane_sum(scattered);
            if (sum > 0 && lot < sum) {
                beta_ = scattered * (total / (sum * slab.pigment_rate_per_um));
                travel_ = sample_henyey_greenstein(travel_, pigment.anisotropy, random_);
                untouched_ = false;
                return;
            }
            lot -= sum;
        }
        const Lanes missed = beta_ * (slab.pigment_rate_per_um - slab.pigment_scattering_per_um);
        const double sum = lane_sum(missed);
        if (sum > 0) beta_ = missed * (total / (sum * slab.pigment_rate_per_um));
    }

    void descend() {
        if (slab_ + 1 < medium_.slabs.size()) {
            ++slab_;
            depth_ = 0;
            return;
        }
        const Lanes& reflectance = medium_.substrate_reflectance;
        tally_.absorbed_by_substrate += beta_ * (1 - reflectance);
        beta_ *= reflectance;
        if (is_dark(beta_) || part_ == Part::single) {
            alive_ = false;
            return;
        }
        for (std::size_t j = 0; j < connections_.size(); ++j)
            tally_.radiance[j] += (1 / std::numbers::pi) * beta_ * connections_[j].from_substrate();
        const double sine_sq = random_.uniform();
        const auto [c, s] = random_.cos_sin();
        const double sine = std::sqrt(sine_sq);
        travel_ = Direction3(sine * c, sine * s, std::sqrt(1 - sine_sq));
        depth_ = medium_.slabs.back().thickness_um;
        untouched_ = false;
        roulette();
    }

    void ascend() {
        if (slab_ > 0) {
            --slab_;
            depth_ = medium_.slabs[slab_].thickness_um;
            return;
        }
        const AirInterface::Weighted reflection = interface_.reflect_inside(travel_, random_);
        tally_.reflected += (1 - reflection.weight) * beta_;
        beta_ *= reflection.weight;
        travel_ = reflection.travel;
        depth_ = 0;
        untouched_ = false;
        roulette();
    }

    void roulette() {
        const double mean = lane_sum(beta_) / medium_.lane_count;
        if (mean >= kRouletteThreshold) return;
        if (random_.uniform() * kRouletteThreshold >= mean)
            alive_ = false;
        else
            beta_ *= kRouletteThreshold / mean;
    }

    const Medium& medium_;
    const AirInterface& interface_;
    std::span<const Connection> connections_;
    Part part_;
    RandomStream& random_;
    WalkTally& tally_;

    Direction3 travel_;
    std::size_t slab_ = 0;
    double depth_ = 0;  ///< um below the top of the slab
    Lanes beta_{};
    bool untouched_ = true;  ///< no flake, pigment, substrate or inner reflection so far
    bool alive_ = true;
};

}  // namespace

Connection::Connection(const AirInterface::Weighted& inner, const Medium& medium)
    : travel_(inner.travel), weight_(inner.weight), lane_count_(medium.lane_count) {
    const double mu = travel_.z();
    Lanes depth{};
    for (const Slab& slab : medium.slabs) {
        depth_above_.push_back(depth);
        depth_per_um_.push_back(slab.extinction(mu) / mu);
        depth += slab.thickness_um * depth_per_um_.back();
    }
    depth_above_.push_back(depth);
}

Lanes Connection::from_slab(std::size_t slab, double depth_um) const {
    return (weight_ / travel_.z()) *
           attenuation(depth_above_[slab] + depth_um * depth_per_um_[slab], lane_count_);
}

Lanes Connection::from_substrate() const {
    return weight_ * attenuation(depth_above_.back(), lane_count_);
}

void WalkTally::clear() {
    std::fill(radiance.begin(), radiance.end(), Lanes{});
    reflected = absorbed_by_substrate = Lanes{};
}

void walk(const Medium& medium, const AirInterface& interface, const Direction3& towards_light,
          std::span<const Connection> connections, Part part, RandomStream& random,
          WalkTally& tally) {
    Walker(medium, interface, connections, part, random, tally).run(towards_light);
}

}  // namespace nacre::reference
