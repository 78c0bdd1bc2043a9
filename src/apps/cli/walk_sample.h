#pragma once

#include <filesystem>

#include "apps/cli/measured_sample.h"

namespace nacre::cli {

/// Reads a recipe, or the recipe inside a solved paint, by the reference's random walk
/// (montecarlo/reference.h): an answer that shares no radiative transfer with the solver, with the
/// standard error of each value. Lamp and detector are points.
/// @throws UsageError if an aperture is asked for
/// @throws InputError, DomainError, Error as load_recipe() and montecarlo::reference_brdf()
MeasuredSample measure_by_walk(const std::filesystem::path& path, const InstrumentRequest& request,
                               const std::string& model, const CommonOptions& options);

}  // namespace nacre::cli
