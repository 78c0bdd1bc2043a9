#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "nacre/bsdf/model.h"

// The appearance models that Nacre offers. A model is added by an entry of its own (bsdf/model.h)
// and one line in models.cpp.

namespace nacre::models {

/// All but those that trace rays (models/traced/traced_models.h).
std::span<const bsdf::ModelInfo* const> all_models();
/// The first of them, for values.
bsdf::Model default_model();
/// For pictures, in which flakes are seen one by one.
bsdf::Model default_picture_model();
/// The names of those that satisfy a condition, default_picture_model() first.
std::vector<std::string_view> names_where(bool (*condition)(const bsdf::ModelInfo&));
/// The names of those by which paints are read by values and sought by their colours
/// (Capabilities::fitted), default_model() first.
std::vector<std::string_view> names_of_fitted();
/// The names of those that make arrays as they are without any choice (bsdf::Model::makes_arrays),
/// likewise.
std::vector<std::string_view> names_with_arrays();
/// Null if there is none of that name.
const bsdf::ModelInfo* find_model(std::string_view name);

/// The model of that name with its default settings; those of its own type, as
/// montecarlo::VolumeModel{.tracking = Tracking::simpson}, choose others.
/// @throws DomainError if there is no such model
bsdf::Model named_model(std::string_view name);

}  // namespace nacre::models
