#include <cstddef>
#include <cstdint>
#include <string_view>

#include "nacre/core/error.h"
#include "nacre/render/shard_file.h"

// A shard of a picture is read or refused with an InputError. Its checksum keeps damaged bytes from
// the HDF5 library; what passes it must still make sense.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    try {
        nacre::render::parse_shard(bytes, "fuzz.h5");
    } catch (const nacre::InputError&) {
    }
    return 0;
}
