#pragma once

#include <span>
#include <vector>

#include "nacre/core/lanes.h"
#include "nacre/optics/material.h"

// Reflectance and transmittance of stacks of flat, coherent films.

namespace nacre {
class SharedProgress;
}

namespace nacre::optics {

inline constexpr Range kFilmThicknessRange{.lo = 0, .hi = 1e9, .unit = "nm"};
inline constexpr Range kThinFilmWavelengthRange{.lo = 1, .hi = 1e9, .unit = "nm"};

inline constexpr Range kFlakeFilmThicknessRange{.lo = 0, .hi = 1e6, .unit = "nm"};

/// Error of R and T of a stack against 50-digit arithmetic, for up to 20 films of optical
/// thickness up to 10 wavelengths each.
inline constexpr double kStackError = 1e-12;

struct ThinFilm {
    ComplexIndex index;
    double thickness_nm = 0;
};

struct ReflectanceTransmittance {
    double reflectance = 0, transmittance = 0;
};

enum class Polarization { s, p, unpolarized };

/// R and T of a stack between two half spaces, by characteristic matrices, scaled so that thick
/// absorbing films and total reflection need no special care.     [born-wolf-1999, 1.6 eq. 33-55]
///
/// @param ambient        index above the stack, real
/// @param films          from the ambient to the substrate; they may absorb
/// @param substrate      index below; it may absorb
/// @param cos_incident   cosine of the incidence angle in the ambient, in [0, 1]; 0 is the limit
/// @param wavelength_nm  in vacuum, in kThinFilmWavelengthRange
/// @return  R, and T as the power that enters the substrate; 1 - R - T is absorbed in the films
/// @throws DomainError naming the argument, its value and its range
ReflectanceTransmittance stack_reflectance(ComplexIndex ambient, std::span<const ThinFilm> films,
                                           ComplexIndex substrate, double cos_incident,
                                           double wavelength_nm, Polarization polarization);

/// Of the angle whose cosine it takes.
inline constexpr Range kIncidenceRange{0, 90, "deg"};

/// The law of a film's thickness over a population of flakes.
struct ThicknessSpread {
    enum class Law { normal, uniform };
    double standard_deviation_nm = 0;  ///< 0: all flakes equal
    Law law = Law::normal;             ///< normal: cut at three deviations and at zero

    friend bool operator==(const ThicknessSpread&, const ThicknessSpread&) = default;
};

struct FilmPopulation {
    Material material;
    double thickness_nm = 0;
    ThicknessSpread spread;

    friend bool operator==(const FilmPopulation&, const FilmPopulation&) = default;
};

/// A platelet of core and coats: coats from the core outwards; each film varies on its own.
struct Platelet {
    FilmPopulation core;
    std::vector<FilmPopulation> coats;
    enum class CoatedSides {
        both,  ///< alike, and varying together
        one
    };
    CoatedSides coated_sides = CoatedSides::both;
    /// The side that light meets, which matters where one side is coated.
    enum class Face { any, coated, bare };
    Face face = Face::any;

    friend bool operator==(const Platelet&, const Platelet&) = default;
};

/// Error of the averages over thickness spreads, against dense sums of stack_reflectance, for
/// platelets with at most two coats that vary; with more it may reach 1e-4 near grazing incidence.
inline constexpr double kPlateletError = 1e-6;

/// Unpolarised R and T of a platelet embedded in `binder` on both sides, for light that meets its
/// `face`, averaged over the spread of each film, for every pair (cosine, wavelength): arrays [cosine][wavelength], row-major.
struct PlateletTable {
    std::vector<double> reflectance, transmittance;
};

/// @param binder          transparent medium on both sides; the cosines are measured in it
/// @param cosines         |cosine| of the angle between light and flake normal, in [0, 1]
/// @param wavelengths_nm  in vacuum, within the data of all materials
/// @throws DomainError naming the argument, its value and its range; if the binder absorbs; if so
///         many films vary that the average would take more than some seconds
/// @throws Stopped if `work`, which may be null, asks to stop
///
/// Both sides of a coat vary together, or one has none, so the core between them is averaged with
/// one complex sum per coat thickness. Wavelengths are vector lanes
/// and cosines run in parallel. Films are coherent: flakes thicker than the coherence length of the
/// light within one wavelength sample need the spread, or finer wavelengths, to lose their fringes.
PlateletTable platelet_table(const Platelet& platelet, const Material& binder,
                             std::span<const double> cosines,
                             std::span<const double> wavelengths_nm,
                             SharedProgress* work = nullptr);

/// R of single platelets of these materials and sides, each with films of its own thickness: arrays
/// [platelet][cosine][wavelength]. The bits are those of platelet_table() for each of them; interfaces,
/// which all share, are computed once.
/// @param platelet        of its films the materials count
/// @param thicknesses_nm  [platelet][film], core first
/// @param binder, cosines, wavelengths_nm, work  as of platelet_table()
/// @throws DomainError, Stopped  as platelet_table(); if a platelet has another number of films
std::vector<double> platelet_reflectances(const Platelet& platelet,
                                          std::span<const std::vector<double>> thicknesses_nm,
                                          const Material& binder, std::span<const double> cosines,
                                          std::span<const double> wavelengths_nm,
                                          SharedProgress* work = nullptr);

}  // namespace nacre::optics
