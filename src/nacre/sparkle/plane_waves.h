#pragma once

#include <array>

#include "nacre/core/lanes.h"
#include "nacre/core/random.h"
#include "nacre/core/vec.h"

// Plane waves in the object space of a shape, whose sum is a random function on its surface: the same
// on any shape, without seams, for any number of threads. What a coat does from place to place is made
// of them (CoatWaves, CoatThickness).

namespace nacre::sparkle {

struct PlaneWave {
    Vec3d direction;              ///< unit
    double wavelength_mm, phase;  ///< phase in turns
};

/// Of one band of wavelengths; the sum of so many is nearly normal.
inline constexpr int kWavesPerBand = 72;

/// They come in triples at right angles.
inline constexpr int kWaveAxes = 3;

/// Waves whose lengths are uniform in their logarithm, so that each octave has as many, and whose
/// triples are turned at random. A wave that runs at an angle to the surface looks longer
/// there by the inverse of the cosine.
std::array<PlaneWave, kWavesPerBand> plane_waves(double shortest_mm, double longest_mm, Rng& rng);

/// Eight of them.
struct PlaneWaveLanes {
    DoubleLanes per_mm[3];  ///< wave vector, in turns
    DoubleLanes phase;      ///< in turns

    void set(int lane, const PlaneWave& wave);
    /// Phases at a point, within half a turn.
    DoubleLanes turns_at(Vec3d position_mm) const;
};

}  // namespace nacre::sparkle
