#pragma once

#include "nacre/solver/solved_paint.h"

namespace nacre::bsdf {

/// Whether the interface is rough; it is smooth where the binder has the index 1.
/// @param done  with the paint, for the message
/// @throws Error "a rough clearcoat ... cannot be `done`" if it is rough at some wavelengths only
bool has_rough_interface(const solver::SolvedPaint& paint, const char* done = "rendered");

/// Of the binder, the mean over the wavelengths.
double mean_index(const solver::PaintMedium& medium);

}  // namespace nacre::bsdf
