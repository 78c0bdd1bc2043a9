#include <cstddef>
#include <cstdint>
#include <string_view>

#include "nacre/core/error.h"
#include "nacre/io/measured_brdf_file.h"

// A measured BRDF over half and difference angles is read or refused with an InputError; what is
// read is recognised, and written again as the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    try {
        const nacre::bsdf::MerlTable table = nacre::io::parse_merl(bytes, "fuzz.binary");
        if (!nacre::io::looks_like_merl(bytes) || nacre::io::merl_bytes(table) != bytes) {
            __builtin_trap();
        }
    } catch (const nacre::InputError&) {
    }
    return 0;
}
