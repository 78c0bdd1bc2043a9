#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>

// What the readers of meshes take from the bytes of a file.

namespace nacre::render {

/// Four bytes, the lowest first.
inline std::uint32_t little_endian(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;) {
        value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    }
    return value;
}

/// The next word of a text from `position`, which is left behind it; empty at the end.
inline std::string_view take_word(std::string_view text, std::size_t& position) {
    constexpr std::string_view kSpace = " \t\r\n\f\v";
    const std::size_t begin =
        std::min(text.find_first_not_of(kSpace, std::min(position, text.size())), text.size());
    position = std::min(text.find_first_of(kSpace, begin), text.size());
    return text.substr(begin, position - begin);
}

}  // namespace nacre::render
