#include "nacre/bsdf/models/hot_spot_block.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/bsdf/flake_lobe.h"
#include "nacre/core/lane_math.h"

namespace nacre::bsdf {
namespace {

// Nodes over the slopes of a lobe (docs/nacre-model.md has by how much compensation factors err).
constexpr int kRadii = 12, kAzimuths = 10;

/// Nodes over half the azimuths of what is scattered evenly. Gaps are shared by two rays whose slopes are
/// alike, over the fewer azimuths the steeper slopes there are; without a coat there is no end of them.
int exit_azimuths(double ior) {
    return static_cast<int>(std::ceil(std::clamp(8 / std::sqrt(ior * ior - 1), 8.0, 48.0)));
}

// The tangent of the least tilt, towards the azimuth of this cosine and sine, of a flake that mirrors
// light from i into total reflection: beyond inside.z = min_z.
//
// As the flake tilts by a in a plane through the vertical, what it mirrors turns by 2 a about the
// normal of that plane, towards which the light from i has the angle beta: z = rho cos(2 a - beta).
double slope_of_total_reflection(const Vec3f& i, double cosine, double sine, double min_z) {
    const double along = i.x * cosine + i.y * sine;
    const double rho = std::hypot(along, i.z), beta = std::atan2(along, i.z);
    return std::tan(0.5 * (beta + std::acos(std::min(1.0, min_z / rho))));
}

bool scatters(const solver::LayerMedium& layer) {
    return !layer.flakes.empty() ||
           std::ranges::any_of(layer.pigments, [](const solver::PigmentMedium& pigment) {
               return std::ranges::any_of(pigment.scattering_per_um,
                                          [](double sigma) { return sigma > 0; });
           });
}

}  // namespace

HotSpotBlock::HotSpotBlock(const solver::SolvedPaint& paint, const HotSpotTables& tables, int block)
    : medium_(paint.medium),
      block_(block),
      where_(wavelengths_of_block(medium_.wavelength_count(), block)),
      hot_spot_(tables, where_),
      coat_(tables.coat()),
      mean_ior_(mean_ior(medium_)),
      ior_(lanes(medium_.ior)),
      ground_reflectance_(lanes(medium_.substrate_reflectance)),
      cover_depth_(lanes(medium_.clearcoat_depth)) {
    const int count = medium_.wavelength_count();
    for (const std::vector<float>& from : tables.extinction()) {
        auto& to = extinction_.emplace_back();
        for (int row = 0; row <= kDirectionIntervals; ++row) {
            to.push_back(at_wavelengths(where_, [&](int w) { return from[row * count + w]; }));
        }
    }
    for (; first_ < medium_.layers.size() && !scatters(medium_.layers[first_]); ++first_) {
        cover_depth_ +=
            static_cast<float>(medium_.layers[first_].thickness_um) * extinction_[first_][0];
    }
}

FloatLanes HotSpotBlock::lanes(const std::vector<double>& values) const {
    return at_wavelengths(where_, [&](int w) { return values[w]; });
}

Ray HotSpotBlock::ray(double theta, double phi) const {
    return make_ray(theta, phi, 1 / mean_ior_);
}

FloatLanes HotSpotBlock::clear_transmittance(const Ray& ray) const {
    return exp_lanes(-cover_depth_ / ray.inside.z);
}

FloatLanes HotSpotBlock::transmittance_of_layers(const Ray& ray) const {
    FloatLanes depth = cover_depth_;
    for (std::size_t l = first_; l < medium_.layers.size(); ++l) {
        depth += static_cast<float>(medium_.layers[l].thickness_um) * ray.look_up(extinction_[l]);
    }
    return exp_lanes(-depth / ray.inside.z);
}

FloatLanes HotSpotBlock::rate(std::size_t layer, const Ray& i, const Ray& o) const {
    return i.look_up(extinction_[layer]) / i.inside.z + o.look_up(extinction_[layer]) / o.inside.z;
}

FloatLanes HotSpotBlock::lost(const Ray& o) const {
    return lost_at_interface(clear_transmittance(o), transmittance(o));
}

std::vector<HotSpotBlock::Exit> HotSpotBlock::exits(const Quadrature& polar) const {
    bool any = lane_max(ground_reflectance_) > 0;
    for (const auto& layer : medium_.layers) any = any || !layer.pigments.empty();
    std::vector<Exit> out;
    if (!any) return out;
    const Quadrature& azimuths = unit_gauss_legendre(exit_azimuths(mean_ior_));
    for (std::size_t n = 0; n < polar.nodes.size(); ++n) {
        for (std::size_t a = 0; a < azimuths.nodes.size(); ++a) {
            const Ray o = ray(polar.nodes[n], std::numbers::pi * azimuths.nodes[a]);
            const FloatLanes solid_angle =
                inverse_ior2() * static_cast<float>(polar.weights[n] * std::sin(polar.nodes[n]) *
                                                    std::cos(polar.nodes[n]) * 2 *
                                                    std::numbers::pi * azimuths.weights[a]);
            out.push_back({o, solid_angle,
                           // The cover on the way out is in lost().
                           exp_lanes(cover_depth_ / o.inside.z) * solid_angle * lost(o)});
        }
    }
    return out;
}

HotSpotBlock::Budget HotSpotBlock::budget(const Ray& i, std::span<const Exit> exits) const {
    Budget sum;
    sum.rescattered = scattered_once(i);
    add_flakes(i, sum);
    add_others(i, exits, sum);
    return sum;
}

FloatLanes HotSpotBlock::scattered_once(const Ray& i) const {
    FloatLanes sum{};
    FloatLanes depth = cover_depth_ / i.inside.z;
    for (std::size_t l = first_; l < medium_.layers.size(); ++l) {
        const solver::LayerMedium& layer = medium_.layers[l];
        const FloatLanes extinction = i.look_up(extinction_[l]);
        const FloatLanes here = extinction * static_cast<float>(layer.thickness_um) / i.inside.z;
        const DoubleLanes absorbed = solver::losses(layer, i.inside.z, block_, 1).absorption[0];
        const FloatLanes scattered = max_lanes(extinction - to_float(absorbed), FloatLanes{});
        sum += exp_lanes(-depth) * mean_attenuation(here) * scattered *
               (static_cast<float>(layer.thickness_um) / i.inside.z);
        depth += here;
    }
    return sum + exp_lanes(-depth) * ground_reflectance_;
}

FloatLanes HotSpotBlock::single_gain(const Ray& i, const Ray& o, double phi,
                                     const HotSpot::Pair& both) const {
    constexpr float kDark = 1e-30f;
    const double spread2 = coat_.spread2(i.inside.z, o.inside.z);
    const auto depth_of = [&](std::size_t l) {
        return max_lanes(static_cast<float>(medium_.layers[l].thickness_um) * rate(l, i, o),
                         splat(1e-20f));
    };
    // Of one layer what it scatters cancels.
    if (medium_.layers.size() == first_ + 1) return both.mean(first_, depth_of(first_));
    FloatLanes plain{}, hot{}, depth{};
    for (std::size_t l = first_; l < medium_.layers.size(); ++l) {
        const solver::LayerMedium& layer = medium_.layers[l];
        const FloatLanes here = depth_of(l);
        const FloatLanes once =
            to_float(solver::backscattering(layer, i.inside.z, o.inside.z, phi, block_, spread2)) *
            exp_lanes(-depth) * mean_attenuation(here) * static_cast<float>(layer.thickness_um);
        plain += once;
        hot += once * both.mean(l, here);
        depth += here;
    }
    return plain > kDark ? hot / max_lanes(plain, splat(kDark)) : splat(1.0f);
}

// What flakes have scattered once and what then is lost, over the slopes of each species.
void HotSpotBlock::add_flakes(const Ray& i, Budget& sum) const {
    constexpr double kTail = 3.3;  // in units of alpha; e^-11 of the flakes is steeper
    const Quadrature &radii = unit_gauss_legendre(kRadii),
                     &azimuths = unit_gauss_legendre(kAzimuths);
    const double n = mean_ior_, min_z = std::sqrt(std::max(0.0, 1 - 1 / (n * n)));
    const double min_slope = slope_of_total_reflection(i.inside, -1, 0, min_z);  // away from i
    for (std::size_t l = 0; l < medium_.layers.size(); ++l) {
        for (const solver::FlakeMedium& flake : medium_.layers[l].flakes) {
            // Total reflection cuts lobes off along a line, which at grazing incidence goes through the
            // normal: azimuths to either side have nodes of their own.
            const bool cut = min_slope < kTail * flake.alpha;
            const int panels = cut ? 2 : 1;
            for (int a = 0; a < panels * kAzimuths; ++a) {
                const double phi =
                    std::numbers::pi * (a / kAzimuths + azimuths.nodes[a % kAzimuths]) / panels;
                const double cosine = std::cos(phi), sine = std::sin(phi);
                double end = kTail;
                if (cut) {
                    end = std::min(end, slope_of_total_reflection(i.inside, cosine, sine, min_z) /
                                            flake.alpha);
                }
                for (int r = 0; r < kRadii; ++r) {
                    // The interface lets through what the square root of the distance from total
                    // reflection is.
                    const double x = radii.nodes[r], u = end * (cut ? 1 - x * x : x);
                    const double du = end * (cut ? 2 * x : 1) * radii.weights[r];
                    const double weight =
                        azimuths.weights[a % kAzimuths] / panels * 2 * u * std::exp(-u * u) * du;
                    const double slope = flake.alpha * u;
                    const Vec3f m = normalize(Vec3f{static_cast<float>(slope * cosine),
                                                    static_cast<float>(slope * sine), 1});
                    const float projected = dot(i.inside, m);
                    const auto outside = refract_out(2 * projected * m - i.inside, mean_ior_);
                    if (!outside || outside->z <= 1e-4f) continue;
                    const Ray o = make_ray(*outside, 1 / mean_ior_);
                    const DoubleLanes reflectance =
                        flake.table.reflectance(std::min(1.0f, projected), block_);
                    const auto scale = static_cast<float>(flake.area_density_per_um * weight *
                                                          projected / i.inside.z);
                    add_once(l, i, o, scale * to_float(reflectance), sum);
                }
            }
        }
    }
}

// What pigments and the ground have scattered once, over the directions outside.
void HotSpotBlock::add_others(const Ray& i, std::span<const Exit> exits, Budget& sum) const {
    for (const Exit& exit : exits) {
        const Ray& o = exit.ray;
        const float projection = 1 / (i.inside.z * o.inside.z);
        for (std::size_t l = first_; l < medium_.layers.size(); ++l) {
            FloatLanes kernel{};
            for (const solver::PigmentMedium& pigment : medium_.layers[l].pigments) {
                // Directions point away from the surface, on both ways.
                kernel += to_float(pigment.phase_value(-dot(i.inside, o.inside), block_)) *
                          lanes(pigment.scattering_per_um);
            }
            if (medium_.layers[l].pigments.empty()) continue;
            add_once(l, i, o, kernel * projection * exit.solid_angle, sum);
        }
        const HotSpot::Pair both = pair(i, o);
        const FloatLanes once = both.ground() * exit.ground_lost;
        sum.rescattered -= once;
        sum.hot_spot += once * (both.ground_gain() - 1.0f);
    }
}

// Light that one kind of particles in a layer turns from i to o, per length.
void HotSpotBlock::add_once(std::size_t layer, const Ray& i, const Ray& o, const FloatLanes& per_um,
                            Budget& sum) const {
    FloatLanes depth = cover_depth_ / i.inside.z;
    for (std::size_t l = first_; l < layer; ++l) {
        depth += static_cast<float>(medium_.layers[l].thickness_um) * rate(l, i, o);
    }
    const float thickness_um = static_cast<float>(medium_.layers[layer].thickness_um);
    const FloatLanes here = thickness_um * rate(layer, i, o);
    const FloatLanes once =
        per_um * exp_lanes(-depth) * thickness_um * mean_attenuation(here) * lost(o);
    sum.rescattered -= once;
    sum.hot_spot += once * (pair(i, o).mean(layer, here) - 1.0f);
}

}  // namespace nacre::bsdf
