#include "apps/datasheet/measurement_plots.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/report/plot_svg.h"

namespace nacre::datasheet {
namespace {

using testing::ElementsAre;

measure::Measurement panel(bool with_spectra) {
    measure::Measurement m;
    m.name = "gold";
    if (with_spectra) m.wavelengths_nm = {400, 500, 600};
    // Out of order, with another lamp and a view off the plane.
    const auto add = [&](measure::Geometry g, double light, double a) {
        measure::Reading reading{std::move(g), {}, {}, {light, a, 2 * a}};
        if (with_spectra) reading.reflectance_factor = {light / 100, light / 50, light / 200};
        m.readings.push_back(std::move(reading));
    };
    add(measure::in_plane(45, 110), 20, 1);
    add(measure::in_plane(45, 15), 120, 30);
    add(measure::in_plane(45, -15), 110, 28);
    add(measure::in_plane(15, 15), 90, 20);
    add(measure::off_plane(45, 25, 90), 70, 10);
    return m;
}

TEST(MeasurementPlots, LightnessIsSortedByAspecularAngleForEachLamp) {
    const report::Plot plot = lightness_plot(panel(true));
    ASSERT_EQ(plot.series.size(), 2u);
    EXPECT_EQ(plot.series[0].name, "gold, lamp at 15°");
    EXPECT_THAT(plot.series[1].x, ElementsAre(-15, 15, 110));
    EXPECT_THAT(plot.series[1].y, ElementsAre(110, 120, 20));
    EXPECT_THAT(plot.series[1].point_colours,
                ElementsAre(chip({110, 28, 56}), chip({120, 30, 60}), chip({20, 1, 2})));
}

TEST(MeasurementPlots, TravelHasEqualScalesAndMarksItsStart) {
    const report::Plot plot = travel_plot(panel(true));
    EXPECT_TRUE(plot.equal_scale);
    EXPECT_THAT(plot.series[1].x, ElementsAre(28, 30, 1));
    EXPECT_THAT(plot.series[1].y, ElementsAre(56, 60, 2));
    // The first two are so close together that they share a label.
    EXPECT_THAT(plot.series[1].point_labels, ElementsAre("start, −15°, 15°", "", "110°"));
    EXPECT_TRUE(plot.series[0].point_labels.empty());  // of one lamp only
}

TEST(MeasurementPlots, PointsOfTheTravelThatLieTogetherShareALabel) {
    const auto labels = [](const std::vector<double>& a) {
        measure::Measurement m;
        for (std::size_t i = 0; i < a.size(); ++i) {
            m.readings.push_back(
                {measure::in_plane(45, 15.0 * static_cast<double>(i)), {}, {}, {50, a[i], 0}});
        }
        return travel_plot(m).series[0].point_labels;
    };
    EXPECT_THAT(labels({100, 50, 0}), ElementsAre("start, 0°", "15°", "30°"));
    EXPECT_THAT(labels({100, 1, 0}), ElementsAre("start, 0°", "15°, 30°", ""));
    EXPECT_THAT(labels({100, 1, 0, 0}), ElementsAre("start, 0°", "15° to 45°", "", ""));
    // A way that comes back to where it was, and one that leads nowhere.
    EXPECT_THAT(labels({100, 0, 99}), ElementsAre("start, 0°, 30°", "15°", ""));
    EXPECT_THAT(labels({1, 1, 1}), ElementsAre("0° to 30°", "", ""));
}

TEST(MeasurementPlots, SpectraAreThoseOfTheLampAt45Degrees) {
    const report::Plot plot = spectra_plot(panel(true));
    ASSERT_EQ(plot.series.size(), 3u);
    EXPECT_THAT(plot.series[0].x, ElementsAre(400, 500, 600));
    EXPECT_THAT(plot.series[0].y, ElementsAre(1.1, 2.2, 0.55));
    EXPECT_THAT(plot.series[2].point_labels, ElementsAre("", "", "110°"));
    // These two end so close together that they share a label.
    EXPECT_THAT(plot.series[0].point_labels, ElementsAre("", "", ""));
    EXPECT_THAT(plot.series[1].point_labels, ElementsAre("", "", "−15°, 15°"));
    // 1.2 at most here, 0.4 there: linear. A tenth of that: logarithmic.
    EXPECT_FALSE(plot.y.logarithmic);
    measure::Measurement wide = panel(true);
    wide.readings[0].reflectance_factor = {0.02, 0.04, 0.01};
    EXPECT_TRUE(spectra_plot(wide).y.logarithmic);
}

TEST(MeasurementPlots, AStandardIsDashedAndUnderTheSample) {
    measure::Measurement standard = panel(true);
    standard.name = "standard";
    for (const NamedPlot& named : measurement_plots(panel(true), &standard)) {
        EXPECT_TRUE(named.plot.series.front().dashed) << named.name;
        EXPECT_FALSE(named.plot.series.back().dashed) << named.name;
        EXPECT_NO_THROW(report::plot_svg(named.plot)) << named.name;
    }
}

TEST(MeasurementPlots, WithoutSpectraThereIsNoPlotOfThem) {
    const auto names = [](const measure::Measurement& m) {
        std::vector<std::string> all;
        for (const NamedPlot& named : measurement_plots(m)) all.push_back(named.name);
        return all;
    };
    EXPECT_THAT(names(panel(true)), ElementsAre("lightness", "travel", "spectra"));
    EXPECT_THAT(names(panel(false)), ElementsAre("lightness", "travel"));
    EXPECT_THAT(names({}), ElementsAre("lightness", "travel"));
    for (const NamedPlot& named : measurement_plots({}))
        EXPECT_NO_THROW(report::plot_svg(named.plot));
}

}  // namespace
}  // namespace nacre::datasheet
