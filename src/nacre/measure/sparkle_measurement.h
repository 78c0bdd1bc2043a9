#pragma once

#include <optional>
#include <vector>

#include "nacre/measure/graininess.h"
#include "nacre/measure/sparkle_camera.h"
#include "nacre/measure/sparkle_scale.h"

namespace nacre::measure {

/// What is reported about the sparkle and the grain of a panel.
struct SparkleMeasurement {
    std::vector<double> lamps_deg;
    std::vector<Sparkle> by_lamp;
    std::optional<Graininess> diffuse;  ///< none: no picture in diffuse light was taken
};

/// Reads the pictures that take_pictures() made.
/// @throws DomainError as sparkle() and graininess()
SparkleMeasurement measure_pictures(const SparkleCamera& camera, const PanelPictures& pictures,
                                    const Viewing& viewing = {});

}  // namespace nacre::measure
