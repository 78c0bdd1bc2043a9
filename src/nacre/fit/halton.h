#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace nacre::fit {

/// Points that fill the unit cube evenly, the same ones for the same seed: Halton's sequence
/// [halton-1960], in base 2 for the first coordinate, 3 for the second, 5, 7, ..., without its
/// point 0, turned by a random shift for each coordinate [cranley-patterson-1976].
/// @param dimensions  1 to kMostHaltonDimensions @throws DomainError
std::vector<std::vector<double>> halton_points(std::size_t count, std::size_t dimensions,
                                               std::uint64_t seed);

/// Bases grow with the dimension, and the first points of large bases lie in a line.
inline constexpr std::size_t kMostHaltonDimensions = 24;

}  // namespace nacre::fit
