#pragma once

#include <string_view>

namespace nacre::panel {

/// panel.css, which is part of the library: what a panel report's page adds to report/page.css.
std::string_view panel_css();

}  // namespace nacre::panel
