#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "nacre/bsdf/bsdf.h"
#include "nacre/core/progress.h"

namespace nacre::panel {

struct PictureSettings {
    std::string scene = "sphere";  ///< one of render::builtin_scene_names()
    int width = 512, height = 512;
    int samples_per_pixel = 64;
    std::uint64_t seed = 0;
};

/// A paint on a body in the built-in studio, as the bytes of a PNG file.
/// @throws InputError if there is no such scene; DomainError as render::render(); Error if
///         `progress` asks to stop
std::string painted_picture(std::shared_ptr<const bsdf::Bsdf> paint,
                            const PictureSettings& settings, const Progress& progress = {});

}  // namespace nacre::panel
