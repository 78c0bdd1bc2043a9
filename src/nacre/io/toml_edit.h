#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "nacre/io/toml_document.h"

// Changes values in a TOML text and leaves every other byte as it is: comments, order, spaces, line
// ends.

namespace nacre::io {

/// The place of a value: keys of tables and places in lists, from the outermost table inwards.
using TomlPath = std::vector<std::variant<std::string, std::size_t>>;

/// From "layer[0].flakes[1].core.thickness_nm". Keys that are not made of letters, digits, `_` and
/// `-` cannot be written so.
/// @throws DomainError naming the text if it is not such a path
TomlPath parse_toml_path(std::string_view text);

/// A value in TOML syntax, without spaces and comments around it. A text that is none, and begins
/// like none, counts as a text without its quotes: SiO2 is "SiO2".
/// @throws DomainError naming the text if it is neither
std::string toml_value(std::string_view text);

class TomlEditor {
 public:
    struct Edit {
        TomlPath path;
        std::string value;  ///< in TOML syntax
    };

    /// @param filename  for messages
    /// @throws InputError as TomlDocument
    TomlEditor(std::string text, std::string filename);

    const std::string& text() const { return text_; }
    const toml::table& root() const { return document_.root(); }
    /// Null if there is none.
    const toml::node* find(const TomlPath& path) const;
    /// Keys and values of the outermost table's own lines, values as they are written, in order.
    std::vector<std::pair<std::string, std::string>> entries() const;

    /// Puts values in the places of those there are, and adds the others: in a table that is
    /// written inline behind its last entry, else in a line of its own below the last line of the
    /// table that has keys; a table that is missing too, at the end of the text.
    /// @throws DomainError naming the path if an entry of a list is missing, or it names a table or
    ///         a list that is written with headers, or lies in a value that is no table, or is in
    ///         another one of `edits`; InputError if a value is not TOML. The text is then as it was.
    void set(const std::vector<Edit>& edits);

    /// Replaces the entry at `path`, key and value, by others in the same table.
    /// @throws DomainError if there is none; InputError if the result is not TOML. The text is then
    ///         as it was.
    void replace(const TomlPath& path,
                 const std::vector<std::pair<std::string, std::string>>& entries);

 private:
    void become(std::string text);
    void add(const Edit& edit);

    std::string text_, filename_;
    TomlDocument document_;
};

}  // namespace nacre::io
