#pragma once

#include <cstdint>
#include <vector>

#include "nacre/core/estimate.h"
#include "nacre/core/progress.h"
#include "nacre/paint/recipe.h"

// The mean of paints with large flakes by direction: explicit discs against the equation of
// transfer, and against the hot spot of the model nacre.

namespace nacre::study {

/// One layer, 15 um thick, of flakes of one kind under 50 um of clear coat: no disc is moved. All
/// is the same at every wavelength.
struct MeanCase {
    double depth = 2;  ///< c H
    double diameter_um = 20, alpha = 0.1;
    double reflectance = 0.9, transmittance = 0, ground = 0;
    double roughness = 0;  ///< Beckmann alpha of the clear coat
};

paint::Recipe recipe_of(const MeanCase& paint);

/// A direction in which light leaves, and what is seen there.
struct MeanRatios {
    double theta_deg = 0, phi_deg = 0;  ///< phi 180: the mirror side
    /// BRDF of discs without diffraction, less the lobe of a rough interface, weighted by the cosine
    /// over a cone of kExitCone_deg.
    Estimate discs = {};
    /// Over it, with the discs' standard error: the equation of transfer; with the hot spot alone,
    /// nothing taken from multiple scattering; the model nacre.
    Estimate transfer = {}, gain_only = {}, nacre = {};
};

inline constexpr double kExitCone_deg = 4;

/// In the mirror direction, in the plane of incidence and across it.
///
/// Walks among discs share no formula with the models. Each specimen is a tile of discs of its own;
/// the standard error is that of their mean. Directions share walks, so that their errors are
/// correlated.
/// @param walks  in all specimens together
/// @throws DomainError, Error as solver::solve(), montecarlo::DiscWalk and bsdf::HotSpotBrdf;
///         Stopped if `progress` says so
std::vector<MeanRatios> compare_means(const MeanCase& paint, double incidence_deg, int walks,
                                      std::uint64_t seed, const Progress& progress = {});

inline constexpr int kMeanSpecimens = 8;

}  // namespace nacre::study
