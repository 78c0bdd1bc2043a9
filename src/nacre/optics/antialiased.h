#pragma once

#include <array>
#include <complex>
#include <limits>
#include <span>

#include "nacre/optics/airy.h"
#include "nacre/spectra/observer.h"

// The colour of a thin film in closed form: its reflectance is a sum of cosines in the wave number,
// so its integral against the observer's sensitivities is a sum of values of their Fourier
// transform. Colours are linear Rec. 709 under D65 for the 2 degree observer, relative to the white
// of that light: a perfect mirror is (1, 1, 1). Nothing is clamped: interference colours may lie
// outside the gamut and have negative components.

namespace nacre::optics {

enum class ObserverTransform {
    table,  ///< of the observer times D65 itself, tabulated
    paper,  ///< Belcour & Barla's fit by four Gaussians in wave number, for equal energy
};

/// S(OPD) = Int s_c(lambda) e^(2 pi i OPD / lambda) d lambda for the sensitivities s_c of the three
/// channels of linear Rec. 709, normalised so that S(0) = 1.
///
/// `paper` is the fit of the supplement of [belcour-barla-2017] to the 1931 observer under equal
/// energy; here X, Y and Z are scaled so that its white becomes that of D65. `table` interpolates
/// the transform of the sums at 1 nm over 360-780 nm, to kTransformError; beyond a path of
/// kTransformReach_nm it is 0. There it has fallen below kTransformTail, and comes from the 5 nm
/// between the samples of the CIE's tables more than from the observer.
/// @param optical_path_nm  OPD >= 0
std::array<std::complex<double>, 3> observer_transform(ObserverTransform transform,
                                                       double optical_path_nm);

inline constexpr double kTransformReach_nm = 60e3;
inline constexpr double kTransformError = 1e-5;
inline constexpr double kTransformTail = 1.5e-3;

/// All orders of interference that matter.
inline constexpr int kEveryOrder = std::numeric_limits<int>::max();

struct Antialiasing {
    ObserverTransform transform = ObserverTransform::table;
    /// Orders of interference in the sum. The supplement of the paper stops at three; then a film
    /// does not vanish with its thickness, which it mends by fading the film's index. With every
    /// order the sum itself becomes the bare base.
    int orders = kEveryOrder;
};

/// Colour of the film's unpolarised reflectance by spectral antialiasing:
///   c0 + 2 sum_m strength ratio^m Re[e^(i m phase) S(m OPD)], s and p averaged.
///   [belcour-barla-2017]
/// Where the film's wave is evanescent, which has no such sum: by sums over wavelengths at 5 nm.
/// @param cosine  of incidence, outside, in [0, 1]
/// @param thickness_nm  d >= 0
Vec3d antialiased_rgb(const AiryFilm& film, double cosine, double thickness_nm,
                      const Antialiasing& how = {});

/// The same by sums over 360-780 nm in steps of 1, 5 or 10 nm.
/// @throws DomainError for another step
Vec3d integrated_rgb(const AiryFilm& film, double cosine, double thickness_nm, int step_nm = 1);

/// Errors of colours by spectral antialiasing against integration at 1 nm: CIEDE2000 differences
/// relative to D65, and the largest difference of a component of linear Rec. 709.
struct AntialiasingError {
    double mean_delta_e = 0, max_delta_e = 0;
    double mean_rgb = 0, max_rgb = 0;
};

/// One film, thickness and angle.
struct AntialiasingComparison {
    Vec3d rgb, integrated_rgb;
    double delta_e, rgb_error;
};
AntialiasingComparison compare_antialiasing(const AiryFilm& film, double cosine,
                                            double thickness_nm, const Antialiasing& how);

/// Over all pairs of thickness and cosine.
/// @throws DomainError if there are none
AntialiasingError antialiasing_error(const AiryFilm& film, std::span<const double> cosines,
                                     std::span<const double> thicknesses_nm,
                                     const Antialiasing& how);

}  // namespace nacre::optics
