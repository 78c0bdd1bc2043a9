#pragma once

#include "nacre/reference/medium_grid.h"

namespace nacre::volume {

/// What walks through one paint share, before any wavelength is chosen.
struct WalkTables {
    layers::Recipe recipe;
    reference::MediumGrid grid;

    WalkTables(const layers::Recipe& r, const std::vector<double>& wavelengths_nm)
        : recipe(r), grid(r, wavelengths_nm) {}
};

}  // namespace nacre::volume
