#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "nacre/core/progress.h"
#include "nacre/measure/sparkle_measurement.h"
#include "nacre/paint/recipe.h"

// Panels that differ in one number of their recipe.

namespace nacre::study {

/// What is varied, about the paint metallic-silver.
enum class FlakeParameter {
    diameter,    ///< um; its spread stays a third of it, and the volume fraction the same
    volume,      ///< fraction of the layer's volume
    orientation  ///< Beckmann alpha
};

/// The recipe with that value. Flakes are 18 um as in the paint, but 30 um where their volume is
/// varied, on a dark primer: then spots are resolved at most volumes, and their background is the
/// flakes' own.
paint::Recipe silver_with(FlakeParameter parameter, double value);

/// A camera whose field is that large, or 2.4 times as large for a paint of large flakes.
measure::SparkleCamera camera_for(const paint::Recipe& recipe, double field_mm);

/// A panel of the model `nacre`, looked at and read.
struct PanelLook {
    measure::PanelPictures pictures;
    measure::SparkleMeasurement readings;
};

/// @param seed  which flakes there are
/// @throws what solving, making and looking at the surface throw
PanelLook look_at(const paint::Recipe& recipe, const measure::SparkleCamera& camera,
                  std::uint64_t seed, const Progress& progress = {});

/// What is read off a panel.
enum class SparkleMeasure { density, intensity, sparkle, graininess };
std::string name(SparkleMeasure measure);
/// The reading under a lamp (of intensity its logarithm), or in diffuse light for graininess, where
/// `lamp` is not used. NaN where there is none.
Estimate reading(const measure::SparkleMeasurement& readings, SparkleMeasure measure,
                 std::size_t lamp);

enum class Trend { rises, falls };

/// Whether readings of independent panels rise or fall as expected.
struct TrendVerdict {
    Estimate first, last;
    double change_in_errors = 0;  ///< of the last from the first, in standard errors; > 0: expected
    double worst_step_in_errors = 0;  ///< the step most against the trend; below 0
    /// From first to last by four standard errors and more, and no step against it by three.
    bool holds() const { return change_in_errors >= 4 && worst_step_in_errors > -3; }
};

/// @param readings  at least two; those that are NaN are passed over
TrendVerdict judge(const std::vector<Estimate>& readings, Trend trend);

}  // namespace nacre::study
