#pragma once

#include <string>
#include <string_view>

namespace nacre::report {

inline constexpr int kMaxRasterPixels = 100'000'000;
/// Of plots and charts: sharp on displays of two pixels for one px, and in print.
inline constexpr double kPngScale = 2;

/// An SVG picture, with its size in px, as the bytes of a PNG file: `scale` pixels for one px, on
/// the paper that the SVG has (none: transparent). Drawn by librsvg and cairo; letters are those
/// of the fonts on this machine.
/// @throws DomainError if the text is no SVG, has no size in px, the scale is outside [0.01, 100],
///         or the picture would have no or more than kMaxRasterPixels pixels
/// @throws Error if it cannot be drawn, or it has letters and there is no font for them
std::string png_of_svg(std::string_view svg, double scale = 1);

}  // namespace nacre::report
