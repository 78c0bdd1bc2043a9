#pragma once

#include <cstdint>
#include <filesystem>

#include "apps/study/gallery.h"

namespace nacre::study {

struct SparkleStudySettings {
    std::filesystem::path folder;
    std::uint64_t seed = 0;
    bool quick = false;  ///< small panels, few points: to see that all works
};

/// How sparkle and graininess, as docs/sparkle.md defines them, depend on the flakes' diameter, on
/// how many there are and on how they lie, in the model `nacre`; whether they rise and fall as they
/// are expected to; and what they are for the paints that are shipped.
///
/// Writes index.html, results.json and pictures/ into the folder.
/// @return the page
/// @throws Interrupted; what making and looking at surfaces throw
std::filesystem::path run_sparkle(const SparkleStudySettings& settings, const Stage& stage);

}  // namespace nacre::study
