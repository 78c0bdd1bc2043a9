#pragma once

#ifdef __AVX2__
#include <immintrin.h>
#endif

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

/// table[index] in each lane.
inline FloatLanes gather_lanes(const float* table, UintLanes index) {
#ifdef __AVX2__
    return std::bit_cast<FloatLanes>(
        _mm256_i32gather_ps(table, std::bit_cast<__m256i>(index), sizeof(float)));
#else
    return make_lanes([&](int i) { return table[index[i]]; });
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

/// Calls visit(lane) for each lane whose bits are set; one test where none is.
template <class Mask, class Visit>
inline void for_each_set_lane(const Mask& mask, Visit&& visit) {
    using ByteLanes = signed char __attribute__((vector_size(kLanes)));
    constexpr ByteLanes kOne = {1, 1, 1, 1, 1, 1, 1, 1};
    // One byte a lane, so that nothing is done for those that are not set.
    const ByteLanes bytes = __builtin_convertvector(mask, ByteLanes) & kOne;
    std::uint64_t bits;
    std::memcpy(&bits, &bytes, sizeof bits);
    for (; bits != 0; bits &= bits - 1) visit(std::countr_zero(bits) / 8);
}

/// Moves the set lanes of several vectors together at their beginning: with AVX-512 without a
/// branch, which would be mispredicted.
class LanePacker {
 public:
    explicit LanePacker(const LaneMask& mask) {
#ifdef __AVX512VL__
        mask_ = _mm256_movepi32_mask(std::bit_cast<__m256i>(mask));
        count_ = std::popcount(static_cast<unsigned>(mask_));
#else
        for_each_set_lane(mask, [&](int lane) { lane_[count_++] = lane; });
#endif
    }
    int count() const { return count_; }

    /// Writes count() numbers; those after them, up to eight, may be overwritten.
    void store(float* out, FloatLanes v) const {
#ifdef __AVX512VL__
        store_lanes(out, std::bit_cast<FloatLanes>(
                             _mm256_maskz_compress_ps(mask_, std::bit_cast<__m256>(v))));
#else
        for (int i = 0; i < count_; ++i) out[i] = v[lane_[i]];
#endif
    }
    void store(std::uint32_t* out, UintLanes v) const {
#ifdef __AVX512VL__
        store_lanes(out, std::bit_cast<UintLanes>(
                             _mm256_maskz_compress_epi32(mask_, std::bit_cast<__m256i>(v))));
#else
        for (int i = 0; i < count_; ++i) out[i] = v[lane_[i]];
#endif
    }

 private:
    int count_ = 0;
#ifdef __AVX512VL__
    __mmask8 mask_;
#else
    int lane_[kLanes];
#endif
};

}  // namespace nacre::sparkle
