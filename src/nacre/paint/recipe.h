#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/optics/material.h"
#include "nacre/optics/particles.h"
#include "nacre/optics/thin_film.h"
#include "nacre/paint/flake_sizes.h"
#include "nacre/paint/limits.h"
#include "nacre/spectra/spectrum.h"

// What a paint is made of: a value, independent of any file format (io/recipe_file.h reads it).
// Units are in the names; paint/recipe_description.h says what each key may be.

namespace nacre::paint {

/// A point of a measured law of tilts, between which it is linear.
struct TiltDensity {
    double tilt_deg = 0;  ///< between the normals of flake and paint
    double density = 0;   ///< area of the flakes per degree of tilt, in any unit

    friend bool operator==(const TiltDensity&, const TiltDensity&) = default;
};
struct TabulatedTilts {
    std::vector<TiltDensity> tilts;  ///< increasing, at least two; none beyond the last

    friend bool operator==(const TabulatedTilts&, const TabulatedTilts&) = default;
};

/// The law of flake normals, the same in all azimuths.
struct Orientation {
    /// Of Gaussian slopes, Beckmann's law: sqrt(2) times the standard deviation of a slope component.
    /// Of another law its own alpha; in what expanded() returns all laws are Beckmann's.
    double beckmann_alpha = 0.1;

    /// GGX: slopes of density 1 / (pi alpha^2) (1 + s^2 / alpha^2)^-2, with long tails.
    enum class Law { beckmann, ggx, tabulated };
    Law law = Law::beckmann;
    /// Alpha at the bottom of the layer, linear in depth from the top; 0: the same at all depths.
    double alpha_bottom = 0;
    std::optional<TabulatedTilts> table = {};  ///< in place of alpha, if law is tabulated

    friend bool operator==(const Orientation&, const Orientation&) = default;
};

/// A flake whose optics are given, not computed: R and T, the same at all angles, R + T <= 1 at
/// every wavelength.
struct PrescribedFlake {
    spectra::Spectrum reflectance;
    spectra::Spectrum transmittance;
    double thickness_um = 0.3;

    friend bool operator==(const PrescribedFlake&, const PrescribedFlake&) = default;
};

struct VolumeFraction {
    double value = 0;  ///< v, in (0, 1]
    friend bool operator==(const VolumeFraction&, const VolumeFraction&) = default;
};
struct AreaDensity {
    double per_um = 0;  ///< c = flake area times number density
    friend bool operator==(const AreaDensity&, const AreaDensity&) = default;
};

struct FlakeSpecies {
    std::string name;
    std::variant<VolumeFraction, AreaDensity> amount;
    double diameter_um = 20;
    double diameter_spread_um = 0;
    std::optional<StatedQuantiles> quantiles = {};  ///< in place of the two above
    /// Width of the rim that scatters light in all directions; 0: flakes reflect up to their edge.
    double edge_um = 0;
    /// Of a flake's surface, as alpha of its slopes about the flake's mean plane; 0: flat.
    double waviness = 0;
    Orientation orientation;
    std::variant<optics::Platelet, PrescribedFlake> body;
    /// The diameters of a part of a species, in place of all above. Only expanded() sets it.
    std::optional<FlakeSizes> part = {};

    /// Mean thickness of the platelet, core and coats, in um.
    double thickness_um() const;
    /// Of a species that expanded() returned, or that it leaves as it is.
    FlakeSizes sizes() const;
    /// Alpha of the slopes of the flakes' surfaces: of their planes and their waviness together.
    double surface_alpha() const;
    /// c = a rho in 1/um; from a volume fraction v and thickness t: v / t.
    double area_density_per_um() const;

    friend bool operator==(const FlakeSpecies&, const FlakeSpecies&) = default;
};

/// How much of a layer is a pigment.
struct PigmentVolume {
    double fraction = 0;
    friend bool operator==(const PigmentVolume&, const PigmentVolume&) = default;
};
/// By mass of the dry layer, the rest of which is taken to be as dense as the binder.
struct PigmentMass {
    double fraction = 0;
    double density_g_per_cm3 = 0;
    double binder_density_g_per_cm3 = 1.1;

    double volume_fraction() const;
    friend bool operator==(const PigmentMass&, const PigmentMass&) = default;
};
using PigmentAmount = std::variant<PigmentVolume, PigmentMass>;

double volume_fraction(const PigmentAmount& amount);

/// Coefficients are those of the layer; how much pigment makes them is not said.
struct PigmentUnstated {
    friend bool operator==(const PigmentUnstated&, const PigmentUnstated&) = default;
};
/// Where an amount is stated, coefficients are those of a volume fraction of 1, and the layer's are
/// in proportion to its own.
using OptionalPigmentAmount = std::variant<PigmentUnstated, PigmentVolume, PigmentMass>;

/// A pigment by its coefficients; it scatters by Henyey-Greenstein.
struct PigmentCoefficients {
    spectra::Spectrum scattering_per_mm = 0.0;
    spectra::Spectrum absorption_per_mm = 0.0;
    double anisotropy = 0;  ///< g, in (-1, 1)
    OptionalPigmentAmount amount = {};

    friend bool operator==(const PigmentCoefficients&, const PigmentCoefficients&) = default;
};

/// The two constants of a two-flux model of diffuse light.           [kubelka-munk-1931]
struct KubelkaMunk {
    spectra::Spectrum absorption_per_mm;  ///< K
    spectra::Spectrum scattering_per_mm;  ///< S

    friend bool operator==(const KubelkaMunk&, const KubelkaMunk&) = default;
};

/// A pigment by the constants of Kubelka and Munk.
struct PigmentKubelkaMunk {
    KubelkaMunk constants;
    double anisotropy = 0;
    OptionalPigmentAmount amount = {};

    /// Those that diffuse light finds alike where it is scattered rather than absorbed:
    /// K = 2 sigma_a, S = 3/4 (1 - g) sigma_s.
    PigmentCoefficients coefficients() const;
    friend bool operator==(const PigmentKubelkaMunk&, const PigmentKubelkaMunk&) = default;
};

/// A pigment by its particles: Mie scattering in the binder.
struct PigmentParticles {
    PigmentAmount amount;
    optics::Spheres spheres;

    friend bool operator==(const PigmentParticles&, const PigmentParticles&) = default;
};

struct Pigment {
    std::variant<PigmentCoefficients, PigmentParticles, PigmentKubelkaMunk> body;
    std::string name = {};

    /// None where it is not stated.
    std::optional<PigmentAmount> amount() const;
    /// Those of the layer that it is in; none for particles, whose coefficients depend on the
    /// binder (optics::particle_optics).
    std::optional<PigmentCoefficients> layer_coefficients() const;

    friend bool operator==(const Pigment&, const Pigment&) = default;
};

struct Layer {
    double thickness_um = 0;
    std::vector<FlakeSpecies> flakes;
    std::vector<Pigment> pigments;

    friend bool operator==(const Layer&, const Layer&) = default;
};

/// Waves of the air interface, far longer than the coat is thick: root mean square slopes along a
/// line, by bands of wavelength (kWaveBands).
struct OrangePeel {
    double wa = 0, wb = 0, wc = 0, wd = 0, we = 0;

    /// Of all bands together, whose waves are independent.
    double slope() const;
    friend bool operator==(const OrangePeel&, const OrangePeel&) = default;
};

/// A band of wavelengths, and where its slope is kept.
struct WaveBand {
    const char* key;
    double OrangePeel::*slope;
    std::array<double, 2> wavelength_mm;
};
inline constexpr std::array<WaveBand, 5> kWaveBands{{{"wa", &OrangePeel::wa, {0.1, 0.3}},
                                                     {"wb", &OrangePeel::wb, {0.3, 1}},
                                                     {"wc", &OrangePeel::wc, {1, 3}},
                                                     {"wd", &OrangePeel::wd, {3, 10}},
                                                     {"we", &OrangePeel::we, {10, 30}}}};

struct Clearcoat {
    double thickness_um = 0;
    spectra::Spectrum absorption_per_mm = 0.0;
    double roughness = 0;  ///< Beckmann alpha of the air interface, 0 = smooth
    std::optional<OrangePeel> orange_peel = {};
    double thickness_spread_um = 0;  ///< standard deviation over the panel

    friend bool operator==(const Clearcoat&, const Clearcoat&) = default;
};

/// The mean of all flakes' normals, where it is not the normal of the paint: flakes lean as spraying from
/// one side, or wet paint that ran, leaves them. Their law is that of others, in the frame of that mean (the
/// shortest turn of the paint's normal into it). The paint is not the same in all azimuths. [docs/flakes.md]
struct FlakeLean {
    double tilt_deg = 0;     ///< of the mean normal
    double azimuth_deg = 0;  ///< of the side towards which the flakes' upper faces look

    /// Tangents m_x/m_z and m_y/m_z of the mean normal m.
    std::array<double, 2> tangents() const;
    friend bool operator==(const FlakeLean&, const FlakeLean&) = default;
};

/// The facets of the model of Guo et al.: the table [microfacet.facets] of docs/recipe.md.
struct MicrofacetFacets {
    double count = 0;                ///< K, over the whole object
    double cone_deg = 3;             ///< gamma, half-angle of the query cone
    double thickness_spread_nm = 0;  ///< standard deviation of the film's thickness

    friend bool operator==(const MicrofacetFacets&, const MicrofacetFacets&) = default;
};
/// The law of facet normals: Beckmann's (Gaussian slopes) or GGX (Trowbridge and Reitz), with long
/// tails.                                                          [walter-2007, eq. 25 and 33]
enum class FacetDistribution { beckmann, ggx };
/// What the models of Belcour & Barla and of Guo et al. take in place of layers: a film of index
/// eta_2 on a base of index eta_3 + i kappa_3.
struct Microfacet {
    double alpha = 0.1;
    FacetDistribution distribution = FacetDistribution::beckmann;
    double film_ior = 1;
    double film_thickness_nm = 0;
    double base_ior = 1;
    double base_extinction = 0;
    std::optional<MicrofacetFacets> facets = {};

    friend bool operator==(const Microfacet&, const Microfacet&) = default;
};

/// A paint: air | clearcoat | layers from the top down | Lambertian substrate. All layers share
/// the binder's refractive index.
struct Recipe {
    std::string name;
    optics::Material binder = optics::Material(1.5);  ///< real index in [1, 3]
    std::optional<Clearcoat> clearcoat;
    std::vector<Layer> layers;
    spectra::Spectrum substrate_reflectance;
    std::optional<Microfacet> microfacet;
    std::optional<FlakeLean> lean = {};

    double thickness_um() const;  ///< of clearcoat and layers
    /// Of the coat, if it is not flat.
    std::optional<OrangePeel> orange_peel() const;
    /// Of the flakes, if there are any and their mean is tilted.
    std::optional<FlakeLean> flake_lean() const;
    /// Of the coat's thickness over the panel, over its mean; 0 also where the coat absorbs nothing, as
    /// nothing is seen of it.
    double coat_spread() const;

    friend bool operator==(const Recipe&, const Recipe&) = default;
};

/// Checks every range, R + T <= 1, and that the data of each material cover `wavelengths_nm`.
/// @throws DomainError naming the key as a recipe file spells it, its value and the allowed range
void validate(const Recipe& recipe, const std::vector<double>& wavelengths_nm);

/// @param what  is the same in all azimuths and takes no paint whose flakes lean: "tables are"
/// @throws DomainError naming the key, its value and what is allowed, if they lean
void require_no_lean(const Recipe& recipe, std::string_view what);

}  // namespace nacre::paint

namespace nacre::paint::limits {

/// R + T may exceed 1 by this much, for rounding.
inline constexpr double kEnergySlack = 1e-9;

/// The first wavelength (nm) at which R + T > 1, if there is one. Both spectra are linear between
/// their samples, so it is enough to look there.
std::optional<double> wavelength_of_excess(const PrescribedFlake& flake);

}  // namespace nacre::paint::limits
