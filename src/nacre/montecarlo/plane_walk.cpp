#include "nacre/montecarlo/plane_walk.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "nacre/montecarlo/depth_walk.h"
#include "nacre/optics/fresnel.h"

namespace nacre::montecarlo {
namespace {

/// Seeds a walk with all bits of the sample's numbers, so that the same ones give the same walk.
RandomStream stream_of(Vec3f wi, float u_select, Vec2f u) {
    const auto pair = [](float a, float b) {
        return std::uint64_t{std::bit_cast<std::uint32_t>(a)} << 32 |
               std::bit_cast<std::uint32_t>(b);
    };
    RandomStream random(pair(u.x, u.y), pair(wi.x, wi.y), pair(wi.z, u_select));
    // A renderer stratifies its numbers: the first flake's normal, which matters most, is drawn
    // from them, extended to the resolution of double.
    constexpr double kStep = 0x1p-24;
    const double x = u.x + kStep * random.uniform(), y = u.y + kStep * random.uniform();
    random.lead_with(x, y);
    return random;
}

bsdf::BsdfSample sample_of(const Escape& escape) {
    constexpr double kMmPerUm = 1e-3;
    return {.wo = to_float(escape.direction),
            .weight = to_float(escape.weight),
            .pdf = 1,
            .kind = bsdf::SampleKind::unknown_density,
            .exit_mm = to_float(kMmPerUm * escape.position_um)};
}

}  // namespace

BoundWalk::BoundWalk(const WalkTables& tables, const bsdf::Wavelengths& wavelengths_nm)
    : medium_(tables.grid.at(wavelengths_nm)) {
    for (int lane = 0; lane < kLanes; ++lane) {
        index_[lane] = tables.grid.index(wavelengths_nm[lane]);
        const bool like_last = lane > 0 && index_[lane] == index_[lane - 1];
        interfaces_[lane] = like_last
                                ? interfaces_[lane - 1]
                                : std::shared_ptr(make_air_interface(tables.recipe, index_[lane]));
        rough_ = rough_ || interfaces_[lane]->scatters();
        dispersive_ = dispersive_ || index_[lane] != index_[0];
    }
}

BoundWalk::Packet BoundWalk::draw_packet(const bsdf::Patch* patch, RandomStream& random) const {
    if (!dispersive_) return {splat(1.0), 0, patch};
    const int lane = static_cast<int>(kLanes * random.uniform());
    Packet packet{{}, lane, patch};
    packet.weight[lane] = kLanes;
    return packet;
}

Lanes BoundWalk::specular_reflectance(double cosine) const {
    if (rough_) return Lanes{};
    if (!dispersive_) return splat(optics::dielectric_reflectance(1.0, index_[0], cosine));
    return make_lanes<Lanes>(
        [&](int i) { return optics::dielectric_reflectance(1.0, index_[i], cosine); });
}

std::optional<bsdf::BsdfSample> BoundWalk::walk(const bsdf::Patch* patch, Vec3f wi, float u_select,
                                                Vec2f u) const {
    if (!(wi.z > 0)) return {};
    RandomStream random = stream_of(wi, u_select, u);
    const Vec3d towards_light = normalize(to_double(wi));
    const Packet packet = draw_packet(patch, random);
    if (rough_) {
        const auto escape = meet_rough(towards_light, packet, random);
        if (!escape) return {};
        return sample_of(*escape);
    }
    // Lobe probability in proportion to the rms contribution of each lobe under uniform light.
    const Lanes specular = specular_reflectance(towards_light.z);
    const double f = lane_mean(specular);
    const double inside = (1 - f) * typical_weight_;
    const double probability = f / (f + inside);
    if (u_select < probability) {
        return bsdf::BsdfSample{
            .wo = to_float(Vec3d{-towards_light.x, -towards_light.y, towards_light.z}),
            .weight = to_float(Lanes(specular / probability)),
            .pdf = static_cast<float>(probability),
            .kind = bsdf::SampleKind::specular};
    }
    const Lanes fraction = (1 - specular) * ((f + inside) / inside);
    const auto escape =
        enter_and_follow(towards_light, {packet.weight * fraction, packet.lane, patch}, random);
    if (!escape) return {};
    return sample_of(*escape);
}

std::optional<Escape> BoundWalk::enter_and_follow(const Vec3d& wi, const Packet& packet,
                                                  RandomStream& random) const {
    return follow(
        {interface(packet.lane).enter(wi, random).travel, packet.weight, packet.lane, packet.patch},
        random);
}

std::optional<Escape> BoundWalk::meet_rough(const Vec3d& wi, const Packet& packet,
                                            RandomStream& random) const {
    const auto passage = interface(packet.lane).sample_from_outside(wi, random);
    if (!passage.inside) return Escape{.direction = passage.travel, .weight = packet.weight};
    return follow({passage.travel, packet.weight, packet.lane, packet.patch}, random);
}

Lanes BoundWalk::mean_weight(double cosine, int walks, std::uint64_t number,
                             double* mean_square) const {
    const Vec3d wi{std::sqrt(1 - cosine * cosine), 0, cosine};
    RandomStream random(0, number, 0);
    Lanes sum{}, sum_of_squares{};
    for (int i = 0; i < walks; ++i) {
        const Packet packet = draw_packet(nullptr, random);
        const auto escape =
            rough_ ? meet_rough(wi, packet, random) : enter_and_follow(wi, packet, random);
        if (!escape) continue;
        sum += escape->weight;
        sum_of_squares += escape->weight * escape->weight;
    }
    if (mean_square) *mean_square = lane_mean(sum_of_squares) / walks;
    return sum / static_cast<double>(walks);
}

void BoundWalk::estimate_typical_weight() {
    constexpr int kWalks = 64;
    constexpr double kTypicalCosine = 0.8;
    // Below this, walks would be drawn so rarely that the few bright ones had large weights.
    constexpr double kMin = 0.1;
    double mean_square = 0;
    mean_weight(kTypicalCosine, kWalks, 0, &mean_square);
    typical_weight_ = std::max(std::sqrt(mean_square), kMin);
}

const Lanes& BoundWalk::inner_albedo(int i) const {
    std::call_once(albedo_once_[i], [&] {
        constexpr double kMinCosine = 1e-3;
        const double cosine = std::max(static_cast<double>(i) / kAlbedoIntervals, kMinCosine);
        inner_albedo_[i] =
            mean_weight(cosine, kAlbedoWalks, static_cast<std::uint64_t>(i) + 1, nullptr);
    });
    return inner_albedo_[i];
}

FloatLanes BoundWalk::albedo(Vec3f wi) const {
    if (!(wi.z > 0)) return FloatLanes{};
    const double cosine = std::min(static_cast<double>(wi.z), 1.0);
    const double x = cosine * kAlbedoIntervals;
    const int i = std::min(static_cast<int>(x), kAlbedoIntervals - 1);
    const Lanes low = inner_albedo(i), inner = low + (x - i) * (inner_albedo(i + 1) - low);
    const Lanes specular = specular_reflectance(cosine);
    return to_float(Lanes(specular + (1 - specular) * inner));
}

namespace {

/// Observer that ends the walk where light leaves the paint, reflected or transmitted at random.
class EscapeObserver {
 public:
    EscapeObserver(const AirInterface& interface, RandomStream& random)
        : interface_(interface), random_(random) {}

    bool follows(const WalkState&) const { return true; }
    void on_flight(const WalkState&, const Slab&, double, double) const {}
    void on_substrate(const Lanes&) const {}
    bool on_substrate_reflection(const Lanes&) const { return true; }
    void at_interface(WalkState& state) {
        const auto passage = interface_.sample_from_inside(state.travel, random_);
        state.travel = passage.travel;
        if (passage.inside) return;
        state.alive = false;
        escape = Escape{.direction = passage.travel, .weight = state.weight};
    }

    std::optional<Escape> escape;

 private:
    const AirInterface& interface_;
    RandomStream& random_;
};

class BoundPlaneWalk final : public BoundWalk {
 public:
    BoundPlaneWalk(const WalkTables& tables, const bsdf::Wavelengths& wavelengths_nm)
        : BoundWalk(tables, wavelengths_nm) {
        estimate_typical_weight();
    }

 private:
    std::optional<Escape> follow(const Entry& entry, RandomStream& random) const override {
        EscapeObserver observer(interface(entry.lane), random);
        DepthWalk(medium(), random, observer).run(entry.travel, entry.weight);
        return observer.escape;
    }
};

}  // namespace

PlaneWalk::PlaneWalk(const paint::Recipe& recipe, const std::vector<double>& wavelengths_nm,
                     const Progress& progress)
    : tables_(std::make_shared<const WalkTables>(recipe, wavelengths_nm, progress)) {}

PlaneWalk::~PlaneWalk() = default;

std::unique_ptr<const bsdf::BoundBsdf> PlaneWalk::bind(
    const bsdf::Wavelengths& wavelengths_nm) const {
    return std::make_unique<BoundPlaneWalk>(*tables_, wavelengths_nm);
}

constinit const bsdf::ModelInfo WalkModel::info = {
    .name = "walk",
    .summary = "random walks of light through the layers, one path at a time",
    .source = "position-free reference",
    .ingredients = bsdf::Ingredients::layers,
    .solution = bsdf::Solution::none,
    .can = {.goniochromism = true,
            .multiple_scattering = true,
            .reference_only = true,
            .estimated_values = true},
    .standard = bsdf::standard_model<WalkModel>};

std::shared_ptr<const bsdf::Bsdf> WalkModel::make(const bsdf::ModelInput& input,
                                                  const Progress& progress) const {
    return std::make_shared<const PlaneWalk>(input.recipe, spectra::default_wavelengths_nm(),
                                             progress);
}

}  // namespace nacre::montecarlo
