#pragma once

#include <vector>

#include "nacre/bsdf/merl_table.h"
#include "nacre/core/progress.h"
#include "nacre/measure/brdf.h"

namespace nacre::measure {

/// Cells of a table over half and difference angles, [2, 1024] each. Reading code of the database
/// takes no others than its own.
struct MerlSettings {
    int half = bsdf::MerlTable::kHalf;
    int difference = bsdf::MerlTable::kDifference;
    int azimuths = bsdf::MerlTable::kAzimuths;
};

/// Measures a reciprocal isotropic surface that is alike on both sides of the plane of incidence,
/// as every one of Nacre's is, in the middle of every cell; cells with a direction below the
/// horizon are marked as not measured, with -1. RGB is that of spectra::rec709_weights(), with
/// components outside the gamut cut off at zero, as a negative value would mean another thing.
///                                                                        [matusik-2003]
/// @param wavelengths_nm  those of `brdf`, increasing
/// @throws DomainError if a setting is out of range, the table larger than 2 GiB, or the BRDF
/// negative or not finite somewhere
/// @throws Error if `progress` asks to stop
bsdf::MerlTable acquire_merl(const Brdf& brdf, const std::vector<double>& wavelengths_nm,
                             const MerlSettings& settings, const Progress& progress = {});

}  // namespace nacre::measure
