#include "nacre/io/text_file.h"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "nacre/core/error.h"

namespace nacre::io {

namespace fs = std::filesystem;

std::string read_file(const fs::path& path, std::size_t most_bytes) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) {
        throw InputError(fmt::format("{}: no such file", path.string()));
    }
    if (!fs::is_regular_file(status)) {
        throw InputError(fmt::format("{}: not a regular file", path.string()));
    }
    const std::uintmax_t size = fs::file_size(path, error);
    if (error) throw InputError(fmt::format("{}: {}", path.string(), error.message()));
    if (size > most_bytes) {
        throw InputError(fmt::format("{}: has {} bytes; at most {} are allowed", path.string(),
                                     size, most_bytes));
    }
    std::ifstream in(path, std::ios::binary);
    std::string bytes(size, '\0');
    in.read(bytes.data(), static_cast<std::streamsize>(size));
    if (!in) throw InputError(fmt::format("{}: cannot be read", path.string()));
    return bytes;
}

void write_atomically(const fs::path& path, const std::function<void(const fs::path&)>& write) {
    if (fs::is_directory(path)) {
        throw Error(fmt::format("{}: cannot be written: it is a folder", path.string()));
    }
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    if (!fs::is_directory(folder)) {
        throw Error(fmt::format("{}: cannot be written: there is no folder {}", path.string(),
                                folder.string()));
    }
    // Unique among processes and threads; the extension stays, some writers go by it.
    static std::atomic<unsigned> serial{0};
    fs::path temporary = path;
    temporary.replace_filename(fmt::format(".{}.{}.{}{}", path.stem().string(), ::getpid(),
                                           serial++, path.extension().string()));
    std::error_code ignored;
    try {
        write(temporary);
    } catch (...) {
        fs::remove(temporary, ignored);
        throw;
    }
    std::error_code error;
    fs::rename(temporary, path, error);
    if (error) {
        fs::remove(temporary, ignored);
        throw Error(fmt::format("{}: cannot be written: {}", path.string(), error.message()));
    }
}

void write_atomically(const fs::path& path, std::string_view bytes) {
    write_atomically(path, [&](const fs::path& temporary) {
        std::ofstream out(temporary, std::ios::binary);
        out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        out.close();
        if (!out) {
            throw Error(
                fmt::format("{}: cannot be written: {}", path.string(), std::strerror(errno)));
        }
    });
}

}  // namespace nacre::io
