#pragma once

#include "nacre/core/range.h"

// What AiryFilm (optics/airy.h) takes, for those who only check input.

namespace nacre::optics {

inline constexpr Range kAiryIndexRange{.lo = 0.01, .hi = 10};
inline constexpr Range kAiryExtinctionRange{.lo = 0, .hi = 100};

}  // namespace nacre::optics
