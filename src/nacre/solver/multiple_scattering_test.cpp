#include "nacre/solver/multiple_scattering.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "nacre/core/parallel.h"
#include "nacre/solver/directions.h"
#include "nacre/testing/statistics.h"

namespace nacre::solver {
namespace {

// Three orders on 12 nodes, 9 wavelengths, spectra of three shapes and a little noise.
struct Example {
    std::vector<double> angle = make_directions(1.5, 12, 8).exit_angle;
    std::vector<int> first = {0, 4, 8};
    int wavelengths = 9;
    std::vector<double> values;

    explicit Example(double noise) {
        std::mt19937 engine(5);
        std::uniform_real_distribution<double> uniform(-1, 1);
        const int pairs = 12 * 13 / 2 + 8 * 9 / 2 + 4 * 5 / 2;
        for (int p = 0; p < pairs; ++p) {
            const double a = uniform(engine), b = uniform(engine), c = uniform(engine);
            for (int w = 0; w < wavelengths; ++w) {
                values.push_back(a + b * w / 9.0 + c * std::sin(w) + noise * uniform(engine));
            }
        }
    }
    double peak() const {
        double largest = 0;
        for (double v : values) largest = std::max(largest, std::abs(v));
        return largest;
    }
};

double reconstruct(const MultipleScattering& r, std::size_t pair, int wavelength, int rank) {
    double sum = 0;
    for (int k = 0; k < rank; ++k) {
        sum += double(r.basis[k * r.wavelength_count + wavelength]) *
               r.coefficient[k * r.pair_count() + pair];
    }
    return sum;
}

TEST(MultipleScattering, CompressionKeepsItsBound) {
    const Example example(0.01);
    int last_rank = 0;
    for (const double tolerance : {0.1, 1e-2, 1e-3, 1e-6}) {
        const MultipleScattering r =
            compress(example.angle, example.first, example.wavelengths, example.values, tolerance);
        ASSERT_EQ(r.pair_count() * example.wavelengths, example.values.size());
        double worst = 0;
        for (std::size_t p = 0; p < r.pair_count(); ++p) {
            for (int w = 0; w < example.wavelengths; ++w) {
                worst = nacre::test::worse(worst,
                                           std::abs(reconstruct(r, p, w, r.rank()) -
                                                    example.values[p * example.wavelengths + w]));
            }
        }
        // Coefficients and basis are stored in single precision.
        EXPECT_LE(worst, (kFineErrorFraction * tolerance + 5e-7) * example.peak()) << tolerance;
        // Of the first spectra: what is left out is half the tolerance.
        double worst_of_tables = 0;
        for (std::size_t p = 0; p < r.pair_count(); ++p) {
            for (int w = 0; w < example.wavelengths; ++w) {
                worst_of_tables = nacre::test::worse(
                    worst_of_tables, std::abs(reconstruct(r, p, w, r.table_rank) -
                                              example.values[p * example.wavelengths + w]));
            }
        }
        EXPECT_LE(worst_of_tables, (tolerance + 5e-7) * example.peak()) << tolerance;
        EXPECT_LE(r.table_rank, r.rank());
        EXPECT_GE(r.rank(), last_rank);
        last_rank = r.rank();
    }
    EXPECT_EQ(last_rank, example.wavelengths);  // noise has full rank
}

TEST(MultipleScattering, FewSpectraNeedFewCoefficients) {
    const Example example(0.0);
    const MultipleScattering r =
        compress(example.angle, example.first, example.wavelengths, example.values, 1e-9);
    EXPECT_EQ(r.rank(), 3);  // as many as there are shapes
    EXPECT_EQ(r.coefficient.size(), 3 * r.pair_count());
    EXPECT_EQ(r.basis.size(), 3u * 9);
}

TEST(MultipleScattering, NothingCompressesToNothing) {
    const Example example(0.0);
    const std::vector<double> zero(example.values.size(), 0.0);
    const MultipleScattering r =
        compress(example.angle, example.first, example.wavelengths, zero, 1e-4);
    EXPECT_EQ(r.rank(), 0);
    EXPECT_EQ(r.orders(), 3);
    std::vector<double> none;
    MultipleScatteringSlice(r, 0.3).coefficients(0.2, 1.0, none);  // no coefficient, no access
}

TEST(MultipleScattering, SlicesReturnTheValuesAtNodes) {
    const Example example(0.0);
    const MultipleScattering r =
        compress(example.angle, example.first, example.wavelengths, example.values, 1e-9);
    std::vector<double> coefficient(r.rank());
    int compared = 0;
    for (int i = 0; i < 12; i += 3) {
        const MultipleScatteringSlice slice(r, example.angle[i]);
        for (int j = 0; j < 12; j += 2) {
            for (const double phi : {0.0, 1.1, std::numbers::pi}) {
                slice.coefficients(example.angle[j], phi, coefficient);
                double found = 0;
                for (int k = 0; k < r.rank(); ++k) {
                    found += coefficient[k] * r.basis[k * r.wavelength_count + 4];
                }
                // The sum of orders, pairs i >= j from first[l].
                double expected = 0;
                std::size_t offset = 0;
                for (std::size_t l = 0; l < example.first.size(); ++l) {
                    const int f = example.first[l], rows = 12 - f;
                    const int a = std::max(i, j) - f, b = std::min(i, j) - f;
                    if (b >= 0) {
                        const std::size_t pair = offset + a * (a + 1) / 2 + b;
                        expected += (l ? 2.0 : 1.0) * std::cos(l * (phi - std::numbers::pi)) *
                                    example.values[pair * example.wavelengths + 4];
                    }
                    offset += rows * (rows + 1) / 2;
                }
                EXPECT_NEAR(found, expected, 1e-6 * example.peak());  // single precision
                ++compared;
            }
        }
    }
    EXPECT_EQ(compared, 4 * 6 * 3);
}

TEST(MultipleScattering, ManyDirectionsAreEachAlone) {
    const Example example(0.01);
    const MultipleScattering r =
        compress(example.angle, example.first, example.wavelengths, example.values, 1e-6);
    const MultipleScatteringSlice slice(r, 0.4, r.rank() - 1);
    const std::vector<double> angles = {0.0, 0.3, 0.7, example.angle[9], 1.1, 1.4, 1.57};
    const std::size_t terms = static_cast<std::size_t>(r.rank() - 1) * r.orders();
    std::vector<double> all(angles.size() * terms), alone(terms);
    slice.by_order(angles, all);
    for (std::size_t i = 0; i < angles.size(); ++i) {
        slice.by_order({&angles[i], 1}, alone);
        for (std::size_t t = 0; t < terms; ++t) EXPECT_EQ(all[i * terms + t], alone[t]) << i;
    }
}

// More pairs than one thread takes at once, of spectra that differ in the last digits that are kept.
TEST(MultipleScattering, ManyPairsAreCompressedAlikeByAnyNumberOfThreads) {
    const std::vector<double> angle = make_directions(1.0, 44, 0).exit_angle;
    const std::vector<int> first = {0, 0, 0, 0, 0, 4};
    constexpr int kWavelengths = 11;
    std::size_t pairs = 0;
    for (int f : first) pairs += triangle(angle.size() - f);
    std::vector<double> values;
    for (std::size_t p = 0; p < pairs; ++p) {
        for (int w = 0; w < kWavelengths; ++w) {
            double sum = 0;
            for (int k = 0; k < 8; ++k)
                sum += std::pow(0.1, k) * std::cos(0.7 * p * (k + 1)) * std::cos(0.3 * k * w);
            values.push_back(sum);
        }
    }
    constexpr double kTolerance = 1e-4;
    const auto compressed = [&](int threads) {
        const ThreadLimit limit(threads);
        return compress(angle, first, kWavelengths, values, kTolerance);
    };
    const MultipleScattering r = compressed(1);
    EXPECT_TRUE(r == compressed(4));
    EXPECT_LT(r.table_rank, r.rank());
    EXPECT_LT(r.rank(), 8);
    double worst = 0;
    for (std::size_t p = 0; p < pairs; ++p) {
        for (int w = 0; w < kWavelengths; ++w) {
            worst = nacre::test::worse(
                worst, std::abs(reconstruct(r, p, w, r.rank()) - values[p * kWavelengths + w]));
        }
    }
    EXPECT_LE(worst, (kFineErrorFraction * kTolerance + 5e-7) * 1.12);
}

TEST(MultipleScattering, DarkPairsKeepSpectraOfTheirOwn) {
    // Two spectra at most pairs; 1e-7 of that and two others where one direction is among the last.
    const Example example(0.0);
    constexpr int kNodes = 12, kFirstDark = 9, kWavelengths = 9;
    constexpr double kDark = 1e-7, kTolerance = 1e-4;
    std::vector<double> values;
    std::vector<char> dark;
    for (int i = 0; i < kNodes; ++i) {
        for (int j = 0; j <= i; ++j) {
            dark.push_back(i >= kFirstDark);
            for (int w = 0; w < kWavelengths; ++w) {
                const double bright = std::cos(i + 2 * j) + std::sin(j) * w / 9.0;
                const double other =
                    std::cos(i + j) * std::sin(w) + std::cos(3.0 * j) * std::cos(2 * w);
                values.push_back(i >= kFirstDark ? kDark * other : bright);
            }
        }
    }
    const MultipleScattering r = compress(example.angle, {0}, kWavelengths, values, kTolerance);
    EXPECT_EQ(r.rank(), 4);
    for (std::size_t p = 0; p < dark.size(); ++p) {
        for (int w = 0; w < kWavelengths; ++w) {
            EXPECT_NEAR(reconstruct(r, p, w, r.rank()), values[p * kWavelengths + w],
                        (kFineErrorFraction * kTolerance + 5e-7) * (dark[p] ? 2 * kDark : 2))
                << p;
        }
    }
}

// Noise, of which every spectrum counts.
TEST(MultipleScattering, WhatIsTooLargeKeepsTheSpectraThatTheToleranceNeeds) {
    const std::vector<double> angle = make_directions(1.0, 44, 0).exit_angle;
    const std::vector<int> first(12, 0);
    constexpr int kWavelengths = 31;
    const std::size_t pairs = first.size() * triangle(angle.size());
    std::mt19937 engine(3);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (const double noise : {1e-5, 1e-3}) {
        std::vector<double> values;
        for (std::size_t p = 0; p < pairs * kWavelengths; ++p)
            values.push_back(1 + noise * uniform(engine));
        constexpr double kTolerance = 1e-4;
        const MultipleScattering r = compress(angle, first, kWavelengths, values, kTolerance);
        double worst = 0;
        for (std::size_t p = 0; p < pairs; ++p) {
            for (int w = 0; w < kWavelengths; ++w) {
                worst = nacre::test::worse(
                    worst, std::abs(reconstruct(r, p, w, r.rank()) - values[p * kWavelengths + w]));
            }
        }
        EXPECT_LE(worst, kTolerance);
        if (noise < kTolerance) {  // one spectrum would do: there is room for more
            EXPECT_EQ(r.table_rank, 1);
            EXPECT_EQ(r.rank(), static_cast<int>(kMaxFineCoefficients / pairs));
        } else {
            EXPECT_EQ(r.table_rank, kWavelengths);
            EXPECT_EQ(r.rank(), kWavelengths);
        }
    }
}

TEST(MultipleScattering, OrdersVanishTowardsTheNormalFromTheirFirstNode) {
    // 400 orders that are nonzero on the outermost four nodes only and are in phase at phi = pi.
    // Towards the normal nothing may depend on azimuth, where the polynomial through the zeros of
    // 40 nodes oscillates.
    const std::vector<double> angle = make_directions(1.0, 44, 0).exit_angle;
    std::vector<int> first = {0};
    std::vector<double> values(44 * 45 / 2, 0.0);
    for (int l = 1; l < 400; ++l) {
        first.push_back(40);
        values.insert(values.end(), 10, 1.0);
    }
    const MultipleScattering r = compress(angle, first, 1, values, 1e-6);
    std::vector<double> c(1);
    for (const double theta : {0.0, 0.01, 0.5 * angle[0], 0.5, angle[39]}) {
        MultipleScatteringSlice(r, theta).coefficients(angle[42], std::numbers::pi, c);
        EXPECT_EQ(c[0], 0) << theta;
        MultipleScatteringSlice(r, angle[42]).coefficients(theta, std::numbers::pi, c);
        EXPECT_EQ(c[0], 0) << theta;
    }
    // No jump where the orders begin, and all of them where they are.
    MultipleScatteringSlice(r, angle[39] + 1e-9).coefficients(angle[42], std::numbers::pi, c);
    EXPECT_NEAR(c[0] * r.basis[0], 0, 1e-9 * 2 * 400 * 100);  // slopes of polynomials: 1/spacing
    MultipleScatteringSlice(r, angle[41]).coefficients(angle[42], std::numbers::pi, c);
    EXPECT_NEAR(c[0] * r.basis[0], 2 * 399, 1e-3);
}

TEST(MultipleScattering, DividedByALobeSmallValuesErrLess) {
    // A Gaussian in the half vector's slope of a coat's inside, as flakes reflect, over a floor of
    // 1e-4: one order, 24 nodes.
    const double width = 0.2, floor = 1e-4;
    const auto f = [&](double a, double b) {
        const double slope =
            (std::tan(std::asin(std::sin(a) / 1.5)) - std::tan(std::asin(std::sin(b) / 1.5))) /
            width;
        return std::exp(-slope * slope) + floor;
    };
    const std::vector<double> angle = make_directions(1.5, 20, 8).exit_angle;
    std::vector<double> values;
    for (int i = 0; i < 20; ++i) {
        for (int j = 0; j <= i; ++j) values.push_back(f(angle[i], angle[j]));
    }
    MultipleScattering r = compress(angle, {0}, 1, values, 1e-9);
    const auto worst = [&](double lobe_width) {
        r.lobe_width = lobe_width;
        double small = 0, large = 0;  // relative errors of small values, absolute ones of all
        std::vector<double> c(1);
        for (double a = 0; a < 1.5; a += 0.031) {
            const MultipleScatteringSlice slice(r, a);
            for (double b = 0; b < 1.5; b += 0.017) {
                slice.coefficients(b, 1.0, c);
                const double exact = f(a, b), error = std::abs(c[0] * r.basis[0] - exact);
                large = nacre::test::worse(large, error);
                if (exact < 1e-3) small = nacre::test::worse(small, error / exact);
            }
        }
        return std::pair(small, large);
    };
    const auto [small, large] = worst(0);
    const auto [small_by_lobe, large_by_lobe] = worst(1.5 * width * std::sqrt(3.0));
    EXPECT_GT(small, 0.05);  // a polynomial alone
    EXPECT_LT(small_by_lobe, 0.1 * small);
    EXPECT_LT(large_by_lobe, large);
}

TEST(MultipleScattering, IsReciprocalBetweenNodesToo) {
    const Example example(0.01);
    MultipleScattering r =
        compress(example.angle, example.first, example.wavelengths, example.values, 1e-3);
    r.lobe_width = 0.5;
    std::vector<double> there(r.rank()), back(r.rank());
    MultipleScatteringSlice(r, 0.37).coefficients(1.21, 2.0, there);
    MultipleScatteringSlice(r, 1.21).coefficients(0.37, -2.0, back);
    for (int k = 0; k < r.rank(); ++k) {
        EXPECT_NEAR(there[k], back[k], 1e-12 * example.peak());  // rounding of double sums
    }
}

}  // namespace
}  // namespace nacre::solver
