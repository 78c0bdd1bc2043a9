#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

#include "nacre/bsdf/tabulated/brdf_table.h"
#include "nacre/core/parallel.h"
#include "nacre/core/progress.h"

namespace nacre::bsdf {

/// Sets the values of all pairs of polar nodes, in parallel: those of (o, i) are those of (i, o).
/// @param what    is made, for the message
/// @param row_of  (i) -> (o, out): for o <= i sets the values of a pair, [azimuth][channel]; what
///                it gives is used by one thread
/// @throws Stopped "making `what` was stopped"
template <class RowOf>
void set_pairs(RawBrdfTable& table, const char* what, const Progress& progress,
               const RowOf& row_of) {
    const std::size_t n = table.grid.angles, line = 3 * table.grid.azimuths;
    table.values.resize(3 * table.grid.values());
    SharedProgress counter(progress, static_cast<double>(n * (n + 1) / 2));  // of pairs
    parallel_for_ranges(0, n, 1, [&](std::size_t first, std::size_t last) {
        for (std::size_t step = first; step < last && !counter.stopped(); ++step) {
            const std::size_t i = n - 1 - step;  // long rows first
            auto set = row_of(static_cast<int>(i));
            for (std::size_t o = 0; o <= i && counter.keep_going(); ++o) {
                float* out = table.values.data() + (i * n + o) * line;
                set(static_cast<int>(o), out);
                if (o != i) std::copy_n(out, line, table.values.data() + (o * n + i) * line);
            }
            counter.add(static_cast<double>(i + 1));
        }
    });
    if (counter.stopped()) throw Stopped(fmt::format("making {} was stopped", what));
}

}  // namespace nacre::bsdf
