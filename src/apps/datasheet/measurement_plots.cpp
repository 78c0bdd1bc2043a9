#include "apps/datasheet/measurement_plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

#include "apps/datasheet/atlas.h"
#include "apps/report/plot_data.h"

namespace nacre::datasheet {

namespace {

using measure::Measurement;
using measure::Reading;
using Readings = std::vector<const Reading*>;

/// Readings in the plane by lamp, those of a lamp by aspecular angle.
std::map<double, Readings> by_lamp(const Measurement& measurement) {
    std::map<double, Readings> lamps;
    for (const Reading& reading : measurement.readings) {
        if (measure::is_in_plane(reading.geometry)) {
            lamps[reading.geometry.theta_i_deg].push_back(&reading);
        }
    }
    for (auto& [lamp, readings] : lamps) {
        std::stable_sort(readings.begin(), readings.end(), [](const Reading* a, const Reading* b) {
            return a->geometry.aspecular_deg < b->geometry.aspecular_deg;
        });
    }
    return lamps;
}

struct Panel {
    const Measurement* measurement;
    bool is_standard;
};

/// The standard first, so that the sample is drawn over it.
std::vector<Panel> panels(const Measurement& sample, const Measurement* standard) {
    std::vector<Panel> all;
    if (standard) all.push_back({standard, true});
    all.push_back({&sample, false});
    return all;
}

/// "Gold pearl", "standard: Gold pearl, lamp at 45°": what there is to be said.
std::string series_name(const Panel& panel, double lamp, std::size_t lamps) {
    std::string name = panel.is_standard ? "standard" : "";
    if (!panel.measurement->name.empty()) {
        name += (name.empty() ? "" : ": ") + panel.measurement->name;
    }
    if (lamps > 1) name += (name.empty() ? "" : ", ") + ("lamp at " + degrees_text(lamp));
    return name;
}

/// One curve a lamp; `place` says where a reading lies.
template <class Place>
void add_curves(report::Plot& plot, const Panel& panel, const Place& place) {
    const auto lamps = by_lamp(*panel.measurement);
    for (const auto& [lamp, readings] : lamps) {
        report::Series series{.name = series_name(panel, lamp, lamps.size()),
                              .dots = true,
                              .dashed = panel.is_standard};
        for (const Reading* reading : readings) {
            const auto [x, y] = place(*reading);
            series.x.push_back(x);
            series.y.push_back(y);
            series.point_colours.push_back(chip(reading->lab));
        }
        plot.series.push_back(std::move(series));
    }
}

/// The lamp that stands for all where there is no room for more: at 45 deg, else the first.
double lamp_of_labels(const std::map<double, Readings>& lamps) {
    return lamps.contains(45) ? 45 : lamps.begin()->first;
}

/// The readings whose spectra are shown.
Readings with_spectra(const Measurement& measurement) {
    const auto lamps = by_lamp(measurement);
    if (lamps.empty()) return {};
    Readings readings = lamps.at(lamp_of_labels(lamps));
    std::erase_if(readings, [](const Reading* r) { return r->reflectance_factor.empty(); });
    return readings;
}

double largest(const Reading& reading) {
    return *std::max_element(reading.reflectance_factor.begin(), reading.reflectance_factor.end());
}

/// What one label says of some of the angles: "15°, 45°", or "−15° to 45°" where three or more of
/// them follow each other.
/// @param which  positions in `angles`
std::string angles_text(const std::vector<double>& angles, std::vector<std::size_t> which) {
    std::sort(which.begin(), which.end());
    std::string text;
    for (std::size_t i = 0; i < which.size();) {
        std::size_t last = i;
        while (last + 1 < which.size() && which[last + 1] == which[last] + 1) ++last;
        if (last < i + 2) last = i;
        text += (text.empty() ? "" : ", ") + degrees_text(angles[which[i]]);
        if (last > i) text += " to " + degrees_text(angles[which[last]]);
        i = last + 1;
    }
    return text;
}

/// Groups of what shares a label, as labels of their own would cover each other: each is near the
/// first of its group, at which the label stands.
/// @param order  in which they are taken
/// @param near   whether two positions are too close for two labels
template <class Near>
std::vector<std::vector<std::size_t>> gathered(const std::vector<std::size_t>& order,
                                               const Near& near) {
    std::vector<std::vector<std::size_t>> groups;
    for (const std::size_t i : order) {
        const auto home = std::find_if(groups.begin(), groups.end(),
                                       [&](const auto& group) { return near(group.front(), i); });
        if (home == groups.end()) {
            groups.push_back({i});
        } else {
            home->push_back(i);
        }
    }
    return groups;
}

std::vector<std::size_t> positions(std::size_t count) {
    std::vector<std::size_t> all(count);
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
}

std::vector<double> aspecular_angles(const Readings& readings) {
    std::vector<double> angles;
    for (const Reading* reading : readings) angles.push_back(reading->geometry.aspecular_deg);
    return angles;
}

/// Writes the angles at the ends of curves, the first of which is series number `first`.
void label_curves(report::Plot& plot, std::size_t first, const std::vector<double>& angles) {
    constexpr double kMinFraction = 0.05;  // of the axis: the height of a letter
    const auto place = [&](std::size_t i) {
        // What a logarithmic axis cannot show is far below all else.
        const double y = plot.series[first + i].y.back();
        return plot.y.logarithmic ? (y > 0 ? std::log10(y) : -1e3) : y;
    };
    const auto ends = extents(plot).y;
    const double length = plot.y.logarithmic ? std::log10(ends.hi / ends.lo) : ends.hi - ends.lo;
    std::vector<std::size_t> downwards = positions(angles.size());
    std::stable_sort(downwards.begin(), downwards.end(),
                     [&](std::size_t a, std::size_t b) { return place(a) > place(b); });
    for (std::size_t i = 0; i < angles.size(); ++i) {
        plot.series[first + i].point_labels.resize(plot.series[first + i].x.size());
    }
    for (const auto& group : gathered(downwards, [&](std::size_t a, std::size_t b) {
             return std::abs(place(a) - place(b)) <= kMinFraction * length;
         })) {
        plot.series[first + group.front()].point_labels.back() = angles_text(angles, group);
    }
}

/// Writes the angles beside the points of a curve and marks where it starts.
void label_points(report::Plot& plot, report::Series& series, const std::vector<double>& angles) {
    // Two lines of text, as shares of the axes in a picture of half a page, whose scales are equal.
    constexpr double kFractionOfWidth = 0.06, kFractionOfHeight = 0.1;
    const report::Extents ends = extents(plot);
    const double min_distance = std::max(kFractionOfWidth * (ends.x.hi - ends.x.lo),
                                         kFractionOfHeight * (ends.y.hi - ends.y.lo));
    const auto groups = gathered(positions(angles.size()), [&](std::size_t a, std::size_t b) {
        return std::hypot(series.x[a] - series.x[b], series.y[a] - series.y[b]) <= min_distance;
    });
    series.point_labels.resize(angles.size());
    for (const auto& group : groups) {
        series.point_labels[group.front()] = angles_text(angles, group);
    }
    if (groups.size() > 1) series.point_labels[0].insert(0, "start, ");
}

/// How far a reading of the sample is spread.
const fit::Spread& spread_of(const Measurement& sample, const fit::Uncertainty& uncertainty,
                             const Reading* reading) {
    return uncertainty.readings.at(static_cast<std::size_t>(reading - sample.readings.data()))
        .best();
}

/// Ellipses in the a*b* plane about the readings of a curve, as one line with gaps.
report::Series ellipses(const Measurement& sample, const fit::Uncertainty& uncertainty) {
    constexpr int kSides = 48;
    constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
    report::Series series{.name = fmt::format("ellipses hold {:.0f} %", 100 * kEllipseProbability),
                          .colour = "#767676"};
    for (const auto& [lamp, readings] : by_lamp(sample)) {
        for (const Reading* reading : readings) {
            const fit::Ellipse e =
                fit::ab_ellipse(spread_of(sample, uncertainty, reading), kEllipseProbability);
            for (int i = 0; i <= kSides; ++i) {
                const double t = 2 * std::numbers::pi * i / kSides;
                const double c = std::cos(t), s = std::sin(t);
                series.x.push_back(reading->lab[1] + c * e.major[0] + s * e.minor[0]);
                series.y.push_back(reading->lab[2] + c * e.major[1] + s * e.minor[1]);
            }
            series.x.push_back(kGap);
            series.y.push_back(kGap);
        }
    }
    return series;
}

/// A colour for a line on white paper.
std::string line_colour(Vec3d lab) {
    constexpr double kLightest = 65;
    lab[0] = std::min(lab[0], kLightest);
    return chip(lab);
}

}  // namespace

std::string chip(const Vec3d& lab) {
    return spectra::css_colour(measure::srgb_chip_at_full_light(lab));
}

report::Plot lightness_plot(const Measurement& sample, const Measurement* standard,
                            const fit::Uncertainty* uncertainty) {
    report::Plot plot{.title = "Lightness",
                      .x = {.label = "aspecular angle, degrees"},
                      .y = {.label = "L*", .lo = 0}};
    for (const Panel& panel : panels(sample, standard)) {
        std::size_t curve = plot.series.size();
        add_curves(plot, panel, [](const Reading& reading) {
            return std::pair{reading.geometry.aspecular_deg, reading.lab[0]};
        });
        if (panel.is_standard || !uncertainty) continue;
        for (const auto& [lamp, readings] : by_lamp(sample)) {
            for (const Reading* reading : readings) {
                plot.series[curve].y_error.push_back(
                    spread_of(sample, *uncertainty, reading).lab()[0]);
            }
            ++curve;
        }
    }
    return plot;
}

report::Plot travel_plot(const Measurement& sample, const Measurement* standard,
                         const fit::Uncertainty* uncertainty) {
    report::Plot plot{
        .title = "Colour travel", .x = {.label = "a*"}, .y = {.label = "b*"}, .equal_scale = true};
    for (const Panel& panel : panels(sample, standard)) {
        const std::size_t first = plot.series.size();
        add_curves(plot, panel, [](const Reading& reading) {
            return std::pair{reading.lab[1], reading.lab[2]};
        });
        if (panel.is_standard) continue;  // one set of labels is enough
        std::size_t s = first;
        const auto lamps = by_lamp(sample);
        for (const auto& [lamp, readings] : lamps) {
            report::Series& series = plot.series[s++];
            if (lamp == lamp_of_labels(lamps)) {
                label_points(plot, series, aspecular_angles(readings));
            }
        }
    }
    if (uncertainty) plot.series.push_back(ellipses(sample, *uncertainty));
    return plot;
}

report::Plot spectra_plot(const Measurement& sample, const Measurement* standard) {
    report::Plot plot{.title = "Reflectance factor by aspecular angle",
                      .x = {.label = "wavelength, nm"},
                      .y = {.label = "reflectance factor (perfect diffuser: 1)"}};
    double smallest = 0, greatest = 0;
    double first_nm = 0, last_nm = 0;
    std::size_t first = 0;  // series of the sample, which is the last
    std::vector<double> angles;
    for (const Panel& panel : panels(sample, standard)) {
        const std::vector<double>& wavelengths = panel.measurement->wavelengths_nm;
        const Readings readings = with_spectra(*panel.measurement);
        first = plot.series.size();
        angles = aspecular_angles(readings);
        for (const Reading* reading : readings) {
            report::Series series{.x = wavelengths,
                                  .y = reading->reflectance_factor,
                                  .colour = line_colour(reading->lab),
                                  .dashed = panel.is_standard};
            const double peak = largest(*reading);
            if (peak > 0) smallest = smallest > 0 ? std::min(smallest, peak) : peak;
            greatest = std::max(greatest, peak);
            first_nm = first_nm > 0 ? std::min(first_nm, wavelengths.front()) : wavelengths.front();
            last_nm = std::max(last_nm, wavelengths.back());
            plot.series.push_back(std::move(series));
        }
    }
    constexpr double kWide = 10;
    plot.y.logarithmic = greatest > kWide * smallest;
    if (!plot.y.logarithmic) plot.y.lo = 0;
    label_curves(plot, first, angles);
    if (first_nm < last_nm) {
        // Room for the angles at the ends of the curves: for each byte of text, as a fraction of
        // the axis in a picture of half a page.
        std::size_t longest = 0;
        for (const report::Series& series : plot.series) {
            if (series.point_labels.empty()) continue;
            longest = std::max(longest, series.point_labels.back().size());
        }
        plot.x.lo = first_nm;
        plot.x.hi =
            last_nm + std::min(0.02 * static_cast<double>(longest), 0.4) * (last_nm - first_nm);
    }
    return plot;
}

std::vector<NamedPlot> measurement_plots(const Measurement& sample, const Measurement* standard,
                                         const fit::Uncertainty* uncertainty) {
    const auto& [lightness, travel, spectra_name] = kMeasurementPlots;
    std::vector<NamedPlot> plots = {{lightness, lightness_plot(sample, standard, uncertainty)},
                                    {travel, travel_plot(sample, standard, uncertainty)}};
    report::Plot spectra = spectra_plot(sample, standard);
    if (!spectra.series.empty()) plots.push_back({spectra_name, std::move(spectra)});
    return plots;
}

}  // namespace nacre::datasheet
