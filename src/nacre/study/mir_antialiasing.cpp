#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "nacre/optics/antialiased_error.h"
#include "nacre/study/mir_parts.h"

// Spectral antialiasing of the thin film: RGB colours in closed form against integration.

namespace nacre::study {
namespace {

struct Film {
    const char* name;
    double outside, film, base, extinction;
};
constexpr Film kFilms[] = {
    {"1.8 on 1.08 + 0.51i, in air", 1, 1.8, 1.08, 0.51},
    {"1.97 on 1.08 + 0.51i, in air", 1, 1.97, 1.08, 0.51},
    {"2.5 (titania) on 1.58 (mica), in resin", 1.5, 2.5, 1.58, 0},
    {"1.45 (silica) on 1.0 + 6.7i (aluminium), in resin", 1.5, 1.45, 1.0, 6.7}};

struct Way {
    const char* name;
    optics::Antialiasing how;
};
const Way kWays[] = {
    {"table, every order", {optics::ObserverTransform::table, optics::kEveryOrder}},
    {"table, 3 orders", {optics::ObserverTransform::table, 3}},
    {"paper (Gaussians), 3 orders", {optics::ObserverTransform::paper, 3}},
    {"paper (Gaussians), every order", {optics::ObserverTransform::paper, optics::kEveryOrder}}};

std::vector<double> steps(double first, double last, double step) {
    std::vector<double> values;
    for (int i = 0; first + i * step <= last + 1e-9; ++i) values.push_back(first + i * step);
    return values;
}

void add_plot(MirContext& context, const Film& film) {
    const optics::AiryFilm airy(film.outside, film.film, film.base, film.extinction);
    report::Plot plot{.title = std::string("Error of a colour against thickness: ") + film.name,
                      .caption = "At 30° on the film.",
                      .x = {.label = "film thickness, nm"},
                      .y = {.label = "CIEDE2000", .logarithmic = true, .lo = 1e-4}};
    for (const Way& way : kWays) {
        report::Series series{.name = way.name};
        for (double thickness : steps(10, 1000, 10)) {
            series.x.push_back(thickness);
            series.y.push_back(optics::compare_antialiasing(airy, std::cos(std::numbers::pi / 6),
                                                            thickness, way.how)
                                   .delta_e);
        }
        plot.series.push_back(series);
    }
    context.report.plot(plot);
}

}  // namespace

void add_antialiasing(MirContext& context) {
    report::Report& report = context.report;
    report.heading(1, "Spectral antialiasing", "antialiasing");
    report.paragraph(
        "`thin-film` renders spectra. Its RGB mode takes the colour of the film in closed form, "
        "from the Fourier transform of the eye's sensitivities: the paper fits them by Gaussians; "
        "ours tabulates the transform of the observer itself. Each against integration at 1 nm, "
        "over thicknesses of 0 to 1000 nm and angles of 0 to 80°.");
    report::Table table{
        .columns = {"film", "colours from", "mean ΔE", "largest ΔE", "mean RGB", "largest RGB"}};
    const std::vector<double> thicknesses = steps(0, 1000, context.settings.quick ? 100 : 10);
    std::vector<double> cosines;
    for (double degrees : steps(0, 80, context.settings.quick ? 40 : 10)) {
        cosines.push_back(std::cos(degrees * std::numbers::pi / 180));
    }
    for (const Film& film : kFilms) {
        const optics::AiryFilm airy(film.outside, film.film, film.base, film.extinction);
        for (const Way& way : kWays) {
            const optics::AntialiasingError e =
                optics::antialiasing_error(airy, cosines, thicknesses, way.how);
            table.rows.push_back({{&way == kWays ? film.name : ""},
                                  {way.name},
                                  report::number_cell(number(e.mean_delta_e)),
                                  report::number_cell(number(e.max_delta_e)),
                                  report::number_cell(number(e.mean_rgb, 2)),
                                  report::number_cell(number(e.max_rgb, 2))});
            context.results["antialiasing"][film.name][way.name] = {
                {"mean_delta_e", e.mean_delta_e},
                {"max_delta_e", e.max_delta_e},
                {"mean_rgb", e.mean_rgb},
                {"max_rgb", e.max_rgb}};
        }
    }
    report.table(table);
    add_plot(context, kFilms[0]);
    add_plot(context, kFilms[2]);
}

}  // namespace nacre::study
