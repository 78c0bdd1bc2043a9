#pragma once

#include <array>
#include <string>

#include "nacre/core/vec.h"

// CIE standard colorimetric observers and illuminants, tabulated at 5 nm in
// data/cie_observers.csv and data/cie_illuminants.csv.                        [cie-15-2018]

namespace nacre::spectra {

enum class Observer { cie1931_2deg, cie1964_10deg };
enum class Illuminant { A, D50, D65, FL2, FL11, E };

/// The colour-matching functions (x, y, z) at a wavelength: linear between 5 nm samples, zero
/// outside 360-830 nm. @throws DomainError if the wavelength is not finite
Vec3d colour_matching(Observer observer, double wavelength_nm);

/// Relative spectral power. 100 at 560 nm for A, D50 and D65, as the CIE normalises them, and 100
/// everywhere for E, which has equal energy; FL2 and FL11 as published. Linear between 5 nm
/// samples. Zero outside the data: 360-780 nm, and 380-780 nm for FL2 and FL11, which the CIE
/// tabulates from there. @throws DomainError if the wavelength is not finite
double illuminant_power(Illuminant illuminant, double wavelength_nm);

/// "2", "10", with or without the unit as files write it: "10 degree", "10deg", "10°", "10_Degree",
/// "10 Grad". @throws InputError
Observer parse_observer(const std::string& text);
Illuminant parse_illuminant(const std::string& text);  ///< "D65" ... @throws InputError

/// As parse_illuminant() and parse_observer() take them: "D65", "10".
std::string name(Illuminant illuminant);
std::string name(Observer observer);

// The tables of data/cie_*.csv as they were when this was compiled. Internal to this folder.

/// Step of the wavelengths of both tables.
inline constexpr double kCieStep_nm = 5;

struct ObserverRow {
    double wavelength_nm;
    double xyz[6];  // 2 degrees, then 10 degrees
};
inline constexpr int kObserverRows = 95;
extern const std::array<ObserverRow, kObserverRows> kObserverTable;

struct IlluminantRow {
    double wavelength_nm;
    double power[5];  // A, D50, D65, FL2, FL11; 0 where the CIE gives none
};
inline constexpr int kIlluminantRows = 85;
extern const std::array<IlluminantRow, kIlluminantRows> kIlluminantTable;

}  // namespace nacre::spectra
