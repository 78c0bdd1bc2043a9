#include "nacre/montecarlo/depth_walk.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nacre::montecarlo {
namespace {

/// From places deeper than this, in optical depths along the way out, connections are made at
/// random. Of a white layer of 20 mean free paths most of a walk is deeper, and hardly any of its
/// light comes from there.
constexpr double kSureOpticalDepth = 1;

/// Observer that adds the contributions of a walk to a tally.
class NextEventObserver {
 public:
    NextEventObserver(const Medium& medium, const AirInterface& interface,
                      std::span<const Connection> connections, Part part, RandomStream& random,
                      WalkTally& tally)
        : medium_(medium),
          interface_(interface),
          connections_(connections),
          part_(part),
          random_(random),
          tally_(tally) {}

    bool follows(const WalkState& state) const {
        return part_ != Part::single || state.unscattered;
    }

    /// Next-event estimation with a forced candidate: a position on the flight is drawn from the
    /// law of the first candidate given that there is one, weighted with the probability of that,
    /// so that thin layers are no noisier than thick ones.
    void on_flight(const WalkState& state, const Slab& slab, double to_edge, double rate) {
        if (!(rate > 0) || !counts(state.unscattered ? Part::single : Part::multiple)) return;
        const double probability = -std::expm1(-rate * to_edge);
        const double place = -std::log1p(-random_.uniform() * probability) / rate;
        const double depth =
            std::clamp(state.depth_um - place * state.travel.z, 0.0, slab.thickness_um);
        Lanes power = (probability / rate) * state.weight;
        if (!is_dark(slab.absorption_per_um))
            power *= attenuation(place * slab.absorption_per_um, medium_.lane_count);
        // Roulette of connections: one is made if a free path goes as far. Its probability exp(-d),
        // d optical depths beyond the sure ones, is the attenuation that it is spared then.
        const double reach = kSureOpticalDepth + random_.exponential();
        for (std::size_t j = 0; j < connections_.size(); ++j) {
            const Connection& connection = connections_[j];
            if (connection.is_dark()) continue;
            const double least = connection.min_optical_depth(state.slab, depth);
            if (least > reach) continue;
            const Lanes scattered = slab.scattering(state.travel, connection.travel());
            if (is_dark(scattered)) continue;
            tally_.radiance[j] +=
                power * scattered *
                connection.from_slab(state.slab, depth, std::max(0.0, least - kSureOpticalDepth));
        }
    }

    void on_substrate(const Lanes& weight) {
        tally_.absorbed_by_substrate += weight * (1 - medium_.substrate_reflectance);
    }

    bool on_substrate_reflection(const Lanes& weight) {
        if (part_ == Part::single) return false;
        for (std::size_t j = 0; j < connections_.size(); ++j)
            tally_.radiance[j] +=
                (1 / std::numbers::pi) * weight * connections_[j].from_substrate();
        return true;
    }

    void at_interface(WalkState& state) {
        const AirInterface::Weighted reflection = interface_.reflect_inside(state.travel, random_);
        tally_.reflected += (1 - reflection.weight) * state.weight;
        state.weight *= reflection.weight;
        state.travel = reflection.travel;
    }

 private:
    bool counts(Part kind) const { return part_ == Part::total || part_ == kind; }

    const Medium& medium_;
    const AirInterface& interface_;
    std::span<const Connection> connections_;
    Part part_;
    RandomStream& random_;
    WalkTally& tally_;
};

}  // namespace

Connection::Connection(const AirInterface::Weighted& inner, const Medium& medium)
    : travel_(inner.travel), weight_(inner.weight), lane_count_(medium.lane_count) {
    const double mu = travel_.z;
    const auto least = [&](const Lanes& lanes) {
        double result = lanes[0];
        for (int i = 1; i < lane_count_; ++i) result = std::min(result, lanes[i]);
        return result;
    };
    Lanes depth{};
    double min_depth = 0;
    for (const Slab& slab : medium.slabs) {
        const Lanes per_um = slab.extinction(travel_) / mu;
        slabs_.push_back({depth, per_um, min_depth, least(per_um)});
        depth += slab.thickness_um * per_um;
        min_depth += slab.thickness_um * least(per_um);
    }
    from_substrate_ = weight_ * attenuation(depth, lane_count_);
}

Lanes Connection::from_slab(std::size_t slab, double depth_um, double spared) const {
    const Lanes depth = slabs_[slab].above + depth_um * slabs_[slab].per_um;
    return (weight_ / travel_.z) * attenuation(depth - spared, lane_count_);
}

void WalkTally::clear() {
    std::fill(radiance.begin(), radiance.end(), Lanes{});
    reflected = absorbed_by_substrate = Lanes{};
}

void walk(const Medium& medium, const AirInterface& interface, const Vec3d& towards_light,
          std::span<const Connection> connections, Part part, RandomStream& random,
          WalkTally& tally) {
    const AirInterface::Weighted entry = interface.enter(towards_light, random);
    Lanes weight{};
    for (int i = 0; i < medium.lane_count; ++i) {
        weight[i] = entry.weight;
        tally.reflected[i] += 1 - entry.weight;
    }
    NextEventObserver observer(medium, interface, connections, part, random, tally);
    DepthWalk(medium, random, observer).run(entry.travel, weight);
}

}  // namespace nacre::montecarlo
