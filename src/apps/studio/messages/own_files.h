#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

#include "nacre/render/mesh.h"
#include "nacre/render/scene.h"

// Shapes and lights that a page brings along: read from the bytes that it sent as what anybody may
// have made, without a look at any file of this machine.

namespace nacre::studio {

/// Of a file that a page sends: what fits in a message as base64, and its other keys.
inline constexpr std::size_t kMaxOwnFileBytes = 6'000'000;
inline constexpr std::size_t kMaxOwnTriangles = 500'000;
/// Around the horizon. What is wider is reduced; the largest that is read is twice as wide.
inline constexpr int kMaxOwnLightWidth = 2048;

struct OwnShape {
    std::string name;   ///< by which scenes know it; a page's newest alone is known
    std::string title;  ///< its file
    render::Shape shape;
    render::Camera camera;
    double extent_mm = 0;  ///< the largest, as the file has it
};

struct OwnLight {
    std::string name, title;
    render::ImageEnvironment picture;
    std::string note;  ///< what its reader changed; empty: nothing
};

/// A mesh: OBJ, PLY, STL, or a glTF in one file. It is put into the middle of the world and, where
/// it is smaller than 50 mm or larger than 400 mm, scaled to 200 mm.
/// @param file  its name, whose extension tells the format
/// @param y_up  its vertical is y; a glTF's always is
/// @throws InputError naming the file, and what is wrong with it
std::shared_ptr<const OwnShape> read_own_shape(const std::string& name, const std::string& file,
                                               std::string_view bytes, bool y_up);

/// A picture of the light from all around, latitude by longitude: Radiance HDR or OpenEXR. It is
/// scaled so that a white panel that lies flat in it is white.
/// @throws InputError naming the file, and what is wrong with it
std::shared_ptr<const OwnLight> read_own_light(const std::string& name, const std::string& file,
                                               std::string_view bytes);

}  // namespace nacre::studio
