#include "nacre/core/file.h"

#include <dlfcn.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <optional>
#include <system_error>
#include <tuple>
#include <utility>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/core/progress.h"
#include "nacre/core/random.h"
#include "nacre/core/text.h"

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

// Reads until the end or until more than max_bytes have come, after `wait` each time. Returns 0 or
// errno.
int read_all(
    int fd, std::uintmax_t max_bytes, std::string& bytes,
    const std::function<void()>& wait = [] {}) {
    constexpr std::size_t kPiece = 1 << 16;
    while (bytes.size() <= max_bytes) {
        const std::size_t size = bytes.size();
        wait();
        bytes.resize(size + kPiece);
        const ssize_t count = ::read(fd, bytes.data() + size, kPiece);
        const int error_number = errno;
        bytes.resize(size + static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
        if (count == 0) return 0;
        if (count < 0 && error_number != EINTR && error_number != EAGAIN) return error_number;
    }
    return 0;
}

[[noreturn]] void refuse(const fs::path& path, const std::string& why) {
    throw InputError(fmt::format("cannot write '{}': {}", path.string(), why));
}

// Whether the permissions of a file or folder that exists, or its file system, forbid writing.
// The superuser is asked for permission by nobody; bits that let nobody write are a wish all the
// same.
bool is_write_protected(const fs::path& path) {
    struct stat status {};
    return ::faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0 ||
           (::stat(path.c_str(), &status) == 0 && (status.st_mode & 0222) == 0);
}

// Throws unless files can be made in the folder.
void check_folder(const fs::path& path, const fs::path& folder) {
    std::error_code ec;
    if (!fs::exists(folder, ec)) {
        refuse(path, fmt::format("there is no folder '{}'", folder.string()));
    }
    if (!fs::is_directory(folder, ec)) {
        refuse(path, fmt::format("'{}' is no folder", folder.string()));
    }
    if (is_write_protected(folder)) {
        refuse(path, fmt::format("the folder '{}' is write-protected", folder.string()));
    }
}

bool is_dangling_link(const fs::path& path) {
    std::error_code ec;
    return fs::is_symlink(fs::symlink_status(path, ec)) && !fs::exists(fs::status(path, ec));
}

// Names of open files. A regular file behind them belongs to whoever opened it, who may append to
// it: `nacre ... -o /dev/stdout >> log`.
bool is_open_file(const fs::path& path) {
    const std::string text = path.lexically_normal().string();
    return text == "/dev/stdout" || text == "/dev/stderr" || text.starts_with("/dev/fd/") ||
           text.starts_with("/proc/self/fd/");
}

fs::path folder_of(const fs::path& path) {
    const fs::path folder = path.parent_path();
    return folder.empty() ? "." : folder;
}

// Where and how the bytes for a path go.
struct Target {
    fs::path path;
    bool replace = true;  // false: append to what is there
};

Target checked_target(const fs::path& path) {
    std::error_code ec;
    if (path == "-") return {"/dev/stdout", false};
    const fs::file_status status = fs::status(path, ec);
    if (!path.has_filename() || fs::is_directory(status)) {
        refuse(path, "the name of a file is expected");
    }
    if (is_dangling_link(path)) refuse(path, "is a symbolic link that leads nowhere");
    if (!fs::exists(status)) {
        check_folder(path, folder_of(path));
        return {path};
    }
    if (!fs::is_regular_file(status) && !fs::is_character_file(status) && !fs::is_fifo(status)) {
        refuse(path, "is neither a regular file, a character device nor a pipe");
    }
    if (is_write_protected(path)) refuse(path, "is write-protected");
    if (!fs::is_regular_file(status) || is_open_file(path)) return {path, false};
    const fs::path target = fs::canonical(path, ec);
    if (ec) refuse(path, ec.message());
    check_folder(path, target.parent_path());
    return {target};
}

/// Numbers of processes mean the same to all who share this: the running system and, in it, the
/// namespace of process numbers.
std::uint64_t processes_known_here() {
    static const std::uint64_t here = [] {
        std::string text;
        const Descriptor boot(::open("/proc/sys/kernel/random/boot_id", O_RDONLY | O_CLOEXEC));
        if (boot.is_open()) (void)read_all(boot.get(), 64, text);
        std::error_code ec;
        text += fs::read_symlink("/proc/self/ns/pid", ec).string();
        return std::hash<std::string>{}(text);
    }();
    return here;
}

/// Names of temporaries for one file: ".STEM.HERE-PROCESS-TAG.partial.EXTENSION".
class TemporaryNames {
 public:
    explicit TemporaryNames(const fs::path& target)
        : folder_(folder_of(target)),
          // Long names are cut so that the addition cannot exceed the file system's limit.
          begin_(fmt::format(".{}.{:016x}-", target.stem().string().substr(0, 150),
                             processes_known_here())),
          end_(".partial" + target.extension().string().substr(0, 40)) {}

    fs::path next() {
        static const std::uint64_t start = [] {
            timespec now{};
            clock_gettime(CLOCK_REALTIME, &now);
            return hash_of(now.tv_sec, now.tv_nsec, ::getpid());
        }();
        static std::atomic<std::uint64_t> count = 0;
        return folder_ / fmt::format("{}{}-{:08x}{}", begin_, ::getpid(),
                                     hash_of(start, ++count) & 0xffffffff, end_);
    }

    /// Removes those whose process is gone. What cannot be removed stays.
    void remove_abandoned() const {
        std::error_code ec;
        for (fs::directory_iterator it(folder_, ec), last; !ec && it != last; it.increment(ec)) {
            const std::string name = it->path().filename().string();
            if (!name.starts_with(begin_) || !name.ends_with(end_)) continue;
            const long process = std::strtol(name.c_str() + begin_.size(), nullptr, 10);
            if (process > 0 && ::kill(static_cast<pid_t>(process), 0) != 0 && errno == ESRCH) {
                ::unlink(it->path().c_str());
            }
        }
    }

 private:
    fs::path folder_;
    std::string begin_, end_;
};

constexpr int kMaxAttempts = 1000;  // to find a name that nobody has

// Creates a file under a name that did not exist, with the permissions of the user's umask.
std::pair<int, fs::path> create_named(const fs::path& target, const fs::path& path) {
    TemporaryNames names(target);
    names.remove_abandoned();
    for (int attempt = 0; attempt < kMaxAttempts; ++attempt) {
        fs::path name = names.next();
        const int fd = ::open(name.c_str(), O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC, 0666);
        if (fd >= 0) return {fd, std::move(name)};
        if (errno != EEXIST) fail(path, errno);
    }
    fail(path, EEXIST);
}

/// The name under which this process sees an open file, by which one without a name gets its own.
std::string name_of_descriptor(int fd) { return fmt::format("/proc/self/fd/{}", fd); }

// Creates a file without a name; -1 where that, or naming it later, does not work.
int create_unnamed(const fs::path& folder) {
    const int fd = ::open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0666);
    if (fd < 0) return -1;
    struct stat status {};
    if (::lstat(name_of_descriptor(fd).c_str(), &status) == 0) return fd;
    ::close(fd);  // no /proc here
    return -1;
}

// Gives a file without a name one that did not exist. Returns 0 or errno.
int link_to(int fd, const fs::path& name) {
    return ::linkat(AT_FDCWD, name_of_descriptor(fd).c_str(), AT_FDCWD, name.c_str(),
                    AT_SYMLINK_FOLLOW) == 0
               ? 0
               : errno;
}

/// The descriptor that a name stands for, as is_stream() has it.
std::optional<int> named_descriptor(const std::string& name) {
    if (name == "-" || name == "/dev/stdin") return STDIN_FILENO;
    for (const std::string_view folder : {"/dev/fd/", "/proc/self/fd/"}) {
        if (!name.starts_with(folder)) continue;
        const std::string_view digits = std::string_view(name).substr(folder.size());
        const auto number = parse_number(digits);
        if (!number || digits.find_first_not_of("0123456789") != std::string_view::npos) continue;
        if (*number <= INT_MAX) return static_cast<int>(*number);
    }
    return std::nullopt;
}

/// A regular file that this process has open is written through its own descriptor: whoever else
/// writes there goes on behind the bytes, and not over them.
int open_to_append(const fs::path& path) {
    const std::string name = path.lexically_normal().string();
    const std::optional<int> open = name == "/dev/stdout"   ? STDOUT_FILENO
                                    : name == "/dev/stderr" ? STDERR_FILENO
                                                            : named_descriptor(name);
    struct stat status {};
    if (open && ::fstat(*open, &status) == 0 && S_ISREG(status.st_mode) &&
        (::fcntl(*open, F_GETFL) & O_ACCMODE) != O_RDONLY) {
        const int fd = ::fcntl(*open, F_DUPFD_CLOEXEC, 0);
        if (fd >= 0 && ::lseek(fd, 0, SEEK_END) >= 0) return fd;
        if (fd >= 0) ::close(fd);
    }
    return ::open(path.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
}

/// Why a file of this mode is not read; empty if it is.
std::string unreadable_kind(mode_t mode, bool stream) {
    if (S_ISREG(mode)) return {};
    if (S_ISDIR(mode)) return reason(EISDIR);
    const bool pipe = S_ISFIFO(mode) || S_ISSOCK(mode);
    if (!pipe) return "is a device";
    return stream ? "" : "is a pipe; only the standard input, -, may be one";
}

/// Waits until a pipe has bytes, or ends.
void wait_for_bytes(int fd, const fs::path& path) {
    constexpr int kPatience_ms = 100;
    pollfd waiting{fd, POLLIN, 0};
    while (::poll(&waiting, 1, kPatience_ms) <= 0) {
        if (interrupt_requested()) {
            throw Error(fmt::format("stopped while waiting for '{}'", path.string()));
        }
    }
}

}  // namespace

bool is_stream(const fs::path& path) { return named_descriptor(path.string()).has_value(); }

std::string read_file(const fs::path& path, std::uintmax_t max_bytes) {
    const auto refuse_input = [&](const std::string& why) {
        throw InputError(fmt::format("cannot read '{}': {}", path.string(), why));
    };
    const std::optional<int> stream = named_descriptor(path.string());
    // Without O_NONBLOCK, opening a pipe waits for somebody to write into it.
    const Descriptor file(stream
                              ? ::fcntl(*stream, F_DUPFD_CLOEXEC, 0)
                              : ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY));
    if (!file.is_open()) refuse_input(reason(errno));
    struct stat status {};
    if (::fstat(file.get(), &status) != 0) refuse_input(reason(errno));
    if (const std::string why = unreadable_kind(status.st_mode, stream.has_value()); !why.empty()) {
        refuse_input(why);
    }
    const auto wait = [&] {
        if (!S_ISREG(status.st_mode)) wait_for_bytes(file.get(), path);
    };
    std::string bytes;
    if (const int error_number = read_all(file.get(), max_bytes, bytes, wait))
        refuse_input(reason(error_number));
    if (bytes.size() > max_bytes) refuse_input(fmt::format("longer than {} bytes", max_bytes));
    return bytes;
}

void check_output_file(const fs::path& path) { checked_target(path); }

void check_output_folder(const fs::path& path) {
    if (path.empty()) refuse(path, "the name of a folder is expected");
    std::error_code ec;
    for (fs::path part = path;; part = folder_of(part)) {
        if (is_dangling_link(part)) {
            refuse(path, fmt::format("'{}' is a symbolic link that leads nowhere", part.string()));
        }
        // Ends at the root or at the working folder, which exist.
        if (fs::exists(part, ec) || part == folder_of(part)) return check_folder(path, part);
    }
}

AtomicFile::AtomicFile(fs::path path, Temporary temporary) : path_(std::move(path)) {
    const Target target = checked_target(path_);
    target_ = target.path;
    replace_ = target.replace;
    std::error_code ec;
    fs::path folder = replace_ ? folder_of(target_) : fs::temp_directory_path(ec);
    if (folder.empty()) folder = "/tmp";
    if (temporary == Temporary::unnamed_if_possible) temporary_ = create_unnamed(folder);
    if (temporary_ >= 0) return;
    std::tie(temporary_, temporary_name_) = create_named(folder / target_.filename(), path_);
    named_ = true;
}

AtomicFile::~AtomicFile() {
    if (temporary_ >= 0) ::close(temporary_);
    if (named_) ::unlink(temporary_name_.c_str());
}

void AtomicFile::write(std::string_view bytes) {
    if (const int error_number = write_all(temporary_, bytes)) fail(path_, error_number);
}

void AtomicFile::flush() {
    if (::fdatasync(temporary_) != 0) fail(path_, errno);
}

void AtomicFile::append_to_target() {
    std::string bytes;
    const Descriptor to(open_to_append(target_));
    if (!to.is_open() || ::lseek(temporary_, 0, SEEK_SET) != 0) fail(path_, errno);
    int error_number = read_all(temporary_, UINTMAX_MAX - (1 << 16), bytes);
    if (!error_number) error_number = write_all(to.get(), bytes);
    if (error_number) fail(path_, error_number);
}

void AtomicFile::commit() {
    if (!replace_) return append_to_target();
    struct stat old_file {};
    const bool is_new = ::stat(target_.c_str(), &old_file) != 0;
    if (!is_new) {
        // Keeps the old file's permissions; a failure (we do not own the file) is ignored.
        (void)::fchmod(temporary_, old_file.st_mode & 07777);
    }
    // Without this a power cut may leave the new name with no contents.
    if (::fsync(temporary_) != 0) fail(path_, errno);
    bool in_place = !named_ && is_new && link_to(temporary_, target_) == 0;
    TemporaryNames names(target_);
    for (int attempt = 0; !in_place && !named_; ++attempt) {
        // A name cannot be given in place of another file: only renaming replaces.
        temporary_name_ = names.next();
        const int error_number = link_to(temporary_, temporary_name_);
        named_ = error_number == 0;
        if (!named_ && (error_number != EEXIST || attempt == kMaxAttempts)) {
            fail(path_, error_number);
        }
    }
    if (!in_place) {
        if (::rename(temporary_name_.c_str(), target_.c_str()) != 0) fail(path_, errno);
        named_ = false;
    }
    // The file is in place; some file systems cannot flush a folder, which is no failure.
    const Descriptor entry(::open(folder_of(target_).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (entry.is_open()) (void)::fsync(entry.get());
}

void write_together(const std::vector<FileContents>& files) {
    const InterruptHandler uninterrupted;
    std::vector<std::unique_ptr<AtomicFile>> together;
    for (const FileContents& file : files) {
        together.push_back(std::make_unique<AtomicFile>(file.path));
        together.back()->write(file.bytes);
    }
    // What takes long before the first is replaced.
    for (const auto& file : together) file->flush();
    for (const auto& file : together) file->commit();
}

void write_file_atomically(const fs::path& path, std::string_view bytes, const Progress& progress) {
    // A signal waits for the few milliseconds, or it would leave the temporary behind. Commands that
    // heed signals already have a handler, which this one leaves alone.
    const InterruptHandler uninterrupted;
    AtomicFile file(path);
    // A slow disk takes a while to flush a gigabyte: what is flushed piece by piece can be stopped.
    constexpr std::size_t kPiece = 1 << 24;
    SharedProgress work(progress, 1);
    while (progress && bytes.size() > kPiece) {
        work.add(0);
        work.throw_if_stopped("writing the file");
        file.write(bytes.substr(0, kPiece));
        file.flush();
        bytes.remove_prefix(kPiece);
    }
    file.write(bytes);
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
    std::vector<fs::path> candidates;
    Dl_info library;
    if (dladdr(reinterpret_cast<const void*>(&data_directory), &library) && library.dli_fname) {
        // Of a program it is the name by which it was called, which says nothing of its folder.
        const fs::path file = library.dli_fname;
        if (file.is_absolute()) candidates.push_back(file.parent_path() / "share" / "data");
    }
    candidates.push_back(NACRE_SOURCE_DATA_DIR);
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
