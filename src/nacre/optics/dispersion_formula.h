#pragma once

#include <span>

namespace nacre::optics {

inline constexpr int kDispersionFormulas = 9;
/// The longest formula (number 4) takes this many coefficients; shorter lists end in zeros.
inline constexpr int kMaxDispersionCoefficients = 17;

/// Refractive index by one of the dispersion formulas of refractiveindex.info [polyanskiy-2024,
/// "Dispersion formulas"]: 1 Sellmeier, 2 Sellmeier-2, 3 polynomial, 4 RefractiveIndex.INFO,
/// 5 Cauchy, 6 gases, 7 Herzberger, 8 retro, 9 exotic.
///
/// @param number         1 to 9
/// @param coefficients   C1, C2, ... as the database lists them; missing ones are 0
/// @param wavelength_um  in vacuum, > 0
/// @return  n; NaN or infinite where the formula has no real value (a pole, n^2 < 0)
double dispersion_formula(int number, std::span<const double> coefficients, double wavelength_um);

}  // namespace nacre::optics
