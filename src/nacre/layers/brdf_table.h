#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "nacre/core/progress.h"
#include "nacre/layers/brdf_table_grid.h"
#include "nacre/layers/solved_paint.h"

// The BRDF of a solved paint as one big table of RGB values, and as its singular value
// decomposition: the two representations that Mir et al. 2022 compare [mir-2022]. Their sizes are
// the paper's; the nodes are ours (brdf_table_grid.h, docs/tables.md).

namespace nacre::layers {

/// Red, green, blue in linear Rec. 709.
using Rgb = std::array<float, 3>;

/// Every value: n^2 m of them per channel, 96 MiB for n = 256 and m = 128.
struct RawBrdfTable {
    std::string paint;  ///< name of the recipe
    BrdfGrid grid;
    std::vector<float> values;  ///< g in 1/sr, [i][o][azimuth][channel]

    std::size_t bytes() const { return values.size() * sizeof(float); }

    Rgb interpolate(const BrdfCell& cell) const {
        Rgb g{};
        for (int corner = 0; corner < 4; ++corner) {
            const float* at =
                values.data() + 3 * (cell.pair[corner] * grid.azimuths + cell.azimuth);
            for (int tap = 0; tap < 4; ++tap) {
                const float weight = cell.pair_weight[corner] * cell.azimuth_weight[tap];
                for (int c = 0; c < 3; ++c) g[c] += weight * at[3 * tap + c];
            }
        }
        return g;
    }

    friend bool operator==(const RawBrdfTable&, const RawBrdfTable&) = default;
};

struct BrdfTableSettings {
    int angles = 256;    ///< n, as BrdfGrid::angles
    int azimuths = 128;  ///< m, as BrdfGrid::azimuths
};

/// Tabulates SolvedPaint::brdf (the total) at all nodes: the spectrum at the paint's wavelengths
/// becomes linear Rec. 709 under D65 by spectra::rec709_weights. At a node f equals the colour of
/// the solved spectrum to kRawNodeError of the peak of its two directions; between nodes it is
/// interpolated (bsdf/tabulated.h states the error). A colour outside the gamut of Rec. 709 has
/// negative components, and keeps them.
///
/// Takes seconds and, beside the table, little memory. `progress` returning false ends it.
/// @throws DomainError if a setting is out of range; Error if stopped by `progress`, or if the
/// interface is rough at some wavelengths only
RawBrdfTable make_raw_table(const SolvedPaint& paint, const BrdfTableSettings& settings = {},
                            const Progress& progress = {});

inline constexpr double kRawNodeError = 1e-5;

}  // namespace nacre::layers
