#include "apps/study/mir_colour.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <tuple>

#include "apps/study/mir_2022.h"
#include "nacre/bsdf/models/special_effect.h"
#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/measure/instrument.h"
#include "nacre/models/spectral_brdf.h"
#include "nacre/nacre.h"
#include "nacre/spectra/spectrum.h"

namespace nacre::study {

double ColourByAngle::chroma(std::size_t i) const { return std::hypot(lab[i][1], lab[i][2]); }

double ColourByAngle::saturation(std::size_t i) const {
    const double all = std::hypot(lab[i][0], chroma(i));
    // L* of the deepest black that a table of the microfacet's lobe still tells from none.
    return lab[i][0] > 1e-6 ? chroma(i) / all : 0.0;
}

ColourByAngle colour_by_angle(const std::string& file, const bsdf::Model& model) {
    const std::vector<double> wavelengths = spectra::default_wavelengths_nm();
    const auto surface = open(shipped_file(file)).appearance(model);
    const models::SpectralBrdf brdf(*surface, wavelengths);
    std::vector<measure::Geometry> geometries;
    for (int a = 0; a <= 110; a += 5) geometries.push_back(measure::in_plane(45, a));
    const measure::Measurement measurement = measure::measure(
        file,
        [&](double theta_i, double theta_o, double phi) { return brdf(theta_i, theta_o, phi); },
        wavelengths, geometries,
        {spectra::Illuminant::D65, spectra::Observer::cie1931_2deg, measure::Aperture{}});
    ColourByAngle colour;
    for (const measure::Reading& reading : measurement.readings) {
        colour.aspecular_deg.push_back(reading.geometry.aspecular_deg);
        colour.lab.push_back(reading.lab);
    }
    return colour;
}

namespace {

/// Draws the colour of a paint by one model into two plots.
void draw_colour(MirContext& context, const std::string& name, const std::string& file,
                 const bsdf::Model& model, report::Plot& travel, report::Plot& lightness) {
    const ColourByAngle colour = colour_by_angle(file, model);
    report::Series ab{.name = name, .dots = true};
    report::Series l{.name = name, .x = colour.aspecular_deg};
    nlohmann::json& results = context.results["colour"][name];
    for (std::size_t i = 0; i < colour.lab.size(); ++i) {
        const Vec3d& lab = colour.lab[i];
        ab.x.push_back(lab[1]);
        ab.y.push_back(lab[2]);
        ab.point_colours.push_back(spectra::css_colour(measure::srgb_chip_at_full_light(lab)));
        l.y.push_back(lab[0]);
        results.push_back({{"aspecular_deg", colour.aspecular_deg[i]}, {"lab", lab}});
    }
    travel.series.push_back(ab);
    lightness.series.push_back(l);
}

}  // namespace

void add_colours(MirContext& context) {
    report::Report& report = context.report;
    report.heading(2, "Colour against angle", "colour-against-angle");
    report.paragraph(
        "Lit from 45°, seen in the same plane from 0° to 110° away from the mirror direction, "
        "every 5°. Each dot has the colour it stands for (brightest lobes are shown at full "
        "light).");
    struct Group {
        const char* title;
        std::vector<std::tuple<std::string, std::string, bsdf::Model>> series;
    };
    std::vector<Group> groups = {
        {"Metallic gray and cadmium red",
         {{"metallic gray", "paints/metallic-gray.toml", named_model("microflake")},
          {"cadmium red", "paints/cadmium-red.toml", named_model("microflake")}}},
        {"Facets of Table 2",
         {{"570 nm", "studies/mir-2022/facets-570.toml", named_model("thin-film")},
          {"665 nm", "studies/mir-2022/facets-665.toml", named_model("thin-film")}}}};
    for (const auto& [name, file] : {std::pair{"80 nm of TiO₂", "paints/tio2-mica-80.toml"},
                                     {"110 nm of TiO₂", "paints/tio2-mica-110.toml"}}) {
        groups.push_back({name,
                          {{fmt::format("{}, microflake", name), file, named_model("microflake")},
                           {fmt::format("{}, thin-film", name), file, named_model("thin-film")}}});
    }
    for (const Group& group : groups) {
        report::Plot travel{.title = std::string(group.title) + ": colour travel",
                            .x = {.label = "a*"},
                            .y = {.label = "b*"},
                            .equal_scale = true};
        report::Plot lightness{.title = std::string(group.title) + ": lightness",
                               .x = {.label = "aspecular angle, degrees"},
                               .y = {.label = "L*"}};
        for (const auto& [name, file, model] : group.series) {
            draw_colour(context, name, file, model, travel, lightness);
        }
        report.plot(travel);
        report.plot(lightness);
    }
    report.paragraph(
        "`special-effect` has the colours of `thin-film` in the mean; its facets scatter about "
        "them. So do the flakes of `nacre` about the colours of `microflake`.");
}

namespace {

/// Whether the paper's words hold, row by row of Figure 4, at the angle that instruments begin with.
std::string what_was_found(const MirContext& context) {
    constexpr double kAngle = 15;
    const auto at = [&](const std::string& subject) {
        for (const nlohmann::json& reading : context.results["saturation"][subject]) {
            if (std::lround(reading["aspecular_deg"].get<double>()) == kAngle) {
                return reading["saturation"].get<double>();
            }
        }
        throw Error("saturation of " + subject + " was not measured");
    };
    std::string text = fmt::format("At {}°, where instruments begin, ", kAngle);
    for (const MirFigure4Row& row : kFigure4Rows) {
        const double flakes = at(fmt::format("flakes, {}", row.flakes_name)),
                     film = at(fmt::format("thin-film, {}", row.facets_name)),
                     facets = at(fmt::format("special-effect, {}", row.facets_name));
        const bool more = flakes > film && flakes > facets;
        text += fmt::format(
            "{}the flakes with {} have S = {:.2f}, beside {:.2f} and {:.2f} of the facets of {}: "
            "{} saturated, {} the paper finds",
            &row == kFigure4Rows ? "" : "; ", row.flakes_name, flakes, film, facets,
            row.facets_name, more ? "more" : "not more", more ? "as" : "which is not what");
    }
    return text + ".";
}

}  // namespace

void add_saturation(MirContext& context) {
    report::Report& report = context.report;
    report.heading(2, "Saturation by angle", "saturation");
    report.paragraph(
        "The paper finds the colour travel of the three alike and Ergun's colours more saturated, "
        "by eye. Measured: chroma C* of CIELAB, lit from 45°, by the angle from the mirror "
        "direction. C* grows with the light, and the facets' lobe is narrow; so the share of "
        "colour in what is seen, S = C* / √(L*² + C*²), stands beside it.");
    struct Subject {
        std::string name, file;
        bsdf::Model model;
    };
    const bsdf::Model guo = bsdf::SpecialEffectModel{.smooth_ndf = true};
    std::vector<Subject> subjects;
    for (const MirFigure4Row& row : kFigure4Rows) {
        subjects.push_back(
            {fmt::format("flakes, {}", row.flakes_name), row.flakes, named_model("microflake")});
        subjects.push_back(
            {fmt::format("thin-film, {}", row.facets_name), row.facets, named_model("thin-film")});
        subjects.push_back({fmt::format("special-effect, {}", row.facets_name), row.facets, guo});
    }
    constexpr int kShown[] = {0, 5, 10, 15, 20, 25, 30};
    report::Table table{.caption = "C* / S by angle from the mirror direction",
                        .columns = {"model, paint"}};
    for (int a : kShown) table.columns.push_back(fmt::format("{}°", a));
    report::Plot plot{.title = "Saturation against angle",
                      .caption = "Facets are black from some 35° on.",
                      .x = {.label = "aspecular angle, degrees", .hi = 60},
                      .y = {.label = "C* / √(L*² + C*²)", .lo = 0, .hi = 1}};
    for (const Subject& subject : subjects) {
        const ColourByAngle colour = colour_by_angle(subject.file, subject.model);
        report::Series series{.name = subject.name};
        std::vector<report::Cell> row = {{subject.name}};
        nlohmann::json& results = context.results["saturation"][subject.name];
        for (std::size_t i = 0; i < colour.lab.size(); ++i) {
            const double angle = colour.aspecular_deg[i];
            if (colour.lab[i][0] > 1) {
                series.x.push_back(angle);
                series.y.push_back(colour.saturation(i));
            }
            if (std::find(std::begin(kShown), std::end(kShown), std::lround(angle)) !=
                std::end(kShown)) {
                row.push_back(report::number_cell(
                    fmt::format("{:.0f} / {:.2f}", colour.chroma(i), colour.saturation(i))));
            }
            results.push_back({{"aspecular_deg", angle},
                               {"chroma", colour.chroma(i)},
                               {"saturation", colour.saturation(i)}});
        }
        plot.series.push_back(series);
        table.rows.push_back(std::move(row));
    }
    context.table("saturation", table);
    report.paragraph(what_was_found(context));
    report.plot(plot);
}

}  // namespace nacre::study
