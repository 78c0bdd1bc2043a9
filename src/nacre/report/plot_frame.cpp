#include "nacre/report/plot_frame.h"

#include <algorithm>
#include <cmath>

#include "nacre/report/plot_style.h"
#include "nacre/report/ticks.h"

namespace nacre::report {

PlotFrame::PlotFrame(const Plot& plot, const Extents& ends, const Box& box)
    : ends_(ends), log_x_(plot.x.logarithmic), log_y_(plot.y.logarithmic), box_(box) {}

double PlotFrame::place(double value, const Extent& extent, bool logarithmic, double at_lo,
                        double at_hi) {
    const auto scale = [&](double v) { return logarithmic ? std::log10(v) : v; };
    const double lo = scale(extent.lo), hi = scale(extent.hi);
    return at_lo + (scale(value) - lo) / (hi - lo) * (at_hi - at_lo);
}

bool PlotFrame::contains(double x_value, double y_value) const {
    const auto in = [](const Extent& e, double v) { return v >= e.lo && v <= e.hi; };
    return in(ends_.x, x_value) && in(ends_.y, y_value);
}

double tick_count(double length_px, double spacing_px) {
    return std::max(1.0, length_px / spacing_px);
}

PlotFrame fit_frame(const Plot& plot, Box box) {
    Extents ends = extents(plot);
    if (plot.equal_scale) {
        // Room for labels beyond the outermost points.
        widen(ends.x, plot.x, 1.1 * (ends.x.hi - ends.x.lo));
        widen(ends.y, plot.y, 1.1 * (ends.y.hi - ends.y.lo));
        const double width = ends.x.hi - ends.x.lo, height = ends.y.hi - ends.y.lo;
        const double unit_px = std::min(box.width() / width, box.height() / height);
        widen(ends.x, plot.x, box.width() / unit_px);
        widen(ends.y, plot.y, box.height() / unit_px);
        box.right = std::min(box.right, box.left + unit_px * (ends.x.hi - ends.x.lo));
        box.bottom = std::min(box.bottom, box.top + unit_px * (ends.y.hi - ends.y.lo));
    } else {
        if (!plot.x.logarithmic) {
            ends.x = rounded(ends.x, tick_count(box.width(), style::kTickSpacingX));
        }
        if (!plot.y.logarithmic) {
            ends.y = rounded(ends.y, tick_count(box.height(), style::kTickSpacingY));
        }
    }
    return {plot, ends, box};
}

}  // namespace nacre::report
