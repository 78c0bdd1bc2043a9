#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "nacre/core/error.h"
#include "nacre/render/mesh_file.h"

// The first byte picks the format of the rest: o, an OBJ; p, a PLY; s, an STL; b, a GLB; any other, a
// glTF. Read, or refused with an InputError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
    const char* const extension = data[0] == 'o'   ? ".obj"
                                  : data[0] == 'p' ? ".ply"
                                  : data[0] == 's' ? ".stl"
                                  : data[0] == 'b' ? ".glb"
                                                   : ".gltf";
    try {
        nacre::render::parse_mesh(bytes, {.path = std::string("/nonexistent/fuzz") + extension});
    } catch (const nacre::InputError&) {
    }
    return 0;
}
