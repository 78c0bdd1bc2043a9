#pragma once

#include <nanobind/nanobind.h>

#include "nacre/measure/difference.h"
#include "nacre/nacre.h"

namespace nacre::python {

/// A colour difference as a dictionary of arrays and numbers.
nanobind::dict difference_of(const measure::Difference& difference);

}  // namespace nacre::python
