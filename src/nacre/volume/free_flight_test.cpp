#include "nacre/volume/free_flight.h"

#include <gtest/gtest.h>

#include "nacre/core/quadrature.h"
#include "nacre/volume/shell_walk.h"
#include "nacre/volume/test_support.h"

namespace nacre::volume {
namespace {

using reference::RandomStream;
using reference::Slab;

/// Flakes and a pigment; what a piece of ray meets varies by a factor of 20.
Slab mixed_slab() {
    layers::Layer layer = test::flake_layer(1, 0.05, 0.6, 0.2);
    layer.pigments.push_back({2.0, 1.0, 0.3});
    const std::array wavelengths{550.};
    return reference::Medium(test::paint(1.5, {layer}), wavelengths).slabs[0];
}

/// Down to the tangent point and up again, in 10 um on a radius of 200 um.
const RadialRay kChord{1. / 200, -0.2};
const double kChordLength = kChord.distance_outwards(0);

double exact_depth(const Slab& slab, const RadialRay& ray, double length) {
    const Quadrature rule = gauss_legendre(400, 0, length);
    double depth = 0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i)
        depth += rule.weights[i] * candidate_rate(slab, ray.cosine_at(rule.nodes[i]));
    return depth;
}

TEST(FreeFlight, SimpsonsRuleIsOfFourthOrder) {
    const Slab slab = mixed_slab();
    const double exact = exact_depth(slab, kChord, kChordLength);
    double last = 0;
    for (const int panels : {16, 32, 64}) {
        const double error = std::abs(simpson_depth(slab, kChord, kChordLength, panels) - exact);
        // Sixteen, with room for terms of higher order.
        if (last > 0) {
            EXPECT_GT(last / error, 12) << panels;
        }
        last = error;
    }
    EXPECT_LT(last, 1e-5 * exact);
}

TEST(FreeFlight, SimpsonsRuleIsExactInAFlatLayer) {
    const Slab slab = mixed_slab();
    const RadialRay ray{0, -0.4};
    EXPECT_NEAR(simpson_depth(slab, ray, 25, 1), 25 * candidate_rate(slab, 0.4), 1e-13);
}

TEST(FreeFlight, BothTrackingsFollowTheOpticalDepth) {
    // The optical depth covered has an exponential law: exp(-depth) is uniform. Kolmogorov and
    // Smirnov's statistic of n draws exceeds 1.95 / sqrt(n) once in 1000.
    const Slab slab = mixed_slab();
    const double total = exact_depth(slab, kChord, kChordLength);
    constexpr int kDraws = 20'000, kPanels = 64;
    for (const Tracking tracking : {Tracking::delta, Tracking::simpson}) {
        RandomStream random(7, 8, 9);
        std::vector<double> distances;
        int passed = 0;
        for (int i = 0; i < kDraws; ++i) {
            const auto candidate = tracking == Tracking::delta
                                       ? fly_delta(slab, kChord, kChordLength, random)
                                       : fly_simpson(slab, kChord, kChordLength, kPanels, random);
            if (candidate) {
                distances.push_back(candidate->distance_um);
                EXPECT_LE(candidate->lot,
                          candidate_rate(slab, kChord.cosine_at(candidate->distance_um)));
            } else {
                ++passed;
            }
        }
        const double through = std::exp(-total);
        EXPECT_NEAR(passed, kDraws * through, 4 * std::sqrt(kDraws * through * (1 - through)));
        std::sort(distances.begin(), distances.end());
        double depth = 0, from = 0, worst = 0;
        for (std::size_t i = 0; i < distances.size(); ++i) {
            const double mid = (from + distances[i]) / 2;
            // Between neighbouring draws the rate is as good as linear.
            depth += (distances[i] - from) * candidate_rate(slab, kChord.cosine_at(mid));
            from = distances[i];
            worst = std::max(worst, std::abs(-std::expm1(-depth) - (i + .5) / kDraws));
        }
        EXPECT_LT(worst, 1.95 / std::sqrt(kDraws));
        EXPECT_GT(distances.size(), 1000u);
    }
}

TEST(FreeFlight, NothingIsMetWhereNothingIs) {
    RandomStream random(1, 1, 1);
    const Slab empty;
    EXPECT_FALSE(fly_delta(empty, kChord, 10, random));
    EXPECT_FALSE(fly_simpson(empty, kChord, 10, 4, random));
}

}  // namespace
}  // namespace nacre::volume
