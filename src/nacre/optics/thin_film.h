#pragma once

#include <span>
#include <vector>

#include "nacre/core/lanes.h"
#include "nacre/optics/material.h"

// Reflectance and transmittance of stacks of flat, coherent films.

namespace nacre::optics {

struct ThinFilm {
    ComplexIndex index;
    double thickness_nm = 0;
};

struct ReflectanceTransmittance {
    double reflectance = 0, transmittance = 0;
};

enum class Polarization { s, p, unpolarized };

/// R and T of a stack between two half spaces, by transfer (characteristic) matrices.
/// ambient must be real; the substrate may absorb; T is the power that enters the substrate.
ReflectanceTransmittance stack_reflectance(ComplexIndex ambient, std::span<const ThinFilm> films,
                                           ComplexIndex substrate, double cos_incident,
                                           double wavelength_nm, Polarization polarization);

/// The law of a film's thickness over a population of flakes.
struct ThicknessSpread {
    enum class Law { normal, uniform };
    double standard_deviation_nm = 0;  ///< 0: all flakes alike
    Law law = Law::normal;             ///< normal: cut at three deviations and at zero

    friend bool operator==(const ThicknessSpread&, const ThicknessSpread&) = default;
};

struct FilmPopulation {
    Material material;
    double thickness_nm = 0;
    ThicknessSpread spread;

    friend bool operator==(const FilmPopulation&, const FilmPopulation&) = default;
};

/// A platelet of core and coats: coats from the core outwards, alike on both sides; each film
/// varies on its own, both sides of a coat together.
struct Platelet {
    FilmPopulation core;
    std::vector<FilmPopulation> coats;

    friend bool operator==(const Platelet&, const Platelet&) = default;
};

/// Unpolarised R and T of a platelet embedded in `binder` on both sides, averaged over the spread
/// of each film, for every pair (cosine, wavelength): arrays [cosine][wavelength], row-major.
struct PlateletTable {
    std::vector<double> reflectance, transmittance;
};
PlateletTable platelet_table(const Platelet& platelet, const Material& binder,
                             std::span<const double> cosines,
                             std::span<const double> wavelengths_nm);

}  // namespace nacre::optics
