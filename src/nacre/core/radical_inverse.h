#pragma once

#include <cstddef>

namespace nacre {

/// The digits of `index` in a base, mirrored at the point: 6 = 110 in base 2 becomes 0.011 = 3/8.
/// In one base the sequence over indices is van der Corput's, in several Halton's. [halton-1960]
/// @param base  >= 2
/// @return in [0, 1)
inline double radical_inverse(std::size_t index, unsigned base) {
    double value = 0, digit = 1.0 / base;
    for (; index > 0; index /= base, digit /= base) {
        value += digit * static_cast<double>(index % base);
    }
    return value;
}

}  // namespace nacre
