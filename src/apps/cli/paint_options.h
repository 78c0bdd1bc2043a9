#pragma once

#include <functional>
#include <optional>
#include <string>

#include "apps/cli/model_options.h"
#include "apps/cli/options.h"
#include "nacre/nacre.h"

// The model options as applied to a paint.

namespace nacre::cli {

/// The file of any kind, or the shipped paint, that an argument of the command names. Warns of what
/// is implausible in its recipe.
/// @throws InputError as nacre::find_paint() and open(), and warn()
Paint open_input(const CommonOptions& options, const std::string& file);

/// The same with the values of --set in its recipe.
/// @throws UsageError naming --set, the key, the value and what is allowed; InputError as
///         open_input(), or if the file holds no recipe
Paint open_paint(const CommonOptions& options, const std::string& file);

/// The material that an option names: as optics::find_material(), or a file of one through a
/// stream, as "-".
/// @throws InputError as optics::find_material() and optics::read_material_file(), naming the option
optics::Material open_material(const std::string& option, const std::string& text);

/// The model that the command line chooses for the paints. None where all of them hold measured
/// values, which are shown as they are.
/// @throws UsageError as parse_model_settings(), if a model or one of its options was chosen and no
///         paint takes one, or if the model gives no values, only pictures, nor (where they will
///         do) estimates
/// @throws InputError if a table was asked for of a measured BRDF
std::optional<bsdf::Model> model_for(std::initializer_list<const Paint*> paints,
                                     const ModelOptions& options, bool estimates = false);

/// @throws UsageError if the model gives no values, only pictures
void require_values(const bsdf::ModelInfo& model);

/// @throws UsageError always: `what` holds a measured BRDF, to which nothing can be chosen
/// @param choice  what the command line said, as in "--model = nacre"
[[noreturn]] void refuse_choice(const std::string& choice, const std::string& what);

/// Warns of the numbers that a paint hardly has.
/// @throws InputError as warn()
void warn_of_implausible(const CommonOptions& options, const Paint& paint);

/// Warns of colours that are sums over too few wavelengths (measure::coarse_spectra_warning).
/// @throws InputError as warn()
void warn_of_coarse_spectra(const CommonOptions& options, const Measurement& measurement);

/// Warns of what the solver could not resolve in a paint.
/// @throws InputError as warn()
void say_warnings(const CommonOptions& options, const Paint& paint);

}  // namespace nacre::cli
