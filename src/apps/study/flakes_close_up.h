#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "apps/study/gallery.h"
#include "nacre/bsdf/bsdf.h"
#include "nacre/core/estimate.h"
#include "nacre/render/scene.h"
#include "nacre/spectra/observer.h"

// Numbers that say how a picture of flakes looks.

namespace nacre::study {

/// A picture as it comes from a renderer: linear Rec. 709, three values a pixel.
struct Pixels {
    int width = 0, height = 0;
    std::vector<float> rgb;
};

/// Luminance Y by pixel.
std::vector<double> luminance(const Pixels& picture);

/// Mean luminance. Error: by the jackknife over 16 pieces of the picture, each left out in turn, so
/// that neighbours which share a flake do not count as independent.   [efron-stein-1981]
Estimate mean_luminance(const Pixels& a, const Pixels& b);

/// Standard deviation of luminance over its mean, from two pictures of the same flakes with
/// independent noise: the root of their covariance over the product of their means, which noise
/// does not raise. 0 where noise makes the covariance negative. Error as above.
/// @throws DomainError unless both have the same size, at least 4 x 4
Estimate contrast(const Pixels& a, const Pixels& b);

/// Fraction of the pixels by luminance over the mean luminance, in equal steps of its logarithm;
/// the first and the last hold what lies beyond.
struct Histogram {
    std::vector<double> centre;  ///< of the steps, as a ratio
    std::vector<double> fraction;
};
Histogram histogram(const Pixels& picture);

/// Colours in CIELAB after scaling the picture so that `mean_luminance` becomes 0.3.
struct ColourSpread {
    Vec3d mean_lab{};                         ///< of the mean colour
    double a_deviation = 0, b_deviation = 0;  ///< over the pixels
    std::vector<std::array<double, 2>> ab;    ///< by pixel
};
ColourSpread colour_spread(const Pixels& picture, double mean_luminance);

// Close looks at a flat panel, from a distance from which all of it is seen and lit under the same
// angles.

/// Directions outside, from the normal; the eye stands near the mirror image of the lamp, but does
/// not see it in the clearcoat.
inline constexpr double kEye_deg = 20, kLamp_deg = 30;
/// Side of the square lamp, as an angle.
inline constexpr double kLampSize_deg = 8;

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

    using MakeSurface = std::function<std::shared_ptr<const bsdf::Bsdf>(const Progress&)>;

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
