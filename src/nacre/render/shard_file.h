#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "nacre/render/render.h"

// Shards of a picture's samples as HDF5, until all of them make the picture.
//
//   (user block)             512 bytes of text: what this is, version, size and SHA-256 of the rest
//   /                        attributes: format, format_version, nacre_version, scene_sha256, and
//                            number, count and seconds of the shard
//   /metadata                what the picture's file will say, JSON
//   /options                 attributes: RenderOptions of the whole picture
//   /picture                 FilmSums: light, albedo, sparkle, spectral, normal, met, invalid by
//                            pixel; white, albedo_white, bin_weights over the passes
//   /probe                   the same of the pixels that are rendered twice for the noise
//
// Sums are whole numbers of steps, so that adding them rounds nothing (core/reproducible_sum.h): of
// light 2^-48 in 128 bits, as a low and a high word of 64; of normals 2^-38 in 64 bits.

namespace nacre::render {

inline constexpr int kShardFormatVersion = 1;
inline constexpr std::size_t kMaxShardBytes = std::size_t{1} << 33;

struct PictureShard {
    RenderOptions options;  ///< of the whole picture
    Shard shard;
    RenderSums sums;
    /// What the picture's file will say besides: picture_metadata().
    std::map<std::string, std::string> metadata;
    /// Of all that the picture shows: shards with another one are of another picture.
    std::string scene_sha256;

    friend bool operator==(const PictureShard&, const PictureShard&) = default;
};

/// What shards of one picture have in common, as text by name, in the order of importance.
std::vector<std::pair<std::string, std::string>> identity_of(const PictureShard& shard);

/// What the file of the picture that it is a shard of says about how that was made.
std::map<std::string, std::string> picture_metadata(const PictureShard& shard);

std::string shard_bytes(const PictureShard& shard);
/// Writes it, whole or not at all.
/// @throws Error if the file cannot be written
void write_shard(const std::filesystem::path& path, const PictureShard& shard);

/// @param name  for messages
/// @throws InputError naming the file if it is cut short, altered, of another kind or version, or
///         of another version of Nacre, whose samples are others; Error as check()
PictureShard parse_shard(std::string_view bytes, const std::string& name);
PictureShard read_shard(const std::filesystem::path& path);

}  // namespace nacre::render
