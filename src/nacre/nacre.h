#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/core/progress.h"
#include "nacre/fit/fit.h"
#include "nacre/measure/geometry.h"
#include "nacre/measure/measurement.h"
#include "nacre/paint/recipe.h"
#include "nacre/paint/recipe_parameter.h"
#include "nacre/solver/solved_paint.h"

// The front door: open a paint, look at it, measure it, fit it, export it.
//
//   const nacre::Paint paint = nacre::open("violet.toml");
//   const auto readings = paint.measure(nacre::geometries("byk-mac"));
//   const auto match = paint.fit(standard, {"coats[0].thickness_nm"});
//
// Everything here is a value: copies share what they hold, may be used from any number of threads
// at once, and give the same bits on all of them. Nothing is printed; long work reports through a
// Progress and may be stopped by it (core/progress.h); what goes wrong is thrown (core/error.h):
// InputError where a file is wrong, naming file, key, value and allowed range; DomainError where a
// setting is; Error where the work itself failed or was stopped. Units and conventions:
// docs/conventions.md.
//
// Link nacre::nacre (find_package(nacre COMPONENTS core)). Pictures of scenes need ray tracing and
// have a door of their own.

namespace nacre {

using measure::Aperture;
using measure::Geometry;
using measure::Measurement;
using spectra::Illuminant;
using spectra::Observer;

/// What a file holds. Its contents tell, not its name.
enum class Kind {
    recipe,           ///< TOML (docs/recipe.md)
    solved_paint,     ///< a recipe and its solution, HDF5
    brdf_table,       ///< raw or SVD, HDF5 (docs/tables.md)
    measured_brdf,    ///< of the RGL database (.bsdf) or of MERL (.binary)
    measured_colours  ///< of a multi-angle instrument, CSV or JSON (docs/measure.md)
};

/// What is none of the others counts as a recipe: its reader says what is wrong with it.
Kind kind_of(std::string_view bytes);

/// How a recipe is solved.
struct SolveSettings {
    /// Vacuum wavelengths, nm; order and repetitions do not matter. Empty: 400 to 700 by 10.
    std::vector<double> wavelengths_nm = {};
    solver::SolverSettings resolution = {};

    friend bool operator==(const SolveSettings&, const SolveSettings&) = default;
};

/// At most so many wavelengths are solved at once.
inline constexpr std::size_t kMaxSolvedWavelengths = 2000;

/// Something that the solver could not resolve, so that multiple scattering is less certain.
struct SolverWarning {
    enum class What { scattering, azimuthal_series } what;
    bool held_back = false;  ///< by SolverSettings; with 0 there, more would have been chosen
    std::string message;     ///< naming file, quantity, value and what does no harm
};

/// What a solved paint has to warn of. `file` is for the messages.
std::vector<SolverWarning> solver_warnings(const solver::SolvedPaint& paint,
                                           const std::string& file);

using FitSettings = fit::FitOptions;
struct Match;

class Paint;
Paint open_text(std::string bytes, const std::string& name, const std::filesystem::path& folder);

class Paint {
 public:
    /// A paint that no file holds.
    /// @param bounds  between which a fit seeks its numbers, as the table [fit] of a recipe's file
    /// @throws DomainError as paint::validate() and paint::check_bounds()
    explicit Paint(paint::Recipe recipe, std::vector<paint::ParameterBounds> bounds = {});

    Kind kind() const;
    /// The file as it was opened, or what a text was said to be; empty for a recipe alone.
    const std::string& file() const;
    /// The recipe's name, or where it has none the file's, without folder and extension.
    std::string name() const;

    bool has_recipe() const;
    /// @throws InputError naming the file if it holds none: tables and measured values
    const paint::Recipe& recipe() const;
    /// SHA-256 of what the recipe says (io/recipe_file.h); empty without a recipe.
    std::string recipe_sha256() const;
    /// The table [fit] of a recipe's file.
    const std::vector<paint::ParameterBounds>& bounds() const;
    /// The same paint with one number changed, to be solved anew.
    /// @param key  as paint::matching_parameters(), meaning one number: "coats[0].thickness_nm"
    /// @throws InputError as recipe(); DomainError naming key, value and range
    Paint with(std::string_view key, double value) const;

    /// The paint solved: as its file holds it, whatever the settings' resolution, or its recipe
    /// solved, once for all copies of this paint, when first asked with such settings.
    /// @throws InputError as recipe(), if the recipe cannot be solved, or if the file holds the
    ///         solution at other wavelengths
    /// @throws DomainError if the settings are out of range; Error as solver::solve()
    std::shared_ptr<const solver::SolvedPaint> solved(const SolveSettings& settings = {}) const;
    /// Of all solutions so far.
    std::vector<SolverWarning> warnings() const;

    /// Seeks the composition, starting from this one, whose colours are nearest to a standard's.
    /// @param keys  of the numbers that may change, as paint::matching_parameters(), `*` for any
    ///        text; empty: those between bounds()
    /// @throws InputError as recipe(), or without layers; DomainError, Error as fit::fit()
    Match fit(const Measurement& standard, const std::vector<std::string>& keys = {},
              const FitSettings& settings = {}, const Progress& progress = {}) const;
    /// The whole keys that such patterns mean, each once.
    /// @throws InputError as recipe(); DomainError if there are none, or as
    ///         paint::matching_parameters()
    std::vector<std::string> free_keys(const std::vector<std::string>& patterns) const;

 private:
    struct State;
    friend Paint open_text(std::string, const std::string&, const std::filesystem::path&);
    explicit Paint(std::shared_ptr<const State> state) : state_(std::move(state)) {}

    std::shared_ptr<const State> state_;  // never null
};

/// What a fit found: its numbers, how sure they are, and the paint that they make.
struct Match : fit::Fit {
    Paint paint;
};

/// Reads a file of any kind, once: the paint needs it no more. Materials that a recipe names as
/// files are read too.
/// @throws InputError naming the file and what is wrong in it
Paint open(const std::filesystem::path& path);

/// The same from the contents of a file.
/// @param name    for messages
/// @param folder  where materials that a recipe names as files are looked for
/// @throws InputError as open()
Paint open_text(std::string bytes, const std::string& name,
                const std::filesystem::path& folder = {});

}  // namespace nacre
