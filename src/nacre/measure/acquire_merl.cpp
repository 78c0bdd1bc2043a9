#include "nacre/measure/acquire_merl.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/measure/acquire_loop.h"
#include "nacre/measure/colour_of_brdf.h"

namespace nacre::measure {

bsdf::MerlTable acquire_merl(const Brdf& brdf, const std::vector<double>& wavelengths_nm,
                             const MerlSettings& settings, const Progress& progress) {
    const auto check = [](int cells, const char* what) {
        require_in_range(cells, bsdf::kLeastMerlCells, bsdf::kMostMerlCells, what);
    };
    check(settings.half, "cells along theta_half");
    check(settings.difference, "cells along theta_difference");
    check(settings.azimuths, "cells along phi_difference");
    require_table_size(3.0 * sizeof(double) * settings.half * settings.difference *
                       settings.azimuths);
    const SpectrumColour colour(wavelengths_nm);
    bsdf::MerlTable table{settings.half, settings.difference, settings.azimuths, {}};
    table.values.assign(3 * table.cells(), -1.0);
    for_each_row(table.half, progress, [&](int h) {
        for (int d = 0; d < table.difference; ++d) {
            // phi_d and pi - phi_d: the same by reciprocity and a mirror's symmetry.
            for (int a = 0; a < (table.azimuths + 1) / 2; ++a) {
                const bsdf::DirectionPair pair = bsdf::directions_of(table.middle(h, d, a));
                const auto &i = pair.wi, &o = pair.wo;
                if (i[2] <= 0 || o[2] <= 0) continue;
                const auto polar = [](const std::array<double, 3>& w) {
                    return std::min(std::atan2(std::hypot(w[0], w[1]), w[2]),
                                    0.5 * std::numbers::pi - 1e-9);
                };
                const std::vector<double> rgb = colour.rgb(
                    brdf(polar(i), polar(o), std::atan2(o[1], o[0]) - std::atan2(i[1], i[0])));
                for (const int twin : {a, table.azimuths - 1 - a}) {
                    for (int c = 0; c < 3; ++c) {
                        table.values[c * table.cells() + table.cell(h, d, twin)] =
                            rgb[c] / bsdf::MerlTable::kScale[c];
                    }
                }
            }
        }
    });
    bsdf::validate(table);
    return table;
}

}  // namespace nacre::measure
