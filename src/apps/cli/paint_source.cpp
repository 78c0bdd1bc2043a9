#include "apps/cli/paint_source.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "apps/cli/measured_source.h"
#include "apps/cli/model_options.h"
#include "apps/cli/options.h"
#include "nacre/bsdf/tabulated/tabulated.h"
#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/core/progress.h"
#include "nacre/io/brdf_table_file.h"
#include "nacre/io/recipe_file.h"
#include "nacre/io/solved_paint_file.h"
#include "nacre/solver/resolution.h"

namespace nacre::cli {

namespace {

/// Two wavelengths closer than this are the same one, written in two ways.
constexpr double kSameWavelength_nm = 1e-6;

constexpr std::size_t kMaxSolvedWavelengths = 2000;

std::string read_paint_file(const std::filesystem::path& path) {
    return read_file(path, std::max(io::kMaxSolvedPaintBytes, io::kMaxBrdfTableBytes));
}

void require_recipe(std::string_view bytes, const std::filesystem::path& path) {
    if (is_measured_brdf(bytes)) {
        throw InputError(
            fmt::format("{}: holds a measured BRDF; a recipe is needed here", path.string()));
    }
}

/// The series may end somewhat above its tolerance before anybody needs to know: what follows its
/// last orders is smaller than they are.
constexpr double kTailOverTolerance = 10;

/// What remains to be done about it: drop the option that held the solver back, or distrust.
std::string advice(bool held_back, std::string_view options) {
    if (held_back) {
        return fmt::format("solve it without {}, and they are chosen from the recipe", options);
    }
    return "the solver is at its limits: compare with nacre reference before relying on this "
           "paint, or make its narrowest lobe wider (alpha of the flakes, anisotropy of the "
           "pigments)";
}

void warn_if_unresolved(const solver::SolvedPaint& paint, const std::filesystem::path& path,
                        const CommonOptions& options) {
    const solver::SolverSettings& settings = paint.settings;
    const solver::SolverReport& report = paint.report;
    if (report.unresolved_scattering > solver::kAcceptedUnresolved) {
        say(options,
            fmt::format(
                "nacre: warning: {}: {} + {} nodes miss {:.2g} % of the scattering in some "
                "direction (unresolved_scattering; up to {:g} % does no harm), so that its "
                "multiple scattering may be off by a fraction of that; {}",
                path.string(), report.exit_nodes, report.inner_nodes,
                100 * report.unresolved_scattering, 100 * solver::kAcceptedUnresolved,
                advice(settings.exit_nodes || settings.inner_nodes, "--nodes and --inner-nodes")));
    }
    if (report.azimuthal_tail > kTailOverTolerance * settings.tolerance) {
        say(options,
            fmt::format("nacre: warning: {}: the azimuthal series ends after {} orders at {:.2g} "
                        "of its peak, not at {:g} (azimuthal_tail and tolerance), so that its "
                        "multiple scattering may ring around the azimuth by a share like that; {}",
                        path.string(), report.orders, report.azimuthal_tail, settings.tolerance,
                        advice(settings.max_orders != 0, "--orders")));
    }
}

solver::SolvedPaint solve_recipe(std::string_view text, const std::filesystem::path& path,
                                 const std::optional<std::vector<double>>& wavelengths_nm,
                                 const solver::SolverSettings& settings) {
    const paint::Recipe recipe = io::parse_recipe(text, path.string(), path.parent_path());
    if (recipe.layers.empty()) {
        throw InputError(fmt::format(
            "{}: layer: is missing; solving a paint needs at least one [[layer]]", path.string()));
    }
    if (wavelengths_nm && wavelengths_nm->size() > kMaxSolvedWavelengths) {
        throw UsageError(
            fmt::format("--wavelength: {} wavelengths to solve; at most {} are allowed",
                        wavelengths_nm->size(), kMaxSolvedWavelengths));
    }
    std::vector<double> wavelengths = wavelengths_nm.value_or(solver::default_wavelengths_nm());
    std::sort(wavelengths.begin(), wavelengths.end());
    wavelengths.erase(std::unique(wavelengths.begin(), wavelengths.end()), wavelengths.end());
    try {
        return solver::solve(recipe, wavelengths, settings);
    } catch (const DomainError& error) {  // as a material whose data end too early
        throw InputError(fmt::format("{}: {}", path.string(), error.what()));
    }
}

}  // namespace

paint::Recipe load_recipe(const std::filesystem::path& path) {
    const std::string bytes = read_paint_file(path);
    require_recipe(bytes, path);
    if (io::looks_like_solved_paint(bytes)) {
        return io::parse_solved_paint(bytes, path.string()).recipe;
    }
    return io::parse_recipe(bytes, path.string(), path.parent_path());
}

solver::SolvedPaint load_paint(const std::filesystem::path& path,
                               const std::optional<std::vector<double>>& wavelengths_nm,
                               const CommonOptions& options,
                               const solver::SolverSettings& settings) {
    const std::string bytes = read_paint_file(path);
    require_recipe(bytes, path);
    if (io::looks_like_solved_paint(bytes)) {
        solver::SolvedPaint paint = io::parse_solved_paint(bytes, path.string());
        if (wavelengths_nm) {
            for (double wavelength : *wavelengths_nm) wavelength_position(paint, wavelength, path);
        }
        warn_if_unresolved(paint, path, options);
        return paint;
    }
    solver::SolvedPaint paint = solve_recipe(bytes, path, wavelengths_nm, settings);
    warn_if_unresolved(paint, path, options);
    return paint;
}

std::size_t wavelength_position(const solver::SolvedPaint& paint, double wavelength_nm,
                                const std::filesystem::path& path) {
    const std::vector<double>& solved = paint.wavelengths_nm();
    const auto found = std::find_if(solved.begin(), solved.end(), [&](double w) {
        return std::abs(w - wavelength_nm) < kSameWavelength_nm;
    });
    if (found == solved.end()) {
        throw InputError(fmt::format(
            "{}: has been solved at {} wavelengths from {} to {} nm, {} nm is not among them",
            path.string(), solved.size(), solved.front(), solved.back(), wavelength_nm));
    }
    return static_cast<std::size_t>(found - solved.begin());
}

bool is_brdf_table(const std::filesystem::path& path) {
    return io::looks_like_brdf_table(read_paint_file(path));
}

std::string PaintSurface::recipe_sha256() const { return recipe ? io::recipe_hash(*recipe) : ""; }

PaintSurface load_surface(const std::filesystem::path& path, const bsdf::Model& model,
                          const CommonOptions& options) {
    const std::string bytes = read_paint_file(path);
    if (is_measured_brdf(bytes)) {
        if (model != models::default_model()) {
            throw InputError(
                fmt::format("{}: holds a measured BRDF, which is shown as it was measured: it "
                            "takes neither --model nor --table",
                            path.string()));
        }
        return {make_measured_brdf(bytes, path.string()), std::nullopt};
    }
    const bsdf::Solution solution = model.info().solution;
    bsdf::ModelInput input;
    if (solution == bsdf::Solution::none) {
        input.recipe = load_recipe(path);
    } else if (io::looks_like_brdf_table(bytes)) {
        if (solution != bsdf::Solution::table) {
            throw InputError(fmt::format(
                "{}: holds a table of a BRDF, from which only the model {} renders", path.string(),
                fmt::join(models_that([](const bsdf::ModelInfo& m) {
                              return m.solution == bsdf::Solution::table;
                          }),
                          ", ")));
        }
        input.table = bsdf::share_table(io::parse_brdf_table(bytes, path.string()));
        try {
            model.require_kind(*input.table, path.string());
        } catch (const DomainError& error) {
            throw UsageError(error.what());
        }
    } else {
        input.solved =
            std::make_shared<const solver::SolvedPaint>(load_paint(path, std::nullopt, options));
        input.recipe = input.solved->recipe;
    }
    try {
        ProgressBar bar("prepare", options.quiet || !model.makes_table());
        auto made = model.make(input, bar.callback());
        return {std::move(made), input.table ? std::nullopt : std::optional(input.recipe)};
    } catch (const DomainError& error) {
        throw InputError(fmt::format("{}: {}", path.string(), error.what()));
    }
}

}  // namespace nacre::cli
