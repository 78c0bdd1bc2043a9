#include "apps/datasheet/atlas.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "apps/datasheet/measurement_plots.h"
#include "apps/report/markup.h"
#include "apps/report/plot_svg.h"
#include "nacre/core/error.h"
#include "nacre/core/math.h"
#include "nacre/measure/instrument.h"
#include "nacre/nacre.h"
#include "nacre/paint/recipe.h"
#include "nacre/paint/recipe_parameter.h"
#include "nacre/spectra/observer.h"

namespace nacre::datasheet {

namespace {

std::string with_minus_sign(std::string text) {
    if (text.starts_with('-')) text.replace(0, 1, "−");
    return text;
}

}  // namespace

std::string degrees_text(double angle_deg) {
    return with_minus_sign(fmt::format("{:.4g}°", angle_deg));
}

std::string decimal_text(double value, int decimals) {
    std::string text = fmt::format("{:.{}f}", value, decimals);
    // What rounds to zero has no sign.
    if (text.find_first_not_of("-0.") == std::string::npos && text.starts_with('-'))
        text.erase(0, 1);
    return with_minus_sign(text);
}

std::string conditions_text(const measure::Conditions& conditions) {
    const measure::Aperture& aperture = conditions.aperture;
    const std::string apertures =
        aperture == measure::Aperture{}
            ? "point apertures"
            : fmt::format("cones of half angle {} (lamp) and {} (detector)",
                          degrees_text(aperture.lamp_half_angle_deg),
                          degrees_text(aperture.detector_half_angle_deg));
    return fmt::format("illuminant {}, {}° observer, {}", spectra::name(conditions.illuminant),
                       spectra::name(conditions.observer), apertures);
}

namespace {

void require_cells(std::size_t values, std::size_t geometries) {
    if (values == 0 || geometries == 0) {
        throw DomainError("an atlas needs at least one thickness and one angle");
    }
    if (values > kMaxAtlasCells / geometries) {
        throw DomainError(fmt::format("an atlas of {} x {} chips: must have at most {}", values,
                                      geometries, kMaxAtlasCells));
    }
}

constexpr const char* kMaking = "making the atlas";

double real_index(const optics::Material& binder, double wavelength_nm) {
    const optics::ComplexIndex index = binder.index(wavelength_nm);
    const Range range = paint::limits::kBinderIndex;
    if (!range.contains(index.real())) {
        throw DomainError(fmt::format("index of the binder = {} at {} nm: must be in {}",
                                      index.real(), wavelength_nm, range.text()));
    }
    return index.real();
}

/// Cosines [geometry][wavelength], and whether they are alike at all wavelengths.
struct Cosines {
    std::vector<std::vector<double>> values;
    bool alike = true;
};

Cosines cosines(const std::vector<measure::Geometry>& geometries, const optics::Material& binder,
                const std::vector<double>& wavelengths_nm) {
    Cosines result{{}, !binder.is_dispersive()};
    for (const measure::Geometry& geometry : geometries) {
        auto& row = result.values.emplace_back();
        for (const double wavelength : wavelengths_nm) {
            row.push_back(cos_on_flake(geometry, real_index(binder, wavelength)));
        }
    }
    return result;
}

/// Reflectance [geometry][wavelength], row-major.
std::vector<double> reflectance(const optics::Platelet& platelet, const optics::Material& binder,
                                const Cosines& cosines, const std::vector<double>& wavelengths_nm,
                                SharedProgress& work) {
    const std::size_t geometries = cosines.values.size(), n = wavelengths_nm.size();
    std::vector<double> column(geometries);
    const auto fill = [&](std::size_t w) {
        for (std::size_t g = 0; g < geometries; ++g) column[g] = cosines.values[g][w];
    };
    if (cosines.alike) {
        fill(0);
        return optics::platelet_table(platelet, binder, column, wavelengths_nm, &work).reflectance;
    }
    std::vector<double> result(geometries * n);
    for (std::size_t w = 0; w < n; ++w) {
        fill(w);
        const auto table = optics::platelet_table(platelet, binder, column,
                                                  std::span(wavelengths_nm).subspan(w, 1), &work);
        for (std::size_t g = 0; g < geometries; ++g) result[g * n + w] = table.reflectance[g];
    }
    return result;
}

std::string title_of(const AtlasFlake& flake) {
    std::string title;
    for (auto outer = flake.outer.rbegin(); outer != flake.outer.rend(); ++outer) {
        title += fmt::format("{} {:g} nm on ", outer->material.name(), outer->thickness_nm);
    }
    title += flake.film.name();
    if (flake.core) {
        title +=
            fmt::format(" on {} {:g} nm", flake.core->material.name(), flake.core->thickness_nm);
    }
    return title;
}

}  // namespace

double cos_on_flake(const measure::Geometry& geometry, double binder_index) {
    const double sin_i = std::sin(geometry.theta_i_deg * kDegree) / binder_index;
    const double sin_o = std::sin(geometry.theta_o_deg * kDegree) / binder_index;
    const double dot = std::sqrt((1 - sin_i * sin_i) * (1 - sin_o * sin_o)) +
                       sin_i * sin_o * std::cos(geometry.phi_deg * kDegree);
    return std::sqrt(std::clamp((1 + dot) / 2, 0.0, 1.0));
}

Atlas flake_atlas(const AtlasFlake& flake, const std::vector<double>& thickness_nm,
                  const std::vector<measure::Geometry>& geometries,
                  const std::vector<double>& wavelengths_nm, const measure::Conditions& conditions,
                  const Progress& progress) {
    require_cells(thickness_nm.size(), geometries.size());
    Atlas atlas{.title = title_of(flake),
                .quantity = fmt::format("thickness of {}, nm", flake.film.name()),
                .column = "thickness_nm",
                .caption = fmt::format(
                    "One flake in a binder of index {}: its reflectance where it mirrors the lamp "
                    "to the eye",
                    flake.binder.name()),
                .conditions = conditions,
                .values = thickness_nm,
                .geometries = geometries};
    atlas.lab.resize(thickness_nm.size() * geometries.size());
    const Cosines angles = cosines(geometries, flake.binder, wavelengths_nm);
    SharedProgress work(progress, static_cast<double>(thickness_nm.size()));
    for (std::size_t t = 0; t < thickness_nm.size(); ++t) {
        work.throw_if_stopped(kMaking);
        const optics::FilmPopulation film{flake.film, thickness_nm[t], flake.film_spread};
        optics::Platelet platelet{flake.core.value_or(film), {}};
        if (flake.core) platelet.coats.push_back(film);
        platelet.coats.insert(platelet.coats.end(), flake.outer.begin(), flake.outer.end());
        const auto values = reflectance(platelet, flake.binder, angles, wavelengths_nm, work);
        for (std::size_t g = 0; g < geometries.size(); ++g) {
            const auto first =
                values.begin() + static_cast<std::ptrdiff_t>(g * wavelengths_nm.size());
            atlas.lab[g * thickness_nm.size() + t] =
                measure::coloured(
                    geometries[g], wavelengths_nm,
                    {first, first + static_cast<std::ptrdiff_t>(wavelengths_nm.size())}, conditions)
                    .lab;
        }
        work.add();
    }
    work.throw_if_stopped(kMaking);
    return atlas;
}

Atlas recipe_atlas(const paint::Recipe& recipe, const std::string& key,
                   const std::vector<double>& values,
                   const std::vector<measure::Geometry>& geometries,
                   const std::vector<double>& wavelengths_nm, const measure::Conditions& conditions,
                   const Progress& progress, RecipeReader read) {
    require_cells(values.size(), geometries.size());
    if (!read) {
        read = [&](const paint::Recipe& changed, const Progress& callback) {
            return Paint(changed)
                .measure(geometries,
                         {.illuminant = conditions.illuminant,
                          .observer = conditions.observer,
                          .aperture = conditions.aperture,
                          .wavelengths_nm = wavelengths_nm},
                         callback)
                .measurement;
        };
    }
    // All values are checked before the first is solved.
    for (const double value : values) {
        paint::Recipe changed = recipe;
        paint::set_parameter(changed, key, value);
        paint::validate(changed, wavelengths_nm);
        paint::require_no_lean(changed, "an atlas is of paints that are");
    }
    Atlas atlas{
        .title = recipe.name.empty() ? "Paint" : recipe.name,
        .quantity = key,
        .column = key,
        .caption = "The whole paint, solved for each value, without the gloss of its surface",
        .conditions = conditions,
        .values = values,
        .geometries = geometries};
    atlas.lab.resize(values.size() * geometries.size());
    SharedProgress work(progress, static_cast<double>(values.size()));
    const Progress callback = [&](double) { return work.keep_going(); };
    for (std::size_t v = 0; v < values.size(); ++v) {
        work.throw_if_stopped(kMaking);
        paint::Recipe changed = recipe;
        paint::set_parameter(changed, key, values[v]);
        const measure::Measurement readings = read(changed, callback);
        for (std::size_t g = 0; g < geometries.size(); ++g) {
            atlas.lab[g * values.size() + v] = readings.readings[g].lab;
        }
        work.add();
    }
    work.throw_if_stopped(kMaking);
    return atlas;
}

namespace {

namespace style = report::style;
using report::svg_number;

constexpr double kLeft = 92, kRight = 24, kTop = 62, kFont = 13;
constexpr double kMaxWidth = 880;  // of all chips

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
    const double chip_width = std::clamp(std::floor(kMaxWidth / columns), 1.0, 56.0);
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
            const Vec3d& lab = atlas.at(g, v);
            csv += fmt::format("{},{},{},{:.4f},{:.4f},{:.4f},{:.4f},{:.2f},{}\n", atlas.values[v],
                               atlas.geometries[g].theta_i_deg, atlas.geometries[g].aspecular_deg,
                               lab[0], lab[1], lab[2], measure::chroma(lab), measure::hue_deg(lab),
                               chip(lab));
        }
    }
    return csv;
}

}  // namespace nacre::datasheet
