#include "apps/report/plot_svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "apps/report/markup.h"
#include "apps/report/plot_frame.h"
#include "nacre/core/error.h"

namespace nacre::report {

std::string svg_number(double pixels) {
    // Rasterisers count in 24 bits before the point.
    constexpr double kFar = 1e5;
    const double rounded = std::round(100 * std::clamp(pixels, -kFar, kFar)) / 100;
    return fmt::format("{}", rounded == 0 ? 0.0 : rounded);  // no -0
}

std::string symbol_path(std::string_view symbol, double radius) {
    const double area = std::numbers::pi * radius * radius;
    if (symbol == "square") {
        const double side = std::sqrt(area);
        return fmt::format("M{0} {0}h{1}v{1}h-{1}z", svg_number(-side / 2), svg_number(side));
    }
    if (symbol == "triangle") {
        // Equilateral, its centroid at the point.
        const double side = std::sqrt(4 * area / std::numbers::sqrt3);
        const double height = side * std::numbers::sqrt3 / 2;
        return fmt::format("M0 {}L{} {}H{}z", svg_number(-2 * height / 3), svg_number(side / 2),
                           svg_number(height / 3), svg_number(-side / 2));
    }
    if (symbol == "diamond") {
        const double half = std::sqrt(area / 2);
        return fmt::format("M0 -{0}L{0} 0L0 {0}L-{0} 0z", svg_number(half));
    }
    return fmt::format("M-{0} 0a{0} {0} 0 1 0 {1} 0a{0} {0} 0 1 0 -{1} 0z", svg_number(radius),
                       svg_number(2 * radius));
}

double text_width(std::string_view utf8, double font_px) {
    // The mean width of a letter in DejaVu Sans, one of the widest faces in use, is 0.6 em.
    constexpr double kEmPerLetter = 0.62;
    double letters = 0;
    for (const char c : utf8) letters += (static_cast<unsigned char>(c) & 0xC0) != 0x80;
    return kEmPerLetter * font_px * letters;
}

std::string legend_key(const Series& series, const Look& look) {
    std::string key;
    if (series.line) {
        key += fmt::format(
            "<path d=\"M0 6H32\" stroke=\"{}\" stroke-width=\"{}\"{}/>", look.colour,
            style::kLineWidth,
            series.dashed ? fmt::format(" stroke-dasharray=\"{}\"", style::kDashes) : "");
    }
    if (series.dots) {
        // Dots with colours of their own are shown empty.
        const bool own = !series.point_colours.empty();
        key +=
            fmt::format("<path transform=\"translate(16 6)\" d=\"{}\" fill=\"{}\" stroke=\"{}\"/>",
                        symbol_path(look.symbol, style::kDotRadius),
                        own ? style::kPaper : look.colour, own ? style::kOwnDotEdge : look.colour);
    }
    return key;
}

Legend legend_svg(const Plot& plot, Pixel corner, double right) {
    constexpr double kRow = 20, kKey = 32, kGap = 8, kEntrySpacing = 22;
    Legend legend;
    Pixel at = corner;
    for (std::size_t i = 0; i < plot.series.size(); ++i) {
        const Series& series = plot.series[i];
        if (series.name.empty()) continue;
        const std::string name = clean_utf8(series.name);
        const double width = kKey + kGap + text_width(name, style::kTickFont);
        if (at.x > corner.x && at.x + width > right) at = {corner.x, at.y + kRow};
        legend.svg += fmt::format(
            "<g transform=\"translate({} {})\">{}<text x=\"{}\" y=\"10.5\">{}</text></g>\n",
            svg_number(at.x), svg_number(at.y), legend_key(series, look_of(series, i)), kKey + kGap,
            escape_html(name));
        legend.height = at.y + kRow - corner.y;
        at.x += width + kEntrySpacing;
    }
    return legend;
}

namespace {

std::string num(double pixels) { return svg_number(pixels); }

std::string line(double x1, double y1, double x2, double y2, const std::string& attributes) {
    return fmt::format("<path d=\"M{} {}L{} {}\" {}/>\n", num(x1), num(y1), num(x2), num(y2),
                       attributes);
}

/// @param anchor  start, middle or end
std::string text(double x, double y, const char* anchor, const std::string& words,
                 const std::string& attributes = {}) {
    if (words.empty()) return {};
    return fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"{}\"{}{}>{}</text>\n", num(x), num(y),
                       anchor, attributes.empty() ? "" : " ", attributes, escape_html(words));
}

std::vector<Tick> ticks_of(const Axis& axis, const Extent& extent, double length_px,
                           double spacing_px) {
    const double count = tick_count(length_px, spacing_px);
    return axis.logarithmic ? logarithmic_ticks(extent.lo, extent.hi, count)
                            : linear_ticks(extent.lo, extent.hi, count);
}

std::string axes_svg(const Plot& plot, const PlotFrame& frame) {
    const Box& box = frame.box();
    const bool equal = plot.equal_scale;
    const auto x_ticks = ticks_of(plot.x, frame.ends().x, box.width(),
                                  equal ? style::kTickSpacingEqual : style::kTickSpacingX);
    const auto y_ticks = ticks_of(plot.y, frame.ends().y, box.height(),
                                  equal ? style::kTickSpacingEqual : style::kTickSpacingY);
    std::string grid, numbers;
    for (const Tick& tick : x_ticks) {
        const double x = frame.x(tick.value);
        grid += fmt::format("M{0} {1}V{2}", num(x), num(box.top), num(box.bottom));
        numbers += text(x, box.bottom + 18, "middle", tick.text);
    }
    for (const Tick& tick : y_ticks) {
        const double y = frame.y(tick.value);
        grid += fmt::format("M{0} {1}H{2}", num(box.left), num(y), num(box.right));
        numbers += text(box.left - 8, y + style::kTickFont * 0.35, "end", tick.text);
    }
    std::string svg;
    if (!grid.empty()) {
        svg += fmt::format(
            "<path d=\"{}\" stroke=\"{}\" stroke-opacity=\"{}\" stroke-width=\"0.8\"/>\n", grid,
            style::kGrid, style::kGridOpacity);
    }
    if (equal) {
        const std::string look = fmt::format("stroke=\"{}\"", style::kZero);
        if (frame.contains(0, frame.ends().y.lo)) {
            svg += line(frame.x(0), box.top, frame.x(0), box.bottom, look);
        }
        if (frame.contains(frame.ends().x.lo, 0)) {
            svg += line(box.left, frame.y(0), box.right, frame.y(0), look);
        }
    } else {
        svg += fmt::format(
            "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"{}\"/>\n",
            num(box.left), num(box.top), num(box.width()), num(box.height()), style::kFrame);
    }
    svg += numbers;
    svg += text((box.left + box.right) / 2, box.bottom + 38, "middle", plot.x.label);
    svg += text(box.left - style::kNumbers, box.top - 12, "start", plot.y.label);
    return svg;
}

/// Lines and bars; the caller cuts them off at the frame.
std::string lines_svg(const Plot& plot, const PlotFrame& frame, const Series& series,
                      const Look& look) {
    std::string bars, path;
    bool pen_down = false, single = false;
    const auto end_run = [&] {
        // A point between two gaps: a line of no length, which round caps make a dot.
        if (single) path += "h0";
        pen_down = single = false;
    };
    for (std::size_t i = 0; i < series.x.size(); ++i) {
        if (!can_be_shown(plot, series.x[i], series.y[i])) {
            end_run();
            continue;
        }
        const Pixel at = frame.at(series.x[i], series.y[i]);
        path += fmt::format("{}{} {}", pen_down ? 'L' : 'M', num(at.x), num(at.y));
        single = !pen_down;
        pen_down = true;
        if (const auto bar = error_bar(plot, series, i)) {
            const double foot = bar->low ? frame.y(*bar->low) : frame.box().bottom;
            bars += fmt::format("M{} {}V{}", num(at.x), num(foot), num(frame.y(bar->high)));
        }
    }
    end_run();
    std::string svg;
    if (!bars.empty()) {
        svg += fmt::format(
            "<path d=\"{}\" stroke=\"{}\" stroke-width=\"{}\" stroke-opacity=\"{}\"/>\n", bars,
            look.colour, style::kBarWidth, style::kBarOpacity);
    }
    if (series.line && !path.empty()) {
        svg += fmt::format(
            "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" "
            "stroke-linejoin=\"round\" stroke-linecap=\"round\"{}/>\n",
            path, look.colour, style::kLineWidth,
            series.dashed ? fmt::format(" stroke-dasharray=\"{}\"", style::kDashes) : "");
    }
    return svg;
}

/// What the pointer shows at a point.
std::string reading(const Plot& plot, const Series& series, std::size_t i) {
    std::vector<std::string> names, lines;
    if (!series.name.empty()) names.push_back(series.name);
    if (!series.point_labels.empty() && !series.point_labels[i].empty()) {
        names.push_back(series.point_labels[i]);
    }
    if (!names.empty()) lines.push_back(fmt::format("{}", fmt::join(names, ", ")));
    const auto add = [&](const Axis& axis, const std::string& number) {
        lines.push_back(axis.label.empty() ? number : axis.label + ": " + number);
    };
    add(plot.x, fmt::format("{:.4g}", series.x[i]));
    const bool bar = error_bar(plot, series, i).has_value();
    add(plot.y, fmt::format("{:.4g}", series.y[i]) +
                    (bar ? fmt::format(" ± {:.2g}", series.y_error[i]) : ""));
    return fmt::format("{}", fmt::join(lines, "\n"));
}

/// Dots on the points of a series, in their own colours if it has some.
/// @param look  attributes of all of them
std::string dots_svg(const Plot& plot, const PlotFrame& frame, const Series& series,
                     const std::string& outline, const std::string& look) {
    std::string dots;
    for (std::size_t i = 0; i < series.x.size(); ++i) {
        const double x = series.x[i], y = series.y[i];
        if (!can_be_shown(plot, x, y) || !frame.contains(x, y)) continue;
        dots += fmt::format(
            "<path transform=\"translate({} {})\" d=\"{}\"{}><title>{}</title></path>\n",
            num(frame.x(x)), num(frame.y(y)), outline,
            series.dots && !series.point_colours.empty()
                ? fmt::format(" fill=\"{}\"", series.point_colours[i])
                : "",
            escape_html(reading(plot, series, i)));
    }
    return dots.empty() ? dots : "<g " + look + ">\n" + dots + "</g>\n";
}

std::string visible_dots_svg(const Plot& plot, const PlotFrame& frame, const Series& series,
                             const Look& look) {
    if (!series.dots) return {};
    const bool own = !series.point_colours.empty();
    return dots_svg(plot, frame, series,
                    symbol_path(look.symbol, own ? style::kOwnDotRadius : style::kDotRadius),
                    fmt::format("fill=\"{}\" stroke=\"{}\"", look.colour,
                                own ? style::kOwnDotEdge : style::kPaper));
}

/// Dots to be found by the pointer alone, on the points of series that have no others.
std::string invisible_dots_svg(const Plot& plot, const PlotFrame& frame) {
    std::size_t count = 0;
    for (const Series& series : plot.series) count += series.dots ? 0 : series.x.size();
    if (count > kMaxInvisibleDots) return {};
    std::string svg;
    for (const Series& series : plot.series) {
        if (series.dots) continue;
        svg += dots_svg(plot, frame, series, symbol_path("circle", style::kInvisibleDotRadius),
                        "fill=\"none\" pointer-events=\"all\"");
    }
    return svg;
}

/// Whether no point but the last has a label.
bool labels_only_its_end(const Series& series) {
    const auto& labels = series.point_labels;
    return labels.size() > 1 && std::all_of(labels.begin(), labels.end() - 1,
                                            [](const std::string& text) { return text.empty(); });
}

std::string labels_svg(const Plot& plot, const PlotFrame& frame, const Series& series) {
    if (series.point_labels.empty()) return {};
    std::vector<Pixel> pixels;
    std::vector<std::size_t> shown;
    for (std::size_t i = 0; i < series.x.size(); ++i) {
        if (!can_be_shown(plot, series.x[i], series.y[i])) continue;
        pixels.push_back(frame.at(series.x[i], series.y[i]));
        shown.push_back(i);
    }
    std::vector<int> sides = label_sides(pixels);
    // It names the line: to the right of its end.
    if (labels_only_its_end(series) && !sides.empty()) sides.back() = 0;
    // A white outline, drawn first, keeps the words readable on lines.
    const std::string look = fmt::format(
        "font-size=\"{}\" fill=\"{}\" stroke=\"{}\" stroke-width=\"3\" "
        "stroke-linejoin=\"round\" paint-order=\"stroke\"",
        style::kLabelFont, style::kPointLabel, style::kPaper);
    std::string svg;
    for (std::size_t k = 0; k < shown.size(); ++k) {
        const std::size_t i = shown[k];
        if (!frame.contains(series.x[i], series.y[i])) continue;
        const Pixel d = side_direction(sides[k]);
        const char* anchor = d.x > 0.1 ? "start" : d.x < -0.1 ? "end" : "middle";
        // The baseline: below the point for words under it, at it for those above.
        const double drop = style::kLabelFont * (d.y > 0.1 ? 0.75 : d.y < -0.1 ? 0.0 : 0.35);
        svg += text(pixels[k].x + style::kLabelDistance * d.x,
                    pixels[k].y + style::kLabelDistance * d.y + drop, anchor,
                    series.point_labels[i], look);
    }
    return svg;
}

/// Its contents keep their coordinates, and what lies outside the box does not show. An inner <svg>
/// needs no id, unlike a clip path.
std::string clipped(const Box& box, const std::string& contents) {
    if (contents.empty()) return {};
    const std::string place = fmt::format("{} {} {} {}", num(box.left), num(box.top),
                                          num(box.width()), num(box.height()));
    return fmt::format(
        "<svg x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" viewBox=\"{}\" "
        "overflow=\"hidden\">\n{}</svg>\n",
        num(box.left), num(box.top), num(box.width()), num(box.height()), place, contents);
}

/// As in "Lightness: L* against aspecular angle, degrees".
std::string spoken_title(const Plot& plot, const std::string& title) {
    const std::string axes = plot.y.label + " against " + plot.x.label;
    return title.empty() ? axes : title + ": " + axes;
}

}  // namespace

std::string plot_svg(const Plot& plot, const SvgSize& size, TitleAndLegend words) {
    check(plot);
    const std::string where = fmt::format("plot '{}'", plot.title);
    require_in_range(size.width_px, kMinSvg, kMaxSvg, (where + ": width in px").c_str());
    require_in_range(size.height_px, kMinSvg, kMaxSvg, (where + ": height in px").c_str());

    const bool alone = words == TitleAndLegend::inside;
    const std::string title = clean_utf8(markup_to_plain(plot.title));
    const double indent = alone ? style::kIndent : 0;
    const double title_height = alone && !title.empty() ? 26 : 0;
    const Legend legend =
        alone ? legend_svg(plot, {indent, title_height + 6}, size.width_px - style::kMarginRight)
              : Legend{};
    Box box{indent + style::kNumbers, title_height + legend.height + style::kMarginTop,
            size.width_px - style::kMarginRight, size.height_px - style::kMarginBottom};
    // However much stands above it, some of the plot remains.
    box.bottom = std::max(box.bottom, box.top + 40);
    const PlotFrame frame = fit_frame(plot, box);

    std::string inside, labels, dots;
    bool empty = true;
    for (std::size_t i = 0; i < plot.series.size(); ++i) {
        const Series& series = plot.series[i];
        const Look look = look_of(series, i);
        inside += lines_svg(plot, frame, series, look);
        labels += labels_svg(plot, frame, series);
        dots += visible_dots_svg(plot, frame, series, look);
        for (std::size_t p = 0; p < series.x.size(); ++p) {
            empty = empty && !can_be_shown(plot, series.x[p], series.y[p]);
        }
    }

    const double height = std::max(size.height_px, box.bottom + style::kMarginBottom);
    std::string svg = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
        "viewBox=\"0 0 {0} {1}\" font-family=\"sans-serif\" font-size=\"{2}\" fill=\"{3}\" "
        "role=\"img\"",
        num(size.width_px), num(height), style::kTickFont, style::kText);
    if (alone) {
        svg += ">\n<title>" + escape_html(title) + "</title>\n";
        if (!plot.caption.empty()) {
            svg += "<desc>" + escape_html(markup_to_plain(plot.caption)) + "</desc>\n";
        }
    } else {
        // A <title> would show wherever the pointer is.
        svg += " aria-label=\"" + escape_html(spoken_title(plot, title)) + "\">\n";
    }
    svg += fmt::format("<rect width=\"{}\" height=\"{}\" fill=\"{}\"/>\n", num(size.width_px),
                       num(height), style::kPaper);
    if (alone) {
        svg += text(indent, 20, "start", title, "font-size=\"15\" font-weight=\"bold\"");
    }
    svg += legend.svg + axes_svg(plot, frame) + clipped(frame.box(), inside) + labels +
           invisible_dots_svg(plot, frame) + dots;
    if (empty) {
        const Box& b = frame.box();
        svg += text((b.left + b.right) / 2, (b.top + b.bottom) / 2, "middle",
                    "No point can be shown", fmt::format("fill=\"{}\"", style::kFaintText));
    }
    return svg + "</svg>\n";
}

}  // namespace nacre::report
