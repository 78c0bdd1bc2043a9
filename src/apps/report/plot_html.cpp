#include <fmt/format.h>

#include <algorithm>

#include "apps/report/markup.h"
#include "apps/report/parts.h"
#include "apps/report/plot_data.h"
#include "apps/report/plot_svg.h"

namespace nacre::report {

namespace {

std::string legend_html(const Plot& plot) {
    std::string items;
    for (std::size_t i = 0; i < plot.series.size(); ++i) {
        const Series& series = plot.series[i];
        if (series.name.empty()) continue;
        items += "<li><svg width=\"32\" height=\"12\" aria-hidden=\"true\">";
        items += legend_key(series, look_of(series, i));
        items += "</svg>" + escape_html(series.name) + "</li>\n";
    }
    return items.empty() ? items : "<ul class=\"legend\">\n" + items + "</ul>\n";
}

}  // namespace

SvgSize page_size(const Plot& plot) {
    check(plot);
    if (!plot.equal_scale) return {.width_px = 560, .height_px = 320};
    // As high as the data ask; their own ends may ask for a tower or a ribbon.
    constexpr double kWidth = 460;
    const Extents ends = extents(plot);
    const double ratio = (ends.y.hi - ends.y.lo) / (ends.x.hi - ends.x.lo);
    return {.width_px = kWidth,
            .height_px =
                std::clamp(ratio, 0.5, 1.0) * (kWidth - style::kNumbers - style::kMarginRight) +
                style::kMarginTop + style::kMarginBottom};
}

std::string plot_html(const Plot& plot, const SvgSize& size, const std::string& after) {
    const std::string drawing = plot_svg(plot, size, TitleAndLegend::around);
    std::string html = "<figure class=\"plot\">\n";
    if (!plot.title.empty()) {
        html += "<p class=\"plot-title\">" + markup_to_html(plot.title) + "</p>\n";
    }
    html += legend_html(plot);
    html += fmt::format("<div class=\"drawing\" tabindex=\"0\" style=\"--width:{}\">\n{}</div>\n",
                        svg_number(size.width_px), drawing);
    if (!plot.caption.empty()) {
        html += "<figcaption>" + markup_to_html(plot.caption) + "</figcaption>\n";
    }
    return html + after + "</figure>\n";
}

std::string numbers_html(const Plot& plot) {
    check(plot);
    std::string html =
        "<details><summary>Numbers</summary>\n<div class=\"scroll\" tabindex=\"0\"><table>\n";
    for (const Series& series : plot.series) {
        const bool labels = !series.point_labels.empty(), errors = !series.y_error.empty();
        html += fmt::format("<tbody>\n<tr><th scope=\"rowgroup\" colspan=\"4\">{}</th></tr>\n",
                            escape_html(series.name));
        html +=
            fmt::format("<tr><th></th><th scope=\"col\">{}</th><th scope=\"col\">{}</th>{}</tr>\n",
                        escape_html(plot.x.label), escape_html(plot.y.label),
                        errors ? "<th scope=\"col\">±</th>" : "<th></th>");
        for (std::size_t i = 0; i < series.x.size(); ++i) {
            html +=
                fmt::format("<tr><td>{}</td><td>{:.6g}</td><td>{:.6g}</td><td>{}</td></tr>\n",
                            labels ? escape_html(series.point_labels[i]) : "", series.x[i],
                            series.y[i], errors ? fmt::format("{:.3g}", series.y_error[i]) : "");
        }
        html += "</tbody>\n";
    }
    return html + "</table></div></details>\n";
}

}  // namespace nacre::report
