#include "apps/cli/plot_files.h"

#include "apps/report/plot_svg.h"
#include "apps/report/svg_raster.h"
#include "apps/study/folder.h"
#include "nacre/core/file.h"

namespace nacre::cli {

void write_plots(const std::filesystem::path& folder,
                 const std::vector<datasheet::NamedPlot>& plots) {
    constexpr double kPngScale = 2;
    study::make_folder(folder);
    for (const datasheet::NamedPlot& named : plots) {
        const std::string svg = report::plot_svg(named.plot);
        write_file_atomically(folder / (named.name + ".svg"), svg);
        write_file_atomically(folder / (named.name + ".png"), report::png_of_svg(svg, kPngScale));
    }
}

std::vector<std::string> plot_file_names(std::span<const char* const> plots) {
    std::vector<std::string> names;
    for (const char* plot : plots) {
        for (const char* extension : {".svg", ".png"})
            names.push_back(plot + std::string(extension));
    }
    return names;
}

std::vector<std::string> plot_file_names() { return plot_file_names(datasheet::kMeasurementPlots); }

}  // namespace nacre::cli
