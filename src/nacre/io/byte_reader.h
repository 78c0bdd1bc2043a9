#pragma once

#include <bit>
#include <concepts>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

// Numbers of binary files, little-endian as all that Nacre reads and runs on.

namespace nacre::io {

static_assert(std::endian::native == std::endian::little);

/// Takes numbers and pieces from the front of bytes; empty where there are too few left.
class ByteReader {
 public:
    explicit ByteReader(std::string_view bytes) : rest_(bytes) {}

    template <class T>
    std::optional<T> take() {
        if (rest_.size() < sizeof(T)) return std::nullopt;
        T value;
        std::memcpy(&value, rest_.data(), sizeof(T));
        rest_.remove_prefix(sizeof(T));
        return value;
    }
    std::optional<std::string_view> take_bytes(std::size_t count) {
        if (rest_.size() < count) return std::nullopt;
        const std::string_view piece = rest_.substr(0, count);
        rest_.remove_prefix(count);
        return piece;
    }

 private:
    std::string_view rest_;
};

template <class T>
void append_number(std::string& bytes, T value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace nacre::io
