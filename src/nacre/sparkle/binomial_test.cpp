#include "nacre/sparkle/binomial.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace nacre::sparkle {
namespace {

struct Moments {
    double mean, variance;
};

template <class Draw>
Moments moments_of(int draws, Draw&& draw) {
    double sum = 0, squares = 0;
    for (int i = 0; i < draws; ++i) {
        const double x = draw(hash_of(7, i));
        sum += x;
        squares += x * x;
    }
    const double mean = sum / draws;
    return {mean, squares / draws - mean * mean};
}

// Five standard errors of the mean and of the variance of bell-shaped numbers.
void expect_binomial(const Moments& found, double n, double p, int draws) {
    const double variance = n * p * (1 - p);
    EXPECT_NEAR(found.mean, n * p, 5 * std::sqrt(variance / draws)) << "n " << n << " p " << p;
    // A skewed law of few successes has a heavier fourth moment, by 1/variance.
    EXPECT_NEAR(found.variance, variance,
                5 * variance * std::sqrt((2 + 1 / variance) / draws) + kBinomialVarianceError)
        << "n " << n << " p " << p;
}

TEST(Binomial, CoinsHaveTheMeanAndVarianceOfTheLaw) {
    constexpr int kDraws = 100000;
    for (const double n : {1.0, 2.0, 63.0, 64.0, 65.0, 200.0, 256.0, 257.0, 1e4, 1e9, 1e15}) {
        // Counted from half: the square of 5e14 has no digits left for the variance.
        const Moments found = moments_of(kDraws, [&](std::uint64_t key) {
            return static_cast<double>(half_binomial(static_cast<std::uint64_t>(n), key)) - n / 2;
        });
        expect_binomial({found.mean + n / 2, found.variance}, n, 0.5, kDraws);
    }
}

TEST(Binomial, TrialsHaveTheMeanAndVarianceOfTheLaw) {
    constexpr int kDraws = 100000;
    for (const double n : {1.0, 5.0, 40.0, 1000.0, 1e6, 1e12}) {
        for (const double p : {1e-12, 1e-6, 0.01, 0.14, 0.5, 0.8, 0.999}) {
            if (n * p * (1 - p) * kDraws < 100 || n * p > 1e9) continue;
            expect_binomial(moments_of(kDraws,
                                       [&](std::uint64_t key) {
                                           return static_cast<double>(
                                               binomial(static_cast<std::uint64_t>(n), p, key));
                                       }),
                            n, p, kDraws);
        }
    }
}

TEST(Binomial, FewTrialsFollowTheExactLaw) {
    constexpr int kDraws = 200000, kTrials = 6;
    constexpr double kChance = 0.3;
    std::vector<int> coins(kTrials + 1), trials(kTrials + 1);
    for (int i = 0; i < kDraws; ++i) {
        ++coins[half_binomial(kTrials, hash_of(1, i))];
        ++trials[binomial(kTrials, kChance, hash_of(2, i))];
    }
    double choose = 1;
    for (int k = 0; k <= kTrials; ++k) {
        const auto expect = [&](int found, double p) {
            const double odds = choose * std::pow(p, k) * std::pow(1 - p, kTrials - k);
            EXPECT_NEAR(found, kDraws * odds, 5 * std::sqrt(kDraws * odds)) << k;
        };
        expect(coins[k], 0.5);
        expect(trials[k], kChance);
        choose *= static_cast<double>(kTrials - k) / (k + 1);
    }
}

TEST(Binomial, CertaintyIsKept) {
    for (const std::uint64_t n : {0ull, 1ull, 100ull, 1000000000000ull}) {
        EXPECT_EQ(binomial(n, 0, 3), 0u);
        EXPECT_EQ(binomial(n, 1, 3), n);
        EXPECT_LE(half_binomial(n, 3), n);
    }
}

TEST(Binomial, TheSameKeyGivesTheSameNumber) {
    int changes = 0;
    for (std::uint64_t key = 0; key < 100; ++key) {
        EXPECT_EQ(binomial(1000, 0.2, key), binomial(1000, 0.2, key));
        changes += binomial(1000, 0.2, key) != binomial(1000, 0.2, key + 1);
    }
    EXPECT_GT(changes, 80);  // neighbouring keys share nothing
}

}  // namespace
}  // namespace nacre::sparkle
