#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

// Random numbers that do not depend on the order of evaluation: a generator is made from a seed
// and a stream (say, a pixel), a hash turns the identity of a thing (cell, slot, seed) into bits.
// Nothing here is global, so results are the same for any number of threads.

namespace nacre {

/// An unsigned integer of so many bits, or a vector of such integers (core/lanes.h).
template <class U, int bits>
concept UnsignedBits = (std::unsigned_integral<U> && 8 * sizeof(U) == bits) || requires(U x) {
    requires std::unsigned_integral<std::remove_cvref_t<decltype(x[0])>>;
    requires 8 * sizeof(x[0]) == bits;
};

/// Bijective scrambling of 64 bits, or of those in each lane: the output function of SplitMix64.
/// [steele-2014; the constants are those of variant 13 of Stafford]
template <UnsignedBits<64> U>
constexpr U mix_bits(U x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

/// The same for 32 bits, in lanes half as wide and hence at half the cost: every input bit flips
/// each output bit half of the time. The constants are those of `lowbias32`.      [wellons-2018]
template <UnsignedBits<32> U>
constexpr U mix_bits_32(U x) {
    x = (x ^ (x >> 16)) * 0x7feb352du;
    x = (x ^ (x >> 15)) * 0x846ca68bu;
    return x ^ (x >> 16);
}

/// Hash of several integers; depends on their order and on their number.
template <std::integral... Ints>
constexpr std::uint64_t hash_of(Ints... values) {
    // The odd increment is 2^64 / golden ratio, as in SplitMix64: it separates equal values.
    std::uint64_t h = sizeof...(values);
    ((h = mix_bits((h ^ static_cast<std::uint64_t>(values)) + 0x9e3779b97f4a7c15u)), ...);
    return h;
}

/// The top 53 (24) bits as a multiple of 2^-53 (2^-24) in [0, 1): never rounds up to 1.
constexpr double to_unit_double(std::uint64_t bits) {
    return static_cast<double>(bits >> 11) * 0x1p-53;
}
constexpr float to_unit_float(std::uint32_t bits) {
    return static_cast<float>(bits >> 8) * 0x1p-24f;
}

/// PCG-XSH-RR 64/32: period 2^64, 2^63 streams.                    [oneill-2014, section 6.3]
/// A UniformRandomBitGenerator. Not for cryptography.
class Rng {
 public:
    using result_type = std::uint32_t;

    /// Seed and stream are hashed first, so that generators of neighbouring seeds, streams or
    /// pixels are uncorrelated.
    explicit constexpr Rng(std::uint64_t seed, std::uint64_t stream = 0)
        : state_(hash_of(seed, stream)), increment_(2 * hash_of(stream, seed) + 1) {
        next_u32();
    }

    constexpr std::uint32_t next_u32() {
        const std::uint64_t old = state_;
        state_ = old * 6364136223846793005u + increment_;
        const auto shifted = static_cast<std::uint32_t>(((old >> 18) ^ old) >> 27);
        const auto turn = static_cast<std::uint32_t>(old >> 59);
        return (shifted >> turn) | (shifted << ((32 - turn) & 31));
    }
    constexpr std::uint64_t next_u64() {
        const std::uint64_t high = next_u32();
        return high << 32 | next_u32();
    }

    constexpr float uniform_float() { return to_unit_float(next_u32()); }     ///< in [0, 1)
    constexpr double uniform_double() { return to_unit_double(next_u64()); }  ///< in [0, 1)

    static constexpr std::uint32_t min() { return 0; }
    static constexpr std::uint32_t max() { return std::numeric_limits<std::uint32_t>::max(); }
    constexpr std::uint32_t operator()() { return next_u32(); }

 private:
    std::uint64_t state_, increment_;
};

/// The digits of `index` in a base, mirrored at the radix point: 6 = 110 in base 2 becomes 0.011 =
/// 3/8. In one base the sequence over indices is van der Corput's, in several Halton's.
/// [halton-1960]
/// @param base  >= 2
/// @return in [0, 1)
inline double radical_inverse(std::size_t index, unsigned base) {
    double value = 0, digit = 1.0 / base;
    for (; index > 0; index /= base, digit /= base) {
        value += digit * static_cast<double>(index % base);
    }
    return value;
}

/// A low-discrepancy set in the unit cube, the same one for the same seed: Halton's sequence
/// [halton-1960], in base 2 for the first coordinate, 3 for the second, 5, 7, ..., without its
/// point 0, each coordinate shifted modulo 1 by a random offset [cranley-patterson-1976].
/// @param dimensions  1 to kMaxHaltonDimensions @throws DomainError
std::vector<std::vector<double>> halton_points(std::size_t count, std::size_t dimensions,
                                               std::uint64_t seed);

/// Bases grow with the dimension, and the first points of large bases lie in a line.
inline constexpr std::size_t kMaxHaltonDimensions = 24;

}  // namespace nacre
