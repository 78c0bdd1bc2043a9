#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "nacre/bsdf/rgl_table.h"

// Files of the RGL material database, .bsdf: a tensor file (tensor_file.h) with the fields of
// bsdf::RglTable.                                             [dupuy-jakob-2018;
// jakob-2022-mitsuba]
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

namespace nacre::io {

inline constexpr std::size_t kMostMeasuredBytes = std::size_t{1} << 31;

bool looks_like_rgl(std::string_view bytes);

/// @param name  of the file, for messages
/// @throws InputError naming file, field, value and what is allowed
bsdf::RglTable parse_rgl(std::string_view bytes, const std::string& name);
bsdf::RglTable read_rgl(const std::filesystem::path& path);

/// @throws DomainError as bsdf::validate()
std::string rgl_bytes(const bsdf::RglTable& table);
/// Writes whole or not at all. @throws as rgl_bytes() and core/atomic_file.h
void write_rgl(const std::filesystem::path& path, const bsdf::RglTable& table);

}  // namespace nacre::io
