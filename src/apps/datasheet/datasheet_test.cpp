#include "apps/datasheet/datasheet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/report/test_support.h"
#include "nacre/bsdf/models/microflake.h"
#include "nacre/bsdf/models/nacre.h"
#include "nacre/core/error.h"

namespace nacre::datasheet {
namespace {

using report::test::Scan;
using report::test::scan;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

measure::Measurement readings(const std::string& name, double shift) {
    measure::Measurement m;
    m.name = name;
    m.wavelengths_nm = {400, 500, 600, 700};
    for (const double angle : {15.0, 25.0, 45.0, 75.0, 110.0}) {
        const double light = 30 / angle;
        m.readings.push_back(measure::coloured(measure::in_plane(45, angle), m.wavelengths_nm,
                                               {light, light + shift, 0.8 * light, 0.5 * light},
                                               {}));
    }
    return m;
}

PanelReport example(const std::string& text) {
    paint::FlakeSpecies flakes;
    flakes.name = text;
    flakes.amount = paint::VolumeFraction{0.05};
    flakes.body = paint::PrescribedFlake{0.6, 0.0, 0.3};
    PanelReport report{.title = text, .sample = readings(text, 0)};
    report.model = &bsdf::MicroflakeModel::info;
    report.recipe.name = text;
    report.recipe.layers = {paint::Layer{15, {flakes}, {}}};
    report.recipe_sha256 = "0123456789abcdef";
    report.pictures = {{text, report::test::tiny_png()}, {text, report::test::tiny_png()}};
    return report;
}

PanelStandard standard(const std::string& text) {
    PanelStandard other{readings(text, 0.3), {}, true};
    other.difference = measure::difference(other.measurement, readings(text, 0));
    return other;
}

TEST(PanelReport, IsOnePageWithoutScripts) {
    const std::string html = panel_report_html(example("Gold pearl"));
    const Scan page = scan(html);
    EXPECT_EQ(page.error, "");
    EXPECT_EQ(page.count("script"), 0);
    EXPECT_EQ(page.count("img"), 2);
    EXPECT_TRUE(page.links.empty());
    for (const std::string& source : page.sources) EXPECT_EQ(source.substr(0, 5), "data:");
    EXPECT_THAT(html, HasSubstr("default-src 'none'"));
    EXPECT_THAT(html, Not(HasSubstr("script-src")));
    for (const char* part : {"Gold pearl", "Flop index", "Colour travel", "110°", "5 % by volume",
                             "illuminant D65", "0123456789abcdef", "microflake"}) {
        EXPECT_THAT(html, HasSubstr(part));
    }
}

TEST(PanelReport, NamesTheModelOfThePicturesWhereItIsAnother) {
    PanelReport report = example("x");
    report.reading_model = report.model;
    EXPECT_EQ(panel_report_html(report), panel_report_html(example("x")));
    report.model = &bsdf::NacreModel::info;
    EXPECT_THAT(panel_report_html(report),
                AllOf(HasSubstr("by the model microflake ("),
                      HasSubstr("but for pictures, by the model nacre (this project)."),
                      HasSubstr("· model microflake (pictures: nacre) ·")));
}

TEST(PanelReport, ShowsEachReading) {
    PanelReport report = example("x");
    const std::string html = panel_report_html(report);
    std::size_t chips = 0;
    for (std::size_t at = 0; (at = html.find("class=\"chip\"", at)) != std::string::npos; ++at)
        ++chips;
    EXPECT_EQ(chips, 5u);
    // Of a whole hemisphere of readings only those in the plane.
    for (int i = 0; i < 100; ++i) {
        measure::Reading reading = report.sample.readings[0];
        reading.geometry = measure::towards(45, 30, 20 + i);
        report.sample.readings.push_back(reading);
    }
    EXPECT_EQ(scan(panel_report_html(report)).error, "");
    EXPECT_LT(panel_report_html(report).size(), 2 * html.size());
}

TEST(PanelReport, ComparesWithAStandard) {
    PanelReport report = example("sample");
    report.standard = standard("standard");
    const std::string html = panel_report_html(report);
    EXPECT_EQ(scan(html).error, "");
    EXPECT_THAT(html, HasSubstr("ΔE2000"));
    EXPECT_THAT(html, HasSubstr("standard, measured"));
    EXPECT_THAT(html, HasSubstr("stroke-dasharray"));
    EXPECT_THAT(html, HasSubstr("ΔH*"));
    EXPECT_THAT(html, Not(HasSubstr("tolerance")));
    // With a tolerance: its formula, and which angles pass.
    report.standard->verdict =
        measure::judge(report.standard->difference, {measure::parse_formula("cmc1:1"), 1e3, {}});
    const std::string judged = panel_report_html(report);
    EXPECT_EQ(scan(judged).error, "");
    report.sparkle = report.standard->sparkle = measure::SparkleMeasurement{
        .lamps_deg = {15}, .by_lamp = {measure::Sparkle{.sparkle_per_cm2 = {12, 1}}}};
    report.standard->sparkle->by_lamp[0].sparkle_per_cm2 = {17, 2};
    EXPECT_THAT(panel_report_html(report), HasSubstr("per cm²; standard 17 ± 2"));
    EXPECT_THAT(judged,
                AllOf(HasSubstr("ΔE cmc1:1"), HasSubstr("passes"), Not(HasSubstr("fails"))));
}

TEST(PanelReport, NoTextCanBringHtmlAlong) {
    const std::string attack =
        "</p></title></style><script>evil()</script><img src=http://e.example>\"'&";
    PanelReport hostile = example(attack), harmless = example("x");
    hostile.standard = standard(attack);
    harmless.standard = standard("x");
    const Scan page = scan(panel_report_html(hostile));
    EXPECT_EQ(page.error, "");
    EXPECT_EQ(page.tags, scan(panel_report_html(harmless)).tags);
}

TEST(PanelReport, GoesWithoutWhatIsMissing) {
    PanelReport report = example("x");
    report.pictures.clear();
    report.sample.readings.resize(1);
    const std::string html = panel_report_html(report);
    EXPECT_EQ(scan(html).error, "");
    EXPECT_THAT(html, HasSubstr("none"));  // no flop index from one angle
    report.sample.readings.clear();
    report.sample.wavelengths_nm.clear();
    EXPECT_EQ(scan(panel_report_html(report)).error, "");
}

TEST(PanelReport, StatesSparkleWithItsError) {
    PanelReport report = example("x");
    measure::SparkleMeasurement sparkle;
    sparkle.lamps_deg = {15};
    sparkle.by_lamp.resize(1);
    sparkle.by_lamp[0].sparkle_per_cm2 = {12.345, 0.67};
    report.sparkle = sparkle;
    const std::string html = panel_report_html(report);
    EXPECT_THAT(html, HasSubstr("12.3 ± 0.7"));
    EXPECT_THAT(html, HasSubstr("instrument on the market"));
}

TEST(PanelReport, RefusesWhatIsNoPicture) {
    PanelReport report = example("x");
    report.pictures[0].png_bytes = "GIF89a";
    EXPECT_THROW(panel_report_html(report), DomainError);
}

}  // namespace
}  // namespace nacre::datasheet
