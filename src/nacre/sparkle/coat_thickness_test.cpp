#include "nacre/sparkle/coat_thickness.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "nacre/core/random.h"
#include "nacre/paint/limits.h"
#include "nacre/testing/directions.h"
#include "nacre/testing/statistics.h"

namespace nacre::sparkle {
namespace {

using std::numbers::pi;
using test::random_direction;

/// Of a standard normal law beyond +-x.
double tails(double x) { return std::erfc(x / std::sqrt(2.0)); }

// On a plane and on a sphere far larger than the waves, also than those that run nearly along the
// normal. The fourth moment of such a sum is 3 - 1.5 sum a^4 / (sum a^2)^2, some 2.95, of a normal law 3:
// that moves the fraction beyond one deviation by 0.002.
TEST(CoatThickness, IsNearlyNormalWithMeanZeroAndVarianceOneOnAnyShape) {
    constexpr int kPoints = 60'000;
    constexpr double kSize_mm = 3e4, kMax = paint::limits::kMaxCoatDeviation;
    // What cutting the law off at +-3 takes from its variance: E[(z^2 - 9)+].
    const double density = std::exp(-kMax * kMax / 2) / std::sqrt(2 * pi);
    const double cut = 2 * kMax * density + tails(kMax) * (1 - kMax * kMax);
    EXPECT_NEAR(cut, 0.005, 2e-4);
    Rng rng(5);
    const Vec3f plane = random_direction(rng);
    const Frame frame = Frame::around(plane);
    for (const bool sphere : {false, true}) {
        const CoatThickness field(11);
        std::vector<double> z, beyond_one;
        int cut_off = 0;
        for (int i = 0; i < kPoints; ++i) {
            const auto side = [&] {
                return static_cast<float>(kSize_mm * (rng.uniform_double() - 0.5));
            };
            const Vec3f place = sphere ? static_cast<float>(kSize_mm / 2) * random_direction(rng)
                                       : side() * frame.s + side() * frame.t;
            z.push_back(field.deviation(place));
            beyond_one.push_back(std::abs(z.back()) > 1);
            cut_off += std::abs(z.back()) >= kMax;
        }
        const test::Moments found(z), beyond(beyond_one);
        EXPECT_NEAR(found.mean, 0, test::kWorstZ * found.mean_error) << sphere;
        EXPECT_NEAR(found.variance, 1 - cut, test::kWorstZ * found.variance_error + 1e-3) << sphere;
        EXPECT_NEAR(beyond.mean, tails(1), test::kWorstZ * beyond.mean_error + 2e-3) << sphere;
        EXPECT_NEAR(cut_off, kPoints * tails(kMax), 0.3 * kPoints * tails(kMax)) << sphere;
        EXPECT_LE(*std::max_element(z.begin(), z.end()), kMax);
    }
}

// The variance on squares of a plane by wavelength, from their Fourier transforms. Of waves of length l
// at random angles to the plane a fraction 1 - sqrt(1 - (l / L)^2) looks longer than L: of the variance
// 34 % looks longer than 100 mm, and 7 % longer than 200 mm.
TEST(CoatThickness, TheSpectrumIsThatOfASprayedPanel) {
    constexpr int n = 192, kFields = 8;
    constexpr double kStep_mm = 4;  // 0.8 m
    double shorter = 0, inside = 0, longer = 0, longest = 0;
    for (std::uint64_t seed = 0; seed < kFields; ++seed) {
        const CoatThickness field(seed);
        Rng rng(seed);
        const Frame frame = Frame::around(random_direction(rng));
        std::vector<std::complex<double>> value(n * n), half(n * n), power(n * n), turn(n);
        for (int i = 0; i < n; ++i) turn[i] = std::polar(1.0, -2 * pi * i / n);
        for (int j = 0; j < n; ++j) {
            for (int i = 0; i < n; ++i) {
                const auto at = [&](int k) { return static_cast<float>(k * kStep_mm); };
                const double window =  // Hann's
                    (1 - std::cos(2 * pi * i / n)) * (1 - std::cos(2 * pi * j / n));
                value[j * n + i] = window * field.deviation(at(i) * frame.s + at(j) * frame.t);
            }
        }
        // No wave is shorter than 10 mm: higher frequencies than that are left out.
        constexpr int kHighest = 84;
        const auto transform_rows = [&](const auto& from, auto& to) {  // and transposes
            for (int j = 0; j < n; ++j) {
                for (int k = 0; k < n; ++k) {
                    if (std::min(k, n - k) > kHighest) continue;
                    std::complex<double> sum = 0;
                    for (int i = 0; i < n; ++i) sum += from[j * n + i] * turn[i * k % n];
                    to[k * n + j] = sum;
                }
            }
        };
        transform_rows(value, half);
        transform_rows(half, power);
        for (int j = 0; j < n; ++j) {
            for (int i = 0; i < n; ++i) {
                const double kx = (i < n / 2 ? i : i - n) / (n * kStep_mm);
                const double ky = (j < n / 2 ? j : j - n) / (n * kStep_mm);
                const double per_mm = std::hypot(kx, ky), part = std::norm(power[i * n + j]);
                // The window blurs an edge by a frequency or so.
                constexpr double kBlur_per_mm = 1.5 / (n * kStep_mm);
                if (per_mm > 1 / CoatThickness::kWavelengths_mm[0] + kBlur_per_mm) {
                    shorter += part;
                } else if (per_mm > 1 / CoatThickness::kWavelengths_mm[1]) {
                    inside += part;
                } else if (per_mm > 0.5 / CoatThickness::kWavelengths_mm[1]) {
                    longer += part;
                } else {
                    longest += part;
                }
            }
        }
    }
    const double all = shorter + inside + longer + longest;
    EXPECT_LT(shorter / all, 1e-4);  // found: 5e-6
    EXPECT_NEAR(inside / all, 0.66, 0.06);
    EXPECT_NEAR(longer / all, 0.27, 0.06);
}

TEST(CoatThickness, SpecimensDifferAndOneIsTheSameEverywhere) {
    const Vec3f x{12.5f, -3.25f, 8};
    EXPECT_EQ(CoatThickness(4).deviation(x), CoatThickness(4).deviation(x));
    EXPECT_GT(std::abs(CoatThickness(4).deviation(x) - CoatThickness(5).deviation(x)), 1e-3);
    // Close places are alike: no wave is shorter than 10 mm.
    EXPECT_NEAR(CoatThickness(4).deviation(x), CoatThickness(4).deviation(x + Vec3f{0, 0.01f, 0}),
                0.02);
}

}  // namespace
}  // namespace nacre::sparkle
