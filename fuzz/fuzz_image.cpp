#include <cstddef>
#include <cstdint>
#include <string_view>

#include "nacre/core/error.h"
#include "nacre/io/image.h"

// A picture is read or refused with an InputError. The bound on its size keeps the fuzzer fast.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr std::size_t kMaxValues = 1 << 14;
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    try {
        nacre::io::parse_image(bytes, "fuzz", kMaxValues);
    } catch (const nacre::InputError&) {
    }
    return 0;
}
