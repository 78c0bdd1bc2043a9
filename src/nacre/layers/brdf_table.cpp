#include "nacre/layers/brdf_table.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <numeric>

#include "nacre/core/error.h"
#include "nacre/core/parallel.h"
#include "nacre/layers/brdf_table_row.h"

namespace nacre::layers {

namespace {

double mean(const std::vector<double>& v) {
    return std::accumulate(v.begin(), v.end(), 0.0) / static_cast<double>(v.size());
}

// Roughness of the narrowest lobe on the side on which the grid measures half vectors.
double narrowest_lobe(const PaintMedium& medium, double ior) {
    double alpha = 1;
    for (const LayerMedium& layer : medium.layers) {
        for (const FlakeMedium& flake : layer.flakes) alpha = std::min(alpha, flake.alpha);
    }
    if (medium.roughness > 0) alpha = std::min(ior * alpha, medium.roughness);
    return alpha;
}

BrdfGrid make_grid(const SolvedPaint& paint, const BrdfTableSettings& settings) {
    const PaintMedium& medium = paint.medium;
    for (int w = 0; w < medium.wavelength_count(); ++w) {
        if (paint.is_rough(w) != paint.is_rough(0)) {
            throw Error(
                "a rough clearcoat whose binder has the index 1 at some wavelengths only cannot "
                "be tabulated");
        }
    }
    BrdfGrid grid;
    grid.angles = settings.angles;
    grid.azimuths = settings.azimuths;
    grid.ior = mean(medium.ior);
    grid.roughness = paint.is_rough(0) ? medium.roughness : 0.0;
    grid.lobe_alpha = narrowest_lobe(medium, grid.ior);
    validate(grid);
    return grid;
}

}  // namespace

RawBrdfTable make_raw_table(const SolvedPaint& paint, const BrdfTableSettings& settings,
                            const Progress& progress) {
    RawBrdfTable table;
    table.paint = paint.recipe.name;
    table.grid = make_grid(paint, settings);
    table.values.resize(3 * table.grid.values());
    const std::size_t n = table.grid.angles, line = 3 * table.grid.azimuths;
    const BrdfTableRows rows(paint, table.grid);

    std::atomic<bool> go_on = true;
    std::mutex mutex;
    std::size_t done = 0;  // pairs
    parallel_for_ranges(0, n, 1, [&](std::size_t first, std::size_t last) {
        for (std::size_t step = first; step < last && go_on; ++step) {
            const std::size_t i = n - 1 - step;  // long rows first
            BrdfTableRows::Workspace work = rows.make_workspace(static_cast<int>(i));
            for (std::size_t o = 0; o <= i; ++o) {
                float* out = table.values.data() + (i * n + o) * line;
                rows.evaluate(work, static_cast<int>(o), out);
                if (o != i) std::copy_n(out, line, table.values.data() + (o * n + i) * line);
            }
            if (!progress) continue;
            const std::scoped_lock lock(mutex);
            done += i + 1;
            if (!progress(2.0 * static_cast<double>(done) / static_cast<double>(n * (n + 1)))) {
                go_on = false;
            }
        }
    });
    if (!go_on) throw Error("making the BRDF table was stopped");
    return table;
}

}  // namespace nacre::layers
