#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

// What a plot shows. How it is drawn: plots.js.

namespace nacre::report {

/// "#rrggbb" of a colour encoded as sRGB, components in [0, 1]; what lies outside is clipped, NaN
/// to 0. From linear Rec. 709, encode first: spectra::srgb_encode.
std::string css_colour(const std::array<double, 3>& srgb);

struct Axis {
    std::string label = {};         ///< plain text: quantity and unit, as in "angle, degrees"
    bool logarithmic = false;       ///< values <= 0 are then left out
    std::optional<double> lo = {};  ///< where it begins; else where the data do
    std::optional<double> hi = {};  ///< where it ends; else where the data do
};

/// Values beyond this, and of course infinity, are not shown: the length of an axis must be finite.
inline constexpr double kLargestShown = 1e150;

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

}  // namespace nacre::report
