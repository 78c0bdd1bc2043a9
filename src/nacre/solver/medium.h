#pragma once

#include <optional>
#include <span>
#include <vector>

#include "nacre/optics/phase_function.h"
#include "nacre/paint/beckmann.h"
#include "nacre/paint/flake_table.h"
#include "nacre/paint/normal_weights.h"
#include "nacre/paint/recipe.h"
#include "nacre/solver/film_cache.h"

// The optics of a recipe at a set of wavelengths, for the solver and for single scattering: spectra
// evaluated and films computed. Lengths in um.

namespace nacre::solver {

struct FlakeMedium {
    double area_density_per_um = 0;  ///< c = a rho
    double alpha = 0.1;
    paint::FlakeTable table;

    /// For averages over the flakes' normals, seen under the cosine mu.
    paint::NormalWeights normals(double mu) const {
        return {mu, alpha, paint::normal_nodes(alpha, table.cosine_count())};
    }

    friend bool operator==(const FlakeMedium&, const FlakeMedium&) = default;
};

struct PigmentMedium {
    std::vector<double> scattering_per_um, absorption_per_um;  ///< by wavelength
    double anisotropy = 0;
    /// By wavelength; without it Henyey and Greenstein's, of the anisotropy above.
    std::optional<optics::PhaseFunction> phase = {};

    /// p in 1/sr for light that is turned by the angle of this cosine.
    ///                                                          [henyey-greenstein-1941, eq. 2]
    DoubleLanes phase_value(double cosine, int block) const;

    /// The anisotropy of the Henyey-Greenstein lobe that is as sharp, in [0, 1).
    double sharpness() const;

    friend bool operator==(const PigmentMedium&, const PigmentMedium&) = default;
};

struct LayerMedium {
    double thickness_um = 0;
    std::vector<FlakeMedium> flakes;
    std::vector<PigmentMedium> pigments;

    friend bool operator==(const LayerMedium&, const LayerMedium&) = default;
};

struct PaintMedium {
    std::vector<double> wavelengths_nm;
    std::vector<double> ior;              ///< real index of the binder, by wavelength
    std::vector<double> clearcoat_depth;  ///< absorption times thickness along the normal
    double roughness = 0;                 ///< Beckmann alpha of the air interface
    std::vector<LayerMedium> layers;
    std::vector<double> substrate_reflectance;

    int wavelength_count() const { return static_cast<int>(wavelengths_nm.size()); }
    friend bool operator==(const PaintMedium&, const PaintMedium&) = default;
};

/// The sharpest pigment that is solved: beyond, the number of Legendre degrees makes it take minutes.
inline constexpr double kSharpestPigment = 0.97;

/// @param films  cache of the flakes' tables; null: none
/// @throws DomainError as validate() and optics::platelet_table() do, and if a pigment is sharper than
///         kSharpestPigment, naming its key
/// @throws Stopped if `work`, which may be null, asks to stop
PaintMedium make_medium(const paint::Recipe& recipe, const std::vector<double>& wavelengths_nm,
                        FilmCache* films = nullptr, SharedProgress* work = nullptr);

/// Extinction sigma_t(mu), in 1/um, of the eight wavelengths of `block`.
DoubleLanes extinction(const LayerMedium& layer, double mu, int block);

/// The same of `count` blocks from `first` on, for all of which the flakes' normals are gone through
/// once.
std::vector<DoubleLanes> extinctions(const LayerMedium& layer, double mu, int first, int count);

/// What a layer takes from light, in 1/um, by block.
struct Losses {
    std::vector<DoubleLanes> extinction;  ///< sigma_t
    std::vector<DoubleLanes> absorption;  ///< sigma_t - sigma_s
};

/// Of `count` blocks from `first` on, for all of which the flakes' normals are gone through once.
Losses losses(const LayerMedium& layer, double mu, int first, int count);

/// sigma_s p(w -> w') in 1/(um sr): light that travels down (towards -z) under the cosine mu_i is
/// turned upwards under mu_o; both cosines > 0, phi = phi_o - phi_i between the directions that
/// point away from the surface (pi is the mirror side).
/// @param added_alpha2  added to alpha^2 of every flake's slope law: it widens the lobe of half
///                      vectors as a rough clearcoat does (sparkle::CoatTilt); 0 under a smooth one
DoubleLanes backscattering(const LayerMedium& layer, double mu_i, double mu_o, double phi,
                           int block, double added_alpha2 = 0);

/// Values of a per-wavelength list as the eight lanes of `block`, the last one repeated.
DoubleLanes block_lanes(std::span<const double> values, int block);

}  // namespace nacre::solver
