#include "nacre/bsdf/thin_film.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "nacre/bsdf/microfacet.h"
#include "nacre/bsdf/microfacet_coat.h"
#include "nacre/bsdf/thin_film_reflectance.h"

namespace nacre::bsdf {

struct ThinFilm::Tables {
    layers::Recipe recipe;
    optics::AiryFilm film;
    MicrofacetDistribution facets;
    std::optional<FilmColours> colours;
};

namespace {

using Ray = MicrofacetCoat::Ray;

class BoundThinFilm final : public BoundBsdf {
 public:
    BoundThinFilm(std::shared_ptr<const ThinFilm::Tables> tables, const Wavelengths& wavelengths_nm)
        : tables_(std::move(tables)),
          facets_(tables_->facets),
          coat_(tables_->recipe, wavelengths_nm),
          reflectance_(tables_->film, tables_->recipe.microfacet->film_thickness_nm,
                       tables_->colours ? &*tables_->colours : nullptr, wavelengths_nm) {
        tabulate_albedo();
    }

    FloatLanes eval(Vec3f wi, Vec3f wo) const override { return evaluate(wi, wo).f; }
    float pdf(Vec3f wi, Vec3f wo) const override {
        if (wi.z <= 0 || wo.z <= 0) return 0;
        const Ray i = coat_.refract(wi), o = coat_.refract(wo);
        const Vec3f h = normalize(i.inside + o.inside);
        return density(i, o, facets_.lambda(i.inside), facets_.density(h));
    }
    BsdfValue evaluate(Vec3f wi, Vec3f wo) const override {
        if (wi.z <= 0 || wo.z <= 0) return {};
        return value_and_density(coat_.refract(wi), coat_.refract(wo));
    }

    std::optional<BsdfSample> sample(Vec3f wi, float u_lobe, Vec2f u) const override {
        if (wi.z <= 0) return std::nullopt;
        const Ray i = coat_.refract(wi);
        const float mirror = mirror_odds(i);
        if (u_lobe < mirror) {
            return BsdfSample{.wo = {-wi.x, -wi.y, wi.z},
                              .weight = splat(coat_.mirror_reflectance(i) / mirror),
                              .pdf = mirror,
                              .mirror = true,
                              .exit_mm = {}};
        }
        const Vec3f h = facets_.sample_visible(i.inside, u);
        const Vec3f inside = 2 * dot(i.inside, h) * h - i.inside;
        if (inside.z <= 0) return std::nullopt;
        const auto outside = coat_.leave(inside);
        if (!outside || outside->z <= 0) return std::nullopt;
        const BsdfValue v = value_and_density(i, coat_.refract(*outside));
        if (!(v.pdf > 0)) return std::nullopt;
        return BsdfSample{.wo = *outside,
                          .weight = v.f * (outside->z / v.pdf),
                          .pdf = v.pdf,
                          .mirror = false,
                          .exit_mm = {}};
    }

    FloatLanes albedo(Vec3f wi) const override {
        if (wi.z <= 0) return FloatLanes{};
        const FloatLanes mirror = splat(coat_.mirror_reflectance(coat_.refract(wi)));
        return min_lanes(mirror + facet_albedo(wi.z), splat(1.0f));
    }

 private:
    // Shared by value and density: h, D and the masking of the incident side.
    BsdfValue value_and_density(const Ray& i, const Ray& o) const {
        const Vec3f h = normalize(i.inside + o.inside);
        const float d = facets_.density(h);
        if (d == 0) return {};
        const float lambda_i = facets_.lambda(i.inside), lambda_o = facets_.lambda(o.inside);
        const float visible = MicrofacetDistribution::masking_shadowing(lambda_i, lambda_o);
        // w_i.h from the half vector alone, which is symmetric in its arguments.
        const float cosine = std::min(1.0f, 0.5f * length(i.inside + o.inside));
        const float geometry = 0.25f * d * visible / (i.inside.z * o.inside.z);
        return {reflectance_(cosine) * geometry * coat_.transfer(i, o), density(i, o, lambda_i, d)};
    }

    // Visible normals over the Jacobian 4 w_i.h of reflection, times that of refraction.
    float density(const Ray& i, const Ray& o, float lambda_i, float d) const {
        const float inside = 0.25f * d / (i.inside.z * (1 + lambda_i));
        return (1 - mirror_odds(i)) * inside * coat_.solid_angle_ratio(o);
    }

    // In proportion to what mirror and facets reflect, as far as that is tabulated.
    float mirror_odds(const Ray& i) const {
        if (!coat_.present()) return 0;
        const float mirror = coat_.mirror_reflectance(i);
        if (!(mirror > 0)) return 0;
        constexpr float kLeast = 0.05f;  // either lobe, so that its weights stay bounded
        const float facets = mean_facet_albedo(i.outside.z);
        return std::clamp(mirror / (mirror + facets), kLeast, 1 - kLeast);
    }

    static constexpr int kAngles = 16;
    struct Between {
        int row;
        float fraction;
    };
    static Between locate(float cosine) {
        const float x = std::min(cosine, 1.0f) * kAngles;
        const int row = std::min(static_cast<int>(x), kAngles - 1);
        return {row, x - static_cast<float>(row)};
    }
    FloatLanes facet_albedo(float cosine) const {
        const Between at = locate(cosine);
        return facet_albedo_[at.row] +
               at.fraction * (facet_albedo_[at.row + 1] - facet_albedo_[at.row]);
    }
    float mean_facet_albedo(float cosine) const {
        const Between at = locate(cosine);
        return mean_albedo_[at.row] +
               at.fraction * (mean_albedo_[at.row + 1] - mean_albedo_[at.row]);
    }

    // Means of weights at the points of a Hammersley set: the visible normals make them vary
    // little.
    void tabulate_albedo() {
        constexpr unsigned kPoints = 256;
        for (int row = 0; row <= kAngles; ++row) {
            const float z = std::max(static_cast<float>(row) / kAngles, 1e-3f);
            const Ray i = coat_.refract({std::sqrt(1 - z * z), 0, z});
            const float lambda_i = facets_.lambda(i.inside);
            FloatLanes sum{};
            for (unsigned p = 0; p < kPoints; ++p) {
                float radical = 0, base = 0.5f;
                for (unsigned q = p; q; q >>= 1, base *= 0.5f) radical += (q & 1) * base;
                const Vec3f h = facets_.sample_visible(
                    i.inside, {(static_cast<float>(p) + 0.5f) / kPoints, radical + 0.5f / kPoints});
                const float cosine = dot(i.inside, h);
                const Vec3f inside = 2 * cosine * h - i.inside;
                if (inside.z <= 0 || cosine <= 0) continue;
                const auto outside = coat_.leave(inside);
                if (!outside || outside->z <= 0) continue;
                const Ray o = coat_.refract(*outside);
                const float lambda_o = facets_.lambda(inside);
                const float seen = (1 + lambda_i) *
                                   MicrofacetDistribution::masking_shadowing(lambda_i, lambda_o) *
                                   inside_to_outside(o);
                sum += reflectance_(std::min(cosine, 1.0f)) * seen * coat_.transfer(i, o);
            }
            facet_albedo_[row] = sum * (1.0f / kPoints);
            mean_albedo_[row] = lane_mean(facet_albedo_[row]);
        }
    }
    // cos dw outside over cos dw inside: the etendue's n^2.
    float inside_to_outside(const Ray& o) const {
        return o.outside.z / (o.inside.z * coat_.solid_angle_ratio(o));
    }

    std::shared_ptr<const ThinFilm::Tables> tables_;
    MicrofacetDistribution facets_;
    MicrofacetCoat coat_;
    FilmReflectance reflectance_;
    std::array<FloatLanes, kAngles + 1> facet_albedo_;
    std::array<float, kAngles + 1> mean_albedo_;
};

ThinFilm::Tables make_tables(const layers::Recipe& recipe, ThinFilmColour colour) {
    validate_microfacet_recipe(recipe);
    const layers::Microfacet& m = *recipe.microfacet;
    const optics::AiryFilm film(index_around_facets(recipe), m.film_ior, m.base_ior,
                                m.base_extinction);
    ThinFilm::Tables tables{recipe, film, MicrofacetDistribution(m.distribution, m.alpha),
                            std::nullopt};
    if (colour != ThinFilmColour::spectral) {
        tables.colours.emplace(film, m.film_thickness_nm, colour);
    }
    return tables;
}

}  // namespace

ThinFilm::ThinFilm(const layers::Recipe& recipe, ThinFilmColour colour)
    : tables_(std::make_shared<const Tables>(make_tables(recipe, colour))) {}

ThinFilm::~ThinFilm() = default;

std::unique_ptr<const BoundBsdf> ThinFilm::bind(const Wavelengths& wavelengths_nm) const {
    return std::make_unique<const BoundThinFilm>(tables_, wavelengths_nm);
}

}  // namespace nacre::bsdf
