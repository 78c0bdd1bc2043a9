#include "apps/report/plot_data.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "nacre/core/error.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/not_finite.h"

namespace nacre::report {
namespace {

using nacre::test::message_of;

using test::kInf;
using test::kNan;

Plot plot_of(std::vector<double> x, std::vector<double> y) {
    return {.title = "t", .series = {{.name = "s", .x = std::move(x), .y = std::move(y)}}};
}

TEST(PlotData, LeavesOutPointsThatAreNotFinite) {
    const Plot plot = plot_of({0, kNan, 2, kInf, 4, 1e200}, {0, 1, kNan, 3, -kInf, 1});
    const Series& series = plot.series[0];
    ASSERT_EQ(series.x.size(), 6u);
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_EQ(can_be_shown(plot, series.x[i], series.y[i]), i == 0) << i;
    }
    EXPECT_LT(extents(plot).x.hi, 1);
}

TEST(PlotData, LeavesOutWhatALogarithmicAxisCannotShow) {
    Plot plot = plot_of({1, 2, 3, 4}, {1, 0, -1, 100});
    plot.y.logarithmic = true;
    plot.series[0].y_error = {2, 0, 0, 50};
    EXPECT_FALSE(can_be_shown(plot, 2, 0));
    EXPECT_FALSE(can_be_shown(plot, 3, -1));
    const auto bar = [&](std::size_t i) { return error_bar(plot, plot.series[0], i).value(); };
    EXPECT_FALSE(bar(0).low.has_value());  // 1 - 2 < 0: the bar goes down to the axis
    EXPECT_EQ(bar(0).high, 3);
    EXPECT_EQ(bar(3).low, 50);
    const Extent y = extents(plot).y;
    EXPECT_GT(y.lo, 0);
    EXPECT_LE(y.lo, 1);
    EXPECT_GE(y.hi, 150);
}

TEST(PlotData, AxesHoldEveryPointAndBar) {
    Plot plot = plot_of({-3, 5}, {10, 20});
    plot.series[0].y_error = {4, kNan};
    const Extents ends = extents(plot);
    EXPECT_TRUE(ends.x.lo <= -3 && ends.x.hi >= 5);
    EXPECT_TRUE(ends.y.lo <= 6 && ends.y.hi >= 20);
    EXPECT_TRUE(ends.x.round && ends.y.round);
}

TEST(PlotData, AxesOfOneSignEndAtZero) {
    const Extents positive = extents(plot_of({0, 100}, {0.1, 50}));
    EXPECT_EQ(positive.x.lo, 0);
    EXPECT_EQ(positive.y.lo, 0);
    const Extents negative = extents(plot_of({-100, 0}, {-50, -0.1}));
    EXPECT_EQ(negative.x.hi, 0);
    EXPECT_EQ(negative.y.hi, 0);
    const Extents far = extents(plot_of({50, 100}, {-1, 1}));
    EXPECT_GT(far.x.lo, 0);
    EXPECT_LT(far.y.lo, -1);
    EXPECT_GT(far.y.hi, 1);
}

TEST(PlotData, AxesEndWhereTheCallerSays) {
    Plot plot = plot_of({1, 2}, {3, 4});
    plot.x.lo = 0;
    plot.y.lo = 3.5;
    plot.y.hi = 3.75;
    const Extents ends = extents(plot);
    EXPECT_EQ(ends.x.lo, 0);
    EXPECT_GE(ends.x.hi, 2);
    EXPECT_EQ(ends.y.lo, 3.5);
    EXPECT_EQ(ends.y.hi, 3.75);
    EXPECT_FALSE(ends.x.round || ends.y.round);
}

TEST(PlotData, AxesHaveALengthWhateverTheData) {
    for (const bool logarithmic : {false, true}) {
        for (const std::vector<double>& v : std::vector<std::vector<double>>{
                 {}, {0}, {5}, {-5, -5}, {kNan}, {1e150, -1e150}, {1e-300}, {7, 7}}) {
            for (const auto& [lo, hi] :
                 std::vector<std::pair<std::optional<double>, std::optional<double>>>{
                     {{}, {}}, {50.0, {}}, {{}, 1e-3}, {1.0, 2.0}}) {
                Plot plot = plot_of(v, v);
                plot.y = {.logarithmic = logarithmic, .lo = lo, .hi = hi};
                const Extent y = extents(plot).y;
                EXPECT_TRUE(std::isfinite(y.lo) && std::isfinite(y.hi) && y.lo < y.hi)
                    << y.lo << " " << y.hi << (logarithmic ? " log" : "");
                EXPECT_TRUE(!logarithmic || y.lo > 0);
            }
        }
    }
}

TEST(PlotData, EqualScaleShowsTheZerosAndKeepsThePictureInShape) {
    for (const auto& [x, y] : std::vector<std::pair<std::vector<double>, std::vector<double>>>{
             {{20, 60}, {1, 2}}, {{1, 2}, {20, 60}}, {{-40, 10}, {-10, 5}}, {{}, {}}}) {
        Plot plot = plot_of(x, y);
        plot.equal_scale = true;
        const Extents ends = extents(plot);
        EXPECT_TRUE(ends.x.lo < 0 && ends.x.hi > 0 && ends.y.lo < 0 && ends.y.hi > 0);
        const double ratio = (ends.y.hi - ends.y.lo) / (ends.x.hi - ends.x.lo);
        EXPECT_GE(ratio, 0.5 - 1e-12);
        EXPECT_LE(ratio, 1 + 1e-12);
    }
}

TEST(PlotData, NamesWhatIsWrong) {
    const auto message = [](const Plot& plot) -> std::string {
        return message_of<DomainError>([&] { check(plot); });
    };
    EXPECT_EQ(message(plot_of({1, 2}, {1})), "plot 't', series 's': 1 y for 2 x");
    Plot plot = plot_of({1, 2}, {1, 2});
    plot.series[0].point_colours = {"#ff0000"};
    EXPECT_EQ(message(plot), "plot 't', series 's': 1 point_colours for 2 x");
    plot.series[0].point_colours = {"#ff0000", "red;x:url(a)"};
    EXPECT_EQ(message(plot),
              "plot 't', series 's': 'red;x:url(a)' is no colour of the form \"#rrggbb\"");
    plot = plot_of({1}, {1});
    plot.series[0].y_error = {-0.5};
    EXPECT_EQ(message(plot), "plot 't', series 's': y_error = -0.5 is below 0");
    plot = plot_of({}, {});
    plot.x.lo = 2;
    plot.x.hi = 2;
    EXPECT_EQ(message(plot), "plot 't': the x axis goes from 2 to 2");
    plot.x.hi = kNan;
    EXPECT_EQ(message(plot), "plot 't': the x axis cannot end at nan");
    plot.x = {.logarithmic = true, .lo = 0};
    EXPECT_EQ(message(plot), "plot 't': the x axis cannot end at 0: it is logarithmic");
    plot.x = {.logarithmic = true};
    plot.equal_scale = true;
    EXPECT_EQ(message(plot), "plot 't': axes of equal scale cannot be logarithmic");
}

TEST(PlotData, ThirtyTwoSeriesLookDifferent) {
    std::set<std::pair<std::string, std::string_view>> looks;
    for (std::size_t i = 0; i < 32; ++i) {
        const Look look = look_of({}, i);
        looks.insert({look.colour, look.symbol});
    }
    EXPECT_EQ(looks.size(), 32u);
    EXPECT_EQ(look_of({.colour = "#123456"}, 3).colour, "#123456");
}

}  // namespace
}  // namespace nacre::report
