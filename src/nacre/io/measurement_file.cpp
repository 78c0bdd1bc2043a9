#include "nacre/io/measurement_file.h"

#include "nacre/core/atomic_file.h"
#include "nacre/io/measurement_csv.h"
#include "nacre/io/measurement_json.h"

namespace nacre::io {

namespace {

bool starts_like_json(std::string_view text) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && text[first] == '{';
}

}  // namespace

measure::Measurement parse_measurement(std::string_view text, const std::string& filename,
                                       const measure::Conditions& defaults) {
    return starts_like_json(text) ? parse_measurement_json(text, filename, defaults)
                                  : parse_measurement_csv(text, filename, defaults);
}

measure::Measurement read_measurement(const std::filesystem::path& path,
                                      const measure::Conditions& defaults) {
    return parse_measurement(read_file(path), path.string(), defaults);
}

bool looks_like_measurement(std::string_view text) {
    return starts_like_json(text) || has_measurement_header(text);
}

}  // namespace nacre::io
