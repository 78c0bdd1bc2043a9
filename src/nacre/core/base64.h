#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace nacre {

/// Bytes as base64 with padding and without line breaks.     [rfc-4648-2006, section 4]
std::string base64(std::string_view bytes);

/// The bytes that base64() makes a text of; none for any other text.
std::optional<std::string> from_base64(std::string_view text);

}  // namespace nacre
