#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "nacre/optics/material.h"

// Files of optical constants. Both formats are described in docs/optics.md.

namespace nacre::optics {

/// Files beyond this size are refused; the largest page of refractiveindex.info has 1 MB.
inline constexpr std::size_t kMaxMaterialFileBytes = 4 << 20;

/// Linear interpolation between the samples of a dispersion formula errs by less than this in n.
inline constexpr double kFormulaSamplingError = 1e-6;

/// A table `wavelength_nm,n,k` with that header (the column k may be missing: transparent); lines
/// that start with # are comments, of which "# source: ..." is kept. One row is a constant.
/// @param name  of the material, and of the file in messages
/// @throws InputError naming file, line and value
Material parse_material_csv(std::string_view text, const std::string& name);

/// A page of refractiveindex.info [polyanskiy-2024]: DATA entries "tabulated nk", "tabulated n",
/// "tabulated k" and "formula 1" to "formula 9", one that gives n and at most one that gives k.
/// Wavelengths, in um there, become nm; the range is where both n and k are known. A formula is
/// sampled so finely that linear interpolation errs by less than kFormulaSamplingError.
/// @param name  of the material, and of the file in messages
/// @throws InputError naming file, line, key and value; anchors and aliases are refused
Material parse_material_yaml(std::string_view text, const std::string& name);

/// Either of the two, whose header tells which.
Material parse_material(std::string_view text, const std::string& name);

/// The text of a .csv, .yml or .yaml file, or of a stream (core/file.h) of either kind, whose header
/// tells which; the material is named after the path.
/// @throws InputError as the above
Material parse_material_file(std::string_view text, const std::filesystem::path& path);
/// The same of the file itself.
/// @throws InputError also if it cannot be read, or is too large
Material read_material_file(const std::filesystem::path& path);

/// A file of data/materials, compiled into the library.
struct ShippedMaterial {
    std::string_view name;
    std::string_view csv;
};

std::span<const ShippedMaterial> shipped_materials();

}  // namespace nacre::optics
