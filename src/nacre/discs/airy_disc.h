#pragma once

#include <array>

// Diffraction at a flat disc that mirrors light.

namespace nacre::discs {

/// The Airy pattern in x = pi d |q| / lambda', where d is the diameter, q the part parallel to the
/// disc by which the direction differs from that of the mirror, and lambda' the wavelength in the
/// binder: power is spread over q with a density proportional to (2 J_1(x) / x)^2.
///                                                   [born-wolf-1999, section 8.5.2, eq. 14 and 18]
/// The disc is lit evenly; light that it lets pass, and light that passes beside it, go straight
/// on. In q the pattern is round at any angle of incidence, and it is reciprocal.
class AiryDisc {
 public:
    /// The x within which a share of the power lies. share in [0, 1); error below kAiryDiscError of
    /// the lesser of the share and the rest.
    static double radius_of_share(double share);
};

/// Of radius_of_share(), against the encircled power.
inline constexpr double kAiryDiscError = 3e-3;

/// Share of the power within x: 1 - J_0(x)^2 - J_1(x)^2.        [born-wolf-1999, section 8.5.2, eq.
/// 18]
double encircled_power(double x);

}  // namespace nacre::discs
