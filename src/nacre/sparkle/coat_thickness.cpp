#include "nacre/sparkle/coat_thickness.h"

#include <algorithm>
#include <cmath>

#include "nacre/core/lane_math.h"
#include "nacre/paint/recipe.h"

namespace nacre::sparkle {

CoatThickness::CoatThickness(std::uint64_t seed) {
    // Of its own: the thickness does not depend on whether the coat has an orange peel.
    Rng rng(seed, hash_of(0x746869636bULL));
    const auto waves = plane_waves(kWavelengths_mm[0], kWavelengths_mm[1], rng);
    for (int wave = 0; wave < kWavesPerBand; ++wave) {
        groups_[wave / kLanes].set(wave % kLanes, waves[wave]);
    }
}

float CoatThickness::deviation(Vec3f position_mm) const {
    static const float amplitude = std::sqrt(2.0f / kWavesPerBand);
    FloatLanes sum{};
    for (const PlaneWaveLanes& group : groups_) {
        const DoubleLanes turns = group.turns_at(to_double(position_mm));
        sum += cos_sin_turns(__builtin_convertvector(turns, FloatLanes)).cosine;
    }
    constexpr auto kMost = static_cast<float>(paint::limits::kMaxCoatDeviation);
    return std::clamp(amplitude * lane_sum(sum), -kMost, kMost);
}

}  // namespace nacre::sparkle
