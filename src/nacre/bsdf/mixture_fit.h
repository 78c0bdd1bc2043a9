#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace nacre::bsdf {

/// A direction of a quadrature: how much light goes there, and the density there of each lobe of a
/// mixture.
template <std::size_t K>
struct FluxPoint {
    double flux;
    std::array<float, K> density;
};

/// Odds of lobes that sample what points hold, by expectation maximisation: each round shares the
/// flux at every point among the lobes by their densities there, and takes the sums for the new
/// odds. It climbs to the mixture of least relative entropy.      [dempster-laird-rubin-1977]
/// @param share  where to start, positive where a lobe may be used; comes back where nothing flows
template <std::size_t K>
std::array<double, K> fit_mixture(const std::vector<FluxPoint<K>>& points,
                                  std::array<double, K> share, int rounds = 30) {
    for (int round = 0; round < rounds; ++round) {
        std::array<double, K> next{};
        for (const FluxPoint<K>& point : points) {
            double mixture = 0;
            for (std::size_t k = 0; k < K; ++k) mixture += share[k] * point.density[k];
            if (!(mixture > 0)) continue;
            for (std::size_t k = 0; k < K; ++k) {
                next[k] += point.flux * share[k] * point.density[k] / mixture;
            }
        }
        double all = 0;
        for (double x : next) all += x;
        if (!(all > 0)) break;
        for (std::size_t k = 0; k < K; ++k) share[k] = next[k] / all;
    }
    return share;
}

}  // namespace nacre::bsdf
