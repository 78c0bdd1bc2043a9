#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "apps/cli/model_options.h"
#include "apps/cli/options.h"
#include "apps/cli/video.h"
#include "nacre/render.h"

// What `nacre render` was told.

namespace nacre::cli {

struct RenderCommandOptions : CommonOptions {
    std::string scene;
    std::string paint;
    std::string brdf;  // measured, instead of the paint
    ModelOptions model{.model = std::string(models::default_picture_model().info().name)};
    std::string size = "512x512";
    render::RenderOptions render;
    io::ToneMap tone_map;
    std::optional<int> spp;
    std::optional<double> noise;
    std::string frames;
    std::optional<std::string> turntable;
    std::optional<double> step_deg;
    VideoOptions video;
    bool fps_given = false;
    std::optional<std::string> shard_text;
    std::optional<Shard> shard;  // that it says
};

/// More samples are taken only where --spp says so.
inline constexpr int kMaxSamplesForNoise = 1 << 16;

void add_render_options(CLI::App& command, RenderCommandOptions& options);

/// Options that only go with others, before any work.
void check_choices(const RenderCommandOptions& options);

/// "640x480".
void parse_size(const std::string& text, render::RenderOptions& options);

/// Of --frames: the first and the last.
struct Frames {
    long first = 0, last = 0;
    long count() const { return last - first + 1; }
};

Frames parse_frames(const std::string& text);

/// "2/8".
Shard parse_shard(const std::string& text, int samples_per_pixel);

}  // namespace nacre::cli
