#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>

#include "nacre/bsdf/tabulated/compression.h"
#include "nacre/core/progress.h"

// BRDF tables, raw and compressed, as HDF5 behind a sealed head (io/hdf5_file.h).
//
//   /                   attributes: format, format_version, nacre_version, paint, kind ("raw" or
//                       "svd"), colour
//   /grid               attributes: angles, azimuths, ior, roughness, lobe_alpha
//   /theta              [i], rad: the polar nodes, for readers other than Nacre
//   /values             raw: [i][o][azimuth][channel], 1/sr
//   /rank               svd: [channel], terms k
//   /left, /right       svd: [i][o][channel and k], 1/sr, and [azimuth][channel and k]
//
// What the numbers mean, and where the azimuths are: bsdf/tabulated/brdf_table.h, docs/tables.md.

namespace nacre::io {

inline constexpr int kBrdfTableFormatVersion = 1;
inline constexpr std::size_t kMaxBrdfTableBytes = std::size_t{1} << 31;

using BrdfTable = std::variant<bsdf::RawBrdfTable, bsdf::CompressedBrdfTable>;

/// Writes a table, whole or not at all.
/// @throws Error if the file cannot be written, InputError as core/file.h
void write_brdf_table(const std::filesystem::path& path, const bsdf::RawBrdfTable& table);
void write_brdf_table(const std::filesystem::path& path, const bsdf::CompressedBrdfTable& table);

/// The bytes of such a file.
/// @throws Stopped if `progress` asks to stop
std::string brdf_table_bytes(const bsdf::RawBrdfTable& table, const Progress& progress = {});
std::string brdf_table_bytes(const bsdf::CompressedBrdfTable& table, const Progress& progress = {});

/// @throws InputError if the file is cut short, altered, of another version, or no BRDF table
BrdfTable read_brdf_table(const std::filesystem::path& path);

/// The same from the bytes of a file; `name` is for messages.
BrdfTable parse_brdf_table(std::string_view bytes, const std::string& name);

/// Whether the bytes start like a BRDF table.
bool looks_like_brdf_table(std::string_view bytes);

}  // namespace nacre::io
