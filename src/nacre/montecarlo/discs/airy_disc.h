#pragma once

// Diffraction at a flat disc that mirrors light.

namespace nacre::montecarlo {

/// The Airy pattern in x = pi d |q| / lambda', where d is the diameter, q the part parallel to the
/// disc by which the direction differs from that of the mirror, and lambda' the wavelength in the
/// binder: power is spread over q with a density proportional to (2 J_1(x) / x)^2.
///                                                   [born-wolf-1999, section 8.5.2, eq. 14 and 18]
/// The disc is lit uniformly; transmitted light, and light that passes beside it, go straight on.
/// In q the pattern is round at any angle of incidence, and it is reciprocal.
class AiryDisc {
 public:
    /// The x within which this fraction of the power lies. fraction in [0, 1); error in the
    /// fraction below kAiryDiscError min(fraction, 1 - fraction).
    static double radius_of_fraction(double fraction);
};

/// Of radius_of_fraction(), against the encircled power.
inline constexpr double kAiryDiscError = 3e-3;

/// Fraction of the power within x: 1 - J_0(x)^2 - J_1(x)^2.
///                                                          [born-wolf-1999, section 8.5.2, eq. 18]
double encircled_power(double x);

}  // namespace nacre::montecarlo
