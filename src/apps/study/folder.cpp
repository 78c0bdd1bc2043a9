#include "apps/study/folder.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <nlohmann/json.hpp>
#include <system_error>

#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/core/sha256.h"
#include "nacre/core/text.h"
#include "nacre/io/brdf_table_file.h"
#include "nacre/io/image.h"
#include "nacre/io/solved_paint_file.h"

namespace nacre::study {

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr std::uintmax_t kMaxRecordBytes = 1 << 20;

/// What the process that has the lock wrote into its file: its number.
std::string holder(int file) {
    std::array<char, 32> text{};
    const ssize_t size = ::pread(file, text.data(), text.size(), 0);
    const auto pid =
        parse_number({text.data(), static_cast<std::size_t>(std::max<ssize_t>(size, 0))});
    return pid ? fmt::format("process {:.0f}", *pid) : "another process";
}

fs::path page_of(const fs::path& folder) { return folder / "index.html"; }
fs::path results_of(const fs::path& folder) { return folder / "results.json"; }

/// A record, or the results of a study.
bool is_own_json(const std::string& bytes) {
    const json document = json::parse(bytes, nullptr, false);
    return document.is_object() && (document.contains("fingerprint") ||
                                    (document.contains("study") && document.contains("version")));
}

/// As far as that shows in the file; not where it is damaged or cannot be read.
bool is_own(const fs::path& file) {
    try {
        if (file.extension() == ".json") return is_own_json(read_file(file));
        const std::string bytes = read_file(file, io::kMaxImageFileBytes);
        return io::looks_like_solved_paint(bytes) || io::looks_like_brdf_table(bytes) ||
               io::is_own_picture(bytes, file.string());
    } catch (const InputError&) {
        return false;
    }
}

std::string sha256_of(const fs::path& file) {
    return sha256_hex(read_file(file, io::kMaxImageFileBytes));
}

}  // namespace

void make_folder(const fs::path& folder) {
    std::error_code ec;
    fs::create_directories(folder, ec);
    if (ec) {
        throw InputError(
            fmt::format("cannot make the folder '{}': {}", folder.string(), ec.message()));
    }
}

FolderLock::FolderLock(const fs::path& folder) {
    make_folder(folder);
    const auto refuse = [&](const std::string& why) {
        if (file_ >= 0) ::close(file_);
        throw InputError(fmt::format("cannot use the folder '{}': {}", folder.string(), why));
    };
    file_ = ::open((folder / ".lock").c_str(),
                   O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666);
    if (file_ < 0) refuse(std::generic_category().message(errno));
    if (::flock(file_, LOCK_EX | LOCK_NB) != 0) {
        if (errno == EWOULDBLOCK) refuse(fmt::format("a study runs in it, {}", holder(file_)));
        refuse(std::generic_category().message(errno));
    }
    const std::string pid = fmt::format("{}\n", ::getpid());
    // Only for the message of the next one.
    if (::ftruncate(file_, 0) == 0) (void)!::pwrite(file_, pid.data(), pid.size(), 0);
}

FolderLock::~FolderLock() { ::close(file_); }

void check_own(const fs::path& file, const fs::path& companion) {
    std::error_code ec;
    if (!fs::exists(file, ec)) return;
    if (is_own(file) || (!companion.empty() && is_own(companion))) return;
    throw InputError(
        fmt::format("cannot write '{}': there is such a file, which Nacre did not make; rename or "
                    "remove it, or "
                    "choose another folder",
                    file.string()));
}

void check_page(const fs::path& folder) {
    check_own(results_of(folder));
    check_own(page_of(folder), results_of(folder));
}

fs::path write_page(const fs::path& folder, const std::string& html, const json& results) {
    write_file_atomically(results_of(folder), results.dump(2) + "\n");
    write_file_atomically(page_of(folder), html);
    return page_of(folder);
}

void write_record(const fs::path& record_file, json record, const std::string& fingerprint,
                  const std::vector<fs::path>& files) {
    record["fingerprint"] = fingerprint;
    for (const fs::path& file : files) {
        record["sha256"][file.filename().string()] = sha256_of(file);
    }
    write_file_atomically(record_file, record.dump(2) + "\n");
}

json find_record(const fs::path& record_file, const std::string& fingerprint,
                 const std::vector<fs::path>& files) {
    try {
        const json record = json::parse(read_file(record_file, kMaxRecordBytes));
        if (record.at("fingerprint") != fingerprint) return nullptr;
        for (const fs::path& file : files) {
            if (record.at("sha256").at(file.filename().string()) != sha256_of(file)) return nullptr;
        }
        return record;
    } catch (const InputError&) {       // not there: the picture is made again
    } catch (const json::exception&) {  // damaged: likewise
    }
    return nullptr;
}

}  // namespace nacre::study
