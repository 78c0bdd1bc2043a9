#include <cstddef>
#include <cstdint>
#include <string_view>

#include "nacre/core/error.h"
#include "nacre/io/drawdown_file.h"
#include "nacre/io/pigment_file.h"

// Drawdowns (CSV) and files of pigments (TOML).

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    try {
        nacre::io::parse_drawdown(text, "fuzz.csv");
    } catch (const nacre::Error&) {  // refused
    }
    try {
        nacre::io::parse_pigment_file(text, "fuzz.toml", 0.1);
    } catch (const nacre::Error&) {  // refused
    }
    return 0;
}
