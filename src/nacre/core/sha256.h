#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace nacre {

/// SHA-256 of a stream of bytes, as a checksum of contents.     [fips-180-4-2015, section 6.2]
class Sha256 {
 public:
    Sha256();

    void update(const void* bytes, std::size_t count);
    void update(std::string_view bytes) { update(bytes.data(), bytes.size()); }

    /// The digest of everything given so far, as 64 hexadecimal digits in lower case; more may
    /// follow.
    std::string hex() const;

 private:
    void compress(const std::uint8_t* block);

    std::array<std::uint32_t, 8> state_;
    std::array<std::uint8_t, 64> block_{};
    std::size_t filled_ = 0;   // bytes waiting in block_
    std::uint64_t total_ = 0;  // bytes seen
};

/// SHA-256 of some bytes as 64 hexadecimal digits in lower case, as `sha256sum` prints it.
std::string sha256_hex(std::string_view bytes);

}  // namespace nacre
