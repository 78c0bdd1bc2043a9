#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "nacre/bsdf/bsdf.h"
#include "nacre/render/scene_description.h"
#include "nacre/study/flakes_statistics.h"
#include "nacre/study/gallery.h"

// Close looks at a flat panel, from a distance from which all of it is seen and lit under the same
// angles.

namespace nacre::study {

/// Directions outside, from the normal; the eye stands near the mirror image of the lamp, but does
/// not see it in the clearcoat.
inline constexpr double kEyeDeg = 20, kLampDeg = 30;
/// Side of the square lamp, as an angle.
inline constexpr double kLampSizeDeg = 8;

/// A dark room, a panel of paint, one lamp.
/// @param pixel_mm  side of a pixel in the middle of the panel, across the line of sight
/// @param pixels    a side of the picture
render::SceneDescription close_up_scene(double pixel_mm, int pixels);

/// Side of the square panel that such a picture looks at: larger than what is seen.
double panel_side_mm(double pixel_mm, int pixels);

struct CloseUpJob {
    std::string key;      ///< file name, unique in the study
    std::string title;    ///< for people
    std::string surface;  ///< all that tells what is looked at
    double pixel_mm = 0;
    int pixels = 64;
    int samples = 64;
    std::uint64_t seed = 0;  ///< of the noise, not of the flakes
};

class CloseUps {
 public:
    /// @param folder  pictures go to its sub-folder pictures/
    CloseUps(std::filesystem::path folder, Stage stage);

    using MakeSurface = std::function<std::shared_ptr<const bsdf::Bsdf>()>;

    /// The picture; from disk if this version has made it before.
    /// @throws Interrupted, and what making the surface and rendering throw
    Pixels take(const CloseUpJob& job, const MakeSurface& surface) const;

    /// Writes pictures/KEY.png, and gives its bytes.
    /// @param mean  the luminance that is shown as 0.3 of white
    std::string png(const Pixels& picture, double mean, const std::string& key) const;

 private:
    std::filesystem::path folder_;
    Stage stage_;
};

}  // namespace nacre::study
