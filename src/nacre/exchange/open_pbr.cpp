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
/// @param root_l, root_v  smith_root() of the two
double smith_g2(double nl, double root_l, double nv, double root_v) {
    return 2 * nl * nv / (nl * root_v + nv * root_l);
}
double smith_g2(double nl, double nv, double alpha) {
    return smith_g2(nl, smith_root(nl, alpha), nv, smith_root(nv, alpha));
}

/// Integrals over facets drawn by D cos.
SplitAlbedo integrate_albedo(double nv, double alpha) {
    constexpr int kSteps = 128;
    static const std::array<double, kSteps> kCosines = [] {
        std::array<double, kSteps> cosines;
        for (int k = 0; k < kSteps; ++k) {
            cosines[k] = std::cos(std::numbers::pi * (k + 0.5) / kSteps);
        }
        return cosines;
    }();
    const double v_x = std::sqrt(1 - nv * nv), root_v = smith_root(nv, alpha);
    SplitAlbedo sum{0, 0};
    for (int i = 0; i < kSteps; ++i) {
        const double u = (i + 0.5) / kSteps;
        const double nh = std::sqrt((1 - u) / (1 + (alpha * alpha - 1) * u));
        const double sine = std::sqrt(1 - nh * nh);
        for (const double cosine : kCosines) {
            const double vh = v_x * sine * cosine + nv * nh, nl = 2 * vh * nh - nv;
            if (vh <= 0 || nl <= 0) continue;
            const double weight = smith_g2(nl, smith_root(nl, alpha), nv, root_v) * vh /
                                  (nv * nh * (kSteps * kSteps));
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

/// What single scattering between facets loses, over what it leaves: given back, a reflectance F
/// becomes F (1 + loss F).                                               [turquin-2019, eq. 14-16]
double loss(const SplitAlbedo& albedo) {
    const double all = albedo.scale + albedo.bias;
    return (1 - all) / all;
}

/// A flake that faces lamp and view.
struct Flake {
    double weight_nl;  ///< its share, times the cosine of the lamp with its normal
    double loss;
    SplitAlbedo albedo;
};

/// What the flakes reflect whatever their colour.
struct Flakes {
    double lobe = 0, lost = 0;  ///< the means of the lobe, and of the lobe times its loss
    std::array<Flake, 9> each;
    int count = 0;
};

Flakes flakes_at(const ShadingDirections& at, double reach, double alpha) {
    // The mean over flakes by Gauss' rule of three nodes in each slope.
    constexpr double kNode = 0.7745966692414834, kWeight[3] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
    Flakes flakes;
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) {
            const Vec3d normal =
                normalize(Vec3d{(i - 1) * kNode * reach, (k - 1) * kNode * reach, 1});
            const double nl = dot(normal, at.l), nv = dot(normal, at.v);
            if (nl <= 0 || nv <= 0) continue;
            const SplitAlbedo albedo = ggx_albedo(nv, alpha);
            const double weight = kWeight[i] * kWeight[k], lost = loss(albedo);
            const double lobe = weight * ggx_distribution(dot(normal, at.h), alpha) *
                                smith_g2(nl, nv, alpha) / (4 * nv);
            flakes.lobe += lobe;
            flakes.lost += lobe * lost;
            flakes.each[flakes.count++] = {weight * nl, lost, albedo};
        }
    }
    return flakes;
}

/// The facets of a coat: their albedo, and what they reflect but for Fresnel's factor.
struct CoatFacets {
    SplitAlbedo albedo{1, 0};
    double lobe = 0, lost = 0;  ///< as those of Flakes
};

CoatFacets coat_at(const ShadingDirections& at, double roughness) {
    const double alpha = std::max(kMinPbrAlpha, roughness * roughness);
    CoatFacets coat;
    coat.albedo = ggx_albedo(at.v.z, alpha);
    coat.lobe =
        ggx_distribution(at.h.z, alpha) * smith_g2(at.l.z, at.v.z, alpha) / (4 * at.v.z * at.l.z);
    coat.lost = coat.lobe * loss(coat.albedo);
    return coat;
}

/// A lamp and a view, with the last material's facets there.
class PbrAt {
 public:
    explicit PbrAt(const ShadingDirections& at) : at_(at) {}
    Vec3d brdf(const OpenPbr& s);

 private:
    Vec3d base_times_cosine(const OpenPbr& s) const;

    ShadingDirections at_;
    std::array<double, 4> shape_{-1, -1, -1, -1};  ///< the numbers that facets depend on
    Flakes flakes_;
    CoatFacets coat_;
};

/// Metal and dielectric below the coat, times the cosine of the lamp with their normals.
Vec3d PbrAt::base_times_cosine(const OpenPbr& s) const {
    const Vec3d tinted = tinted_schlick(at_.vh, s.base_color, s.specular_color);
    const Vec3d metal = flakes_.lobe * tinted + flakes_.lost * (tinted * tinted);

    // Below a coat the index counts relative to the coat's, from its denser side.
    const double ratio = s.specular_ior / s.coat_ior;
    const double ior = s.coat_weight > 0 ? std::max(ratio, 1 / ratio) : s.specular_ior;
    const double reflected = optics::dielectric_reflectance(1.0, ior, at_.vh);
    const double f0 = normal_reflectance(ior, 1);
    double below = 0;
    for (int i = 0; i < flakes_.count; ++i) {
        const Flake& flake = flakes_.each[i];
        const double albedo = f0 * flake.albedo.scale + flake.albedo.bias;
        below += flake.weight_nl * std::max(0.0, 1 - albedo * (1 + flake.loss * reflected));
    }
    const Vec3d dielectric =
        reflected * (flakes_.lobe + flakes_.lost * reflected) * s.specular_color +
        below * std::numbers::inv_pi * s.base_color;
    return s.base_metalness * metal + (1 - s.base_metalness) * dielectric;
}

Vec3d PbrAt::brdf(const OpenPbr& s) {
    const std::array<double, 4> shape{s.specular_roughness, s.flake_tilt, s.coat_weight,
                                      s.coat_roughness};
    if (shape != shape_) {
        shape_ = shape;
        // A rough coat widens the lobes below it.
        const double r4 = std::pow(s.specular_roughness, 4), c4 = std::pow(s.coat_roughness, 4);
        const double widened = s.coat_weight > 0 ? std::min(1.0, r4 + 2 * c4) : r4;
        const double alpha = std::max(kMinPbrAlpha, std::sqrt(widened));
        flakes_ = flakes_at(at_, s.flake_tilt * s.specular_roughness * s.specular_roughness, alpha);
        if (s.coat_weight > 0) coat_ = coat_at(at_, s.coat_roughness);
    }
    Vec3d f = base_times_cosine(s) / at_.l.z;
    if (s.coat_weight > 0) {
        const double f0 = normal_reflectance(s.coat_ior, 1);
        f = (1 - s.coat_weight * (f0 * coat_.albedo.scale + coat_.albedo.bias)) * f;
        if (s.coat_roughness > 0) {
            const double reflected = optics::dielectric_reflectance(1.0, s.coat_ior, at_.vh);
            f += s.coat_weight * reflected * (coat_.lobe + coat_.lost * reflected) * kPbrWhite;
        }
    }
    return f;
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

Vec3d open_pbr_brdf(const OpenPbr& surface, double theta_i, double theta_o, double phi) {
    return PbrAt(shading_directions(theta_i, theta_o, phi)).brdf(surface);
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
    model.brdfs = brdfs_by<PbrAt>(
        [model](const std::vector<double>& values) { return open_pbr(model, values); });
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
