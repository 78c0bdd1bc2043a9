#pragma once

#include "nacre/report/label_sides.h"
#include "nacre/report/plot_data.h"

// From data to pixels.

namespace nacre::report {

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
