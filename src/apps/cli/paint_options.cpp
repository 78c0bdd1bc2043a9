#include "apps/cli/paint_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/core/text.h"
#include "nacre/optics/material_file.h"

namespace nacre::cli {

namespace {

/// The options that limit the solver in this respect.
const char* options_of(SolverWarning::What what) {
    return what == SolverWarning::What::scattering ? "--nodes and --inner-nodes" : "--orders";
}

/// What the user can do: leave out the option that limited the solver, or else check the result.
std::string advice(const SolverWarning& warning) {
    if (warning.held_back) {
        return fmt::format("solve it without {}, and they are chosen from the recipe",
                           options_of(warning.what));
    }
    return "the solver is at its limits: compare with nacre reference before relying on this "
           "paint, or make its narrowest lobe wider (alpha of the flakes, anisotropy of the "
           "pigments)";
}

/// With what its reader made of it said.
Paint open_as_it_is(const CommonOptions& options, const std::string& file) {
    const std::string path = find_paint(file).string();
    Paint paint = open(path, references_of(options, path));
    for (const std::string& note : paint.notes()) say(options, "nacre: note: " + note);
    return paint;
}

/// A file that is named on the command line is looked for where the command runs first: shipped recipes,
/// beside which it would lie otherwise, are elsewhere.
std::string setting_value(std::string_view value) {
    std::string with;
    std::size_t done = 0;
    for (const std::string_view text : texts_of_setting(value)) {
        std::error_code none;
        const std::filesystem::path file(text);
        if (!text.ends_with(".csv") || !std::filesystem::is_regular_file(file, none)) continue;
        const auto begin = static_cast<std::size_t>(text.data() - value.data());
        with += value.substr(done, begin - done);
        with += std::filesystem::absolute(file).string();
        done = begin + text.size();
    }
    return with.append(value.substr(done));
}

Paint with_settings(const CommonOptions& options, const Paint& paint) {
    std::vector<std::pair<std::string, std::string>> settings;
    for (const std::string& text : options.set) {
        const std::size_t equals = text.find('=');
        if (equals == std::string::npos || equals == 0) {
            throw UsageError(
                fmt::format("--set {}: must be KEY=VALUE, as in layer[0].thickness_um=20", text));
        }
        settings.emplace_back(trimmed(std::string_view(text).substr(0, equals)),
                              setting_value(std::string_view(text).substr(equals + 1)));
    }
    try {
        return paint.with_settings(settings);
    } catch (const DomainError& error) {
        throw UsageError(std::string("--set ") + error.what());
    }
}

}  // namespace

Paint open_input(const CommonOptions& options, const std::string& file) {
    Paint paint = open_as_it_is(options, file);
    warn_of_implausible(options, paint);
    return paint;
}

void warn_of_implausible(const CommonOptions& options, const Paint& paint) {
    for (const std::string& line : paint.implausible_numbers()) warn(options, line);
}

void warn_of_coarse_spectra(const CommonOptions& options, const Measurement& measurement) {
    if (const auto line = measure::coarse_spectra_warning(measurement)) warn(options, *line);
}

Paint open_paint(const CommonOptions& options, const std::string& file) {
    Paint paint = open_as_it_is(options, file);
    if (!options.set.empty()) paint = with_settings(options, paint);
    warn_of_implausible(options, paint);
    return paint;
}

optics::Material open_material(const std::string& option, const std::string& text) {
    try {
        return is_stream(text) ? optics::read_material_file(text) : optics::find_material(text);
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", option, error.what()));
    }
}

void require_values(const bsdf::ModelInfo& model) {
    if (!model.can.reference_only) return;
    // `nacre reference` has no single flakes: models that show them give pictures only.
    throw UsageError(fmt::format("{}: follows light and has no values to give; see nacre {}",
                                 choice_of(model), model.can.sparkle ? "render" : "reference"));
}

void refuse_choice(const std::string& choice, const std::string& what) {
    throw UsageError(
        fmt::format("{}: {} holds a measured BRDF, which is shown as it was measured; models "
                    "are for recipes, and so are their options",
                    choice, what));
}

std::optional<bsdf::Model> model_for(std::initializer_list<const Paint*> paints,
                                     const ModelOptions& options, bool estimates) {
    const auto is_measured_brdf = [](const Paint* p) { return p->kind() == Kind::measured_brdf; };
    std::optional<bsdf::Model> model;
    for (const Paint* paint : paints) {
        if (!paint->is_measured()) model = parse_model_settings(options);
    }
    if (model) {
        if (!estimates || !model->info().can.estimated_values) require_values(model->info());
        return model;
    }
    const auto measured = std::find_if(paints.begin(), paints.end(), is_measured_brdf);
    if (measured != paints.end()) {
        if (const auto choice = choice_of_any(options)) {
            const std::vector<std::string> of_tables = solution_flags();
            if (std::ranges::any_of(of_tables,
                                    [&](auto& flag) { return choice->starts_with(flag); }))
                throw InputError(
                    fmt::format("{}: holds a measured BRDF, which is shown as it was measured: it "
                                "takes neither --model nor {}",
                                (*measured)->file(), fmt::join(of_tables, " nor ")));
            refuse_choice(*choice, (*measured)->file());
        }
    } else if (const auto choice = choice_of_any(options)) {
        throw UsageError(
            fmt::format("{}: {} holds measured colours, which are as they are; models "
                        "are for recipes, and so are their options",
                        *choice, (*paints.begin())->file()));
    }
    return std::nullopt;
}

void say_warnings(const CommonOptions& options, const Paint& paint) {
    for (const SolverWarning& warning : paint.warnings()) {
        warn(options, fmt::format("{}; {}", warning.message, advice(warning)));
    }
}

}  // namespace nacre::cli
