#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "nacre/report/plot.h"

// From a plot's description to what plots.js and plot_svg.cpp draw. All decisions are made here,
// where tests can reach them; the script only draws.

namespace nacre::report {

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

/// Whether both coordinates are finite, not beyond kLargestShown and, on logarithmic axes, > 0.
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

/// The plot as JSON for plots.js, which documents the form. A point that cannot be shown has null
/// for x and y.
/// @throws DomainError as check(plot)
std::string plot_json(const Plot& plot);

}  // namespace nacre::report
