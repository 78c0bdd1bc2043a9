#include "nacre/panel/atlas_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "nacre/panel/measurement_plots.h"
#include "nacre/panel/texts.h"
#include "nacre/report/escape.h"
#include "nacre/report/plot_legend.h"
#include "nacre/report/plot_style.h"
#include "nacre/report/symbol.h"

namespace nacre::panel {

namespace {

namespace style = report::style;
using report::svg_number;

constexpr double kLeft = 92, kRight = 24, kTop = 62, kFont = 13;
constexpr double kMostWidth = 880;  // of all chips

struct Text {
    const char* anchor = "start";
    double font_px = kFont;
    const char* colour = style::kText;
    bool bold = false;
};

std::string text_svg(double x, double y, const std::string& words, const Text& look) {
    return fmt::format(
        "<text x=\"{}\" y=\"{}\" text-anchor=\"{}\" font-size=\"{}\" fill=\"{}\"{}>{}</text>\n",
        svg_number(x), svg_number(y), look.anchor, look.font_px, look.colour,
        look.bold ? " font-weight=\"bold\"" : "", report::escape_html(words));
}

/// Words in lines of at most `width` px.
std::vector<std::string> wrapped(const std::string& words, double font_px, double width) {
    std::vector<std::string> lines(1);
    for (std::size_t at = 0; at < words.size();) {
        const std::size_t end = std::min(words.find(' ', at), words.size());
        const std::string word = words.substr(at, end - at);
        std::string& line = lines.back();
        if (line.empty()) {
            line = word;
        } else if (report::text_width(line + " " + word, font_px) <= width) {
            line += " " + word;
        } else {
            lines.push_back(word);
        }
        at = end + 1;
    }
    return lines;
}

/// Every so many columns carry a number: 1, 2, 5, 10, ...
std::size_t labelled_step(const std::vector<std::string>& labels, double chip_width) {
    double widest = 0;
    for (const std::string& label : labels) {
        widest = std::max(widest, report::text_width(label, kFont) + 8);
    }
    const auto needed = static_cast<std::size_t>(std::ceil(widest / chip_width));
    for (std::size_t power = 1;; power *= 10) {
        for (const std::size_t digit : {1, 2, 5}) {
            if (digit * power >= needed) return digit * power;
        }
    }
}

bool one_lamp(const Atlas& atlas) {
    return std::all_of(atlas.geometries.begin(), atlas.geometries.end(), [&](const auto& g) {
        return g.theta_i_deg == atlas.geometries[0].theta_i_deg;
    });
}

}  // namespace

std::string atlas_svg(const Atlas& atlas) {
    const auto columns = static_cast<double>(atlas.values.size());
    const double chip_width = std::clamp(std::floor(kMostWidth / columns), 1.0, 56.0);
    const double chip_height = atlas.geometries.size() <= 12 ? 44 : 22;
    const double width = std::max(480.0, kLeft + columns * chip_width + kRight);
    const double bottom = kTop + chip_height * static_cast<double>(atlas.geometries.size());

    std::string svg;
    for (std::size_t g = 0; g < atlas.geometries.size(); ++g) {
        const double y = kTop + chip_height * static_cast<double>(g);
        const measure::Geometry& geometry = atlas.geometries[g];
        const bool plain = one_lamp(atlas) && measure::is_in_plane(geometry);
        svg += text_svg(kLeft - 10, y + chip_height / 2 + 0.35 * kFont,
                        plain ? degrees_text(geometry.aspecular_deg) : geometry.name,
                        {.anchor = "end"});
        for (std::size_t v = 0; v < atlas.values.size(); ++v) {
            svg +=
                fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n",
                            svg_number(kLeft + chip_width * static_cast<double>(v)), svg_number(y),
                            svg_number(chip_width), svg_number(chip_height), chip(atlas.at(g, v)));
        }
    }
    std::vector<std::string> labels;
    for (const double value : atlas.values) labels.push_back(fmt::format("{:.6g}", value));
    const std::size_t step = labelled_step(labels, chip_width);
    for (std::size_t v = 0; v < labels.size(); v += step) {
        svg += text_svg(kLeft + chip_width * (static_cast<double>(v) + 0.5), bottom + 19, labels[v],
                        {.anchor = "middle"});
    }
    svg += text_svg(kLeft + columns * chip_width / 2, bottom + 39, atlas.quantity,
                    {.anchor = "middle"});
    svg += text_svg(14, 24, atlas.title, {.font_px = 16, .bold = true});
    svg += text_svg(14, 50,
                    one_lamp(atlas) ? fmt::format("aspecular angle, lamp at {}",
                                                  degrees_text(atlas.geometries[0].theta_i_deg))
                                    : std::string("lamp, aspecular angle"),
                    {});
    double y = bottom + 64;
    for (const std::string& line :
         wrapped(atlas.caption + "; " + conditions_text(atlas.conditions) + ".", 12, width - 28)) {
        svg += text_svg(14, y, line, {.font_px = 12, .colour = style::kFaintText});
        y += 16;
    }
    // Chips that touch: edges must stay sharp.
    return fmt::format(
               "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 "
               "0 "
               "{0} {1}\" font-family=\"sans-serif\" shape-rendering=\"crispEdges\">\n<title>{2}"
               "</title>\n<rect width=\"{0}\" height=\"{1}\" fill=\"{3}\"/>\n",
               svg_number(width), svg_number(y), report::escape_html(atlas.title), style::kPaper) +
           svg + "</svg>\n";
}

std::string atlas_csv(const Atlas& atlas) {
    std::string csv = atlas.column + ",theta_i,aspecular_deg,L,a,b,C,h,chip\n";
    for (std::size_t v = 0; v < atlas.values.size(); ++v) {
        for (std::size_t g = 0; g < atlas.geometries.size(); ++g) {
            const spectra::Vec3& lab = atlas.at(g, v);
            fmt::format_to(
                std::back_inserter(csv), "{},{},{},{:.4f},{:.4f},{:.4f},{:.4f},{:.2f},{}\n",
                atlas.values[v], atlas.geometries[g].theta_i_deg, atlas.geometries[g].aspecular_deg,
                lab[0], lab[1], lab[2], measure::chroma(lab), measure::hue_deg(lab), chip(lab));
        }
    }
    return csv;
}

}  // namespace nacre::panel
