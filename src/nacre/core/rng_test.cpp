#include "nacre/core/rng.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <set>
#include <vector>

namespace nacre {
namespace {

static_assert(std::uniform_random_bit_generator<Rng>);

TEST(UnitInterval, LargestBitsStayBelowOne) {
    EXPECT_LT(to_unit_double(~std::uint64_t{0}), 1.0);
    EXPECT_LT(to_unit_float(~std::uint32_t{0}), 1.0f);
    EXPECT_EQ(to_unit_double(0), 0.0);
    EXPECT_EQ(to_unit_float(0), 0.0f);
}

// First output of SplitMix64 seeded with 0, as published with the xoshiro generators' seeder.
TEST(MixBits, MatchesSplitMix64) { EXPECT_EQ(mix_bits(0x9e3779b97f4a7c15u), 0xe220a8397b1dcdafu); }

// "Round 1" of the demonstration program at pcg-random.org: initial state 42, sequence 54. The
// published seeding is a step from 0, the addition of the state, and another step.
TEST(Rng, MatchesThePublishedPcg32Sequence) {
    const std::uint64_t increment = 2 * 54 + 1;
    Rng rng = Rng::from_state(increment + 42, increment);
    rng.next_u32();
    for (std::uint32_t published :
         {0xa15c02b7u, 0x7b47f409u, 0xba1d3330u, 0x83d2f293u, 0xbfa4784bu, 0xcbed606eu}) {
        EXPECT_EQ(rng.next_u32(), published);
    }
}

TEST(Rng, SameSeedAndStreamGiveTheSameNumbers) {
    Rng a(7, 3), b(7, 3);
    for (int i = 0; i < 100; ++i) ASSERT_EQ(a.next_u32(), b.next_u32());
}

// 64 bits from each of 10^4 generators: a coincidence has probability 3e-12.
TEST(Rng, NeighbouringSeedsAndStreamsDiffer) {
    std::set<std::uint64_t> seen;
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        for (std::uint64_t stream = 0; stream < 100; ++stream) {
            seen.insert(Rng(seed, stream).next_u64());
        }
    }
    EXPECT_EQ(seen.size(), 10000u);
}

TEST(Hash, DependsOnOrderAndNumberOfItsArguments) {
    EXPECT_NE(hash_of(1, 2), hash_of(2, 1));
    EXPECT_NE(hash_of(0), hash_of(0, 0));
    EXPECT_NE(hash_of(1, 2, 3), hash_of(1, 2, 4));
    static_assert(hash_of(1, 2) == hash_of(1, 2));
}

// Flipping any input bit flips each output bit with probability 1/2: over 64 x 200 trials the
// frequency is within 5 standard deviations, 5 / (2 sqrt(200 * 64)) = 0.022 on average per output.
TEST(Hash, EveryInputBitAvalanches) {
    Rng rng(11);
    std::array<int, 64> flips{};
    const int trials = 200;
    for (int t = 0; t < trials; ++t) {
        const std::uint64_t x = rng.next_u64();
        for (int bit = 0; bit < 64; ++bit) {
            const std::uint64_t change = hash_of(x, 5) ^ hash_of(x ^ (std::uint64_t{1} << bit), 5);
            for (int out = 0; out < 64; ++out) flips[out] += change >> out & 1;
        }
    }
    for (int out = 0; out < 64; ++out) EXPECT_NEAR(flips[out] / (64.0 * trials), 0.5, 0.022) << out;
}

// Chi-square over 64 bins, 1e5 numbers: 63 degrees of freedom, 1e-6 quantile 126.
TEST(Rng, NumbersAreUniformWithinAndAcrossStreams) {
    const int bins = 64, count = 100000;
    std::vector<double> within(bins), across(bins);
    Rng one(1);
    for (int i = 0; i < count; ++i) {
        ++within[static_cast<int>(one.uniform_double() * bins)];
        Rng fresh(1, i);
        ++across[static_cast<int>(fresh.uniform_float() * bins)];
    }
    const double expected = static_cast<double>(count) / bins;
    double chi2_within = 0, chi2_across = 0;
    for (int b = 0; b < bins; ++b) {
        chi2_within += std::pow(within[b] - expected, 2) / expected;
        chi2_across += std::pow(across[b] - expected, 2) / expected;
    }
    EXPECT_LT(chi2_within, 126);
    EXPECT_LT(chi2_across, 126);
}

}  // namespace
}  // namespace nacre
