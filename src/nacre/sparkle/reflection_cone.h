#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "nacre/core/lane_math.h"
#include "nacre/core/lanes.h"
#include "nacre/core/vec.h"

// The facets that reflect light from one direction into a narrow cone of others. Their normals
// form Omega_h, a region of the sphere with a spherical conic for a border.  [jakob-2014, section
// 4]

namespace nacre::sparkle {

/// The cone of half-angle gamma about wo, seen from wi. Both are unit vectors.
struct ReflectionCone {
    Vec3f wi, wo;
    float chord2;  ///< squared chord of gamma, 4 sin^2(gamma / 2)

    ReflectionCone(Vec3f wi, Vec3f wo, float gamma_chord2) : wi(wi), wo(wo), chord2(gamma_chord2) {}

    /// Whether a facet with this unit normal reflects wi into the cone: the conic test, by
    /// reflecting the ray. Chords keep the digits that the cosine of a small angle loses.
    /// Reflection is an isometry and its own inverse, so the same facets count when wi and wo
    /// change places.
    /// The normal (x, y, z) may have any length, and be numbers or lanes of them.
    template <class V>
    auto contains(V x, V y, V z) const {
        const Vec3f sum = wi + wo;
        const V twice = 2 * (wi.x * x + wi.y * y + wi.z * z), length2 = x * x + y * y + z * z;
        const V a = twice * x - length2 * sum.x, b = twice * y - length2 * sum.y;
        const V c = twice * z - length2 * sum.z;
        return a * a + b * b + c * c <= chord2 * length2 * length2;
    }
    bool contains(Vec3f m) const { return contains(m.x, m.y, m.z); }
};

/// The largest half-angle of a cone in rad over alpha: ConeRule does not resolve smoother facets.
inline constexpr double kMaxConePerRoughness = 25;

/// Error of ConeRule's means over their peaks, 1 / (pi alpha^2) and that over 4 w_i.h: for
/// incidence up to 75 deg, and beyond, where the horizon may cut the cone.
inline constexpr double kConeRuleError = 2e-4;
inline constexpr double kConeRuleGrazingError = 1e-2;

/// Mean over the cone of functions of the facet normal: a product rule, Gauss-Legendre in the
/// cosine from the axis and evenly spaced around it, made once for a cone's width. There are two,
/// the finer for grazing directions, which stretch the region of normals.
class ConeRule {
 public:
    /// @param gamma_rad  half-angle of the cone, in [1e-5, pi/2]
    /// @param alpha      roughness of the facets the rule is for, in [1e-4, 2]: the rougher, the
    ///                   fewer nodes; gamma_rad / alpha is at most kMaxConePerRoughness
    /// @throws DomainError naming the argument, its value and its range
    ConeRule(double gamma_rad, double alpha);

    /// Solid angle of the cone, 2 pi (1 - cos gamma). (Not pi (1 - cos gamma).)
    double solid_angle() const { return solid_angle_; }
    float chord2() const { return chord2_; }
    /// Of the rule for directions that do not graze.
    int nodes() const { return kLanes * static_cast<int>(groups_.size()); }

    /// Means over the cone, in 1/sr.
    struct Means {
        float density;  ///< of the Beckmann density D(m)
        /// Of D(m) (m.n) / (4 wi.m): times solid_angle(), the fraction of facets.
        float projected;
    };
    /// Of the normals m that reflect wi into the directions of the cone about wo, for Beckmann
    /// facets of this roughness.                                          [walter-2007, eq. 14, 25]
    Means means(Vec3f wi, Vec3f wo) const {
        return visit(wi, wo, [](FloatLanes, FloatLanes, FloatLanes, FloatLanes) {});
    }

    /// The same, calling visit(x, y, z, fraction) with the normals of each eight nodes and the
    /// fraction of facets that is each node's part of the integral.
    template <class Visit>
    Means visit(Vec3f wi, Vec3f wo, Visit&& visit) const;

    /// The direction at (u.x, u.y) in [0, 1)^2 of the cone about wo, evenly over its solid angle.
    Vec3f sample(Vec3f wo, Vec2f u) const;

 private:
    struct Group {
        FloatLanes x, y, z, weight;  // directions about the z axis; weights sum to 1
    };
    static std::vector<Group> product_rule(int rings, double versine);

    std::vector<Group> groups_, grazing_groups_;
    double solid_angle_;
    float chord2_, versine_, inverse_alpha2_, norm_;
};

template <class Visit>
ConeRule::Means ConeRule::visit(Vec3f wi, Vec3f wo, Visit&& visit) const {
    const Frame frame = Frame::around(wo);
    const float quarter_angle = 0.25f * static_cast<float>(solid_angle_);
    FloatLanes density{}, projected{};
    // |wi + wo| = 2 cos of the incidence on the facets.
    constexpr float kGrazingCosine = 0.35f;
    const Vec3f sum = wi + wo;
    const bool grazing = dot(sum, sum) < 4 * kGrazingCosine * kGrazingCosine;
    for (const Group& g : grazing ? grazing_groups_ : groups_) {
        const FloatLanes hx = wi.x + g.x * frame.s.x + g.y * frame.t.x + g.z * frame.n.x;
        const FloatLanes hy = wi.y + g.x * frame.s.y + g.y * frame.t.y + g.z * frame.n.y;
        const FloatLanes hz = wi.z + g.x * frame.s.z + g.y * frame.t.z + g.z * frame.n.z;
        // Facets face upwards: none lies where the half vector does not.
        const FloatLanes z = max_lanes(hz, splat(1e-6f));
        const FloatLanes r2 = hx * hx + hy * hy, z2 = z * z, length2 = r2 + z2;
        const FloatLanes sec2 = length2 / z2, exponent = r2 / z2 * inverse_alpha2_;
        const FloatLanes d = exp_lanes(-exponent) * (g.weight * norm_) * sec2 * sec2;
        const FloatLanes seen = hz > 0.0f && exponent < 80.0f ? d : FloatLanes{};
        // (m.n) / (wi.m) = hz / (wi.h), and wi.h = |h|^2 / 2 for unit directions.
        const FloatLanes p = seen * (0.5f * z / length2);
        density += seen;
        projected += p;
        const FloatLanes inverse_length = 1.0f / sqrt_lanes(length2);
        visit(hx * inverse_length, hy * inverse_length, z * inverse_length,
              p * (4 * quarter_angle));
    }
    return {lane_sum(density), lane_sum(projected)};
}

inline Vec3f ConeRule::sample(Vec3f wo, Vec2f u) const {
    const float versine = u.x * versine_;
    const float sine = std::sqrt(std::max(0.0f, versine * (2 - versine)));
    const float angle = 2 * std::numbers::pi_v<float> * u.y;
    return Frame::around(wo).to_world(
        Vec3f{sine * std::cos(angle), sine * std::sin(angle), 1 - versine});
}

}  // namespace nacre::sparkle
