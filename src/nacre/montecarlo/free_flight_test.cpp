#include "nacre/montecarlo/free_flight.h"

#include <gtest/gtest.h>

#include "nacre/core/quadrature.h"
#include "nacre/montecarlo/shell_walk.h"
#include "nacre/paint/beckmann.h"
#include "nacre/testing/montecarlo.h"
#include "nacre/testing/statistics.h"

namespace nacre::montecarlo {
namespace {

// A ray on a small sphere, by plain vectors.
constexpr double kRadius = 7;

Vec3d at(double cosine, double t) {
    return Vec3d{0, 0, kRadius} + t * Vec3d(std::sqrt(1 - cosine * cosine), 0, cosine);
}

TEST(RadialRay, HeightAndCosineAreThoseOfVectors) {
    for (const double cosine : {-1.0, -0.7, -0.01, 0.0, 0.3, 1.0}) {
        const RadialRay ray{1 / kRadius, cosine};
        for (const double t : {0.0, 0.5, 3.0, 6.0, 20.0}) {
            const Vec3d p = at(cosine, t), way = at(cosine, 1) - at(cosine, 0);
            EXPECT_NEAR(ray.rise(t), length(p) - kRadius, 1e-13);
            EXPECT_NEAR(ray.cosine_at(t), dot(normalize(p), way), 1e-13);
        }
    }
}

TEST(RadialRay, ReachesTheSpheresItIsSentTo) {
    int reached = 0;
    for (const double cosine : {-1.0, -0.7, -0.3, -0.01, 0.0, 0.3, 1.0}) {
        const RadialRay ray{1 / kRadius, cosine};
        for (const double height : {0.0, 1e-9, 0.5, 4.0}) {
            const double out = ray.distance_outwards(height);
            EXPECT_NEAR(ray.rise(out), height, 1e-13);
            EXPECT_GE(ray.cosine_at(out), -1e-13) << "outwards";
            const double in = ray.distance_inwards(height);
            const double nearest = kRadius * (1 - std::sqrt(1 - cosine * cosine));
            const bool hits = cosine < 0 && height <= nearest;
            EXPECT_EQ(std::isfinite(in), hits) << cosine << ' ' << height;
            if (!hits) continue;
            EXPECT_NEAR(ray.rise(in), -height, 1e-13);
            EXPECT_LE(ray.cosine_at(in), 0);
            ++reached;
        }
    }
    EXPECT_GE(reached, 10);
}

TEST(RadialRay, CurvatureZeroIsAFlatLayer) {
    const RadialRay up{0, 0.5}, down{0, -0.5}, level{0, 0};
    EXPECT_EQ(up.distance_outwards(3), 6);
    EXPECT_EQ(down.distance_inwards(3), 6);
    EXPECT_TRUE(std::isinf(down.distance_outwards(3)));
    EXPECT_TRUE(std::isinf(up.distance_inwards(3)));
    EXPECT_TRUE(std::isinf(level.distance_inwards(3)));
    EXPECT_EQ(up.rise(4), 2);
    EXPECT_EQ(up.cosine_at(1e9), 0.5);
}

TEST(RadialRay, ThinLayersOnLargeSpheresKeepTheirDigits) {
    // 15 um on 1 km: a difference of radii would keep 7 digits of the height; the layer is flat up
    // to a fraction of 15 um / 1 km / cosine^2.
    const RadialRay ray{1e-9, -0.6};
    EXPECT_NEAR(ray.distance_inwards(15) / 25, 1, 1e-7);
    EXPECT_NEAR(ray.rise(ray.distance_inwards(15)), -15, 1e-13);
    const RadialRay chord{1e-9, -1e-3};
    EXPECT_NEAR(chord.distance_outwards(0), 2e6, 1e-6) << "2 r cos";
}

}  // namespace

namespace {

TEST(FlakeCandidates, AreaIsTheMeanOfTheFoldedGaussian) {
    for (const double alpha : {0.005, 0.1, 0.5, 1.0}) {
        for (const double mu : {0.0, 0.01, 0.1, 0.5, 0.95, 1.0}) {
            const double sine = std::sqrt(1 - mu * mu);
            // The tail beyond 6 alpha holds exp(-36); the kink gets a panel on each side.
            const double reach = 6 * alpha;
            const double kink = sine > 0 ? std::min(reach, mu / sine) : reach;
            double mean = 0;
            const auto add = [&](double from, double to) {
                if (!(to > from)) return;
                const Quadrature rule = gauss_legendre(80, from, to);
                for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
                    const double p = rule.nodes[i];
                    mean += rule.weights[i] * std::abs(mu - sine * p) *
                            std::exp(-p * p / (alpha * alpha)) /
                            (alpha * std::sqrt(std::numbers::pi));
                }
            };
            add(-reach, kink);
            add(kink, reach);
            EXPECT_NEAR(candidate_area(mu, alpha), mean, 1e-12) << mu << ' ' << alpha;
            EXPECT_EQ(candidate_area(mu, alpha), candidate_area(-mu, alpha));
        }
    }
}

TEST(FlakeCandidates, AreaGrowsWithTheCosine) {
    // Else its value at the end of a ray would be no majorant. Where flakes are narrow it is the
    // cosine itself, to a rounding.
    for (const double alpha : {0.005, 0.1, 1.0}) {
        double last = 0;
        for (int i = 0; i <= 2000; ++i) {
            const double area = candidate_area(i / 2000., alpha);
            EXPECT_GE(area, last * (1 - 1e-15)) << i << ' ' << alpha;
            last = area;
        }
        EXPECT_EQ(last, 1);
    }
}

TEST(FlakeCandidates, RealOnesHaveTheProjectedAreaOfTheFlakes) {
    // E[m_z] over candidates, times their area, against the quadrature over flake normals.
    RandomStream random(1, 2, 3);
    constexpr int kDraws = 100'000;
    for (const double alpha : {0.1, 0.6}) {
        for (const double mu : {0.02, 0.3, 0.8, -0.8, 1.0}) {
            const double sine = std::sqrt(1 - mu * mu);
            double sum = 0, squares = 0;
            for (int i = 0; i < kDraws; ++i) {
                const auto [p, q] = sample_candidate(mu, sine, alpha, random);
                const double upright = 1 / std::sqrt(1 + p * p + q * q);
                sum += upright;
                squares += upright * upright;
            }
            const double mean = sum / kDraws;
            const double error = std::sqrt((squares / kDraws - mean * mean) / kDraws);
            const double expected =
                paint::projected_area(std::abs(mu), alpha) / candidate_area(mu, alpha);
            EXPECT_LT(std::abs(mean - expected), 4 * error + 1e-9) << mu << ' ' << alpha;
        }
    }
}

TEST(FlakeCandidates, SlopesFollowTheVisibleArea) {
    // Histogram of the slope along the ray against the integral of its density: chi-square of 20
    // bins, 19 degrees of freedom, exceeds 43.8 once in 1000.
    RandomStream random(4, 5, 6);
    constexpr int kDraws = 200'000, kBins = 20;
    const double alpha = 0.3;
    for (const double mu : {-0.9, 0.1, 0.5}) {
        const double sine = std::sqrt(1 - mu * mu);
        std::array<double, kBins> expected{}, found{};
        const auto bin_edge = [&](int i) { return alpha * (-2.5 + 5. * i / kBins); };
        for (int i = 0; i < kBins; ++i) {
            const double from = i == 0 ? -6 * alpha : bin_edge(i);
            const double to = i == kBins - 1 ? 6 * alpha : bin_edge(i + 1);
            constexpr int kSteps = 4000;
            for (int k = 0; k < kSteps; ++k) {
                const double p = from + (to - from) * (k + .5) / kSteps;
                expected[i] += (to - from) / kSteps * std::abs(mu - sine * p) *
                               std::exp(-p * p / (alpha * alpha)) /
                               (alpha * std::sqrt(std::numbers::pi) * candidate_area(mu, alpha));
            }
        }
        double across_sq = 0;
        for (int i = 0; i < kDraws; ++i) {
            const auto [p, q] = sample_candidate(mu, sine, alpha, random);
            const int bin = static_cast<int>(std::floor((p / alpha + 2.5) / 5 * kBins));
            found[std::clamp(bin, 0, kBins - 1)] += 1;
            across_sq += q * q;
        }
        double chi_square = 0;
        for (int i = 0; i < kBins; ++i) {
            const double n = kDraws * expected[i];
            ASSERT_GT(n, 10);
            chi_square += (found[i] - n) * (found[i] - n) / n;
        }
        EXPECT_LT(chi_square, 43.8) << mu;
        // Across: variance alpha^2 / 2, whose estimate scatters by its square root of 2 / draws.
        EXPECT_NEAR(across_sq / kDraws / (alpha * alpha / 2), 1, 4 * std::sqrt(2. / kDraws));
    }
}

}  // namespace

namespace {

/// Flakes and a pigment; the rate of candidates along a ray varies by a factor of 20.
Slab mixed_slab() {
    paint::Layer layer = test::flake_layer(1, 0.05, 0.6, 0.2);
    layer.pigments.push_back({paint::PigmentCoefficients{2.0, 1.0, 0.3}});
    const std::array wavelengths{550.};
    return Medium(test::paint_of(1.5, {layer}), wavelengths).slabs[0];
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
        // 16 but for terms of higher order.
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
                EXPECT_LE(candidate->choice,
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
            worst = test::worse(worst, std::abs(-std::expm1(-depth) - (i + .5) / kDraws));
        }
        EXPECT_LT(worst, 1.95 / std::sqrt(kDraws));
        EXPECT_GT(distances.size(), 1000u);
    }
}

TEST(FreeFlight, AnEmptySlabHasNoCandidates) {
    RandomStream random(1, 1, 1);
    const Slab empty;
    EXPECT_FALSE(fly_delta(empty, kChord, 10, random));
    EXPECT_FALSE(fly_simpson(empty, kChord, 10, 4, random));
}

}  // namespace
}  // namespace nacre::montecarlo
