#include <algorithm>
#include <cmath>
#include <limits>
#include <new>

#include "nacre/bsdf/models/nacre_flakes.h"

// Light that the nacre model reflects on a patch: its value and its sampling.

namespace nacre::bsdf {

namespace {

constexpr float kWide = std::numeric_limits<float>::infinity();

// On a patch the flake lobe of the mean keeps at least this fraction of its probability: multiple
// scattering follows that lobe too, as do the rings of the flakes' patterns, and it bounds the weights
// of directions for which no single flake is sampled.
constexpr float kMinMeanProbability = 0.15f;

}  // namespace

BoundNacre::PatchFlakes::PatchFlakes(const BoundNacre& surface, const Patch& patch, Vec3f wi)
    : own_(patch.memory ? 0 : surface.patch_memory_bytes()) {
    using sparkle::FlakeView;
    PatchMemory& memory = patch.memory ? *patch.memory : own_;
    // Those for a narrow light lie behind the others: one patch may need both.
    const std::vector<NacreSpecies>& species = surface.tables_->species;
    const bool narrow = patch.narrow_light_pdf > 0;
    FlakeView* const views =
        reinterpret_cast<FlakeView*>(memory.data()) + (narrow ? species.size() : 0);
    views_ = views;
    const unsigned bit = narrow ? 2 : 1;
    if (memory.filled & bit) return;
    for (std::size_t s = 0; s < species.size(); ++s) {
        FlakeView& view = *new (views + s) FlakeView;
        const sparkle::FlakeField& field = species[s].field;
        if (patch.flakes == Patch::Flakes::shown) {
            field.query(patch.footprint, view);
            continue;
        }
        const sparkle::FlakeField::StandIns stand_ins{
            narrow ? std::min(1.0f, surface.slope_density(s, wi) / patch.narrow_light_pdf) : kWide};
        if (patch.flakes == Patch::Flakes::sampled) {
            field.query(patch.footprint, view, stand_ins);
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

float BoundNacre::narrow_light_pdf(Vec3f wi) const {
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
    eye_ = response_of_eye(wavelengths);
    for (std::size_t s = 0; s < tables_->species.size(); ++s)
        mean_flake_reflectance_.push_back(mean_flake_reflectance(s));
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

void BoundNacre::relative_attenuations(std::size_t species, std::size_t layer,
                                       const sparkle::FlakeView& view, const IntLanes& flakes,
                                       const FloatLanes& cosine, const FloatLanes& depth,
                                       const HotSpot::Pair* pair,
                                       std::array<FloatLanes, kLanes>& attenuations) const {
    UintLanes film{};
    FloatLanes at{};
    for (int lane = 0; lane < kLanes; ++lane) {
        const sparkle::FlakeView::Body body = view.body(flakes[lane]);
        at[lane] = body.depth;
        film[lane] = body.film;
    }
    for (int lane = 0; lane < kLanes; ++lane) attenuations[lane] = -at[lane] * depth;
    if (pair) pair->add_gains(layer, at, attenuations);
    const BoundFlakeFilms& films = films_[species];
    for (int lane = 0; lane < kLanes; ++lane) {
        attenuations[lane] = exp_lanes(attenuations[lane]);
        if (films.vary()) attenuations[lane] *= films.ratio(cosine[lane], film[lane]);
    }
}

FloatLanes BoundNacre::value_on(const Patch& patch, const PatchFlakes& views, const Ray& i,
                                const Ray& o) const {
    if (patch.flakes != Patch::Flakes::shown)
        return value(i, o, BackgroundFlakes(*this, views, i, o));
    return value(i, o, FlakesOfPatch(*this, views, i, o));
}

BoundNacre::Probability BoundNacre::probability_on(const PatchFlakes& views, const Ray& i) const {
    const SamplingProbabilities& mean = probabilities_at(i);
    float background = 0, resolved = 0;
    for (std::size_t s = 0; s < tables_->species.size(); ++s) {
        const float fraction = tables_->species[s].fraction;
        background += fraction * views[s].background;
        resolved += fraction * views[s].weight_sum;
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

std::optional<Vec3f> BoundNacre::draw_flake(const PatchFlakes& views,
                                            const Probability& probability, const Ray& i,
                                            float u_flake, Vec2f u) const {
    float rest = u_flake;
    std::size_t last = 0;
    for (std::size_t s = 0; s < tables_->species.size(); ++s) {
        const float part =
            probability.per_species * tables_->species[s].fraction * views[s].weight_sum;
        if (part == 0) continue;
        last = s;
        if (rest < part) {
            rest /= part;
            break;
        }
        rest -= part;
    }
    const sparkle::FlakeView& view = views[last];
    const Vec2f slope = view.sample_slope(tables_->species[last].field.lobe(), i.inside,
                                          std::min(rest, 0x1.fffffep-1f), u);
    const Vec3f m = normalize(Vec3f{slope.x, slope.y, 1});
    return leave(2 * dot(i.inside, m) * m - i.inside);
}

float BoundNacre::flake_density(const PatchFlakes& views, const Probability& probability,
                                const Ray& i, const Ray& o) const {
    if (probability.flakes == 0) return 0;
    const HalfVector half(i, o, coat());
    float sum = 0;
    for (std::size_t s = 0; s < tables_->species.size(); ++s) {
        const sparkle::FlakeView& view = views[s];
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
    const PatchFlakes views(*this, patch, wi);
    const Ray i = make_ray(wi), o = make_ray(wo);
    if (patch.flakes != Patch::Flakes::shown) {
        return {value_on(patch, views, i, o), density(probabilities_at(i), i, o)};
    }
    const Probability probability = probability_on(views, i);
    return {value_on(patch, views, i, o),
            density(probability.lobes, i, o) + flake_density(views, probability, i, o)};
}

std::optional<BsdfSample> BoundNacre::sample_on(const Patch& patch, Vec3f wi, float u_select,
                                                Vec2f u) const {
    if (wi.z <= 0) return std::nullopt;
    if (tables_->species.empty()) return sample(wi, u_select, u);
    const PatchFlakes views(*this, patch, wi);
    const Ray i = make_ray(wi);
    if (patch.flakes != Patch::Flakes::shown) {
        return sample_by(i, u_select, u,
                         [&](const Ray& o) { return value_on(patch, views, i, o); });
    }
    const Probability probability = probability_on(views, i);
    BsdfSample s;
    if (u_select < probability.flakes) {
        const auto wo = draw_flake(views, probability, i, u_select, u);
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
    s.pdf = density(probability.lobes, i, o) + flake_density(views, probability, i, o);
    if (!(s.pdf > 0)) return std::nullopt;
    s.weight = value_on(patch, views, i, o) * (s.wo.z / s.pdf);
    return s;
}

UnitRange BoundNacre::interface_lobe_range(const Patch* patch, Vec3f wi) const {
    if (!patch || patch->flakes != Patch::Flakes::shown || tables_->species.empty() ||
        !under_rough_coat() || wi.z <= 0) {
        return BoundMicroflake::interface_lobe_range(patch, wi);
    }
    const PatchFlakes views(*this, *patch, wi);
    const Probability probability = probability_on(views, make_ray(wi));
    return {probability.flakes, probability.flakes + probability.lobes.interface};
}

FloatLanes BoundNacre::eval(Vec3f wi, Vec3f wo) const {
    if (wi.z <= 0 || wo.z <= 0) return FloatLanes{};
    return mean_value(make_ray(wi), make_ray(wo));
}

MultiplyScattered BoundNacre::multiply_scattered(Vec3f wi, Vec3f wo) const {
    const Ray i = make_ray(wi), o = make_ray(wo);
    if (!hot_spot_) return multiple_value(i, o, MeanFlakes{});
    return multiple_value(i, o, WithHotSpot(*this, i, o));
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
