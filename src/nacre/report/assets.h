#pragma once

#include <string_view>

// Files beside this one that become part of the page (CMakeLists.txt).

namespace nacre::report {

std::string_view page_css();
std::string_view plots_js();

}  // namespace nacre::report
