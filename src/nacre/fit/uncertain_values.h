#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "nacre/measure/measurement.h"

// The numbers of a measurement in a row, and how the numbers of a recipe move them.

namespace nacre::fit {

using Values = std::vector<double>;

/// All that is reported of a measurement in a row: L*, a*, b* of each reading, its spectrum, and
/// then the metrics, which are NaN where there are none.
struct ValueLayout {
    std::size_t readings = 0, wavelengths = 0;

    std::size_t lab(std::size_t reading) const { return reading * (3 + wavelengths); }
    std::size_t spectrum(std::size_t reading) const { return lab(reading) + 3; }
    std::size_t flop() const { return lab(readings); }
    std::size_t travel() const { return flop() + 1; }
    std::size_t size() const { return travel() + 1; }
};

Values values_of(const measure::Measurement& measurement);

/// Values one standard deviation to either side in a direction, or in two at once; none where there
/// is no paint.
struct BothSides {
    std::optional<Values> up, down;
};

/// Several values and how the numbers move them. Directions are the independent numbers z of which
/// the numbers are made, in standard deviations, x = L z: the numbers themselves where L is none.
struct Sensitivities {
    Values centre;
    std::vector<double>
        first;  ///< by value and number: with one standard deviation, to first order
    std::vector<BothSides> alone;  ///< by direction
    std::vector<BothSides> pairs;  ///< by pair (0, 1), (0, 2), ..., (1, 2), ...
    std::size_t numbers = 0;
    std::vector<double> root = {};  ///< L, row by row (paint::correlation_root()); empty: none

    std::vector<double> of(std::size_t value) const {
        return {first.begin() + static_cast<std::ptrdiff_t>(value * numbers),
                first.begin() + static_cast<std::ptrdiff_t>((value + 1) * numbers)};
    }
    /// From changes by number to those by direction, whose squares sum to the variance: L^T c.
    template <class Change>
    std::vector<Change> along(const std::vector<Change>& change) const {
        if (root.empty()) return change;
        std::vector<Change> out(numbers, Change{});
        for (std::size_t i = 0; i < numbers; ++i) {
            for (std::size_t k = 0; k <= i; ++k) out[k] += root[i * numbers + k] * change[i];
        }
        return out;
    }
};

}  // namespace nacre::fit
