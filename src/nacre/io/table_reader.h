#pragma once

#include <toml++/toml.h>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/io/toml_document.h"
#include "nacre/spectra/spectrum.h"

// Reads the tables of a TOML text so that whatever is wrong is refused with a message of the form
//
//   paint.toml:7:16: layer[0].thickness_um = -3: must be a number in (0, 1000000] um
//
// Arrays are counted from 0. Values in messages are shortened. Of a text that may not be quoted
// (References::may_quote()) they show places, the keys that are allowed and numbers, nothing else.

namespace nacre::io {

/// One table. The keys that it may have are named when it is opened; others are refused at once,
/// with the nearest of those allowed as a suggestion.
class TableReader {
 public:
    using Keys = std::vector<std::string>;

    TableReader(TomlDocument& document, const Keys& allowed);  ///< the outermost table
    /// No keys at all means that they are not known yet: see narrowed().
    TableReader(TomlDocument& document, const toml::table& table, std::string path,
                const Keys& allowed);

    /// The same table once it is known, from a `type` in it, which keys it may have.
    TableReader narrowed(const Keys& allowed) const;
    /// The same place with other contents, which must outlive the reader.
    TableReader on(const toml::table& contents, const Keys& allowed) const;
    const toml::table& contents() const { return *table_; }
    /// The keys that it has, for tables whose keys are names.
    std::vector<std::string> keys() const;

    bool has(std::string_view key) const { return find(key) != nullptr; }

    /// A finite number in the range.
    double number(std::string_view key, const Range& range) const;
    /// A finite number, or refused with the words for what is allowed.
    double number(std::string_view key, std::string_view allowed) const;
    /// Text of 1 to `max_length` characters (0 to `max_length` for text_or).
    std::string text(std::string_view key, std::size_t max_length) const;
    std::string text_or(std::string_view key, std::string fallback, std::size_t max_length) const;
    bool flag_or(std::string_view key, bool fallback) const;
    /// Numbers in the range, between `min_size` and `max_size` of them.
    std::vector<double> numbers(std::string_view key, const Range& range, std::size_t min_size,
                                std::size_t max_size) const;
    /// Texts of 1 to `max_length` characters, between `min_size` and `max_size` of them.
    std::vector<std::string> texts(std::string_view key, std::size_t max_length,
                                   std::size_t min_size, std::size_t max_size) const;
    /// One of the given words; returns which.
    std::size_t choice(std::string_view key, const std::vector<std::string>& words) const;

    TableReader table(std::string_view key, const Keys& allowed) const;
    std::optional<TableReader> table_if_present(std::string_view key, const Keys& allowed) const;
    /// The entries of an array of tables; empty if the key is absent.
    std::vector<TableReader> tables(std::string_view key, std::size_t max_size,
                                    const Keys& allowed) const;

    bool is_table(std::string_view key) const;
    bool is_array(std::string_view key) const;
    bool is_text(std::string_view key) const;

    /// Refuses the value of a key; `why` completes "key = value: ...".
    [[noreturn]] void fail(std::string_view key, std::string_view why) const;
    /// Refuses this table as a whole.
    [[noreturn]] void fail(std::string_view why) const;

    /// Full path of a key of this table.
    std::string path_of(std::string_view key) const;
    TomlDocument& document() const { return *document_; }

 private:
    bool may_have(std::string_view key) const;
    const toml::node* find(std::string_view key) const;
    const toml::node& require(std::string_view key, std::string_view what) const;
    double as_number(const toml::node& node, const std::string& key, const Range& range) const;
    [[noreturn]] void fail_at(const std::string& key, const toml::node& node,
                              std::string_view why) const;

    TomlDocument* document_;
    const toml::table* table_;
    std::string path_;
    Keys allowed_;
};

/// A number, { wavelengths_nm = [...], values = [...] }, or the path of a CSV file with the columns
/// wavelength_nm and one of values; every value in the range.
spectra::Spectrum read_spectrum(const TableReader& table, std::string_view key, const Range& range);

/// A reflectance in [0, 1]: a spectrum as above, or [r, g, b] in linear Rec. 709, for which a
/// smooth spectrum of that colour is taken (spectra::reflectance_from_rec709).
spectra::Spectrum read_reflectance(const TableReader& table, std::string_view key);

/// Wavelengths in nm that increase from each to the next.
std::vector<double> read_wavelengths(const TableReader& table, std::string_view key);

}  // namespace nacre::io
