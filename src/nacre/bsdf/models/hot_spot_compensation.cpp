#include "nacre/bsdf/models/hot_spot_compensation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>

#include "nacre/bsdf/models/hot_spot_block.h"
#include "nacre/core/error.h"
#include "nacre/core/parallel.h"
#include "nacre/core/quadrature.h"
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
            if (row <= 0 && sum[a] <= 0) {
                next[a] = g[a];
                continue;
            }
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

solver::MultipleScattering order_0_of(const solver::MultipleScattering& all) {
    solver::MultipleScattering out;
    out.exit_angle = all.exit_angle;
    out.wavelength_count = all.wavelength_count;
    out.first = {all.first[0]};
    out.basis = all.basis;
    out.lobe_width = all.lobe_width;
    out.table_rank = all.table_rank;
    const std::size_t pairs = all.pair_count();
    for (int k = 0; k < all.rank(); ++k) {
        const auto begin = all.coefficient.begin() + static_cast<std::ptrdiff_t>(k * pairs);
        out.coefficient.insert(out.coefficient.end(), begin,
                               begin + static_cast<std::ptrdiff_t>(out.pair_count()));
    }
    return out;
}

}  // namespace

std::vector<float> compensation_factors(const solver::SolvedPaint& paint,
                                        const HotSpotTables& tables) {
    const solver::MultipleScattering& multiple = paint.multiple_scattering;
    const int count = paint.medium.wavelength_count(), rank = multiple.rank();
    const int n = static_cast<int>(multiple.exit_angle.size());
    std::vector<float> factors(static_cast<std::size_t>(kDirectionIntervals + 1) * count, 1.0f);
    if (rank == 0 || n == 0 || multiple.orders() == 0) return factors;    // black
    const Quadrature polar = gauss_legendre(n, 0, std::numbers::pi / 2);  // the exit nodes

    // Order 0 between the exit nodes, [a][b][k].
    const solver::MultipleScattering zeroth = order_0_of(multiple);
    std::vector<double> order_0(static_cast<std::size_t>(n) * n * rank);
    parallel_for(0, n, [&](std::size_t a) {
        solver::MultipleScatteringSlice(zeroth, polar.nodes[a])
            .by_order(polar.nodes, std::span(order_0).subspan(a * n * rank, n * rank));
    });
    const solver::ExitInterpolation interpolation(multiple.exit_angle);
    const auto pair = [n](int a, int b) { return static_cast<std::size_t>(a) * n + b; };
    parallel_for(0, paint::block_count(count), [&](int block) {
        const HotSpotBlock paint_block(paint, tables, block);
        std::vector<Ray> rays;
        for (const double theta : polar.nodes) rays.push_back(paint_block.ray(theta));
        const std::vector<HotSpotBlock::Exit> exits = paint_block.exits(polar);
        std::vector<FloatLanes> kept(n), entering(n), ground(pair(n, 0));  // kept: 1 - dPhi / Phi
        parallel_for(0, n, [&](std::size_t a) {
            const HotSpotBlock::Budget budget = paint_block.budget(rays[a], exits);
            const FloatLanes rescattered = max_lanes(budget.rescattered, splat(1e-20f));
            kept[a] = max_lanes(1.0f - budget.hot_spot / rescattered, FloatLanes{});
            entering[a] = paint_block.transmittance(rays[a]);
            for (int b = 0; b < n; ++b) {
                ground[pair(a, b)] = paint_block.pair(rays[a], rays[b]).ground();
            }
        });
        for (int lane = 0; lane < std::min(kLanes, count - block * kLanes); ++lane) {
            const int w = block * kLanes + lane;
            std::vector<double> matrix(pair(n, 0)), sum(n);
            for (int a = 0; a < n; ++a) {
                for (int b = 0; b < n; ++b) {
                    double f = -ground[pair(a, b)][lane];
                    for (int k = 0; k < rank; ++k) {
                        f += order_0[pair(a, b) * rank + k] * multiple.basis[k * count + w];
                    }
                    const double in_out =
                        entering[a][lane] * entering[b][lane] * paint_block.inverse_ior2()[lane];
                    const double flux = 2 * std::numbers::pi * polar.weights[b] *
                                        std::sin(polar.nodes[b]) * std::cos(polar.nodes[b]);
                    matrix[pair(a, b)] = std::max(0.0, f) * in_out * flux;
                    sum[a] += matrix[pair(a, b)];
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
    });
    return factors;
}

std::vector<float> internal_reflection_gains(const solver::SolvedPaint& paint,
                                             const HotSpotTables& tables) {
    const int count = paint.medium.wavelength_count();
    std::vector<float> gains(static_cast<std::size_t>(kDirectionIntervals + 1) * count);
    parallel_for(0, paint::block_count(count), [&](int block) {
        const HotSpotBlock paint_block(paint, tables, block);
        const Ray grazing = paint_block.ray(direction_angle(kDirectionIntervals), std::numbers::pi);
        for (int row = 0; row <= kDirectionIntervals; ++row) {
            const Ray ray = paint_block.ray(direction_angle(row));
            const FloatLanes gain = paint_block.single_gain(ray, grazing, std::numbers::pi,
                                                            paint_block.pair(ray, grazing));
            for (int lane = 0; lane < std::min(kLanes, count - block * kLanes); ++lane) {
                gains[static_cast<std::size_t>(row) * count + block * kLanes + lane] =
                    std::sqrt(gain[lane]);
            }
        }
    });
    return gains;
}

}  // namespace nacre::bsdf
