#pragma once

#include <vector>

#include "nacre/reference/medium.h"

// The same recipe at ever new wavelengths, as a renderer asks for it: films are computed once.

namespace nacre::reference {

/// Media of one recipe on a grid of wavelengths, between which everything in them is linear.
class MediumGrid {
 public:
    /// @param wavelengths_nm  strictly increasing, at least one
    /// @throws DomainError as layers::validate() does, or if the wavelengths do not increase
    MediumGrid(const layers::Recipe& recipe, std::vector<double> wavelengths_nm);

    /// The medium at up to kLanes wavelengths; beyond the ends of the grid it is that of the end.
    /// Medium::index is that of the first; see index().
    Medium at(std::span<const double> wavelengths_nm) const;

    /// Index of the binder, likewise interpolated.
    double index(double wavelength_nm) const;

 private:
    struct Place;
    Place locate(double wavelength_nm) const;

    std::vector<double> wavelengths_nm_, index_;
    std::vector<Medium> media_;  // for kLanes wavelengths each, the last one perhaps for fewer
};

}  // namespace nacre::reference
