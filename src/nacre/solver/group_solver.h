#pragma once

#include <cstddef>

#include "nacre/core/progress.h"
#include "nacre/solver/medium.h"
#include "nacre/solver/resolution.h"
#include "nacre/solver/wavelength_groups.h"

// Solves wavelengths that share one index of the binder, order by order.

namespace nacre::solver {

/// What becomes of the light that a smooth interface sends back into the coat.
enum class InternalReflection { scattered, lost };

/// Solves azimuthal orders, in parallel, until those omitted sum to less than `tolerance` of the peak.
/// @param medium  at wavelengths of one index of the binder
/// @param work  counts what is done, group_work() at most
/// @throws Error if a result is not finite; Stopped if `work` is
GroupSolution solve_group(PaintMedium medium, const Resolution& resolution,
                          InternalReflection internal, double tolerance, SharedProgress& work);

/// At most, of so many wavelengths, in units of one order of one block of them.
double group_work(int wavelengths, const Resolution& resolution);

/// Bytes.
struct GroupMemory {
    std::size_t solving;  ///< kernels and values by order
    std::size_t values;   ///< of the solution, for each wavelength
};

/// Of solving a group of so many wavelengths, of which paint.ior[first_wavelength] is the index.
GroupMemory group_memory(const PaintMedium& paint, int first_wavelength, int wavelengths,
                         const Resolution& resolution);

}  // namespace nacre::solver
