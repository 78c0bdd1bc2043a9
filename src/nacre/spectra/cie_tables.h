#pragma once

#include <array>

// The tables of data/cie_*.csv as they were when this was compiled. Internal to this folder.

namespace nacre::spectra {

/// Columns tabulated at first_nm, first_nm + kCieStep_nm, ...
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
