#include <cstddef>
#include <cstdint>
#include <string_view>

#include "nacre/core/error.h"
#include "nacre/render/scene_file.h"

// A scene is read or refused with an InputError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    try {
        nacre::render::parse_scene(text, "fuzz.toml", "/nonexistent");
    } catch (const nacre::InputError&) {
    }
    return 0;
}
