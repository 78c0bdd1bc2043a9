#include "nacre/core/lane_math.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

#include "nacre/core/quadrature.h"
#include "nacre/core/random.h"
#include "nacre/testing/statistics.h"

namespace nacre {
namespace {

// Against long double, of arguments as they are after rounding to the lanes' type.
template <class V>
double worst_exp_error(double first, double last, double step) {
    using Real = LaneScalar<V>;
    double worst = 0;
    for (double at = first; at < last; at += step) {
        const V x = make_lanes<V>([&](int i) { return static_cast<Real>(at + step * i / kLanes); });
        const V found = exp_lanes(x);
        for (int i = 0; i < kLanes; ++i) {
            const long double exact = std::exp(static_cast<long double>(x[i]));
            worst = test::worse(worst, static_cast<double>(std::abs(found[i] - exact) / exact));
        }
    }
    EXPECT_GT(worst, 0);
    return worst;
}

TEST(LaneMath, ExponentialKeepsItsErrorBoundOverItsRange) {
    EXPECT_LT(worst_exp_error<FloatLanes>(-86.9, 87.9, 0.0371), kExpLanesError<FloatLanes>);
    EXPECT_LT(worst_exp_error<DoubleLanes>(-708, 708.9, 0.0371), kExpLanesError<DoubleLanes>);
}

TEST(LaneMath, FloatExponentialIsClampedAndFiniteOutsideItsRange) {
    EXPECT_FLOAT_EQ(exp_lanes(splat(-1000.0f))[0], std::exp(-87.0f));
    EXPECT_TRUE(std::isfinite(exp_lanes(splat(1000.0f))[0]));
    EXPECT_FLOAT_EQ(exp_lanes(splat(0.0f))[7], 1.0f);
}

TEST(LaneMath, OneMinusExponentialKeepsItsDigitsWhereItVanishes) {
    double worst = 0;
    for (float x = 1e-20f; x < 80.0f; x *= 1.07f) {
        const double exact = -std::expm1(-static_cast<double>(x));
        const double found = one_minus_exp_lanes(splat(x))[3];
        worst = test::worse(worst, std::abs(found - exact) / exact);
    }
    EXPECT_GT(worst, 0);
    EXPECT_LT(worst, kOneMinusExpLanesError);
}

TEST(LaneMath, MeanAttenuationIsOneWithoutDepthAndTheMeanOfTheExponential) {
    EXPECT_EQ(mean_attenuation(0.0), 1.0);
    EXPECT_EQ(mean_attenuation(splat(0.0f))[3], 1.0f);
    const Quadrature rule = gauss_legendre(40, 0, 1);
    for (const double x : {1e-14, 1e-6, 0.01, 0.3, 2.0, 20.0}) {
        double mean = 0;
        for (std::size_t n = 0; n < rule.nodes.size(); ++n) {
            mean += rule.weights[n] * std::exp(-x * rule.nodes[n]);
        }
        EXPECT_NEAR(mean_attenuation(x), mean, 1e-12 * mean) << x;
        EXPECT_NEAR(mean_attenuation(splat(static_cast<float>(x)))[3], mean,
                    kOneMinusExpLanesError * mean)
            << x;
    }
}

TEST(Lanes, LargerSmallerAndRootActOnEachLane) {
    const FloatLanes rising = make_lanes([](int i) { return static_cast<float>(i); });
    const FloatLanes falling = make_lanes([](int i) { return static_cast<float>(7 - i); });
    for (int i = 0; i < kLanes; ++i) {
        EXPECT_EQ(max_lanes(rising, falling)[i], std::max(i, 7 - i));
        EXPECT_EQ(min_lanes(rising, falling)[i], std::min(i, 7 - i));
        EXPECT_FLOAT_EQ(sqrt_lanes(rising)[i], std::sqrt(static_cast<float>(i)));
    }
    EXPECT_EQ(lane_sum(rising), 28);
    EXPECT_EQ(lane_max(rising), 7);
    EXPECT_EQ(lane_mean(rising), 3.5f);
    const FloatLanes nan = splat(std::numeric_limits<float>::quiet_NaN());
    EXPECT_EQ(max_lanes(nan, splat(2.0f))[0], 2);
}

TEST(LaneMath, LogarithmKeepsItsBound) {
    Rng rng(1);
    for (int i = 0; i < 20000; ++i) {
        const float x = std::exp(170 * (rng.uniform_float() - 0.5f));
        const float near_one = 1 - 0.001f * rng.uniform_float();
        const FloatLanes found = log_lanes(FloatLanes{x, near_one, 1, 1, 1, 1, 1, 1});
        EXPECT_NEAR(found[0], std::log(static_cast<double>(x)),
                    kLogLanesError * (1 + std::abs(std::log(x))));
        EXPECT_NEAR(found[1], std::log(static_cast<double>(near_one)), kLogLanesError * 1e-3);
        EXPECT_EQ(found[2], 0);
    }
}

TEST(LaneMath, DoubleExponentialVanishesBelowItsRange) {
    EXPECT_EQ(exp_lanes(nacre::splat(-0.0))[3], 1);
    EXPECT_GT(exp_lanes(nacre::splat(-708.0))[3], 0);
    EXPECT_EQ(exp_lanes(nacre::splat(-708.1))[3], 0);
    EXPECT_EQ(exp_lanes(nacre::splat(-1e300))[3], 0);
}

TEST(ComplexLanes, CosineAndSineOfRadiansMatchLongDouble) {
    for (int i = -20000; i <= 20000; ++i) {
        const double x = i % 2 == 0 ? i * 5.0 : i * 1e-3;
        const ComplexLanes found = cis_lanes(nacre::splat(x));
        EXPECT_NEAR(found.re[0], static_cast<double>(std::cos((long double)x)),
                    kCosSinLanesError<DoubleLanes>)
            << x;
        EXPECT_NEAR(found.im[0], static_cast<double>(std::sin((long double)x)),
                    kCosSinLanesError<DoubleLanes>)
            << x;
    }
}

TEST(ComplexLanes, ArithmeticIsThatOfStdComplex) {
    const std::complex<double> a(1.5, -2), b(.3, .7);
    const ComplexLanes x = splat_complex(a), y = splat_complex(b);
    const std::pair<ComplexLanes, std::complex<double>> pairs[] = {
        {x + y, a + b},
        {x - y, a - b},
        {x * y, a * b},
        {x / y, a / b},
        {-x, -a},
        {conj(x), std::conj(a)},
        {exp_i(y), std::exp(std::complex<double>(0, 1) * b)}};
    for (const auto& [found, expected] : pairs) {
        EXPECT_NEAR(found.re[5], expected.real(), 4e-15);
        EXPECT_NEAR(found.im[5], expected.imag(), 4e-15);
    }
    EXPECT_NEAR(norm(x)[0], std::norm(a), 1e-15);
}

TEST(ComplexLanes, RootsOfTheUpperHalfPlaneAreThoseOfStdComplex) {
    using Complex = std::complex<double>;
    for (double size : {1e-150, 1e-3, 1.0, 7e5, 1e150}) {
        for (double degrees : {0.0, 1e-12, 3.0, 45.0, 89.999, 90.0, 91.0, 179.0, 180 - 1e-9}) {
            const Complex z = std::polar(size, degrees * std::numbers::pi / 180);
            const ComplexLanes found = sqrt_upper(splat_complex(z));
            EXPECT_LE(std::abs(Complex(found.re[3], found.im[3]) - std::sqrt(z)),
                      1e-15 * std::sqrt(size))
                << z;
        }
    }
    const ComplexLanes decaying = sqrt_upper(splat_complex(-4)),
                       none = sqrt_upper(splat_complex(0));
    EXPECT_EQ(decaying.re[0], 0);
    EXPECT_EQ(decaying.im[0], 2);
    EXPECT_EQ(none.re[0], 0);
    EXPECT_EQ(none.im[0], 0);
}

// Largest error over [-5, 5] turns, of arguments as they are after rounding to the lanes' type.
template <class V>
double worst_turns_error() {
    using Real = LaneScalar<V>;
    double worst = 0;
    for (int n = -5000; n < 5000; n += kLanes) {
        const V turns = make_lanes<V>([&](int i) { return Real(n + i) * Real(0.001); });
        const auto wave = cos_sin_turns(turns);
        for (int i = 0; i < kLanes; ++i) {
            // Whole turns are subtracted first, which is exact.
            const long double fraction = std::remainder(static_cast<long double>(turns[i]), 1.0L);
            const long double angle = 2 * std::numbers::pi_v<long double> * fraction;
            worst =
                std::max({worst, static_cast<double>(std::abs(wave.cosine[i] - std::cos(angle))),
                          static_cast<double>(std::abs(wave.sine[i] - std::sin(angle)))});
        }
    }
    EXPECT_GT(worst, 0);
    return worst;
}

TEST(LaneMath, CosineAndSineOfTurnsKeepTheirErrorBound) {
    EXPECT_LT(worst_turns_error<FloatLanes>(), kCosSinLanesError<FloatLanes>);
    EXPECT_LT(worst_turns_error<DoubleLanes>(), kCosSinLanesError<DoubleLanes>);
}

template <class V>
void expect_digits_of_small_sine() {
    using Real = LaneScalar<V>;
    for (const Real turns : {Real(1e-20), Real(1e-8), Real(1e-3)}) {
        const long double expected =
            std::sin(2 * std::numbers::pi_v<long double> * static_cast<long double>(turns));
        const V found = cos_sin_turns(nacre::splat(turns)).sine;
        EXPECT_NEAR(static_cast<double>(found[5] / expected), 1, kCosSinLanesError<V>) << turns;
    }
}

TEST(LaneMath, SineOfTurnsKeepsItsDigitsNearZero) {
    expect_digits_of_small_sine<FloatLanes>();
    expect_digits_of_small_sine<DoubleLanes>();
}

template <class V>
double worst_decay_error() {
    using Real = LaneScalar<V>;
    double worst = 0;
    for (Real x = Real(1e-12); x < 80; x *= Real(1.07)) {
        const auto d = decay(V{} + x);
        const double mean = -std::expm1(-static_cast<double>(x)) / x;
        worst = test::worse(worst, std::abs(d.left[2] / std::exp(-static_cast<double>(x)) - 1));
        worst = test::worse(worst, std::abs(d.mean[2] / mean - 1));
    }
    return worst;
}

TEST(LaneMath, DecayKeepsItsErrorBound) {
    EXPECT_LT(worst_decay_error<FloatLanes>(), kDecayLanesError<FloatLanes>);
    EXPECT_LT(worst_decay_error<DoubleLanes>(), kDecayLanesError<DoubleLanes>);
    EXPECT_EQ(decay(FloatLanes{}).mean[0], 1);
    EXPECT_EQ(decay(DoubleLanes{}).mean[0], 1);
}

TEST(LaneMath, AnglesKeepTheirErrorAllAroundAndAtAnySize) {
    double worst = 0;
    int count = 0;
    for (float size : {1e-20f, 1e-3f, 1.0f, 1e15f}) {
        for (double angle = -3.1415; angle < 3.1415; angle += 1.7e-4, ++count) {
            const float x = size * static_cast<float>(std::cos(angle));
            const float y = size * static_cast<float>(std::sin(angle));
            const double exact = std::atan2(static_cast<double>(y), static_cast<double>(x));
            worst = test::worse(worst, std::abs(atan2_lanes(splat(y), splat(x))[5] - exact));
        }
    }
    EXPECT_GT(count, 100000);
    EXPECT_GT(worst, 0);
    EXPECT_LT(worst, kAtan2LanesError);
}

TEST(LaneMath, SmallAnglesKeepTheirDigits) {
    for (float y = 1e-30f; y < 0.1f; y *= 3) {
        const double exact = std::atan2(static_cast<double>(y), 1.0);
        EXPECT_NEAR(atan2_lanes(splat(y), splat(1.0f))[0], exact, kAtan2LanesError * exact);
    }
}

TEST(LaneMath, AxesAndTheOriginAreExact) {
    const FloatLanes y{0, 1, 0, -1, 0, 0, 0, 0}, x{1, 0, -1, 0, 0, 0, 0, 0};
    const FloatLanes angle = atan2_lanes(y, x);
    for (int i = 0; i < kLanes; ++i) EXPECT_FLOAT_EQ(angle[i], std::atan2(y[i], x[i]));
}

TEST(LaneMath, EveryCombinationOfLanesIsCountedAndItsFirstFound) {
    for (unsigned bits = 0; bits < 1u << kLanes; ++bits) {
        const IntLanes lanes = make_lanes<IntLanes>([&](int i) { return bits >> i & 1u; });
        EXPECT_EQ(lane_bits(lanes != 0), bits);
        EXPECT_EQ(count_lanes(lanes != 0), std::popcount(bits));
        EXPECT_EQ(first_lane(lanes != 0), bits == 0 ? kLanes : std::countr_zero(bits));
    }
}

}  // namespace
}  // namespace nacre
