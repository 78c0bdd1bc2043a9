#pragma once

#include <bit>
#include <cstdint>

// Half floats, as textures hold them: binary16 of IEEE 754.

namespace nacre {

/// The bits of the nearest half float, to even where two are as near; infinity beyond 65519.
constexpr std::uint16_t half_bits(float value) {
    const std::uint32_t bits = std::bit_cast<std::uint32_t>(value);
    const auto sign = static_cast<std::uint16_t>(bits >> 16 & 0x8000u);
    const std::uint32_t size = bits & 0x7fffffffu;
    if (size > 0x7f800000u) return sign | 0x7e00u;   // not a number
    if (size >= 0x477ff000u) return sign | 0x7c00u;  // 65520 and above
    if (size < 0x38800000u) {
        // Below 2^-14 steps are of 2^-24: adding 1/2, whose steps are those, rounds.
        const float rounded = std::bit_cast<float>(size) + 0.5f;
        return sign |
               static_cast<std::uint16_t>(std::bit_cast<std::uint32_t>(rounded) - 0x3f000000u);
    }
    const std::uint32_t odd = size >> 13 & 1u;
    return sign | static_cast<std::uint16_t>((size - 0x38000000u + 0xfffu + odd) >> 13);
}

constexpr bool is_finite_half(std::uint16_t bits) { return (bits & 0x7c00u) != 0x7c00u; }

/// Exactly.
constexpr float half_value(std::uint16_t bits) {
    const std::uint32_t sign = static_cast<std::uint32_t>(bits & 0x8000u) << 16;
    const std::uint32_t size = static_cast<std::uint32_t>(bits & 0x7fffu) << 13;
    if ((bits & 0x7c00u) == 0x7c00u) return std::bit_cast<float>(sign | 0x7f800000u | size);
    const float scaled = std::bit_cast<float>(sign | size);
    return scaled * 0x1p112f;
}

}  // namespace nacre
