#pragma once

#include <array>
#include <cstdint>

#include "nacre/core/lanes.h"
#include "nacre/core/random.h"

// Low-discrepancy numbers for the paths of one pixel: padded (0,2)-sequences.
//
// A path needs many numbers; we take them in pairs, each pair from the two-dimensional Sobol
// sequence, scrambled after Owen and shuffled by a hash of (seed, pixel, vertex, pair). So each
// pair is evenly spread over any power of two of samples, pairs are independent of each other, and
// so are pixels.                                                       [burley-2020]
//
// Four pairs, all that one vertex of a path needs, are drawn at once in the lanes of a vector.

namespace nacre::render {

namespace sampler_detail {

inline UintLanes reverse_bits(UintLanes x) {
    x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
    x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
    x = ((x >> 4) & 0x0F0F0F0Fu) | ((x & 0x0F0F0F0Fu) << 4);
    x = ((x >> 8) & 0x00FF00FFu) | ((x & 0x00FF00FFu) << 8);
    return (x >> 16) | (x << 16);
}

/// A hash in which every bit depends on the lower ones only: applied to bits in reversed order it
/// is an Owen scramble.                                   [burley-2020; laine-2011-lk]
inline UintLanes laine_karras(UintLanes x, UintLanes seed) {
    x += seed;
    x ^= x * 0x6C50B47Cu;
    x ^= x * 0xB82F1E52u;
    x ^= x * 0xC7AFE638u;
    x ^= x * 0x8D22F6E6u;
    return x;
}

/// Product with the Pascal triangle modulo 2, the generator matrix of the second Sobol dimension
/// in reversed bit order: bit i becomes the sum of the bits j whose binomial (j over i) is odd,
/// that is (Lucas) of those whose index contains i's, which five steps add up.
inline UintLanes pascal(UintLanes x) {
    x ^= (x >> 1) & 0x55555555u;
    x ^= (x >> 2) & 0x33333333u;
    x ^= (x >> 4) & 0x0F0F0F0Fu;
    x ^= (x >> 8) & 0x00FF00FFu;
    x ^= (x >> 16) & 0x0000FFFFu;
    return x;
}

}  // namespace sampler_detail

/// The numbers of one path.
class PathSampler {
 public:
    static constexpr int kNumbers = kLanes;

    PathSampler(std::uint64_t seed, std::uint32_t pixel, std::uint32_t sample_index)
        : sample_index_(sample_index) {
        const auto low = static_cast<std::uint32_t>(seed);
        const auto high = static_cast<std::uint32_t>(seed >> 32);
        base_ = mix_bits_32(pixel ^ mix_bits_32(low ^ mix_bits_32(high + 0x9E3779B9u)));
    }

    /// Eight numbers in [0, 1) for vertex `vertex` of the path (0: the camera): elements 2 p and
    /// 2 p + 1 form pair p, a (0,2)-sequence over the sample index.
    std::array<float, kNumbers> draw(std::uint32_t vertex) const {
        using namespace sampler_detail;
        static_assert(kLanes == 8);
        constexpr UintLanes kPair{0, 0, 1, 1, 2, 2, 3, 3};
        constexpr UintLanes kLane{0, 1, 2, 3, 4, 5, 6, 7};
        constexpr UintLanes kSecond{0, ~0u, 0, ~0u, 0, ~0u, 0, ~0u};
        const std::uint32_t vertex_base = mix_bits_32(base_ + vertex * 0x9E3779B9u);
        const UintLanes shuffle_seed = mix_bits_32(kPair * 0x85EBCA6Bu + vertex_base);
        const UintLanes scramble_seed = mix_bits_32((kLane + 4u) * 0xC2B2AE35u + vertex_base);
        // Shuffling acts on the index from its highest bit down, scrambling on the value from its
        // highest bit down, which is the index's lowest: the bit reversals cancel but for these.
        const UintLanes index = UintLanes{} + sample_index_;
        const UintLanes shuffled = reverse_bits(laine_karras(reverse_bits(index), shuffle_seed));
        const UintLanes sobol = (pascal(shuffled) & kSecond) | (shuffled & ~kSecond);
        const UintLanes bits = reverse_bits(laine_karras(sobol, scramble_seed)) >> 8;
        std::array<float, kNumbers> u;
        for (int i = 0; i < kNumbers; ++i) u[i] = static_cast<float>(bits[i]) * 0x1p-24f;
        return u;
    }

 private:
    std::uint32_t sample_index_, base_;
};

}  // namespace nacre::render
