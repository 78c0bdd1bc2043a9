#pragma once

#include <array>
#include <cstdint>

#include "nacre/sparkle/plane_waves.h"

namespace nacre::sparkle {

/// Where on one specimen a clear coat is thinner or thicker.            [docs/coat-thickness.md]
///
/// The deviation from the mean, in standard deviations, is a sum of plane waves of one amplitude A,
///
///     z(x) = sum_j A cos(2 pi (k_j.x / lambda_j + phi_j)),  N A^2 / 2 = 1,
///
/// of wavelengths kWavelengths_mm (sparkle/plane_waves.h): mean 0 and variance 1 exactly, over all places
/// and on the mean of all specimens, and a nearly normal law. It is cut off at paint's kMaxCoatDeviation,
/// 3, beyond which 0.27 % of the area of a normal law lies; that takes 0.5 % of the variance.
class CoatThickness {
 public:
    /// A choice: from the smallest to the largest patches that people call mottling on a sprayed panel.
    static constexpr std::array<double, 2> kWavelengths_mm{10, 100};

    /// @param seed  the specimen
    explicit CoatThickness(std::uint64_t seed);

    /// z, in [-3, 3], at a point in object space.
    float deviation(Vec3f position_mm) const;

 private:
    std::array<PlaneWaveLanes, kWavesPerBand / kLanes> groups_;
};

}  // namespace nacre::sparkle
