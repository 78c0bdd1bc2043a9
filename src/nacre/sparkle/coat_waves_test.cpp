#include "nacre/sparkle/coat_waves.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <vector>

#include "nacre/core/random.h"
#include "nacre/sparkle/plane_waves.h"
#include "nacre/testing/directions.h"
#include "nacre/testing/statistics.h"

namespace nacre::sparkle {
namespace {

using std::numbers::pi;
using test::random_direction;

constexpr double kSlope = 0.01;

paint::OrangePeel only(const paint::WaveBand& band) {
    paint::OrangePeel peel;
    peel.*band.slope = kSlope;
    return peel;
}

TEST(CoatWaves, TheGradientIsThatOfTheHeight) {
    const CoatWaves waves({0.01, 0.02, 0.005, 0.03, 0.01}, 3);
    // Numbers of few bits, so that the places are exact; steps far below the shortest wave.
    constexpr float kStep = 0x1p-11f;
    Rng rng(1);
    for (int i = 0; i < 200; ++i) {
        const auto place = [&] { return std::floor(512 * rng.uniform_float()) / 4 - 64; };
        const Vec3f x{place(), place(), place()};
        const Vec3d gradient = waves.gradient(x);
        for (int axis = 0; axis < 3; ++axis) {
            Vec3f before = x, after = x;
            before[axis] -= kStep;
            after[axis] += kStep;
            const double slope =
                (waves.height_mm(after) - waves.height_mm(before)) / (2 * double{kStep});
            EXPECT_NEAR(gradient[axis], slope, 1e-5);
        }
    }
}

// On planes of any direction and on a sphere, along both axes of the tangent plane; the two are not
// correlated. Nearly normal: a normal law has a fourth moment of 3, a sum of sinusoids of amplitudes a
// 3 - 3/2 Sum a^4 / (Sum a^2)^2, and as a goes with the cosine of a random direction, whose square has
// the mean 1/3 and its fourth power 1/5, N of them have 3 - 27 / (10 N).
TEST(CoatWaves, SlopesHaveTheStatedRootMeanSquareOnAnyShape) {
    constexpr int kPoints = 40'000;
    constexpr double kKurtosis = 3 - 2.7 / kWavesPerBand;
    const double kurtosis_error = std::sqrt(24.0 / kPoints);  // of a normal law
    int shapes = 0;
    for (const paint::WaveBand& band : paint::kWaveBands) {
        const CoatWaves waves(only(band), 11);
        Rng rng(5);
        // Far larger than the waves, also than those that run nearly along the normal.
        const double size_mm = 200 * band.wavelength_mm[1];
        const Vec3f plane = random_direction(rng);
        for (const bool sphere : {false, true}) {
            std::vector<double> x, y, product;
            for (int i = 0; i < kPoints; ++i) {
                const Vec3f n = sphere ? random_direction(rng) : plane;
                const Frame frame = Frame::around(n);
                const auto side = [&] {
                    return static_cast<float>(size_mm * (rng.uniform_double() - 0.5));
                };
                const Vec3f place = sphere ? static_cast<float>(size_mm / 2) * n
                                           : side() * frame.s + side() * frame.t;
                const Vec2f slope = waves.slope(place, n, frame.s);
                x.push_back(slope.x);
                y.push_back(slope.y);
                product.push_back(double{slope.x} * slope.y);
            }
            const std::string what = std::string(band.key) + (sphere ? " sphere" : " plane");
            for (const auto* axis : {&x, &y}) {
                const test::Moments found(*axis);
                EXPECT_NEAR(found.mean, 0, test::kWorstZ * found.mean_error) << what;
                EXPECT_NEAR(found.variance, kSlope * kSlope, test::kWorstZ * found.variance_error)
                    << what;
                const double kurtosis =
                    std::pow(found.variance_error / found.variance, 2) * kPoints + 1;
                EXPECT_NEAR(kurtosis, kKurtosis, test::kWorstZ * kurtosis_error) << what;
            }
            const test::Moments across(product);
            EXPECT_NEAR(across.mean, 0, test::kWorstZ * across.mean_error) << what;
            ++shapes;
        }
    }
    EXPECT_EQ(shapes, 10);
}

// The squared slopes of a square of a plane by wavelength, from the Fourier transform of its heights.
TEST(CoatWaves, TheSpectrumIsThatOfTheBand) {
    constexpr int n = 192;
    const paint::WaveBand& band = paint::kWaveBands[2];
    const double step_mm = band.wavelength_mm[0] / 3;  // Nyquist beyond the shortest wave
    std::vector<std::complex<double>> turn(n);
    for (int i = 0; i < n; ++i) turn[i] = std::polar(1.0, -2 * pi * i / n);
    double all = 0, inside = 0, near = 0, shorter = 0;
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        const CoatWaves waves(only(band), seed);
        Rng rng(seed);
        const Frame frame = Frame::around(random_direction(rng));
        std::vector<std::complex<double>> height(n * n), half(n * n), power(n * n);
        for (int j = 0; j < n; ++j) {
            for (int i = 0; i < n; ++i) {
                const auto at = [&](int k) { return static_cast<float>(k * step_mm); };
                // Hann's window.
                const double window =
                    (1 - std::cos(2 * pi * i / n)) * (1 - std::cos(2 * pi * j / n));
                height[j * n + i] = window * waves.height_mm(at(i) * frame.s + at(j) * frame.t);
            }
        }
        const auto transform_rows = [&](const auto& from, auto& to) {  // and transposes
            for (int j = 0; j < n; ++j) {
                for (int k = 0; k < n; ++k) {
                    std::complex<double> sum = 0;
                    for (int i = 0; i < n; ++i) sum += from[j * n + i] * turn[i * k % n];
                    to[k * n + j] = sum;
                }
            }
        };
        transform_rows(height, half);
        transform_rows(half, power);
        for (int j = 0; j < n; ++j) {
            for (int i = 0; i < n; ++i) {
                const double kx = (i < n / 2 ? i : i - n) / (n * step_mm);
                const double ky = (j < n / 2 ? j : j - n) / (n * step_mm);
                const double k2 = kx * kx + ky * ky;
                if (k2 == 0) continue;
                const double slopes = std::norm(power[i * n + j]) * k2;
                const double wavelength_mm = 1 / std::sqrt(k2);
                all += slopes;
                // The window blurs an edge by a frequency or so.
                constexpr double kBlur = 1.1;
                if (wavelength_mm < band.wavelength_mm[0] / kBlur) {
                    shorter += slopes;
                } else if (wavelength_mm < band.wavelength_mm[1] * kBlur) {
                    inside += slopes;
                } else if (wavelength_mm < 2 * band.wavelength_mm[1] * kBlur) {
                    near += slopes;
                }
            }
        }
    }
    EXPECT_LT(shorter / all, 1e-6);  // found: 4e-9
    EXPECT_NEAR(inside / all, 0.89, 0.04);
    EXPECT_GT((inside + near) / all, 0.97);
}

TEST(CoatWaves, BandsAddUpAndSpecimensDiffer) {
    const Vec3f x{12.5f, -3.25f, 8};
    Vec3d sum{};
    paint::OrangePeel all;
    for (const paint::WaveBand& band : paint::kWaveBands) {
        sum += CoatWaves(only(band), 4).gradient(x);
        all.*band.slope = kSlope;
    }
    EXPECT_NEAR(length(CoatWaves(all, 4).gradient(x) - sum), 0, 1e-7);
    EXPECT_GT(length(CoatWaves(all, 5).gradient(x) - sum), 1e-3);
    EXPECT_EQ(CoatWaves({}, 4).gradient(x), Vec3d{});
    EXPECT_NEAR(all.slope(), kSlope * std::sqrt(5.0), 1e-15);
}

}  // namespace
}  // namespace nacre::sparkle
