#pragma once

#include <string>
#include <string_view>

#include "nacre/report/plot.h"

// From a plot's description to what plots.js draws. All decisions are made here, where tests can
// reach them; the script only draws.

namespace nacre::report {

/// Where an axis begins and ends.
struct Extent {
    double lo = 0, hi = 1;
    bool round = false;  ///< the script may move both ends outwards to round numbers
};

struct Extents {
    Extent x, y;
};

/// The ends of both axes: as given, else such that every point and bar that can be shown is.
Extents extents(const Plot& plot);

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
