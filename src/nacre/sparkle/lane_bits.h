#pragma once

#ifdef __AVX2__
#include <immintrin.h>
#endif

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

#include "nacre/core/lane_math.h"
#include "nacre/core/lanes.h"

// Random bits of eight facets at a time, and the Gaussian slopes made of them.

namespace nacre::sparkle {

using BitLanes = std::uint64_t __attribute__((vector_size(kLanes * sizeof(std::uint64_t))));

struct SlopeLanes {
    FloatLanes x, y;
};

/// Two slopes of density exp(-x^2 - y^2) / pi, by Box and Muller's transform of two numbers even in
/// (0, 1): r^2 = -ln u.                                           [walter-2007, eq. 28-29]
inline SlopeLanes gaussian_slopes(FloatLanes fraction, FloatLanes turns) {
    const FloatLanes r = sqrt_lanes(max_lanes(-log_lanes(fraction), FloatLanes{}));
    const auto wave = cos_sin_turns(turns);
    return {r * wave.cosine, r * wave.sine};
}

/// The same from the upper and the lower half of each lane's bits; slopes end at 4.74.
inline SlopeLanes gaussian_slopes(BitLanes bits) {
    return gaussian_slopes((__builtin_convertvector(bits >> 32, FloatLanes) + 0.5f) * 0x1p-32f,
                           __builtin_convertvector(bits & 0xffffffffu, FloatLanes) * 0x1p-32f);
}

}  // namespace nacre::sparkle

// 32 random bits in each of eight lanes; visiting and packing those of eight lanes that a mask selects.

namespace nacre::sparkle {

/// The lanes that are set in the result of a comparison of floats.
using LaneMask = int __attribute__((vector_size(kLanes * sizeof(int))));

inline UintLanes load_short_bits(const std::uint32_t* p) {
    UintLanes v;
    std::memcpy(&v, p, sizeof v);
    return v;
}

/// eight[at] in each lane.
inline FloatLanes pick_lanes(const FloatLanes& eight, const IntLanes& at) {
#ifdef __AVX2__
    return std::bit_cast<FloatLanes>(
        _mm256_permutevar8x32_ps(std::bit_cast<__m256>(eight), std::bit_cast<__m256i>(at)));
#else
    return make_lanes([&](int i) { return eight[at[i]]; });
#endif
}

/// The upper 31 of each lane's bits as a number in (0, 1).
inline FloatLanes unit_fraction(UintLanes bits) {
    return (__builtin_convertvector(std::bit_cast<LaneMask>(bits >> 1), FloatLanes) + 0.5f) *
           0x1p-31f;
}

/// The lower and the upper half of each lane's bits as numbers in [0, 65536).
inline FloatLanes lower_half(UintLanes bits) {
    return __builtin_convertvector(std::bit_cast<LaneMask>(bits & 0xffffu), FloatLanes);
}
inline FloatLanes upper_half(UintLanes bits) {
    return __builtin_convertvector(std::bit_cast<LaneMask>(bits >> 16), FloatLanes);
}

/// Calls visit(lane) for each lane whose bits are set.
template <class Visit>
inline void for_each_set_lane(const LaneMask& mask, Visit&& visit) {
    for (unsigned bits = lane_bits(mask); bits != 0; bits &= bits - 1)
        visit(std::countr_zero(bits));
}

namespace detail {

// By the bits of lane_bits(): the lanes that are set, one a byte, the first lowest.
inline constexpr std::array<std::uint64_t, 1 << kLanes> kSetLanes = [] {
    std::array<std::uint64_t, 1 << kLanes> lanes{};
    for (unsigned bits = 0; bits < lanes.size(); ++bits) {
        int count = 0;
        for (unsigned rest = bits; rest != 0; rest &= rest - 1)
            lanes[bits] |= static_cast<std::uint64_t>(std::countr_zero(rest)) << (8 * count++);
    }
    return lanes;
}();

}  // namespace detail

/// Moves the set lanes of several vectors together at their beginning, without a branch, which would
/// be mispredicted.
class LanePacker {
 public:
    explicit LanePacker(const LaneMask& mask)
        : bits_(lane_bits(mask)),
          count_(std::popcount(bits_))
#ifdef __AVX2__
          ,
          lanes_(_mm256_cvtepu8_epi32(
              _mm_cvtsi64_si128(static_cast<long long>(detail::kSetLanes[bits_]))))
#endif
    {
    }
    int count() const { return count_; }

    /// Writes count() numbers; those after them, up to eight, may be overwritten.
    void store(float* out, const FloatLanes& v) const { store_lanes(out, packed(v)); }
    void store(std::uint32_t* out, const UintLanes& v) const { store_lanes(out, packed(v)); }

 private:
    template <class V>
    V packed(const V& v) const {
#ifdef __AVX2__
        return std::bit_cast<V>(_mm256_permutevar8x32_epi32(std::bit_cast<__m256i>(v), lanes_));
#else
        const std::uint64_t lanes = detail::kSetLanes[bits_];
        return make_lanes<V>([&](int i) { return v[lanes >> (8 * i) & 7]; });
#endif
    }

    unsigned bits_;
    int count_;
#ifdef __AVX2__
    __m256i lanes_;
#endif
};

}  // namespace nacre::sparkle
