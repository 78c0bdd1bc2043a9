#pragma once

#include "nacre/measure/eye.h"
#include "nacre/measure/jackknife.h"
#include "nacre/measure/panel_picture.h"

// How grainy a panel looks in diffuse light: definition, sources and limits in docs/sparkle.md.

namespace nacre::measure {

struct Graininess {
    double mean_y = 0;        ///< luminance factor of the panel
    Estimate graininess;      ///< in thresholds: 1 is a sinusoidal grating that is just noticed
    Estimate pixel_contrast;  ///< the same without the eye: measure::pixel_contrast()
};

/// The contrast of a picture, frequency by frequency, weighted with the eye's contrast sensitivity
/// S [barten-1999, chapter 3]:
///   G^2 = 2  Int S(|u|)^2 P(u) d^2u,     P: power spectrum of Y / mean - 1.
/// A sinusoidal grating of modulation m has G = m S(u): 1 at the threshold.
///
/// From two pictures of the same flakes with independent noise: P is their cross spectrum, which
/// noise does not raise. Where a side has prime factors above 7, the rows and columns beyond the
/// largest one without are left out. 0 where noise makes the sum negative, and for a black picture.
/// @throws DomainError unless both have the same size, at least 16 pixels a side; as check()
Graininess graininess(const PanelPicture& a, const PanelPicture& b, const Viewing& viewing = {});

}  // namespace nacre::measure
