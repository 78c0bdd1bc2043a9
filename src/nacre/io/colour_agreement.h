#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "nacre/io/measurement_file.h"

// Whether what a row of measured colours says more than once is the same each time. Internal to this
// folder.

namespace nacre::io {

/// By which two statements of one colour may differ, Delta E 2000, besides what their digits round:
/// colours and spectra by other tables of weights and other wavelength steps; colours alone by other
/// digits of the white point.
inline constexpr double kSpectrumTolerance = 1, kColourTolerance = 0.5;

/// Collects where the rows of a file contradict themselves.
class ColourAgreement {
 public:
    /// @param row         its reflectances are factors
    /// @param wavelengths_nm  those of its spectrum
    void check(const MeasurementRow& row, const std::vector<double>& wavelengths_nm,
               const measure::Conditions& conditions);

    /// A line for each two statements that contradict each other: the row where they do so most, which
    /// columns, by how much, which of them counts, and in how many rows more.
    std::vector<std::string> contradictions() const;

 private:
    struct Contradiction {
        double delta_e = 0;
        std::string text;
        std::size_t rows = 0;
    };
    void add(const std::string& kind, double delta_e, std::string text);

    std::map<std::string, Contradiction> worst_;  ///< by the columns
};

}  // namespace nacre::io
