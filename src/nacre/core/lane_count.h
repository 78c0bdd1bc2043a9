#pragma once

#include <bit>

#include "nacre/core/lanes.h"

namespace nacre {

/// A bit for each lane, set if a comparison holds there; the first lane's is the lowest.
inline unsigned lane_bits(const IntLanes& holds) {
#ifdef __AVX__
    // Of the loop below compilers make one that takes the lanes out one by one.
    return static_cast<unsigned>(__builtin_ia32_movmskps256(std::bit_cast<FloatLanes>(holds)));
#else
    unsigned bits = 0;
    for (int i = 0; i < kLanes; ++i) bits |= (holds[i] != 0 ? 1u : 0u) << i;
    return bits;
#endif
}
/// For how many lanes a comparison holds.
inline int count_lanes(const IntLanes& holds) { return std::popcount(lane_bits(holds)); }
/// The first lane for which it holds; kLanes: for none.
inline int first_lane(const IntLanes& holds) {
    return std::countr_zero(lane_bits(holds) | 1u << kLanes);
}

}  // namespace nacre
