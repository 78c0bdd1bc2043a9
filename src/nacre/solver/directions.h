#pragma once

#include <cstddef>
#include <vector>

// The quadrature of directions inside the coat, and the tail of the azimuthal Fourier series.

namespace nacre::solver {

/// Nodes from the normal outwards. The first exit_count of them refract into air; the rest are
/// totally reflected by a smooth interface.
///
/// The critical angle splits the hemisphere into two panels, since Fresnel reflection has a kink
/// there. On the exit panel the Gauss-Legendre variable is the angle *outside*, theta_e, in which
/// Fresnel's reflectance is smooth up to grazing exit; on the other it is the angle inside. Both
/// are angles, not cosines: order l of a smooth function goes like sin^l theta near the normal,
/// which is a polynomial in neither but analytic in the angle.
struct Directions {
    double ior = 1;
    int exit_count = 0;
    std::vector<double> exit_angle;  ///< theta_e of the exit nodes, rad
    std::vector<double> mu;          ///< cosine inside the coat
    std::vector<double> weight;      ///< d mu

    int size() const { return static_cast<int>(mu.size()); }
    friend bool operator==(const Directions&, const Directions&) = default;
};

/// @param ior          real index of the binder, >= 1; at 1 there is one panel
/// @param exit_count   multiple of 4
/// @param inner_count  nodes beyond the critical angle at ior = 1.5, scaled to the panel's width
///                     and rounded up to a multiple of 4; 0 at ior = 1
Directions make_directions(double ior, int exit_count, int inner_count);

/// Number of pairs i >= j of so many nodes, and so where row `rows` of such pairs begins.
constexpr std::size_t triangle(std::size_t rows) { return rows * (rows + 1) / 2; }

/// Cosine inside the coat of the direction that leaves under theta_e.
double inside_cosine(double ior, double theta_e);

/// Barycentric weights b with f(theta_e) = sum b_i f(node_i) for the exit panel's polynomial
/// interpolant.                                             [berrut-trefethen-2004, eq. 4.2]
class ExitInterpolation {
 public:
    explicit ExitInterpolation(const std::vector<double>& exit_angle);
    /// `weights` holds as many values as there are exit nodes.
    void weights_at(double theta_e, double* weights) const;

 private:
    std::vector<double> node_, barycentric_;
};

}  // namespace nacre::solver
