#include "apps/report/plot_svg.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <regex>

#include "apps/report/plot_frame.h"
#include "apps/report/svg_raster.h"
#include "nacre/core/error.h"
#include "nacre/testing/not_finite.h"

namespace nacre::report {
namespace {

using testing::HasSubstr;
using testing::Not;

using test::kInf;
using test::kNan;

Plot full_plot(const std::string& text) {
    return {.title = text,
            .caption = text,
            .x = {.label = text},
            .y = {.label = text},
            .series = {{.name = text,
                        .x = {1, 2, 3},
                        .y = {3, kNan, 4},
                        .y_error = {1, 1, kInf},
                        .point_colours = {"#112233", "#445566", "#778899"},
                        .point_labels = {text, text, text},
                        .dots = true,
                        .dashed = true}}};
}

/// The points of the paths that are drawn in a colour, as "x y".
std::vector<std::string> path_points(const std::string& svg, const std::string& colour) {
    std::vector<std::string> points;
    const std::regex path("<path d=\"([^\"]*)\" fill=\"none\" stroke=\"" + colour + "\"");
    const std::regex point("[ML]([-0-9.e]+ [-0-9.e]+)");
    for (std::sregex_iterator p(svg.begin(), svg.end(), path), end; p != end; ++p) {
        const std::string data = (*p)[1];
        for (std::sregex_iterator q(data.begin(), data.end(), point); q != end; ++q) {
            points.push_back((*q)[1]);
        }
    }
    return points;
}

TEST(PlotFrame, PutsKnownPointsWhereTheyBelong) {
    Plot plot;
    plot.y.logarithmic = true;
    const PlotFrame frame(plot, {{10, 20}, {1, 100}}, {50, 30, 150, 230});
    EXPECT_DOUBLE_EQ(frame.x(10), 50);
    EXPECT_DOUBLE_EQ(frame.x(12.5), 75);
    EXPECT_DOUBLE_EQ(frame.x(20), 150);
    EXPECT_DOUBLE_EQ(frame.y(1), 230);
    EXPECT_DOUBLE_EQ(frame.y(10), 130);
    EXPECT_DOUBLE_EQ(frame.y(100), 30);
    EXPECT_TRUE(frame.contains(10, 100));
    EXPECT_FALSE(frame.contains(10, 101));
}

TEST(PlotFrame, AUnitIsAsLongInBothDirectionsWhereScalesAreEqual) {
    for (const bool fixed : {false, true}) {
        Plot plot{.equal_scale = true, .series = {{.x = {-10, 30}, .y = {5, 60}}}};
        if (fixed) {
            plot.x = {.lo = -20, .hi = 40};
            plot.y = {.lo = 0, .hi = 60};
        }
        for (const Box& box : {Box{60, 20, 660, 320}, Box{60, 20, 260, 520}}) {
            const PlotFrame frame = fit_frame(plot, box);
            EXPECT_NEAR(frame.x(1) - frame.x(0), frame.y(0) - frame.y(1), 1e-9);
            EXPECT_LE(frame.box().width(), box.width());
            EXPECT_LE(frame.box().height(), box.height());
            EXPECT_TRUE(frame.contains(-10, 5) && frame.contains(30, 60));
        }
    }
}

TEST(PlotSvg, DrawsPointsAtTheirPlaces) {
    const Plot plot{.x = {.lo = 0, .hi = 10},
                    .y = {.lo = 0, .hi = 4},
                    .series = {{.x = {0, 5, 10}, .y = {0, 4, 1}, .colour = "#123456"}}};
    // The margins of plot_svg.h leave 62 ... 462 across and 32 ... 232 down.
    const std::string svg = plot_svg(plot, {.width_px = 490, .height_px = 280});
    EXPECT_EQ(path_points(svg, "#123456"),
              (std::vector<std::string>{"62 232", "262 32", "462 182"}));
}

TEST(PlotSvg, GapsInterruptTheLineAndLonePointsStay) {
    const Plot plot{
        .x = {.lo = 0, .hi = 10},
        .y = {.lo = 0, .hi = 4},
        .series = {{.x = {0, 5, 6, 7, 10}, .y = {0, 4, kNan, 1, kInf}, .colour = "#123456"}}};
    const std::string svg = plot_svg(plot, {.width_px = 490, .height_px = 280});
    EXPECT_THAT(svg, HasSubstr("d=\"M62 232L262 32M342 182h0\""));
}

TEST(PlotSvg, DotsOffTheAxesAreLeftOutAndLinesAreCut) {
    const Plot plot{.x = {.lo = 0, .hi = 10},
                    .y = {.lo = 0, .hi = 4},
                    .series = {{.x = {1, 2}, .y = {1, 1e140}, .colour = "#123456", .dots = true}}};
    const std::string svg = plot_svg(plot);
    std::size_t dots = 0;
    for (std::size_t at = 0; (at = svg.find("translate(", at)) != std::string::npos; ++at) ++dots;
    EXPECT_EQ(dots, 1u);
    EXPECT_THAT(svg, HasSubstr("overflow=\"hidden\""));
    EXPECT_FALSE(png_of_svg(svg).empty());
}

// librsvg reads with libxml2, which refuses what is no XML.
TEST(PlotSvg, IsValidXmlWithoutScriptsWhateverTheTexts) {
    for (const std::string text : {"plain", "</text><script>evil()</script>", "a\"b'c & d < e > f",
                                   "]]> -->", "a\xFF\x01\xEF\xBF\xBE", "µm ΔE 色", ""}) {
        const std::string svg = plot_svg(full_plot(text));
        EXPECT_NO_THROW(png_of_svg(svg)) << text;
        EXPECT_THAT(svg, Not(HasSubstr("<script")));
        EXPECT_THAT(svg, Not(HasSubstr("id=")));
        EXPECT_THAT(svg, Not(HasSubstr("href")));
    }
    EXPECT_THROW(png_of_svg("<svg><a></svg>"), DomainError);  // the oracle does notice
}

TEST(PlotSvg, EveryKindOfDataCanBeDrawn) {
    int drawn = 0;
    for (const bool logarithmic : {false, true}) {
        for (const std::vector<double>& v : std::vector<std::vector<double>>{{},
                                                                             {0},
                                                                             {kNan},
                                                                             {5},
                                                                             {1e150, -1e150},
                                                                             {1e-300, 1e-299},
                                                                             {kInf, -kInf},
                                                                             {1e16, 1e16 + 2},
                                                                             {1e-300, 1e150}}) {
            Plot plot{.title = "t", .series = {{.name = "s", .x = v, .y = v}}};
            plot.y.logarithmic = logarithmic;
            const std::string svg = plot_svg(plot, {200, 150});
            EXPECT_THAT(svg, Not(HasSubstr("nan")));
            EXPECT_THAT(svg, Not(HasSubstr("inf")));
            EXPECT_NO_THROW(png_of_svg(svg));
            ++drawn;
        }
    }
    EXPECT_EQ(drawn, 18);
    EXPECT_THAT(plot_svg({}), HasSubstr("No point can be shown"));
}

TEST(PlotSvg, GrowsWhenTheLegendIsLong) {
    Plot plot;
    for (int i = 0; i < 200; ++i) plot.series.push_back({.name = "a series", .x = {1}, .y = {1}});
    const std::string svg = plot_svg(plot, {200, 150});
    std::smatch match;
    ASSERT_TRUE(std::regex_search(svg, match, std::regex("width=\"200\" height=\"([0-9]+)\"")));
    EXPECT_GT(std::stoi(match[1]), 200 * 20);
}

TEST(PlotSvg, RefusesWhatCannotBeDrawn) {
    EXPECT_THROW(plot_svg({}, {100, 400}), DomainError);
    EXPECT_THROW(plot_svg({}, {400, kNan}), DomainError);
    EXPECT_THROW(plot_svg({.series = {{.x = {1}}}}), DomainError);
}

/// What the pointer shows: the titles of paths, in their order.
std::vector<std::string> readings(const std::string& svg) {
    std::vector<std::string> texts;
    const std::regex dot("<path [^>]*><title>([^<]*)</title></path>");
    for (std::sregex_iterator p(svg.begin(), svg.end(), dot), end; p != end; ++p) {
        texts.push_back((*p)[1]);
    }
    return texts;
}

TEST(PlotSvg, EveryPointCanBeReadUnderThePointer) {
    Plot plot{.x = {.label = "angle, degrees", .lo = 0, .hi = 100},
              .y = {.label = "L*"},
              .series = {{.name = "gold",
                          .x = {15, 25, 45, 110},
                          .y = {60.12345, kNan, 30, 1},
                          .y_error = {0.123, 0, kInf, 0},
                          .point_labels = {"near", "", "", ""},
                          .dots = true},
                         {.x = {20}, .y = {2e-7}}}};
    // Not what is cut off, at 110, nor what is no number.
    const std::vector<std::string> expected = {
        "angle, degrees: 20\nL*: 2e-07",
        "gold, near\nangle, degrees: 15\nL*: 60.12 ± 0.12",
        "gold\nangle, degrees: 45\nL*: 30",
    };
    EXPECT_EQ(readings(plot_svg(plot)), expected);
    plot.series[0].dots = false;  // now they are invisible, but there
    EXPECT_EQ(readings(plot_svg(plot)).size(), 3u);
    EXPECT_THAT(plot_svg(plot), HasSubstr("fill=\"none\" pointer-events=\"all\""));
}

TEST(PlotSvg, LongLinesHaveNoInvisibleDots) {
    Plot plot{.series = {{}, {.x = {1}, .y = {1}, .dots = true}}};
    for (const std::size_t count : {kMaxInvisibleDots, kMaxInvisibleDots + 1}) {
        plot.series[0].x = plot.series[0].y = std::vector<double>(count, 2.0);
        EXPECT_EQ(readings(plot_svg(plot)).size(), count <= kMaxInvisibleDots ? count + 1 : 1u);
    }
}

TEST(PlotSvg, InvisibleDotsDoNotShow) {
    Plot plot{.x = {.lo = 0, .hi = 10}, .y = {.lo = 0, .hi = 4}, .series = {{.x = {5}, .y = {3}}}};
    plot.series[0].line = false;
    const std::string with = plot_svg(plot);
    plot.series.clear();
    ASSERT_EQ(readings(with).size(), 1u);
    const std::string without = plot_svg(plot);
    EXPECT_EQ(png_of_svg(with),
              png_of_svg(std::regex_replace(without, std::regex("No point can be shown"), "")));
}

TEST(PlotSvg, TheNameOfALineStandsRightOfItsEnd) {
    Plot plot{.x = {.lo = 0, .hi = 10},
              .y = {.lo = 0, .hi = 4},
              .series = {{.x = {0, 1, 5}, .y = {0, 1, 3}, .point_labels = {"", "", "c"}}}};
    const SvgSize size{.width_px = 490, .height_px = 280};
    // (5, 3) is at (262, 82); the label stands kLabelDistance beside it, on the same height.
    EXPECT_THAT(plot_svg(plot, size),
                HasSubstr("<text x=\"272\" y=\"86.2\" text-anchor=\"start\""));
    plot.series[0].point_labels[0] = "a";
    EXPECT_THAT(plot_svg(plot, size), Not(HasSubstr("<text x=\"272\" y=\"86.2\"")));
}

TEST(PlotSvg, LeavesTitleAndLegendToThePage) {
    const Plot plot{.title = "a *title*",
                    .caption = "a caption",
                    .x = {.label = "a*"},
                    .y = {.label = "b*"},
                    .series = {{.name = "gold", .x = {1}, .y = {1}}}};
    const std::string alone = plot_svg(plot);
    EXPECT_THAT(alone, HasSubstr("<title>a title</title>\n<desc>a caption</desc>"));
    EXPECT_THAT(alone, HasSubstr(">a title</text>"));
    EXPECT_THAT(alone, HasSubstr(">gold</text>"));
    const std::string around = plot_svg(plot, {}, TitleAndLegend::around);
    EXPECT_THAT(around, HasSubstr("role=\"img\" aria-label=\"a title: b* against a*\""));
    EXPECT_THAT(around, Not(HasSubstr(">a title</text>")));
    EXPECT_THAT(around, Not(HasSubstr(">gold</text>")));
    EXPECT_THAT(around, Not(HasSubstr("<title>a title")));
}

}  // namespace
}  // namespace nacre::report
