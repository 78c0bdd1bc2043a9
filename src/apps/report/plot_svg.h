#pragma once

#include <string>
#include <string_view>

#include "apps/report/plot_data.h"
#include "apps/report/plot_frame.h"

// How every plot looks, in pages and in files.

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
inline constexpr double kInvisibleDotRadius = 7;

inline constexpr double kTickFont = 13;
inline constexpr double kLabelFont = 12;      ///< of points
inline constexpr double kLabelDistance = 10;  ///< from a point to its label

inline constexpr double kMarginTop = 32, kMarginRight = 28, kMarginBottom = 48;
/// Left of the title and of the label of y, where the title is drawn.
inline constexpr double kIndent = 14;
/// Left of the axes, for the numbers of y.
inline constexpr double kNumbers = 48;
inline constexpr double kTickSpacingX = 80, kTickSpacingY = 50, kTickSpacingEqual = 60;

}  // namespace nacre::report::style

namespace nacre::report {

/// The outline of a dot as the data of an SVG path about (0, 0): equal areas, as eyes compare
/// them.
/// @param symbol  circle, square, triangle or diamond, as in Look
/// @param radius  of the circle, px
std::string symbol_path(std::string_view symbol, double radius);

/// A coordinate or length in SVG, to a hundredth of a pixel; what lies too far off to be drawn is
/// moved to where no picture reaches.
std::string svg_number(double pixels);

// What the lines and dots of a plot stand for.

/// How wide a text will be about, px: fonts are the viewer's. On the safe side for common ones.
double text_width(std::string_view utf8, double font_px);

/// A piece of line and a dot as a series has them, in a box of 32 x 12 px from (0, 0).
std::string legend_key(const Series& series, const Look& look);

struct Legend {
    std::string svg;
    double height = 0;  ///< 0: no series has a name
};

/// The names of the series with their keys, in rows from `corner` to the right edge.
Legend legend_svg(const Plot& plot, Pixel corner, double right);

// A plot as a picture: for pages, for print, for a paper.

struct SvgSize {
    double width_px = 720;
    double height_px = 420;

    friend bool operator==(const SvgSize&, const SvgSize&) = default;
};

inline constexpr double kMinSvg = 120, kMaxSvg = 10'000;  // px a side

/// Where the title and the legend stand, with the caption as description: in the picture, or in the
/// page around it, which sets them better.
enum class TitleAndLegend { inside, around };

/// Lines without dots have an invisible one on each point, so that the pointer can read it off,
/// unless a plot would have more of them than this.
inline constexpr std::size_t kMaxInvisibleDots = 500;

/// The plot as SVG 1.1: valid XML, text as text in the viewer's sans-serif font. Browsers show the
/// series, label and numbers of a dot under the pointer. It has no scripts, styles, links or ids,
/// so that it can stand in a page as often as wanted.
/// @throws DomainError as check(plot), or if a side is outside [kMinSvg, kMaxSvg]
std::string plot_svg(const Plot& plot, const SvgSize& size = {},
                     TitleAndLegend words = TitleAndLegend::inside);

}  // namespace nacre::report
