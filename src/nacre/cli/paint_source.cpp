#include "nacre/cli/paint_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "nacre/cli/usage_error.h"
#include "nacre/core/atomic_file.h"
#include "nacre/core/error.h"
#include "nacre/io/recipe_file.h"
#include "nacre/io/solved_paint_file.h"

namespace nacre::cli {

namespace {

/// Two wavelengths closer than this are the same one, written in two ways.
constexpr double kSameWavelengthNm = 1e-6;

constexpr std::size_t kMostSolvedWavelengths = 2000;

std::string read_paint_file(const std::filesystem::path& path) {
    return read_file(path, io::kMostSolvedPaintBytes);
}

}  // namespace

layers::Recipe load_recipe(const std::filesystem::path& path) {
    const std::string bytes = read_paint_file(path);
    if (io::looks_like_solved_paint(bytes)) {
        return io::parse_solved_paint(bytes, path.string()).recipe;
    }
    return io::parse_recipe(bytes, path.string(), path.parent_path());
}

layers::SolvedPaint load_paint(const std::filesystem::path& path,
                               const std::optional<std::vector<double>>& wavelengths_nm,
                               const layers::SolverSettings& settings) {
    const std::string bytes = read_paint_file(path);
    if (io::looks_like_solved_paint(bytes)) {
        layers::SolvedPaint paint = io::parse_solved_paint(bytes, path.string());
        if (wavelengths_nm) {
            for (double wavelength : *wavelengths_nm) wavelength_position(paint, wavelength, path);
        }
        return paint;
    }
    const layers::Recipe recipe = io::parse_recipe(bytes, path.string(), path.parent_path());
    if (recipe.layers.empty()) {
        throw InputError(
            fmt::format("{}: layer: is missing; the model microflake needs at least one [[layer]]",
                        path.string()));
    }
    if (wavelengths_nm && wavelengths_nm->size() > kMostSolvedWavelengths) {
        throw UsageError(
            fmt::format("--wavelength: {} wavelengths to solve; at most {} are allowed",
                        wavelengths_nm->size(), kMostSolvedWavelengths));
    }
    std::vector<double> wavelengths = wavelengths_nm.value_or(layers::default_wavelengths_nm());
    std::sort(wavelengths.begin(), wavelengths.end());
    wavelengths.erase(std::unique(wavelengths.begin(), wavelengths.end()), wavelengths.end());
    try {
        return layers::solve(recipe, wavelengths, settings);
    } catch (const DomainError& error) {  // as a material whose data end too early
        throw InputError(fmt::format("{}: {}", path.string(), error.what()));
    }
}

std::size_t wavelength_position(const layers::SolvedPaint& paint, double wavelength_nm,
                                const std::filesystem::path& path) {
    const std::vector<double>& solved = paint.wavelengths_nm();
    const auto found = std::find_if(solved.begin(), solved.end(), [&](double w) {
        return std::abs(w - wavelength_nm) < kSameWavelengthNm;
    });
    if (found == solved.end()) {
        throw InputError(fmt::format(
            "{}: has been solved at {} wavelengths from {} to {} nm, {} nm is not among them",
            path.string(), solved.size(), solved.front(), solved.back(), wavelength_nm));
    }
    return static_cast<std::size_t>(found - solved.begin());
}

void require_known_model(const std::string& model) {
    if (model == "microflake") return;
    const bool planned = model == "thin-film" || model == "special-effect" || model == "nacre";
    throw UsageError(fmt::format("--model = {}: {}; available: microflake", model,
                                 planned ? "is not available in this version" : "is no model"));
}

}  // namespace nacre::cli
