#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string_view>

#include "nacre/core/error.h"
#include "nacre/io/measurement_file.h"

// Multi-angle colour, as CSV or JSON, is read or refused with an InputError; what is read survives
// being written and read again.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    nacre::io::looks_like_measurement(text);
    nacre::measure::Measurement measurement;
    try {
        measurement = nacre::io::parse_measurement(text, "fuzz.csv");
    } catch (const nacre::InputError&) {
        return 0;
    }
    const auto again =
        nacre::io::parse_measurement(nacre::io::measurement_csv(measurement), "again.csv");
    if (again != measurement) __builtin_trap();
    // JSON replaces bytes that are not UTF-8.
    nacre::io::parse_measurement(
        nacre::io::measurement_json(measurement)
            .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace),
        "again.json");
    return 0;
}
