#include "nacre/layers/paint_block.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/optics/dielectric.h"

namespace nacre::layers {

namespace {

LaneBuffer balanced_extinction(const LayerMedium& layer, const FourierKernel& kernel,
                               const Directions& d, int block, double& unresolved) {
    const int n = d.size();
    LaneBuffer scattering(n, DoubleLanes{}), total(n);
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j <= i; ++j) {
            const std::size_t at = triangle(i) + j;
            // Widened before they are added, as in set_operators: a sum rounded to single precision
            // would be flux lost or gained, 1e-8 of it per unit of optical depth.
            const DoubleLanes both = 2 * std::numbers::pi *
                                     (__builtin_convertvector(kernel.same(0)[at], DoubleLanes) +
                                      __builtin_convertvector(kernel.opposite(0)[at], DoubleLanes));
            scattering[i] += d.weight[j] * both;
            if (j != i) scattering[j] += d.weight[i] * both;
        }
    }
    for (int i = 0; i < n; ++i) {
        const DoubleLanes lost = absorption(layer, d.mu[i], block);
        total[i] = lost + scattering[i];
        if (i < d.exit_count) {
            const DoubleLanes exact = extinction(layer, d.mu[i], block);
            for (int lane = 0; lane < kLanes; ++lane) {
                const double miss = std::abs(total[i][lane] - exact[lane]);
                unresolved = std::max(unresolved, miss / std::max(exact[lane], 1e-300));
            }
        }
    }
    return total;
}

}  // namespace

PaintBlock make_block(const PaintMedium& medium, const Directions& d, const ActiveNodes& active,
                      int lit, int block) {
    const int n = d.size();
    PaintBlock out;
    out.substrate = block_lanes(medium.substrate_reflectance, block);
    const DoubleLanes clearcoat = block_lanes(medium.clearcoat_depth, block);
    out.coat_absorbs = lane_max(clearcoat) > 0;
    for (int i = 0; i < n; ++i) {
        out.coat.push_back(make_lanes<DoubleLanes>(
            [&](int lane) { return std::exp(-clearcoat[lane] / d.mu[i]); }));
        out.mirror.push_back(splat(optics::dielectric_reflectance(d.ior, 1.0, d.mu[i])));
    }
    LaneBuffer depth(lit, DoubleLanes{});  // above the layer, one way
    for (const LayerMedium& layer : medium.layers) {
        FourierKernel kernel(layer, d, active, block);
        LaneBuffer total = balanced_extinction(layer, kernel, d, block, out.unresolved);
        DoubleLanes deepest{};
        for (int i = 0; i < n; ++i) {
            deepest = max_lanes(deepest, layer.thickness_um * total[i] * (1 / d.mu[i]));
        }
        LaneBuffer factor(triangle(lit));
        for (int i = 0; i < lit; ++i) {
            for (int j = 0; j <= i; ++j) {
                const DoubleLanes rate = total[i] / d.mu[i] + total[j] / d.mu[j];
                factor[triangle(i) + j] =
                    make_lanes<DoubleLanes>([&](int lane) {
                        const double x = layer.thickness_um * rate[lane];
                        return std::exp(-depth[i][lane] - depth[j][lane]) *
                               (x > 1e-12 ? -std::expm1(-x) / rate[lane] : layer.thickness_um);
                    }) *
                    out.coat[i] * out.coat[j];
            }
        }
        for (int i = 0; i < lit; ++i) depth[i] += layer.thickness_um * total[i] / d.mu[i];
        out.layers.push_back({layer.thickness_um, std::move(kernel), std::move(total),
                              std::move(factor), doublings_for(lane_max(deepest))});
    }
    return out;
}

}  // namespace nacre::layers
