#include <cstddef>
#include <cstdint>
#include <string_view>

#include "nacre/bsdf/measured/rgl.h"
#include "nacre/core/error.h"
#include "nacre/io/measured_brdf_file.h"

// A measured BRDF in the adaptive parameterization is read or refused with an InputError; what is
// read can be rendered, and written again to be read as the same.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    try {
        const nacre::bsdf::RglTable table = nacre::io::parse_rgl(bytes, "fuzz.bsdf");
        if (!(nacre::io::parse_rgl(nacre::io::rgl_bytes(table), "again.bsdf") == table)) {
            __builtin_trap();
        }
        // Making a surface takes a hundred times as long as reading: only of some.
        if (!table.description.empty()) return 0;
        const nacre::bsdf::MeasuredRgl model(table);
        const auto bound = model.bind({418, 456, 493, 531, 568, 606, 643, 681});
        bound->sample({0.6f, 0, 0.8f}, 0.5f, {0.3f, 0.7f});
        bound->evaluate({0.6f, 0, 0.8f}, {0, -0.6f, 0.8f});
    } catch (const nacre::InputError&) {
    }
    return 0;
}
