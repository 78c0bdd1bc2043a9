#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

// Files are read with a limit and written whole or not at all.

namespace nacre {

/// The most a text file for people (recipe, scene, table) may hold.
inline constexpr std::uintmax_t kMaxTextFileBytes = std::uintmax_t{64} << 20;

/// The whole contents of a file.
/// @throws InputError naming the file and the reason: not there, not readable, a folder, or longer
/// than max_bytes
std::string read_file(const std::filesystem::path& path,
                      std::uintmax_t max_bytes = kMaxTextFileBytes);

/// A file under construction: write to temporary_path(), then commit(). Until then `path` keeps
/// its old contents, and afterwards it has all of the new ones. Meant for libraries that open files
/// by name (HDF5, OpenEXR).
///
/// The temporary stands in the same folder, with the same extension. A symbolic link is followed.
/// When `path` is a device or a pipe, such as /dev/null, commit() copies into it instead.
class AtomicFile {
 public:
    /// Creates the temporary, empty.
    /// @throws InputError if the folder does not exist or `path` is a folder
    /// @throws Error if the temporary cannot be created
    explicit AtomicFile(std::filesystem::path path);
    /// Removes the temporary unless it was committed.
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    const std::filesystem::path& temporary_path() const { return temporary_; }

    /// Puts the temporary in the place of `path`, flushed to the disk first.
    /// @throws Error naming the file and the reason; the old file is then as it was
    void commit();

 private:
    std::filesystem::path path_;    // as the user wrote it, for messages
    std::filesystem::path target_;  // where the links lead
    std::filesystem::path temporary_;
    bool replace_ = true;  // false for devices and pipes
};

/// Writes bytes to a file, whole or not at all.
/// @throws InputError, Error as AtomicFile
void write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

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
