#pragma once

#include <string>

namespace nacre::cli {

/// A video of numbered pictures, made by ffmpeg, whose codec is the usual one of the video's format:
/// .mp4, .mkv, .webm or .gif.
struct VideoOptions {
    std::string path;  ///< empty: none
    double frames_per_s = 24;
};

/// @throws UsageError if the extension is another, or there is no ffmpeg to run
void check_video(const VideoOptions& options);

/// Puts the video in its place, whole or not at all.
/// @param pictures  their name with %04d for the number, other % doubled
/// @throws Error if ffmpeg fails, with what it said
void write_video(const VideoOptions& options, const std::string& pictures, long first, long count);

}  // namespace nacre::cli
