#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

// Reading and writing whole files.

namespace nacre::io {

/// The bytes of a regular file.
///
/// @throws InputError if there is no such file, it is not a regular file (reading a pipe could
///         wait for ever), it is larger than `most_bytes` or cannot be read
std::string read_file(const std::filesystem::path& path, std::size_t most_bytes);

/// Writes a file whole or not at all: `write` fills a temporary file in the same folder, which
/// then takes the place of `path` in one step. If `write` throws, nothing is left behind.
///
/// @throws Error if the folder cannot be written to
void write_atomically(const std::filesystem::path& path,
                      const std::function<void(const std::filesystem::path& temporary)>& write);

/// The same for bytes that are at hand.
void write_atomically(const std::filesystem::path& path, std::string_view bytes);

}  // namespace nacre::io
