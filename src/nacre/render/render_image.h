#pragma once

#include <map>
#include <string>

#include "nacre/io/image.h"
#include "nacre/render/render.h"

namespace nacre::render {

/// A rendered picture with the channels R, G, B; A; albedo.R ... and normal.X ... for denoisers;
/// sparkle.R ... if it was asked for; and, where there is a spectral film, S0.550nm and so on for
/// each bin, laid out so that tools for spectral OpenEXR read them [fichet-2021]. The metadata are
/// those given plus samples, seconds and whether the picture is complete.
io::Image image_of(const RenderResult& result, std::map<std::string, std::string> metadata);

}  // namespace nacre::render
