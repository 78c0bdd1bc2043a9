#include "nacre/exchange/cycles_material.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/exchange/shading.h"
#include "nacre/optics/fresnel.h"

namespace nacre::exchange {

namespace {

/// Where nodes bound the view's cosine, which they divide by.
constexpr double kMinViewCosine = 0.01;

/// Of a fit's lobes: narrower ones would hide between the views that it sees.
constexpr double kMinRoughness = 0.25;

/// Beyond, Cycles turns normals that would mirror views of up to 87 deg into the surface.
constexpr double kMinLean = -0.4, kMaxLean = 0.5;

/// Of Beckmann's facets.                                                 [walter-2007, eq. 25]
double beckmann_distribution(double nh, double alpha) {
    const double c2 = nh * nh, a2 = alpha * alpha;
    return std::exp((c2 - 1) / (c2 * a2)) / (std::numbers::pi * a2 * c2 * c2);
}

/// Smith's hidden over visible area, by a rational fit.          [walter-2007, eq. 27; heitz-2014]
double beckmann_lambda(double cosine, double alpha) {
    const double a = cosine / (alpha * std::sqrt(std::max(0.0, 1 - cosine * cosine)));
    if (!(a < 1.598)) return 0;
    return ((0.396 * a - 1.259) * a + 1) / ((2.181 * a + 3.535) * a);
}

/// What is reflected about a normal, over the lamp's cosine with the surface.
double glossy(const Vec3d& normal, const ShadingDirections& at, double alpha) {
    const double nl = dot(normal, at.l), nv = dot(normal, at.v);
    if (nl <= 0 || nv <= 0) return 0;
    const double seen = 1 / (1 + beckmann_lambda(nl, alpha) + beckmann_lambda(nv, alpha));
    return beckmann_distribution(dot(normal, at.h), alpha) * seen / (4 * nv * at.l.z);
}

/// The weights of the stops at a place in [0, 1].
std::array<double, CyclesRamp::kStops> ramp_weights(double place) {
    constexpr int kStops = CyclesRamp::kStops;
    const double x = place * (kStops - 1);
    const int k = std::clamp(static_cast<int>(x), 0, kStops - 2);
    const double t = x - k, s = 1 - t;
    std::array<double, kStops> weights{};
    const auto add = [&](int i, double w) { weights[std::clamp(i, 0, kStops - 1)] += w / 6; };
    add(k - 1, s * s * s);
    add(k, 4 - 6 * t * t + 3 * t * t * t);
    add(k + 1, 4 - 6 * s * s + 3 * s * s * s);
    add(k + 2, t * t * t);
    return weights;
}

Vec3d ramp_color(const CyclesRamp& ramp, const std::array<double, CyclesRamp::kStops>& weights) {
    Vec3d color;
    for (int k = 0; k < CyclesRamp::kStops; ++k) color += weights[k] * ramp.stops[k];
    return color;
}

/// A lamp and a view, with what materials have in common there.
class CyclesAt {
 public:
    explicit CyclesAt(const ShadingDirections& at)
        : at_(at), cosine_(std::max(at.v.z, kMinViewCosine)) {
        weights_ = ramp_weights(std::acos(cosine_) / (0.5 * std::numbers::pi));
    }
    Vec3d brdf(const CyclesMaterial& m);

 private:
    /// A lobe by its shape, without its colour.
    struct Lobe {
        double roughness = -1, widening = 0, lean = 0;
        double reflected = 0;
    };
    double reflected(const CyclesLobe& lobe, Lobe& last) const;

    ShadingDirections at_;
    double cosine_;
    std::array<double, CyclesRamp::kStops> weights_;
    std::array<Lobe, CyclesMaterial::kLobes> last_;
};

double CyclesAt::reflected(const CyclesLobe& lobe, Lobe& last) const {
    if (lobe.roughness != last.roughness || lobe.widening != last.widening ||
        lobe.lean != last.lean) {
        const double alpha =
            std::min(1.0, lobe.roughness * lobe.roughness * std::pow(cosine_, -lobe.widening));
        const double lean = lobe.lean * cosine_;
        const Vec3d normal = normalize(Vec3d{lean * at_.v.x, lean * at_.v.y, 1});
        last = {lobe.roughness, lobe.widening, lobe.lean, glossy(normal, at_, alpha)};
    }
    return last.reflected;
}

Vec3d CyclesAt::brdf(const CyclesMaterial& m) {
    Vec3d f = std::numbers::inv_pi * m.diffuse;
    for (int i = 0; i < CyclesMaterial::kLobes; ++i) {
        f += reflected(m.lobes[i], last_[i]) * ramp_color(m.lobes[i].color, weights_);
    }
    if (m.coat) {
        const double reflected = optics::dielectric_reflectance(1.0, m.coat_ior, at_.v.z);
        f = (1 - reflected) * f;
        if (m.coat_roughness > 0) {
            const double alpha = m.coat_roughness * m.coat_roughness;
            f += reflected * glossy({0, 0, 1}, at_, alpha) * Vec3d{1, 1, 1};
        }
    }
    return f;
}

}  // namespace

Vec3d CyclesRamp::at(double place) const { return ramp_color(*this, ramp_weights(place)); }

Vec3d cycles_brdf(const CyclesMaterial& material, double theta_i, double theta_o, double phi) {
    return CyclesAt(shading_directions(theta_i, theta_o, phi)).brdf(material);
}

FormatModel cycles_model(bool coat, bool coat_is_rough, double coat_ior) {
    constexpr std::array<double, CyclesMaterial::kLobes> kRoughness{0.35, 0.6, 0.8};
    FormatModel model;
    model.format = "Cycles (Blender)";
    for (std::size_t i = 0; i < kRoughness.size(); ++i) {
        const std::string lobe = fmt::format("lobe {} ", i + 1);
        model.parameters.push_back({lobe + "roughness", kMinRoughness, 1, kRoughness[i]});
        model.parameters.push_back({lobe + "widening", 0, 1, 0.5});
        model.parameters.push_back({lobe + "lean", kMinLean, kMaxLean, 0});
    }
    const auto add_fractions = [&](const std::string& ramp, int stops) {
        for (int k = 0; k < 3 * stops; ++k) {
            model.parameters.push_back(
                {fmt::format("{} share[{}][{}]", ramp, k / 3, k % 3), 0, 1, 0.3, 2, false});
        }
    };
    add_fractions("diffuse", 1);
    for (std::size_t i = 0; i < kRoughness.size(); ++i) {
        add_fractions(fmt::format("lobe {}", i + 1), CyclesRamp::kStops);
    }
    if (coat && coat_is_rough) model.parameters.push_back({"coat roughness", 0.1, 1, 0.3});
    model.coat = coat;
    model.coat_ior = coat_ior;
    model.across = true;
    model.trial_steps = 30;
    model.brdfs = brdfs_by<CyclesAt>(
        [model](const std::vector<double>& values) { return cycles_material(model, values); });
    return model;
}

CyclesMaterial cycles_material(const FormatModel& model, const std::vector<double>& values) {
    CyclesMaterial m;
    auto value = values.begin();
    for (CyclesLobe& lobe : m.lobes) {
        lobe.roughness = *value++;
        lobe.widening = *value++;
        lobe.lean = *value++;
    }
    const auto next_color = [&] {
        Vec3d fraction;
        for (int c = 0; c < 3; ++c) fraction[c] = *value++;
        return fraction;
    };
    const Vec3d white{1, 1, 1}, diffuse = next_color();
    m.diffuse = diffuse;
    std::array<Vec3d, CyclesRamp::kStops> left;
    left.fill(white - diffuse);
    for (CyclesLobe& lobe : m.lobes) {
        for (int k = 0; k < CyclesRamp::kStops; ++k) {
            const Vec3d fraction = next_color();
            lobe.color.stops[k] = left[k] * fraction;
            left[k] = left[k] * (white - fraction);
        }
    }
    m.coat = model.coat;
    m.coat_ior = model.coat_ior;
    if (value != values.end()) m.coat_roughness = *value;
    return m;
}

std::vector<std::pair<std::string, double>> cycles_parameters(const CyclesMaterial& m) {
    std::vector<std::pair<std::string, double>> named;
    const auto add_color = [&](const std::string& name, const Vec3d& color) {
        for (int c = 0; c < 3; ++c) named.emplace_back(fmt::format("{}[{}]", name, c), color[c]);
    };
    add_color("diffuse", m.diffuse);
    for (std::size_t i = 0; i < m.lobes.size(); ++i) {
        const CyclesLobe& lobe = m.lobes[i];
        const std::string prefix = fmt::format("lobe {} ", i + 1);
        named.emplace_back(prefix + "roughness", lobe.roughness);
        named.emplace_back(prefix + "widening", lobe.widening);
        named.emplace_back(prefix + "lean", lobe.lean);
        for (int k = 0; k < CyclesRamp::kStops; ++k) {
            add_color(fmt::format("{}color[{}]", prefix, k), lobe.color.stops[k]);
        }
    }
    if (m.coat) {
        named.emplace_back("coat ior", m.coat_ior);
        named.emplace_back("coat roughness", m.coat_roughness);
    }
    return named;
}

}  // namespace nacre::exchange
