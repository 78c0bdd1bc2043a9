#pragma once

#include <string>
#include <vector>

#include "nacre/bsdf/model.h"
#include "nacre/core/vec.h"

namespace nacre::study {

struct MirContext;

/// The colour of a paint, lit from 45 deg, by the angle from the mirror direction in the plane of
/// incidence, every 5 deg from 0 to 110; CIELAB under D65 for the 2 degree observer.
struct ColourByAngle {
    std::vector<double> aspecular_deg;
    std::vector<Vec3d> lab;

    /// C* = sqrt(a*^2 + b*^2) of one angle.
    double chroma(std::size_t i) const;
    /// C* / sqrt(L*^2 + C*^2), in [0, 1]: how much of what is seen is colour, however bright it is.
    /// 0 where nothing is seen.
    double saturation(std::size_t i) const;
};

/// @param file  a shipped recipe
/// @throws what reading, solving and the model throw
ColourByAngle colour_by_angle(const std::string& file, const bsdf::Model& model);

/// Plots of colour and lightness against angle.
void add_colours(MirContext& context);
/// C* by angle of the paints and models of Figure 4, which the paper discusses in words.
void add_saturation(MirContext& context);

}  // namespace nacre::study
