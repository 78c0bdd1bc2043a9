#include "apps/cli/plot_files.h"

#include "apps/report/plot_svg.h"
#include "apps/report/svg_raster.h"
#include "apps/study/folder.h"

namespace nacre::cli {

std::vector<FileContents> plot_files(const std::filesystem::path& folder,
                                     const std::vector<datasheet::NamedPlot>& plots) {
    study::make_folder(folder);
    std::vector<FileContents> files;
    for (const datasheet::NamedPlot& named : plots) {
        std::string svg = report::plot_svg(named.plot);
        std::string png = report::png_of_svg(svg, report::kPngScale);
        files.push_back({folder / (named.name + ".svg"), std::move(svg)});
        files.push_back({folder / (named.name + ".png"), std::move(png)});
    }
    return files;
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
