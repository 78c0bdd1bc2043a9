#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "apps/report/report.h"
#include "apps/study/flakes_close_up.h"
#include "apps/study/gallery.h"
#include "nacre/bsdf/bsdf.h"
#include "nacre/paint/recipe.h"
#include "nacre/solver/solved_paint.h"

namespace nacre::study {

struct FlakesSettings {
    std::filesystem::path folder;
    std::uint64_t seed = 0;
    bool quick = false;  ///< two recipes, tiny pictures: to see that all works
};

/// The evidence for the model `nacre`: close-ups of flat panels whose flakes are hashed, as in the
/// model, and explicit, as discs (montecarlo/discs/disc_walk.h), with the same camera, lamp and
/// recipe. Mean, contrast against the pixel's footprint, histogram and colour for the recipes of
/// studies/flakes.
///
/// Writes index.html, results.json and pictures/ into the folder. Pictures that this version has
/// made there already are not made again.
/// @return the page
/// @throws Interrupted; what making and rendering surfaces throw
std::filesystem::path run_flakes(const FlakesSettings& settings, const Stage& stage);

/// How the flakes of a paint are shown.
enum class Way {
    discs,        ///< explicit: each in its place, light traced among them
    mirrors,      ///< the same without diffraction
    hashed,       ///< the model `nacre`
    no_hot_spot,  ///< the same without its hot spot
    smooth        ///< the mean of that: `microflake`
};

/// In file names and results.
std::string name(Way way);

/// A recipe, and the surfaces that are made of it.
class FlakePaint {
 public:
    /// @param file  of studies/flakes; its name without the extension begins those of pictures
    explicit FlakePaint(const std::string& file, std::uint64_t seed);

    const std::string& key() const { return key_; }
    const paint::Recipe& recipe() const { return recipe_; }
    const paint::FlakeSpecies& species() const { return recipe_.layers[0].flakes[0]; }
    /// c H: flakes that a vertical line meets on average.
    double depth() const;
    double flakes_per_mm2() const;

    /// @param side_mm  of the panel: explicit flakes are laid out over all of it, others on each
    ///                 size of panel
    std::shared_ptr<const bsdf::Bsdf> surface(Way way, double side_mm, const Progress& progress);

    /// All that decides what surface() is.
    std::string identity(Way way, double side_mm) const;

 private:
    std::string key_;
    std::uint64_t seed_;
    paint::Recipe recipe_;
    std::shared_ptr<const solver::SolvedPaint> solved_;
    std::shared_ptr<const bsdf::Bsdf> hashed_, no_hot_spot_, smooth_;
};

// The parts of the study of flakes, one file each.

struct FlakesContext {
    const FlakesSettings& settings;
    const CloseUps& close_ups;
    report::Report& report;
    nlohmann::json& results;
};

/// The results for one recipe, for the table of all recipes.
struct FlakesVerdict {
    std::string name;
    double depth = 0, diameter_um = 0, flakes_per_mm2 = 0;
    Estimate mean_ratio;              ///< mean luminance of hashed over that of discs
    double mean_ratio_mirrors = 0;    ///< over that of discs without diffraction
    double contrast_ratio = 0;        ///< of hashed over discs: geometric mean over the footprints
    Estimate mean_ratio_no_hot_spot;  ///< the same two without the model's hot spot
    double contrast_ratio_no_hot_spot = 0;
    double worst_contrast_ratio = 1;  ///< farthest from 1
    double mean_delta_e = 0;          ///< between the mean colours at equal luminance
    double a_ratio = 0, b_ratio = 0;  ///< of the deviations of a* and b* over the pixels
};

/// "39.4", "7294".
std::string flake_count(double per_mm2);

/// Renders, measures and describes one recipe.
FlakesVerdict add_flake_paint(FlakesContext& context, FlakePaint& paint);

/// The mean by direction: of discs, by the equation of transfer, and with the hot spot of the model.
void add_means(FlakesContext& context, const Progress& progress);

/// The fraction of a flake that is both lit and seen: of discs, and by the equation of transfer.
void add_hiding(FlakesContext& context, const Progress& progress);

}  // namespace nacre::study
