#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "apps/cli/instrument_options.h"
#include "apps/cli/model_options.h"
#include "apps/cli/options.h"
#include "nacre/measure/measurement.h"

// A panel on the command line: either a paint, which is measured, or a file of what was measured.

namespace nacre::cli {

struct MeasuredSample {
    measure::Measurement measurement;
    std::string path;
    std::string recipe_sha256;  ///< empty: measured, or made from a table
    std::string model;          ///< empty: measured
    /// Of the reflectance factor, by reading and wavelength; empty where values are not estimates.
    std::vector<std::vector<double>> standard_error{};
};

/// Reads a measured file, or measures a recipe, a solved paint or a table; by the model walk, with
/// standard errors (apps/cli/walk_sample.h).
///
/// A measured file has its own geometries, of which those asked for are taken; its colours are
/// stated anew under the light asked for, which needs spectra. An aperture that is asked for must
/// be the file's, or is taken where it states none.
/// @throws UsageError, InputError, DomainError, Error as load_brdf(), measure::measure() and
///         io::parse_measurement(), or if a measured file cannot be stated as asked
MeasuredSample measure_sample(const std::filesystem::path& path, const ModelOptions& model,
                              const InstrumentRequest& request, const CommonOptions& options);

/// Sample and standard. Where geometries or light are not asked for, a paint is measured as the
/// measured file was.
std::pair<MeasuredSample, MeasuredSample> measure_both(const std::filesystem::path& sample,
                                                       const std::filesystem::path& standard,
                                                       const ModelOptions& model,
                                                       const InstrumentRequest& request,
                                                       const CommonOptions& options);

/// Whether a file holds measured values; no, if it cannot be read.
bool is_measured_file(const std::filesystem::path& path);

}  // namespace nacre::cli
