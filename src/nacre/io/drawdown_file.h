#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "nacre/measure/drawdown.h"

// Drawdowns as CSV, a row for each reading: `ground`, `thickness_um` (0: the bare ground),
// `volume_fraction` (or `mass_fraction` and `density_g_per_cm3`, perhaps `binder_density_g_per_cm3`)
// and a column for each wavelength ("400" or "R400"). Tints have `white_volume_fraction` or
// `white_mass_fraction` besides; `thickness_um` may be `opaque`. docs/drawdown.md describes it.

namespace nacre::io {

/// @throws InputError naming file, line, column, value and allowed range
measure::Drawdown parse_drawdown(std::string_view text, const std::string& filename);

/// @throws InputError also if it cannot be read
measure::Drawdown read_drawdown(const std::filesystem::path& path);

/// The CSV of such a file.
std::string drawdown_csv(const measure::Drawdown& drawdown);

}  // namespace nacre::io
