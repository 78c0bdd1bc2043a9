#include "apps/report/markup.h"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <optional>

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
    constexpr std::uint32_t kMin[] = {0, 0, 0x80, 0x800, 0x10000};
    const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
    if (code < kMin[length] || code > 0x10FFFF || surrogate) return {};
    return {code, length};
}

// Controls, which HTML may not hold, and the two codes besides that XML may not.   [xml-2008, 2.2]
bool is_forbidden(std::uint32_t code) {
    return (code < 0x20 && code != '\t' && code != '\n' && code != '\r') ||
           (code >= 0x7F && code < 0xA0) || code == 0xFFFE || code == 0xFFFF;
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

namespace {

constexpr auto kNone = std::string_view::npos;

// A mark that does not close within so many bytes does not count. This keeps the time for a text
// full of opening marks proportional to its length.
constexpr std::size_t kMaxMarkLength = 4096;

// Bytes of characters beyond ASCII count as letters.
bool is_word(char c) {
    const auto byte = static_cast<unsigned char>(c);
    return byte >= 0x80 || std::isalnum(byte);
}

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n'; }

bool is_address(std::string_view url) {
    if (url.empty() || url.substr(0, 2) == "//") return false;
    const auto printable = [](char c) { return static_cast<unsigned char>(c) > ' ' && c != 0x7F; };
    if (!std::all_of(url.begin(), url.end(), printable)) return false;
    for (const std::string_view scheme : {"http://", "https://", "mailto:"}) {
        if (url.substr(0, scheme.size()) == scheme) return true;
    }
    // Browsers take a backslash for a slash.
    return url.find(':') >= url.find_first_of("/?#") && url.find('\\') == kNone;
}

// How the marks come out.
struct Html {
    static std::string text(std::string_view t) { return escape_html(t); }
    static std::string code(std::string_view t) { return "<code>" + escape_html(t) + "</code>"; }
    static std::string emphasis(const std::string& inner) { return "<em>" + inner + "</em>"; }
    static std::string link(std::string_view url, const std::string& inner) {
        return "<a href=\"" + escape_html(url) + "\">" + inner + "</a>";
    }
};

struct Plain {
    static std::string text(std::string_view t) { return std::string(t); }
    static std::string code(std::string_view t) { return std::string(t); }
    static std::string emphasis(const std::string& inner) { return inner; }
    static std::string link(std::string_view, const std::string& inner) { return inner; }
};

struct Allowed {
    bool emphasis = true;
    bool link = true;
};

// Where the emphasis that opens at `open` closes.
std::size_t end_of_emphasis(std::string_view text, std::size_t open) {
    if (open > 0 && is_word(text[open - 1])) return kNone;
    if (open + 1 >= text.size() || is_blank(text[open + 1])) return kNone;
    text = text.substr(0, open + kMaxMarkLength);
    for (std::size_t i = text.find('*', open + 2); i != kNone; i = text.find('*', i + 1)) {
        const bool inside_word = i + 1 < text.size() && is_word(text[i + 1]);
        if (!is_blank(text[i - 1]) && !inside_word) return i;
    }
    return kNone;
}

struct Link {
    std::string_view words, url;
    std::size_t end;  // of the closing parenthesis
};

std::optional<Link> link_at(std::string_view text, std::size_t open) {
    text = text.substr(0, open + kMaxMarkLength);
    const std::size_t middle = text.find(']', open);
    if (middle == kNone || middle == open + 1 || text.substr(middle + 1, 1) != "(") return {};
    const std::size_t close = text.find(')', middle);
    if (close == kNone) return {};
    const std::string_view url = text.substr(middle + 2, close - middle - 2);
    if (!is_address(url)) return {};
    return Link{text.substr(open + 1, middle - open - 1), url, close};
}

template <class Out>
std::string convert(std::string_view text, Allowed allowed) {
    std::string result;
    std::size_t plain = 0;  // where the text begins that has not been put out yet
    const auto put = [&](std::size_t end, const std::string& marked, std::size_t next) {
        result += Out::text(text.substr(plain, end - plain)) + marked;
        plain = next;
        return next;
    };
    for (std::size_t i = 0; i < text.size();) {
        if (text[i] == '`') {
            const std::size_t close = text.substr(0, i + kMaxMarkLength).find('`', i + 1);
            if (close != kNone && close > i + 1) {
                i = put(i, Out::code(text.substr(i + 1, close - i - 1)), close + 1);
                continue;
            }
        } else if (text[i] == '*' && allowed.emphasis) {
            const std::size_t close = end_of_emphasis(text, i);
            if (close != kNone) {
                const auto inner = text.substr(i + 1, close - i - 1);
                i = put(i, Out::emphasis(convert<Out>(inner, {false, allowed.link})), close + 1);
                continue;
            }
        } else if (text[i] == '[' && allowed.link) {
            if (const auto link = link_at(text, i)) {
                const auto inner = convert<Out>(link->words, {allowed.emphasis, false});
                i = put(i, Out::link(link->url, inner), link->end + 1);
                continue;
            }
        }
        ++i;
    }
    put(text.size(), {}, text.size());
    return result;
}

}  // namespace

std::string markup_to_html(std::string_view text) { return convert<Html>(text, {}); }
std::string markup_to_plain(std::string_view text) { return convert<Plain>(text, {}); }

}  // namespace nacre::report
