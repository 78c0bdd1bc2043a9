#include "nacre/sparkle/coat_thickness.h"

#include <algorithm>
#include <cmath>

#include "nacre/core/lane_math.h"
#include "nacre/paint/limits.h"

namespace nacre::sparkle {

CoatThickness::CoatThickness(std::uint64_t seed) {
    // Of its own: the thickness does not depend on whether the coat has an orange peel.
    Rng rng(seed, hash_of(0x746869636bULL));
    const auto waves = plane_waves(kWavelengths_mm[0], kWavelengths_mm[1], rng);
    double squares = 0;
    for (const PlaneWave& wave : waves) squares += wave.wavelength_mm * wave.wavelength_mm;
    const double per_mm = std::sqrt(2 / squares);
    for (int wave = 0; wave < kWavesPerBand; ++wave) {
        Group& group = groups_[wave / kLanes];
        group.waves.set(wave % kLanes, waves[wave]);
        group.amplitude[wave % kLanes] = static_cast<float>(per_mm * waves[wave].wavelength_mm);
    }
}

float CoatThickness::deviation(Vec3f position_mm) const {
    const Vec3d x = to_double(position_mm);
    FloatLanes sum{};
    for (const Group& group : groups_) {
        const FloatLanes turns = __builtin_convertvector(group.waves.turns_at(x), FloatLanes);
        sum += group.amplitude * cos_sin_turns(turns).cosine;
    }
    constexpr auto kMax = static_cast<float>(paint::limits::kMaxCoatDeviation);
    return std::clamp(lane_sum(sum), -kMax, kMax);
}

}  // namespace nacre::sparkle
