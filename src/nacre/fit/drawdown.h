#pragma once

#include <optional>
#include <string>
#include <vector>

#include "nacre/core/progress.h"
#include "nacre/measure/drawdown.h"
#include "nacre/optics/material.h"
#include "nacre/paint/recipe.h"
#include "nacre/spectra/spectrum.h"

// A pigment's coefficients from drawdowns: films of paint of known thickness and content over a
// black and a white ground, whose reflectance is measured over both; and from tints, in which it is
// mixed with a white that is known. The method and what it determines: docs/drawdown.md.

namespace nacre::fit {

using measure::Drawdown;
using measure::DrawdownGeometry;
using measure::DrawdownReading;

/// The words of options, in the order of the enumeration.
std::vector<std::string> drawdown_geometry_words();

struct DrawdownSettings {
    DrawdownGeometry geometry = DrawdownGeometry::diffuse_8_included;
    optics::Material binder = optics::Material(1.5);
    /// g of the pigment, which a drawdown hardly determines: (-1, 1). Scattering comes out so that
    /// sigma_s (1 - g) is nearly the same for all.
    double anisotropy = 0;
    /// The ground was measured without a glossy surface of its own (plain paper, a matt card):
    /// its reflectance is taken as it is. Else it has one of the binder's index, through which
    /// what lies below is seen.                                            [saunderson-1942]
    bool matt_ground = false;
    /// Standard deviation of a reading; none: from the residuals.
    std::optional<double> noise = {};
    /// The white of tints, of whatever amount. Mixed pigments add their coefficients, each by its own
    /// volume.                                                                  [duncan-1940]
    std::optional<paint::Pigment> white = {};
};

/// So thick a layer is in the place of an opaque one. What shows of a black ground under rutile is
/// then below 1e-5.
inline constexpr double kOpaqueThickness_um = 1e5;

/// What was found of one application.
struct DrawdownResidual {
    std::string ground;
    double thickness_um = 0, volume_fraction = 0;
    double white_volume_fraction = 0;
    bool opaque = false;
    std::vector<double> measured, modelled;
    /// CIEDE2000 under D65 for the observer of 10 deg; none where 400 to 700 nm are not covered.
    std::optional<double> delta_e_2000;

    /// "20 um", or "opaque".
    std::string thickness_text(const char* unit = "um") const;
    /// " in 15 % white", " over black", both or neither.
    std::string place_text() const;
};

struct PigmentEstimate {
    std::vector<double> wavelengths_nm;
    /// Coefficients for a volume fraction of 1, and their standard errors. An error is empty where
    /// the noise is unknown (as many readings as numbers), infinite where the number is not
    /// determined.
    std::vector<double> scattering_per_mm, absorption_per_mm;
    std::vector<std::optional<double>> scattering_error, absorption_error;
    std::optional<double> noise;  ///< given, or from the residuals of all wavelengths
    double rms_residual = 0;
    std::vector<DrawdownResidual> residuals;  ///< by application
    /// Wavelengths at which scattering is determined to no better than half of itself: the paint
    /// hides its ground, and only the ratio of the coefficients shows.
    std::vector<double> hidden_nm;
    /// Of tints: wavelengths at which scattering is determined to no better than half of itself, as
    /// the white scatters for both. Absorption may be known well there.
    std::vector<double> absorption_only_nm;
    /// All tints have one ratio of pigment to white, which determines one number: scattering was
    /// taken as 0 everywhere, and its errors are infinite.
    bool scattering_assumed = false;

    /// To five digits.
    paint::Pigment pigment(const std::string& name, double anisotropy) const;
};

/// The coefficients whose solved reflectances (solver::solve, every order of scattering, the
/// surface exactly) are nearest to those measured: least squares, each wavelength on its own, the
/// coefficients held at 0 or above. Steps of Levenberg and Marquardt by Ceres Solver from the best
/// point of a grid.                              [levenberg-1944; marquardt-1963; agarwal-2022]
///
/// Of tints in opaque layers only ratios to the white's coefficients show: an error of these goes into
/// what is found as it is.                                          [berns-mohammadi-2007]
///
/// @throws DomainError if there are no bare readings of a ground that is not hidden, readings that
///         cannot tell scattering from absorption (but for tints of one ratio), tints without a
///         white or a white without tints, or a number is out of range; Error, Stopped as
///         solver::solve
PigmentEstimate estimate_pigment(const Drawdown& drawdown, const DrawdownSettings& settings = {},
                                 const Progress& progress = {});

/// The reflectance factor that an instrument reads on a paint whose BRDF does not depend on
/// azimuth, at each wavelength. The gloss that `geometry` includes is that of a smooth surface.
std::vector<double> drawdown_reflectance(const paint::Recipe& recipe,
                                         const std::vector<double>& wavelengths_nm,
                                         DrawdownGeometry geometry, const Progress& progress = {});

/// The reflectance of a ground inside the binder that reads `measured` bare: the inverse of what a
/// Lambertian ground under a smooth surface reads.                        [saunderson-1942]
/// @throws DomainError if it were outside of [0, 1]
std::vector<double> ground_inside(const std::vector<double>& measured,
                                  const std::vector<double>& wavelengths_nm,
                                  const optics::Material& binder, DrawdownGeometry geometry);

}  // namespace nacre::fit
