#pragma once

#include <string>
#include <string_view>

namespace nacre::report {

/// @throws DomainError naming `where` unless the colour is "#rrggbb": nothing else may enter the
/// page's style attributes
void require_colour(std::string_view colour, const std::string& where);

}  // namespace nacre::report
