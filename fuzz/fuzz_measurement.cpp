#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "nacre/core/csv.h"
#include "nacre/core/error.h"
#include "nacre/io/measurement_file.h"

// Multi-angle colour, as CSV, JSON or CGATS, is read or refused with an InputError; what is read
// survives being written and read again.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    nacre::io::looks_like_measurement(text);
    nacre::io::MeasurementFile file;
    try {
        file = nacre::io::parse_measurement_file(text, "fuzz.csv");
    } catch (const nacre::InputError&) {
        return 0;
    }
    for (const nacre::measure::Measurement& measurement : file.samples) {
        const std::string csv = nacre::io::measurement_csv(measurement);
        if (nacre::io::parse_measurement(csv, "again.csv") != measurement) __builtin_trap();
        // Names that are numbers get a comma too; what was read must not change.
        const auto commas =
            nacre::io::parse_measurement(nacre::with_decimal_commas(csv), "commas.csv");
        for (std::size_t i = 0; i < measurement.readings.size(); ++i) {
            if (commas.readings.at(i).lab != measurement.readings[i].lab) __builtin_trap();
        }
        // JSON replaces bytes that are not UTF-8.
        nacre::io::parse_measurement(
            nacre::io::measurement_json(measurement)
                .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace),
            "again.json");
    }
    return 0;
}
