#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "apps/datasheet/measurement_plots.h"

namespace nacre::cli {

/// Writes each plot as NAME.svg and NAME.png into a folder, which is made if it is not there.
/// @throws InputError naming the folder if it cannot be made; Error if a file cannot be written
void write_plots(const std::filesystem::path& folder,
                 const std::vector<datasheet::NamedPlot>& plots);

/// The names of all files that it writes of plots of these names.
std::vector<std::string> plot_file_names(std::span<const char* const> plots);
/// Those of the plots of a measurement.
std::vector<std::string> plot_file_names();

}  // namespace nacre::cli
