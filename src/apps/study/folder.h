#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

// The folder of a study: one process at a time works in it, and takes up again only what it can
// prove to be its own.

namespace nacre::study {

/// Makes a folder and those above it where they are missing.
/// @throws InputError naming the folder, and why it cannot be made
void make_folder(const std::filesystem::path& folder);

/// Keeps a folder to this process while it lives, by a lock on the file .lock in it, which the
/// system releases when the process ends, however it ends.
class FolderLock {
 public:
    /// Makes the folder if it does not exist.
    /// @throws InputError naming the folder: it cannot be made or locked, or another process, which
    ///         the message names too, has it
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

 private:
    int file_;
};

/// Refuses to replace a file in a study's folder that Nacre did not write: nobody named it. Nacre's
/// own are known by what they hold: pictures by a text in them whose key begins with "nacre:",
/// records and results by their keys, solved paints and tables by their heads; what became damaged,
/// by a companion that shows it.
/// @param companion  a file that is always written along with it, if there is one
/// @throws InputError naming the file
void check_own(const std::filesystem::path& file, const std::filesystem::path& companion = {});

/// The same for what write_page() writes, before the work.
void check_page(const std::filesystem::path& folder);

/// Writes the page of a study, index.html, and its numbers, results.json, each whole or not at all.
/// @return the page's path
std::filesystem::path write_page(const std::filesystem::path& folder, const std::string& html,
                                 const nlohmann::json& results);

/// Writes what is known about finished files, whole or not at all: `record` with a fingerprint of
/// all that they depend on and the SHA-256 of each. To be written after them.
void write_record(const std::filesystem::path& record_file, nlohmann::json record,
                  const std::string& fingerprint, const std::vector<std::filesystem::path>& files);

/// That record; null if there is none of this fingerprint, or one of the files is missing or not the
/// one that it was written for.
nlohmann::json find_record(const std::filesystem::path& record_file, const std::string& fingerprint,
                           const std::vector<std::filesystem::path>& files);

}  // namespace nacre::study
