#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "apps/report/report.h"
#include "nacre/bsdf/bsdf.h"
#include "nacre/bsdf/model.h"
#include "nacre/core/progress.h"
#include "nacre/fit/uncertainty.h"
#include "nacre/measure/difference.h"
#include "nacre/measure/measurement.h"
#include "nacre/measure/sparkle_measurement.h"
#include "nacre/measure/tolerance.h"
#include "nacre/paint/recipe.h"

namespace nacre::datasheet {

struct PictureSettings {
    std::string scene = "sphere";  ///< one of render::builtin_scene_names()
    int width = 512, height = 512;
    int samples_per_pixel = 64;
    std::uint64_t seed = 0;
};

/// A paint on a body in the built-in studio, as the bytes of a PNG file.
/// @throws InputError if there is no such scene; DomainError as render::render(); Error if
///         `progress` asks to stop
std::string painted_picture(std::shared_ptr<const bsdf::Bsdf> paint,
                            const PictureSettings& settings, const Progress& progress = {});

/// panel.css, which is part of the library: what a panel report's page adds to
/// apps/report/page.css.
std::string_view panel_css();

// What a designer hands to a customer: a paint on one page.

/// What the sample is held against.
struct PanelStandard {
    measure::Measurement measurement;
    measure::Difference difference;
    bool measured = false;  ///< read from a file, not computed
    std::optional<measure::Verdict> verdict = {};
    /// Seen by the sample's lamps; none of a standard that shows no single flakes.
    std::optional<measure::SparkleMeasurement> sparkle = {};
};

struct PanelReport {
    std::string title = {};                          ///< plain text: the paint's name
    const bsdf::ModelInfo* model = nullptr;          ///< of the pictures; never null
    const bsdf::ModelInfo* reading_model = nullptr;  ///< of the readings; null: the same
    measure::Measurement sample = {};
    std::optional<PanelStandard> standard = {};
    /// The first stands large, the others small beside it.
    std::vector<report::Picture> pictures = {};
    std::optional<measure::SparkleMeasurement> sparkle = {};
    /// Of the sample, its readings in the same order.
    std::optional<fit::Uncertainty> uncertainty = {};
    paint::Recipe recipe = {};
    std::string recipe_sha256 = {};
};

/// The page: one file without scripts or links to others, for screens and for A4 paper. Pictures,
/// chips by angle, curves, metrics, composition, conditions, and what the numbers are and are not.
/// @throws DomainError as report::pictures_html() and report::plot_svg()
std::string panel_report_html(const PanelReport& report);

}  // namespace nacre::datasheet
