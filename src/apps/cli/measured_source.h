#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "apps/cli/model_options.h"
#include "nacre/bsdf/bsdf.h"

// Files of measured BRDFs: the RGL database's tensor files (.bsdf) and MERL's (.binary). They are
// known by their contents, not by their names: the first begins with "tensor_file", the second with
// three sizes from which the length of the file follows.

namespace nacre::cli {

bool is_measured_brdf(std::string_view bytes);
bool is_measured_brdf_file(const std::filesystem::path& path);

/// @param name  of the file, for messages
/// @throws InputError naming file, field, value and what is allowed
std::shared_ptr<const bsdf::Bsdf> make_measured_brdf(std::string_view bytes,
                                                     const std::string& name);

/// @throws UsageError if --model was given for a measured BRDF
void refuse_model_of_measured(bool model_given, const std::string& model, const std::string& file);

}  // namespace nacre::cli
