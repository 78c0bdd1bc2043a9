#include "nacre/exchange/open_pbr.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "nacre/core/parallel.h"
#include "nacre/exchange/shading.h"
#include "nacre/optics/fresnel.h"

namespace nacre::exchange {

namespace {

constexpr double kMinPbrAlpha = 1e-3;
const Vec3d kPbrWhite = {1, 1, 1};

double smith_root(double cosine, double alpha) {
    return std::sqrt(alpha * alpha + (1 - alpha * alpha) * cosine * cosine);
}

/// Height-correlated.                                                    [heitz-2014]
double smith_g2(double nl, double nv, double alpha) {
    return 2 * nl * nv / (nl * smith_root(nv, alpha) + nv * smith_root(nl, alpha));
}

/// Integrals over facets drawn by D cos.
SplitAlbedo integrate_albedo(double nv, double alpha) {
    constexpr int kSteps = 128;
    const Vec3d v = {std::sqrt(1 - nv * nv), 0, nv};
    SplitAlbedo sum{0, 0};
    for (int i = 0; i < kSteps; ++i) {
        const double u = (i + 0.5) / kSteps;
        const double nh = std::sqrt((1 - u) / (1 + (alpha * alpha - 1) * u));
        const double sine = std::sqrt(1 - nh * nh);
        for (int k = 0; k < kSteps; ++k) {
            const double phi = std::numbers::pi * (k + 0.5) / kSteps;
            const Vec3d h = {sine * std::cos(phi), sine * std::sin(phi), nh};
            const double vh = dot(v, h), nl = 2 * vh * nh - nv;
            if (vh <= 0 || nl <= 0) continue;
            const double weight = smith_g2(nl, nv, alpha) * vh / (nv * nh) / (kSteps * kSteps);
            const double edge = schlick_weight(vh);
            sum.scale += weight * (1 - edge);
            sum.bias += weight * edge;
        }
    }
    return sum;
}

/// By the cosine and the square root of alpha, both from kMin to 1.
struct AlbedoTable {
    static constexpr int kNodes = 33;
    static constexpr double kMin = 0.02;
    std::array<SplitAlbedo, kNodes * kNodes> values;

    static double node(int i) { return kMin + (1 - kMin) * i / (kNodes - 1); }
    AlbedoTable() {
        parallel_for(0, kNodes * kNodes, [&](std::size_t i) {
            const double root = node(static_cast<int>(i) % kNodes);
            values[i] = integrate_albedo(node(static_cast<int>(i) / kNodes), root * root);
        });
    }
    SplitAlbedo at(double cosine, double alpha) const {
        struct Place {
            int node;
            double beyond;
        };
        const auto place = [](double x) {
            const double at = std::clamp((x - kMin) / (1 - kMin), 0.0, 1.0) * (kNodes - 1);
            const int lower = std::min(static_cast<int>(at), kNodes - 2);
            return Place{lower, at - lower};
        };
        const Place row = place(cosine), column = place(std::sqrt(alpha));
        const auto mix = [&](double SplitAlbedo::*part) {
            const auto value = [&](int r, int c) { return values[r * kNodes + c].*part; };
            const auto along = [&](int r) {
                return (1 - column.beyond) * value(r, column.node) +
                       column.beyond * value(r, column.node + 1);
            };
            return (1 - row.beyond) * along(row.node) + row.beyond * along(row.node + 1);
        };
        return {mix(&SplitAlbedo::scale), mix(&SplitAlbedo::bias)};
    }
};

/// What single scattering between facets loses, given back.             [turquin-2019, eq. 14-16]
Vec3d compensation(double nv, double alpha, const Vec3d& fresnel) {
    const SplitAlbedo albedo = ggx_albedo(nv, alpha);
    const double all = albedo.scale + albedo.bias;
    return kPbrWhite + ((1 - all) / all) * fresnel;
}

struct Facing {
    Vec3d l, v, h;
    double vh;
};

/// Metal and dielectric below the coat, times the cosine of the lamp with their normal.
Vec3d base_times_cosine(const OpenPbr& s, const Facing& at, const Vec3d& normal, double alpha) {
    const double nl = dot(normal, at.l), nv = dot(normal, at.v);
    if (nl <= 0 || nv <= 0) return {};
    const double lobe =
        ggx_distribution(dot(normal, at.h), alpha) * smith_g2(nl, nv, alpha) / (4 * nv);
    const Vec3d tinted = tinted_schlick(at.vh, s.base_color, s.specular_color);
    const Vec3d metal = lobe * (tinted * compensation(nv, alpha, tinted));

    // Below a coat the index counts relative to the coat's, from its denser side.
    const double ratio = s.specular_ior / s.coat_ior;
    const double ior = s.coat_weight > 0 ? std::max(ratio, 1 / ratio) : s.specular_ior;
    const double reflected = optics::dielectric_reflectance(1.0, ior, at.vh);
    const Vec3d gain = compensation(nv, alpha, reflected * kPbrWhite);
    const SplitAlbedo albedo = ggx_albedo(nv, alpha);
    const double below = 1 - (normal_reflectance(ior, 1) * albedo.scale + albedo.bias) * gain.x;
    const Vec3d dielectric = lobe * reflected * (gain * s.specular_color) +
                             std::max(0.0, below) * nl * std::numbers::inv_pi * s.base_color;
    return s.base_metalness * metal + (1 - s.base_metalness) * dielectric;
}

}  // namespace

SplitAlbedo ggx_albedo(double cosine, double alpha) {
    static const AlbedoTable kTable;
    return kTable.at(cosine, alpha);
}

Vec3d tinted_schlick(double cosine, const Vec3d& f0, const Vec3d& tint) {
    constexpr double kCosine = 1.0 / 7;
    const double dip = cosine * (1 - cosine) * schlick_weight(cosine) /
                       (kCosine * (1 - kCosine) * schlick_weight(kCosine));
    const auto schlick = [&](double c) { return f0 + schlick_weight(c) * (kPbrWhite - f0); };
    return schlick(cosine) - dip * (schlick(kCosine) * (kPbrWhite - tint));
}

Vec3d open_pbr_brdf(const OpenPbr& s, double theta_i, double theta_o, double phi) {
    Facing at;
    at.l = {std::sin(theta_i), 0, std::cos(theta_i)};
    at.v = {std::sin(theta_o) * std::cos(phi), std::sin(theta_o) * std::sin(phi),
            std::cos(theta_o)};
    at.h = normalize(at.l + at.v);
    at.vh = dot(at.v, at.h);
    // A rough coat widens the lobes below it.
    const double r4 = std::pow(s.specular_roughness, 4), c4 = std::pow(s.coat_roughness, 4);
    const double widened = s.coat_weight > 0 ? std::min(1.0, r4 + 2 * c4) : r4;
    const double alpha = std::max(kMinPbrAlpha, std::sqrt(widened));

    // The mean over flakes by Gauss' rule of three nodes in each slope.
    constexpr double kNode = 0.7745966692414834, kWeight[3] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
    const double reach = kNode * s.flake_tilt * s.specular_roughness * s.specular_roughness;
    Vec3d sum;
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) {
            const Vec3d normal = normalize(Vec3d{(i - 1) * reach, (k - 1) * reach, 1});
            sum += kWeight[i] * kWeight[k] * base_times_cosine(s, at, normal, alpha);
        }
    }
    Vec3d f = sum / at.l.z;
    if (s.coat_weight > 0) {
        const double coat_alpha = std::max(kMinPbrAlpha, s.coat_roughness * s.coat_roughness);
        const SplitAlbedo albedo = ggx_albedo(at.v.z, coat_alpha);
        const double f0 = normal_reflectance(s.coat_ior, 1);
        f = (1 - s.coat_weight * (f0 * albedo.scale + albedo.bias)) * f;
        if (s.coat_roughness > 0) {
            const double reflected = optics::dielectric_reflectance(1.0, s.coat_ior, at.vh);
            const double lobe = ggx_distribution(at.h.z, coat_alpha) *
                                smith_g2(at.l.z, at.v.z, coat_alpha) / (4 * at.v.z * at.l.z);
            f += s.coat_weight * lobe * reflected *
                 compensation(at.v.z, coat_alpha, reflected * kPbrWhite);
        }
    }
    return f;
}

namespace {

/// Below, the law of the metal's reflectance is negative at some angle for a black one.
constexpr double kMinMetalTint = 0.52;

/// In the order of open_pbr().
const std::vector<FormatParameter> kPbrParameters = {
    {"base_color[0]", 0, 1, 0.5, 2},
    {"base_color[1]", 0, 1, 0.5, 2},
    {"base_color[2]", 0, 1, 0.5, 2},
    {"base_metalness", 0, 1, 0.8},
    {"specular_color[0]", kMinMetalTint, 1, 0.9},
    {"specular_color[1]", kMinMetalTint, 1, 0.9},
    {"specular_color[2]", kMinMetalTint, 1, 0.9},
    {"specular_roughness", 0.1, 1, 0.4},
    {"specular_ior", 1, 3, 1.8},
};

}  // namespace

FormatModel open_pbr_model(bool coat, bool coat_is_rough) {
    FormatModel model;
    model.format = "OpenPBR (MaterialX)";
    model.parameters = kPbrParameters;
    if (coat && coat_is_rough) model.parameters.push_back({"coat_roughness", 0.1, 1, 0.3});
    model.coat = coat;
    model.brdf = [model](const std::vector<double>& values, double theta_i, double theta_o,
                         double phi) {
        return open_pbr_brdf(open_pbr(model, values), theta_i, theta_o, phi);
    };
    return model;
}

OpenPbr open_pbr(const FormatModel& model, const std::vector<double>& v) {
    OpenPbr s;
    s.base_color = {v[0], v[1], v[2]};
    s.base_metalness = v[3];
    s.specular_color = {v[4], v[5], v[6]};
    s.specular_roughness = v[7];
    s.specular_ior = v[8];
    s.coat_weight = model.coat ? 1 : 0;
    if (v.size() > kPbrParameters.size()) s.coat_roughness = v[9];
    return s;
}

}  // namespace nacre::exchange
