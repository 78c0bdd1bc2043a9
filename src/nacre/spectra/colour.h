#pragma once

// From spectra to colours and back, in one include. Formulas, tables and error bounds:
// docs/colour.md.

#include "nacre/spectra/lab.h"         // IWYU pragma: export
#include "nacre/spectra/observer.h"    // IWYU pragma: export
#include "nacre/spectra/rgb.h"         // IWYU pragma: export
#include "nacre/spectra/upsampling.h"  // IWYU pragma: export
#include "nacre/spectra/xyz.h"         // IWYU pragma: export
