#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>

#include "nacre/bsdf/bsdf.h"
#include "nacre/core/random.h"
#include "nacre/core/vec.h"
#include "nacre/paint/recipe.h"

// Facets of a rough surface, as the microfacet models share them: how their normals are
// distributed, how they hide each other, and how to draw those that can be seen.

namespace nacre::bsdf {

/// Isotropic microfacets of roughness alpha. Directions are in the local frame, z the mean normal.
class MicrofacetDistribution {
 public:
    /// @param alpha  in paint::limits::kMicrofacetAlpha: for Beckmann sqrt(2) times the standard
    ///               deviation of a slope component
    MicrofacetDistribution(paint::FacetDistribution law, double alpha);

    /// D(h), density of normals per solid angle and per area of the mean surface: its integral
    /// times the cosine is 1.       [walter-2007, eq. 25 (Beckmann) and 33 (GGX)]
    /// @param h  unit, h.z > 0
    float density(Vec3f h) const;

    /// Smith's Lambda(w): hidden area over visible area, in its exact form for either law. The
    /// fraction seen of the facets that face w is 1 / (1 + Lambda).
    ///                                                                      [heitz-2014, section 5]
    /// @param w  unit, w.z > 0
    float lambda(Vec3f w) const;

    /// Fraction of facets visible from both sides, heights being correlated.  [heitz-2014]
    static float masking_shadowing(float lambda_i, float lambda_o) {
        return 1 / (1 + lambda_i + lambda_o);
    }

    /// Density of the normals visible from wi, per solid angle of h.      [heitz-deon-2014]
    float visible_density(Vec3f wi, float lambda_i, Vec3f h) const {
        const float facing = dot(wi, h);
        return facing > 0 ? density(h) * facing / (wi.z * (1 + lambda_i)) : 0;
    }

    /// Draws a normal with visible_density(). u in [0, 1)^2.
    /// GGX: the disk of the stretched hemisphere, re-projected [heitz-2018]. Beckmann: slopes of
    /// the stretched surface, that towards wi by inverting its distribution [heitz-deon-2014] with
    /// Newton's method in the error function of the slope, where it is nearly straight; the other
    /// by the Gaussian.
    Vec3f sample_visible(Vec3f wi, Vec2f u) const;

    float alpha() const { return alpha_; }
    paint::FacetDistribution law() const { return law_; }

 private:
    paint::FacetDistribution law_;
    float alpha_, inverse_alpha2_;
};

/// The slope x of a visible facet of a surface with the slope density exp(-x^2) / sqrt(pi), seen
/// under the angle whose cotangent is given: density (cot - x) exp(-x^2) on x < cot, normalised;
/// x > 0 turns facets away. Of the result, the error in probability is below kVisibleSlopeError.
/// @param u  in (0, 1)
float sample_visible_beckmann_slope(float cotangent, float u);

inline constexpr double kVisibleSlopeError = 2e-6;

// A smooth clearcoat over microfacets: light is refracted on its way to them and back, and what the
// interface reflects back to them, beyond the critical angle all of it, is lost: the
// interreflection of coat and facets is neglected.

/// The index that surrounds the microfacets of a recipe: 1, or under a clearcoat that of the binder
/// at 550 nm (microfacet models take indices that do not depend on wavelength).
double index_around_facets(const paint::Recipe& recipe);

/// @throws DomainError if the recipe has no [microfacet] or its clearcoat is rough, or as
///         paint::validate
void validate_microfacet_recipe(const paint::Recipe& recipe);

/// The clearcoat of a microfacet recipe at eight wavelengths, or none at all.
class MicrofacetCoat {
 public:
    MicrofacetCoat(const paint::Recipe& recipe, const Wavelengths& wavelengths_nm);

    /// A direction outside, w.z > 0, and what it becomes inside.
    struct Ray {
        Vec3f outside, inside;
        float transmittance;  ///< Fresnel's, unpolarised
    };
    Ray refract(Vec3f outside) const;
    /// The direction outside of one inside; empty beyond the critical angle.
    std::optional<Vec3f> leave(Vec3f inside) const;

    /// BRDF outside over BRDF of the facets inside: t_i t_o / n^2 times the coat's absorption.
    FloatLanes transfer(const Ray& i, const Ray& o) const;
    /// Solid angle inside over solid angle outside.
    float solid_angle_ratio(const Ray& o) const {
        return present_ ? o.outside.z * inverse_ior2_ / o.inside.z : 1.0f;
    }
    /// Reflectance of the coat's smooth surface; 0 without a coat.
    float specular_reflectance(const Ray& i) const { return 1 - i.transmittance; }
    /// Its specular reflection, sampled with this probability.
    BsdfSample specular_sample(const Ray& i, float probability) const {
        return {.wo = {-i.outside.x, -i.outside.y, i.outside.z},
                .weight = splat(specular_reflectance(i) / probability),
                .pdf = probability,
                .kind = SampleKind::specular,
                .exit_mm = {}};
    }
    bool present() const { return present_; }

 private:
    bool present_, absorbs_;
    float ior_, inverse_ior_, inverse_ior2_;
    FloatLanes depth_;  // of absorption, along the normal
};

/// Albedo of microfacets seen through their coat: the mean of the weights of their own samples,
/// tabulated over the cosine of incidence; and the probability with which to sample the coat's
/// specular reflection beside them.
class MicrofacetAlbedo {
 public:
    /// Fills the table. weight(wi, u) is the weight f cos / pdf, without the specular lobe, of the
    /// sample that the numbers u in (0, 1)^4 give for the direction wi; they are points of a
    /// Hammersley set.                                      [niederreiter-1992, chapter 3]
    template <class Weight>
    void tabulate(Weight&& weight) {
        constexpr unsigned kPoints = 256;
        for (int row = 0; row <= kIntervals; ++row) {
            const float z = std::max(static_cast<float>(row) / kIntervals, 1e-3f);
            const Vec3f wi = {std::sqrt(1 - z * z), 0, z};
            FloatLanes sum{};
            for (unsigned p = 0; p < kPoints; ++p) {
                const auto inverse = [p](unsigned base) {
                    return static_cast<float>(radical_inverse(p, base));
                };
                sum += weight(wi, std::array{(static_cast<float>(p) + 0.5f) / kPoints,
                                             inverse(2) + 0.5f / kPoints, inverse(3), inverse(5)});
            }
            lanes_[row] = sum * (1.0f / kPoints);
            means_[row] = lane_mean(lanes_[row]);
        }
    }

    /// Linear between rows; without the specular lobe.
    FloatLanes at(float cosine) const { return interpolate(lanes_, cosine); }

    /// Probability with which to sample the coat's specular reflection for a ray: in proportion to
    /// what coat and facets reflect; 0 without a coat.
    float specular_probability(const MicrofacetCoat& coat, const MicrofacetCoat::Ray& i) const {
        if (!coat.present()) return 0;
        const float specular = coat.specular_reflectance(i);
        if (!(specular > 0)) return 0;
        constexpr float kMin = 0.05f;  // either lobe, so that its weights stay bounded
        const float facets = interpolate(means_, i.outside.z);
        return std::clamp(specular / (specular + facets), kMin, 1 - kMin);
    }

 private:
    static constexpr int kIntervals = 16;

    template <class T>
    static T interpolate(const std::array<T, kIntervals + 1>& rows, float cosine) {
        const float x = std::min(cosine, 1.0f) * kIntervals;
        const int row = std::min(static_cast<int>(x), kIntervals - 1);
        return rows[row] + (x - static_cast<float>(row)) * (rows[row + 1] - rows[row]);
    }

    std::array<FloatLanes, kIntervals + 1> lanes_{};
    std::array<float, kIntervals + 1> means_{};
};

// A surface of microfacets that scatter once, under their coat.

/// What the models of such surfaces do alike, at eight wavelengths. `Model` derives from it, names
/// it a friend, and has
///
///     struct Pair;                                 two directions, and what the next two share
///         Pair(const Model&, const Ray& i, const Ray& o);   with members i and o
///     FloatLanes mean_value(const Pair&) const;    the BRDF without the specular lobe
///     float facet_density(const Pair&) const;      of draw(), per solid angle outside
///     std::optional<Ray> draw(const Ray& i, Vec2f u, Vec2f v) const;
///                                                  a direction that facets send light to, by four
///                                                  numbers; empty where none leaves
template <class Model>
class BoundMicrofacets : public BoundBsdf {
 public:
    FloatLanes eval(Vec3f wi, Vec3f wo) const override {
        if (wi.z <= 0 || wo.z <= 0) return FloatLanes{};
        return model().mean_value(pair(wi, wo));
    }
    float pdf(Vec3f wi, Vec3f wo) const override {
        if (wi.z <= 0 || wo.z <= 0) return 0;
        return density(pair(wi, wo));
    }
    BsdfValue evaluate(Vec3f wi, Vec3f wo) const override {
        if (wi.z <= 0 || wo.z <= 0) return {};
        const auto p = pair(wi, wo);
        return {model().mean_value(p), density(p)};
    }
    std::optional<BsdfSample> sample(Vec3f wi, float u_select, Vec2f u) const override {
        return sample_by(wi, u_select, u, [&](const auto& p) { return model().mean_value(p); });
    }
    FloatLanes albedo(Vec3f wi) const override {
        if (wi.z <= 0) return FloatLanes{};
        const FloatLanes specular = splat(coat_.specular_reflectance(coat_.refract(wi)));
        return min_lanes(specular + albedo_.at(wi.z), splat(1.0f));
    }

 protected:
    using Ray = MicrofacetCoat::Ray;

    BoundMicrofacets(const paint::Recipe& recipe, const MicrofacetDistribution& facets,
                     const Wavelengths& wavelengths_nm)
        : facets_(facets), coat_(recipe, wavelengths_nm) {}
    /// For the end of the model's constructor.
    void tabulate_albedo() {
        albedo_.tabulate([&](Vec3f wi, std::array<float, 4> u) -> FloatLanes {
            const Ray i = coat_.refract(wi);
            const auto o = model().draw(i, {u[0], u[1]}, {u[2], u[3]});
            if (!o) return FloatLanes{};
            const typename Model::Pair p(model(), i, *o);
            const float density = model().facet_density(p);
            if (!(density > 0)) return FloatLanes{};
            return model().mean_value(p) * (o->outside.z / density);
        });
    }

    const MicrofacetDistribution& facets() const { return facets_; }
    const MicrofacetCoat& coat() const { return coat_; }
    auto pair(Vec3f wi, Vec3f wo) const {
        return typename Model::Pair(model(), coat_.refract(wi), coat_.refract(wo));
    }
    /// Of sample(), the specular lobe aside.
    template <class Pair>
    float density(const Pair& p) const {
        return (1 - albedo_.specular_probability(coat_, p.i)) * model().facet_density(p);
    }
    /// The ray of a direction inside; empty where it does not leave.
    std::optional<Ray> leave(Vec3f inside) const {
        if (inside.z <= 0) return std::nullopt;
        const auto outside = coat_.leave(inside);
        if (!outside || outside->z <= 0) return std::nullopt;
        return coat_.refract(*outside);
    }
    /// sample() with another BRDF than the mean.
    template <class Value>
    std::optional<BsdfSample> sample_by(Vec3f wi, float u_select, Vec2f u, Value&& value) const {
        if (wi.z <= 0) return std::nullopt;
        const Ray i = coat_.refract(wi);
        const float p_specular = albedo_.specular_probability(coat_, i);
        if (u_select < p_specular) return coat_.specular_sample(i, p_specular);
        // Two more numbers than the caller gives: a hash of the three.
        const std::uint64_t bits =
            hash_of(std::bit_cast<std::uint32_t>(u.x), std::bit_cast<std::uint32_t>(u.y),
                    std::bit_cast<std::uint32_t>(u_select));
        const auto o = model().draw(i, u,
                                    {to_unit_float(static_cast<std::uint32_t>(bits >> 32)),
                                     to_unit_float(static_cast<std::uint32_t>(bits))});
        if (!o) return std::nullopt;
        const typename Model::Pair p(model(), i, *o);
        const float pdf = density(p);
        if (!(pdf > 0)) return std::nullopt;
        return BsdfSample{
            .wo = o->outside, .weight = value(p) * (o->outside.z / pdf), .pdf = pdf, .exit_mm = {}};
    }

 private:
    const Model& model() const { return static_cast<const Model&>(*this); }

    MicrofacetDistribution facets_;
    MicrofacetCoat coat_;
    MicrofacetAlbedo albedo_;
};

}  // namespace nacre::bsdf
