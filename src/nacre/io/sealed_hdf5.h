#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "nacre/io/hdf5_handle.h"

// HDF5 files behind a head of 512 bytes of text that says what this is, and version, size and
// SHA-256 of the rest. The checksum is verified before HDF5 sees a byte: its library is not made
// for damaged files. Files are made and read in memory.

namespace nacre::io {

struct SealedFormat {
    std::string_view name;  ///< the first line of the head, and the attribute `format`
    int version;
    std::string_view noun;  ///< for messages: "is not a `noun` of Nacre"
};

/// Whether the bytes start like a file of that format.
bool is_sealed_as(const SealedFormat& format, std::string_view bytes);

/// The bytes of a file: `write` fills the root group, which has attributes format, format_version
/// and nacre_version already.
std::string sealed_bytes(const SealedFormat& format, const std::function<void(hid_t)>& write);

/// Calls `read` with the root group of a file; `name` is for messages.
/// @throws InputError naming the file if it is cut short, altered, of another version or format, or
/// if HDF5 or `read` throw an Error
void read_sealed(const SealedFormat& format, std::string_view bytes, const std::string& name,
                 const std::function<void(hid_t)>& read);

}  // namespace nacre::io
