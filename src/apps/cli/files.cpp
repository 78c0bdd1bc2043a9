#include "apps/cli/files.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

#include "apps/cli/options.h"
#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/core/text.h"
#include "nacre/io/image.h"
#include "nacre/io/measurement_file.h"
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

std::optional<fs::path> file_named(const std::string& text) {
    std::error_code ec;
    if (const io::SampleName name = io::split_sample_name(text); !name.sample.empty()) {
        return file_named(name.file.string());
    }
    for (std::size_t size = text.size(); size != 0 && size != std::string::npos;
         size = text.rfind(':', size - 1)) {
        const std::string name = text.substr(0, size);
        const fs::path path = name == "-" ? "/dev/stdin" : name;
        if (fs::is_regular_file(path, ec)) return path;
    }
    return std::nullopt;
}

/// A file that an input names, and what it names in turn, if it is a mesh.
/// @param references  those of the input
void add_named(const fs::path& named, const std::string& input, const References& references,
               std::vector<Input>& inputs) {
    const auto add = [&](const fs::path& path) {
        inputs.push_back({path, fmt::format("'{}', which '{}' names", path.string(), input)});
    };
    std::error_code ec;
    if (!fs::is_regular_file(named, ec)) return;
    add(named);
    for (const fs::path& path : io::files_named_by(named, references.beside(named))) add(path);
}

/// Those that exist, and what those among them name that are meshes.
std::vector<Input> existing_inputs(const CommandFiles& files) {
    std::vector<Input> inputs;
    for (const std::string& text : files.inputs) {
        const auto path = file_named(text);
        if (!path) continue;
        inputs.push_back({*path, fmt::format("'{}'", path->string())});
        const References references =
            files.untrusted ? References::of_untrusted_file(*path) : References::of_file(*path);
        for (const fs::path& named : io::files_named_by(*path, references)) {
            add_named(named, path->string(), references, inputs);
        }
    }
    return inputs;
}

void check_not_an_input(const Output& output, const std::vector<Input>& inputs) {
    for (const Input& input : inputs) {
        if (!is_same_file(output.name, input.path)) continue;
        const bool optional =
            !output.may_replace.empty() && is_same_file(output.may_replace, input.path);
        if (optional && output.overwrite) continue;
        throw UsageError(fmt::format("{} = {}: would replace an input, {}{}", output.option,
                                     output.name, input.text,
                                     optional ? "; --overwrite allows it" : ""));
    }
}

void check_not_another(const Output& output, const Output& other) {
    if (!is_same_file(output.name, other.name) &&
        !(is_standard_output(output.name) && is_standard_output(other.name))) {
        return;
    }
    throw UsageError(fmt::format("{} = {}: is the same file as {} = {}", output.option, output.name,
                                 other.option, other.name));
}

/// Two outputs there would be mixed.
void check_not_printed_to(const Output& output) {
    if (!is_standard_output(output.name)) return;
    throw UsageError(
        fmt::format("{} = {}: is the standard output, which takes another output of the same "
                    "command",
                    output.option, output.name));
}

/// CSV in a file that is called .xlsx would be opened as what it is not, and the same elsewhere.
void check_format(const Output& output) {
    constexpr std::pair<std::string_view, std::string_view> kFormats[] = {
        {".csv", "CSV"},
        {".json", "JSON"},
        {".xlsx", "a spreadsheet"},
        {".xls", "a spreadsheet"},
        {".ods", "a spreadsheet"},
        {".tsv", "a table with tabs"},
        {".toml", "TOML"},
        {".h5", "HDF5"},
        {".hdf5", "HDF5"},
        {".exr", "a picture"},
        {".png", "a picture"},
        {".jpg", "a picture"},
        {".svg", "a drawing"},
        {".html", "a page"},
        {".pdf", "a document"},
        {".xml", "XML"},
        {".cxf", "XML"},
        {".bsdf", "a measured BRDF"},
        {".binary", "a measured BRDF"}};
    if (output.format.empty()) return;
    const std::string extension = lowercase(fs::path(output.name).extension().string());
    for (const auto& [suffix, format] : kFormats) {
        if (extension != suffix || format == output.format) continue;
        throw UsageError(
            fmt::format("{} = {}: is {} by its name, but what is written is {}; {}", output.option,
                        output.name, format, output.format,
                        format == "JSON" ? "--format json, where a command has it, writes JSON"
                        : output.format == "JSON" ? "end the name in .json"
                        : format == "a spreadsheet"
                            ? "end the name in .csv, which spreadsheets open (--decimal "
                              "comma and --bom where they expect these)"
                            : "end the name in .csv"));
    }
}

/// A file cannot be where a folder is to be made, or one above it.
void check_not_a_folder(const Output& output, const OutputFolder& folder) {
    std::error_code ec;
    for (fs::path part = fs::absolute(folder.name, ec); part.has_relative_path();
         part = part.parent_path()) {
        if (!is_same_file(output.name, part)) continue;
        throw UsageError(fmt::format("{} = {}: is the folder for {} = {}", output.option,
                                     output.name, folder.option, folder.name));
    }
}

/// The files that a command may write into a folder.
std::vector<Output> outputs_in(const OutputFolder& folder) {
    std::vector<Output> outputs;
    for (const std::string& name : folder.files) {
        const std::string exr = fs::path(name).replace_extension(".exr").string();
        const bool beside =
            name != exr && std::ranges::find(folder.files, exr) != folder.files.end();
        outputs.push_back({folder.option, (fs::path(folder.name) / name).string(), beside});
    }
    return outputs;
}

}  // namespace

bool is_standard_output(const std::string& name) {
    const std::string plain = fs::path(name).lexically_normal().string();
    return name == "-" || plain == "/dev/stdout" || plain == "/dev/fd/1" ||
           plain == "/proc/self/fd/1" || is_same_file(name, "/dev/stdout");
}

std::vector<std::string_view> texts_of_setting(std::string_view value) {
    const std::string_view whole = trimmed(value);
    constexpr std::string_view kQuotes = "\"'";
    if (whole.empty() || std::string_view("\"'[{").find(whole[0]) == std::string_view::npos) {
        return {whole};
    }
    std::vector<std::string_view> texts;
    std::size_t begin = whole.find_first_of(kQuotes);
    while (begin != std::string_view::npos) {
        const std::size_t end = whole.find(whole[begin], begin + 1);
        if (end == std::string_view::npos) break;
        texts.push_back(whole.substr(begin + 1, end - begin - 1));
        begin = whole.find_first_of(kQuotes, end + 1);
    }
    return texts;
}

CommandFiles files_of(const CommonOptions& options, std::vector<std::string> inputs,
                      const std::string& format) {
    const std::size_t arguments = inputs.size();
    for (const std::string& setting : options.set) {
        const std::size_t equals = std::min(setting.find('='), setting.size() - 1);
        for (const std::string_view text :
             texts_of_setting(std::string_view(setting).substr(equals + 1))) {
            inputs.emplace_back(text);
            for (std::size_t i = 0; i < arguments;
                 ++i) {  // else it is looked for beside the recipe
                inputs.push_back((fs::path(inputs[i]).parent_path() / text).string());
            }
        }
    }
    return {.inputs = std::move(inputs),
            .files = {{"--output", options.output, false, format}, {"--report", options.report}},
            .untrusted = options.untrusted,
            .prints = options.output.empty(),
            .in_use = options.in_use};
}

void check_files(const CommandFiles& files) {
    std::vector<Output> named = files.files;
    std::erase_if(named, [](const Output& output) { return output.name.empty(); });
    std::vector<Output> outputs = named, checked = named;
    std::error_code ec;
    for (const OutputFolder& folder : files.folders) {
        if (folder.name.empty()) continue;
        for (const Output& output : named) check_not_a_folder(output, folder);
        const std::vector<Output> inside = outputs_in(folder);
        outputs.insert(outputs.end(), inside.begin(), inside.end());
        if (fs::is_directory(folder.name, ec)) {
            checked.insert(checked.end(), inside.begin(), inside.end());
        }
    }
    std::vector<Input> inputs = outputs.empty() ? std::vector<Input>() : existing_inputs(files);
    if (files.in_use) {
        inputs.insert(inputs.end(), files.in_use->named.begin(), files.in_use->named.end());
        files.in_use->outputs = outputs;
    }
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        check_not_an_input(outputs[i], inputs);
        if (files.prints) check_not_printed_to(outputs[i]);
        for (std::size_t j = 0; j < i; ++j) check_not_another(outputs[i], outputs[j]);
    }
    for (const Output& output : named) check_format(output);
    for (const Output& output : checked) {
        check_output_file(output.name);
        if (output.beside) io::check_png_beside(output.name);
    }
    for (const OutputFolder& folder : files.folders) {
        if (!folder.name.empty()) check_output_folder(folder.name);
    }
    for (const Output& output : named) check_format(output);
}

References checked_references(const References& references, const std::string& input,
                              std::shared_ptr<FilesInUse> in_use) {
    return references.checked_by([=](const fs::path& path) {
        if (std::ranges::find(in_use->named, path, &Input::path) != in_use->named.end()) return;
        std::vector<Input> named;
        add_named(path, input, references, named);
        for (const Output& output : in_use->outputs) check_not_an_input(output, named);
        in_use->named.insert(in_use->named.end(), named.begin(), named.end());
    });
}

void check_values(const CLI::App& command) {
    for (const CLI::Option* option : command.get_options()) {
        const std::string type = option->get_type_name();
        const bool is_folder = type == "DIR" || type == "FOLDER";
        const bool is_name = is_folder || type.starts_with("FILE") || type == "RECIPE";
        for (const std::string& value : option->results()) {
            if (!value.empty()) continue;
            throw UsageError(fmt::format("{}: {} is expected", option->get_name(),
                                         is_folder ? "the name of a folder"
                                         : is_name ? "the name of a file"
                                                   : "a value"));
        }
    }
}

}  // namespace nacre::cli
