#include "nacre/bsdf/thin_film.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "nacre/bsdf/microfacet.h"
#include "nacre/bsdf/microfacet_albedo.h"
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
        albedo_.tabulate([&](Vec3f wi, std::array<float, 4> u) -> FloatLanes {
            const Ray i = coat_.refract(wi);
            const auto o = draw(i, {u[0], u[1]});
            if (!o) return FloatLanes{};
            const Pair pair(*this, i, *o);
            if (!(pair.density > 0)) return FloatLanes{};
            return value(pair) * (o->outside.z / facet_density(pair));
        });
    }

    FloatLanes eval(Vec3f wi, Vec3f wo) const override {
        if (wi.z <= 0 || wo.z <= 0) return FloatLanes{};
        return value(Pair(*this, coat_.refract(wi), coat_.refract(wo)));
    }
    float pdf(Vec3f wi, Vec3f wo) const override {
        if (wi.z <= 0 || wo.z <= 0) return 0;
        return density(Pair(*this, coat_.refract(wi), coat_.refract(wo)));
    }
    BsdfValue evaluate(Vec3f wi, Vec3f wo) const override {
        if (wi.z <= 0 || wo.z <= 0) return {};
        const Pair pair(*this, coat_.refract(wi), coat_.refract(wo));
        return {value(pair), density(pair)};
    }

    std::optional<BsdfSample> sample(Vec3f wi, float u_lobe, Vec2f u) const override {
        if (wi.z <= 0) return std::nullopt;
        const Ray i = coat_.refract(wi);
        const float mirror = albedo_.mirror_odds(coat_, i);
        if (u_lobe < mirror) return coat_.mirror_sample(i, mirror);
        const auto o = draw(i, u);
        if (!o) return std::nullopt;
        const Pair pair(*this, i, *o);
        const float p = density(pair);
        if (!(p > 0)) return std::nullopt;
        return BsdfSample{.wo = o->outside,
                          .weight = value(pair) * (o->outside.z / p),
                          .pdf = p,
                          .mirror = false,
                          .exit_mm = {}};
    }

    FloatLanes albedo(Vec3f wi) const override {
        if (wi.z <= 0) return FloatLanes{};
        const FloatLanes mirror = splat(coat_.mirror_reflectance(coat_.refract(wi)));
        return min_lanes(mirror + albedo_.at(wi.z), splat(1.0f));
    }

 private:
    // Two directions, and what value and density share.
    struct Pair {
        Ray i, o;
        float cosine;  // w_i.h, from the half vector alone, which is symmetric in its arguments
        float density, lambda_i;

        Pair(const BoundThinFilm& b, const Ray& i, const Ray& o) : i(i), o(o) {
            const Vec3f sum = i.inside + o.inside;
            const float twice = length(sum);
            cosine = std::min(1.0f, 0.5f * twice);
            density = b.facets_.density(sum * (1 / twice));
            lambda_i = b.facets_.lambda(i.inside);
        }
    };

    FloatLanes value(const Pair& p) const {
        if (p.density == 0) return FloatLanes{};
        const float visible =
            MicrofacetDistribution::masking_shadowing(p.lambda_i, facets_.lambda(p.o.inside));
        const float geometry = 0.25f * p.density * visible / (p.i.inside.z * p.o.inside.z);
        return reflectance_(p.cosine) * geometry * coat_.transfer(p.i, p.o);
    }

    // A direction that visible facets mirror to; empty where it does not leave.
    std::optional<Ray> draw(const Ray& i, Vec2f u) const {
        const Vec3f h = facets_.sample_visible(i.inside, u);
        const Vec3f inside = 2 * dot(i.inside, h) * h - i.inside;
        if (inside.z <= 0) return std::nullopt;
        const auto outside = coat_.leave(inside);
        if (!outside || outside->z <= 0) return std::nullopt;
        return coat_.refract(*outside);
    }

    // Of draw(): visible normals over the Jacobian of reflection, times that of refraction.
    float facet_density(const Pair& p) const {
        return 0.25f * p.density / (p.i.inside.z * (1 + p.lambda_i)) * coat_.solid_angle_ratio(p.o);
    }
    float density(const Pair& p) const {
        return (1 - albedo_.mirror_odds(coat_, p.i)) * facet_density(p);
    }

    std::shared_ptr<const ThinFilm::Tables> tables_;
    MicrofacetDistribution facets_;
    MicrofacetCoat coat_;
    FilmReflectance reflectance_;
    MicrofacetAlbedo albedo_;
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
