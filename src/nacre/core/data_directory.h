#pragma once

#include <filesystem>
#include <string>

namespace nacre {

/// The folder with optical constants and other data: the environment variable NACRE_DATA_DIR if it
/// is set; else data/ in the source tree that this was built from; else share/nacre/data beside the
/// folder of the running program, where `cmake --install` puts it.
/// @throws InputError naming the folders that were tried
std::filesystem::path data_directory();

/// A file in that folder.
/// @throws InputError if it is not there
std::filesystem::path data_file(const std::string& name);

/// A file that is shipped beside that folder, as "paints/metallic-gray.toml".
/// @throws InputError if it is not there
std::filesystem::path shipped_file(const std::string& name);

}  // namespace nacre
