#include "nacre/bsdf/bound_nacre.h"

#include <algorithm>
#include <cmath>
#include <new>

#include "nacre/core/lane_math.h"

namespace nacre::bsdf {
namespace {

// Of the light that a patch's flakes are expected to send back, at least this part is looked for
// where the mean has it: what is scattered again follows the flakes too, and it bounds the weights
// of directions that no single flake is sampled for.
constexpr float kLeastMeanOdds = 0.1f;

// The half vector inside, as the flakes see it.
struct HalfVector {
    Vec2f slope;
    float slope2, cosine;   // cosine: w_i . h
    float per_solid_angle;  // squares of slopes per solid angle of the direction w_o

    HalfVector(const Ray& i, const Ray& o) {
        const Vec3f sum = i.inside + o.inside;
        const float inverse = 1 / sum.z;
        slope = {sum.x * inverse, sum.y * inverse};
        slope2 = slope.x * slope.x + slope.y * slope.y;
        const float sec2 = 1 + slope2;
        cosine = std::min(1.0f, 0.5f * sum.z * std::sqrt(sec2));
        // sec^3 squares of slopes make a solid angle of h, 4 (w_i.h) of them one of w_o.
        per_solid_angle = 0.5f * inverse * sec2;
    }
};

}  // namespace

// In place of MeanFlakes: all flakes, with the gaps between them.
class BoundNacre::MeanHotSpot {
 public:
    MeanHotSpot(const HotSpot& hot_spot, const Ray& i, const Ray& o) : pair_(hot_spot, i, o) {}
    FloatLanes factor(std::size_t layer, std::size_t, const FloatLanes& depth) const {
        return pair_.mean(layer, depth);
    }

 private:
    HotSpot::Pair pair_;
};

// In place of MeanFlakes: those of a patch.
class BoundNacre::FlakesOfPatch {
 public:
    FlakesOfPatch(const BoundNacre& surface, const Look& look, const Ray& i, const Ray& o)
        : surface_(surface), look_(look), half_(i, o) {
        if (surface.hot_spot_) pair_.emplace(*surface.hot_spot_, i, o);
    }

    FloatLanes factor(std::size_t layer, std::size_t flake, const FloatLanes& depth) const {
        const std::size_t at = surface_.tables_->first_species[layer] + flake;
        const sparkle::DiffractionLobe& lobe = surface_.tables_->species[at].field.lobe();
        if (!lobe.reaches(half_.slope2)) return pair_ ? pair_->mean(layer, depth) : splat(1.0f);
        const sparkle::FlakeView& view = look_[at];
        FloatLanes answers{};
        bool any = false;
        const float background =
            view.for_each_answer(lobe, half_.slope, half_.cosine, [&](int k, float share) {
                any = true;
                const sparkle::FlakeView::Body body = view.body(k);
                FloatLanes exponent = -body.depth * depth;
                if (pair_) exponent += pair_->gain(layer, body.depth);
                FloatLanes answer = share * exp_lanes(exponent);
                const BoundFlakeFilms& films = surface_.films_[at];
                if (films.vary()) answer *= films.ratio(half_.cosine, body.film);
                answers += answer;
            });
        FloatLanes sum = splat(background);
        if (pair_ && background > 0) sum *= pair_->mean(layer, depth);
        if (any) {
            const FloatLanes safe = max_lanes(depth, splat(1e-20f));
            sum += answers * (safe / one_minus_exp_lanes(safe));
        }
        return sum;
    }

 private:
    const BoundNacre& surface_;
    const Look& look_;
    HalfVector half_;
    std::optional<HotSpot::Pair> pair_;
};

BoundNacre::Look::Look(const BoundNacre& surface, const Patch& patch)
    : own_(patch.memory ? 0 : surface.patch_memory_bytes()) {
    using sparkle::FlakeView;
    PatchMemory& memory = patch.memory ? *patch.memory : own_;
    FlakeView* const views = reinterpret_cast<FlakeView*>(memory.data());
    views_ = views;
    if (memory.filled) return;
    const std::vector<NacreSpecies>& species = surface.tables_->species;
    for (std::size_t s = 0; s < species.size(); ++s) {
        species[s].field.look(patch.rest, *new (views + s) FlakeView);
    }
    memory.filled = true;
}

BoundNacre::BoundNacre(std::shared_ptr<const Nacre::Tables> tables, const Wavelengths& wavelengths)
    : BoundMicroflake(tables->smooth, wavelengths), tables_(std::move(tables)) {
    for (const NacreSpecies& species : tables_->species) {
        films_.push_back(species.films ? species.films->bind(where()) : BoundFlakeFilms());
    }
    if (tables_->hot_spot) hot_spot_.emplace(*tables_->hot_spot, where());
}

FloatLanes BoundNacre::mean_value(const Ray& i, const Ray& o) const {
    return hot_spot_ ? value(i, o, MeanHotSpot(*hot_spot_, i, o)) : value(i, o, MeanFlakes{});
}

FloatLanes BoundNacre::value_on(const Look& look, const Ray& i, const Ray& o) const {
    return value(i, o, FlakesOfPatch(*this, look, i, o));
}

BoundNacre::Odds BoundNacre::odds_on(const Look& look, const Ray& i) const {
    const LobeOdds& mean = odds_at(i);
    float background = 0, told_apart = 0;
    for (std::size_t s = 0; s < tables_->species.size(); ++s) {
        const float share = tables_->species[s].share;
        background += share * look[s].background;
        told_apart += share * look[s].weight_sum;
    }
    Odds odds;
    odds.lobes = mean;
    odds.lobes.flakes *= std::max(background, kLeastMeanOdds);
    odds.flakes = mean.flakes * told_apart;
    const float scale = 1 / (odds.lobes.interface + odds.lobes.flakes + odds.lobes.wide +
                             odds.lobes.diffuse + odds.flakes);
    odds.lobes.interface *= scale;
    odds.lobes.flakes *= scale;
    odds.lobes.wide *= scale;
    odds.lobes.diffuse *= scale;
    odds.flakes *= scale;
    odds.per_species = mean.flakes * scale;
    return odds;
}

std::optional<Vec3f> BoundNacre::draw_flake(const Look& look, const Odds& odds, const Ray& i,
                                            float u_flake, Vec2f u) const {
    float rest = u_flake;
    std::size_t last = 0;
    for (std::size_t s = 0; s < tables_->species.size(); ++s) {
        const float part = odds.per_species * tables_->species[s].share * look[s].weight_sum;
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
    const Vec3f m = normalize({slope.x, slope.y, 1});
    return leave(2 * dot(i.inside, m) * m - i.inside);
}

float BoundNacre::flake_density(const Look& look, const Odds& odds, const Ray& i,
                                const Ray& o) const {
    if (odds.flakes == 0) return 0;
    const HalfVector half(i, o);
    float sum = 0;
    for (std::size_t s = 0; s < tables_->species.size(); ++s) {
        const sparkle::FlakeView& view = look[s];
        if (view.weight_sum == 0) continue;
        const NacreSpecies& species = tables_->species[s];
        sum += species.share * view.weight_sum *
               view.slope_pdf(species.field.lobe(), i.inside, half.slope);
    }
    return sum * odds.per_species * half.per_solid_angle * solid_angle_ratio(o);
}

BsdfValue BoundNacre::evaluate_on(const Patch& patch, Vec3f wi, Vec3f wo) const {
    if (wi.z <= 0 || wo.z <= 0) return {};
    if (tables_->species.empty()) return evaluate(wi, wo);
    const Look look(*this, patch);
    const Ray i = make_ray(wi), o = make_ray(wo);
    const Odds odds = odds_on(look, i);
    return {value_on(look, i, o), density(odds.lobes, i, o) + flake_density(look, odds, i, o)};
}

std::optional<BsdfSample> BoundNacre::sample_on(const Patch& patch, Vec3f wi, float u_lobe,
                                                Vec2f u) const {
    if (wi.z <= 0) return std::nullopt;
    if (tables_->species.empty()) return sample(wi, u_lobe, u);
    const Look look(*this, patch);
    const Ray i = make_ray(wi);
    const Odds odds = odds_on(look, i);
    BsdfSample s;
    if (u_lobe < odds.flakes) {
        const auto wo = draw_flake(look, odds, i, u_lobe, u);
        if (!wo) return std::nullopt;
        s.wo = *wo;
    } else {
        u_lobe -= odds.flakes;
        if (draws_mirror(odds.lobes, u_lobe)) return mirror_sample(wi, odds.lobes.interface);
        s.wo = draw(odds.lobes, i, u_lobe, u);
        if (s.wo.z <= 0) return std::nullopt;
    }
    const Ray o = make_ray(s.wo);
    s.pdf = density(odds.lobes, i, o) + flake_density(look, odds, i, o);
    if (!(s.pdf > 0)) return std::nullopt;
    s.weight = value_on(look, i, o) * (s.wo.z / s.pdf);
    return s;
}

FloatLanes BoundNacre::eval(Vec3f wi, Vec3f wo) const {
    if (wi.z <= 0 || wo.z <= 0) return FloatLanes{};
    return mean_value(make_ray(wi), make_ray(wo));
}

BsdfValue BoundNacre::evaluate(Vec3f wi, Vec3f wo) const {
    if (wi.z <= 0 || wo.z <= 0) return {};
    const Ray i = make_ray(wi), o = make_ray(wo);
    return {mean_value(i, o), density(odds_at(i), i, o)};
}

std::optional<BsdfSample> BoundNacre::sample(Vec3f wi, float u_lobe, Vec2f u) const {
    auto s = BoundMicroflake::sample(wi, u_lobe, u);
    if (s && !s->mirror && hot_spot_) {
        s->weight = mean_value(make_ray(wi), make_ray(s->wo)) * (s->wo.z / s->pdf);
    }
    return s;
}

}  // namespace nacre::bsdf
