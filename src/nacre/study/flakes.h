#pragma once

#include <cstdint>
#include <filesystem>

#include "nacre/study/gallery.h"

namespace nacre::study {

struct FlakesSettings {
    std::filesystem::path folder;
    std::uint64_t seed = 0;
    bool quick = false;  ///< two recipes, tiny pictures: to see that all works
};

/// The evidence for the model `nacre`: close looks at flat panels whose flakes are hashed, as in
/// the model, and explicit, as discs (discs/disc_walk.h); the same camera, lamp and recipe. Mean,
/// contrast against the pixel's footprint, histogram and colour for the recipes of studies/flakes.
///
/// Writes index.html, results.json and pictures/ into the folder. Pictures that this version has
/// made there already are not made again.
/// @return the page
/// @throws Interrupted; what making and rendering surfaces throw
std::filesystem::path run_flakes(const FlakesSettings& settings, const Stage& stage);

}  // namespace nacre::study
