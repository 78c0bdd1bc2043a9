#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "nacre/bsdf/merl_table.h"

// Files of the MERL database, .binary: three int32, the numbers of cells along theta_half,
// theta_difference and phi_difference (90, 90, 180), then float64 for all red, all green and all
// blue cells, phi_difference running fastest. Little-endian, without a mark at the start.
//                                                                        [matusik-2003]

namespace nacre::io {

/// Whether three sizes in the allowed range stand at the start and the bytes have the length that
/// follows from them: all that the format has to be recognised by.
bool looks_like_merl(std::string_view bytes);

/// Other numbers of cells than the database's are read too, as long as the file's length fits.
/// @param name  of the file, for messages
/// @throws InputError naming file, value and what is allowed
bsdf::MerlTable parse_merl(std::string_view bytes, const std::string& name);
bsdf::MerlTable read_merl(const std::filesystem::path& path);

/// @throws DomainError as bsdf::validate()
std::string merl_bytes(const bsdf::MerlTable& table);
/// Writes whole or not at all. @throws as merl_bytes() and core/atomic_file.h
void write_merl(const std::filesystem::path& path, const bsdf::MerlTable& table);

}  // namespace nacre::io
