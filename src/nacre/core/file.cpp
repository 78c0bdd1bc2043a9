#include "nacre/core/file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <system_error>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/core/random.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

std::string reason(int error_number) { return std::generic_category().message(error_number); }

[[noreturn]] void fail(const fs::path& path, int error_number) {
    throw Error(fmt::format("cannot write '{}': {}", path.string(), reason(error_number)));
}

// Closes a file descriptor on every way out.
class Descriptor {
 public:
    explicit Descriptor(int fd) : fd_(fd) {}
    ~Descriptor() {
        if (fd_ >= 0) ::close(fd_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    int get() const { return fd_; }
    bool is_open() const { return fd_ >= 0; }

 private:
    int fd_;
};

// Returns 0 or errno.
int write_all(int fd, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(fd, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return errno;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
}

// Reads until the end or until more than max_bytes have come. Returns 0 or errno.
int read_all(int fd, std::uintmax_t max_bytes, std::string& bytes) {
    constexpr std::size_t kPiece = 1 << 16;
    while (bytes.size() <= max_bytes) {
        const std::size_t size = bytes.size();
        bytes.resize(size + kPiece);
        const ssize_t count = ::read(fd, bytes.data() + size, kPiece);
        const int error_number = errno;
        bytes.resize(size + static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
        if (count == 0) return 0;
        if (count < 0 && error_number != EINTR) return error_number;
    }
    return 0;
}

// Creates a file under a name that did not exist, with the permissions of the user's umask.
fs::path create_temporary(const fs::path& folder, const fs::path& name, const fs::path& path) {
    static const std::uint64_t start = [] {
        timespec now{};
        clock_gettime(CLOCK_REALTIME, &now);
        return hash_of(now.tv_sec, now.tv_nsec, ::getpid());
    }();
    // Long names are cut so that the addition cannot exceed the file system's limit.
    const std::string stem = name.stem().string().substr(0, 180);
    const std::string extension = name.extension().string().substr(0, 40);
    for (std::uint64_t attempt = 0; attempt < 1000; ++attempt) {
        const auto tag = hash_of(start, std::hash<std::string>{}(name.string()), attempt);
        const fs::path temporary =
            folder / fmt::format(".{}.{:016x}.partial{}", stem, tag, extension);
        const Descriptor file(
            ::open(temporary.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666));
        if (file.is_open()) return temporary;
        if (errno != EEXIST) fail(path, errno);
    }
    fail(path, EEXIST);
}

}  // namespace

std::string read_file(const fs::path& path, std::uintmax_t max_bytes) {
    const auto refuse = [&](const std::string& why) {
        throw InputError(fmt::format("cannot read '{}': {}", path.string(), why));
    };
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (!file.is_open()) refuse(reason(errno));
    std::string bytes;
    if (const int error_number = read_all(file.get(), max_bytes, bytes))
        refuse(reason(error_number));
    if (bytes.size() > max_bytes) refuse(fmt::format("longer than {} bytes", max_bytes));
    return bytes;
}

AtomicFile::AtomicFile(fs::path path) : path_(std::move(path)) {
    std::error_code ec;
    target_ = fs::canonical(path_, ec);  // fails if there is no such file yet
    if (ec) target_ = path_;
    const fs::file_status status = fs::status(target_, ec);
    if (path_.empty() || !path_.has_filename() || fs::is_directory(status)) {
        throw InputError(
            fmt::format("cannot write '{}': the name of a file is expected", path_.string()));
    }
    replace_ = !fs::exists(status) || fs::is_regular_file(status);
    fs::path folder = replace_ ? target_.parent_path() : fs::temp_directory_path(ec);
    if (folder.empty()) folder = replace_ ? "." : "/tmp";
    if (!fs::is_directory(folder, ec)) {
        throw InputError(fmt::format("cannot write '{}': there is no folder '{}'", path_.string(),
                                     folder.string()));
    }
    temporary_ = create_temporary(folder, target_.filename(), path_);
}

AtomicFile::~AtomicFile() {
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void AtomicFile::commit() {
    if (!replace_) {
        std::string bytes;
        const Descriptor from(::open(temporary_.c_str(), O_RDONLY | O_CLOEXEC));
        const Descriptor to(::open(target_.c_str(), O_WRONLY | O_CLOEXEC));
        if (!from.is_open() || !to.is_open()) fail(path_, errno);
        int error_number = read_all(from.get(), UINTMAX_MAX - (1 << 16), bytes);
        if (!error_number) error_number = write_all(to.get(), bytes);
        if (error_number) fail(path_, error_number);
        return;
    }
    {
        const Descriptor file(::open(temporary_.c_str(), O_RDONLY | O_CLOEXEC));
        if (!file.is_open()) fail(path_, errno);
        struct stat old_file {};
        if (::stat(target_.c_str(), &old_file) == 0) {
            // Keeps the old file's permissions; a failure (we do not own the file) is ignored.
            (void)::fchmod(file.get(), old_file.st_mode & 07777);
        }
        // Without this a power cut may leave the new name with no contents.
        if (::fsync(file.get()) != 0) fail(path_, errno);
    }
    if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail(path_, errno);
    const fs::path folder = temporary_.parent_path();
    temporary_.clear();
    // The file is in place; some file systems cannot flush a folder, which is no failure.
    const Descriptor entry(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (entry.is_open()) (void)::fsync(entry.get());
}

void write_file_atomically(const fs::path& path, std::string_view bytes) {
    AtomicFile file(path);
    {
        const Descriptor out(::open(file.temporary_path().c_str(), O_WRONLY | O_CLOEXEC));
        if (!out.is_open()) fail(path, errno);
        if (const int error_number = write_all(out.get(), bytes)) fail(path, error_number);
    }
    file.commit();
}

namespace fs = std::filesystem;

fs::path data_directory() {
    std::error_code ec;
    if (const char* chosen = std::getenv("NACRE_DATA_DIR"); chosen && *chosen) {
        // No fallback: results from other data than the user asked for would go unnoticed.
        if (fs::is_directory(chosen, ec)) return chosen;
        throw InputError(fmt::format("NACRE_DATA_DIR = '{}' is not a folder", chosen));
    }
    std::vector<fs::path> candidates = {NACRE_SOURCE_DATA_DIR};
    const fs::path program = fs::read_symlink("/proc/self/exe", ec);
    if (!ec) {
        candidates.push_back(program.parent_path().parent_path() / NACRE_INSTALL_DATA_DIR / "data");
    }
    std::string tried;
    for (const fs::path& candidate : candidates) {
        if (fs::is_directory(candidate, ec)) return candidate;
        tried += (tried.empty() ? "'" : ", '") + candidate.string() + "'";
    }
    throw InputError(
        fmt::format("Nacre's data folder was not found; tried {}. Set NACRE_DATA_DIR.", tried));
}

namespace {

fs::path file_in(const fs::path& folder, const std::string& name, const char* what) {
    std::error_code ec;
    if (!fs::is_regular_file(folder / name, ec)) {
        throw InputError(
            fmt::format("there is no file '{}' in {} '{}'", name, what, folder.string()));
    }
    return folder / name;
}

}  // namespace

fs::path data_file(const std::string& name) {
    return file_in(data_directory(), name, "the data folder");
}

fs::path shipped_file(const std::string& name) {
    return file_in(fs::absolute(data_directory()).lexically_normal().parent_path(), name,
                   "the folder with Nacre's data,");
}

}  // namespace nacre
