#pragma once

#include <map>
#include <string>
#include <vector>

#include "nacre/measure/measurement.h"

namespace nacre::measure {

struct AngleDifference {
    Geometry geometry;
    spectra::Vec3 delta_lab{};  ///< sample less standard
    double delta_e_2000 = 0;
    double weight = 1;
};

/// How far a sample is from a standard, at the geometries that both have.
struct Difference {
    std::vector<AngleDifference> angles;
    double mean_delta_e_2000 = 0;  ///< weighted
    double max_delta_e_2000 = 0;
};

/// @param weights  by the geometry's name, >= 0; those not named weigh 1
/// @throws DomainError if the two have no geometry in common, their illuminants or observers
///         differ while one of them has no spectra to be converted, a weight is negative or names
///         no geometry in common, or all weights are 0
Difference difference(const Measurement& standard, const Measurement& sample,
                      const std::map<std::string, double>& weights = {});

}  // namespace nacre::measure
