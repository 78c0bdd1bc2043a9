#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <iterator>
#include <memory>
#include <numbers>

#include "apps/cli/options.h"
#include "apps/cli/paint_options.h"
#include "nacre/optics/thin_film.h"
#include "nacre/paint/recipe.h"

namespace nacre::cli {

namespace {

using optics::Polarization;

constexpr std::size_t kMaxFilms = 10'000;

struct FilmOptions : CommonOptions {
    std::string ambient = "1", substrate = "1";
    std::vector<std::string> layers;
    std::string angles = "0", wavelengths = "400:700:10";
    std::string polarization = "u";
};

struct Film {
    optics::Material material;
    double thickness_nm;
};

/// "TiO2_anatase:80" or "3.18+3.33i:20".
Film parse_film(const std::string& text) {
    const std::size_t colon = text.rfind(':');
    if (colon == std::string::npos || colon == 0) {
        throw UsageError(fmt::format(
            "--layer = {}: must be INDEX:THICKNESS, the thickness in nm, as in 2.5:120", text));
    }
    return {open_material("--layer", text.substr(0, colon)),
            parse_number("thickness of --layer", text.substr(colon + 1), Range{0, 1e9, "nm"})};
}

Polarization parse_polarization(const std::string& text) {
    if (text == "s") return Polarization::s;
    if (text == "p") return Polarization::p;
    return Polarization::unpolarized;
}

std::string film_table(const FilmOptions& options) {
    const optics::Material ambient = open_material("--ambient", options.ambient);
    const optics::Material substrate = open_material("--substrate", options.substrate);
    if (options.layers.size() > kMaxFilms) {
        throw UsageError(fmt::format("--layer: more than {} of them", kMaxFilms));
    }
    std::vector<Film> films;
    for (const std::string& text : options.layers) films.push_back(parse_film(text));
    const std::vector<double> angles =
        parse_numbers("--angle", options.angles, optics::kIncidenceRange);
    const std::vector<double> wavelengths =
        parse_numbers("--wavelength", options.wavelengths, paint::limits::kWavelength);
    if (angles.size() * wavelengths.size() > 10 * kMaxNumbers) {
        throw UsageError(fmt::format("{} angles times {} wavelengths are too many: at most {} rows",
                                     angles.size(), wavelengths.size(), 10 * kMaxNumbers));
    }
    std::string table = "wavelength_nm,angle_deg,polarization,R,T\n";
    std::vector<optics::ThinFilm> stack(films.size());
    for (double wavelength : wavelengths) {
        for (std::size_t i = 0; i < films.size(); ++i) {
            stack[i] = {films[i].material.index(wavelength), films[i].thickness_nm};
        }
        for (double angle : angles) {
            const optics::ReflectanceTransmittance rt = optics::stack_reflectance(
                ambient.index(wavelength), stack, substrate.index(wavelength),
                std::cos(angle * std::numbers::pi / 180), wavelength,
                parse_polarization(options.polarization));
            table += fmt::format("{},{},{},{:.12g},{:.12g}\n", wavelength, angle,
                                 options.polarization, rt.reflectance, rt.transmittance);
        }
    }
    return table;
}

/// Media and films may be files of optical constants.
std::vector<std::string> inputs(const FilmOptions& options) {
    std::vector<std::string> all = options.layers;
    all.insert(all.end(), {options.ambient, options.substrate});
    return all;
}

}  // namespace

Command add_film(CLI::App& program) {
    auto options = std::make_shared<FilmOptions>();
    CLI::App* film =
        program.add_subcommand("film", "Reflectance and transmittance of a stack of thin films");
    film->add_option("--ambient", options->ambient, "Medium that the light comes from; transparent")
        ->capture_default_str();
    film->add_option("--layer", options->layers,
                     "A film as INDEX:THICKNESS_NM; repeat it, from the ambient inwards")
        ->option_text("INDEX:THICKNESS_NM")
        ->allow_extra_args(false);
    film->add_option("--substrate", options->substrate, "Medium beyond the films")
        ->capture_default_str();
    film->add_option("--angle", options->angles,
                     "Angles of incidence in the ambient, in " + optics::kIncidenceRange.text())
        ->capture_default_str();
    film->add_option("--wavelength", options->wavelengths, "Vacuum wavelengths, nm")
        ->capture_default_str();
    film->add_option("--polarization", options->polarization,
                     "s (perpendicular to the plane of incidence), p (parallel) or u (unpolarized)")
        ->check(CLI::IsMember({"s", "p", "u"}))
        ->capture_default_str();
    add_table_output(*film, *options);
    film->footer(
        "An index is n, n+ki (as in 3.18+3.33i, k > 0 absorbs), the name of a shipped material\n"
        "(TiO2_anatase), or a file of optical constants (.csv, .yml). Angles and wavelengths are\n"
        "one value, a comma list, or first:last:step.\n\n"
        "Writes CSV: wavelength_nm,angle_deg,polarization,R,T; T is the power that enters the\n"
        "substrate.\n\n"
        "Example: titania on a mica platelet in resin, seen at 30 deg\n"
        "  nacre film --ambient 1.5 --layer TiO2_anatase:80 --layer mica:500 \\\n"
        "             --layer TiO2_anatase:80 --substrate 1.5 --angle 30 --wavelength 400:700:10");
    return {film, [options] { return files_of(*options, inputs(*options), "CSV"); },
            [options] {
                emit_table(*options, film_table(*options));
                return ExitStatus::ok;
            }};
}

}  // namespace nacre::cli
