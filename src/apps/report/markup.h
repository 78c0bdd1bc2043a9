#pragma once

#include <string>
#include <string_view>

// What keeps text from being taken for HTML.

namespace nacre::report {

/// The text as valid UTF-8 that HTML and XML may hold: each byte that is no part of a character,
/// each control character but tabs and line ends, U+FFFE and U+FFFF become U+FFFD.
std::string clean_utf8(std::string_view text);

/// The cleaned text with & < > " ' as character references: safe between tags and inside quoted
/// attributes.
std::string escape_html(std::string_view text);

/// HTML of a text with markup: `code`, *emphasis*, [words](address). Stars inside words mean
/// nothing, so that L*a*b* stays as it is; nor do marks that do not close. A link whose address is
/// neither http, https, mailto, #anchor nor a relative path is shown as it was written, so that no
/// text can bring a script along.
std::string markup_to_html(std::string_view text);

/// The same text without its marks, for places that hold plain text only. Not escaped.
std::string markup_to_plain(std::string_view text);

}  // namespace nacre::report
