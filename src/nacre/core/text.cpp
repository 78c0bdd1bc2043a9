#include "nacre/core/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "nacre/core/error.h"

namespace nacre {
namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

// Longer texts are not compared: no key is so long, and the distance takes time in proportion to
// the product of the lengths.
constexpr std::size_t kMaxNameLength = 100;

/// Bytes of the control character that a text starts with: C0 and DEL as in ASCII, C1 as UTF-8 (C2
/// 80 to C2 9F); 0 if it is none.
std::size_t control_size(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    if (text.empty()) return 0;
    if (byte(0) < 0x20 || byte(0) == 0x7f) return 1;
    if (text.size() < 2 || byte(0) != 0xc2) return 0;
    return byte(1) >= 0x80 && byte(1) < 0xa0 ? 2 : 0;
}

std::size_t sequence_size(unsigned char lead) {
    return lead < 0x80   ? 1
           : lead < 0xc2 ? 0
           : lead < 0xe0 ? 2
           : lead < 0xf0 ? 3
           : lead < 0xf5 ? 4
                         : 0;
}

/// Bytes of the character of UTF-8 that a text starts with; 0 if its bytes are none. A stray byte
/// from 80 to 9F is a C1 control character to a terminal that is not set to UTF-8.
std::size_t character_size(std::string_view text) {
    const std::size_t size = sequence_size(static_cast<unsigned char>(text[0]));
    if (size == 0 || size > text.size()) return 0;
    for (std::size_t i = 1; i < size; ++i) {
        if ((static_cast<unsigned char>(text[i]) & 0xc0) != 0x80) return 0;
    }
    return size;
}

std::string escaped(std::string_view text, std::string_view kept) {
    std::string result;
    while (!text.empty()) {
        const std::size_t control = control_size(text), whole = character_size(text);
        const std::size_t size = std::max<std::size_t>(control > 0 ? control : whole, 1);
        const std::string_view character = text.substr(0, size);
        if (kept.find(character[0]) != std::string_view::npos || (control == 0 && whole > 0)) {
            result += character;
        } else if (character == "\n") {
            result += "\\n";
        } else if (character == "\t") {
            result += "\\t";
        } else {
            // C1 by its code, which is the second of its bytes.
            result += fmt::format("\\x{:02x}", static_cast<unsigned char>(character.back()));
        }
        text.remove_prefix(size);
    }
    return result;
}

}  // namespace

std::optional<std::size_t> first_not_utf8(std::string_view text) {
    for (std::size_t i = 0; i < text.size();) {
        const std::size_t size = character_size(text.substr(i));
        if (size == 0) return i;
        i += size;
    }
    return std::nullopt;
}

bool looks_like_utf16(std::string_view bytes) {
    if (bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF")) return true;
    // Of a letter of ASCII, with which people's texts begin, one byte is 0 and the other is not.
    constexpr std::size_t kLetters = 16;
    const std::size_t letters = std::min(bytes.size() / 2, kLetters);
    const auto are_zero = [&](std::size_t parity, bool zero) {
        for (std::size_t i = 0; i < letters; ++i) {
            if ((bytes[2 * i + parity] == 0) != zero) return false;
        }
        return letters > 0;
    };
    return (are_zero(0, true) && are_zero(1, false)) || (are_zero(0, false) && are_zero(1, true));
}

void require_utf8(std::string_view text, const std::string& filename) {
    if (looks_like_utf16(text)) {
        throw InputError(filename + ": is UTF-16; save the file as UTF-8");
    }
    if (text.find('\0') != std::string_view::npos) {
        throw InputError(filename + ": is no text, but binary data of no kind that is read here");
    }
    const auto position = first_not_utf8(text);
    if (!position) return;
    const std::string_view before = text.substr(0, *position);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t start = before.find_last_of('\n') + 1;  // npos + 1 is 0
    throw InputError(
        fmt::format("{}:{}:{}: is not UTF-8, but perhaps Latin-1 or Windows-1252; save the file as "
                    "UTF-8",
                    filename, line, *position - start + 1));
}

std::string replaced(std::string_view text, std::string_view from, std::string_view to) {
    std::string result;
    for (std::size_t at; (at = text.find(from)) != std::string_view::npos;) {
        result += text.substr(0, at);
        result += to;
        text.remove_prefix(at + from.size());
    }
    return result += text;
}

std::size_t json_nesting(std::string_view text) {
    std::size_t depth = 0, deepest = 0;
    bool in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (in_string) {
            if (c == '\\') ++i;
            in_string = c != '"';
        } else if (c == '"') {
            in_string = true;
        } else if (c == '[' || c == '{') {
            deepest = std::max(deepest, ++depth);
        } else if ((c == ']' || c == '}') && depth > 0) {
            --depth;
        }
    }
    return deepest;
}

std::string printable(std::string_view text) { return escaped(text, ""); }

std::string printable_lines(std::string_view text) { return escaped(text, "\n\t"); }

std::string lowercase(std::string_view text) {
    std::string result(text);
    for (char& c : result) c = lower(c);
    return result;
}

std::string excerpt(std::string_view text, std::size_t longest, char stand_in) {
    std::size_t end = std::min(text.size(), longest);
    // Not before a continuation byte, which would leave half a character.
    while (end < text.size() && end > 0 && (static_cast<unsigned char>(text[end]) & 0xc0) == 0x80) {
        --end;
    }
    std::string result(text.substr(0, end));
    for (std::size_t i = 0; i < result.size(); ++i) {
        const std::size_t size = control_size(std::string_view(result).substr(i));
        if (size > 0) result.replace(i, size, 1, stand_in);
    }
    return end < text.size() ? result + "..." : result;
}

int edit_distance(std::string_view a, std::string_view b) {
    // Three rows of the table d[i][j] = distance of the first i letters of a to the first j of b.
    std::vector<int> before(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = static_cast<int>(j);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        before.swap(last);
        last.swap(row);
        row[0] = static_cast<int>(i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const char x = lower(a[i - 1]), y = lower(b[j - 1]);
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (x != y)});
            if (i > 1 && j > 1 && x == lower(b[j - 2]) && lower(a[i - 2]) == y) {
                row[j] = std::min(row[j], before[j - 2] + 1);
            }
        }
    }
    return row[b.size()];
}

std::optional<std::string> closest_match(std::string_view name,
                                         std::span<const std::string> candidates) {
    if (name.empty() || name.size() > kMaxNameLength) return std::nullopt;
    std::optional<std::string> best;
    int best_distance = 0;
    for (const std::string& candidate : candidates) {
        if (candidate.size() > kMaxNameLength) continue;
        const int longest = static_cast<int>(std::max(name.size(), candidate.size()));
        const int distance = edit_distance(name, candidate);
        if (distance < longest && distance <= std::max(1, longest / 3) &&
            (!best || distance < best_distance)) {
            best = candidate;
            best_distance = distance;
        }
    }
    return best;
}

std::string did_you_mean(std::string_view name, std::span<const std::string> candidates) {
    constexpr std::size_t kMax = 6;
    std::vector<std::string> meant;
    const std::string stem = lowercase(name.substr(0, kMaxNameLength)) + "_";
    for (const std::string& candidate : candidates) {
        if (lowercase(candidate).starts_with(stem)) meant.push_back(candidate);
    }
    if (name.empty() || meant.size() > kMax) meant.clear();
    if (const auto match = closest_match(name, candidates); match && meant.empty()) {
        meant.push_back(*match);
    }
    std::string text;
    for (std::size_t i = 0; i < meant.size(); ++i) {
        text += (i == 0 ? "'" : i + 1 < meant.size() ? ", '" : " or '") + meant[i] + "'";
    }
    return meant.empty() ? "" : " (did you mean " + text + "?)";
}

}  // namespace nacre
