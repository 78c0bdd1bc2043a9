#pragma once

#include <string>
#include <string_view>

namespace nacre::report {

/// HTML of a text with markup: `code`, *emphasis*, [words](address). Stars inside words mean
/// nothing, so that L*a*b* stays as it is; nor do marks that do not close. A link whose address is
/// neither http, https, mailto, #anchor nor a relative path is shown as it was written, so that no
/// text can bring a script along.
std::string markup_to_html(std::string_view text);

/// The same text without its marks, for places that hold plain text only. Not escaped.
std::string markup_to_plain(std::string_view text);

}  // namespace nacre::report
