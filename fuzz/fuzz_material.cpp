#include <cstddef>
#include <cstdint>
#include <string_view>

#include "nacre/core/error.h"
#include "nacre/optics/material_file.h"

// The first byte picks the format of the rest: c, a table; any other, a page of
// refractiveindex.info. Read, or refused with an InputError.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
    try {
        if (data[0] == 'c') {
            nacre::optics::parse_material_csv(text, "fuzz");
        } else {
            nacre::optics::parse_material_yaml(text, "fuzz");
        }
    } catch (const nacre::InputError&) {
    }
    return 0;
}
