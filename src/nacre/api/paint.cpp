#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>

#include "nacre/api/state.h"
#include "nacre/bsdf/measured/merl.h"
#include "nacre/bsdf/measured/rgl.h"
#include "nacre/bsdf/tabulated/tabulated.h"
#include "nacre/core/file.h"
#include "nacre/core/sha256.h"
#include "nacre/core/text.h"
#include "nacre/io/brdf_table_file.h"
#include "nacre/io/file_kind.h"
#include "nacre/io/measured_brdf_file.h"
#include "nacre/io/measurement_file.h"
#include "nacre/io/recipe_text.h"
#include "nacre/io/solved_paint_file.h"
#include "nacre/paint/plausibility.h"
#include "nacre/solver/film_cache.h"
#include "nacre/solver/resolution.h"
#include "nacre/solver/solver.h"
#include "nacre/spectra/spectrum.h"

namespace nacre {

namespace {

/// Two wavelengths closer than this are the same one, written in two ways.
constexpr double kSameWavelength_nm = 1e-6;

/// The azimuthal series may end at this multiple of its tolerance without a warning: azimuthal_tail
/// is an upper estimate. It adds the largest values of the omitted orders as if all of them were at
/// one pair of directions, at one wavelength and of one sign.
constexpr double kTailOverTolerance = 10;

const char* name_of(Kind kind) {
    switch (kind) {
        case Kind::recipe:
            return "a recipe";
        case Kind::solved_paint:
            return "a solved paint";
        case Kind::brdf_table:
            return "a table of a BRDF";
        case Kind::measured_brdf:
            return "a measured BRDF";
        case Kind::measured_colours:
            return "measured colours";
    }
    return "";
}

/// What open() takes a file for.
Kind kind_of(io::FileKind kind) {
    switch (kind) {
        case io::FileKind::solved_paint:
            return Kind::solved_paint;
        case io::FileKind::brdf_table:
            return Kind::brdf_table;
        case io::FileKind::rgl:
        case io::FileKind::merl:
            return Kind::measured_brdf;
        case io::FileKind::measured_colours:
            return Kind::measured_colours;
        default:
            return Kind::recipe;
    }
}

MeasuredBrdf read_measured_brdf(io::TypedFile& file) {
    if (file.kind == io::FileKind::rgl) {
        bsdf::RglTable table = io::parse_rgl(file.bytes, file.name);
        const bool isotropic = table.isotropic();
        return {std::make_shared<const bsdf::MeasuredRgl>(std::move(table)), isotropic,
                std::move(file.bytes)};
    }
    auto merl = std::make_shared<const bsdf::MeasuredMerl>(io::parse_merl(file.bytes, file.name));
    return {std::move(merl), true, std::move(file.bytes)};
}

/// Refuses what is no paint, saying what it is instead.
/// @throws InputError naming the file
void require_recipe(const io::TypedFile& file) {
    if (file.kind == io::FileKind::recipe) return;
    if (file.kind == io::FileKind::other_table) {
        io::parse_measurement_file(file.bytes, file.name);  // says more
    }
    if (file.kind == io::FileKind::other_encoding)
        require_utf8(file.bytes, file.name);  // as this does
    throw InputError(
        fmt::format("{}: is {}; needed here is a recipe (TOML), a solved paint or table (HDF5), a "
                    "measured BRDF "
                    "(.bsdf, .binary) or measured colours (CSV, JSON, CGATS)",
                    file.name, io::words_for(file.kind)));
}

/// By wavelength, each once, as a solver wants them.
SolveSettings in_order(SolveSettings settings) {
    std::vector<double>& nm = settings.wavelengths_nm;
    if (nm.empty()) nm = spectra::default_wavelengths_nm();
    std::sort(nm.begin(), nm.end());
    nm.erase(std::unique(nm.begin(), nm.end()), nm.end());
    if (nm.size() > kMaxSolvedWavelengths) {
        throw SettingError("wavelength",
                           fmt::format("{} wavelengths to solve; at most {} are allowed", nm.size(),
                                       kMaxSolvedWavelengths));
    }
    return settings;
}

}  // namespace

SettingError::SettingError(const std::string& message)
    : DomainError(message),
      setting_(message.substr(0, message.find_first_of(" :"))),
      reason_(message.substr(std::min(message.size(), message.find(": ") + 2))) {}

Kind kind_of(std::string_view bytes) { return kind_of(io::kind_of_bytes(bytes)); }

std::vector<SolverWarning> solver_warnings(const solver::SolvedPaint& paint,
                                           const std::string& file) {
    const solver::SolverSettings& settings = paint.settings;
    const solver::SolverReport& report = paint.report;
    std::vector<SolverWarning> warnings;
    if (report.unresolved_scattering > solver::kAcceptedUnresolved) {
        warnings.push_back(
            {SolverWarning::What::scattering, settings.exit_nodes || settings.inner_nodes,
             fmt::format("{}: {} + {} nodes miss {:.2g} % of the extinction in some direction "
                         "(unresolved_scattering; up to {:g} % does no harm), so that its "
                         "multiple scattering may be off by a fraction of that",
                         file, report.exit_nodes, report.inner_nodes,
                         100 * report.unresolved_scattering, 100 * solver::kAcceptedUnresolved)});
    }
    if (report.azimuthal_tail > kTailOverTolerance * settings.tolerance) {
        warnings.push_back(
            {SolverWarning::What::azimuthal_series, settings.max_orders != 0,
             fmt::format("{}: the azimuthal series ends after {} orders at {:.2g} of its peak, "
                         "not at {:g} (azimuthal_tail and tolerance), so that its multiple "
                         "scattering may ring around the azimuth by as much of it",
                         file, report.orders, report.azimuthal_tail, settings.tolerance)});
    }
    return warnings;
}

std::string Paint::State::label() const { return file.empty() ? "recipe" : file; }

std::shared_ptr<Paint::State::Solution> Paint::State::solution(
    const SolveSettings& settings) const {
    const std::lock_guard lock(mutex);
    const auto known = std::ranges::find_if(
        solutions, [&](const auto& solution) { return solution->settings == settings; });
    if (known != solutions.end()) {
        std::rotate(known, known + 1, solutions.end());  // the last one asked for stands last
        return solutions.back();
    }
    if (solutions.size() == kKeptSolutions) solutions.erase(solutions.begin());
    solutions.push_back(std::make_shared<Solution>());
    solutions.back()->settings = settings;
    return solutions.back();
}

Paint::Paint(paint::Recipe recipe, std::vector<paint::ParameterBounds> bounds,
             std::vector<paint::ParameterDeviation> deviations,
             std::vector<paint::ParameterCorrelation> correlations) {
    paint::validate(recipe, {});
    for (const paint::ParameterBounds& b : bounds) paint::check_bounds(recipe, b);
    for (const paint::ParameterDeviation& d : deviations) paint::check_deviation(recipe, d);
    paint::check_correlations(recipe, deviations, correlations);
    state_ = std::make_shared<const State>(
        io::RecipeFile{std::move(recipe), std::move(bounds), std::move(deviations),
                       std::move(correlations)},
        "");
}

Paint open_text(std::string bytes, const std::string& name, const References& references,
                const std::string& sample) {
    return open_typed(io::typed_file(std::move(bytes), name, references), sample);
}

Paint open_typed(io::TypedFile file, const std::string& sample) {
    const Kind kind = kind_of(file.kind);
    if (!sample.empty() && kind != Kind::measured_colours) {
        throw InputError(fmt::format("{}: holds {}; only measured colours have samples", file.name,
                                     name_of(kind)));
    }
    const auto paint = [&](Paint::State::Contents contents, const std::string& sha256 = {}) {
        return Paint(std::make_shared<const Paint::State>(std::move(contents), file.name, sha256));
    };
    switch (kind) {
        case Kind::recipe:
            if (file.references.may_quote()) require_recipe(file);
            return paint(io::parse_recipe_file(file));
        case Kind::solved_paint:
            return paint(std::make_shared<const solver::SolvedPaint>(
                             io::parse_solved_paint(file.bytes, file.name)),
                         sha256_hex(file.bytes));
        case Kind::brdf_table:
            return paint(bsdf::shared_brdf_table(io::parse_brdf_table(file.bytes, file.name)),
                         sha256_hex(file.bytes));
        case Kind::measured_brdf: {
            const std::string sha256 = sha256_hex(file.bytes);
            return paint(read_measured_brdf(file), sha256);
        }
        case Kind::measured_colours: {
            if (!file.references.may_quote()) {  // as the reader would
                throw InputError(
                    fmt::format("{}: holds measured colours; a recipe, a table or a "
                                "measured BRDF is needed here",
                                file.name));
            }
            io::MeasurementFile read = io::parse_measurement_file(file.bytes, file.name);
            const Measurement& found = io::sample_called(read, sample, file.name);
            std::vector<std::string>& contradictions =
                read.contradictions[static_cast<std::size_t>(&found - read.samples.data())];
            return paint(MeasuredColours{std::move(file.bytes), sample, found,
                                         std::move(read.notes), std::move(contradictions)});
        }
    }
    throw Error("no such kind of file");
}

Paint open(const std::filesystem::path& path) { return open(path, References::of_file(path)); }

Paint open(const std::filesystem::path& path, const References& references) {
    constexpr std::size_t kMaxBytes =
        std::max({io::kMaxSolvedPaintBytes, io::kMaxBrdfTableBytes, io::kMaxMeasuredBytes});
    const io::SampleName name = io::split_sample_name(path);
    return open_text(read_file(name.file, kMaxBytes), name.file.string(), references, name.sample);
}

Kind Paint::kind() const { return static_cast<Kind>(state_->contents.index()); }

const std::string& Paint::file() const { return state_->file; }

std::string Paint::name() const {
    if (has_recipe() && !recipe().name.empty()) return recipe().name;
    return std::filesystem::path(state_->file).stem().string();
}

bool Paint::has_recipe() const { return kind() == Kind::recipe || kind() == Kind::solved_paint; }

bool Paint::is_measured() const {
    return kind() == Kind::measured_brdf || kind() == Kind::measured_colours;
}

const std::vector<std::string>& Paint::notes() const {
    static const std::vector<std::string> none;
    const auto* colours = std::get_if<MeasuredColours>(&state_->contents);
    return colours ? colours->notes : none;
}

const paint::Recipe& Paint::recipe() const {
    if (const auto* file = std::get_if<io::RecipeFile>(&state_->contents)) return file->recipe;
    if (const auto* solved =
            std::get_if<std::shared_ptr<const solver::SolvedPaint>>(&state_->contents)) {
        return (*solved)->recipe;
    }
    state_->refuse_without_recipe();
}

std::string Paint::recipe_sha256() const {
    return has_recipe() ? io::recipe_hash(recipe()) : std::string();
}

const std::string& Paint::file_sha256() const { return state_->file_sha256; }

const std::vector<paint::ParameterBounds>& Paint::bounds() const {
    static const std::vector<paint::ParameterBounds> none;
    const auto* file = std::get_if<io::RecipeFile>(&state_->contents);
    return file ? file->bounds : none;
}

const std::vector<paint::ParameterDeviation>& Paint::deviations() const {
    static const std::vector<paint::ParameterDeviation> none;
    const auto* file = std::get_if<io::RecipeFile>(&state_->contents);
    return file ? file->deviations : none;
}

const std::vector<paint::ParameterCorrelation>& Paint::correlations() const {
    static const std::vector<paint::ParameterCorrelation> none;
    const auto* file = std::get_if<io::RecipeFile>(&state_->contents);
    return file ? file->correlations : none;
}

void Paint::State::refuse_without_recipe() const {
    throw InputError(fmt::format("{}: holds {}; a recipe is needed here", label(),
                                 name_of(static_cast<Kind>(contents.index()))));
}

io::RecipeFile Paint::State::recipe_file() const {
    if (const auto* read = std::get_if<io::RecipeFile>(&contents)) return *read;
    if (const auto* solved = std::get_if<std::shared_ptr<const solver::SolvedPaint>>(&contents)) {
        return {(*solved)->recipe, {}};
    }
    refuse_without_recipe();
}

Paint Paint::with_uncertainty(const std::vector<paint::ParameterDeviation>& deviations,
                              const std::vector<paint::ParameterCorrelation>& correlations) const {
    io::RecipeFile made = state_->recipe_file();
    const std::vector<paint::ParameterDeviation> all =
        paint::with_deviations(std::move(made.deviations), deviations);
    const auto called = [](const std::string& key) {
        return [&key](const paint::ParameterDeviation& d) { return d.key == key; };
    };
    for (const paint::ParameterDeviation& d : all) paint::check_deviation(made.recipe, d);
    made.deviations.clear();  // now in the order of a file
    for (const paint::RecipeParameter& number : paint::recipe_parameters(made.recipe)) {
        const auto found = std::ranges::find_if(all, called(number.key));
        if (found != all.end()) made.deviations.push_back(*found);
    }
    made.correlations = paint::correlations_among(
        std::move(made.correlations),
        [&](const std::string& key) { return std::ranges::none_of(deviations, called(key)); });
    made.correlations.insert(made.correlations.end(), correlations.begin(), correlations.end());
    paint::check_correlations(made.recipe, made.deviations, made.correlations);
    return Paint(std::make_shared<const State>(std::move(made), state_->file));
}

Paint Paint::with_settings(const std::vector<std::pair<std::string, std::string>>& settings) const {
    return Paint(std::make_shared<const State>(io::with_settings(state_->recipe_file(), settings),
                                               state_->file));
}

io::RecipeText Paint::recipe_text(const References& there) const {
    return io::recipe_text(state_->recipe_file(), there);
}

std::string Paint::whole_key(std::string_view key) const {
    const std::vector<std::string> keys =
        paint::matching_parameters(state_->recipe_file().recipe, key);
    if (keys.size() == 1) return keys[0];
    throw SettingError(std::string(key), fmt::format("means {} numbers, such as {}; must mean one",
                                                     keys.size(), keys[0]));
}

Paint Paint::with(std::string_view key, double value) const {
    io::RecipeFile changed = state_->recipe_file();
    paint::set_parameter(changed.recipe, whole_key(key), value);
    paint::validate(changed.recipe, {});
    return Paint(std::make_shared<const State>(std::move(changed), state_->file));
}

namespace {

/// @throws InputError as Paint::recipe(), or naming the file if the recipe has no layers
const paint::Recipe& recipe_to_solve(const Paint& paint, const std::string& label) {
    const paint::Recipe& recipe = paint.recipe();
    if (recipe.layers.empty()) {
        throw InputError(fmt::format(
            "{}: layer: is missing; solving a paint needs at least one [[layer]]", label));
    }
    return recipe;
}

/// For paints that are solved one after another with the same flakes, as when one number is changed
/// again and again; the bits are those without it. None for so many wavelengths that the tables would
/// take more than some megabytes.
solver::FilmCache* recent_films(const std::vector<double>& wavelengths_nm) {
    constexpr std::size_t kMaxTables = 16, kMaxWavelengths = 64;
    static solver::FilmCache films(kMaxTables);
    return wavelengths_nm.size() <= kMaxWavelengths ? &films : nullptr;
}

}  // namespace

std::shared_ptr<const solver::SolvedPaint> Paint::solved(const SolveSettings& settings,
                                                         const Progress& progress) const {
    if (const auto* stored =
            std::get_if<std::shared_ptr<const solver::SolvedPaint>>(&state_->contents)) {
        for (double wavelength_nm : settings.wavelengths_nm) {
            wavelength_position(**stored, wavelength_nm, state_->label());
        }
        return *stored;
    }
    const paint::Recipe& paint = recipe_to_solve(*this, state_->label());
    const std::shared_ptr<State::Solution> solution = state_->solution(in_order(settings));
    const std::lock_guard lock(solution->mutex);
    if (!solution->paint) {
        // Isolated: a thread that waits for parts of this solution must not begin other work of the
        // caller's meanwhile, which might ask for it again and wait for itself.
        tbb::this_task_arena::isolate([&] {
            state_->naming_file([&] {
                solution->paint = std::make_shared<const solver::SolvedPaint>(solver::solve(
                    paint, solution->settings.wavelengths_nm, solution->settings.resolution,
                    recent_films(solution->settings.wavelengths_nm), progress));
            });
        });
    }
    return solution->paint;
}

std::size_t Paint::memory_to_solve(const SolveSettings& settings) const {
    if (kind() == Kind::solved_paint) return 0;
    const paint::Recipe& paint = recipe_to_solve(*this, state_->label());
    const SolveSettings ordered = in_order(settings);
    return state_->naming_file(
        [&] { return solver::memory_to_solve(paint, ordered.wavelengths_nm, ordered.resolution); });
}

std::vector<SolverWarning> Paint::warnings() const {
    if (const auto* stored =
            std::get_if<std::shared_ptr<const solver::SolvedPaint>>(&state_->contents)) {
        return solver_warnings(**stored, state_->label());
    }
    std::vector<std::shared_ptr<State::Solution>> solutions;
    {
        const std::lock_guard lock(state_->mutex);
        solutions = state_->solutions;
    }
    std::vector<SolverWarning> all;
    for (const auto& solution : solutions) {
        const std::lock_guard lock(solution->mutex);
        if (!solution->paint) continue;  // it could not be solved
        for (SolverWarning& w : solver_warnings(*solution->paint, state_->label())) {
            all.push_back(std::move(w));
        }
    }
    return all;
}

std::vector<std::string> Paint::implausible_numbers() const {
    if (const auto* colours = std::get_if<MeasuredColours>(&state_->contents)) {
        return colours->contradictions;
    }
    if (!has_recipe()) return {};
    std::vector<std::string> lines = paint::implausible_numbers(recipe());
    for (std::string& line : lines) line = fmt::format("{}: {}", state_->label(), line);
    return lines;
}

std::size_t wavelength_position(const solver::SolvedPaint& paint, double wavelength_nm,
                                const std::string& file) {
    const std::vector<double>& solved = paint.wavelengths_nm();
    const auto found = std::find_if(solved.begin(), solved.end(), [&](double w) {
        return std::abs(w - wavelength_nm) < kSameWavelength_nm;
    });
    if (found == solved.end()) {
        throw InputError(fmt::format(
            "{}: has been solved at {} wavelengths from {} to {} nm, {} nm is not among them", file,
            solved.size(), solved.front(), solved.back(), wavelength_nm));
    }
    return static_cast<std::size_t>(found - solved.begin());
}

}  // namespace nacre
