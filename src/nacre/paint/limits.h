#pragma once

#include <cstddef>

#include "nacre/core/error.h"

// Bounds that other folders use too; those of every key: paint/recipe_description.h.

namespace nacre::paint::limits {

inline constexpr std::size_t kMaxLayers = 64;
inline constexpr Range kFraction{0, 1};
/// Of absorption and scattering, and the constants of Kubelka and Munk.
inline constexpr Range kCoefficient{0, 1e9, "1/mm"};
inline constexpr Range kWavelength{1, 1e6, "nm"};
inline constexpr Range kBinderIndex{1, 3};
inline constexpr Range kFilmThickness{0, 1e5, "nm", true};
inline constexpr Range kFilmSpread{0, 1e5, "nm"};
inline constexpr Range kMicrofacetAlpha{0.001, 1};
/// Of the flakes' mean. Beyond, what is first order in it would be off by more than some percent.
inline constexpr Range kLeanTilt{0, 10, "deg"};
inline constexpr Range kOrientationAlpha{0.005, 1};
/// Of GGX: below, its core of slopes is narrower than what is solved; above, more than a fifth of
/// the flakes would be steeper than what Beckmann's laws of kOrientationAlpha can be.
inline constexpr Range kGgxAlpha{0.02, 0.5};
/// Of a coat's thickness over its mean: at kMaxCoatDeviation nothing is left of the coat.
inline constexpr double kMaxCoatSpread = 1 / 3.0;
/// In standard deviations; the normal law of a coat's thickness ends there.
inline constexpr double kMaxCoatDeviation = 3;
/// Over the alpha of the flakes' planes.
inline constexpr double kMaxRelativeWaviness = 2;

}  // namespace nacre::paint::limits
