#include "apps/cli/files.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <optional>

#include "apps/cli/options.h"
#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/io/image.h"
#include "nacre/io/named_files.h"

namespace nacre::cli {

namespace {

namespace fs = std::filesystem;

/// Whether two names mean one regular file: through links too, and before it exists. Devices and
/// pipes may be read and written at once.
bool is_same_file(const fs::path& a, const fs::path& b) {
    std::error_code ec;
    const fs::file_status status_a = fs::status(a, ec), status_b = fs::status(b, ec);
    if (fs::exists(status_a) != fs::exists(status_b)) return false;
    if (fs::exists(status_a)) return fs::is_regular_file(status_a) && fs::equivalent(a, b, ec);
    return fs::weakly_canonical(fs::absolute(a, ec), ec) ==
           fs::weakly_canonical(fs::absolute(b, ec), ec);
}

/// An input and how messages name it.
struct Input {
    fs::path path;
    std::string text;
};

std::optional<fs::path> file_named(const std::string& text) {
    std::error_code ec;
    if (text == "-") return file_named("/dev/stdin");
    for (std::size_t size = text.size(); size != 0 && size != std::string::npos;
         size = text.rfind(':', size - 1)) {
        const fs::path path = text.substr(0, size);
        if (fs::is_regular_file(path, ec)) return path;
    }
    return std::nullopt;
}

/// Those that exist, and what they name.
std::vector<Input> existing_inputs(const std::vector<std::string>& texts) {
    std::vector<Input> inputs;
    for (const std::string& text : texts) {
        const auto path = file_named(text);
        if (!path) continue;
        inputs.push_back({*path, fmt::format("'{}'", path->string())});
        if (text == "-" || text.starts_with("/dev/") || text.starts_with("/proc/")) {
            continue;  // an open file: to look into it would take its bytes from the command
        }
        for (const fs::path& named : io::files_named_by(*path)) {
            inputs.push_back(
                {named, fmt::format("'{}', which '{}' names", named.string(), path->string())});
        }
    }
    return inputs;
}

void check_not_an_input(const Output& output, const std::vector<Input>& inputs) {
    for (const Input& input : inputs) {
        if (!is_same_file(output.name, input.path)) continue;
        throw UsageError(fmt::format("{} = {}: would replace an input, {}", output.option,
                                     output.name, input.text));
    }
}

void check_not_another(const Output& output, const Output& other) {
    if (!is_same_file(output.name, other.name)) return;
    throw UsageError(fmt::format("{} = {}: is the same file as {} = {}", output.option, output.name,
                                 other.option, other.name));
}

}  // namespace

CommandFiles files_of(const CommonOptions& options, std::vector<std::string> inputs) {
    return {std::move(inputs), {{"--output", options.output}, {"--report", options.report}}, {}};
}

void check_files(const CommandFiles& files) {
    std::vector<Output> outputs = files.files;
    std::erase_if(outputs, [](const Output& output) { return output.name.empty(); });
    const std::vector<Input> inputs =
        outputs.empty() ? std::vector<Input>() : existing_inputs(files.inputs);
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        check_not_an_input(outputs[i], inputs);
        for (std::size_t j = 0; j < i; ++j) check_not_another(outputs[i], outputs[j]);
    }
    for (const Output& output : outputs) {
        check_output_file(output.name);
        if (output.beside) io::check_png_beside(output.name);
    }
    for (const Output& folder : files.folders) {
        if (!folder.name.empty()) check_output_folder(folder.name);
    }
}

void check_names(const CLI::App& command) {
    for (const CLI::Option* option : command.get_options()) {
        const std::string type = option->get_type_name();
        if (!type.starts_with("FILE") && type != "DIR" && type != "RECIPE") continue;
        for (const std::string& name : option->results()) {
            if (!name.empty()) continue;
            throw UsageError(fmt::format("{}: the name of a {} is expected", option->get_name(),
                                         type == "DIR" ? "folder" : "file"));
        }
    }
}

}  // namespace nacre::cli
