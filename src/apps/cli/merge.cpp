#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "apps/cli/options.h"
#include "apps/cli/picture_output.h"
#include "nacre/render.h"

namespace nacre::cli {

namespace {

namespace fs = std::filesystem;

struct MergeOptions : CommonOptions {
    std::vector<std::string> shards;
    ToneMap tone_map;
};

ExitStatus run_merge(const MergeOptions& options) {
    const Stopwatch watch;
    const Picture picture =
        merge_shards(std::vector<fs::path>(options.shards.begin(), options.shards.end()));
    warn_of_picture(options, picture.result, picture.metadata.at("nacre:scene"));
    const std::string clipped = write_picture(options.output, picture.image(), options.tone_map);
    say(options, fmt::format("{}; of {} shards{}", summary(picture.result, options.output),
                             options.shards.size(), clipped));
    nlohmann::json report = report_of(picture.result, options.output, options.tone_map);
    report["shares"] = options.shards;
    report["header"] = picture.metadata;
    report["total_s"] = watch.seconds();
    write_report(options, "merge", std::move(report));
    return ExitStatus::ok;
}

CommandFiles merge_files(const MergeOptions& options) {
    check_extension(options, ".exr");
    CommandFiles files = files_of(options, options.shards);
    files.files.push_back({"--output", io::png_beside(options.output).string(), true});
    return files;
}

}  // namespace

Command add_merge(CLI::App& program) {
    auto options = std::make_shared<MergeOptions>();
    CLI::App* command = program.add_subcommand("merge", "Put the shards of a picture together");
    command
        ->add_option("SHARD", options->shards,
                     "Files of nacre render --shard, all of one picture, in any order")
        ->required()
        ->type_name("FILE");
    add_tone_map(*command, options->tone_map);
    add_picture_output(*command, *options);
    add_quiet(*command, *options);
    add_report(*command, *options);
    command->footer(
        "The picture is the one that nacre render makes without --shard, bit for bit. A shard "
        "that\n"
        "is missing, there twice or of another picture is refused. Its seconds are those of all\n"
        "shards together.\n\n"
        "Example:\n"
        "  nacre render sphere --paint ruby --spp 256 --shard 1/2 -o ruby.1.h5\n"
        "  nacre render sphere --paint ruby --spp 256 --shard 2/2 -o ruby.2.h5\n"
        "  nacre merge ruby.1.h5 ruby.2.h5 -o ruby.exr");
    return {command, [options] { return merge_files(*options); },
            [options] { return run_merge(*options); }};
}

}  // namespace nacre::cli
