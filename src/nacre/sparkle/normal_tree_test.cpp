#include "nacre/sparkle/normal_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/sparkle/facet_field.h"
#include "nacre/testing/statistics.h"

namespace nacre::sparkle {
namespace {

using test::Moments;

template <class Draw>
Moments moments_of(int draws, Draw&& draw) {
    std::vector<double> values(draws);
    for (int i = 0; i < draws; ++i) values[i] = draw(hash_of(7, i));
    return Moments(values);
}

// Five standard errors of the mean and of the variance of bell-shaped numbers.
// @param offset  what was subtracted from the numbers, so that their variance keeps its digits
void expect_binomial(const Moments& found, double n, double p, int draws, double offset = 0) {
    const double variance = n * p * (1 - p);
    EXPECT_NEAR(found.mean + offset, n * p, 5 * std::sqrt(variance / draws))
        << "n " << n << " p " << p;
    // A skewed law of few successes has a heavier fourth moment, by 1/variance.
    EXPECT_NEAR(found.variance, variance,
                5 * variance * std::sqrt((2 + 1 / variance) / draws) + kBinomialVarianceError)
        << "n " << n << " p " << p;
}

TEST(Binomial, FairTrialsHaveTheMeanAndVarianceOfTheLaw) {
    constexpr int kDraws = 100000;
    for (const double n : {1.0, 2.0, 63.0, 64.0, 65.0, 200.0, 256.0, 257.0, 1e4, 1e9, 1e15}) {
        // Counted from half: the square of 5e14 has no digits left for the variance.
        const Moments found = moments_of(kDraws, [&](std::uint64_t key) {
            return static_cast<double>(half_binomial(static_cast<std::uint64_t>(n), key)) - n / 2;
        });
        expect_binomial(found, n, 0.5, kDraws, n / 2);
    }
}

TEST(Binomial, TrialsHaveTheMeanAndVarianceOfTheLaw) {
    constexpr int kDraws = 100000;
    int laws = 0;
    for (const double n : {1.0, 5.0, 40.0, 1000.0, 1e6, 1e12}) {
        for (const double p : {1e-12, 1e-6, 0.01, 0.14, 0.5, 0.8, 0.999}) {
            if (n * p * (1 - p) * kDraws < 100 || n * p > 1e9) continue;
            ++laws;
            expect_binomial(moments_of(kDraws,
                                       [&](std::uint64_t key) {
                                           return static_cast<double>(
                                               binomial(static_cast<std::uint64_t>(n), p, key));
                                       }),
                            n, p, kDraws);
        }
    }
    EXPECT_GT(laws, 20);
}

TEST(Binomial, FewTrialsFollowTheExactLaw) {
    constexpr int kDraws = 200000, kTrials = 6;
    constexpr double kProbability = 0.3;
    std::vector<int> fair(kTrials + 1), biased(kTrials + 1);
    for (int i = 0; i < kDraws; ++i) {
        ++fair[half_binomial(kTrials, hash_of(1, i))];
        ++biased[binomial(kTrials, kProbability, hash_of(2, i))];
    }
    double choose = 1;
    for (int k = 0; k <= kTrials; ++k) {
        const auto expect = [&](int found, double p) {
            const double probability = choose * std::pow(p, k) * std::pow(1 - p, kTrials - k);
            EXPECT_NEAR(found, kDraws * probability, 5 * std::sqrt(kDraws * probability)) << k;
        };
        expect(fair[k], 0.5);
        expect(biased[k], kProbability);
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

TEST(NormalTree, MassesAreThoseOfSampledNormals) {
    constexpr double kFacets = 200000;
    for (const double alpha : {0.02, 0.07, 0.5}) {
        const NormalTree tree(alpha, 0.05);
        const FacetField field(kFacets, alpha, 3, 1);
        std::map<NormalTree::Code, double> found;
        field.for_each_facet({0.5, 0.5, {1, 0}, {0, 1}},
                             [&](const Facet& f) { ++found[tree.locate(f.normal)]; });
        // Pearson's statistic over the triangles where enough is expected.
        double chi2 = 0, cells = 0, mass = 0;
        for (const auto& [leaf, count] : found) {
            const double expected = kFacets * tree.mass(leaf);
            mass += tree.mass(leaf);
            if (expected < 10) continue;
            chi2 += (count - expected) * (count - expected) / expected;
            ++cells;
        }
        EXPECT_GT(cells, 10);
        EXPECT_NEAR(mass, 1, 2e-3);  // found: 5e-4, where no facet is
        EXPECT_LT(chi2, cells + 5 * std::sqrt(2 * cells)) << "alpha " << alpha;
    }
}

TEST(NormalTree, SplitsKeepEveryFacet) {
    const NormalTree tree(0.1, 0.05);
    for (std::uint64_t key = 0; key < 50; ++key) {
        for (const std::uint64_t n : {0ull, 1ull, 77ull, 100000ull, 100000000000ull}) {
            const auto octants = NormalTree::split_octants(n, key);
            EXPECT_EQ(octants.count[0] + octants.count[1] + octants.count[2] + octants.count[3], n);
            const auto parts = tree.split(0, n, key);
            EXPECT_EQ(parts.count[0] + parts.count[1] + parts.count[2] + parts.count[3], n);
            // Asking for less gives the same.
            for (int part = 0; part < 4; ++part) {
                EXPECT_EQ(tree.split(0, n, key, 1u << part).count[part], parts.count[part]);
            }
        }
    }
}

TEST(NormalTree, RefusesValuesOutOfRange) {
    EXPECT_THROW(NormalTree(0, 0.1), DomainError);
    EXPECT_THROW(NormalTree(0.1, 0), DomainError);
    EXPECT_THROW(NormalTree(0.1, NAN), DomainError);
}

}  // namespace
}  // namespace nacre::sparkle
