#include "nacre/sparkle/plane_waves.h"

#include <cmath>
#include <numbers>

#include "nacre/core/lane_math.h"

namespace nacre::sparkle {
namespace {

static_assert(kWavesPerBand % kLanes == 0 && kWavesPerBand % kWaveAxes == 0);

/// Three unit vectors at right angles, all rotations equally likely: by a unit quaternion.
/// [shoemake-1992]
std::array<Vec3d, kWaveAxes> random_axes(Rng& rng) {
    const double u = rng.uniform_double();
    const double a = 2 * std::numbers::pi * rng.uniform_double();
    const double b = 2 * std::numbers::pi * rng.uniform_double();
    const double x = std::sqrt(1 - u) * std::sin(a), y = std::sqrt(1 - u) * std::cos(a);
    const double z = std::sqrt(u) * std::sin(b), w = std::sqrt(u) * std::cos(b);
    return {Vec3d{1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)},
            Vec3d{2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)},
            Vec3d{2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)}};
}

}  // namespace

std::array<PlaneWave, kWavesPerBand> plane_waves(double shortest_mm, double longest_mm, Rng& rng) {
    std::array<PlaneWave, kWavesPerBand> waves;
    std::array<Vec3d, kWaveAxes> axes;
    for (int wave = 0; wave < kWavesPerBand; ++wave) {
        if (wave % kWaveAxes == 0) axes = random_axes(rng);
        const double octave = (wave + rng.uniform_double()) / kWavesPerBand;
        waves[wave] = {axes[wave % kWaveAxes],
                       shortest_mm * std::pow(longest_mm / shortest_mm, octave),
                       rng.uniform_double()};
    }
    return waves;
}

void PlaneWaveLanes::set(int lane, const PlaneWave& wave) {
    for (int i = 0; i < kWaveAxes; ++i) per_mm[i][lane] = wave.direction[i] / wave.wavelength_mm;
    phase[lane] = wave.phase;
}

DoubleLanes PlaneWaveLanes::turns_at(Vec3d x) const {
    // Whole turns are many, and leave before the digits do.
    const DoubleLanes turns = per_mm[0] * x.x + per_mm[1] * x.y + per_mm[2] * x.z + phase;
    return turns - nacre::detail::nearest_integer<DoubleLanes>(turns).value;
}

}  // namespace nacre::sparkle
