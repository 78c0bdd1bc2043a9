#pragma once

#include <span>
#include <string_view>

namespace nacre::studio {

/// A file of the page (src/apps/studio/page), which is part of the program.
struct PageFile {
    std::string_view path;  ///< as "/studio.js"
    std::string_view bytes;
};

std::span<const PageFile> page_files();

}  // namespace nacre::studio
