#pragma once

#include <filesystem>
#include <vector>

#include "apps/datasheet/measurement_plots.h"

namespace nacre::cli {

/// Writes each plot as NAME.svg and NAME.png into a folder, which is made if it is not there.
/// @throws InputError naming the folder if it cannot be made; Error if a file cannot be written
void write_plots(const std::filesystem::path& folder,
                 const std::vector<datasheet::NamedPlot>& plots);

}  // namespace nacre::cli
