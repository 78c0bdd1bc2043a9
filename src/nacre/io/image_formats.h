#pragma once

#include <string>
#include <string_view>

#include "nacre/io/image.h"

// One reader per picture format; parse_image() picks among them.

namespace nacre::io {

bool looks_like_exr(std::string_view bytes);
bool looks_like_png(std::string_view bytes);
bool looks_like_radiance_hdr(std::string_view bytes);

Image parse_exr(std::string_view bytes, const std::string& name, std::size_t most_values);
Image parse_png(std::string_view bytes, const std::string& name, std::size_t most_values);
Image parse_radiance_hdr(std::string_view bytes, const std::string& name, std::size_t most_values);

/// @throws InputError naming `name` if a picture of that size is absurd or has more than
///         `most_values` values
void check_image_size(const std::string& name, long width, long height, std::size_t channels,
                      std::size_t most_values);

/// An image with the given channels, all zero.
/// @throws InputError as check_image_size()
Image blank_image(const std::string& name, long width, long height,
                  const std::vector<std::string>& channels, std::size_t most_values);

}  // namespace nacre::io
