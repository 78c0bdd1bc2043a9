#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "nacre/fit/fit.h"

// What a fit found, for people and for programs.

namespace nacre::cli {

/// Tables: numbers with bounds and errors, differences by angle, whether the standard was matched and
/// else what is missing and what might help, numbers that the colours do not determine.
std::string fit_text(const fit::Fit& fit);

/// The same and more: correlations, other lights, alternatives, effort.
nlohmann::json fit_json(const fit::Fit& fit);

}  // namespace nacre::cli
