#pragma once

#include <concepts>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>

// A recipe names files of materials, a scene those of meshes, pictures and recipes. Whoever opens a
// text says which files it may name: a text from elsewhere must not reach files that are not its.

namespace nacre {

/// Which files a text may name, and where relative names start. A value.
class References {
 public:
    /// None.
    References();
    /// Those anywhere(), from this folder; none if it is empty.
    template <class Path>
    requires(std::convertible_to<Path, std::filesystem::path> &&
             !std::same_as<std::remove_cvref_t<Path>, References>)
        References(Path&& folder)  // NOLINT: a folder stands for its files
        : References() {
        folder_ = std::forward<Path>(folder);
        allowed_ = folder_.empty() ? Allowed::none : Allowed::anywhere;
    }

    /// Files anywhere, relative names from this folder; empty: from the current one.
    static References anywhere(const std::filesystem::path& folder);
    /// Only files in this folder and below, wherever links lead; empty: the current one.
    static References within(const std::filesystem::path& folder);
    /// What a file that the user opened by name may name: files anywhere, relative names from its
    /// folder. None for a stream (core/file.h), which has no folder.
    static References of_file(const std::filesystem::path& file);
    /// The same for a file that came from elsewhere: only files in its folder and below.
    static References of_untrusted_file(const std::filesystem::path& file);

    /// The same permission for a file that was itself named: relative names start from its folder,
    /// and messages may not quote it.
    References beside(const std::filesystem::path& file) const;
    /// The same permission, where each file that a text names, and each that is named in turn, is shown to
    /// `check` before it is read: what that throws, resolve() throws.
    References checked_by(std::function<void(const std::filesystem::path&)> check) const;
    /// Whether messages about the text may quote it. Not if another text named it, which may name
    /// any file, one that the reader of the message may not be allowed to see among them.
    bool may_quote() const { return !named_; }

    /// The path of a file by its name in the text.
    /// @throws InputError without the name, which the caller knows, if the text may not name it; as the
    ///         function of checked_by()
    std::filesystem::path resolve(const std::filesystem::path& name) const;
    /// The bytes of a file that resolve() found. Read once for all copies of these references: a text
    /// that is read again, with other values in it, means the same files as they were.
    /// @throws InputError as read_file()
    std::shared_ptr<const std::string> read(const std::filesystem::path& path,
                                            std::size_t max_bytes) const;

    friend bool operator==(const References&, const References&) = default;

 private:
    enum class Allowed { none, within_root, anywhere };

    /// What was read; of no account when references are compared.
    struct Contents {
        struct Files;
        std::shared_ptr<Files> files;
        friend bool operator==(const Contents&, const Contents&) { return true; }
    };

    std::filesystem::path permitted(const std::filesystem::path& name) const;

    Contents contents_;
    std::filesystem::path folder_, root_;
    Allowed allowed_ = Allowed::none;
    bool named_ = false;  // by another text
    std::shared_ptr<const std::function<void(const std::filesystem::path&)>> check_;
};

}  // namespace nacre
