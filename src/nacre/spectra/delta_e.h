#pragma once

#include "nacre/spectra/observer.h"

namespace nacre::spectra {

/// CIEDE2000 difference of two CIELAB colours with kL = kC = kH = 1; about 1 is just noticeable.
/// Symmetric in its arguments.                                        [sharma-2005, eq. 2-22]
double delta_e_2000(const Vec3& lab1, const Vec3& lab2);

}  // namespace nacre::spectra
