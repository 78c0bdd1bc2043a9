#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace nacre::io {

/// Looks through the headers of an OpenEXR file before the OpenEXR library does, which allocates
/// whatever sizes it finds there: a file of a kilobyte could ask for gigabytes.
///
/// @throws InputError naming `name` if an attribute is larger than the file, or if the picture, one
///         of its tiles or a block of its scan lines has more than `most_values` values
void check_exr_headers(std::string_view bytes, const std::string& name, std::size_t most_values);

}  // namespace nacre::io
