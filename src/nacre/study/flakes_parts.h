#pragma once

#include <nlohmann/json.hpp>

#include "nacre/report/report.h"
#include "nacre/study/flakes.h"
#include "nacre/study/flakes_close_up.h"
#include "nacre/study/flakes_paint.h"

// The parts of the study of flakes, one file each.

namespace nacre::study {

struct FlakesContext {
    const FlakesSettings& settings;
    const CloseUps& close_ups;
    report::Report& report;
    nlohmann::json& results;
};

/// What came out for one recipe, for the table at the top.
struct FlakesVerdict {
    std::string name;
    double depth = 0, diameter_um = 0, flakes_per_mm2 = 0;
    Measured mean_ratio;            ///< mean luminance of hashed over that of discs
    double mean_ratio_mirrors = 0;  ///< over that of discs without diffraction
    double contrast_ratio = 0;      ///< of hashed over discs: geometric mean over the footprints
    Measured mean_ratio_hot_spot;   ///< the same two with the model's hot spot
    double contrast_ratio_hot_spot = 0;
    double worst_contrast_ratio = 1;  ///< farthest from 1
    double mean_delta_e = 0;          ///< between the mean colours at equal luminance
    double a_ratio = 0, b_ratio = 0;  ///< of the deviations of a* and b* over the pixels
};

/// "39.4", "7294".
std::string flake_count(double per_mm2);

/// Renders, measures and describes one recipe.
FlakesVerdict add_flake_paint(FlakesContext& context, FlakePaint& paint);

/// How much of a flake is lit and seen: discs against what the equation of transfer says.
void add_hiding(FlakesContext& context);

}  // namespace nacre::study
