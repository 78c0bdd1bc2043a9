#include "nacre/report/escape.h"

#include <cctype>
#include <cstdint>

namespace nacre::report {

namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD

struct Character {
    std::uint32_t code = 0;
    std::size_t length = 0;  // bytes; 0: no character
};

// The first character of a text that is not empty. Overlong forms, surrogates and codes beyond
// U+10FFFF are no characters.
Character first_character(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
    const std::uint8_t lead = byte(0);
    if (lead < 0x80) return {lead, 1};
    const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
    if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return {};
    std::uint32_t code = lead & (0x7Fu >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0) != 0x80) return {};
        code = code << 6 | (byte(i) & 0x3Fu);
    }
    constexpr std::uint32_t kSmallest[] = {0, 0, 0x80, 0x800, 0x10000};
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    if (code < kSmallest[length] || code > 0x10FFFF || surrogate) return {};
    return {code, length};
}

// Controls, which HTML may not hold, and the two codes besides that XML may not.   [xml-2008, 2.2]
bool is_forbidden(std::uint32_t code) {
    return (code < 0x20 && code != '\t' && code != '\n' && code != '\r') ||
           (code >= 0x7F && code < 0xA0) || code == 0xFFFE || code == 0xFFFF;
}

// Puts `insert` after the first character of each `what`, whatever the case of its letters.
std::string split_every(std::string_view source, std::string_view what, char insert) {
    std::string result;
    result.reserve(source.size() + 16);
    for (std::size_t i = 0; i < source.size(); ++i) {
        result += source[i];
        std::size_t matched = 0;
        while (matched < what.size() && i + matched < source.size() &&
               std::tolower(static_cast<unsigned char>(source[i + matched])) == what[matched]) {
            ++matched;
        }
        if (matched == what.size()) result += insert;
    }
    return result;
}

}  // namespace

std::string clean_utf8(std::string_view text) {
    std::string clean;
    clean.reserve(text.size());
    for (std::size_t i = 0; i < text.size();) {
        const Character c = first_character(text.substr(i));
        if (c.length == 0 || is_forbidden(c.code)) {
            clean += kReplacement;
        } else {
            clean += text.substr(i, c.length);
        }
        i += c.length == 0 ? 1 : c.length;
    }
    return clean;
}

std::string escape_html(std::string_view text) {
    std::string escaped;
    escaped.reserve(text.size());
    for (const char c : clean_utf8(text)) {
        switch (c) {
            case '&':
                escaped += "&amp;";
                break;
            case '<':
                escaped += "&lt;";
                break;
            case '>':
                escaped += "&gt;";
                break;
            case '"':
                escaped += "&quot;";
                break;
            case '\'':
                escaped += "&#39;";
                break;
            default:
                escaped += c;
        }
    }
    return escaped;
}

std::string escape_script(std::string_view source) {
    return split_every(split_every(source, "</script", '\\'), "<!--", '\\');
}

std::string escape_json(std::string_view json) {
    std::string escaped;
    escaped.reserve(json.size());
    for (const char c : json) {
        if (c == '<') {
            escaped += "\\u003c";
        } else {
            escaped += c;
        }
    }
    return escaped;
}

}  // namespace nacre::report
