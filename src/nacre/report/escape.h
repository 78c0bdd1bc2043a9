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

/// A script's source such that it cannot end the <script> element that it stands in. What it does
/// stays the same as long as "</script" and "<!--" occur in strings and regular expressions only,
/// where a backslash before / or ! means nothing.
std::string escape_script(std::string_view source);

/// JSON such that it cannot end the <script> element that it stands in: < becomes \u003c.
std::string escape_json(std::string_view json);

}  // namespace nacre::report
