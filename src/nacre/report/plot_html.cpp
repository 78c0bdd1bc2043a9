#include "nacre/core/error.h"
#include "nacre/report/escape.h"
#include "nacre/report/markup.h"
#include "nacre/report/parts.h"
#include "nacre/report/plot_data.h"

namespace nacre::report {

namespace {

// The symbols of d3 in a legend, about (16, 6).
std::string_view symbol_path(std::string_view symbol) {
    if (symbol == "square") return "M12.2 2.2h7.6v7.6h-7.6z";
    if (symbol == "triangle") return "M16 1L20.8 9.4H11.2z";
    if (symbol == "diamond") return "M16 .4L19.4 6L16 11.6L12.6 6z";
    return "M11.7 6a4.3 4.3 0 1 0 8.6 0a4.3 4.3 0 1 0 -8.6 0z";
}

std::string legend_html(const Plot& plot) {
    std::string items;
    for (std::size_t i = 0; i < plot.series.size(); ++i) {
        const Series& series = plot.series[i];
        if (series.name.empty()) continue;
        const Look look = look_of(series, i);
        items += "<li><svg width=\"32\" height=\"12\" aria-hidden=\"true\">";
        if (series.line) {
            items += fmt::format("<path d=\"M0 6H32\" stroke=\"{}\" stroke-width=\"2\"{}/>",
                                 look.colour, series.dashed ? " stroke-dasharray=\"6 4\"" : "");
        }
        if (series.dots) {
            // Dots with colours of their own are shown empty.
            const bool own = !series.point_colours.empty();
            items +=
                fmt::format("<path d=\"{}\" fill=\"{}\" stroke=\"{}\"/>", symbol_path(look.symbol),
                            own ? "#ffffff" : look.colour, own ? "#333333" : look.colour);
        }
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

}  // namespace nacre::report
