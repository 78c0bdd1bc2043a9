#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

// Wavelengths are the vector lanes. GCC and Clang share the vector extension used here; an
// arithmetic operator on a Lanes value is one machine instruction where the machine has the width
// and several where it has not, with the same result.

namespace nacre {

inline constexpr int kLanes = 8;

using FloatLanes = float __attribute__((vector_size(kLanes * sizeof(float))));
using DoubleLanes = double __attribute__((vector_size(kLanes * sizeof(double))));
using UintLanes = std::uint32_t __attribute__((vector_size(kLanes * sizeof(std::uint32_t))));
using IntLanes = std::int32_t __attribute__((vector_size(kLanes * sizeof(std::int32_t))));

/// All lanes equal to x.
inline FloatLanes splat(float x) { return FloatLanes{} + x; }
inline DoubleLanes splat(double x) { return DoubleLanes{} + x; }

/// Lane i = f(i).
template <class V = FloatLanes, class F>
inline V make_lanes(F&& f) {
    V v{};
    for (int i = 0; i < kLanes; ++i) v[i] = f(i);
    return v;
}

inline FloatLanes load_lanes(const float* p) {
    FloatLanes v;
    std::memcpy(&v, p, sizeof v);
    return v;
}
inline DoubleLanes load_lanes(const double* p) {
    DoubleLanes v;
    std::memcpy(&v, p, sizeof v);
    return v;
}
template <class V, class T>
inline void store_lanes(T* p, const V& v) {
    static_assert(sizeof(T) * kLanes == sizeof(V));
    std::memcpy(p, &v, sizeof v);
}

/// The widest vectors of the machine, in bytes.
#if defined(__AVX512F__)
inline constexpr std::size_t kRegisterBytes = 64;
#elif defined(__AVX__)
inline constexpr std::size_t kRegisterBytes = 32;
#else
inline constexpr std::size_t kRegisterBytes = 16;
#endif

/// The lower half of the lanes (0), or the upper (1).
template <class V>
inline auto half_lanes(const V& a, int which) {
    using Half __attribute__((vector_size(sizeof(V) / 2))) = std::remove_cvref_t<decltype(a[0])>;
    Half half;
    std::memcpy(&half, reinterpret_cast<const char*>(&a) + which * sizeof half, sizeof half);
    return half;
}

/// f, which is a function of one lane of each argument, by as many lanes as a register holds: GCC 12
/// compares the lanes of wider vectors one by one, in four times as many instructions. Numbers are one
/// lane.
template <class F, class V, class... More>
inline V by_registers(F&& f, const V& a, const More&... more) {
    if constexpr (sizeof(V) <= kRegisterBytes) {
        return f(a, more...);
    } else {
        const auto low = by_registers(f, half_lanes(a, 0), half_lanes(more, 0)...);
        const auto high = by_registers(f, half_lanes(a, 1), half_lanes(more, 1)...);
        V both;
        std::memcpy(&both, &low, sizeof low);
        std::memcpy(reinterpret_cast<char*>(&both) + sizeof low, &high, sizeof high);
        return both;
    }
}

/// Larger and smaller of each pair of lanes; b where a is NaN.
template <class V>
inline V max_lanes(V a, V b) {
    return by_registers([](auto x, auto y) { return x > y ? x : y; }, a, b);
}
template <class V>
inline V min_lanes(V a, V b) {
    return by_registers([](auto x, auto y) { return x < y ? x : y; }, a, b);
}
/// Of each lane: a where x > 0, else b.
template <class V>
inline V where_positive(V x, V a, V b) {
    return by_registers([](auto y, auto c, auto d) { return y > 0 ? c : d; }, x, a, b);
}
template <class V>
inline V sqrt_lanes(V a) {
    V r;
    for (int i = 0; i < kLanes; ++i) r[i] = std::sqrt(a[i]);
    return r;
}
/// For functions of one number or of lanes.
inline float sqrt_lanes(float a) { return std::sqrt(a); }
/// The whole number towards zero, of magnitude below 2^31, and back.
inline int whole(float a) { return static_cast<int>(a); }
inline IntLanes whole(FloatLanes a) { return __builtin_convertvector(a, IntLanes); }
inline float to_float(int a) { return static_cast<float>(a); }
inline FloatLanes to_float(IntLanes a) { return __builtin_convertvector(a, FloatLanes); }
/// The other precision.
inline FloatLanes to_float(const DoubleLanes& a) { return __builtin_convertvector(a, FloatLanes); }
inline DoubleLanes to_double(FloatLanes a) { return __builtin_convertvector(a, DoubleLanes); }
/// The elements of a table at these places.
template <class T>
inline T gather(const T* table, int at) {
    return table[at];
}
inline FloatLanes gather(const float* table, IntLanes at) {
    return make_lanes([&](int i) { return table[at[i]]; });
}
inline IntLanes gather(const std::uint16_t* table, IntLanes at) {
    return make_lanes<IntLanes>([&](int i) { return table[at[i]]; });
}
/// Whether a comparison holds, for any of the lanes.
inline bool any(bool holds) { return holds; }
inline bool any(IntLanes holds) {
    std::int32_t some = 0;
    for (int i = 0; i < kLanes; ++i) some |= holds[i];
    return some != 0;
}
/// Sum, largest and mean over the lanes. The sum is one of halves and of quarters, so that no
/// addition waits for seven others.
template <class V>
inline auto lane_sum(const V& a) {
    const auto s = half_lanes(a, 0) + half_lanes(a, 1);
    return (s[0] + s[2]) + (s[1] + s[3]);
}
template <class V>
inline auto lane_max(V a) {
    const auto s = max_lanes(half_lanes(a, 0), half_lanes(a, 1));
    return std::max(std::max(s[0], s[2]), std::max(s[1], s[3]));
}
template <class V>
inline auto lane_mean(V a) {
    return lane_sum(a) / kLanes;
}

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
