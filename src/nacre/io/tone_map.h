#pragma once

namespace nacre::io {

/// Where the shoulder of the tone curve starts: below, light is shown as it is.
inline constexpr double kShoulderStart = 0.8;

/// Linear light in [0, inf) to linear light on a display in [0, 1): the identity up to s =
/// kShoulderStart, then s + (1 - s)(1 - exp(-(x - s)/(1 - s))), which continues it with the same
/// slope and never burns out. Negative light, from colours outside the gamut, becomes 0.
double soft_shoulder(double light);

/// The whole way to eight bits: exposure, shoulder, sRGB transfer function, rounding.
/// NaN is shown as 0.                                                      [iec-61966-2-1-1999]
unsigned char display_byte(double light, double exposure_scale);

}  // namespace nacre::io
