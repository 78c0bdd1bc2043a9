#pragma once

#include <span>
#include <vector>

#include "nacre/optics/material.h"
#include "nacre/optics/phase_function.h"

// Pigments as what they are: particles of a substance in a binder.

namespace nacre::optics {

/// What the median of a distribution of diameters counts: half of the particles are smaller, or
/// half of the volume is in smaller ones. The same powder has
/// ln(median by volume) = ln(median by number) + 3 spread^2.       [hatch-choate-1929]
enum class DiameterWeighting { number, volume };

/// Whether particles scatter as if they were alone, or as hard spheres that cannot overlap.
enum class Crowding { hard_spheres, independent };

/// Spheres with log-normal diameters.
struct Spheres {
    Material material;
    double diameter_nm = 250;  ///< median
    double spread = 0;         ///< standard deviation of the logarithm; 0 is one size
    DiameterWeighting weighting = DiameterWeighting::number;
    Crowding crowding = Crowding::hard_spheres;

    friend bool operator==(const Spheres&, const Spheres&) = default;
};

inline constexpr Range kDiameterRange{.lo = 1, .hi = 1e4, .unit = "nm"};
inline constexpr Range kDiameterSpreadRange{.lo = 0, .hi = 1};
/// Beyond, particles touch and air comes in, which no formula here knows of.
inline constexpr Range kParticleVolumeRange{.lo = 0, .hi = 0.5, .lo_open = true};

/// The law of the volume over the logarithm of the diameter is cut at so many deviations, and
/// renormalised.
inline constexpr double kSpreadCut = 5;

/// Optics of a volume fraction of particles in a binder.
struct ParticleOptics {
    std::vector<double> scattering_per_um, absorption_per_um;  ///< by wavelength
    PhaseFunction phase;
};

/// By Mie's series, with the particles' index over the binder's, averaged over the diameters:
///
///     sigma_s p(theta) = sum_i N_i |S(theta, d_i)|^2/k^2 S(q d_i),   sigma_a = sum_i N_i C_abs(d_i)
///
/// with N_i particles of diameter d_i per volume. Crowding gives each size neighbours of its own
/// size, at the volume fraction of all (the local monodisperse approximation, [pedersen-1994]).
///
/// What is neglected: other shapes than spheres and their birefringence (a material has one index);
/// aggregates, apart from their being entered as larger spheres; that near neighbours change the
/// field in which a particle stands (rutile scatters less than this for it, by up to 20 % for pairs
/// that touch [thiele-french-1998]); other pigments, and flakes, as neighbours.
///
/// Relative error of the sums over sizes: kParticleError for clear pigments of up to twice the binder's
/// index, a median by volume of up to 0.5 um and a spread of up to 0.5. Larger clear spheres resonate
/// more sharply than the sums resolve.
///
/// @param volume_fraction  of all particles in the layer, in kParticleVolumeRange
/// @throws DomainError naming the argument, its value and its range, or the wavelength that data of
/// the materials do not reach; also if the binder absorbs, or a particle is too large for the series
ParticleOptics particle_optics(const Spheres& spheres, double volume_fraction,
                               const Material& binder, std::span<const double> wavelengths_nm);
inline constexpr double kParticleError = 3e-4;

/// S(q) of equal hard spheres by the closure of Percus and Yevick: how much more light than from
/// independent spheres is turned by the angle theta, q = 2 k sin(theta/2), since the places of
/// neighbours are not independent. It is below 1 forwards, 1 for thin suspensions, and goes to 1 as
/// q d grows.              [percus-yevick-1958; wertheim-1963; kinning-thomas-1984, eq. 8 to 10]
///
/// S(0) = (1 - v)^4/(1 + 2 v)^2. Against simulated hard spheres its peak is some per cent too high near
/// v = 0.5, and less below [verlet-weis-1972].
///
/// @param q_diameter       q times the diameter, >= 0
/// @param volume_fraction  v, in [0, 0.5]
/// @throws DomainError naming the argument, its value and its range
double percus_yevick(double q_diameter, double volume_fraction);

}  // namespace nacre::optics
