#include "nacre/bsdf/microflake_tables.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/core/parallel.h"
#include "nacre/core/quadrature.h"
#include "nacre/flakes/beckmann.h"
#include "nacre/layers/rough_interface.h"
#include "nacre/optics/dielectric.h"

namespace nacre::bsdf {

namespace {

// Roughness that the grid of the smooth table must resolve.
double narrowest_alpha(const layers::PaintMedium& medium) {
    double alpha = 1.0;
    for (const auto& layer : medium.layers) {
        for (const auto& flake : layer.flakes) alpha = std::min(alpha, flake.alpha);
    }
    // Under a rough interface the table holds single scattering too, narrower by the square root
    // of three, and weighs all of the peak.
    return medium.roughness > 0 ? alpha / 3 : alpha;
}

bool has_rough_interface(const layers::SolvedPaint& paint) {
    int rough = 0;
    for (int w = 0; w < paint.medium.wavelength_count(); ++w) rough += paint.is_rough(w);
    if (rough != 0 && rough != paint.medium.wavelength_count()) {
        throw Error(
            "a rough clearcoat whose binder has the index 1 at some wavelengths only "
            "cannot be rendered");
    }
    return rough != 0;
}

double mean(const std::vector<double>& v) {
    double sum = 0;
    for (double x : v) sum += x;
    return sum / static_cast<double>(v.size());
}

// Share of the incident flux that the flakes of the paint return after one reflection, roughly:
// as if the outgoing cosine were the incident one.
double single_scattering_share(const layers::PaintMedium& medium, double theta) {
    const double ior = mean(medium.ior);
    const double mu = layers::inside_cosine(ior, theta);
    const double t = 1 - optics::dielectric_reflectance(1.0, ior, std::cos(theta));
    double share = 0, depth = 0;
    for (const auto& layer : medium.layers) {
        const DoubleLanes rate = 2.0 * layers::extinction(layer, mu, 0) / mu;
        const double here = layer.thickness_um * lane_mean(rate);
        double scattering = 0;
        for (const auto& flake : layer.flakes) {
            flakes::for_each_normal(mu, flake.alpha, [&](double cosine, double weight) {
                scattering += flake.area_density_per_um * weight *
                              lane_mean(flake.table.reflectance(cosine, 0));
            });
        }
        share += t * t * scattering / mu * std::exp(-depth) * layer.thickness_um *
                 (here > 1e-9 ? -std::expm1(-here) / here : 1.0);
        depth += here;
    }
    return share;
}

}  // namespace

double direction_angle(int row) {
    const double x = static_cast<double>(row) / kDirectionIntervals;
    return std::min(2 * std::atan(x), std::numbers::pi / 2 - 1e-4);
}

Microflake::Tables::Tables(std::shared_ptr<const layers::SolvedPaint> solved)
    : paint(std::move(solved)),
      mean_ior(static_cast<float>(mean(paint->medium.ior))),
      rough(has_rough_interface(*paint)),
      smooth(tensors(), narrowest_alpha(paint->medium), mean_ior) {
    tabulate_extinction();
    choose_lobes();
}

std::vector<const layers::Remainder*> Microflake::Tables::tensors() const {
    if (rough) return {&paint->remainder, &paint->rough_single};
    return {&paint->remainder};
}

void Microflake::Tables::tabulate_extinction() {
    const auto& medium = paint->medium;
    const int count = wavelength_count();
    for (const auto& layer : medium.layers) {
        auto& table = extinction.emplace_back((kDirectionIntervals + 1) * count);
        parallel_for(0, kDirectionIntervals + 1, [&](std::size_t row) {
            const double theta = direction_angle(static_cast<int>(row));
            for (int block = 0; block < flakes::block_count(count); ++block) {
                const int end = std::min(kLanes, count - block * kLanes);
                DoubleLanes value{};
                for (int lane = 0; lane < end; ++lane) {
                    const int w = block * kLanes + lane;
                    if (lane == 0 || medium.ior[w] != medium.ior[w - 1]) {
                        value = layers::extinction(
                            layer, layers::inside_cosine(medium.ior[w], theta), block);
                    }
                    table[row * count + w] = static_cast<float>(value[lane]);
                }
            }
        });
    }
}

void Microflake::Tables::choose_lobes() {
    const auto& medium = paint->medium;
    double weight = 0, sum = 0;
    for (const auto& layer : medium.layers) {
        for (const auto& flake : layer.flakes) {
            const double w = flake.area_density_per_um * layer.thickness_um;
            weight += w;
            sum += w * flake.alpha;
        }
    }
    const bool has_flakes = weight > 0;
    if (has_flakes) flake_alpha = static_cast<float>(sum / weight);
    // Facets of slope m refract as half a flake of that slope reflects, roughly.
    if (rough) flake_alpha = static_cast<float>(std::hypot(flake_alpha, 0.5 * medium.roughness));
    // Three reflections off Gaussian slopes spread like sqrt(3); five and more, wider still.
    wide_alpha = 2 * flake_alpha;

    const double ior = mean_ior;
    const Quadrature polar = gauss_legendre(12, 0.0, std::numbers::pi / 2);
    constexpr int kAzimuths = 12;
    odds.resize(kDirectionIntervals + 1);
    constexpr int kStride = 8;  // the smooth part changes slowly with direction
    parallel_for(0, kDirectionIntervals / kStride + 1, [&](std::size_t step) {
        const int row = static_cast<int>(step) * kStride;
        const double theta_i = direction_angle(row);
        const double mirror = rough
                                  ? layers::rough_interface(ior, medium.roughness)->albedo(theta_i)
                                  : optics::dielectric_reflectance(1.0, ior, std::cos(theta_i));
        // Energy of the remainder, and what it would be if its dark side were all there is.
        const layers::RemainderSlice slice(paint->remainder, theta_i);
        std::vector<double> coefficient(paint->remainder.rank());
        double energy = 0, dark = 0;
        for (std::size_t t = 0; t < polar.nodes.size(); ++t) {
            const double theta_o = polar.nodes[t];
            const double fresnel =
                (1 - mirror) * (1 - optics::dielectric_reflectance(1.0, ior, std::cos(theta_o))) /
                (ior * ior);
            for (int p = 0; p < kAzimuths; ++p) {
                const double phi = std::numbers::pi * (p + 0.5) / kAzimuths;
                slice.coefficients(theta_o, phi, coefficient);
                double f = 0;
                for (int k = 0; k < paint->remainder.rank(); ++k) {
                    for (int w = 0; w < wavelength_count(); ++w) {
                        f += coefficient[k] * paint->remainder.basis[k * wavelength_count() + w];
                    }
                }
                const double flux = std::max(0.0, f / wavelength_count()) * fresnel *
                                    polar.weights[t] * std::sin(theta_o) * std::cos(theta_o) * 2 *
                                    std::numbers::pi / kAzimuths;
                energy += flux;
                if (phi < std::numbers::pi / 2) dark += 2 * flux;
            }
        }
        const double single = has_flakes ? single_scattering_share(medium, theta_i) : 0.0;
        const double total = mirror + single + energy + 1e-6;
        // A tenth of the multiple scattering at least, and a hundredth of all, goes everywhere:
        // that bounds the weights.
        double diffuse = std::max(std::min(dark, energy), 0.1 * energy) / total + 0.01;
        double wide = has_flakes ? std::max(energy / total + 0.01 - diffuse, 0.01) : 0.0;
        double flake = single / total + (has_flakes ? 0.01 : 0.0);
        const double sum_all = mirror / total + flake + wide + diffuse;
        odds[row] = {static_cast<float>(mirror / total / sum_all),
                     static_cast<float>(flake / sum_all), static_cast<float>(wide / sum_all),
                     static_cast<float>(diffuse / sum_all)};
    });
    for (int row = 0; row < kDirectionIntervals; ++row) {
        const int from = row / kStride * kStride;
        const float f = static_cast<float>(row - from) / kStride;
        const LobeOdds &a = odds[from], &b = odds[from + kStride];
        if (row == from) continue;
        const auto mix = [&](float LobeOdds::*m) { return a.*m + f * (b.*m - a.*m); };
        odds[row] = {mix(&LobeOdds::interface), mix(&LobeOdds::flakes), mix(&LobeOdds::wide),
                     mix(&LobeOdds::diffuse)};
    }
}

}  // namespace nacre::bsdf
