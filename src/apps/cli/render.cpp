#include "nacre/render.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "apps/cli/model_options.h"
#include "apps/cli/options.h"
#include "apps/cli/paint_options.h"
#include "apps/cli/picture_output.h"
#include "apps/cli/video.h"
#include "nacre/core/error.h"
#include "nacre/core/parallel.h"
#include "nacre/core/progress.h"
#include "nacre/render/builtin_scenes.h"
#include "nacre/render/turntable.h"

namespace nacre::cli {

namespace {

namespace fs = std::filesystem;

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
    std::optional<std::string> shard;
    std::optional<Share> share;  // that it says
};

/// More samples are taken only where --spp says so.
constexpr int kMostSamplesForNoise = 1 << 16;

/// "640x480".
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

/// --brdf, which must name a measured BRDF; none if it was not given.
std::optional<Paint> open_brdf(const RenderCommandOptions& options) {
    if (options.brdf.empty()) return std::nullopt;
    if (!options.paint.empty()) throw UsageError("--paint and --brdf exclude each other");
    Paint brdf = open_input(options, options.brdf);
    if (brdf.kind() != Kind::measured_brdf) {
        throw InputError(fmt::format(
            "{}: holds no measured BRDF, neither of the RGL database (.bsdf) nor of MERL "
            "(.binary); recipes go with --paint",
            options.brdf));
    }
    return brdf;
}

/// The paint for materials without a recipe, if there are any: --brdf, or --paint.
std::optional<Paint> paint_for_slots(const render::SceneDescription& description,
                                     const RenderCommandOptions& options,
                                     std::optional<Paint> brdf) {
    const std::vector<std::string> slots = paint_slots(description);
    if (!brdf && options.paint.empty()) {
        if (slots.empty()) return std::nullopt;
        throw UsageError(
            fmt::format("the material {} of the scene {} has no recipe: name one with --paint, or "
                        "a measured BRDF with --brdf",
                        slots[0], options.scene));
    }
    if (slots.empty()) {
        throw UsageError(fmt::format("{} = {}: the scene {} has no material without a recipe",
                                     brdf ? "--brdf" : "--paint",
                                     brdf ? options.brdf : options.paint, options.scene));
    }
    return brdf ? brdf : open_paint(options, options.paint);
}

/// What a picture, or each frame, is made from.
struct Painted {
    render::SceneDescription description;
    ScenePaints paints;
};

Painted painted(const RenderCommandOptions& options) {
    std::optional<Paint> brdf = open_brdf(options);
    render::SceneDescription description =
        find_scene(options.scene, references_of(options, options.scene));
    for (const std::string& note : description.notes) warn(options, note);
    std::optional<Paint> slot = paint_for_slots(description, options, std::move(brdf));
    ModelOptions chosen = options.model;
    if (!chosen.model_given && slot && slot->kind() == Kind::brdf_table) {
        chosen.model = models::default_model().info().name;  // the one that tables are made of
    }
    return {std::move(description), {std::move(slot), parse_model_settings(chosen)}};
}

Scene scene_of(const RenderCommandOptions& options, Painted painted) {
    const bsdf::Model& model = *painted.paints.model;
    ProgressBar bar("prepare", options.quiet || !model.makes_table());
    try {
        return Scene(std::move(painted.description), painted.paints, bar.callback());
    } catch (const SettingError& error) {  // where the model does not go
        if (error.setting() != "model") throw;
        throw UsageError(fmt::format("{}: {}", choice_of(model.info()), error.reason()));
    }
}

/// Refuses model options where every paint is a measured BRDF, which takes no model.
void check_model(const RenderCommandOptions& options, const Scene& scene) {
    if (scene.paints().empty() || scene.shows_model()) return;
    if (options.model.model_given) {
        refuse_model(options.model.model, "every material of the scene " + options.scene);
    }
    const bsdf::Model model = parse_model_settings(options.model);
    if (model.makes_table()) {
        throw UsageError(
            fmt::format("{}: every material of the scene {} holds a measured BRDF; "
                        "tables are made of recipes",
                        choice_of_table(model), options.scene));
    }
}

/// Of --frames: the first and the last.
struct Frames {
    long first = 0, last = 0;
    long count() const { return last - first + 1; }
};

constexpr long kMostFrames = 100'000;

Frames parse_frames(const std::string& text) {
    const std::vector<std::string_view> ends = split(text, ':');
    const Range range{0, 999'999};
    if (ends.size() == 2) {
        const double first = parse_number("--frames (first)", ends[0], range);
        const double last = parse_number("--frames (last)", ends[1], range);
        const Frames frames{static_cast<long>(first), static_cast<long>(last)};
        if (static_cast<double>(frames.first) == first &&
            static_cast<double>(frames.last) == last && first <= last &&
            frames.count() <= kMostFrames) {
            return frames;
        }
    }
    throw UsageError(
        fmt::format("--frames = {}: must be FIRST:LAST in whole numbers, at most {} "
                    "frames, as in 0:35",
                    text, kMostFrames));
}

/// "out.exr" of frame 7: "out.0007.exr".
fs::path frame_file(const fs::path& output, long frame) {
    return fs::path(output).replace_extension(
        fmt::format(".{:04}{}", frame, output.extension().string()));
}

/// "2/8".
Share parse_share(const std::string& text, int samples_per_pixel) {
    const std::vector<std::string_view> parts = split(text, '/');
    const Range range{1, static_cast<double>(samples_per_pixel)};
    if (parts.size() == 2) {
        const double number = parse_number("--shard (share)", parts[0], range);
        const double count = parse_number("--shard (of)", parts[1], range);
        const Share share{static_cast<int>(number), static_cast<int>(count)};
        if (share.number == number && share.count == count && number <= count) return share;
    }
    throw UsageError(
        fmt::format("--shard = {}: must be one from 1/N to N/N in whole numbers, N at most the {} "
                    "samples of a pixel, as in 2/8",
                    text, samples_per_pixel));
}

/// Options that only go with others, before any work.
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
    if (!options.frames.empty() && !options.turntable) {
        throw UsageError("--frames needs --turntable, which says what turns");
    }
    if (options.shard && options.noise) {
        throw UsageError(
            "--shard and --noise exclude each other: say with --spp how many samples all shares "
            "have together");
    }
    if (options.shard && !options.video.path.empty()) {
        throw UsageError("--shard makes no pictures for --video to show: merge the frames first");
    }
    if (!options.video.path.empty()) check_video(options.video);
    if (options.shard && options.tone_map != io::ToneMap{}) {
        throw UsageError("--exposure and --gamut belong to nacre merge where there is --shard");
    }
    if (options.render.sparkle && !parse_model(options.model).can.sparkle) {
        throw UsageError(fmt::format("--sparkle: the model {} shows no single flakes; must be {}",
                                     options.model.model, fmt::join(sparkling_models(), " or ")));
    }
}

/// Without --noise the samples that were asked for.
int samples_for(const RenderCommandOptions& options, const Scene& scene) {
    if (!options.noise) return options.render.samples_per_pixel;
    ProgressBar bar("noise", options.quiet);
    return scene.samples_for_noise(options.render, *options.noise,
                                   options.spp.value_or(kMostSamplesForNoise), bar.callback());
}

/// Of a picture and a share.
void add_scene_report(nlohmann::json& report, const RenderCommandOptions& options,
                      const Scene& scene, const render::RenderOptions& how) {
    report["scene"] = options.scene;
    report["model"] = scene.model_name();
    report["recipe_sha256"] = scene.recipe_sha256();
    report["seed"] = how.seed;
    report["specimen"] = scene.specimen() ? nlohmann::json(*scene.specimen()) : nullptr;
}

/// Renders a share of one picture and writes it. @return for the report
nlohmann::json render_share_to(const RenderCommandOptions& options, const Scene& scene,
                               const fs::path& file) {
    render::RenderOptions how = options.render;
    how.noise = true;
    PictureShare share = [&] {
        ProgressBar bar("render", options.quiet);
        return scene.render_share(how, *options.share, bar.callback());
    }();
    share.metadata["nacre:scene"] = options.scene;
    write_share(file, share);
    const int samples = render::samples_of(how, *options.share);
    say(options,
        fmt::format("{}: share {}/{} of {} x {} pixels, {} of {} samples each, {}", file.string(),
                    options.share->number, options.share->count, how.width, how.height, samples,
                    how.samples_per_pixel, duration_text(share.sums.seconds)));
    nlohmann::json report = {{"output", {file.string()}},
                             {"width", how.width},
                             {"height", how.height},
                             {"share", options.share->number},
                             {"shares", options.share->count},
                             {"samples_per_pixel", samples},
                             {"complete", true},
                             {"render_s", share.sums.seconds}};
    add_scene_report(report, options, scene, how);
    return report;
}

/// Renders one picture and writes it. @return for the report
nlohmann::json render_picture_to(const RenderCommandOptions& options, const Scene& scene,
                                 const fs::path& exr) {
    render::RenderOptions how = options.render;
    how.noise = true;
    how.samples_per_pixel = samples_for(options, scene);
    Picture picture = [&] {
        ProgressBar bar("render", options.quiet);
        return scene.render(how, bar.callback());
    }();
    const render::RenderResult& result = picture.result;
    if (result.samples == 0) {
        throw Error("stopped before every pixel had a sample; nothing was written");
    }
    warn_of_picture(options, result, options.scene);
    picture.metadata["nacre:scene"] = options.scene;
    const std::string clipped = write_picture(exr, picture.image(), options.tone_map);

    say(options, (result.complete ? "" : "stopped early; partial picture in ") +
                     summary(result, exr) + clipped);
    const bool capped = how.samples_per_pixel == options.spp.value_or(kMostSamplesForNoise);
    if (options.noise && capped && result.complete && result.noise > options.noise) {
        say(options,
            fmt::format("nacre: the noise is {}, not {}: {} samples were the most that "
                        "--spp allows",
                        percent_text(*result.noise), percent_text(*options.noise), result.samples));
    }
    nlohmann::json report = report_of(result, exr);
    add_scene_report(report, options, scene, how);
    return report;
}

nlohmann::json render_to(const RenderCommandOptions& options, const Scene& scene,
                         const fs::path& output) {
    return options.share ? render_share_to(options, scene, output)
                         : render_picture_to(options, scene, output);
}

void add_png_beside(CommandFiles& files, const fs::path& exr) {
    files.files.push_back({"--output", io::png_beside(exr).string(), true});
}

/// What one frame reads and writes. Frames are checked one by one: all against all would take long.
CommandFiles frame_files(const RenderCommandOptions& options, long frame) {
    CommandFiles files = files_of(options, {options.scene, options.paint, options.brdf});
    const fs::path file = frame_file(options.output, frame);
    files.files = {
        {"--report", options.report}, {"--output", file.string()}, {"--video", options.video.path}};
    if (!options.shard) add_png_beside(files, file);
    return files;
}

/// Warns of what its paints hardly are, and refuses a model that shows none of them.
void check_scene(const RenderCommandOptions& options, const Scene& scene) {
    const std::string slot = options.paint.empty() ? "" : find_paint(options.paint).string();
    for (const Paint& paint : scene.paints()) {
        if (paint.file() != slot) warn_of_implausible(options, paint);  // else done when opened
        say_warnings(options, paint);
    }
    check_model(options, scene);
}

ExitStatus render_frames(RenderCommandOptions options, const Painted& start,
                         const Stopwatch& watch) {
    const Frames frames = parse_frames(options.frames);
    const double step_deg = options.step_deg.value_or(360.0 / static_cast<double>(frames.count()));
    const render::Turning turning = render::turning_called(*options.turntable);
    nlohmann::json all = nlohmann::json::array();
    bool complete = true;
    std::optional<Scene> scene;  // the last one keeps the paints solved for the next
    for (long frame = frames.first; frame <= frames.last && complete; ++frame) {
        require_going();
        check_files(frame_files(options, frame));
        Painted turned = start;
        turned.description = render::turned(std::move(turned.description), turning,
                                            step_deg * static_cast<double>(frame));
        const bool is_first = !scene;
        scene = scene_of(options, std::move(turned));
        if (is_first) check_scene(options, *scene);
        // Noise that stays while the paint moves would look like dirt on the lens.
        options.render.seed = options.seed + static_cast<std::uint64_t>(frame);
        all.push_back(render_to(options, *scene, frame_file(options.output, frame)));
        complete = all.back()["complete"];
    }
    if (complete && !options.video.path.empty()) {
        const fs::path output = replaced(options.output, "%", "%%");
        const fs::path frames_exr =
            fs::path(output).replace_extension(".%04d" + output.extension().string());
        write_video(options.video, io::png_beside(frames_exr).string(), frames.first,
                    frames.count());
        say(options, fmt::format("{}: {} frames, {} a second", options.video.path, frames.count(),
                                 options.video.frames_per_s));
    }
    write_report(options, "render",
                 {{"frames", std::move(all)},
                  {"turntable", *options.turntable},
                  {"step_deg", step_deg},
                  {"complete", complete},
                  {"total_s", watch.seconds()}});
    return complete ? ExitStatus::ok : ExitStatus::failure;
}

ExitStatus run(RenderCommandOptions options) {
    if (!options.model.model_given && asks_for_table(options.model)) {
        options.model.model = models::default_model().info().name;  // the one that makes tables
    }
    parse_model_settings(options.model);  // before any work
    check_choices(options);
    parse_size(options.size, options.render);
    options.render.seed = options.seed;
    if (options.spp) options.render.samples_per_pixel = *options.spp;
    render::check(options.render);
    if (options.shard) {
        options.share = parse_share(*options.shard, options.render.samples_per_pixel);
    }
    const ThreadLimit threads(options.threads);
    const InterruptHandler interrupt;
    const Stopwatch watch;

    Painted start = painted(options);
    if (!options.frames.empty()) return render_frames(options, start, watch);
    const Scene scene = scene_of(options, std::move(start));
    check_scene(options, scene);
    const double prepare_s = watch.seconds();
    nlohmann::json report = render_to(options, scene, options.output);
    const bool complete = report["complete"];
    report["prepare_s"] = prepare_s;
    report["total_s"] = watch.seconds();
    write_report(options, "render", std::move(report));
    return complete ? ExitStatus::ok : ExitStatus::failure;
}

CommandFiles files(const RenderCommandOptions& options) {
    check_extension(options, options.shard ? ".h5" : ".exr");
    if (!options.frames.empty()) return frame_files(options, parse_frames(options.frames).first);
    CommandFiles files = files_of(options, {options.scene, options.paint, options.brdf});
    if (!options.shard) add_png_beside(files, options.output);
    return files;
}

std::string joined_scene_names() {
    std::string names;
    for (const std::string& name : render::builtin_scene_names()) {
        names += (names.empty() ? "" : ", ") + name;
    }
    return names;
}

}  // namespace

Command add_render(CLI::App& program) {
    auto options = std::make_shared<RenderCommandOptions>();
    CLI::App* command = program.add_subcommand("render", "Render a picture of a painted scene");
    command
        ->add_option("SCENE", options->scene,
                     "Scene file (TOML), or a built-in scene: " + joined_scene_names())
        ->required();
    command
        ->add_option("--paint", options->paint,
                     "Recipe (TOML) or solved paint (HDF5) for the scene's unnamed paint")
        ->type_name("RECIPE");
    command
        ->add_option("--brdf", options->brdf,
                     "Measured BRDF (.bsdf of the RGL database, .binary of MERL) for it instead")
        ->type_name("FILE");
    add_model_options(*command, options->model);
    command
        ->add_option("--footprint", options->render.footprint_pixels,
                     fmt::format("{}: side of a patch that each sample shows, pixels, for "
                                 "experiments; 0: the samples share out what the pixel shows",
                                 fmt::join(sparkling_models(), ", ")))
        ->check(CLI::Range(0.0, 1000.0))
        ->capture_default_str();
    command->add_flag("--sparkle", options->render.sparkle,
                      "Keep the light of single flakes apart as well, in the EXR's channels "
                      "sparkle.R, .G, .B: what they send less their mean");
    command
        ->add_option("--spp", options->spp,
                     fmt::format("Samples per pixel [{}]; with --noise at most [{}]",
                                 options->render.samples_per_pixel, kMostSamplesForNoise))
        ->check(CLI::Range(1, 1 << 24));
    command
        ->add_option("--noise", options->noise,
                     "Take as many samples as this noise needs: the standard error of a pixel over "
                     "the mean luminance, as 0.01")
        ->check(CLI::Range(render::kNoiseRange.lo, render::kNoiseRange.hi));
    command->add_option("--frames", options->frames,
                        "Render frames FIRST:LAST, as 0:35, to files numbered out.0000.exr ...");
    command
        ->add_option("--turntable", options->turntable,
                     "With --frames: shape, camera or light turns about the vertical")
        ->check(CLI::IsMember({"shape", "camera", "light"}));
    command
        ->add_option("--step", options->step_deg,
                     "With --frames: deg from frame to frame; frame 0 is the scene as it is [a "
                     "whole turn in all frames]")
        ->check(CLI::Range(-360.0, 360.0));
    command
        ->add_option("--video", options->video.path,
                     "With --frames: a video of them besides, by ffmpeg: .mp4, .mkv, .webm, .gif")
        ->type_name("FILE");
    command->add_option("--fps", options->video.frames_per_s, "Frames a second of the video")
        ->check(CLI::Range(0.1, 240.0))
        ->capture_default_str();
    command->add_option("--size", options->size, "Pixels as WIDTHxHEIGHT")->capture_default_str();
    command->add_option("--depth", options->render.max_depth, "Surface reflections along a path")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    command
        ->add_option("--spectral-bins", options->render.spectral_bins,
                     "Spectral channels over 400 to 700 nm in the EXR; 0: none")
        ->check(CLI::Range(0, 300))
        ->capture_default_str();
    command
        ->add_option("--shard", options->shard,
                     "Render share I of N of the samples only, as 2/8, for nacre merge; -o then "
                     "names an .h5")
        ->type_name("I/N");
    add_tone_map(*command, options->tone_map);
    add_picture_output(*command, *options);
    add_seed(*command, *options);
    add_input_options(*command, *options);
    add_set(*command, *options);
    add_run_options(*command, *options);
    command->footer(
        "The EXR holds linear Rec. 709 (1 is the perfect diffuser in full light), albedo and "
        "normal\n"
        "for denoisers, and the settings; the PNG is tone-mapped for looking at. With --sparkle,\n"
        "take sparkle from the picture, denoise the rest and add it again. For a given seed\n"
        "the picture does not depend on the number of threads. Ctrl-C writes what is there, marks\n"
        "it as partial and ends with status 3; of a share it writes nothing.\n\n"
        "Example:\n"
        "  nacre render sphere --paint paints/red-gold.toml --spp 256 --size 512x512 -o red.exr");
    return {command, [options] { return files(*options); }, [options] { return run(*options); }};
}

}  // namespace nacre::cli
