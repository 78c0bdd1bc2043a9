#pragma once

#include <string>

#include "nacre/nacre.h"

// A material beside its paint, as a picture of colours.

namespace nacre::cli {

/// An SVG of the colours at all angles: of the instrument, of the rest of the fit, and of those
/// that the fit did not see. Both colours of a pair are scaled alike where one is brighter than the
/// display, so that a difference of brightness shows.
std::string material_chips(const std::string& paint, const FittedMaterial& material);

/// The same of a shader, which is no fit.
std::string shader_chips(const std::string& paint, const ShaderMaterial& material);

/// Nobody named the picture: only one of Nacre's own may be replaced.
/// @throws InputError naming the file if it is of another origin
void check_chips_beside(const std::string& file);

}  // namespace nacre::cli
