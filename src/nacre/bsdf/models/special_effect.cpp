#include "nacre/bsdf/models/special_effect.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "nacre/bsdf/microfacet.h"
#include "nacre/core/error.h"
#include "nacre/core/quadrature.h"
#include "nacre/sparkle/facet_field.h"

namespace nacre::bsdf {

SpreadFilm::SpreadFilm(const optics::AiryFilm& film, double film_ior, optics::ThicknessRange range,
                       const Wavelengths& wavelengths_nm)
    : film_(film),
      lo_nm_(static_cast<float>(range.lo_nm)),
      width_nm_(static_cast<float>(range.hi_nm - range.lo_nm)),
      inverse_wavelengths_(
          make_lanes([&](int i) { return static_cast<float>(1 / wavelengths_nm[i]); })) {
    if (!(range.hi_nm > range.lo_nm)) {
        nodes_.push_back({lo_nm_ * inverse_wavelengths_, 1});
        return;
    }
    // Half the range of the phase 4 pi n d / lambda. The rule needs about as many nodes, and more
    // for the overtones of a strong film.
    const double shortest = *std::min_element(wavelengths_nm.begin(), wavelengths_nm.end());
    const double phase = 2 * std::numbers::pi * film_ior * (range.hi_nm - range.lo_nm) / shortest;
    constexpr double kMaxNodes = 100000;
    const int count = static_cast<int>(std::min(kMaxNodes, std::ceil(4 + 2 * phase)));
    const Quadrature rule = gauss_legendre(count, range.lo_nm, range.hi_nm);
    for (int i = 0; i < count; ++i) {
        nodes_.push_back({static_cast<float>(rule.nodes[i]) * inverse_wavelengths_,
                          static_cast<float>(rule.weights[i] / (range.hi_nm - range.lo_nm))});
    }
}

FloatLanes SpreadFilm::mean(const optics::AiryAngle<float>& angle) const {
    FloatLanes sum{};
    for (const Node& node : nodes_) {
        sum += node.weight * angle.reflectance(node.thickness_over_wavelength);
    }
    return sum;
}

FloatLanes SpreadFilm::sum(float cosine, const sparkle::FacetTally& facets) const {
    const optics::AiryAngle<float> angle = film_.at(cosine);
    if (width_nm_ == 0) return static_cast<float>(facets.count) * mean(angle);
    FloatLanes sum{};
    for (int i = 0; i < facets.listed; ++i) {
        const float thickness_nm = lo_nm_ + width_nm_ * facets.thickness[i];
        sum += angle.reflectance(thickness_nm * inverse_wavelengths_);
    }
    if (facets.count == static_cast<std::uint64_t>(facets.listed)) return sum;
    const float listed = static_cast<float>(facets.listed);
    const float count = static_cast<float>(facets.count);
    const FloatLanes expected = mean(angle);
    return count * (expected + std::sqrt(listed / count) * (sum * (1 / listed) - expected));
}

struct SpecialEffect::Tables {
    paint::Recipe recipe;
    optics::AiryFilm film;
    optics::ThicknessRange thickness;
    MicrofacetDistribution facets;
    sparkle::FacetField field;
    bool smooth_ndf;
};

namespace {

class BoundSpecialEffect final : public BoundMicrofacets<BoundSpecialEffect> {
 public:
    BoundSpecialEffect(std::shared_ptr<const SpecialEffect::Tables> tables,
                       const Wavelengths& wavelengths_nm)
        : BoundMicrofacets(tables->recipe, tables->facets, wavelengths_nm),
          tables_(std::move(tables)),
          rule_(tables_->field.cone_rule()),
          film_(tables_->film, tables_->recipe.microfacet->film_ior, tables_->thickness,
                wavelengths_nm),
          inverse_solid_angle_(static_cast<float>(1 / rule_.solid_angle())) {
        tabulate_albedo();
    }

    BsdfValue evaluate_on(const Patch& patch, Vec3f wi, Vec3f wo) const override {
        if (wi.z <= 0 || wo.z <= 0) return {};
        const Pair p = pair(wi, wo);
        return {value({patch.u, patch.v, patch.edge_1, patch.edge_2}, p), density(p)};
    }
    std::optional<BsdfSample> sample_on(const Patch& patch, Vec3f wi, float u_select,
                                        Vec2f u) const override {
        return sample_by(wi, u_select, u, [&](const Pair& p) {
            return value({patch.u, patch.v, patch.edge_1, patch.edge_2}, p);
        });
    }

 private:
    friend BoundMicrofacets;

    // Two directions and what value and density share.
    struct Pair {
        Ray i, o;
        Vec3f sum;  // of the directions inside
        float lambda_i;
        sparkle::ConeRule::Means means;

        Pair(const BoundSpecialEffect& b, const Ray& i, const Ray& o)
            : i(i),
              o(o),
              sum(i.inside + o.inside),
              lambda_i(b.facets().lambda(i.inside)),
              means(b.rule_.means(i.inside, o.inside)) {}

        // w_i.h from the half vector alone, which is symmetric in its arguments.
        float cosine() const { return std::min(1.0f, 0.5f * length(sum)); }
    };

    // The BRDF over (1/K) sum R / (A |Omega|).
    FloatLanes geometry(const Pair& p) const {
        const float visible =
            MicrofacetDistribution::masking_shadowing(p.lambda_i, facets().lambda(p.o.inside));
        // (w_i.h) / (h.n), with w_i.h = |sum| / 2 and h.n = sum_z / |sum|.
        const float foreshortening = 0.5f * dot(p.sum, p.sum) / p.sum.z;
        return (foreshortening * visible / (p.i.inside.z * p.o.inside.z)) *
               coat().transfer(p.i, p.o);
    }

    FloatLanes mean_value(const Pair& p) const {
        if (!(p.means.projected > 0)) return FloatLanes{};
        return film_.mean(p.cosine()) * p.means.projected * geometry(p);
    }

    FloatLanes value(const sparkle::Footprint& footprint, const Pair& p) const {
        if (tables_->smooth_ndf || !(footprint.area() > 0)) return mean_value(p);
        const sparkle::FacetField& field = tables_->field;
        const sparkle::FacetTally tally = field.count(footprint, p.i.inside, p.o.inside);
        if (tally.count == 0) return FloatLanes{};
        const double fraction = 1 / (field.facets() * footprint.area());
        return film_.sum(p.cosine(), tally) *
               (static_cast<float>(fraction) * inverse_solid_angle_) * geometry(p);
    }

    // A direction into which visible facets reflect, turned within the cone.
    std::optional<Ray> draw(const Ray& i, Vec2f u, Vec2f u_cone) const {
        const Vec3f m = facets().sample_visible(i.inside, u);
        return leave(rule_.sample(2 * dot(i.inside, m) * m - i.inside, u_cone));
    }

    // Of draw(): the mean over the cone of the density of visible normals over the Jacobian of
    // reflection, times that of refraction.
    float facet_density(const Pair& p) const {
        return 0.25f * p.means.density / (p.i.inside.z * (1 + p.lambda_i)) *
               coat().solid_angle_ratio(p.o);
    }

    std::shared_ptr<const SpecialEffect::Tables> tables_;
    const sparkle::ConeRule& rule_;  // of tables_
    SpreadFilm film_;
    float inverse_solid_angle_;
};

SpecialEffect::Tables make_tables(const paint::Recipe& recipe, std::uint64_t seed,
                                  bool smooth_ndf) {
    validate_microfacet_recipe(recipe);
    const paint::Microfacet& m = *recipe.microfacet;
    if (!m.facets) {
        throw DomainError(
            "microfacet.facets: is missing; this model needs the table [microfacet.facets]");
    }
    if (m.distribution != paint::FacetDistribution::beckmann) {
        throw DomainError(
            "microfacet.distribution = \"ggx\": must be \"beckmann\" for facets that are counted");
    }
    Range cone = sparkle::kFacetConeRange;
    cone.hi = std::min(cone.hi, sparkle::kMaxConePerRoughness * m.alpha * 180 / std::numbers::pi);
    if (!cone.contains(m.facets->cone_deg)) {
        throw DomainError(
            fmt::format("microfacet.facets.cone_deg = {} is outside {} for alpha = {}",
                        m.facets->cone_deg, cone.text(), m.alpha));
    }
    if (m.facets->count != std::floor(m.facets->count)) {
        throw DomainError(fmt::format("microfacet.facets.count = {} is not a whole number in {}",
                                      m.facets->count, sparkle::kFacetCountRange.text()));
    }
    // The uniform distribution from -w to w has the standard deviation w / sqrt 3.
    const double reach_nm = std::numbers::sqrt3 * m.facets->thickness_spread_nm;
    if (reach_nm > m.film_thickness_nm) {
        throw DomainError(fmt::format(
            "microfacet.facets.thickness_spread_nm = {} is outside [0, {:.6g}] nm: films even "
            "about "
            "film_thickness_nm = {} with this standard deviation must not reach below 0",
            m.facets->thickness_spread_nm, m.film_thickness_nm / std::numbers::sqrt3,
            m.film_thickness_nm));
    }
    return {
        recipe,
        optics::AiryFilm(index_around_facets(recipe), m.film_ior, m.base_ior, m.base_extinction),
        {m.film_thickness_nm - reach_nm, m.film_thickness_nm + reach_nm},
        MicrofacetDistribution(m.distribution, m.alpha),
        sparkle::FacetField(m.facets->count, m.alpha, m.facets->cone_deg, seed),
        smooth_ndf};
}

}  // namespace

SpecialEffect::SpecialEffect(const paint::Recipe& recipe, std::uint64_t seed, bool smooth_ndf)
    : tables_(std::make_shared<const Tables>(make_tables(recipe, seed, smooth_ndf))) {}

SpecialEffect::~SpecialEffect() = default;

std::unique_ptr<const BoundBsdf> SpecialEffect::bind(const Wavelengths& wavelengths_nm) const {
    return std::make_unique<const BoundSpecialEffect>(tables_, wavelengths_nm);
}

SurfaceCoordinates SpecialEffect::surface_coordinates() const {
    return tables_->smooth_ndf ? SurfaceCoordinates::none : SurfaceCoordinates::unit_square;
}

namespace {

constexpr ModelOption kSpecialEffectOptions[] = {OptionFor<&SpecialEffectModel::smooth_ndf>::toggle(
    "--smooth-ndf",
    "special-effect: the mean over all facets, without sparkle (as in Table 4 of the comparison of "
    "2022)")};

}  // namespace

constinit const ModelInfo SpecialEffectModel::info = {
    .name = "special-effect",
    .summary = "single microfacets, each with its own place, normal and film thickness",
    .source = "Guo et al. 2018",
    .ingredients = Ingredients::facets,
    .solution = Solution::none,
    .can = {.goniochromism = true, .sparkle = true},
    .coordinates = SurfaceCoordinates::unit_square,
    .standard = standard_model<SpecialEffectModel>,
    .options = kSpecialEffectOptions};

std::string SpecialEffectModel::text() const {
    return fmt::format("specimen={} smooth_ndf={}", specimen, smooth_ndf);
}

std::shared_ptr<const Bsdf> SpecialEffectModel::make(const ModelInput& input,
                                                     const Progress&) const {
    return std::make_shared<const SpecialEffect>(input.recipe, specimen, smooth_ndf);
}

}  // namespace nacre::bsdf
