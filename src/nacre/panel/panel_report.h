#pragma once

#include <optional>
#include <string>
#include <vector>

#include "nacre/layers/recipe.h"
#include "nacre/measure/difference.h"
#include "nacre/measure/measurement.h"
#include "nacre/measure/sparkle_measurement.h"
#include "nacre/models/model.h"
#include "nacre/report/report.h"

// What a designer hands to a customer: a paint on one page.

namespace nacre::panel {

/// What the sample is held against.
struct PanelStandard {
    measure::Measurement measurement;
    measure::Difference difference;
    bool measured = false;  ///< read from a file, not computed
};

struct PanelReport {
    std::string title = {};  ///< plain text: the paint's name
    models::Model model = models::Model::microflake;
    measure::Measurement sample = {};
    std::optional<PanelStandard> standard = {};
    /// The first stands large, the others small beside it.
    std::vector<report::Picture> pictures = {};
    std::optional<measure::SparkleMeasurement> sparkle = {};
    layers::Recipe recipe = {};
    std::string recipe_sha256 = {};
};

/// The page: one file without scripts or links to others, for screens and for A4 paper. Pictures,
/// chips by angle, curves, metrics, composition, conditions, and what the numbers are and are not.
/// @throws DomainError as report::pictures_html() and report::plot_svg()
std::string panel_report_html(const PanelReport& report);

}  // namespace nacre::panel
