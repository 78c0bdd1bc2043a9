#pragma once

#include <array>
#include <string>

namespace nacre::studio {

/// A model by which paints are read: of all that there are (nacre/models/models.h) one of those that give
/// exact values of layers, and by which fits see paints.
struct ReadingModel {
    const char* name;
    const char* title;  ///< for people
};

/// The first is the default.
inline constexpr std::array<ReadingModel, 2> kReadingModels = {
    {{"microflake", "micro-flakes"}, {"nacre", "nacre, as the picture"}}};

/// The name as it is.
/// @throws InputError with those that there are
std::string parse_reading_model(const std::string& name);

}  // namespace nacre::studio
