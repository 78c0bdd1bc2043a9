#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "nacre/core/lanes.h"
#include "nacre/core/random.h"

// Low-discrepancy numbers for the paths of one pixel: padded Sobol sequences.
//
// A path needs many numbers; we take them in threes, each three from the Sobol sequence of that many
// dimensions, scrambled after Owen and shuffled by a hash of (seed, pixel, vertex, three). So a
// place and the choice that goes with it, of a light or of a lobe, are evenly spread together: the
// samples of each lobe as well, and not only those of all. Threes are independent of each other, and
// so are pixels.                                              [burley-2020; joe-kuo-2008]
//
// All that one vertex of a path needs, two threes and a pair, are drawn at once in the lanes of a
// vector.

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

/// The third Sobol dimension of 32-bit indices, in reversed bit order as pascal(), by the bytes of
/// the index. Its direction numbers are m_k = 2 m_(k-1) ^ 4 m_(k-2) ^ m_(k-2), from 1 and 3, of the
/// primitive polynomial x^2 + x + 1.                                 [joe-kuo-2008]
struct ThirdDimension {
    std::array<std::array<std::uint32_t, 256>, 4> byte{};

    constexpr ThirdDimension() {
        std::array<std::uint32_t, 32> m{1, 3}, column{};
        for (int k = 2; k < 32; ++k) m[k] = 2 * m[k - 1] ^ 4 * m[k - 2] ^ m[k - 2];
        for (int k = 0; k < 32; ++k) {
            // m_k 2^-k as digits after the point, the first in bit 0.
            for (int digit = 0; digit <= k; ++digit)
                column[k] |= (m[k] >> (k - digit) & 1u) << digit;
        }
        for (int b = 0; b < 4; ++b) {
            for (std::uint32_t x = 0; x < 256; ++x) {
                for (int bit = 0; bit < 8; ++bit) {
                    if (x >> bit & 1u) byte[b][x] ^= column[8 * b + bit];
                }
            }
        }
    }
    std::uint32_t operator()(std::uint32_t x) const {
        return byte[0][x & 255] ^ byte[1][x >> 8 & 255] ^ byte[2][x >> 16 & 255] ^ byte[3][x >> 24];
    }
};
inline constexpr ThirdDimension kThirdDimension;

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

    /// Eight numbers in [0, 1) for vertex `vertex` of the path (0: the camera): elements 0, 1, 4
    /// and 2, 3, 5 form threes, 6 and 7 a pair. Over the sample index, the first two of each are a
    /// (0,2)-sequence, and a three is a (1,3)-sequence.
    std::array<float, kNumbers> draw(std::uint32_t vertex) const {
        using namespace sampler_detail;
        constexpr UintLanes kSequence{0, 0, 1, 1, 0, 1, 2, 2};
        constexpr UintLanes kLane{0, 1, 2, 3, 4, 5, 6, 7};
        constexpr UintLanes kSecond{0, ~0u, 0, ~0u, 0, 0, 0, ~0u};
        const std::uint32_t vertex_base = base_of(vertex);
        const UintLanes shuffled = shuffle(UintLanes{} + sample_index_,
                                           mix_bits_32(kSequence * kSequenceStep + vertex_base));
        UintLanes sobol = (pascal(shuffled) & kSecond) | (shuffled & ~kSecond);
        for (int third : {4, 5}) sobol[third] = kThirdDimension(shuffled[third]);
        const FloatLanes numbers =
            scramble(sobol, mix_bits_32((kLane + 4u) * kDimensionStep + vertex_base));
        std::array<float, kNumbers> u;
        store_lanes(u.data(), numbers);
        return u;
    }

    /// A three of each of eight paths.
    struct Threes {
        FloatLanes x, y, choice;
    };
    /// The first three, elements 0, 1 and 4 of draw(), of the eight paths for which this one stands
    /// where there are eight times as many: those of all samples are as evenly spread.
    Threes draw_refined(std::uint32_t vertex) const {
        using namespace sampler_detail;
        constexpr UintLanes kLane{0, 1, 2, 3, 4, 5, 6, 7};
        const std::uint32_t vertex_base = base_of(vertex);
        const auto seed = [&](std::uint32_t element) {
            return UintLanes{} + mix_bits_32((element + 4u) * kDimensionStep + vertex_base);
        };
        const UintLanes shuffled =
            shuffle(sample_index_ * kLanes + kLane, UintLanes{} + mix_bits_32(vertex_base));
        UintLanes third;
        for (int i = 0; i < kLanes; ++i) third[i] = kThirdDimension(shuffled[i]);
        return {scramble(shuffled, seed(0)), scramble(pascal(shuffled), seed(1)),
                scramble(third, seed(4))};
    }

 private:
    static constexpr std::uint32_t kSequenceStep = 0x85EBCA6Bu, kDimensionStep = 0xC2B2AE35u;

    std::uint32_t base_of(std::uint32_t vertex) const {
        return mix_bits_32(base_ + vertex * 0x9E3779B9u);
    }
    // Shuffling acts on the index from its highest bit down, scrambling on the value from its
    // highest bit down, which is the index's lowest: the bit reversals cancel but for these.
    static UintLanes shuffle(UintLanes index, UintLanes seed) {
        using namespace sampler_detail;
        return reverse_bits(laine_karras(reverse_bits(index), seed));
    }
    static FloatLanes scramble(UintLanes reversed, UintLanes seed) {
        using namespace sampler_detail;
        // 24 bits fit into a signed number, whose conversion is one instruction on any processor.
        const UintLanes bits = reverse_bits(laine_karras(reversed, seed)) >> 8;
        return to_float(std::bit_cast<IntLanes>(bits)) * 0x1p-24f;
    }

    std::uint32_t sample_index_, base_;
};

}  // namespace nacre::render
