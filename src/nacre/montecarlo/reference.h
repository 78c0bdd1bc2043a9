#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/core/estimate.h"
#include "nacre/core/math.h"
#include "nacre/core/part.h"
#include "nacre/core/progress.h"
#include "nacre/paint/recipe.h"

// An independent check of the solver: a random walk through the same recipe. It shares with the
// solver the recipe and the optics of films and interfaces, and no formula of radiative transfer.
// How it works and what it neglects: docs/reference.md.

namespace nacre::montecarlo {

/// A direction away from the surface. phi_o - phi_i = 180 deg is the mirror side.
struct Direction {
    double theta_deg = 0;  ///< from the outward normal, in kPolarAngleRange
    double phi_deg = 0;    ///< any finite angle
};

struct ReferenceSettings {
    std::uint64_t samples = 1u << 20;  ///< walks per incident direction, in kSamplesRange
    std::uint64_t seed = 0;
    Part part = Part::total;  ///< which light is counted

    static constexpr Range kSamplesRange{2, 1e15};
};

/// The BRDF in 1/sr: [incident][outgoing][wavelength], row-major.
///
/// Wavelengths at which the binder has the same index share walks, so their errors are correlated;
/// outgoing directions share walks too; incident directions do not. For a given seed the result is
/// the same, bit for bit, however many threads the caller's oneTBB arena has.
///
/// @param wavelengths_nm  as the recipe's materials allow
/// @param progress  may be empty
/// @throws DomainError if the recipe is not valid or has no layers, or naming an argument out of range
/// @throws Error if `progress` asks to stop (part of an estimate is no estimate), or if light stays
///         in the paint for ever (thick layers without absorption)
std::vector<Estimate> reference_brdf(const paint::Recipe& recipe,
                                     std::span<const Direction> incident,
                                     std::span<const Direction> outgoing,
                                     std::span<const double> wavelengths_nm,
                                     const ReferenceSettings& settings,
                                     const Progress& progress = {});

/// Fractions of the light from one direction; flakes and pigments absorb the remainder.
struct Albedo {
    Estimate reflectance;            ///< directional-hemispherical, specular reflection included
    Estimate absorbed_by_substrate;  ///< of a black substrate: the transmittance of what lies above
};

/// Reflectance and transmittance: [incident][wavelength], row-major. settings.part is not used.
/// Errors as for reference_brdf().
std::vector<Albedo> reference_albedo(const paint::Recipe& recipe,
                                     std::span<const Direction> incident,
                                     std::span<const double> wavelengths_nm,
                                     const ReferenceSettings& settings,
                                     const Progress& progress = {});

}  // namespace nacre::montecarlo
