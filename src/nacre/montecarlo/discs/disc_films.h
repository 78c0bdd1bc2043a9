#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "nacre/bsdf/wavelength_lanes.h"
#include "nacre/core/lanes.h"
#include "nacre/core/progress.h"
#include "nacre/optics/material.h"
#include "nacre/paint/recipe.h"

// R and T of single flakes, each of its own film thicknesses.

namespace nacre::montecarlo {

/// Where eight wavelengths lie between those of the tables: bsdf::locate_wavelengths().
using WavelengthPlaces = std::array<bsdf::WavelengthPosition, kLanes>;

/// A set of flakes of one species. Their films are drawn from the recipe's laws, evenly: each film
/// thickness takes one value from each of so many equally probable intervals, and thicknesses are
/// combined at random.                                                    [mckay-1979, section 2.3]
class DiscFilms {
 public:
    /// @param wavelengths_nm  within the data of all materials, increasing
    /// @throws DomainError, Stopped as optics::platelet_table()
    DiscFilms(const paint::FlakeSpecies& species, const optics::Material& binder,
              const std::vector<double>& wavelengths_nm, std::uint64_t seed,
              SharedProgress* work = nullptr);

    /// How many different flakes there are: one where no film varies.
    int count() const { return count_; }

    struct Optics {
        DoubleLanes reflectance, transmittance;
    };
    /// Linear in cosine and wavelength between the nodes of the tables.
    /// @param film    in [0, count())
    /// @param cosine  of incidence on the flake, in [0, 1]; rounding above 1 is taken as 1
    Optics at(int film, double cosine, const WavelengthPlaces& places) const;

    static constexpr int kFilms = 256;
    static constexpr int kCosineIntervals = 256;

 private:
    void fill(const paint::FlakeSpecies& species, const optics::Material& binder,
              const std::vector<double>& wavelengths_nm, std::uint64_t seed, SharedProgress* work);

    int count_ = 1, intervals_ = 0;
    std::size_t stride_ = 0;
    std::vector<float> reflectance_, transmittance_;  // [film][cosine][wavelength]
};

}  // namespace nacre::montecarlo
