#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "nacre/core/text.h"
#include "nacre/io/file_kind.h"
#include "nacre/render/scene.h"

// What `nacre info` says of files that are not paints: measured colours, what recipes and scenes
// name, and results that are not read again.

namespace nacre::cli {

/// Lines of "name: value".
class Facts {
 public:
    template <class... Args>
    void add(const std::string& name, fmt::format_string<Args...> format, Args&&... args) {
        text_ += printable(name) + ": " +
                 printable(fmt::format(format, std::forward<Args>(args)...)) + "\n";
    }
    const std::string& text() const { return text_; }

 private:
    std::string text_;
};

/// @param sample  the one that is meant; empty: all
/// @return what is to be warned of: columns that contradict each other
/// @throws InputError as io::parse_measurement_file() and io::sample_called()
std::vector<std::string> describe_measured_colours(Facts& facts, const io::TypedFile& file,
                                                   const std::string& sample);

/// @throws InputError as render::make_mesh(), naming the shape
void describe_scene(Facts& facts, const render::SceneDescription& scene);

/// Files of every kind that neither open() nor a function above reads.
/// @throws InputError naming the file and what is wrong in it, or what it is if nothing of Nacre's
///         reads or writes it
void describe_other(Facts& facts, const io::TypedFile& typed);

}  // namespace nacre::cli
