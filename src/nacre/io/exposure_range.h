#pragma once

#include "nacre/core/error.h"

namespace nacre::io {

/// Of ToneMap::exposure_stops, where users choose it.
inline constexpr Range kExposureRange{-50, 50, "stops"};

}  // namespace nacre::io
