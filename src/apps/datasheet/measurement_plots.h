#pragma once

#include <array>
#include <string>
#include <vector>

#include "apps/report/plot_data.h"
#include "nacre/fit/uncertainty.h"
#include "nacre/measure/measurement.h"

// What multi-angle colour looks like as curves. Readings off the plane of incidence are left out:
// an aspecular angle alone does not say where they are. A standard, where there is one, is dashed.

namespace nacre::datasheet {

/// L* against the aspecular angle: how steep it is, is the flop. One curve for each lamp, each dot
/// in the colour seen there.
/// @param uncertainty  of the sample, its readings in the same order: bars of one standard
///                     deviation; null: none
report::Plot lightness_plot(const measure::Measurement& sample,
                            const measure::Measurement* standard = nullptr,
                            const fit::Uncertainty* uncertainty = nullptr);

/// The way through a* and b* as the view leaves the mirror direction, which is where it starts. One
/// curve for each lamp, labelled with angles for that at 45 deg, or the first; equal scales, so
/// that distances are differences in chroma and hue.
/// @param uncertainty  likewise: ellipses that hold kEllipseProbability
report::Plot travel_plot(const measure::Measurement& sample,
                         const measure::Measurement* standard = nullptr,
                         const fit::Uncertainty* uncertainty = nullptr);
inline constexpr double kEllipseProbability = 0.95;

/// Reflectance factors at the angles lit from 45 deg, or from the first lamp where none is there.
/// Each curve has the colour that it makes, darkened where it would vanish on white paper. The axis
/// is logarithmic where the curves' largest values differ more than tenfold.
report::Plot spectra_plot(const measure::Measurement& sample,
                          const measure::Measurement* standard = nullptr);

struct NamedPlot {
    std::string name;  ///< of a file, without extension
    report::Plot plot;
};

/// The names of all that can be drawn.
inline constexpr std::array kMeasurementPlots = {"lightness", "travel", "spectra"};

/// All that can be drawn; "spectra" only if there are some.
std::vector<NamedPlot> measurement_plots(const measure::Measurement& sample,
                                         const measure::Measurement* standard = nullptr,
                                         const fit::Uncertainty* uncertainty = nullptr);

/// A colour as "#rrggbb" on a display: measure::srgb_chip_at_full_light().
std::string chip(const Vec3d& lab);

}  // namespace nacre::datasheet
