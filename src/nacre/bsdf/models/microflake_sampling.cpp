#include <algorithm>
#include <cmath>

#include "nacre/bsdf/models/bound_microflake.h"
#include "nacre/core/lane_math.h"
#include "nacre/core/parallel.h"
#include "nacre/core/random.h"
#include "nacre/optics/fresnel.h"
#include "nacre/paint/beckmann.h"
#include "nacre/solver/rough_interface.h"

// How the micro-flake model is sampled: what depends on the paint alone.

namespace nacre::bsdf {
namespace {

using Bind = std::function<std::unique_ptr<const BoundMicroflake>(const Wavelengths&)>;

// Of the narrowest lobes that carry much light: the mean of the flakes, by area, and what a rough
// interface adds.
float typical_alpha(const solver::PaintMedium& medium, bool rough) {
    double weight = 0, sum = 0;
    for (const auto& layer : medium.layers) {
        for (const auto& flake : layer.flakes) {
            const double area = flake.area_density_per_um * layer.thickness_um;
            weight += area;
            sum += area * flake.alpha;
        }
    }
    constexpr double kWithoutFlakes = 0.3;
    const double alpha = weight > 0 ? sum / weight : kWithoutFlakes;
    // A facet of slope m turns refracted light by about half as much as a flake of that slope turns
    // reflected light.
    return static_cast<float>(rough ? std::hypot(alpha, 0.5 * medium.roughness) : alpha);
}

// Fraction of the incident flux that leaves the paint after one reflection at a flake, roughly: as
// if the outgoing cosine were the incident one. theta outside the coat, rad.
double single_scattering_fraction(const solver::PaintMedium& medium, double ior, double theta) {
    const int block = paint::block_count(medium.wavelength_count()) / 2;
    const double mu = solver::inside_cosine(ior, theta);
    const double t = 1 - optics::dielectric_reflectance(1.0, ior, std::cos(theta));
    double fraction = 0, depth = 0;
    for (const auto& layer : medium.layers) {
        const DoubleLanes rate = 2.0 * solver::extinction(layer, mu, block) / mu;
        const double here = layer.thickness_um * lane_mean(rate);
        double scattering = 0;
        for (const auto& flake : layer.flakes) {
            paint::for_each_normal(
                mu, flake.alpha, paint::kNormalNodes, [&](double cosine, double weight) {
                    scattering += flake.area_density_per_um * weight *
                                  lane_mean(flake.table.reflectance(cosine, block));
                });
        }
        fraction += t * t * scattering / mu * std::exp(-depth) * layer.thickness_um *
                    mean_attenuation(here);
        depth += here;
    }
    return fraction;
}

// A thirtieth of what the interface does not take, so that no direction is missed and weights are
// bounded where the table is coarse.
constexpr float kDiffuse = 1 / 30.0f;

void tabulate_warp(Microflake::Tables& tables, const Bind& bind) {
    const std::vector<double>& grid = tables.paint->wavelengths_nm();
    Wavelengths wavelengths;
    for (int i = 0; i < kLanes; ++i) {
        // Over what is seen; a paint that is solved elsewhere is taken at its ends.
        constexpr double kFirst_nm = 400, kLast_nm = 700;
        wavelengths[i] = std::clamp(kFirst_nm + (i + 0.5) / kLanes * (kLast_nm - kFirst_nm),
                                    grid.front(), grid.back());
    }
    const FloatLanes response = response_of_eye(wavelengths);
    const auto bound = bind(wavelengths);
    const InterfaceLobe* const interface = bound->interface_lobe();
    const auto flux = [&](Vec3f wi, Vec3f wo) {
        const FloatLanes lobe = interface ? interface->eval(wi, wo) : FloatLanes{};
        return wo.z * lane_sum(response * (bound->eval(wi, wo) - lobe));
    };
    const auto warp = std::make_shared<ReflectionWarp>(
        tables.mean_ior, typical_alpha(tables.paint->medium, tables.rough), flux);
    tables.warp = warp;

    tables.probability.resize(kDirectionIntervals + 1);
    for (int row = 0; row <= kDirectionIntervals; ++row) {
        const double theta = direction_angle(row), ior = tables.mean_ior;
        const double interface =
            tables.rough
                ? solver::rough_interface(ior, tables.paint->medium.roughness)->albedo(theta)
                : optics::dielectric_reflectance(1.0, ior, std::cos(theta));
        const double rest = warp->albedo(static_cast<float>(std::tan(theta / 2))) + 1e-6;
        const double single = single_scattering_fraction(tables.paint->medium, ior, theta);
        // Light that lies where the table does not expect it should not weigh too much.
        constexpr double kMax = 0.98;
        SamplingProbabilities& p = tables.probability[row];
        p.interface = static_cast<float>(std::min(kMax, interface / (interface + rest)));
        p.diffuse = (1 - p.interface) * kDiffuse;
        p.table = 1 - p.interface - p.diffuse;
        p.single = static_cast<float>(std::min(0.95, single / rest));
    }
}

// Directional-hemispherical reflectance by the model's own sampling at 512 low-discrepancy points:
// deterministic, and within 5e-3 (microflake_test.cpp).
void tabulate_albedo(Microflake::Tables& tables, const Bind& bind) {
    constexpr int kStride = 8, kPoints = 512;
    const int count = tables.wavelength_count();
    tables.albedo.assign(static_cast<std::size_t>(kDirectionIntervals + 1) * count, 0.0f);
    const std::vector<double>& grid = tables.paint->wavelengths_nm();
    for (int block = 0; block < paint::block_count(count); ++block) {
        Wavelengths wavelengths;
        for (int i = 0; i < kLanes; ++i) {
            wavelengths[i] = grid[std::min(block * kLanes + i, count - 1)];
        }
        const auto bound = bind(wavelengths);
        const int lanes = std::min(kLanes, count - block * kLanes);
        parallel_for(0, kDirectionIntervals / kStride + 1, [&](std::size_t step) {
            const int row = static_cast<int>(step) * kStride;
            const double theta = direction_angle(row);
            const Vec3f wi = {static_cast<float>(std::sin(theta)), 0,
                              static_cast<float>(std::cos(theta))};
            FloatLanes sum{};
            for (unsigned p = 0; p < kPoints; ++p) {
                unsigned bits = p * 0x9E3779B9u;  // Weyl sequence for the third coordinate
                const auto radical = static_cast<float>(radical_inverse(p, 2));
                const float u_select = static_cast<float>(bits >> 8) * 0x1p-24f;
                if (const auto s = bound->sample(wi, u_select, {(p + 0.5f) / kPoints, radical})) {
                    sum += s->weight;
                }
            }
            for (int lane = 0; lane < lanes; ++lane) {
                tables.albedo[static_cast<std::size_t>(row) * count + block * kLanes + lane] =
                    std::min(1.0f, sum[lane] / kPoints);
            }
        });
    }
    for (int row = 0; row < kDirectionIntervals; ++row) {
        const int from = row / kStride * kStride;
        const float f = static_cast<float>(row - from) / kStride;
        for (int w = 0; w < count; ++w) {
            const float a = tables.albedo[from * count + w];
            tables.albedo[row * count + w] =
                a + f * (tables.albedo[(from + kStride) * count + w] - a);
        }
    }
}

}  // namespace

void tabulate_sampling(Microflake::Tables& tables, const Bind& bind) {
    tabulate_warp(tables, bind);
    tabulate_albedo(tables, bind);
}

}  // namespace nacre::bsdf
