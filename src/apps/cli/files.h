#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/core/references.h"

// The files that a command reads and writes. They are checked in one place, before the work: a
// result must not replace what it was made from, and hours of work must not end at a folder that
// is not there.

namespace CLI {
class App;
}

namespace nacre::cli {

struct CommonOptions;

/// A file to be written, by the option that says so; an empty name: none.
struct Output {
    std::string option;  ///< for messages, as in "--output"
    std::string name;
    /// A PNG beside an EXR: nobody named it, so that only one of Nacre's own may be replaced.
    bool beside = false;
    /// "CSV" or "JSON": a name that ends like that of another format is refused. Empty: the name
    /// has been looked at already, or may end as it likes.
    std::string format = {};
    /// An input, as CommandFiles names it, that the flag --overwrite lets this file replace.
    std::string may_replace = {};
    bool overwrite = false;  ///< the flag was given
};

/// A folder to be written into; an empty name: none.
struct OutputFolder {
    std::string option, name;
    /// The names of all files that the command may write there. A PNG has the rights of one beside
    /// an EXR if that is among them.
    std::vector<std::string> files = {};
};

/// A file that is read, and how messages name it.
struct Input {
    std::filesystem::path path;
    std::string text;
};

/// The outputs that check_files() was asked about last, and the files that inputs were found to name as
/// they were read (checked_references()).
struct FilesInUse {
    std::vector<Output> outputs;
    std::vector<Input> named;
};

struct CommandFiles {
    /// As on the command line. Numbers may follow, as in "film.csv:80", and what names no file is
    /// passed over: a built-in scene, a shipped material.
    std::vector<std::string> inputs;
    std::vector<Output> files;
    std::vector<OutputFolder> folders = {};
    bool untrusted = false;  ///< inputs name files in their folders only
    bool prints = false;     ///< data to the standard output, whatever the files are called
    std::shared_ptr<FilesInUse> in_use = {};  ///< null: no input names any
};

/// What a command with --output and --report reads and writes.
/// @param format  of --output, as Output::format
CommandFiles files_of(const CommonOptions& options, std::vector<std::string> inputs,
                      const std::string& format = {});

/// Checks that each output can be written, as far as that shows beforehand, and that none is an
/// input, a file that an input names (a mesh, or one that has been read), or another output: by name,
/// or the same file through links.
/// @throws UsageError naming both where an output is an input or another output, or naming what is
///         written where an output is called like something else
/// @throws InputError as check_output_file(), check_output_folder() and io::check_png_beside()
void check_files(const CommandFiles& files);

/// The files that an input may name, none of which may be an output: which one it names shows as it is
/// read, which every command does before its work.
/// @param input  as messages name it
/// @return  refuses by the UsageError of check_files() what is an output
References checked_references(const References& references, const std::string& input,
                              std::shared_ptr<FilesInUse> in_use);

/// Whether a name means the standard output, or the file to which that is redirected.
bool is_standard_output(const std::string& name);

/// What a value of --set may name: its texts, which are the whole where nothing begins with a quote
/// or is a list or a table. They are parts of `value`.
std::vector<std::string_view> texts_of_setting(std::string_view value);

/// Refuses options that were given an empty value: no option means anything by it.
/// @throws UsageError naming the option
void check_values(const CLI::App& command);

}  // namespace nacre::cli
