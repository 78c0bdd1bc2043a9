#pragma once

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "nacre/bsdf/microflake.h"
#include "nacre/bsdf/smooth_table.h"

// What the micro-flake model works out once a paint, before any wavelength is chosen.

namespace nacre::bsdf {

/// Functions of one direction are tabulated over x = tan(theta/2), even in x.
inline constexpr int kDirectionIntervals = 128;

/// Odds of the sampling strategies at one incident direction; they sum to 1.
struct LobeOdds {
    float interface = 0, flakes = 0, wide = 0, diffuse = 0;
};

struct Microflake::Tables {
    explicit Tables(std::shared_ptr<const layers::SolvedPaint> solved);

    std::shared_ptr<const layers::SolvedPaint> paint;
    float mean_ior;  ///< of the binder over the paint's wavelengths
    bool rough;      ///< the interface: its lobe takes the place of the mirror
    SmoothTable smooth;
    /// Roughness of the sampled lobes inside the coat: flakes (area-weighted mean) and what they
    /// scatter again.
    float flake_alpha = 0.1f, wide_alpha = 0.2f;  // the second always twice the first
    /// [layer][direction][wavelength]: extinction in 1/um of the direction refracted into the coat.
    std::vector<std::vector<float>> extinction;
    std::vector<LobeOdds> odds;  ///< by direction
    /// [direction][wavelength]: directional-hemispherical reflectance; filled by
    /// tabulate_albedo(), which needs the model itself.
    std::vector<float> albedo;

    /// What the smooth table sums, in the order of its basis.
    std::vector<const layers::Remainder*> tensors() const;
    int wavelength_count() const { return paint->medium.wavelength_count(); }

 private:
    void tabulate_extinction();
    void choose_lobes();
};

/// Fills tables.albedo with the mean weight of sample() of the surface that `bind` makes of the
/// tables.
void tabulate_albedo(
    Microflake::Tables& tables,
    const std::function<std::unique_ptr<const BoundBsdf>(const Wavelengths&)>& bind);

/// Angle outside the coat of a row of the direction tables, just short of the horizon at the last.
double direction_angle(int row);

}  // namespace nacre::bsdf
