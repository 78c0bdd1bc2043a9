#include "nacre/optics/airy_lanes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace nacre::optics {
namespace {

// Largest error over [-5, 5] turns, of arguments as they are after rounding to the lanes' type.
template <class V>
double worst_wave_error() {
    using Real = LaneScalar<V>;
    double worst = 0;
    for (int n = -5000; n < 5000; n += kLanes) {
        const V turns = make_lanes<V>([&](int i) { return Real(n + i) * Real(0.001); });
        const auto wave = cos_sin_turns(turns);
        for (int i = 0; i < kLanes; ++i) {
            // Whole turns taken off first: what is left is exact.
            const double rest = std::remainder(static_cast<double>(turns[i]), 1.0);
            const double angle = 2 * std::numbers::pi * rest;
            worst = std::max({worst, std::abs(wave.cosine[i] - std::cos(angle)),
                              std::abs(wave.sine[i] - std::sin(angle))});
        }
    }
    return worst;
}

TEST(AiryLanes, WavesKeepTheirErrorBound) {
    EXPECT_LT(worst_wave_error<FloatLanes>(), kAiryLanesError<FloatLanes>);
    EXPECT_LT(worst_wave_error<DoubleLanes>(), kAiryLanesError<DoubleLanes>);
}

TEST(AiryLanes, SineKeepsItsDigitsNearZero) {
    for (const float turns : {1e-20f, 1e-8f, 1e-3f}) {
        const double expected = std::sin(2 * std::numbers::pi * turns);
        EXPECT_NEAR(cos_sin_turns(splat(turns)).sine[5] / expected, 1, kAiryLanesError<FloatLanes>);
    }
}

template <class V>
double worst_decay_error() {
    using Real = LaneScalar<V>;
    double worst = 0;
    for (Real x = Real(1e-12); x < 80; x *= Real(1.07)) {
        const auto d = decay(V{} + x);
        const double mean = -std::expm1(-static_cast<double>(x)) / x;
        worst = std::max({worst, std::abs(d.left[2] / std::exp(-static_cast<double>(x)) - 1),
                          std::abs(d.mean[2] / mean - 1)});
    }
    return worst;
}

TEST(AiryLanes, DecayKeepsItsErrorBound) {
    EXPECT_LT(worst_decay_error<FloatLanes>(), kAiryLanesError<FloatLanes>);
    EXPECT_LT(worst_decay_error<DoubleLanes>(), kAiryLanesError<DoubleLanes>);
    EXPECT_EQ(decay(FloatLanes{}).mean[0], 1);
    EXPECT_EQ(decay(DoubleLanes{}).mean[0], 1);
}

}  // namespace
}  // namespace nacre::optics
