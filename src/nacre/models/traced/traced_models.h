#pragma once

#include <span>

#include "nacre/bsdf/model.h"

namespace nacre::models {

/// The models that trace rays among flakes, by Embree: in the package's component `render`.
/// Each is an alternative to one of all_models().
std::span<const bsdf::ModelInfo* const> traced_models();

}  // namespace nacre::models
