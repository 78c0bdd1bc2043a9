#include "apps/datasheet/datasheet.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "apps/datasheet/atlas.h"
#include "apps/datasheet/composition.h"
#include "apps/datasheet/measurement_plots.h"
#include "apps/report/markup.h"
#include "apps/report/page.h"
#include "apps/report/parts.h"
#include "nacre/core/error.h"
#include "nacre/core/version.h"
#include "nacre/measure/measurement.h"
#include "nacre/render/builtin_scenes.h"
#include "nacre/render/render.h"
#include "nacre/render/render_image.h"

namespace nacre::datasheet {

std::string painted_picture(std::shared_ptr<const bsdf::Bsdf> paint,
                            const PictureSettings& settings, const Progress& progress) {
    const render::SceneDescription description = render::builtin_scene(settings.scene);
    render::PaintTable paints;
    for (const auto& [name, material] : description.materials) {
        if (std::holds_alternative<render::PaintMaterial>(material)) paints[name] = paint;
    }
    const render::Scene scene(description, paints);
    const render::RenderResult result =
        render::render(scene,
                       {.width = settings.width,
                        .height = settings.height,
                        .samples_per_pixel = settings.samples_per_pixel,
                        .seed = settings.seed},
                       progress);
    if (!result.complete) throw Error("stopped");
    io::Image image = render::image_of(result, {});
    image.metadata.clear();  // such as the time it took: a report made twice is the same
    return io::encode_png(image, "a picture of " + settings.scene);
}

namespace {

using measure::Measurement;
using measure::Reading;
using report::escape_html;

/// More chips would be too small to compare: then only those lit from one angle are drawn.
constexpr std::size_t kMaxChips = 24;

std::string heading(const std::string& words) { return "<h2>" + escape_html(words) + "</h2>\n"; }

std::string paragraph(const std::string& words, const char* look = "") {
    return fmt::format("<p{}>{}</p>\n", look, escape_html(words));
}

// ----------------------------------------------------------------------------- metrics

struct Metric {
    std::string name, value, note;
};

/// "12.3", with "standard 11.9" beside it.
Metric compared(const char* name, const std::optional<double>& value,
                const std::optional<double>& standard, int decimals) {
    const auto text = [&](const std::optional<double>& v) {
        return v ? decimal_text(*v, decimals) : std::string("none");
    };
    return {name, text(value), standard ? "standard " + text(standard) : ""};
}

std::string uncertain(const Estimate& estimate) {
    const double error = estimate.standard_error;
    if (estimate.value == 0 && error == 0) return "0";
    // As many digits as the error leaves.
    const int decimals = std::isfinite(error) && error > 0
                             ? std::clamp(static_cast<int>(-std::floor(std::log10(error))), 0, 3)
                             : 1;
    std::string text = decimal_text(estimate.value, decimals);
    if (std::isfinite(error)) text += " ± " + decimal_text(error, decimals);
    return text;
}

/// Adds " ± 0.3" where it is known.
std::string with_deviation(std::string text, const std::optional<double>& deviation, int decimals) {
    if (!deviation) return text;
    const double smallest = std::pow(10.0, -decimals);
    if (*deviation > 0 && *deviation < smallest / 2) {
        return text + " ± <" + decimal_text(smallest, decimals);
    }
    return text + " ± " + decimal_text(*deviation, decimals);
}

/// The standard deviation of a metric.
std::optional<double> deviation_of(const std::optional<fit::MetricUncertainty>& metric) {
    return metric ? std::optional(metric->best()) : std::nullopt;
}

std::vector<Metric> metrics(const PanelReport& report) {
    const Measurement& sample = report.sample;
    const Measurement* standard = report.standard ? &report.standard->measurement : nullptr;
    const auto of_standard = [&](const auto& quantity) -> std::optional<double> {
        return standard ? quantity(*standard) : std::nullopt;
    };
    const auto travel = [](const Measurement& m) -> std::optional<double> {
        const measure::ColourTravel way = measure::colour_travel(m);
        return way.path.size() > 1 ? std::optional(way.length) : std::nullopt;
    };
    std::vector<Metric> all = {
        compared("Flop index", measure::flop_index(sample), of_standard(measure::flop_index), 1),
        compared("Colour travel in a*b*", travel(sample), of_standard(travel), 1)};
    if (report.uncertainty) {
        all[0].value =
            with_deviation(all[0].value, deviation_of(report.uncertainty->flop_index), 1);
        all[1].value =
            with_deviation(all[1].value, deviation_of(report.uncertainty->colour_travel), 1);
    }
    if (report.standard) {
        const measure::Difference& d = report.standard->difference;
        all.push_back({"ΔE2000 to the standard", decimal_text(d.mean_delta_e_2000, 2),
                       "greatest " + decimal_text(d.max_delta_e_2000, 2)});
    }
    if (!report.sparkle) return all;
    const measure::SparkleMeasurement* other =
        report.standard && report.standard->sparkle ? &*report.standard->sparkle : nullptr;
    const auto with_standard = [](const char* unit, const Estimate* estimate) {
        return estimate ? fmt::format("{}; standard {}", unit, uncertain(*estimate)) : unit;
    };
    for (std::size_t i = 0; i < report.sparkle->by_lamp.size(); ++i) {
        const Estimate* standard_sparkle = other ? &other->by_lamp.at(i).sparkle_per_cm2 : nullptr;
        all.push_back({"Sparkle, lamp at " + degrees_text(report.sparkle->lamps_deg[i]),
                       uncertain(report.sparkle->by_lamp[i].sparkle_per_cm2),
                       with_standard("per cm²", standard_sparkle)});
    }
    if (report.sparkle->diffuse) {
        all.push_back(
            {"Graininess in diffuse light", uncertain(report.sparkle->diffuse->graininess),
             with_standard("thresholds",
                           other && other->diffuse ? &other->diffuse->graininess : nullptr)});
    }
    return all;
}

std::string metrics_html(const PanelReport& report) {
    std::string html = "<dl class=\"metrics\">\n";
    for (const Metric& metric : metrics(report)) {
        html += fmt::format(
            "<div><dt>{}</dt><dd>{}{}</dd></div>\n", escape_html(metric.name),
            escape_html(metric.value),
            metric.note.empty() ? "" : " <span>" + escape_html(metric.note) + "</span>");
    }
    return html + "</dl>\n";
}

// ------------------------------------------------------------------------------- chips

/// The reading of the standard at the same geometry; null if there is none.
const Reading* same_geometry(const Measurement* standard, const measure::Geometry& geometry) {
    if (!standard) return nullptr;
    for (const Reading& reading : standard->readings) {
        if (measure::separation_deg(reading.geometry, geometry) <= 1e-6) return &reading;
    }
    return nullptr;
}

std::vector<const Reading*> readings_for_chips(const Measurement& sample) {
    std::vector<const Reading*> all;
    for (const Reading& reading : sample.readings) all.push_back(&reading);
    if (all.size() <= kMaxChips) return all;
    const double lamp = sample.readings[0].geometry.theta_i_deg;
    std::erase_if(all, [&](const Reading* r) {
        return r->geometry.theta_i_deg != lamp || !measure::is_in_plane(r->geometry);
    });
    if (all.size() > kMaxChips) all.resize(kMaxChips);
    return all;
}

std::string angle_name(const Measurement& sample, const measure::Geometry& geometry) {
    const bool one_lamp =
        std::all_of(sample.readings.begin(), sample.readings.end(), [&](const Reading& r) {
            return measure::is_in_plane(r.geometry) &&
                   r.geometry.theta_i_deg == sample.readings[0].geometry.theta_i_deg;
        });
    return one_lamp ? degrees_text(geometry.aspecular_deg) : geometry.name;
}

std::string chips_html(const PanelReport& report) {
    const Measurement* standard = report.standard ? &report.standard->measurement : nullptr;
    const auto readings = readings_for_chips(report.sample);
    std::string html = fmt::format("<div class=\"chips\" style=\"--columns:{}\">\n",
                                   std::clamp<std::size_t>(readings.size(), 1, 8));
    for (const Reading* reading : readings) {
        html += "<div class=\"chip\">";
        const Reading* other = same_geometry(standard, reading->geometry);
        // The standard above, the sample below, without a seam between them.
        const std::string below = chip(reading->lab), above = other ? chip(other->lab) : below;
        html += fmt::format(
            "<div class=\"colour\" style=\"background-image:linear-gradient({} 50%, {} "
            "50%)\"></div>",
            above, below);
        html += fmt::format("<b>{}</b><span>L* {}</span><span>C* {}</span><span>h {}</span>",
                            escape_html(angle_name(report.sample, reading->geometry)),
                            decimal_text(reading->lab[0], 1),
                            decimal_text(measure::chroma(reading->lab), 1),
                            decimal_text(measure::hue_deg(reading->lab), 0) + "°");
        html += "</div>\n";
    }
    return html + "</div>\n";
}

// ------------------------------------------------------------------------------ readings

const fit::ReadingUncertainty& uncertainty_at(const PanelReport& report, const Reading* reading) {
    return report.uncertainty->readings.at(
        static_cast<std::size_t>(reading - report.sample.readings.data()));
}

/// Standard deviations of a reading of the sample; none where they are not known.
struct ReadingDeviations {
    std::array<std::optional<double>, 4> lab_and_chroma = {};
    std::optional<double> hue_deg = {};
};

ReadingDeviations deviations_of(const PanelReport& report, const Reading* reading) {
    if (!report.uncertainty) return {};
    const fit::Spread& spread = uncertainty_at(report, reading).best();
    const Vec3d lab = spread.lab();
    return {{lab[0], lab[1], lab[2], spread.chroma}, spread.hue_deg};
}

/// "+0.3", "−1.2".
std::string signed_text(double value) {
    return (value < 0 ? "−" : "+") + decimal_text(std::abs(value), 2);
}

/// Sample less standard, angle by angle; nothing without a standard.
std::string differences_html(const PanelReport& report) {
    if (!report.standard) return {};
    const std::optional<measure::Verdict>& verdict = report.standard->verdict;
    const bool own_formula = verdict && verdict->tolerance.formula != measure::DifferenceFormula{};
    const bool limited = verdict && verdict->tolerance.has_limits();
    report::Table table{.caption = "Sample less standard",
                        .columns = {"Angle", "ΔL*", "Δa*", "Δb*", "ΔC*", "ΔH*", "ΔE2000"}};
    if (own_formula) table.columns.push_back("ΔE " + verdict->tolerance.formula.name());
    if (limited) {
        table.columns.emplace_back("tolerance");
        table.columns.emplace_back("");
    }
    const std::vector<measure::AngleDifference>& angles = report.standard->difference.angles;
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const measure::AngleDifference& angle = angles[i];
        std::vector<report::Cell> row = {
            {.text = angle_name(report.sample, angle.geometry), .numeric = true}};
        for (const double value : {angle.delta_lab[0], angle.delta_lab[1], angle.delta_lab[2],
                                   angle.delta_chroma(), angle.delta_hue()}) {
            row.push_back(report::number_cell(signed_text(value)));
        }
        row.push_back(report::number_cell(decimal_text(angle.delta_e_2000, 2)));
        if (own_formula) {
            row.push_back(report::number_cell(decimal_text(verdict->angles[i].delta_e, 2)));
        }
        if (limited) {
            const measure::AngleVerdict& judged = verdict->angles[i];
            row.push_back(report::number_cell(judged.limit ? decimal_text(*judged.limit, 2) : ""));
            row.push_back({.text = !judged.limit     ? ""
                                   : judged.passes() ? "passes"
                                                     : "fails",
                           .strong = judged.limit && !judged.passes()});
        }
        table.rows.push_back(std::move(row));
    }
    return report::table_html(table, 1);
}

std::string readings_html(const PanelReport& report) {
    report::Table table{.columns = {"Angle", "L*", "a*", "b*", "C*", "h"}};
    for (const Reading* reading : readings_for_chips(report.sample)) {
        const Vec3d& lab = reading->lab;
        std::vector<report::Cell> row = {
            {.text = angle_name(report.sample, reading->geometry), .numeric = true}};
        const std::array<double, 4> values = {lab[0], lab[1], lab[2], measure::chroma(lab)};
        const ReadingDeviations deviations = deviations_of(report, reading);
        for (std::size_t i = 0; i < values.size(); ++i) {
            row.push_back(report::number_cell(
                with_deviation(decimal_text(values[i], 1), deviations.lab_and_chroma[i], 1)));
        }
        row.push_back(report::number_cell(
            with_deviation(decimal_text(measure::hue_deg(lab), 0) + "°", deviations.hue_deg, 0)));
        table.rows.push_back(std::move(row));
    }
    return report::table_html(table, 1) + differences_html(report);
}

std::string plots_html(const PanelReport& report) {
    constexpr report::SvgSize kHalf{.width_px = 470, .height_px = 270};
    // The page has said whose curves these are.
    Measurement sample = report.sample;
    sample.name = report.standard ? "sample" : "";
    std::optional<Measurement> standard;
    if (report.standard) {
        standard = report.standard->measurement;
        standard->name.clear();
    }
    std::string html = "<div class=\"two\">\n";
    for (const NamedPlot& named :
         measurement_plots(sample, standard ? &*standard : nullptr,
                           report.uncertainty ? &*report.uncertainty : nullptr)) {
        html += report::plot_html(named.plot, kHalf);
    }
    return html + readings_html(report) + "</div>\n";
}

// ---------------------------------------------------------------------------- uncertainty

/// Where first order is not enough, as in "15° (b, C)".
std::vector<std::string> doubtful_places(const PanelReport& report,
                                         const std::vector<const Reading*>& readings) {
    std::vector<std::string> where;
    for (const Reading* reading : readings) {
        std::vector<const char*> names;
        for (const fit::Quantity quantity : uncertainty_at(report, reading).doubtful()) {
            names.push_back(name_of(quantity));
        }
        if (names.empty()) continue;
        where.push_back(fmt::format("{} ({})", angle_name(report.sample, reading->geometry),
                                    fmt::join(names, ", ")));
    }
    const fit::Uncertainty& u = *report.uncertainty;
    if (u.flop_index && u.flop_index->linearity.fails) where.emplace_back("the flop index");
    if (u.colour_travel && u.colour_travel->linearity.fails) {
        where.emplace_back("the colour travel");
    }
    return where;
}

/// How well the composition is known, and what each number of it does to the colours.
std::string uncertainty_html(const PanelReport& report) {
    if (!report.uncertainty) return {};
    const fit::Uncertainty& u = *report.uncertainty;
    report::Table table{.columns = {"Number", "Value", "±"}};
    const std::vector<const Reading*> readings = readings_for_chips(report.sample);
    for (const Reading* reading : readings) {
        table.columns.push_back(angle_name(report.sample, reading->geometry));
    }
    std::vector<std::vector<double>> by_reading;
    for (const Reading* reading : readings) {
        by_reading.push_back(
            fit::variance_fractions(uncertainty_at(report, reading).change, u.correlation));
    }
    for (std::size_t i = 0; i < u.numbers.size(); ++i) {
        const fit::UncertainNumber& number = u.numbers[i];
        std::vector<report::Cell> row = {
            {.text = fmt::format("`{}`", number.key)},
            report::number_cell(fmt::format("{:.4g}", number.value)),
            report::number_cell(fmt::format("{:.2g}", number.standard_deviation))};
        for (const std::vector<double>& shares : by_reading) {
            row.push_back(report::number_cell(decimal_text(100 * shares[i], 0) + " %"));
        }
        table.rows.push_back(std::move(row));
    }
    std::string html = heading("How sure this is") + report::table_html(table, 2);
    html += paragraph(
        "± is one standard deviation, as that of these numbers makes it; " +
            correlations_in_words(u) +
            " Ellipses in the plot of colour travel hold 95 %, bars are one standard deviation.",
        " class=\"small\"");
    std::string words;
    const auto say = [&](const std::string& sentence) {
        words += (words.empty() ? "" : " ") + sentence;
    };
    if (u.samples > 0) {
        say(fmt::format("From {} recipes that were drawn; shares to first order.", u.samples));
    } else if (const auto where = doubtful_places(report, readings); !where.empty()) {
        say(
            fmt::format("To first order only, which is not enough at {}: the next terms change "
                        "standard deviations by more than 5 %.",
                        fmt::join(where, ", ")));
    }
    for (const fit::UncertainNumber& number : u.numbers) {
        if (!number.meets_range) continue;
        say(
            fmt::format("{} reaches values that no recipe may have within {:g} standard "
                        "deviations: it cannot be normal.",
                        number.key, fit::UncertainNumber::kSigmasOfRange));
    }
    if (!words.empty()) html += paragraph(words, " class=\"small\"");
    return html;
}

// ---------------------------------------------------------------------------- composition

std::string composition_html(const PanelReport& report) {
    const bool of_layers = report.model->ingredients == bsdf::Ingredients::layers;
    std::string html;
    if (of_layers) {
        std::string words;
        for (const std::string& sentence : layers_in_words(report.recipe)) {
            words += (words.empty() ? "" : " ") + sentence;
        }
        html += paragraph(words) + report::table_html(layers_table(report.recipe), 2);
    } else if (report.recipe.microfacet) {
        std::string words;
        for (const std::string& sentence : facets_in_words(*report.recipe.microfacet)) {
            words += (words.empty() ? "" : " ") + sentence;
        }
        html += paragraph(words);
    }
    return html;
}

std::string legend_of_two(const PanelReport& report) {
    if (!report.standard) return {};
    return paragraph(
        fmt::format("Upper halves of the chips and dashed curves: {} ({}). Lower halves "
                    "and full curves: {}.",
                    report.standard->measurement.name,
                    report.standard->measured ? "standard, measured" : "standard, computed",
                    report.sample.name),
        " class=\"small\"");
}

bool has_two_models(const PanelReport& report) {
    return report.reading_model && report.reading_model != report.model;
}

std::string models_in_words(const PanelReport& report) {
    const auto words = [](const bsdf::ModelInfo& model) {
        return fmt::format("{} ({})", model.name, model.source);
    };
    if (!has_two_models(report)) return words(*report.model);
    return fmt::format("{}, but for {}, by the model {}", words(*report.reading_model),
                       report.sparkle ? "pictures and sparkle" : "pictures", words(*report.model));
}

std::string method_html(const PanelReport& report) {
    const std::string lamp = report.sample.readings.empty()
                                 ? ""
                                 : fmt::format("; {} geometries", report.sample.readings.size());
    std::vector<std::string> texts = {
        fmt::format("Readings: {}{}; angles are aspecular, from the mirror direction towards the "
                    "normal. The perfect diffuser has Y = 100; the gloss of a smooth surface is "
                    "excluded, as instruments exclude it. Flop index: 2.69 (L*15 − L*110)^1.11 / "
                    "L*45^0.86.",
                    conditions_text(report.sample.conditions), lamp),
        fmt::format("All numbers and pictures are computed from the composition by the model {}{}. "
                    "They say what a multi-angle instrument would read if the paint were "
                    "as described and the model true; they do not replace a panel that was "
                    "painted and measured.",
                    models_in_words(report),
                    report.standard && report.standard->measured
                        ? ", but for the standard, which was measured"
                        : ""),
        "Chips and pictures are shown as sRGB. Colours brighter than white are dimmed at equal "
        "hue; what screen or printer cannot show is cut off. Compare numbers, not prints."};
    if (report.sparkle) {
        texts.emplace_back(
            "Sparkle counts the points of light that an eye at half a metre notices, each by the "
            "logarithm of how far it stands above the threshold; graininess is the contrast in "
            "diffuse light "
            "in units of the threshold. The definitions are Nacre's own and published with it: "
            "they are not those of any instrument on the market. ± is one standard error.");
    }
    std::string html = "<ul class=\"small\">\n";
    for (const std::string& text : texts) html += "<li>" + escape_html(text) + "</li>\n";
    return html + "</ul>\n";
}

std::string pictures_html(const PanelReport& report) {
    if (report.pictures.empty()) return {};
    const std::vector<report::Picture> small(report.pictures.begin() + 1, report.pictures.end());
    std::string html = report::pictures_html({report.pictures[0]}, 1, "");
    for (const report::Picture& picture : small) html += report::pictures_html({picture}, 1, "");
    return html;
}

}  // namespace

std::string panel_report_html(const PanelReport& report) {
    std::string body = fmt::format("<section class=\"hero\" style=\"--small:{}\">\n",
                                   report.pictures.empty() ? 0 : report.pictures.size() - 1);
    body += pictures_html(report) + "</section>\n" + metrics_html(report) +
            heading("Colour by angle") + chips_html(report) + legend_of_two(report) +
            plots_html(report) + uncertainty_html(report);
    body += heading("Composition") + composition_html(report);
    body += heading("What these numbers are") + method_html(report);
    body += fmt::format(
        "<footer>nacre {} · model {}{}</footer>\n", version(),
        has_two_models(report)
            ? fmt::format("{} (pictures: {})", report.reading_model->name, report.model->name)
            : std::string(report.model->name),
        report.recipe_sha256.empty() ? "" : " · recipe SHA-256 " + report.recipe_sha256);
    return report::page_html(report.title, "Virtual panel report", {}, body, panel_css());
}

}  // namespace nacre::datasheet
