#pragma once

#include <span>
#include <string>
#include <vector>

#include "apps/report/plot_data.h"

// Where the axes of a plot lie, and where they carry lines and numbers.

namespace nacre::report {

struct Tick {
    double value = 0;
    std::string text = {};  ///< empty: a line without a number

    friend bool operator==(const Tick&, const Tick&) = default;
};

/// The distance between ticks, of the form 1, 2 or 5 times a power of ten, that gives about
/// `count` of them.
double tick_step(double lo, double hi, double count);

/// The extent with both ends moved outwards to multiples of the tick step, if it may be.
Extent rounded(const Extent& extent, double count);

/// Multiples of tick_step() from lo to hi. An axis that spans less than its numbers resolve
/// (1e16 to 1e16 + 2) has none.
std::vector<Tick> linear_ticks(double lo, double hi, double count);

/// On a logarithmic axis: the powers of ten, with 2 and 5 numbered and the other digits as lines
/// where there is room; over very many decades only every so many; within one decade those of a
/// linear axis.
/// @param lo  > 0
std::vector<Tick> logarithmic_ticks(double lo, double hi, double count);

/// A number with `decimals` digits after the point, or of six digits and more as in 2.5·10⁶.
std::string tick_text(double value, double step);

struct Pixel {
    double x = 0, y = 0;  ///< y grows downwards
};

/// Where the label of each point of a curve stands: on its outer side, as one of eight directions
/// in steps of 45 deg from the right, clockwise on the screen. Straight and single points have it
/// above.
std::vector<int> label_sides(std::span<const Pixel> points);

/// The direction of a side: (cos, sin) of its angle, y downwards.
Pixel side_direction(int side);

// From data to pixels.

/// A rectangle of pixels, y downwards.
struct Box {
    double left = 0, top = 0, right = 1, bottom = 1;

    double width() const { return right - left; }
    double height() const { return bottom - top; }
};

/// The two axes of a plot, laid over a box.
class PlotFrame {
 public:
    /// @param ends  where the axes begin and end: the edges of the box
    PlotFrame(const Plot& plot, const Extents& ends, const Box& box);

    double x(double value) const { return place(value, ends_.x, log_x_, box_.left, box_.right); }
    double y(double value) const { return place(value, ends_.y, log_y_, box_.bottom, box_.top); }
    Pixel at(double x_value, double y_value) const { return {x(x_value), y(y_value)}; }
    bool contains(double x_value, double y_value) const;

    const Extents& ends() const { return ends_; }
    const Box& box() const { return box_; }

 private:
    static double place(double value, const Extent& extent, bool logarithmic, double at_lo,
                        double at_hi);

    Extents ends_;
    bool log_x_, log_y_;
    Box box_;
};

/// The frame of a plot that fills a box, ends rounded where they may be. Axes of equal scale are
/// made longer until they fill it; those with given ends make the box smaller instead.
PlotFrame fit_frame(const Plot& plot, Box box);

/// Ticks for which there is room.
double tick_count(double length_px, double spacing_px);

}  // namespace nacre::report
