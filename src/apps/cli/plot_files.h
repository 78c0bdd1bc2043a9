#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "apps/datasheet/measurement_plots.h"
#include "nacre/core/file.h"

namespace nacre::cli {

/// Each plot as NAME.svg and NAME.png in a folder, which is made if it is not there.
/// @throws InputError naming the folder if it cannot be made
std::vector<FileContents> plot_files(const std::filesystem::path& folder,
                                     const std::vector<datasheet::NamedPlot>& plots);

/// The names of all files that it writes of plots of these names.
std::vector<std::string> plot_file_names(std::span<const char* const> plots);
/// Those of the plots of a measurement.
std::vector<std::string> plot_file_names();

}  // namespace nacre::cli
