#include "nacre/render.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "apps/cli/paint_options.h"
#include "apps/cli/picture_output.h"
#include "apps/cli/render_options.h"
#include "apps/cli/video.h"
#include "nacre/core/error.h"
#include "nacre/core/parallel.h"
#include "nacre/core/progress.h"
#include "nacre/render/turntable.h"

namespace nacre::cli {

namespace {

namespace fs = std::filesystem;

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
    return {std::move(description),
            {std::move(slot), chosen_model(options.model), options.model.specimen}};
}

Scene scene_of(const RenderCommandOptions& options, Painted painted) {
    const std::optional<bsdf::Model> model = painted.paints.model;
    ProgressBar bar("prepare", options.quiet || !model || !model->makes_table());
    try {
        return Scene(std::move(painted.description), painted.paints, bar.callback());
    } catch (const SettingError& error) {  // where the model does not go
        if (error.setting() != "model" || !model) throw;
        throw UsageError(fmt::format("{}: {}", choice_of(model->info()), error.reason()));
    }
}

/// Refuses model options where every paint is a measured BRDF, which takes no model.
void check_model(const RenderCommandOptions& options, const Scene& scene) {
    if (scene.paints().empty() || scene.shows_model()) return;
    const std::string all = "every material of the scene " + options.scene;
    if (options.render.sparkle) refuse_choice("--sparkle", all);
    if (options.render.footprint_pixels != 0) refuse_choice("--footprint", all);
    const bsdf::Model model = parse_model_settings(options.model);
    if (!options.model.model_given && model.makes_table()) {
        throw UsageError(
            fmt::format("{}: every material of the scene {} holds a measured BRDF; "
                        "tables are made of recipes",
                        choice_of_table(model), options.scene));
    }
    if (const auto choice = choice_of_any(options.model)) refuse_choice(*choice, all);
}

/// "out.exr" of frame 7: "out.0007.exr".
fs::path frame_file(const fs::path& output, long frame) {
    return fs::path(output).replace_extension(
        fmt::format(".{:04}{}", frame, output.extension().string()));
}

/// Without --noise the samples that were asked for.
int samples_for(const RenderCommandOptions& options, const Scene& scene) {
    if (!options.noise) return options.render.samples_per_pixel;
    ProgressBar bar("noise", options.quiet);
    return scene.samples_for_noise(options.render, *options.noise,
                                   options.spp.value_or(kMaxSamplesForNoise), bar.callback());
}

/// Of a picture and a shard.
void add_scene_report(nlohmann::json& report, const RenderCommandOptions& options,
                      const Scene& scene, const render::RenderOptions& how) {
    report["scene"] = options.scene;
    report["scene_sha256"] = scene.sha256();
    report["model"] = scene.model_name();
    report["model_settings"] = scene.model_settings();
    report["recipe_sha256"] = scene.recipe_sha256();
    report["seed"] = how.seed;
    report["depth"] = how.max_depth;
    report["footprint_pixels"] = how.footprint_pixels;
    report["specimen"] = scene.specimen() ? nlohmann::json(*scene.specimen()) : nullptr;
}

/// Renders a shard of one picture and writes it. @return for the report
nlohmann::json render_shard_to(const RenderCommandOptions& options, const Scene& scene,
                               const fs::path& file) {
    render::RenderOptions how = options.render;
    how.noise = true;
    PictureShard shard = [&] {
        ProgressBar bar("render", options.quiet);
        return scene.render_shard(how, *options.shard, bar.callback());
    }();
    shard.metadata["nacre:scene"] = options.scene;
    write_shard(file, shard);
    const int samples = render::samples_of(how, *options.shard);
    say(options,
        fmt::format("{}: shard {}/{} of {} x {} pixels, {} of {} samples each, {}", file.string(),
                    options.shard->number, options.shard->count, how.width, how.height, samples,
                    how.samples_per_pixel, duration_text(shard.sums.seconds)));
    nlohmann::json report = {{"output", {file.string()}},
                             {"width", how.width},
                             {"height", how.height},
                             {"share", options.shard->number},
                             {"shares", options.shard->count},
                             {"samples_per_pixel", samples},
                             {"complete", true},
                             {"render_s", shard.sums.seconds}};
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
    const bool capped = how.samples_per_pixel == options.spp.value_or(kMaxSamplesForNoise);
    if (options.noise && capped && result.complete && result.noise > options.noise) {
        say(options,
            fmt::format("nacre: the noise is {}, not {}: {} samples were the most that "
                        "--spp allows",
                        percent_text(*result.noise), percent_text(*options.noise), result.samples));
    }
    nlohmann::json report = report_of(result, exr, options.tone_map);
    add_scene_report(report, options, scene, how);
    return report;
}

nlohmann::json render_to(const RenderCommandOptions& options, const Scene& scene,
                         const fs::path& output) {
    return options.shard ? render_shard_to(options, scene, output)
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
    if (!options.shard_text) add_png_beside(files, file);
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
        throw_if_stopped();
        check_files(frame_files(options, frame));
        Painted turned = start;
        const double turn_deg = step_deg * static_cast<double>(frame);
        turned.description = render::turned(std::move(turned.description), turning, turn_deg);
        const bool is_first = !scene;
        if (scene) turned.paints.known = scene->named_paints();
        scene = scene_of(options, std::move(turned));
        if (is_first) check_scene(options, *scene);
        // Noise that stays while the paint moves would look like dirt on the lens.
        options.render.seed = options.seed + static_cast<std::uint64_t>(frame);
        all.push_back(render_to(options, *scene, frame_file(options.output, frame)));
        all.back()["turn_deg"] = turn_deg;
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
    choose_by_table(options.model);
    parse_model_settings(options.model);  // before any work
    check_choices(options);
    parse_size(options.size, options.render);
    options.render.seed = options.seed;
    if (options.spp) options.render.samples_per_pixel = *options.spp;
    render::check(options.render);
    if (options.shard_text) {
        options.shard = parse_shard(*options.shard_text, options.render.samples_per_pixel);
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
    check_extension(options, options.shard_text ? ".h5" : ".exr");
    if (!options.frames.empty()) return frame_files(options, parse_frames(options.frames).first);
    CommandFiles files = files_of(options, {options.scene, options.paint, options.brdf});
    if (!options.shard_text) add_png_beside(files, options.output);
    return files;
}

}  // namespace

Command add_render(CLI::App& program) {
    auto options = std::make_shared<RenderCommandOptions>();
    CLI::App* command = program.add_subcommand("render", "Render a picture of a painted scene");
    add_render_options(*command, *options);
    return {command, [options] { return files(*options); }, [options] { return run(*options); }};
}

}  // namespace nacre::cli
