#pragma once

#include <span>
#include <vector>

#include "nacre/report/plot_data.h"

namespace nacre::report {

struct Pixel {
    double x = 0, y = 0;  ///< y grows downwards
};

/// Where the label of each point of a curve stands: on its outer side, as one of eight directions
/// in steps of 45 deg from the right, clockwise on the screen. Straight and single points have it
/// above.
std::vector<int> label_sides(std::span<const Pixel> points);

/// The same for the points of a series, about as they will lie in a picture; -1 for those that
/// cannot be shown. A label that only the last point has names the line: it stands to its right.
std::vector<int> label_sides(const Plot& plot, const Extents& ends, const Series& series);

/// Whether no point but the last has a label.
bool labels_only_its_end(const Series& series);

/// The direction of a side: (cos, sin) of its angle, y downwards.
Pixel side_direction(int side);

}  // namespace nacre::report
