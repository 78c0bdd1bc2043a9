#include "nacre/panel/measurement_plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "nacre/panel/texts.h"
#include "nacre/report/plot_data.h"

namespace nacre::panel {

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

/// Curves whose ends are so close that their labels would cover each other share one, as in "75°,
/// 110°".
void join_labels(report::Plot& plot) {
    constexpr double kLeastShare = 0.05;  // of the axis: the height of a letter
    std::vector<report::Series*> labelled;
    for (report::Series& series : plot.series) {
        if (!series.point_labels.empty()) labelled.push_back(&series);
    }
    const auto place = [&](const report::Series* series) {
        // What a logarithmic axis cannot show is far below all else.
        const double y = series->y.back();
        return plot.y.logarithmic ? (y > 0 ? std::log10(y) : -1e3) : y;
    };
    const auto ends = extents(plot).y;
    const double length = plot.y.logarithmic ? std::log10(ends.hi / ends.lo) : ends.hi - ends.lo;
    std::stable_sort(labelled.begin(), labelled.end(),
                     [&](const auto* a, const auto* b) { return place(a) > place(b); });
    for (std::size_t i = 0, first = 0; i + 1 < labelled.size(); ++i) {
        if (place(labelled[first]) - place(labelled[i + 1]) > kLeastShare * length) {
            first = i + 1;
            continue;
        }
        std::string& joined = labelled[first]->point_labels.back();
        joined += ", ";
        joined += std::exchange(labelled[i + 1]->point_labels.back(), {});
    }
}

/// A colour for a line on white paper.
std::string line_colour(spectra::Vec3 lab) {
    constexpr double kLightest = 65;
    lab[0] = std::min(lab[0], kLightest);
    return chip(lab);
}

}  // namespace

std::string chip(const spectra::Vec3& lab) {
    return report::css_colour(measure::srgb_chip_at_full_light(lab));
}

report::Plot lightness_plot(const Measurement& sample, const Measurement* standard) {
    report::Plot plot{.title = "Lightness",
                      .x = {.label = "aspecular angle, degrees"},
                      .y = {.label = "L*", .lo = 0}};
    for (const Panel& panel : panels(sample, standard)) {
        add_curves(plot, panel, [](const Reading& reading) {
            return std::pair{reading.geometry.aspecular_deg, reading.lab[0]};
        });
    }
    return plot;
}

report::Plot travel_plot(const Measurement& sample, const Measurement* standard) {
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
            auto& labels = plot.series[s++].point_labels;
            if (lamp != lamp_of_labels(lamps)) continue;
            for (const Reading* reading : readings) {
                labels.push_back(degrees_text(reading->geometry.aspecular_deg));
            }
            if (labels.size() > 1) labels[0] = "start, " + labels[0];
        }
    }
    return plot;
}

report::Plot spectra_plot(const Measurement& sample, const Measurement* standard) {
    report::Plot plot{.title = "Reflectance factor by aspecular angle",
                      .x = {.label = "wavelength, nm"},
                      .y = {.label = "reflectance factor (perfect diffuser: 1)"}};
    double least = 0, greatest = 0;
    double first_nm = 0, last_nm = 0;
    for (const Panel& panel : panels(sample, standard)) {
        const std::vector<double>& wavelengths = panel.measurement->wavelengths_nm;
        for (const Reading* reading : with_spectra(*panel.measurement)) {
            report::Series series{.x = wavelengths,
                                  .y = reading->reflectance_factor,
                                  .colour = line_colour(reading->lab),
                                  .dashed = panel.is_standard};
            if (!panel.is_standard) {
                series.point_labels.resize(wavelengths.size());
                series.point_labels.back() = degrees_text(reading->geometry.aspecular_deg);
            }
            const double peak = largest(*reading);
            if (peak > 0) least = least > 0 ? std::min(least, peak) : peak;
            greatest = std::max(greatest, peak);
            first_nm = first_nm > 0 ? std::min(first_nm, wavelengths.front()) : wavelengths.front();
            last_nm = std::max(last_nm, wavelengths.back());
            plot.series.push_back(std::move(series));
        }
    }
    constexpr double kWide = 10;
    plot.y.logarithmic = greatest > kWide * least;
    if (!plot.y.logarithmic) plot.y.lo = 0;
    join_labels(plot);
    if (first_nm < last_nm) {
        // Room for the angles at the ends of the curves: for each byte of text, as a share of the
        // axis in a picture of half a page.
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

std::vector<NamedPlot> measurement_plots(const Measurement& sample, const Measurement* standard) {
    std::vector<NamedPlot> plots = {{"lightness", lightness_plot(sample, standard)},
                                    {"travel", travel_plot(sample, standard)}};
    report::Plot spectra = spectra_plot(sample, standard);
    if (!spectra.series.empty()) plots.push_back({"spectra", std::move(spectra)});
    return plots;
}

}  // namespace nacre::panel
