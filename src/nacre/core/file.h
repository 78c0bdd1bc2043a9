#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/core/progress.h"

// Files are read with a limit and written whole or not at all.

namespace nacre {

/// The most a text file for people (recipe, scene, table) may hold.
inline constexpr std::uintmax_t kMaxTextFileBytes = std::uintmax_t{64} << 20;

/// The whole contents of a regular file, or of a stream. Pipes and devices of other names are
/// refused, so that no name makes the program wait or read without end.
/// @throws InputError naming the file and the reason: not there, not readable, a folder, a pipe, a
///         device, or longer than max_bytes
/// @throws Error if the user interrupts (core/progress.h) while a stream has nothing to give
std::string read_file(const std::filesystem::path& path,
                      std::uintmax_t max_bytes = kMaxTextFileBytes);

/// Whether a name means a descriptor that the program was started with, which may be a pipe: "-"
/// and "/dev/stdin" the standard input, "/dev/fd/N" any, as shells write `<(command)`.
bool is_stream(const std::filesystem::path& path);

/// Refuses a file that AtomicFile could not write, as far as that shows before there is anything
/// to write: a program calls this before work that takes long. Nothing is made or changed.
/// @throws InputError naming `path` and the reason: no name of a file, a folder, a symbolic link
///         that leads nowhere, what is neither a regular file, a character device nor a pipe, a
///         folder that does not exist, a write-protected file or folder. Permission bits that let
///         nobody write protect from the superuser too.
void check_output_file(const std::filesystem::path& path);

/// The same for a folder that files are to be written into; where it is missing, for making it.
/// @throws InputError naming `path` and the reason
void check_output_folder(const std::filesystem::path& path);

/// A file under construction: write(), then commit(). Until then `path` keeps its old contents, and
/// afterwards it has all of the new ones.
///
/// The bytes go to a file in the same folder that has no name until it is whole (O_TMPFILE), so that
/// nothing is left of it where the program is killed. Where the file system knows no such files it
/// is called .NAME.*.partial.EXTENSION, and the next AtomicFile for the same path removes those whose
/// process is gone. A symbolic link is followed. When `path` is a device, a pipe, such as /dev/null,
/// or an open file of this process, such as /dev/stdout or "-", commit() appends to it instead.
class AtomicFile {
 public:
    enum class Temporary { unnamed_if_possible, named };

    /// Creates the temporary, empty.
    /// @throws InputError as check_output_file()
    /// @throws Error if the temporary cannot be created
    explicit AtomicFile(std::filesystem::path path,
                        Temporary temporary = Temporary::unnamed_if_possible);
    /// Removes the temporary unless it was committed.
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    /// Where the temporary is, for another program that writes it; empty if it has no name.
    const std::filesystem::path& temporary() const { return temporary_name_; }
    /// Appends to the temporary.
    /// @throws Error naming the file and the reason, such as a full disk
    void write(std::string_view bytes);
    /// Waits until what has been written is on the disk.
    /// @throws Error as write()
    void flush();

    /// Puts the temporary in the place of `path`, flushed to the disk first.
    /// @throws Error naming the file and the reason; the old file is then as it was
    void commit();

 private:
    void append_to_target();

    std::filesystem::path path_;    // as the user wrote it, for messages
    std::filesystem::path target_;  // where the links lead
    std::filesystem::path temporary_name_;
    int temporary_ = -1;   // its descriptor
    bool named_ = false;   // whether it stands under its name
    bool replace_ = true;  // false for devices and pipes
};

/// Writes bytes to a file, whole or not at all.
/// @param progress  asked several times a second; once the file is in place it is not
/// @throws InputError, Error as AtomicFile; Stopped if `progress` asks to stop, and the old file is
///         as it was
void write_file_atomically(const std::filesystem::path& path, std::string_view bytes,
                           const Progress& progress = {});

struct FileContents {
    std::filesystem::path path;
    std::string bytes;
};

/// Writes files that belong together: none is replaced before all are on the disk, and then all are at
/// once, so that a kill hardly leaves files of two runs.
/// @throws InputError, Error as AtomicFile
void write_together(const std::vector<FileContents>& files);

/// The folder with optical constants and other data: the environment variable NACRE_DATA_DIR if it
/// is set; else share/data beside this library, as in a Python wheel; data/ in the source tree of
/// which it was built; share/nacre/data beside the folder of the program, as `cmake --install` has it.
/// @throws InputError naming the folders that were tried
std::filesystem::path data_directory();

/// A file in that folder.
/// @throws InputError if it is not there
std::filesystem::path data_file(const std::string& name);

/// A file that is shipped beside that folder, as "paints/metallic-gray.toml".
/// @throws InputError if it is not there
std::filesystem::path shipped_file(const std::string& name);

}  // namespace nacre
