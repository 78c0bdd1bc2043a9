#pragma once

#include <cstdint>
#include <vector>

#include "nacre/bsdf/bsdf.h"
#include "nacre/core/progress.h"
#include "nacre/core/text.h"
#include "nacre/measure/panel_picture.h"

namespace nacre::measure {

/// How many pixels of a SparkleCamera the side of its field may be.
inline constexpr Range kPixelsAcross{32, 4096, "pixels"};

/// A telecentric camera that looks along the normal of a flat panel, and the lights around it.
struct SparkleCamera {
    double pixel_um = 25;  ///< side of a pixel on the panel, [1, 1000]
    /// Side of its square field: 32 to 4096 pixels, 60 million in all pictures together.
    double field_mm = 12;
    /// Lamps, from the normal, in one plane; at most kMaxLamps, each in kLampRange. May be empty.
    std::vector<double> lamps_deg = {15, 45, 75};
    /// Lamps are discs of uniform radiance of this radius, [0, 3]. 0 is a point. The sun has 0.27.
    double lamp_half_angle_deg = 0.25;
    /// Directions per pixel, at least two per patch, for the picture in diffuse light; even, in [2,
    /// 65536], or 0: no such picture.
    int diffuse_samples = 16;
    std::uint64_t seed = 0;  ///< of those directions; which flakes there are is the surface's own
    /// Side of the panel that is an object's unit square (bsdf::SurfaceCoordinates::unit_square),
    /// at least the field.
    double unit_square_mm = 100;

    static constexpr Range kLampRange{0, 85, "deg"};
    static constexpr std::size_t kMaxLamps = 16;
};

/// @throws DomainError naming the number and its range; Error if the machine has less memory than
///         the pictures take
void check(const SparkleCamera& camera);
/// Pixels per side.
int pixels_across(const SparkleCamera& camera);

struct PanelPictures {
    std::vector<PanelPicture> by_lamp;  ///< in the camera's order
    /// Under a hemisphere of uniform radiance: the same flakes twice, sampled along independent
    /// directions, so that their covariance is free of noise. Empty without diffuse_samples.
    std::vector<PanelPicture> diffuse;
    /// False if flakes are so dense that the model represents several by one even on the smallest
    /// patches: graininess is then too large.
    bool flakes_resolved = true;
};

/// Takes the pictures of a panel. They do not contain the specular reflection of a smooth
/// interface. The waves of a coat that is not flat (Bsdf::coat_waves) are there, each patch being seen at
/// the slope of its middle; where its thickness varies the mean thickness is taken everywhere.
///
/// Pixels are made of patches that are small enough for the model to resolve every flake
/// (bsdf::SingleFlakes). A pixel under a lamp is pi times the BRDF of its patch, averaged over the
/// lamp's disc with the cosine of incidence, at 16 wavelengths from 400 to 700 nm by 20; under
/// diffuse light, the integral of BRDF times cosine by sampling the patch along stratified
/// directions, shifted at random from pixel to pixel [cranley-patterson-1976]. Illuminant D65.
///
/// The same bits for any number of threads. For a homogeneous surface under a flat coat a single pixel is computed.
/// @throws DomainError as check(), or if the field is larger than the unit square of a surface that
///         is laid out over it
/// @throws Error if `progress` asks to stop
PanelPictures take_pictures(const bsdf::Bsdf& surface, const SparkleCamera& camera,
                            const Progress& progress = {});

}  // namespace nacre::measure
