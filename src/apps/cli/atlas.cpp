#include "apps/datasheet/atlas.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "apps/cli/files.h"
#include "apps/cli/instrument_options.h"
#include "apps/cli/model_options.h"
#include "apps/cli/options.h"
#include "apps/cli/paint_options.h"
#include "apps/report/svg_raster.h"
#include "nacre/core/parallel.h"
#include "nacre/core/progress.h"
#include "nacre/nacre.h"
#include "nacre/paint/recipe.h"
#include "nacre/paint/recipe_parameter.h"
#include "nacre/spectra/spectrum.h"

namespace nacre::cli {

namespace {

struct AtlasOptions : CommonOptions {
    std::string film, core;
    std::vector<std::string> outer;
    std::string spread = "0", ior = "1.5";
    std::string recipe, key;
    std::string values = "20:200:5";
    std::string lamp = "45", aspecular = "15,25,45,75,110";
    InstrumentOptions instrument;  // illuminant and observer
    ModelOptions model;            // of a recipe; if none is chosen, the solution itself is read
};

enum class Format { csv, svg, png };

Format parse_format(const std::string& output) {
    if (output.empty()) return Format::csv;
    const std::string extension = std::filesystem::path(output).extension().string();
    if (extension == ".csv") return Format::csv;
    if (extension == ".svg") return Format::svg;
    if (extension == ".png") return Format::png;
    if (is_standard_output(output)) return Format::csv;
    throw UsageError(fmt::format(
        "--output = {}: must end in .svg, .png or .csv, or be - for CSV on the standard "
        "output",
        output));
}

/// "mica:500" or "mica:500:60".
optics::FilmPopulation parse_film(const std::string& option, const std::string& text) {
    const auto number_at_end = [&](std::string& rest) -> std::optional<std::string> {
        const std::size_t colon = rest.rfind(':');
        if (colon == std::string::npos || colon == 0) return {};
        std::string number = rest.substr(colon + 1);
        rest.resize(colon);
        return number;
    };
    const auto is_number = [](const std::string& t) {
        return !t.empty() && t.find_first_not_of("0123456789.eE+-") == std::string::npos;
    };
    std::string material = text;
    const auto last = number_at_end(material);
    if (!last) {
        throw UsageError(fmt::format(
            "{} = {}: must be MATERIAL:THICKNESS or MATERIAL:THICKNESS:SPREAD in nm, as in "
            "mica:500:60",
            option, text));
    }
    std::string thickness = *last, spread = "0", shorter = material;
    if (const auto before = number_at_end(shorter); before && is_number(*before)) {
        spread = thickness;
        thickness = *before;
        material = shorter;
    }
    return {open_material(option, material),
            parse_number("thickness of " + option, thickness, paint::limits::kFilmThickness),
            {parse_number("spread of " + option, spread, paint::limits::kFilmSpread)}};
}

std::vector<measure::Geometry> parse_angles(const AtlasOptions& options) {
    const double lamp = parse_number("--lamp", options.lamp, Range{0, 90, "deg", false, true});
    std::vector<measure::Geometry> geometries;
    for (const double angle :
         parse_numbers("--aspecular", options.aspecular, Range{-180, 180, "deg"})) {
        geometries.push_back(measure::in_plane(lamp, angle));
    }
    return geometries;
}

std::vector<double> wavelengths_nm(double step) {
    std::vector<double> all;
    for (double w = 400; w <= 700; w += step) all.push_back(w);
    return all;
}

datasheet::Atlas atlas_of_flake(const AtlasOptions& options, const Progress& progress) {
    datasheet::AtlasFlake flake;
    flake.film = open_material("--film", options.film);
    flake.film_spread = {parse_number("--spread", options.spread, paint::limits::kFilmSpread)};
    if (!options.core.empty()) flake.core = parse_film("--core", options.core);
    for (const std::string& text : options.outer) {
        flake.outer.push_back(parse_film("--outer", text));
    }
    if (!flake.outer.empty() && !flake.core) {
        throw UsageError("--outer needs --core: coats are alike on both sides of a core");
    }
    flake.binder = open_material("--ior", options.ior);
    return datasheet::flake_atlas(
        flake, parse_numbers("--thickness", options.values, paint::limits::kFilmThickness),
        parse_angles(options), wavelengths_nm(5), parse_conditions(options.instrument), progress);
}

datasheet::Atlas atlas_of_recipe(const AtlasOptions& options, const Progress& progress) {
    const Paint paint = open_paint(options, options.recipe);
    const std::string key = [&] {
        try {
            return paint.whole_key(options.key);
        } catch (const SettingError& error) {
            throw UsageError(fmt::format("--key = {}: {}", options.key, error.reason()));
        }
    }();
    const std::vector<double> values = parse_numbers("--values", options.values, Range{});
    const std::vector<measure::Geometry> geometries = parse_angles(options);
    const measure::Conditions conditions = parse_conditions(options.instrument);
    datasheet::RecipeReader read;
    if (choice_of_any(options.model)) {
        const MeasureSettings settings{.model = model_for({&paint}, options.model, true),
                                       .illuminant = conditions.illuminant,
                                       .observer = conditions.observer};
        read = [settings, geometries](const paint::Recipe& changed, const Progress& callback) {
            return Paint(changed).measure(geometries, settings, callback).measurement;
        };
    }
    try {
        datasheet::Atlas atlas =
            datasheet::recipe_atlas(paint.recipe(), key, values, geometries,
                                    spectra::default_wavelengths_nm(), conditions, progress, read);
        if (read) atlas.caption += fmt::format(", by the model {}", options.model.model);
        return atlas;
    } catch (const DomainError& error) {
        throw InputError(options.recipe + ": " + error.what());
    }
}

void check_choice(const AtlasOptions& options, const CLI::App& command) {
    if (options.film.empty() == options.recipe.empty()) {
        throw UsageError("either --film or --recipe must be given");
    }
    const std::vector<const char*> foreign =
        options.recipe.empty() ? std::vector{"--key", "--set"}
                               : std::vector{"--core", "--outer", "--spread", "--ior"};
    for (const char* option : foreign) {
        if (command.count(option) > 0) {
            throw UsageError(fmt::format("{} belongs to {}", option,
                                         options.recipe.empty() ? "--recipe" : "--film"));
        }
    }
    if (const auto choice = choice_of_any(options.model); choice && options.recipe.empty()) {
        throw UsageError(*choice + ": belongs to --recipe");
    }
    if (!options.recipe.empty() && options.key.empty()) {
        throw UsageError("--recipe needs --key: which of its numbers is to vary");
    }
    if (!options.recipe.empty() && command.count("--values") == 0) {
        throw UsageError("--recipe needs --values: those of the number that varies");
    }
}

ExitStatus run(const AtlasOptions& options, const CLI::App& command) {
    check_choice(options, command);
    const Format format = parse_format(options.output);
    if (format != Format::csv) refuse_table_options(options);
    const ThreadLimit threads(options.threads);
    const InterruptHandler interrupt;
    const Stopwatch watch;
    const datasheet::Atlas atlas = [&] {
        ProgressBar bar("atlas", options.quiet);
        return options.film.empty() ? atlas_of_recipe(options, bar.callback())
                                    : atlas_of_flake(options, bar.callback());
    }();
    switch (format) {
        case Format::csv:
            emit_table(options, datasheet::atlas_csv(atlas));
            break;
        case Format::svg:
            emit(options, datasheet::atlas_svg(atlas));
            break;
        case Format::png:
            emit(options, report::png_of_svg(datasheet::atlas_svg(atlas), report::kPngScale));
            break;
    }
    write_report(options, "atlas",
                 {{"title", atlas.title},
                  {"quantity", atlas.quantity},
                  {"values", atlas.values.size()},
                  {"angles", atlas.geometries.size()},
                  {"output", options.output},
                  {"total_s", watch.seconds()}});
    return ExitStatus::ok;
}

/// Films and the binder may be files of optical constants.
std::vector<std::string> inputs(const AtlasOptions& options) {
    std::vector<std::string> all = options.outer;
    all.insert(all.end(), {options.film, options.core, options.ior, options.recipe});
    return all;
}

}  // namespace

Command add_atlas(CLI::App& program) {
    auto options = std::make_shared<AtlasOptions>();
    CLI::App* command = program.add_subcommand(
        "atlas", "Colours of an interference film by its thickness and the angle of view");
    command->add_option("--film", options->film,
                        "Material of the film that varies: a name, an index or a file");
    command
        ->add_option("--thickness,--values", options->values,
                     "Thicknesses across, nm; with --key, values of that number")
        ->capture_default_str();
    command->add_option("--spread", options->spread, "Standard deviation of the film, nm")
        ->capture_default_str();
    command->add_option(
        "--core", options->core,
        "Platelet under the film as MATERIAL:NM[:SPREAD_NM]; none: the film itself");
    command
        ->add_option("--outer", options->outer,
                     "Coat over the film as MATERIAL:NM[:SPREAD_NM]; repeat it, outwards")
        ->option_text("MATERIAL:NM[:SPREAD_NM]")
        ->allow_extra_args(false);
    command->add_option("--ior", options->ior, "Binder: an index, a material or a file")
        ->capture_default_str();
    command->add_option("--lamp", options->lamp, "Angle of the lamp from the normal, deg")
        ->capture_default_str();
    command->add_option("--aspecular", options->aspecular, "Aspecular angles down, deg")
        ->capture_default_str();
    command->add_option("--illuminant", options->instrument.illuminant,
                        "A, D50, D65, FL2, FL11 or E; D65 by default");
    command->add_option("--observer", options->instrument.observer,
                        "2 or 10 degrees; 10 by default");
    command->add_option("--recipe", options->recipe,
                        "The whole paint instead of one flake: a recipe, solved for each value");
    command->add_option("--key", options->key,
                        "Number of the recipe that varies, as in coats[0].thickness_nm");
    add_model_options(*command, options->model);
    add_table_output(*command, *options);
    add_input_options(*command, *options);
    add_set(*command, *options);
    add_run_options(*command, *options);
    command->footer(
        "Writes a picture of chips (FILE.svg, FILE.png) or CSV (FILE.csv, -): the value, theta_i, "
        "aspecular_deg,\n"
        "L, a, b, C, h, chip. A chip of --film is the reflectance of one flake where it mirrors "
        "the\n"
        "lamp to the eye inside the binder: the hue of a paint of such flakes, its lightness "
        "being\n"
        "relative. docs/panel.md has the definitions.\n\n"
        "Examples:\n"
        "  nacre atlas --film TiO2_anatase --core mica:500:60 --thickness 20:200:5 -o atlas.svg\n"
        "  nacre atlas --recipe paints/tio2-mica-80.toml --key 'coats[0].thickness_nm' \\\n"
        "              --values 40:160:20 -o paint.png");
    return {command, [options] { return files_of(*options, inputs(*options)); },
            [options, command] { return run(*options, *command); }};
}

}  // namespace nacre::cli
