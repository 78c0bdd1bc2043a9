#pragma once

#include <span>
#include <string_view>

namespace nacre::optics {

/// A file of data/materials, compiled into the library.
struct ShippedMaterial {
    std::string_view name;
    std::string_view csv;
};

std::span<const ShippedMaterial> shipped_materials();

}  // namespace nacre::optics
