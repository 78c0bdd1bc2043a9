#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

// The container of the RGL material database, which Mitsuba calls a tensor file: named arrays of
// any rank. All numbers are little-endian.                    [dupuy-jakob-2018;
// jakob-2022-mitsuba]
//
//   "tensor_file" and a zero    12 bytes
//   version                     two bytes, 1 and 0
//   number of fields            uint32
//   per field:  uint16 length of the name, the name; uint16 rank; uint8 type; uint64 offset from
//               the start of the file; rank times uint64 size
//   the arrays, the last index running fastest, each at its offset

namespace nacre::io {

enum class TensorType : std::uint8_t {
    uint8 = 1,
    int8,
    uint16,
    int16,
    uint32,
    int32,
    uint64,
    int64,
    float16,
    float32,
    float64
};
std::size_t bytes_of(TensorType type);
std::string_view name_of(TensorType type);

struct TensorField {
    std::string name;
    TensorType type = TensorType::uint8;
    std::vector<std::uint64_t> shape;  ///< empty: one number
    std::string bytes;                 ///< as they stand in the file

    friend bool operator==(const TensorField&, const TensorField&) = default;
};

inline constexpr std::uint32_t kMostTensorFields = 256;
inline constexpr std::uint16_t kMostTensorRank = 16;

bool looks_like_tensor_file(std::string_view bytes);

/// @param name  of the file, for messages
/// @throws InputError naming file, field, value and what is allowed. Sizes are compared with the
/// bytes that are there before anything is made of them
std::vector<TensorField> parse_tensor_file(std::string_view bytes, const std::string& name);

/// The bytes of such a file; arrays begin at multiples of 8.
/// @throws DomainError if a field's bytes do not fit its shape, or there are too many
std::string tensor_file_bytes(const std::vector<TensorField>& fields);

}  // namespace nacre::io
