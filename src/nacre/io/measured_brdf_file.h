#pragma once

#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/bsdf/measured/merl.h"
#include "nacre/bsdf/measured/rgl.h"
#include "nacre/core/progress.h"

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

// The container of the RGL material database, which Mitsuba calls a tensor file: named arrays of
// any rank. All numbers are little-endian.
//                                                            [dupuy-jakob-2018; jakob-2022-mitsuba]
//
//   "tensor_file" and a zero    12 bytes
//   version                     two bytes, 1 and 0
//   number of fields            uint32
//   per field:  uint16 length of the name, the name; uint16 rank; uint8 type; uint64 offset from
//               the start of the file; rank times uint64 size
//   the arrays, the last index running fastest, each at its offset

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
    std::string bytes;                 ///< as in the file

    friend bool operator==(const TensorField&, const TensorField&) = default;
};

inline constexpr std::uint32_t kMaxTensorFields = 256;
inline constexpr std::uint16_t kMaxTensorRank = 16;

bool looks_like_tensor_file(std::string_view bytes);

/// @param name  of the file, for messages
/// @throws InputError naming file, field, value and what is allowed. Sizes are compared with the
/// number of bytes before anything is allocated
std::vector<TensorField> parse_tensor_file(std::string_view bytes, const std::string& name);

/// The bytes of such a file; arrays begin at multiples of 8.
/// @throws DomainError if a field's bytes do not fit its shape, or there are too many
/// @throws Stopped if `work`, which may be null, asks to stop
std::string tensor_file_bytes(const std::vector<TensorField>& fields,
                              SharedProgress* work = nullptr);

// Files of the RGL material database, .bsdf: a tensor file with the fields of
// bsdf::RglTable.
//                                                            [dupuy-jakob-2018; jakob-2022-mitsuba]
//
//   description   uint8    [bytes], text
//   phi_i         float32  [a], rad
//   theta_i       float32  [b], rad
//   ndf, sigma    float32  [rows][columns]
//   vndf          float32  [a][b][rows][columns]
//   luminance     float32  [a][b][n][n]
//   wavelengths   float32  [w], nm, with
//   spectra       float32  [a][b][w][n][n]      -- or --      rgb  float32  [a][b][3][n][n]
//   jacobian      uint8    [1], 0 or 1
//
// Other fields (the database has `version` and `valid`) are allowed and not used.

inline constexpr std::size_t kMaxMeasuredBytes = std::size_t{1} << 31;

bool looks_like_rgl(std::string_view bytes);

/// @param name  of the file, for messages
/// @throws InputError naming file, field, value and what is allowed
bsdf::RglTable parse_rgl(std::string_view bytes, const std::string& name);
bsdf::RglTable read_rgl(const std::filesystem::path& path);

/// @throws DomainError as bsdf::validate(); Stopped if `progress` asks to stop
std::string rgl_bytes(const bsdf::RglTable& table, const Progress& progress = {});
/// Writes whole or not at all. @throws as rgl_bytes() and core/file.h
void write_rgl(const std::filesystem::path& path, const bsdf::RglTable& table);

// Files of the MERL database, .binary: three int32, the numbers of cells along theta_half,
// theta_difference and phi_difference (90, 90, 180), then float64 for all red, all green and all
// blue cells, phi_difference running fastest. Little-endian, without a mark at the start.
//                                                                        [matusik-2003]

/// Whether the bytes start with three sizes in the allowed range and have the length that follows
/// from them: the format has no other mark.
bool looks_like_merl(std::string_view bytes);

/// Other numbers of cells than the database's are read too, as long as the file's length fits.
/// @param name  of the file, for messages
/// @throws InputError naming file, value and what is allowed
bsdf::MerlTable parse_merl(std::string_view bytes, const std::string& name);
bsdf::MerlTable read_merl(const std::filesystem::path& path);

/// @throws DomainError as bsdf::validate(); Stopped if `progress` asks to stop
std::string merl_bytes(const bsdf::MerlTable& table, const Progress& progress = {});
/// Writes whole or not at all. @throws as merl_bytes() and core/file.h
void write_merl(const std::filesystem::path& path, const bsdf::MerlTable& table);

}  // namespace nacre::io
