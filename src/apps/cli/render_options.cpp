#include "apps/cli/render_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>
#include <utility>
#include <vector>

#include "apps/cli/picture_output.h"
#include "nacre/core/error.h"
#include "nacre/core/text.h"
#include "nacre/render/builtin_scenes.h"

namespace nacre::cli {

namespace {

constexpr long kMaxFrames = 100'000;

std::string joined_scene_names() {
    std::string names;
    for (const std::string& name : render::builtin_scene_names()) {
        names += (names.empty() ? "" : ", ") + name;
    }
    return names;
}

}  // namespace

void add_render_options(CLI::App& command, RenderCommandOptions& options) {
    command
        .add_option("SCENE", options.scene,
                    "Scene file (TOML), or a built-in scene: " + joined_scene_names())
        ->required();
    command
        .add_option("--paint", options.paint,
                    "Recipe (TOML) or solved paint (HDF5) for the scene's unnamed paint")
        ->type_name("RECIPE");
    command
        .add_option("--brdf", options.brdf,
                    "Measured BRDF (.bsdf of the RGL database, .binary of MERL) for it instead")
        ->type_name("FILE");
    add_model_options(command, options.model);
    command
        .add_option("--footprint", options.render.footprint_pixels,
                    fmt::format("{}: side of a patch that each sample shows, pixels, for "
                                "experiments; 0: the samples share out what the pixel shows",
                                fmt::join(sparkling_models(), ", ")))
        ->check(in_range(0.0, 1000.0))
        ->capture_default_str();
    command.add_flag("--sparkle", options.render.sparkle,
                     "Keep the light of single flakes apart as well, in the EXR's channels "
                     "sparkle.R, .G, .B: what they send less their mean");
    command
        .add_option("--spp", options.spp,
                    fmt::format("Samples per pixel [{}]; with --noise at most [{}]",
                                options.render.samples_per_pixel, kMaxSamplesForNoise))
        ->check(in_range(1, 1 << 24));
    command
        .add_option("--noise", options.noise,
                    "Take as many samples as this noise needs: the standard error of a pixel over "
                    "the mean luminance, as 0.01")
        ->check(in_range(render::kNoiseRange.lo, render::kNoiseRange.hi));
    command.add_option("--frames", options.frames,
                       "Render frames FIRST:LAST, as 0:35, to files numbered out.0000.exr ...");
    command
        .add_option("--turntable", options.turntable,
                    "With --frames: shape, camera or light turns about the vertical")
        ->check(CLI::IsMember({"shape", "camera", "light"}));
    command
        .add_option("--step", options.step_deg,
                    "With --frames: deg from frame to frame; frame 0 is the scene as it is [a "
                    "whole turn in all frames]")
        ->check(in_range(-360.0, 360.0));
    command
        .add_option("--video", options.video.path,
                    "With --frames: a video of them besides, by ffmpeg: .mp4, .mkv, .webm, .gif")
        ->type_name("FILE");
    command.add_option("--fps", options.video.frames_per_s, "Frames a second of the video")
        ->check(in_range(0.1, 240.0))
        ->each([&options](const std::string&) { options.fps_given = true; })
        ->capture_default_str();
    command.add_option("--size", options.size, "Pixels as WIDTHxHEIGHT")->capture_default_str();
    command.add_option("--depth", options.render.max_depth, "Surface reflections along a path")
        ->check(in_range(1, 1000))
        ->capture_default_str();
    command
        .add_option("--spectral-bins", options.render.spectral_bins,
                    "Spectral channels over 400 to 700 nm in the EXR; 0: none")
        ->check(in_range(0, 300))
        ->capture_default_str();
    command
        .add_option("--shard", options.shard_text,
                    "Render shard I of N of the samples only, as 2/8, for nacre merge; -o then "
                    "names an .h5")
        ->type_name("I/N");
    add_tone_map(command, options.tone_map);
    add_picture_output(command, options);
    add_seed(command, options);
    add_input_options(command, options);
    add_set(command, options);
    add_run_options(command, options);
    command.footer(
        "The EXR holds linear Rec. 709 (1 is the perfect diffuser in full light), albedo and "
        "normal\n"
        "for denoisers, and the settings; the PNG is tone-mapped for looking at. With --sparkle,\n"
        "take sparkle from the picture, denoise the rest and add it again. For a given seed\n"
        "the picture does not depend on the number of threads. Ctrl-C writes what is there, marks\n"
        "it as partial and ends with status 3; of a shard it writes nothing.\n\n"
        "Example:\n"
        "  nacre render sphere --paint paints/red-gold.toml --spp 256 --size 512x512 -o red.exr");
}

void check_choices(const RenderCommandOptions& options) {
    if (options.paint.empty() && !options.set.empty()) {
        throw UsageError("--set belongs to --paint: it changes that recipe");
    }
    if (options.frames.empty() && (options.turntable || options.step_deg)) {
        throw UsageError("--turntable and --step belong to --frames");
    }
    if (options.frames.empty() && !options.video.path.empty()) {
        throw UsageError("--video belongs to --frames");
    }
    if (options.fps_given && options.video.path.empty()) {
        throw UsageError("--fps belongs to --video");
    }
    if (!options.frames.empty() && !options.turntable) {
        throw UsageError("--frames needs --turntable, which says what turns");
    }
    if (options.shard_text && options.noise) {
        throw UsageError(
            "--shard and --noise exclude each other: say with --spp how many samples all shards "
            "have together");
    }
    if (options.shard_text && !options.video.path.empty()) {
        throw UsageError("--shard makes no pictures for --video to show: merge the frames first");
    }
    if (!options.video.path.empty()) check_video(options.video);
    if (options.shard_text && options.tone_map != io::ToneMap{}) {
        throw UsageError("--exposure and --gamut belong to nacre merge where there is --shard");
    }
    for (const auto& [option, given] : {std::pair{"--sparkle", options.render.sparkle},
                                        {"--footprint", options.render.footprint_pixels != 0}}) {
        if (!given || parse_model(options.model).can.sparkle) continue;
        throw UsageError(fmt::format("{}: the model {} shows no single flakes; must be {}", option,
                                     options.model.model, fmt::join(sparkling_models(), " or ")));
    }
}

void parse_size(const std::string& text, render::RenderOptions& options) {
    const std::vector<std::string_view> sides = split(text, 'x');
    const Range range{1, io::kMaxPixelsPerSide, "pixels"};
    if (sides.size() == 2) {
        const double width = parse_number("--size (width)", sides[0], range);
        const double height = parse_number("--size (height)", sides[1], range);
        options.width = static_cast<int>(width);
        options.height = static_cast<int>(height);
        if (options.width == width && options.height == height) return;
    }
    throw UsageError(
        fmt::format("--size = {}: must be WIDTHxHEIGHT in whole pixels, as in 512x512", text));
}

Frames parse_frames(const std::string& text) {
    const std::vector<std::string_view> ends = split(text, ':');
    const Range range{0, 999'999};
    if (ends.size() == 2) {
        const double first = parse_number("--frames (first)", ends[0], range);
        const double last = parse_number("--frames (last)", ends[1], range);
        const Frames frames{static_cast<long>(first), static_cast<long>(last)};
        if (static_cast<double>(frames.first) == first &&
            static_cast<double>(frames.last) == last && first <= last &&
            frames.count() <= kMaxFrames) {
            return frames;
        }
    }
    throw UsageError(
        fmt::format("--frames = {}: must be FIRST:LAST in whole numbers, at most {} "
                    "frames, as in 0:35",
                    text, kMaxFrames));
}

Shard parse_shard(const std::string& text, int samples_per_pixel) {
    const std::vector<std::string_view> parts = split(text, '/');
    const Range range{1, static_cast<double>(samples_per_pixel)};
    if (parts.size() == 2) {
        const double number = parse_number("--shard (number)", parts[0], range);
        const double count = parse_number("--shard (of)", parts[1], range);
        const Shard shard{static_cast<int>(number), static_cast<int>(count)};
        if (shard.number == number && shard.count == count && number <= count) return shard;
    }
    throw UsageError(
        fmt::format("--shard = {}: must be one from 1/N to N/N in whole numbers, N at most the {} "
                    "samples of a pixel, as in 2/8",
                    text, samples_per_pixel));
}

}  // namespace nacre::cli
