#pragma once

#include <string>
#include <string_view>

namespace nacre::optics {

/// Refuses YAML with anchors, aliases or deep nesting, which a page of data does not need and by
/// which a small file makes a parser do endless work. It reads the parser's events, before any tree
/// is built.
/// @param name  of the file in messages
/// @throws InputError naming file and line; YAML::Exception where the text is not YAML
void require_plain_yaml(std::string_view text, const std::string& name);

}  // namespace nacre::optics
