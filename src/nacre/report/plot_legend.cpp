#include "nacre/report/plot_legend.h"

#include <fmt/format.h>

#include "nacre/report/escape.h"
#include "nacre/report/plot_style.h"
#include "nacre/report/symbol.h"

namespace nacre::report {

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
    constexpr double kRow = 20, kKey = 32, kGap = 8, kBetween = 22;
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
        at.x += width + kBetween;
    }
    return legend;
}

}  // namespace nacre::report
