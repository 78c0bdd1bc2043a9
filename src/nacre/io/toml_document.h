#pragma once

#include <toml++/toml.h>

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "nacre/core/references.h"
#include "nacre/io/file_kind.h"

namespace nacre::io {

/// Characters that a recipe or a scene may have: a megabyte.
inline constexpr std::size_t kMaxTextBytes = 1 << 20;

/// How deep tables and arrays may lie in each other, and how many parts a dotted key may have. What
/// is deeper is refused before it is parsed: parser and tree are recursive.
inline constexpr int kMaxTomlNesting = 32;

/// Characters of a key or a value in a message.
inline constexpr std::size_t kMaxShownLength = 60;

/// A parsed TOML text: its name for messages, the files that it may name, and the place of each
/// key.
class TomlDocument {
 public:
    /// @param kind  kind_of_bytes() of the text, where that is known already
    /// @throws InputError with file, line and column if the text is not TOML, not UTF-8, too large or
    ///         nested too deeply; naming what it is instead where that shows (io/file_kind.h)
    TomlDocument(std::string_view text, std::string filename, References references,
                 std::optional<FileKind> kind = {});

    /// It is moved, not copied: a copy of the tree has no places.
    TomlDocument(TomlDocument&&) = default;
    TomlDocument& operator=(TomlDocument&&) = default;

    /// The document of a file that has been told apart; where it has none, one is made of its bytes.
    /// @throws InputError as above where they are no TOML
    static std::shared_ptr<TomlDocument> of(const TypedFile& file);

    const toml::table& root() const { return root_; }
    const std::string& filename() const { return filename_; }
    const References& references() const { return references_; }
    void set_references(References references) { references_ = std::move(references); }

    /// "file:line:column: ".
    std::string place(const toml::source_region& where) const;
    /// Remembers where `key` (its full path) stands.
    void note(const std::string& key, const toml::source_region& where);
    /// The place of a key, or of the nearest table around it that is known.
    std::string location(std::string key) const;

 private:
    void refuse_other_kind(FileKind kind) const;

    toml::table root_;
    std::string filename_;
    References references_;
    std::map<std::string, toml::source_region> places_;
};

/// Gives the message of a DomainError ("key = value: ...") the place of its key in the file.
/// @throws InputError always
[[noreturn]] void rethrow_with_location(const TomlDocument& document, const std::string& message);

}  // namespace nacre::io
