#include "nacre/core/random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <random>
#include <set>
#include <vector>

#include "nacre/core/error.h"

namespace nacre {
namespace {

static_assert(std::uniform_random_bit_generator<Rng>);

TEST(UnitInterval, LargestBitsStayBelowOne) {
    EXPECT_LT(to_unit_double(~std::uint64_t{0}), 1.0);
    EXPECT_LT(to_unit_float(~std::uint32_t{0}), 1.0f);
    EXPECT_EQ(to_unit_double(0), 0.0);
    EXPECT_EQ(to_unit_float(0), 0.0f);
}

// By a program of three lines in another language.
TEST(MixBits, MatchesLowbias32) {
    EXPECT_EQ(mix_bits_32(1u), 0x688990c0u);
    EXPECT_EQ(mix_bits_32(0xdeadbeefu), 0xe628c683u);
}

// First output of SplitMix64 seeded with 0, as published with the xoshiro generators' seeder.
TEST(MixBits, MatchesSplitMix64) { EXPECT_EQ(mix_bits(0x9e3779b97f4a7c15u), 0xe220a8397b1dcdafu); }

// The minimal implementation that its author publishes at pcg-random.org.
struct PublishedPcg32 {
    std::uint64_t state, increment;
    std::uint32_t next() {
        const std::uint64_t old = state;
        state = old * 6364136223846793005ULL + increment;
        const auto xorshifted = static_cast<std::uint32_t>(((old >> 18u) ^ old) >> 27u);
        return std::rotr(xorshifted, static_cast<int>(old >> 59u));
    }
};

// "Round 1" of the demonstration program there: initial state 42, sequence 54. The published
// seeding is a step from 0, the addition of the state, and another step.
TEST(Rng, IsPcg32WithHashedSeedAndStream) {
    const std::uint64_t increment = 2 * 54 + 1;
    PublishedPcg32 pcg{increment + 42, increment};
    pcg.next();
    for (std::uint32_t published :
         {0xa15c02b7u, 0x7b47f409u, 0xba1d3330u, 0x83d2f293u, 0xbfa4784bu, 0xcbed606eu}) {
        EXPECT_EQ(pcg.next(), published);
    }
    pcg = {hash_of(std::uint64_t{42}, std::uint64_t{54}),
           2 * hash_of(std::uint64_t{54}, std::uint64_t{42}) + 1};
    pcg.next();
    Rng rng(42, 54);
    for (int i = 0; i < 1000; ++i) ASSERT_EQ(rng.next_u32(), pcg.next()) << i;
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

TEST(RadicalInverse, MirrorsDigitsAtThePoint) {
    EXPECT_EQ(radical_inverse(0, 2), 0);
    EXPECT_EQ(radical_inverse(1, 2), 0.5);
    EXPECT_EQ(radical_inverse(6, 2), 0.375);                       // 110 -> 0.011
    EXPECT_NEAR(radical_inverse(7, 3), 1 / 3.0 + 2 / 9.0, 1e-15);  // 21 -> 0.12
}

// Any b^k indices in a row from a multiple of b^k on fall into different intervals of b^-k.
TEST(RadicalInverse, FillsTheIntervalEvenly) {
    constexpr unsigned kBase = 5, kCount = 125;
    bool taken[kCount] = {};
    for (unsigned i = 0; i < kCount; ++i) {
        // 3/5^4 above the interval's lower end: rounding does not reach it.
        const auto cell = static_cast<unsigned>(radical_inverse(3 * kCount + i, kBase) * kCount);
        ASSERT_LT(cell, kCount);
        EXPECT_FALSE(taken[cell]) << i;
        taken[cell] = true;
    }
}

// In base 2 any 64 consecutive points fall one each into 64 equal intervals; after a shift modulo 1
// neighbours are still at most two intervals apart.
TEST(Halton, FillsTheFirstAxisEvenly) {
    const auto points = halton_points(64, 2, 7);
    std::vector<double> along;
    for (const auto& point : points) along.push_back(point[0]);
    std::sort(along.begin(), along.end());
    EXPECT_GE(along.front(), 0);
    EXPECT_LT(along.back(), 1);
    for (std::size_t i = 1; i < along.size(); ++i) EXPECT_LE(along[i] - along[i - 1], 2.0 / 64);
}

TEST(Halton, IsShiftedByTheSeedAndByNothingElse) {
    EXPECT_EQ(halton_points(5, 3, 1), halton_points(5, 3, 1));
    const auto a = halton_points(2, 1, 1), b = halton_points(2, 1, 2);
    EXPECT_NE(a, b);
    // 1/2 and 1/4, shifted.
    const double step = a[0][0] - a[1][0];
    EXPECT_NEAR(step - std::floor(step), 0.25, 1e-15);
}

TEST(Halton, RefusesDimensionsWithoutABase) {
    EXPECT_THROW(halton_points(1, 0, 0), DomainError);
    EXPECT_THROW(halton_points(1, 25, 0), DomainError);
}

}  // namespace
}  // namespace nacre
