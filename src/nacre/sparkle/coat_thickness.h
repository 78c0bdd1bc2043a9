#pragma once

#include <array>
#include <cstdint>

#include "nacre/sparkle/plane_waves.h"

namespace nacre::sparkle {

/// Where on one specimen a clear coat is thinner or thicker.            [docs/coat-thickness.md]
///
/// The deviation from the mean, in standard deviations, is a sum of plane waves
///
///     z(x) = sum_j a_j cos(2 pi (k_j.x / lambda_j + phi_j)),  a_j ~ lambda_j,  sum a_j^2 / 2 = 1,
///
/// of wavelengths kWavelengths_mm (sparkle/plane_waves.h), of the same slope in each octave as those of an
/// orange peel: mean 0 and variance 1 exactly, over all places and on the mean of all specimens, and a
/// nearly normal law, as of noise that is a sum of sinusoids of random phase [rice-1945]. The law and the
/// slopes are choices of this project: no measured spectrum of mottling could be cited. The law is cut off
/// at 3 (paint::limits::kMaxCoatDeviation), beyond which 0.27 % of a normal law lies, which takes 0.5 % of
/// its variance.
class CoatThickness {
 public:
    /// A choice: clouds of some centimetres, as people call mottling.
    static constexpr std::array<double, 2> kWavelengths_mm{10, 100};

    /// @param seed  the specimen
    explicit CoatThickness(std::uint64_t seed);

    /// z, in [-3, 3], at a point in object space.
    float deviation(Vec3f position_mm) const;

 private:
    struct Group {  // eight waves
        PlaneWaveLanes waves;
        FloatLanes amplitude;
    };
    std::array<Group, kWavesPerBand / kLanes> groups_;
};

}  // namespace nacre::sparkle
