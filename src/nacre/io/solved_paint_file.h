#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "nacre/solver/solved_paint.h"

// Solved paints as HDF5. The file describes itself: every group and array has its meaning and unit
// as an attribute; h5dump, h5py, Julia and MATLAB open it.
//
//   (user block)             512 bytes of text: what this is, version, size and SHA-256 of the rest
//   /                        attributes: format, format_version, nacre_version, recipe_sha256
//   /recipe                  the recipe as TOML, complete in itself: shipped materials by name,
//                            those of a user's files by their samples
//   /wavelengths_nm          [w]
//   /settings, /report       attributes: SolverSettings and SolverReport
//   /remainder               attributes lobe_width and table_rank (MultipleScattering), which older
//                            files lack
//   /remainder/exit_angle    [i], rad
//   /remainder/first         [l]
//   /remainder/basis         [k][w]
//   /remainder/coefficient   [k][pair], 1/sr
//   /rough_single            under a rough interface only: single scattering, in the same arrays
//
// /remainder is the multiple scattering. Under a smooth interface the single scattering and
// everything else is computed from the recipe when the file is read. The checksum is verified
// before HDF5 sees a byte: its library is not made for damaged files.

namespace nacre::io {

inline constexpr int kSolvedPaintFormatVersion = 2;
inline constexpr std::size_t kMaxSolvedPaintBytes = std::size_t{1} << 28;

/// Writes a solved paint, whole or not at all.
/// @throws Error if the file cannot be written, or a material has more samples than a recipe may
void write_solved_paint(const std::filesystem::path& path, const solver::SolvedPaint& paint);

/// The bytes of such a file.
/// @throws Error if a material has more samples than a recipe may
std::string solved_paint_bytes(const solver::SolvedPaint& paint);

/// @throws InputError if the file is cut short, altered, of another version, or no solved paint
solver::SolvedPaint read_solved_paint(const std::filesystem::path& path);

/// The same from the bytes of a file; `name` is for messages.
solver::SolvedPaint parse_solved_paint(std::string_view bytes, const std::string& name);

/// Whether the bytes start like a solved paint.
bool looks_like_solved_paint(std::string_view bytes);

}  // namespace nacre::io
