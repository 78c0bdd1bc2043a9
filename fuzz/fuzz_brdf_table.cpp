#include <cstddef>
#include <cstdint>
#include <string_view>

#include "nacre/core/error.h"
#include "nacre/io/brdf_table_file.h"

// A BRDF table is read or refused with an InputError. Its checksum keeps damaged bytes from the
// HDF5 library; what passes it must still make sense.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    try {
        nacre::io::parse_brdf_table(bytes, "fuzz.h5");
    } catch (const nacre::InputError&) {
    }
    return 0;
}
