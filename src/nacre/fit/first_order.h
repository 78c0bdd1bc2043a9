#pragma once

#include <cstddef>
#include <optional>

#include "nacre/fit/uncertain_values.h"
#include "nacre/fit/uncertainty.h"

// Uncertainty to first order, and how far the next terms are from it.

namespace nacre::fit {

/// @param lab, spectrum  where the reading's numbers begin (ValueLayout)
ReadingUncertainty reading_of(const measure::Reading& reading, std::size_t lab,
                              std::size_t spectrum, const Sensitivities& moves);
/// None where the metric has no value.
std::optional<MetricUncertainty> metric_of(std::size_t position, const Sensitivities& moves);

/// Chroma and hue from the spread of a* and b*, where that does not reach grey.
void add_chroma_and_hue(Spread& spread, const Vec3d& lab);

/// The shortest way round, in (-180, 180].
double hue_between_deg(const Vec3d& from, const Vec3d& to);

}  // namespace nacre::fit
