#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// What a plot shows. How it is drawn: plot_svg.h.

namespace nacre::report {

struct Axis {
    std::string label = {};         ///< plain text: quantity and unit, as in "angle, degrees"
    bool logarithmic = false;       ///< values <= 0 are then left out
    std::optional<double> lo = {};  ///< where it begins; else where the data do
    std::optional<double> hi = {};  ///< where it ends; else where the data do
};

/// Values beyond this, and of course infinity, are not shown: the length of an axis must be finite.
inline constexpr double kMaxShown = 1e150;

/// Points, and perhaps the line through them. A point whose x or y is not finite is left out and
/// interrupts the line; so does one that a logarithmic axis cannot show. What lies beyond the ends
/// of an axis is cut off.
struct Series {
    std::string name = {};  ///< plain text for the legend; empty: not in it
    std::vector<double> x = {};
    std::vector<double> y = {};  ///< as many as x, and so are the lists below unless empty

    /// Each >= 0: bars from y - y_error to y + y_error. Not finite: no bar.
    std::vector<double> y_error = {};
    /// Each dot's own colour, "#rrggbb", such as that of the sample it stands for.
    std::vector<std::string> point_colours = {};
    /// Plain text beside each point.
    std::vector<std::string> point_labels = {};
    /// Of line and dots. Empty: the next of a palette that colour-blind readers can tell apart.
    std::string colour = {};

    bool line = true;
    bool dots = false;
    bool dashed = false;
};

struct Plot {
    std::string title = {};    ///< text
    std::string caption = {};  ///< text
    Axis x = {};
    Axis y = {};
    /// One unit is as long in x as in y, and axes without given ends show their zero: for a* and
    /// b* of CIELAB.
    bool equal_scale = false;
    std::vector<Series> series = {};
};

/// Checks what a caller can get wrong.
/// @throws DomainError naming the plot and the series if lists differ in length, an error is
/// negative, a colour is not "#rrggbb", lo or hi is not finite, lo >= hi, a logarithmic axis begins
/// at or below 0, or equal_scale meets a logarithmic axis
void check(const Plot& plot);

/// @throws DomainError naming `where` unless the colour is "#rrggbb": nothing else may enter the
/// page's style attributes
void require_colour(std::string_view colour, const std::string& where);

// What follows from a plot's description before anything is drawn.

/// Where an axis begins and ends.
struct Extent {
    double lo = 0, hi = 1;
    bool round = false;  ///< both ends may move outwards to round numbers
};

struct Extents {
    Extent x, y;
};

/// The ends of both axes: as given, else such that every point and bar that can be shown is.
Extents extents(const Plot& plot);

/// Widens an extent about its middle, but not beyond ends that the axis was given.
void widen(Extent& extent, const Axis& axis, double width);

/// Whether both coordinates are finite, not beyond kMaxShown and, on logarithmic axes, > 0.
bool can_be_shown(const Plot& plot, double x, double y);

struct ErrorBar {
    std::optional<double> low;  ///< empty: it goes down to the end of a logarithmic axis
    double high = 0;
};

/// The bar of point `i`, which can be shown; empty if it has none.
std::optional<ErrorBar> error_bar(const Plot& plot, const Series& series, std::size_t i);

/// How a series looks.
struct Look {
    std::string colour;       ///< "#rrggbb"
    std::string_view symbol;  ///< of the dots: circle, square, triangle or diamond
};

/// The look of series number `index`. Its colour is its own or one that readers with any colour
/// vision can tell from its neighbours [okabe-ito-2008]; 32 looks differ.
Look look_of(const Series& series, std::size_t index);

}  // namespace nacre::report
