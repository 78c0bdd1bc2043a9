#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

// Standard errors, correlations and undetermined directions of a least-squares estimate, from its
// Jacobian.

namespace nacre::fit {

struct CertaintyOptions {
    /// Standard deviation of the noise in each of the three components of the colour of a reading
    /// of mean weight, in Delta E 2000. Empty: from the residual itself.
    std::optional<double> noise_delta_e;
    /// Readings whose components are independent: residuals under several illuminants come from one
    /// spectrum and are not independent.
    std::size_t independent_values = 0;
    std::size_t geometries = 1;
    /// Paints this close (root mean square of Delta E 2000) count as equal.
    double equal_delta_e = 0.3;
};

/// A direction in the unit cube along which the colour hardly changes.
struct WeakDirection {
    /// In the unit cube: changes the colour by equal_delta_e (root mean square, to first order), or
    /// by less if it is of length 1, its maximum.
    std::vector<double> step;
};

struct Certainty {
    /// Standard deviation of the noise, in Delta E 2000 per component. Empty: none was given, and
    /// there are not more values than numbers to estimate it from the residual.
    std::optional<double> noise_delta_e;
    int degrees_of_freedom = 0;  ///< values less numbers
    /// Standard error of each coordinate. Empty where the noise is unknown, or where the error
    /// would be above the standard deviation of the uniform law between the bounds, 1/sqrt(12) of
    /// their distance: the colours do not determine that number.
    std::vector<std::optional<double>> standard_error;
    /// Correlations between the errors, row by row. Zero beside a coordinate without any effect.
    std::vector<double> correlation;
    /// Those along which a step of kWeak of the cube's width or more stays within equal_delta_e,
    /// the weakest first.
    std::vector<WeakDirection> weak;

    static constexpr double kWeak = 0.1;
};

/// For residuals r(x) with independent, equal normal errors of standard deviation s the estimate of
/// x has the covariance s^2 (J^T J)^-1, J being the derivative of r, as far as r is linear over the
/// error; s^2 is estimated by r^T r over the degrees of freedom.
/// [seber-wild-1989, section 2.1.2]
///
/// @param residuals  as Target::residuals()
/// @param jacobian   their derivatives in the unit cube, row by row
/// @throws DomainError if the sizes do not fit
Certainty certainty(std::span<const double> residuals, std::span<const double> jacobian,
                    std::size_t numbers, const CertaintyOptions& options);

}  // namespace nacre::fit
