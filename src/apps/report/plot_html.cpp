#include <fmt/format.h>

#include "apps/report/markup.h"
#include "apps/report/parts.h"
#include "apps/report/plot_data.h"
#include "apps/report/plot_svg.h"
#include "nacre/core/error.h"

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

std::string numbers_html(const Plot& plot) {
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

}  // namespace

std::string plot_html(const Plot& plot, int number) {
    const std::string data = plot_json(plot);
    std::string html = fmt::format("<figure class=\"plot\" id=\"plot_{}\">\n", number);
    if (!plot.title.empty()) {
        html += "<p class=\"plot-title\">" + markup_to_html(plot.title) + "</p>\n";
    }
    html += legend_html(plot);
    html += fmt::format("<div class=\"canvas{}\" role=\"img\" aria-label=\"{}\"></div>\n",
                        plot.equal_scale ? " equal" : "", escape_html(markup_to_plain(plot.title)));
    html += "<noscript><p>JavaScript draws this plot; its numbers stand below.</p></noscript>\n";
    if (!plot.caption.empty()) {
        html += "<figcaption>" + markup_to_html(plot.caption) + "</figcaption>\n";
    }
    html += numbers_html(plot);
    return html + "<script type=\"application/json\">" + escape_json(data) +
           "</script>\n</figure>\n";
}

std::string static_plot_html(const Plot& plot, const SvgSize& size) {
    std::string html = "<figure class=\"plot static\">\n" + plot_svg(plot, size);
    if (!plot.caption.empty()) {
        html += "<figcaption>" + markup_to_html(plot.caption) + "</figcaption>\n";
    }
    return html + "</figure>\n";
}

}  // namespace nacre::report
