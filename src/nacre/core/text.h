#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// Text that people write: numbers and lists, independent of the locale, and names that are nearly
// right.

namespace nacre {

/// Without spaces at both ends.
inline std::string_view trimmed(std::string_view text) {
    constexpr std::string_view space = " \t\r\n\f\v";
    const auto first = text.find_first_not_of(space);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(space) - first + 1);
}

/// Reads a number at the front of `text` and removes it; nothing for anything that is not a finite
/// number in decimal or exponent form.
inline std::optional<double> take_number(std::string_view& text) {
    std::string_view rest = text;
    if (!rest.empty() && rest.front() == '+') {
        rest.remove_prefix(1);
        if (!rest.empty() && rest.front() == '-') return std::nullopt;
    }
    double value = 0;
    const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
    if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
    text = rest.substr(static_cast<std::size_t>(end - rest.data()));
    return value;
}

/// All of `text`, spaces at its ends aside, as a finite number.
inline std::optional<double> parse_number(std::string_view text) {
    text = trimmed(text);
    const auto value = take_number(text);
    return value && text.empty() ? value : std::nullopt;
}

/// The pieces between separators: at least one, possibly empty.
inline std::vector<std::string_view> split(std::string_view text, char separator) {
    std::vector<std::string_view> pieces;
    while (true) {
        const auto end = text.find(separator);
        pieces.push_back(text.substr(0, end));
        if (end == std::string_view::npos) return pieces;
        text.remove_prefix(end + 1);
    }
}

/// The pieces between runs of spaces; none where there is nothing else.
inline std::vector<std::string_view> words(std::string_view text) {
    std::vector<std::string_view> pieces;
    for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
        pieces.push_back(trimmed(text.substr(0, text.find_first_of(" \t"))));
        text.remove_prefix(std::min(text.size(), text.find_first_of(" \t")));
    }
    return pieces;
}

/// With small letters of the English alphabet.
std::string lowercase(std::string_view text);

/// The mark with which some editors begin a file of UTF-8.
inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// Without that mark.
inline std::string_view without_byte_order_mark(std::string_view text) {
    return text.starts_with(kByteOrderMark) ? text.substr(kByteOrderMark.size()) : text;
}

/// Where a text is not UTF-8: the position of the first byte that is part of no character.
std::optional<std::size_t> first_not_utf8(std::string_view text);

/// Whether bytes are a text in UTF-16: by its mark, or by zeros in every other byte of its beginning.
bool looks_like_utf16(std::string_view bytes);

/// Refuses a text in another encoding, which editors and spreadsheets write where they are not told
/// otherwise. UTF-8 may begin with a byte order mark.
/// @param filename  for the message, which quotes nothing of the text
/// @throws InputError naming the file, line and column, what the text seems to be (UTF-16, Latin-1
///         or binary data) and how to save it
void require_utf8(std::string_view text, const std::string& filename);

/// How deep arrays and objects of a JSON text lie within each other, to be asked before it is parsed:
/// 0 of a bare number, 1 of `[]`. Of text that is no JSON at least what a parser meets before it
/// finds that out. Linear in the text's length.
std::size_t json_nesting(std::string_view text);

/// As it may go to a terminal: control characters (C0, DEL and C1, which move the cursor, change
/// colours or begin a line) become escape sequences of C, such as `\x1b`.
std::string printable(std::string_view text);
/// The same for a table or a message of several lines, whose line ends and tabs stay.
std::string printable_lines(std::string_view text);

/// A copy in which `from` (not empty) is replaced by `to` wherever it stands.
std::string replaced(std::string_view text, std::string_view from, std::string_view to);

/// For messages: at most `longest` bytes of a text, cut between characters of UTF-8, control
/// characters replaced by `stand_in`, so that a message stays one line.
std::string excerpt(std::string_view text, std::size_t longest = 60, char stand_in = '?');

/// Fewest insertions, deletions, substitutions and swaps of neighbours that turn a into b, no
/// letter being changed twice: the optimal string alignment distance. Bytes are compared, upper
/// and lower case count as equal.                                                [damerau-1964]
int edit_distance(std::string_view a, std::string_view b);

/// The candidate nearest to `name` if it is near enough to be a typing error (at most a third
/// of the letters differ, and at least one edit is allowed); the first of several equally near.
std::optional<std::string> closest_match(std::string_view name,
                                         std::span<const std::string> candidates);

/// " (did you mean 'x'?)", or nothing: to append to a message. Names that go on where this one ends,
/// at an underscore, are looked for before typing errors: 'thickness_um' for "thickness",
/// 'TiO2_anatase' or 'TiO2_rutile_o' for "TiO2".
std::string did_you_mean(std::string_view name, std::span<const std::string> candidates);

}  // namespace nacre
