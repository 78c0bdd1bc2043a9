#include "nacre/cli/plot_files.h"

#include "nacre/core/atomic_file.h"
#include "nacre/report/plot_svg.h"
#include "nacre/report/svg_raster.h"
#include "nacre/study/gallery.h"

namespace nacre::cli {

void write_plots(const std::filesystem::path& folder, const std::vector<panel::NamedPlot>& plots) {
    constexpr double kPngScale = 2;
    study::make_folder(folder);
    for (const panel::NamedPlot& named : plots) {
        const std::string svg = report::plot_svg(named.plot);
        write_file_atomically(folder / (named.name + ".svg"), svg);
        write_file_atomically(folder / (named.name + ".png"), report::png_of_svg(svg, kPngScale));
    }
}

}  // namespace nacre::cli
