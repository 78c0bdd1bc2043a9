#pragma once

#include <optional>
#include <vector>

#include "nacre/solver/order_interpolation.h"
#include "nacre/solver/representative_wavelengths.h"
#include "nacre/solver/solved_paint.h"

// Wavelengths that can be solved together or need not be solved twice.

namespace nacre::solver {

/// Wavelengths at which the binder has one and the same index.
struct WavelengthGroup {
    std::vector<int> members;    ///< indices of wavelengths
    std::vector<int> distinct;   ///< those of them at which the paint differs: what is solved
    std::vector<int> solved_as;  ///< by member: its position in distinct
};
using WavelengthGroups = std::vector<WavelengthGroup>;

/// A metallic grey is the same paint at all wavelengths: it is solved once.
WavelengthGroups group_wavelengths(const PaintMedium& medium);

/// The medium at some of its wavelengths.
PaintMedium select_wavelengths(const PaintMedium& medium, const std::vector<int>& wavelengths);

/// All that the solution depends on at each wavelength, [number][block of wavelengths], of which few
/// wavelengths may tell the others.
LaneBuffer spectra_of(const PaintMedium& medium);

/// The solution of one group at its distinct wavelengths, by order: pairs i >= j of exit nodes from
/// first[order].
struct GroupSolution {
    int inner_nodes = 0;
    std::vector<double> exit_angle;
    std::vector<int> first;
    std::vector<OrderValues> values;
    std::vector<OrderValues> single_values;  ///< likewise, under a rough interface; else empty
    /// Where few wavelengths tell all others, those at which orders from this one on are given.
    std::optional<RepresentativeWavelengths> representatives;
    int represented_from = 0;
    double unresolved_scattering = 0, azimuthal_tail = 0;
};

/// Puts the groups together into paint.multiple_scattering, paint.rough_single and paint.report.
void merge_groups(const WavelengthGroups& groups, const std::vector<GroupSolution>& solutions,
                  double tolerance, SolvedPaint& paint);

}  // namespace nacre::solver
