#pragma once

#include <initializer_list>
#include <span>
#include <string_view>
#include <utility>

#include "nacre/bsdf/model.h"

// The appearance models that Nacre offers. A model is added by an entry of its own (bsdf/model.h)
// and one line in models.cpp.

namespace nacre::models {

/// All but those that trace rays (models/traced/traced_models.h).
std::span<const bsdf::ModelInfo* const> all_models();
/// The first of them.
bsdf::Model default_model();
/// Null if there is none of that name.
const bsdf::ModelInfo* find_model(std::string_view name);

/// A model by its name, with such options: named_model("volume", {{"--tracking", "simpson"}}).
/// @throws DomainError if there is no such model or option; as bsdf::set_option()
bsdf::Model named_model(
    std::string_view name,
    std::initializer_list<std::pair<std::string_view, std::string_view>> options = {});

}  // namespace nacre::models
