#pragma once

#include <string>

#include "nacre/spectra/observer.h"

namespace nacre::spectra {

/// What parse_illuminant() and parse_observer() take: "D65", "10".
std::string name(Illuminant illuminant);
std::string name(Observer observer);

}  // namespace nacre::spectra
