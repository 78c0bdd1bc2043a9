#pragma once

#include <string>

#include "nacre/report/label_sides.h"
#include "nacre/report/plot_data.h"

// What the lines and dots of a plot stand for.

namespace nacre::report {

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

}  // namespace nacre::report
