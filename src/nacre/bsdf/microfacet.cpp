#include "nacre/bsdf/microfacet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/bsdf/flake_lobe.h"
#include "nacre/bsdf/warp.h"
#include "nacre/core/error.h"
#include "nacre/core/lane_math.h"
#include "nacre/optics/fresnel.h"

namespace nacre::bsdf {
namespace {

constexpr float kInvSqrtPi = std::numbers::inv_sqrtpi_v<float>;

// Single-precision erf^-1 for |x| < 1: polynomials in ln(1 - x^2), two ranges.      [giles-2011]
float erf_inverse(float x) {
    float w = -std::log((1 - x) * (1 + x)), p;
    if (w < 5) {
        constexpr float kCoefficients[] = {2.81022636e-08f,  3.43273939e-07f, -3.5233877e-06f,
                                           -4.39150654e-06f, 0.00021858087f,  -0.00125372503f,
                                           -0.00417768164f,  0.246640727f,    1.50140941f};
        w -= 2.5f;
        p = 0;
        for (const float c : kCoefficients) p = p * w + c;
    } else {
        constexpr float kCoefficients[] = {-0.000200214257f, 0.000100950558f, 0.00134934322f,
                                           -0.00367342844f,  0.00573950773f,  -0.0076224613f,
                                           0.00943887047f,   1.00167406f,     2.83297682f};
        w = std::sqrt(w) - 3;
        p = 0;
        for (const float c : kCoefficients) p = p * w + c;
    }
    return p * x;
}

}  // namespace

MicrofacetDistribution::MicrofacetDistribution(paint::FacetDistribution law, double alpha)
    : law_(law), alpha_(static_cast<float>(alpha)), inverse_alpha2_(1 / (alpha_ * alpha_)) {}

float MicrofacetDistribution::density(Vec3f h) const {
    const float cos2 = h.z * h.z;
    const float tan2 = (h.x * h.x + h.y * h.y) / cos2 * inverse_alpha2_;
    const float scale = inverse_alpha2_ * std::numbers::inv_pi_v<float> / (cos2 * cos2);
    if (law_ == paint::FacetDistribution::ggx) return scale / ((1 + tan2) * (1 + tan2));
    return tan2 < 80 ? scale * std::exp(-tan2) : 0;
}

float MicrofacetDistribution::lambda(Vec3f w) const {
    const float sin2 = w.x * w.x + w.y * w.y;
    // 1/a^2 with a = 1 / (alpha tan theta).
    const float spread2 = alpha_ * alpha_ * sin2 / (w.z * w.z);
    if (law_ == paint::FacetDistribution::ggx) return 0.5f * (std::sqrt(1 + spread2) - 1);
    if (spread2 < 1.0f / 16) return 0;  // Lambda(4) = 1e-9: below the rounding of 1 + Lambda
    const float a = 1 / std::sqrt(spread2);
    return std::max(0.0f, 0.5f * (std::exp(-a * a) * kInvSqrtPi / a - std::erfc(a)));
}

float sample_visible_beckmann_slope(float cotangent, float u) {
    // In b = erf(x) the distribution function is cot (1 + b) + exp(-x^2)/sqrt(pi), increasing and
    // concave with slope cot - x, so that Newton's steps approach from below. All is divided by
    // 1 + cot, which keeps it of order 1.
    const float scale = 1 / (1 + cotangent), c = cotangent * scale, g = kInvSqrtPi * scale;
    const float end = std::erf(cotangent);
    const float target =
        u * (c * (1 + end) + g * std::exp(-std::min(cotangent * cotangent, 80.0f)));
    constexpr float kMin = -0.9999999f, kMax = 0.9999999f;
    const float top = std::min(end, kMax);
    // First guess: exact for light along the normal, and not far off elsewhere.
    float b = std::clamp((1 + end) * u - 1, kMin, top);
    float x = erf_inverse(b);
    for (int step = 0; step < 12; ++step) {
        const float gauss = std::exp(-x * x);
        const float excess = c * (1 + b) + g * gauss - target;
        const float slope = c - scale * x;
        const float dx = 0.5f / (kInvSqrtPi * gauss);  // dx/db
        if (slope <= 1e-6f) {                          // next to the end, where the slope vanishes
            b = 0.5f * (b + kMin);
        } else {
            // Halley's correction of Newton's step: the slope falls by scale dx/db. It is for steps
            // that are small against the distance to where the slope vanishes.
            const float newton = -excess / slope;
            const float bend = std::min(0.5f, 0.5f * newton * scale * dx / slope);
            const float move = newton / (1 - bend);
            const float moved = move * dx;
            // So small a step needs no new inverse: x to second order.
            if (std::abs(moved) < 0.01f && std::abs(bend) < 0.01f) {
                return x + moved * (1 + x * moved);
            }
            b = std::clamp(b + move, 0.5f * (b + kMin), 0.5f * (b + top));
        }
        x = erf_inverse(b);
    }
    return x;
}

Vec3f MicrofacetDistribution::sample_visible(Vec3f wi, Vec2f u) const {
    if (law_ == paint::FacetDistribution::ggx) {
        const Vec3f stretched = normalize(Vec3f{alpha_ * wi.x, alpha_ * wi.y, wi.z});
        // The hemisphere seen from there: a half disk, and a half ellipse squeezed along `along`.
        const float sine = std::sqrt(stretched.x * stretched.x + stretched.y * stretched.y);
        const Vec3f across =
            sine > 0 ? Vec3f{-stretched.y / sine, stretched.x / sine, 0} : Vec3f{1, 0, 0};
        const Vec3f along = cross(stretched, across);
        Vec2f d = concentric_disk(u);
        const float s = 0.5f * (1 + stretched.z);
        d.y = (1 - s) * std::sqrt(std::max(0.0f, 1 - d.x * d.x)) + s * d.y;
        const float up = std::sqrt(std::max(0.0f, 1 - d.x * d.x - d.y * d.y));
        const Vec3f m = d.x * across + d.y * along + up * stretched;
        return normalize(Vec3f{alpha_ * m.x, alpha_ * m.y, std::max(1e-6f, m.z)});
    }
    const float sine = std::sqrt(wi.x * wi.x + wi.y * wi.y);
    const float cotangent = sine > 0 ? wi.z / (alpha_ * sine) : 1e9f;
    const float ex = sine > 0 ? wi.x / sine : 1.0f, ey = sine > 0 ? wi.y / sine : 0.0f;
    const float x = alpha_ * sample_visible_beckmann_slope(cotangent, std::max(u.x, 1e-7f));
    const float y = alpha_ * erf_inverse(std::clamp(2 * u.y - 1, -0.9999999f, 0.9999999f));
    return normalize(Vec3f{-(x * ex - y * ey), -(x * ey + y * ex), 1.0f});
}

namespace {

constexpr double kIndexWavelength_nm = 550;
constexpr double kMmPerUm = 1e-3;

}  // namespace

double index_around_facets(const paint::Recipe& recipe) {
    return recipe.clearcoat ? recipe.binder.index(kIndexWavelength_nm).real() : 1.0;
}

void validate_microfacet_recipe(const paint::Recipe& recipe) {
    if (!recipe.microfacet) {
        throw DomainError("microfacet: is missing; this model needs the table [microfacet]");
    }
    paint::validate(recipe, {kIndexWavelength_nm});
    if (recipe.clearcoat && recipe.clearcoat->roughness > 0) {
        throw DomainError(fmt::format(
            "clearcoat.roughness = {}: must be 0 over microfacets, which take a smooth coat only",
            recipe.clearcoat->roughness));
    }
}

MicrofacetCoat::MicrofacetCoat(const paint::Recipe& recipe, const Wavelengths& wavelengths_nm)
    : present_(recipe.clearcoat.has_value()),
      ior_(static_cast<float>(index_around_facets(recipe))),
      inverse_ior_(1 / ior_),
      inverse_ior2_(inverse_ior_ * inverse_ior_),
      depth_{} {
    if (present_) {
        depth_ = make_lanes([&](int i) {
            return static_cast<float>(recipe.clearcoat->absorption_per_mm(wavelengths_nm[i]) *
                                      recipe.clearcoat->thickness_um * kMmPerUm);
        });
    }
    absorbs_ = lane_max(depth_) > 0;
}

MicrofacetCoat::Ray MicrofacetCoat::refract(Vec3f outside) const {
    if (!present_) return {outside, outside, 1};
    return {outside, refract_in(outside, inverse_ior_),
            1 - optics::fresnel_dielectric(ior_, outside.z)};
}

std::optional<Vec3f> MicrofacetCoat::leave(Vec3f inside) const {
    return present_ ? refract_out(inside, ior_) : inside;
}

FloatLanes MicrofacetCoat::transfer(const Ray& i, const Ray& o) const {
    if (!present_) return splat(1.0f);
    const float interface = i.transmittance * o.transmittance * inverse_ior2_;
    if (!absorbs_) return splat(interface);
    return interface * exp_lanes(-depth_ * (1 / i.inside.z + 1 / o.inside.z));
}

}  // namespace nacre::bsdf
