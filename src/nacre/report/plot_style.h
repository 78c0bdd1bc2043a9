#pragma once

// How every plot looks, whoever draws it: plots.js in a browser gets these with its data, and
// plot_svg.cpp uses them as they are.

namespace nacre::report::style {

inline constexpr const char* kPaper = "#ffffff";
inline constexpr const char* kText = "#1f1f1f";
inline constexpr const char* kFaintText = "#5c5c5c";
inline constexpr const char* kPointLabel = "#333333";
inline constexpr const char* kGrid = "#000000";
inline constexpr double kGridOpacity = 0.1;
inline constexpr const char* kFrame = "#bbbbbb";
inline constexpr const char* kZero = "#777777";  ///< lines of zero, where scales are equal

inline constexpr double kLineWidth = 2;  ///< px, as all lengths here
inline constexpr const char* kDashes = "6 4";
inline constexpr double kBarWidth = 1.2;
inline constexpr double kBarOpacity = 0.8;
inline constexpr double kDotRadius = 4;
/// Dots in colours of their own are larger, so that the colour can be seen, and have a dark edge.
inline constexpr double kOwnDotRadius = 7;
inline constexpr const char* kOwnDotEdge = "#333333";

inline constexpr double kTickFont = 13;
inline constexpr double kLabelFont = 12;      ///< of points
inline constexpr double kLabelDistance = 10;  ///< from a point to its label

inline constexpr double kMarginTop = 32, kMarginRight = 28, kMarginBottom = 48, kMarginLeft = 62;
inline constexpr double kTickSpacingX = 80, kTickSpacingY = 50, kTickSpacingEqual = 60;

}  // namespace nacre::report::style
