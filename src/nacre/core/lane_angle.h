#pragma once

#include <array>
#include <numbers>

#include "nacre/core/lane_math.h"
#include "nacre/core/lanes.h"

namespace nacre {

/// Error of atan2_lanes(), in rad, absolute; and relative of small angles from +x.
inline constexpr double kAtan2LanesError = 3e-7;

/// Angle in [-pi, pi] from +x to the point (x, y); 0 of the origin.
/// By the polynomial for arcs up to 45 deg.               [abramowitz-stegun-1964, eq. 4.4.49]
inline FloatLanes atan2_lanes(FloatLanes y, FloatLanes x) {
    static constexpr std::array<float, 9> coefficients = {
        1.0f,           -0.3333314528f, 0.1999355085f,  -0.1420889944f, 0.1065626393f,
        -0.0752896400f, 0.0429096138f,  -0.0161657367f, 0.0028662257f};
    const FloatLanes width = max_lanes(x, -x), height = max_lanes(y, -y);
    const FloatLanes longer = max_lanes(width, height), shorter = min_lanes(width, height);
    const FloatLanes slope = longer > 0 ? shorter / longer : FloatLanes{};
    const FloatLanes arc = slope * detail::horner(slope * slope, coefficients);
    constexpr float kPi = std::numbers::pi_v<float>;
    const FloatLanes quarter = height > width ? 0.5f * kPi - arc : arc;
    const FloatLanes half = x < 0 ? kPi - quarter : quarter;
    return y < 0 ? -half : half;
}

}  // namespace nacre
