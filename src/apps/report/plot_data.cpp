#include "apps/report/plot_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include "nacre/core/error.h"

namespace nacre::report {

void require_colour(std::string_view colour, const std::string& where) {
    const auto is_digit = [](unsigned char c) { return std::isxdigit(c) != 0; };
    if (colour.size() == 7 && colour[0] == '#' &&
        std::all_of(colour.begin() + 1, colour.end(), is_digit)) {
        return;
    }
    throw DomainError(fmt::format("{}: '{}' is no colour of the form \"#rrggbb\"", where, colour));
}

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool shown(const Axis& axis, double value) {
    return std::abs(value) <= kMaxShown && (!axis.logarithmic || value > 0);
}

void check_axis(const Axis& axis, const char* name, const std::string& where) {
    for (const auto& end : {axis.lo, axis.hi}) {
        if (end && !shown(axis, *end)) {
            throw DomainError(fmt::format("{}: the {} axis cannot end at {}{}", where, name, *end,
                                          axis.logarithmic ? ": it is logarithmic" : ""));
        }
    }
    if (axis.lo && axis.hi && !(*axis.lo < *axis.hi)) {
        throw DomainError(
            fmt::format("{}: the {} axis goes from {} to {}", where, name, *axis.lo, *axis.hi));
    }
}

void check_series(const Series& series, const std::string& where) {
    const std::size_t count = series.x.size();
    const auto check_count = [&](std::size_t n, const char* name, bool may_be_empty) {
        if (n == count || (n == 0 && may_be_empty)) return;
        throw DomainError(fmt::format("{}: {} {} for {} x", where, n, name, count));
    };
    check_count(series.y.size(), "y", false);
    check_count(series.y_error.size(), "y_error", true);
    check_count(series.point_colours.size(), "point_colours", true);
    check_count(series.point_labels.size(), "point_labels", true);
    for (const double error : series.y_error) {
        if (error < 0) throw DomainError(fmt::format("{}: y_error = {} is below 0", where, error));
    }
    if (!series.colour.empty()) require_colour(series.colour, where);
    for (const std::string& colour : series.point_colours) require_colour(colour, where);
}

// The range of the values that an axis can show.
struct ShownValues {
    double lo = kInfinity, hi = -kInfinity;
    void add(const Axis& axis, double value) {
        if (!shown(axis, value)) return;
        lo = std::min(lo, value);
        hi = std::max(hi, value);
    }
};

/// @param end_at_zero  whether the margins stop at a zero that the data do not cross
Extent extent(const Axis& axis, ShownValues range, bool end_at_zero) {
    if (!(range.lo <= range.hi)) {  // nothing to show
        range = axis.logarithmic ? ShownValues{1, 10} : ShownValues{0, 1};
    }
    // Margins are parts of the range, on a logarithmic axis of that of the logarithms.
    const auto to = [&](double v) { return axis.logarithmic ? std::log10(v) : v; };
    const auto from = [&](double v) { return axis.logarithmic ? std::pow(10, v) : v; };
    double lo = to(axis.lo.value_or(range.lo)), hi = to(axis.hi.value_or(range.hi));
    if (!(lo < hi)) {  // one value only, or data on the other side of the end that was given
        const double half = axis.logarithmic ? 0.5 : lo == 0 ? 0.5 : 0.05 * std::abs(lo);
        if (axis.hi && !axis.lo) {
            lo = hi - 2 * half;
        } else if (axis.lo && !axis.hi) {
            hi = lo + 2 * half;
        } else {
            const double middle = lo;
            lo = middle - half;
            hi = middle + half;
        }
    } else {
        const double margin = 0.03 * (hi - lo);
        const auto moved = [&](double end, double by) {
            return end_at_zero && !axis.logarithmic && end * (end + by) <= 0 ? 0 : end + by;
        };
        if (!axis.lo) lo = moved(lo, -margin);
        if (!axis.hi) hi = moved(hi, margin);
    }
    return {axis.lo.value_or(from(lo)), axis.hi.value_or(from(hi)),
            !axis.logarithmic && !axis.lo && !axis.hi};
}

}  // namespace

void check(const Plot& plot) {
    const std::string where = fmt::format("plot '{}'", plot.title);
    check_axis(plot.x, "x", where);
    check_axis(plot.y, "y", where);
    if (plot.equal_scale && (plot.x.logarithmic || plot.y.logarithmic)) {
        throw DomainError(where + ": axes of equal scale cannot be logarithmic");
    }
    for (const Series& series : plot.series) {
        check_series(series, fmt::format("{}, series '{}'", where, series.name));
    }
}

Extents extents(const Plot& plot) {
    ShownValues x, y;
    for (const Series& series : plot.series) {
        for (std::size_t i = 0; i < series.x.size(); ++i) {
            if (!can_be_shown(plot, series.x[i], series.y[i])) continue;
            x.add(plot.x, series.x[i]);
            y.add(plot.y, series.y[i]);
            if (series.y_error.empty()) continue;
            y.add(plot.y, series.y[i] - series.y_error[i]);
            y.add(plot.y, series.y[i] + series.y_error[i]);
        }
    }
    if (plot.equal_scale) {
        x.add(plot.x, 0);
        y.add(plot.y, 0);
    }
    Extents result{extent(plot.x, x, !plot.equal_scale), extent(plot.y, y, !plot.equal_scale)};
    if (plot.equal_scale) {
        // The picture's height follows from its width: keep it between half of it and all of it.
        const double width = result.x.hi - result.x.lo, height = result.y.hi - result.y.lo;
        widen(result.x, plot.x, height);
        widen(result.y, plot.y, width / 2);
        result.x.round = result.y.round = false;
    }
    return result;
}

void widen(Extent& extent, const Axis& axis, double width) {
    const double missing = width - (extent.hi - extent.lo);
    if (missing <= 0 || (axis.lo && axis.hi)) return;
    const double below = axis.lo ? 0 : axis.hi ? missing : missing / 2;
    extent.lo -= below;
    extent.hi += missing - below;
}

bool can_be_shown(const Plot& plot, double x, double y) {
    return shown(plot.x, x) && shown(plot.y, y);
}

std::optional<ErrorBar> error_bar(const Plot& plot, const Series& series, std::size_t i) {
    if (series.y_error.empty() || !std::isfinite(series.y_error[i])) return {};
    const double low = series.y[i] - series.y_error[i];
    ErrorBar bar{low, series.y[i] + series.y_error[i]};
    // A bar that reaches 0 on a logarithmic axis goes down to its end.
    if (plot.y.logarithmic && !(low > 0)) bar.low.reset();
    return bar;
}

Look look_of(const Series& series, std::size_t index) {
    // The palette of Okabe and Ito, the yellow last: it is faint on white. [okabe-ito-2008]
    constexpr std::string_view kPalette[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                             "#e69f00", "#56b4e9", "#000000", "#f0e442"};
    constexpr std::string_view kSymbols[] = {"circle", "square", "triangle", "diamond"};
    constexpr std::size_t colours = std::size(kPalette), symbols = std::size(kSymbols);
    return {series.colour.empty() ? std::string(kPalette[index % colours]) : series.colour,
            kSymbols[(index + index / colours) % symbols]};
}

}  // namespace nacre::report
