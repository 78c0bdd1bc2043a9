#pragma once

#include <map>
#include <string>

#include "nacre/io/image.h"
#include "nacre/measure/panel_picture.h"

namespace nacre::io {

/// What a camera saw of a panel, with the channels R, G and B: 1 is the perfect diffuser under the
/// same light. The metadata are those given.
Image image_of(const measure::PanelPicture& picture, std::map<std::string, std::string> metadata);

/// The exposure in stops that shows the panel's mean luminance as 0.25 of white, leaving room for
/// flakes that flash. 0 for a black panel.
double display_stops(const measure::PanelPicture& picture);

}  // namespace nacre::io
