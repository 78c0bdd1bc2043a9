#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <new>
#include <numbers>

#include "nacre/bsdf/models/hot_spot_brdf.h"
#include "nacre/bsdf/models/nacre.h"
#include "nacre/core/lane_math.h"
#include "nacre/core/random.h"

// Light that the nacre model reflects on a patch: its value, its sampling, its flakes one by one.

namespace nacre::bsdf {

namespace {

constexpr float kWide = std::numeric_limits<float>::infinity();

// On a patch the flake lobe of the mean keeps at least this fraction of its probability: multiple
// scattering follows that lobe too, as do the rings of the flakes' patterns, and it bounds the weights
// of directions for which no single flake is sampled.
constexpr float kMinMeanProbability = 0.15f;

// Of what a flake is guessed to send, at the least: weights stay bounded where the guess is wrong.
constexpr float kLeastSeen = 0.05f;

// The half vector inside, as the flakes see it.
struct HalfVector {
    Vec2f slope;
    float slope2, cosine;   // cosine: w_i . h
    float per_solid_angle;  // area of slopes per solid angle of w_o
    float spread2;          // by a rough clearcoat

    HalfVector(const Ray& i, const Ray& o, const sparkle::CoatTilt& coat)
        : spread2(coat.spread2(i.inside.z, o.inside.z)) {
        const Vec3f sum = i.inside + o.inside;
        const float inverse = 1 / sum.z;
        slope = {sum.x * inverse, sum.y * inverse};
        slope2 = slope.x * slope.x + slope.y * slope.y;
        const float sec2 = 1 + slope2;
        cosine = std::min(1.0f, 0.5f * sum.z * std::sqrt(sec2));
        // sec^3 / (4 w_i.h): area of slopes per solid angle of h over solid angle of w_o per that.
        per_solid_angle = 0.5f * inverse * sec2;
    }
};

}  // namespace

// In place of MeanFlakes: the mean of all flakes, with the hot spot if there is one.
class BoundNacre::WithHotSpot {
 public:
    WithHotSpot(const BoundNacre& surface, const Ray& i, const Ray& o) {
        if (surface.hot_spot_) pair_.emplace(*surface.hot_spot_, i, o);
    }
    FloatLanes factor(std::size_t layer, std::size_t /*flake*/, const FloatLanes& depth) const {
        return pair_ ? pair_->mean(layer, depth) : splat(1.0f);
    }
    FloatLanes pigment_factor(std::size_t layer, const FloatLanes& depth) const {
        return pair_ ? pair_->mean(layer, depth) : splat(1.0f);
    }
    FloatLanes multiple(const FloatLanes& multiple) const {
        return pair_ ? pair_->multiple(multiple) : multiple;
    }
    FloatLanes multiple(const FloatLanes& multiple, const FloatLanes& closing) const {
        return pair_ ? pair_->multiple(multiple, closing) : multiple;
    }
    FloatLanes closing() const { return pair_ ? pair_->closing() : splat(1.0f); }
    FloatLanes returned_gain() const { return pair_ ? pair_->returned_gain() : splat(1.0f); }
    // What the table of single scattering under a rough clearcoat holds.
    const WithHotSpot& mean() const { return *this; }

 protected:
    std::optional<HotSpot::Pair> pair_;
};

// In place of MeanFlakes: those of a patch.
class BoundNacre::FlakesOfPatch : public WithHotSpot {
 public:
    FlakesOfPatch(const BoundNacre& surface, const Look& look, const Ray& i, const Ray& o)
        : WithHotSpot(surface, i, o), surface_(surface), look_(look), half_(i, o, surface.coat()) {}

    FloatLanes factor(std::size_t layer, std::size_t flake, const FloatLanes& depth) const {
        const std::size_t at = surface_.tables_->first_species[layer] + flake;
        const sparkle::DiffractionLobe& lobe = surface_.tables_->species[at].field.lobe();
        if (!lobe.reaches(half_.slope2)) return pair_ ? pair_->mean(layer, depth) : splat(1.0f);
        const sparkle::FlakeView& view = look_[at];
        FloatLanes reflected{};
        bool any = false;
        const float background = view.for_each_answer(
            lobe, half_.slope, half_.cosine,
            [&](int k, float fraction) {
                any = true;
                reflected +=
                    fraction * surface_.relative_attenuation(at, layer, view, k, half_.cosine,
                                                             depth, pair_ ? &*pair_ : nullptr);
            },
            half_.spread2);
        FloatLanes sum = splat(background);
        if (pair_ && background > 0) sum *= pair_->mean(layer, depth);
        if (any) {
            const FloatLanes safe = max_lanes(depth, splat(1e-20f));
            sum += reflected * (safe / one_minus_exp_lanes(safe));
        }
        return sum;
    }

 private:
    const BoundNacre& surface_;
    const Look& look_;
    HalfVector half_;
};

// In place of MeanFlakes: what is left where flakes are asked one by one.
class BoundNacre::BesideFlakes : public WithHotSpot {
 public:
    BesideFlakes(const BoundNacre& surface, const Look& look, const Ray& i, const Ray& o)
        : WithHotSpot(surface, i, o), surface_(surface), look_(look), half_(i, o, surface.coat()) {}

    FloatLanes factor(std::size_t layer, std::size_t flake, const FloatLanes& depth) const {
        const std::size_t at = surface_.tables_->first_species[layer] + flake;
        const sparkle::DiffractionLobe& lobe = surface_.tables_->species[at].field.lobe();
        const float background =
            lobe.reaches(half_.slope2)
                ? look_[at].background_at(lobe, half_.slope2, half_.cosine, half_.spread2)
                : 1.0f;
        return pair_ && background > 0 ? background * pair_->mean(layer, depth) : splat(background);
    }

 private:
    const BoundNacre& surface_;
    const Look& look_;
    HalfVector half_;
};

// In place of MeanFlakes: flakes of one species of a patch, and nothing else.
class BoundNacre::SomeFlakes : public WithHotSpot {
 public:
    static constexpr bool kFlakesAlone = true;

    SomeFlakes(const BoundNacre& surface, std::size_t species, const sparkle::FlakeView& view,
               const Ray& i, const Ray& o)
        : WithHotSpot(surface, i, o),
          surface_(surface),
          species_(species),
          view_(view),
          cosine_(HalfVector(i, o, surface.coat()).cosine) {}
    /// @param fraction  of the mean of the species
    void add(int flake, float fraction) {
        if (count_ == static_cast<int>(answers_.size())) return;
        answers_[count_++] = {flake, fraction};
    }
    bool empty() const { return count_ == 0; }

    bool reflects(std::size_t layer, std::size_t flake) const {
        return surface_.tables_->first_species[layer] + flake == species_;
    }
    FloatLanes factor(std::size_t layer, std::size_t, const FloatLanes& depth) const {
        FloatLanes sum{};
        for (int n = 0; n < count_; ++n) {
            sum += answers_[n].fraction *
                   surface_.relative_attenuation(species_, layer, view_, answers_[n].flake, cosine_,
                                                 depth, pair_ ? &*pair_ : nullptr);
        }
        const FloatLanes safe = max_lanes(depth, splat(1e-20f));
        return sum * (safe / one_minus_exp_lanes(safe));
    }

 private:
    struct Answer {
        int flake;
        float fraction;
    };
    const BoundNacre& surface_;
    std::size_t species_;
    const sparkle::FlakeView& view_;
    float cosine_;
    std::array<Answer, sparkle::FlakeView::kMax> answers_;
    int count_ = 0;
};

// In place of MeanFlakes: all flakes of one species, and nothing else.
class BoundNacre::AllOfSpecies : public WithHotSpot {
 public:
    static constexpr bool kFlakesAlone = true;

    /// @param bare  with nothing in their layer above them
    AllOfSpecies(const BoundNacre& surface, std::size_t species, const Ray& i, const Ray& o,
                 bool bare)
        : WithHotSpot(surface, i, o), surface_(surface), species_(species), bare_(bare) {}

    bool reflects(std::size_t layer, std::size_t flake) const {
        return surface_.tables_->first_species[layer] + flake == species_;
    }
    FloatLanes factor(std::size_t layer, std::size_t flake, const FloatLanes& depth) const {
        if (!bare_) return WithHotSpot::factor(layer, flake, depth);
        const FloatLanes safe = max_lanes(depth, splat(1e-20f));
        return safe / one_minus_exp_lanes(safe);
    }

 private:
    const BoundNacre& surface_;
    std::size_t species_;
    bool bare_;
};

BoundNacre::Look::Look(const BoundNacre& surface, const Patch& patch, Vec3f wi)
    : own_(patch.memory ? 0 : surface.patch_memory_bytes()) {
    using sparkle::FlakeView;
    PatchMemory& memory = patch.memory ? *patch.memory : own_;
    // Those for a narrow light lie behind the others: one patch may need both.
    const std::vector<NacreSpecies>& species = surface.tables_->species;
    const bool narrow = patch.narrow_light > 0;
    FlakeView* const views =
        reinterpret_cast<FlakeView*>(memory.data()) + (narrow ? species.size() : 0);
    views_ = views;
    const unsigned bit = narrow ? 2 : 1;
    if (memory.filled & bit) return;
    for (std::size_t s = 0; s < species.size(); ++s) {
        FlakeView& view = *new (views + s) FlakeView;
        const sparkle::FlakeField& field = species[s].field;
        if (patch.flakes == Patch::Flakes::shown) {
            field.look(patch.footprint, view);
            continue;
        }
        const sparkle::FlakeField::StandIns stand_ins{
            narrow ? std::min(1.0f, surface.slope_density(s, wi) / patch.narrow_light) : kWide,
            !narrow};
        if (patch.flakes == Patch::Flakes::apart) {
            field.look(patch.footprint, view, stand_ins);
        } else {
            field.leave_out(patch.footprint, view, stand_ins);
        }
    }
    memory.filled |= bit;
}

float BoundNacre::slope_density(std::size_t species, Vec3f wi) const {
    const Ray i = make_ray(wi);
    return HalfVector(i, i, coat()).per_solid_angle * solid_angle_ratio(i) /
           tables_->species[species].field.lobe_area(i.inside.z);
}

float BoundNacre::narrow_light(Vec3f wi) const {
    float narrowest = 0;
    for (std::size_t s = 0; s < tables_->species.size(); ++s) {
        narrowest = std::max(
            narrowest, static_cast<float>(tables_->species[s].directions) * slope_density(s, wi));
    }
    return narrowest > 0 ? narrowest : std::numeric_limits<float>::infinity();
}

BoundNacre::BoundNacre(std::shared_ptr<const Nacre::Tables> tables, const Wavelengths& wavelengths)
    : BoundMicroflake(tables->smooth, wavelengths), tables_(std::move(tables)) {
    bind_rough_single();
    for (const NacreSpecies& species : tables_->species) {
        films_.push_back(species.films ? species.films->bind(where()) : BoundFlakeFilms());
    }
    if (tables_->hot_spot) hot_spot_.emplace(*tables_->hot_spot, where());
    for (const HotSpotTables& node : tables_->hot_spot_nodes)
        hot_spot_nodes_.emplace_back(node, where());
    const FloatLanes eye = response_of_eye(wavelengths);
    for (std::size_t s = 0; s < tables_->species.size(); ++s)
        seen_flakes_.push_back(seen_flakes(s, eye));
}

Ray BoundNacre::typical_mirrored(std::size_t species, const Ray& i) const {
    const sparkle::DiffractionLobe& lobe = tables_->species[species].field.lobe();
    const float slope = lobe.median_slope() / std::max(i.sine, 1e-6f);
    const Vec3f normal = i.sine > 1e-6f
                             ? normalize(Vec3f{-slope * i.outside.y, slope * i.outside.x, 1})
                             : normalize(Vec3f{lobe.median_slope(), 0, 1});
    const auto wo = leave(2 * dot(i.inside, normal) * normal - i.inside);
    return make_ray(wo ? *wo : Vec3f{-i.outside.x, -i.outside.y, i.outside.z});
}

BoundNacre::SeenFlakes BoundNacre::seen_flakes(std::size_t species, const FloatLanes& eye) const {
    const sparkle::FlakeField& field = tables_->species[species].field;
    const sparkle::DiffractionLobe& lobe = field.lobe();
    sparkle::FlakeView view;  // of one typical flake
    view.count = 1;
    view.weight[0] = 1;
    view.typical_radius = field.constants().typical_radius;
    view.lobe_radius[0] = lobe.radius(static_cast<float>(field.population().diameter_um));
    // Of a flake that mirrors w_i into w_o: what it sends there by flake_weight(), as an eye sees it, and
    // how many do, per solid angle.
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
                           o.outside.z / flake_pdf(view, species, 0, i, o);
        return Sent{seen * eye * single_value(i, o, AllOfSpecies(*this, species, i, o, bare)),
                    lobe.slope_density(half.slope2) * half.per_solid_angle * solid_angle_ratio(o)};
    };
    SeenFlakes seen;
    for (int a = 0; a < SeenFlakes::kNodes; ++a) {
        const float cosine_i = SeenFlakes::cosine(a);
        const Ray i = make_ray({std::sqrt(1 - cosine_i * cosine_i), 0, cosine_i});
        const Ray typical = typical_mirrored(species, i);
        const Sent bare = sent(i, typical, true), covered = sent(i, typical, false);
        if (!(lane_sum(covered.light) > 0)) continue;
        seen.light[a] = bare.light;
        // Outwards from as steep as w_i; beyond the last flakes as there.
        SeenFlakes::ByCosine<float>& relative = seen.relative[a];
        const auto fill = [&](int b, int before) {
            const float cosine = SeenFlakes::cosine(b), sine = std::sqrt(1 - cosine * cosine);
            // In directions half around from where a flake that lies flat mirrors w_i.
            constexpr int kAzimuths = 3;
            float light = 0, flakes = 0;
            for (int n = 0; n < kAzimuths; ++n) {
                const float phi = std::numbers::pi_v<float> * n / (kAzimuths - 1);
                const Ray o = make_ray({-sine * std::cos(phi), sine * std::sin(phi), cosine});
                const Sent there = sent(i, o, false);
                const float weight = n == 0 || n == kAzimuths - 1 ? 0.5f : 1.0f;
                light += weight * there.flakes * lane_sum(there.light);
                flakes += weight * there.flakes;
            }
            relative[b] = flakes > 0
                              ? std::max(light / (flakes * lane_sum(covered.light)), kLeastSeen)
                              : relative[before];
        };
        for (int b = a; b >= 0; --b) fill(b, b + 1);
        for (int b = a + 1; b < SeenFlakes::kNodes; ++b) fill(b, b - 1);
    }
    return seen;
}

FloatLanes BoundNacre::mean_value(const Ray& i, const Ray& o) const {
    // Under a rough clearcoat the tables hold the hot spot.
    if (!hot_spot_ || under_rough_coat()) return value(i, o, MeanFlakes{});
    return value(i, o, WithHotSpot(*this, i, o));
}

FloatLanes BoundNacre::relative_attenuation(std::size_t species, std::size_t layer,
                                            const sparkle::FlakeView& view, int flake, float cosine,
                                            const FloatLanes& depth,
                                            const HotSpot::Pair* pair) const {
    const sparkle::FlakeView::Body body = view.body(flake);
    FloatLanes exponent = -body.depth * depth;
    if (pair) exponent += pair->gain(layer, body.depth);
    const FloatLanes attenuation = exp_lanes(exponent);
    return films_[species].vary() ? attenuation * films_[species].ratio(cosine, body.film)
                                  : attenuation;
}

FloatLanes BoundNacre::value_on(const Patch& patch, const Look& look, const Ray& i,
                                const Ray& o) const {
    if (patch.flakes != Patch::Flakes::shown) return value(i, o, BesideFlakes(*this, look, i, o));
    return value(i, o, FlakesOfPatch(*this, look, i, o));
}

BoundNacre::Probability BoundNacre::probability_on(const Look& look, const Ray& i) const {
    const SamplingProbabilities& mean = probabilities_at(i);
    float background = 0, resolved = 0;
    for (std::size_t s = 0; s < tables_->species.size(); ++s) {
        const float fraction = tables_->species[s].fraction;
        background += fraction * look[s].background;
        resolved += fraction * look[s].weight_sum;
    }
    Probability probability;
    probability.lobes = mean;
    const float flakes = mean.table * mean.single;
    probability.lobes.table += flakes * (std::max(background, kMinMeanProbability) - 1);
    probability.flakes = flakes * resolved;
    const float scale = 1 / (probability.lobes.interface + probability.lobes.table +
                             probability.lobes.diffuse + probability.flakes);
    probability.lobes.interface *= scale;
    probability.lobes.table *= scale;
    probability.lobes.diffuse *= scale;
    probability.flakes *= scale;
    probability.per_species = flakes * scale;
    return probability;
}

std::optional<Vec3f> BoundNacre::draw_flake(const Look& look, const Probability& probability,
                                            const Ray& i, float u_flake, Vec2f u) const {
    float rest = u_flake;
    std::size_t last = 0;
    for (std::size_t s = 0; s < tables_->species.size(); ++s) {
        const float part =
            probability.per_species * tables_->species[s].fraction * look[s].weight_sum;
        if (part == 0) continue;
        last = s;
        if (rest < part) {
            rest /= part;
            break;
        }
        rest -= part;
    }
    const sparkle::FlakeView& view = look[last];
    const Vec2f slope = view.sample_slope(tables_->species[last].field.lobe(), i.inside,
                                          std::min(rest, 0x1.fffffep-1f), u);
    const Vec3f m = normalize(Vec3f{slope.x, slope.y, 1});
    return leave(2 * dot(i.inside, m) * m - i.inside);
}

float BoundNacre::flake_density(const Look& look, const Probability& probability, const Ray& i,
                                const Ray& o) const {
    if (probability.flakes == 0) return 0;
    const HalfVector half(i, o, coat());
    float sum = 0;
    for (std::size_t s = 0; s < tables_->species.size(); ++s) {
        const sparkle::FlakeView& view = look[s];
        if (view.weight_sum == 0) continue;
        const NacreSpecies& species = tables_->species[s];
        sum += species.fraction * view.weight_sum *
               view.slope_pdf(species.field.lobe(), i.inside, half.slope);
    }
    return sum * probability.per_species * half.per_solid_angle * solid_angle_ratio(o);
}

BsdfValue BoundNacre::evaluate_on(const Patch& patch, Vec3f wi, Vec3f wo) const {
    if (wi.z <= 0 || wo.z <= 0) return {};
    if (tables_->species.empty()) return evaluate(wi, wo);
    const Look look(*this, patch, wi);
    const Ray i = make_ray(wi), o = make_ray(wo);
    if (patch.flakes != Patch::Flakes::shown) {
        return {value_on(patch, look, i, o), density(probabilities_at(i), i, o)};
    }
    const Probability probability = probability_on(look, i);
    return {value_on(patch, look, i, o),
            density(probability.lobes, i, o) + flake_density(look, probability, i, o)};
}

std::optional<BsdfSample> BoundNacre::sample_on(const Patch& patch, Vec3f wi, float u_select,
                                                Vec2f u) const {
    if (wi.z <= 0) return std::nullopt;
    if (tables_->species.empty()) return sample(wi, u_select, u);
    const Look look(*this, patch, wi);
    const Ray i = make_ray(wi);
    if (patch.flakes != Patch::Flakes::shown) {
        return sample_by(i, u_select, u, [&](const Ray& o) { return value_on(patch, look, i, o); });
    }
    const Probability probability = probability_on(look, i);
    BsdfSample s;
    if (u_select < probability.flakes) {
        const auto wo = draw_flake(look, probability, i, u_select, u);
        if (!wo) return std::nullopt;
        s.wo = *wo;
    } else {
        u_select -= probability.flakes;
        if (draws_specular(probability.lobes, u_select))
            return specular_sample(wi, probability.lobes.interface);
        s.wo = draw(probability.lobes, i, u_select, u);
        if (s.wo.z <= 0) return std::nullopt;
    }
    const Ray o = make_ray(s.wo);
    s.pdf = density(probability.lobes, i, o) + flake_density(look, probability, i, o);
    if (!(s.pdf > 0)) return std::nullopt;
    s.weight = value_on(patch, look, i, o) * (s.wo.z / s.pdf);
    return s;
}

UnitRange BoundNacre::chooses_interface_lobe(const Patch* patch, Vec3f wi) const {
    if (!patch || patch->flakes != Patch::Flakes::shown || tables_->species.empty() ||
        !under_rough_coat() || wi.z <= 0) {
        return BoundMicroflake::chooses_interface_lobe(patch, wi);
    }
    const Look look(*this, *patch, wi);
    const Probability probability = probability_on(look, make_ray(wi));
    return {probability.flakes, probability.flakes + probability.lobes.interface};
}

void BoundNacre::ask_flakes(const Patch& patch, Vec3f wi, std::uint32_t random,
                            std::vector<AskedFlake>& list) const {
    list.clear();
    constexpr UintLanes kNumber = {1, 2, 3, 4, 5, 6, 7, 8};
    // Directions of one flake are a lattice, shifted at random [cranley-patterson-1976].
    constexpr float kGolden = std::numbers::phi_v<float> - 1;
    if (wi.z <= 0) return;
    const Look look(*this, patch, wi);
    const Ray i = make_ray(wi);
    const SeenFlakes::Place place(wi.z);
    std::size_t layer = 0;
    for (std::size_t s = 0; s < tables_->species.size(); ++s) {
        while (layer + 1 < tables_->first_species.size() && tables_->first_species[layer + 1] <= s)
            ++layer;
        const sparkle::FlakeView& view = look[s];
        const NacreSpecies& species = tables_->species[s];
        const FloatLanes depth = depth_there_and_back(layer, i);
        const SeenFlakes& flakes = seen_flakes_[s];
        const FloatLanes light = place.in(flakes.light);
        const auto relative = flakes.towards(place);
        // What lies above each of them as if the light came from there: that it comes from elsewhere
        // changes all nearly alike.
        const Ray typical = typical_mirrored(s, i);
        std::optional<HotSpot::Pair> pair;
        if (hot_spot_) pair.emplace(*hot_spot_, i, typical);
        const auto directions = static_cast<float>(species.directions);
        for (int first = 0; first < view.count; first += kLanes) {
            const int last = std::min(kLanes, view.count - first);
            FloatLanes strength{};
            for (int lane = 0; lane < last; ++lane) {
                const int k = first + lane;
                const Vec3f normal = normalize(Vec3f{view.slope_x[k], view.slope_y[k], 1});
                const FloatLanes seen =
                    relative_attenuation(s, layer, view, k, std::abs(dot(i.inside, normal)), depth,
                                         pair ? &*pair : nullptr);
                strength[lane] = view.weight[k] * lane_sum(light * seen);
            }
            const auto bits = hash_of(random, s, first);
            const UintLanes by_flake =
                mix_bits_32(static_cast<std::uint32_t>(bits) +
                            kNumber * (static_cast<std::uint32_t>(bits >> 32) | 1u));
            for (int direction = 0; direction < species.directions; ++direction) {
                const auto n = static_cast<float>(direction);
                const FloatLanes u = sparkle::lower_half(by_flake) * 0x1p-16f + n / directions;
                const FloatLanes turns = sparkle::upper_half(by_flake) * 0x1p-16f + n * kGolden;
                const auto half = view.sample_lobes(species.field.lobe(), i.inside, first,
                                                    {u < 1.0f ? u : u - 1.0f, turns});
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
                const FloatLanes pdf = directions * half.pdf * (0.5f * sec2 / (i.inside.z + z)) *
                                       oz / (z * (mean_ior() * mean_ior()));
                const auto leaves = (oz2 > 1e-6f) & (z > 0.0f) & (pdf > 0.0f) & (strength > 0.0f);
                for (int lane = 0; lane < last; ++lane) {
                    if (!leaves[lane]) continue;
                    list.push_back({{ox[lane], oy[lane], oz[lane]},
                                    pdf[lane],
                                    strength[lane] * SeenFlakes::Place(oz[lane]).in(relative),
                                    static_cast<int>(s),
                                    first + lane});
                }
            }
        }
    }
}

float BoundNacre::flake_pdf(const sparkle::FlakeView& view, std::size_t species, int flake,
                            const Ray& i, const Ray& o) const {
    const HalfVector half(i, o, coat());
    const NacreSpecies& by = tables_->species[species];
    return static_cast<float>(by.directions) *
           view.lobe_pdf(by.field.lobe(), i.inside, flake, half.slope) * half.per_solid_angle *
           solid_angle_ratio(o);
}

FloatLanes BoundNacre::flake_weight(const Patch& patch, Vec3f wi, const AskedFlake& asked) const {
    const Look look(*this, patch, wi);
    const Ray i = make_ray(wi), o = make_ray(asked.wo);
    const HalfVector half(i, o, coat());
    const auto species = static_cast<std::size_t>(asked.species);
    const sparkle::FlakeView& view = look[species];
    const float fraction = view.fraction(tables_->species[species].field.lobe(), half.slope,
                                         half.cosine, asked.flake, half.spread2);
    if (fraction == 0) return FloatLanes{};
    SomeFlakes flakes(*this, species, view, i, o);
    flakes.add(asked.flake, fraction);
    return single_value(i, o, flakes) * (asked.wo.z / asked.pdf);
}

FloatLanes BoundNacre::flakes_at(const Patch& patch, Vec3f wi, Vec3f wo, float pdf) const {
    if (wi.z <= 0 || wo.z <= 0) return FloatLanes{};
    const Look look(*this, patch, wi);
    const Ray i = make_ray(wi), o = make_ray(wo);
    const HalfVector half(i, o, coat());
    FloatLanes sum{};
    for (std::size_t s = 0; s < tables_->species.size(); ++s) {
        const sparkle::DiffractionLobe& lobe = tables_->species[s].field.lobe();
        const sparkle::FlakeView& view = look[s];
        if (view.count == 0 || !lobe.reaches(half.slope2)) continue;
        SomeFlakes flakes(*this, s, view, i, o);
        view.for_each_answer(
            lobe, half.slope, half.cosine,
            [&](int k, float fraction) {
                flakes.add(k, fraction * power_heuristic(pdf, flake_pdf(view, s, k, i, o)));
            },
            half.spread2);
        if (!flakes.empty()) sum += single_value(i, o, flakes);
    }
    return sum;
}

FloatLanes BoundNacre::eval(Vec3f wi, Vec3f wo) const {
    if (wi.z <= 0 || wo.z <= 0) return FloatLanes{};
    return mean_value(make_ray(wi), make_ray(wo));
}

ScatteredAgain BoundNacre::scattered_again(Vec3f wi, Vec3f wo) const {
    const Ray i = make_ray(wi), o = make_ray(wo);
    if (!hot_spot_) return again_value(i, o, MeanFlakes{});
    return again_value(i, o, WithHotSpot(*this, i, o));
}

BsdfValue BoundNacre::evaluate(Vec3f wi, Vec3f wo) const {
    if (wi.z <= 0 || wo.z <= 0) return {};
    const Ray i = make_ray(wi), o = make_ray(wo);
    return {mean_value(i, o), density(probabilities_at(i), i, o)};
}

std::optional<BsdfSample> BoundNacre::sample(Vec3f wi, float u_select, Vec2f u) const {
    if (wi.z <= 0) return std::nullopt;
    const Ray i = make_ray(wi);
    return sample_by(i, u_select, u, [&](const Ray& o) { return mean_value(i, o); });
}

}  // namespace nacre::bsdf
