#pragma once

#include <string>
#include <string_view>

namespace nacre::report {

/// The outline of a dot as the data of an SVG path about (0, 0): equal areas, as eyes compare
/// them.
/// @param symbol  circle, square, triangle or diamond, as in Look
/// @param radius  of the circle, px
std::string symbol_path(std::string_view symbol, double radius);

/// A coordinate or length in SVG, to a hundredth of a pixel; what lies too far off to be drawn is
/// moved to where no picture reaches.
std::string svg_number(double pixels);

}  // namespace nacre::report
