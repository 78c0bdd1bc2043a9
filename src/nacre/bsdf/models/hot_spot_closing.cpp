#include "nacre/bsdf/models/hot_spot_closing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "nacre/bsdf/flake_lobe.h"
#include "nacre/core/error.h"
#include "nacre/core/lane_math.h"
#include "nacre/core/parallel.h"
#include "nacre/core/quadrature.h"
#include "nacre/optics/fresnel.h"
#include "nacre/solver/directions.h"

namespace nacre::bsdf {

std::vector<double> balance(const std::vector<double>& matrix, const std::vector<double>& sum) {
    constexpr int kMaxRounds = 2000;
    constexpr double kTolerance = 1e-6;
    const std::size_t n = sum.size();
    std::vector<double> g(n, 1.0), next(n, 1.0);
    double error = 0;
    for (int round = 0; round < kMaxRounds; ++round) {
        error = 0;
        bool converged = true;
        for (std::size_t a = 0; a < n; ++a) {
            double row = 0;
            for (std::size_t b = 0; b < n; ++b) row += matrix[a * n + b] * g[b];
            row *= g[a];
            if (row <= 0 && sum[a] <= 0) continue;
            // The geometric mean with Sinkhorn's step, which alone would swing to and fro.
            next[a] = g[a] * std::sqrt(sum[a] / row);
            const double here = std::abs(row - sum[a]) / sum[a];
            // Not a number where scales run off to 0 and infinity.
            converged = converged && here <= kTolerance;
            error = std::max(error, here);
        }
        if (converged) return g;
        g.swap(next);
    }
    throw Error(
        fmt::format("the hot spot's share of multiple scattering was not found: after {} "
                    "rounds an albedo is off by {:.2g} of its value",
                    kMaxRounds, error));
}

namespace {

constexpr int kRadii = 24, kAzimuths = 24;

// Of the light that has just entered the coat from one direction, at eight wavelengths.
struct Budget {
    FloatLanes again{};   // is there to be scattered again, by the equation of transfer
    FloatLanes gained{};  // of it, what leaves with the hot spot
};

// The paint at the eight wavelengths of a block.
class Block {
 public:
    Block(const solver::SolvedPaint& paint, const HotSpotTables& tables, int block)
        : medium_(paint.medium),
          block_(block),
          where_(wavelengths_of_block(medium_.wavelength_count(), block)),
          hot_spot_(tables, where_),
          mean_ior_(mean_ior(medium_)),
          ior_(lanes(medium_.ior)),
          clearcoat_depth_(lanes(medium_.clearcoat_depth)),
          ground_reflectance_(lanes(medium_.substrate_reflectance)) {
        const int count = medium_.wavelength_count();
        for (const std::vector<float>& from : tables.extinction()) {
            auto& to = extinction_.emplace_back();
            for (int row = 0; row <= kDirectionIntervals; ++row) {
                to.push_back(at_wavelengths(where_, [&](int w) { return from[row * count + w]; }));
            }
        }
    }

    HotSpot::Pair pair(const Ray& i, const Ray& o) const { return {hot_spot_, i, o}; }
    Ray ray(double theta, double phi = 0) const {
        const double sine = std::sin(theta);
        return make_ray(
            {static_cast<float>(sine * std::cos(phi)), static_cast<float>(sine * std::sin(phi)),
             static_cast<float>(std::cos(theta))},
            1 / mean_ior_);
    }
    FloatLanes transmittance(const Ray& ray) const {
        return 1.0f - optics::dielectric_reflectance(splat(1.0f), ior_, splat(ray.outside.z));
    }
    FloatLanes inverse_ior2() const { return 1.0f / (ior_ * ior_); }

    Budget budget(const Ray& i, const Quadrature& polar) const {
        Budget sum;
        add_first_scattering(i, sum);
        add_flakes(i, sum);
        add_others(i, polar, sum);
        return sum;
    }

 private:
    FloatLanes lanes(const std::vector<double>& values) const {
        return at_wavelengths(where_, [&](int w) { return values[w]; });
    }

    // 1/um along the way in and out together.
    FloatLanes rate(std::size_t layer, const Ray& i, const Ray& o) const {
        return i.look_up(extinction_[layer]) / i.inside.z +
               o.look_up(extinction_[layer]) / o.inside.z;
    }
    // Of light on its way from the flakes to the interface, what is not there to be scattered
    // again: all but what the interface sends back.
    FloatLanes lost(const Ray& o) const {
        const FloatLanes clear = exp_lanes(-2.0f * clearcoat_depth_ / o.inside.z);
        return 1.0f - clear * (1.0f - transmittance(o));
    }

    // All that is scattered once.
    void add_first_scattering(const Ray& i, Budget& sum) const {
        FloatLanes depth = clearcoat_depth_ / i.inside.z;
        for (std::size_t l = 0; l < medium_.layers.size(); ++l) {
            const solver::LayerMedium& layer = medium_.layers[l];
            const FloatLanes extinction = i.look_up(extinction_[l]);
            const FloatLanes here = max_lanes(
                extinction * static_cast<float>(layer.thickness_um) / i.inside.z, splat(1e-20f));
            const DoubleLanes absorbed = solver::losses(layer, i.inside.z, block_, 1).absorption[0];
            const FloatLanes scattered =
                max_lanes(extinction - __builtin_convertvector(absorbed, FloatLanes), FloatLanes{});
            sum.again += exp_lanes(-depth) * one_minus_exp_lanes(here) / here * scattered *
                         (static_cast<float>(layer.thickness_um) / i.inside.z);
            depth += here;
        }
        sum.again += exp_lanes(-depth) * ground_reflectance_;
    }

    // What flakes have scattered once and what then is lost, over the slopes of each species.
    void add_flakes(const Ray& i, Budget& sum) const {
        const Quadrature &radii = unit_gauss_legendre(kRadii),
                         &azimuths = unit_gauss_legendre(kAzimuths);
        for (std::size_t l = 0; l < medium_.layers.size(); ++l) {
            for (const solver::FlakeMedium& flake : medium_.layers[l].flakes) {
                constexpr double kTail = 4.5;  // in units of alpha; e^-20 of the flakes is steeper
                for (int r = 0; r < kRadii; ++r) {
                    const double u = kTail * radii.nodes[r], slope = flake.alpha * u;
                    const double weight = kTail * radii.weights[r] * 2 * u * std::exp(-u * u);
                    for (int a = 0; a < kAzimuths; ++a) {
                        const double phi = std::numbers::pi * azimuths.nodes[a];
                        const Vec3f m =
                            normalize(Vec3f{static_cast<float>(slope * std::cos(phi)),
                                            static_cast<float>(slope * std::sin(phi)), 1});
                        const float projected = dot(i.inside, m);
                        if (projected <= 0) continue;
                        const Vec3f inside = 2 * projected * m - i.inside;
                        if (inside.z <= 0) continue;
                        const auto outside = refract_out(inside, mean_ior_);
                        if (!outside || outside->z <= 1e-4f) continue;
                        const Ray o = make_ray(*outside, 1 / mean_ior_);
                        const DoubleLanes reflectance =
                            flake.table.reflectance(std::min(1.0f, projected), block_);
                        const auto scale =
                            static_cast<float>(flake.area_density_per_um * weight *
                                               azimuths.weights[a] * projected / i.inside.z);
                        add_once(l, i, o, scale * __builtin_convertvector(reflectance, FloatLanes),
                                 sum);
                    }
                }
            }
        }
    }

    // What pigments and the ground have scattered once, over the directions outside.
    void add_others(const Ray& i, const Quadrature& polar, Budget& sum) const {
        bool any = lane_max(ground_reflectance_) > 0;
        for (const auto& layer : medium_.layers) any = any || !layer.pigments.empty();
        if (!any) return;
        const Quadrature& azimuths = unit_gauss_legendre(kAzimuths);
        for (std::size_t n = 0; n < polar.nodes.size(); ++n) {
            for (int a = 0; a < kAzimuths; ++a) {
                const Ray o = ray(polar.nodes[n], std::numbers::pi * azimuths.nodes[a]);
                const FloatLanes solid_angle =
                    inverse_ior2() *
                    static_cast<float>(polar.weights[n] * std::sin(polar.nodes[n]) *
                                       std::cos(polar.nodes[n]) * 2 * std::numbers::pi *
                                       azimuths.weights[a]);
                const float projection = 1 / (i.inside.z * o.inside.z);
                for (std::size_t l = 0; l < medium_.layers.size(); ++l) {
                    FloatLanes kernel{};
                    for (const solver::PigmentMedium& pigment : medium_.layers[l].pigments) {
                        // Directions point away from the surface, on both ways.
                        const DoubleLanes phase =
                            pigment.phase_value(-dot(i.inside, o.inside), block_);
                        kernel += __builtin_convertvector(phase, FloatLanes) *
                                  at_wavelengths(
                                      where_, [&](int w) { return pigment.scattering_per_um[w]; });
                    }
                    if (medium_.layers[l].pigments.empty()) continue;
                    add_once(l, i, o, kernel * projection * solid_angle, sum);
                }
                const HotSpot::Pair both = pair(i, o);
                // The clearcoat on the way out is in lost().
                const FloatLanes once = both.ground() * exp_lanes(clearcoat_depth_ / o.inside.z) *
                                        solid_angle * lost(o);
                sum.again -= once;
                sum.gained += once * (both.ground_gain() - 1.0f);
            }
        }
    }

    // Light that one kind of particles in a layer turns from i to o, per length.
    void add_once(std::size_t layer, const Ray& i, const Ray& o, const FloatLanes& per_um,
                  Budget& sum) const {
        FloatLanes depth = clearcoat_depth_ / i.inside.z;
        for (std::size_t l = 0; l < layer; ++l) {
            depth += static_cast<float>(medium_.layers[l].thickness_um) * rate(l, i, o);
        }
        const float thickness_um = static_cast<float>(medium_.layers[layer].thickness_um);
        const FloatLanes here = thickness_um * rate(layer, i, o);
        const FloatLanes safe = max_lanes(here, splat(1e-20f));
        const FloatLanes once =
            per_um * exp_lanes(-depth) * thickness_um * one_minus_exp_lanes(safe) / safe * lost(o);
        sum.again -= once;
        sum.gained += once * (pair(i, o).mean(layer, here) - 1.0f);
    }

    const solver::PaintMedium& medium_;
    int block_;
    std::array<WavelengthPosition, kLanes> where_;
    HotSpot hot_spot_;
    float mean_ior_;
    FloatLanes ior_, clearcoat_depth_, ground_reflectance_;
    std::vector<std::vector<FloatLanes>> extinction_;  // by layer and direction
};

}  // namespace

std::vector<float> closing_factors(const solver::SolvedPaint& paint, const HotSpotTables& tables) {
    const solver::MultipleScattering& multiple = paint.multiple_scattering;
    const int count = paint.medium.wavelength_count(), rank = multiple.rank();
    const int n = static_cast<int>(multiple.exit_angle.size());
    std::vector<float> factors(static_cast<std::size_t>(kDirectionIntervals + 1) * count, 1.0f);
    if (rank == 0 || n == 0) return factors;                              // black
    const Quadrature polar = gauss_legendre(n, 0, std::numbers::pi / 2);  // the exit nodes

    // Order 0 between the exit nodes, [a][b][k].
    std::vector<double> order_0(static_cast<std::size_t>(n) * n * rank);
    parallel_for(0, n, [&](std::size_t a) {
        const solver::MultipleScatteringSlice slice(multiple, polar.nodes[a]);
        std::vector<double> orders(static_cast<std::size_t>(rank) * multiple.orders());
        for (int b = 0; b < n; ++b) {
            slice.by_order(polar.nodes[b], orders);
            for (int k = 0; k < rank; ++k) {
                order_0[(a * n + b) * rank + k] = orders[k * multiple.orders()];
            }
        }
    });
    const solver::ExitInterpolation interpolation(multiple.exit_angle);
    for (int block = 0; block < paint::block_count(count); ++block) {
        const Block paint_block(paint, tables, block);
        std::vector<Ray> rays;
        for (const double theta : polar.nodes) rays.push_back(paint_block.ray(theta));
        std::vector<FloatLanes> kept(n);  // 1 - dQ / Q
        parallel_for(0, n, [&](std::size_t a) {
            const Budget budget = paint_block.budget(rays[a], polar);
            const FloatLanes again = max_lanes(budget.again, splat(1e-20f));
            kept[a] = max_lanes(1.0f - budget.gained / again, FloatLanes{});
        });
        for (int lane = 0; lane < std::min(kLanes, count - block * kLanes); ++lane) {
            const int w = block * kLanes + lane;
            std::vector<double> matrix(static_cast<std::size_t>(n) * n), sum(n);
            for (int a = 0; a < n; ++a) {
                for (int b = 0; b < n; ++b) {
                    double f = -paint_block.pair(rays[a], rays[b]).ground()[lane];
                    for (int k = 0; k < rank; ++k) {
                        f += order_0[(static_cast<std::size_t>(a) * n + b) * rank + k] *
                             multiple.basis[k * count + w];
                    }
                    const double in_out = paint_block.transmittance(rays[a])[lane] *
                                          paint_block.transmittance(rays[b])[lane] *
                                          paint_block.inverse_ior2()[lane];
                    const double flux = 2 * std::numbers::pi * polar.weights[b] *
                                        std::sin(polar.nodes[b]) * std::cos(polar.nodes[b]);
                    matrix[a * n + b] = std::max(0.0, f) * in_out * flux;
                    sum[a] += matrix[a * n + b];
                }
                sum[a] *= kept[a][lane];
            }
            const std::vector<double> g = balance(matrix, sum);
            std::vector<double> weight(n);
            for (int row = 0; row <= kDirectionIntervals; ++row) {
                interpolation.weights_at(direction_angle(row), weight.data());
                const double at = std::inner_product(g.begin(), g.end(), weight.begin(), 0.0);
                factors[static_cast<std::size_t>(row) * count + w] =
                    static_cast<float>(std::max(0.0, at));
            }
        }
    }
    return factors;
}

}  // namespace nacre::bsdf
