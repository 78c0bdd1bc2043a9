#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "nacre/bsdf/models/nacre_flakes.h"
#include "nacre/core/random.h"

// The nacre model's flakes sampled one by one: which directions, how bright each is guessed to be, and
// what it sends.

namespace nacre::bsdf {

namespace {

// Of what a flake is guessed to send, at the least: weights stay bounded where the guess is wrong.
constexpr float kMinSeen = 0.05f;

using sparkle::FlakeView;

constexpr IntLanes kNumbers = {0, 1, 2, 3, 4, 5, 6, 7};

// How many directions are drawn from each flake of a patch: in proportion to its weight, as the noise
// that it makes is. Most flakes that touch a patch have hardly more than an edge on it, and weigh
// little.
class DirectionCounts {
 public:
    static constexpr int kMax = 4 * NacreSpecies::kMaxDirections;

    /// @param directions  of a flake of the mean weight, weighted by itself
    DirectionCounts(const FlakeView& view, int directions)
        : directions_(static_cast<float>(directions)) {
        FloatLanes sum{}, squares{};
        for (int first = 0; first < view.count; first += kLanes) {
            const FloatLanes weight =
                kNumbers + first < view.count ? load_lanes(&view.weight[first]) : FloatLanes{};
            sum += weight;
            squares += weight * weight;
        }
        const float of_squares = lane_sum(squares);
        per_mean_ = of_squares > 0 ? lane_sum(sum) / of_squares : 0.0f;
    }

    /// Below 1, of flakes that weigh least: the probability with which they are sampled.
    /// @param weight  of one flake, or of eight
    template <class T>
    T of(const T& weight) const {
        constexpr float kRouletteBelow = 8;  // times as light as the mean
        const T relative = min_lanes(weight * per_mean_, T{} + 4.0f);
        const T number = max_lanes(to_float(whole(relative * directions_ + 0.5f)), T{} + 1.0f);
        return kRouletteBelow * relative < 1.0f ? kRouletteBelow * relative : number;
    }

 private:
    float directions_, per_mean_;
};

// 32 bits for each of eight flakes.
UintLanes bits_of_flakes(std::uint64_t random, const IntLanes& flakes) {
    const std::uint32_t step = static_cast<std::uint32_t>(random >> 32) | 1u;
    return mix_bits_32(static_cast<std::uint32_t>(random) +
                       step * __builtin_convertvector(flakes + 1, UintLanes));
}

// The flakes of a patch that are sampled, those with most directions first: eight that follow each
// other then have nearly as many.
class SamplingOrder {
 public:
    /// @param random  by which flakes that weigh least are sampled or not
    SamplingOrder(const FlakeView& view, const DirectionCounts& directions, std::uint64_t random) {
        std::array<std::uint8_t, FlakeView::kMax + kLanes> directions_of;
        std::array<int, DirectionCounts::kMax + 1> flakes_with{}, place{};
        for (int first = 0; first < view.count; first += kLanes) {
            const FloatLanes number = directions.of(load_lanes(&view.weight[first]));
            const FloatLanes u = sparkle::unit_fraction(bits_of_flakes(random, kNumbers + first));
            const IntLanes survives = u < number ? IntLanes{} + 1 : IntLanes{};
            const IntLanes here = number < 1.0f ? survives : whole(number);
            for (int lane = 0; lane < std::min(kLanes, view.count - first); ++lane) {
                directions_of[first + lane] = static_cast<std::uint8_t>(here[lane]);
                ++flakes_with[here[lane]];
            }
        }
        for (int n = DirectionCounts::kMax; n > 0; --n) {
            place[n] = count_;
            count_ += flakes_with[n];
        }
        for (int k = 0; k < view.count; ++k) {
            if (directions_of[k] > 0) flakes_[place[directions_of[k]]++] = k;
        }
    }
    int count() const { return count_; }
    /// Eight of them; in place of those beyond the last, any flake.
    IntLanes flakes(int first) const {
        IntLanes eight;
        std::memcpy(&eight, &flakes_[first], sizeof eight);
        return eight;
    }

 private:
    std::array<int, FlakeView::kMax + kLanes> flakes_{};
    int count_ = 0;
};

}  // namespace

Ray BoundNacre::typical_reflected(std::size_t species, const Ray& i) const {
    const sparkle::DiffractionLobe& lobe = tables_->species[species].field.lobe();
    const float slope = lobe.median_slope() / std::max(i.sine, 1e-6f);
    const Vec3f normal = i.sine > 1e-6f
                             ? normalize(Vec3f{-slope * i.outside.y, slope * i.outside.x, 1})
                             : normalize(Vec3f{lobe.median_slope(), 0, 1});
    const auto wo = leave(2 * dot(i.inside, normal) * normal - i.inside);
    return make_ray(wo ? *wo : Vec3f{-i.outside.x, -i.outside.y, i.outside.z});
}

BoundNacre::MeanFlakeReflectance BoundNacre::mean_flake_reflectance(std::size_t species) const {
    const sparkle::FlakeField& field = tables_->species[species].field;
    const sparkle::DiffractionLobe& lobe = field.lobe();
    const auto directions = static_cast<float>(tables_->species[species].directions);
    FlakeView view;  // of one typical flake
    view.count = 1;
    view.weight[0] = 1;
    view.typical_radius = field.constants().typical_radius;
    view.lobe_radius[0] = lobe.radius(static_cast<float>(field.population().diameter_um));
    // Of a flake that mirrors w_i into w_o: what it sends there by flake_weight(), and how many do,
    // per solid angle.
    struct Sent {
        FloatLanes light{};
        float flakes = 0;
    };
    const auto sent = [&](const Ray& i, const Ray& o, bool bare) {
        const HalfVector half(i, o, coat());
        if (!lobe.reaches(half.slope2)) return Sent{};
        view.slope_x[0] = half.slope.x;
        view.slope_y[0] = half.slope.y;
        const float seen = view.fraction(lobe, half.slope, half.cosine, 0, half.spread2) *
                           o.outside.z / flake_pdf(view, directions, species, 0, i, o);
        return Sent{seen * single_value(i, o, AllOfSpecies(*this, species, i, o, bare)),
                    lobe.slope_density(half.slope2) * half.per_solid_angle * solid_angle_ratio(o)};
    };
    MeanFlakeReflectance seen;
    for (int a = 0; a <= MeanFlakeReflectance::kEyeIntervals; ++a) {
        const float cosine_i = MeanFlakeReflectance::cosine(a, MeanFlakeReflectance::kEyeIntervals);
        const Ray i = make_ray({std::sqrt(1 - cosine_i * cosine_i), 0, cosine_i});
        const Ray typical = typical_reflected(species, i);
        const Sent bare = sent(i, typical, true), covered = sent(i, typical, false);
        const float covered_light = lane_sum(eye_ * covered.light);
        if (!(covered_light > 0)) continue;
        seen.light[a] = bare.light;
        // Outwards from as steep as w_i; beyond the last flakes as there.
        FloatLanes& relative = seen.relative[a];
        const auto fill = [&](int b, int before) {
            const float cosine = MeanFlakeReflectance::cosine(b, MeanFlakeReflectance::kIntervals),
                        sine = std::sqrt(1 - cosine * cosine);
            // In directions half around from where a flake that lies flat mirrors w_i.
            constexpr int kAzimuths = 3;
            float light = 0, flakes = 0;
            for (int n = 0; n < kAzimuths; ++n) {
                const float phi = std::numbers::pi_v<float> * n / (kAzimuths - 1);
                const Ray o = make_ray({-sine * std::cos(phi), sine * std::sin(phi), cosine});
                const Sent there = sent(i, o, false);
                const float weight = n == 0 || n == kAzimuths - 1 ? 0.5f : 1.0f;
                light += weight * there.flakes * lane_sum(eye_ * there.light);
                flakes += weight * there.flakes;
            }
            relative[b] = flakes > 0 ? std::max(light / (flakes * covered_light), kMinSeen)
                                     : relative[before];
        };
        constexpr int kLast = MeanFlakeReflectance::kIntervals;
        const int steep = a * kLast / MeanFlakeReflectance::kEyeIntervals;
        for (int b = steep; b >= 0; --b) fill(b, std::min(b + 1, kLast));
        for (int b = steep + 1; b <= kLast; ++b) fill(b, b - 1);
    }
    return seen;
}

void BoundNacre::sample_flakes(const Patch& patch, Vec3f wi, std::uint32_t random,
                               std::vector<FlakeSamples>& list) const {
    list.clear();
    // Directions of one flake are a lattice, shifted at random [cranley-patterson-1976].
    constexpr float kGolden = std::numbers::phi_v<float> - 1;
    if (wi.z <= 0) return;
    const PatchFlakes views(*this, patch, wi);
    const Ray i = make_ray(wi);
    const MeanFlakeReflectance::Place place(wi.z, MeanFlakeReflectance::kEyeIntervals);
    std::size_t layer = 0;
    for (std::size_t s = 0; s < tables_->species.size(); ++s) {
        while (layer + 1 < tables_->first_species.size() && tables_->first_species[layer + 1] <= s)
            ++layer;
        const FlakeView& view = views[s];
        const NacreSpecies& species = tables_->species[s];
        const FloatLanes depth = depth_there_and_back(layer, i);
        const MeanFlakeReflectance& flakes = mean_flake_reflectance_[s];
        const FloatLanes light = place.in(flakes.light);
        const FloatLanes relative = place.in(flakes.relative);
        // What lies above each of them as if the light came from there: that it comes from elsewhere
        // changes all nearly alike.
        const Ray typical = typical_reflected(s, i);
        std::optional<HotSpot::Pair> pair;
        if (hot_spot_) pair.emplace(*hot_spot_, i, typical);
        const DirectionCounts directions(view, species.directions);
        const std::uint64_t bits = hash_of(random, s);
        const SamplingOrder order(view, directions, ~bits);
        for (int first = 0; first < order.count(); first += kLanes) {
            const IntLanes flakes_here = order.flakes(first);
            const FloatLanes weight = kNumbers + first < order.count()
                                          ? gather(view.weight.data(), flakes_here)
                                          : FloatLanes{};
            const FloatLanes number = directions.of(weight);
            const FloatLanes rounds = max_lanes(number, splat(1.0f));
            const auto lobes = view.lobes(species.field.lobe(), i.inside, flakes_here);
            const FloatLanes facing = i.inside.x * lobes.x + i.inside.y * lobes.y + i.inside.z;
            const FloatLanes cosine = (facing < 0.0f ? -facing : facing) /
                                      sqrt_lanes(1.0f + lobes.x * lobes.x + lobes.y * lobes.y);
            // Of each flake, at eight wavelengths.
            std::array<FloatLanes, kLanes> colour{};
            relative_attenuations(s, layer, view, flakes_here, cosine, depth,
                                  pair ? &*pair : nullptr, colour);
            FloatLanes luminance{};
            for (int lane = 0; lane < kLanes; ++lane) {
                colour[lane] *= light;
                luminance[lane] = lane_sum(eye_ * colour[lane]);
            }
            // `light` is that of one of as many directions as a flake of the mean weight has.
            const FloatLanes strength =
                weight * luminance * (static_cast<float>(species.directions) / number);
            const FloatLanes per_luminance = luminance > 0.0f ? 1 / luminance : FloatLanes{};
            for (int lane = 0; lane < kLanes; ++lane) colour[lane] *= per_luminance[lane];
            const UintLanes by_flake = bits_of_flakes(bits, flakes_here);
            for (float n = 0; n < lane_max(rounds); ++n) {
                const FloatLanes u = sparkle::lower_half(by_flake) * 0x1p-16f + n / rounds;
                const FloatLanes turns = sparkle::upper_half(by_flake) * 0x1p-16f + n * kGolden;
                const auto half = lobes.sample({u < 1.0f ? u : u - 1.0f, turns});
                // The mirror image of w_i in a plane of this slope, and its refraction out.
                const FloatLanes sec2 = 1.0f + half.x * half.x + half.y * half.y;
                const FloatLanes twice =
                    2.0f * (i.inside.x * half.x + i.inside.y * half.y + i.inside.z) / sec2;
                const FloatLanes x = twice * half.x - i.inside.x, y = twice * half.y - i.inside.y;
                const FloatLanes z = twice - i.inside.z;
                const FloatLanes ox = mean_ior() * x, oy = mean_ior() * y;
                const FloatLanes oz2 = 1.0f - ox * ox - oy * oy;
                const FloatLanes oz = sqrt_lanes(max_lanes(oz2, FloatLanes{}));
                // sec^3 / (4 w_i.h): area of slopes per solid angle of w_o; then per that outside.
                const FloatLanes pdf = number * half.pdf * (0.5f * sec2 / (i.inside.z + z)) * oz /
                                       (z * (mean_ior() * mean_ior()));
                const auto leaves =
                    (oz2 > 1e-6f) & (z > 0.0f) & (pdf > 0.0f) & (strength > 0.0f) & (n < rounds);
                const FloatLanes seen =
                    strength *
                    MeanFlakeReflectance::Place(oz, MeanFlakeReflectance::kIntervals).in(relative);
                if (!any(leaves)) continue;
                FlakeSamples& samples = list.emplace_back();
                // A direction for those too that do not leave: whoever draws them looks into tables by it.
                samples.wo = {leaves ? ox : FloatLanes{}, leaves ? oy : FloatLanes{},
                              leaves ? oz : splat(1.0f)};
                samples.pdf = pdf;
                samples.strength = leaves ? seen : FloatLanes{};
                samples.colour = colour;
                samples.species = static_cast<int>(s);
                samples.number = flakes_here;
            }
        }
    }
}

float BoundNacre::flake_pdf(const FlakeView& view, float directions, std::size_t species, int flake,
                            const Ray& i, const Ray& o) const {
    const HalfVector half(i, o, coat());
    const sparkle::DiffractionLobe& lobe = tables_->species[species].field.lobe();
    return directions * view.lobe_pdf(lobe, i.inside, flake, half.slope) * half.per_solid_angle *
           solid_angle_ratio(o);
}

FloatLanes BoundNacre::flake_weight(const Patch& patch, Vec3f wi, const FlakeSample& sample) const {
    const PatchFlakes views(*this, patch, wi);
    const Ray i = make_ray(wi), o = make_ray(sample.wo);
    const HalfVector half(i, o, coat());
    const auto species = static_cast<std::size_t>(sample.species);
    const sparkle::FlakeView& view = views[species];
    const float fraction = view.fraction(tables_->species[species].field.lobe(), half.slope,
                                         half.cosine, sample.flake, half.spread2);
    if (fraction == 0) return FloatLanes{};
    SomeFlakes flakes(*this, species, view, i, o);
    flakes.add(sample.flake, fraction);
    return single_value(i, o, flakes) * (sample.wo.z / sample.pdf);
}

FloatLanes BoundNacre::flakes_at(const Patch& patch, Vec3f wi, Vec3f wo, float pdf) const {
    if (wi.z <= 0 || wo.z <= 0) return FloatLanes{};
    const PatchFlakes views(*this, patch, wi);
    const Ray i = make_ray(wi), o = make_ray(wo);
    const HalfVector half(i, o, coat());
    FloatLanes sum{};
    for (std::size_t s = 0; s < tables_->species.size(); ++s) {
        const sparkle::DiffractionLobe& lobe = tables_->species[s].field.lobe();
        const sparkle::FlakeView& view = views[s];
        if (view.count == 0 || !lobe.reaches(half.slope2)) continue;
        const DirectionCounts directions(view, tables_->species[s].directions);
        SomeFlakes flakes(*this, s, view, i, o);
        view.for_each_reflecting_flake(
            lobe, half.slope, half.cosine,
            [&](int k, float fraction) {
                const float own = flake_pdf(view, directions.of(view.weight[k]), s, k, i, o);
                flakes.add(k, fraction * power_heuristic(pdf, own));
            },
            half.spread2);
        if (!flakes.empty()) sum += single_value(i, o, flakes);
    }
    return sum;
}

}  // namespace nacre::bsdf
