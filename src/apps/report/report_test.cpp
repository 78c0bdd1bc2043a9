#include "apps/report/report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "apps/report/parts.h"
#include "apps/report/test_support.h"
#include "nacre/core/error.h"

namespace nacre::report {
namespace {

using test::Scan;
using test::scan;
using test::tiny_png;
using testing::HasSubstr;
using testing::Not;

// A report with the same text in every field that takes one.
Report full_report(const std::string& text, bool with_plot) {
    Report report(text, text);
    report.heading(1, text);
    report.heading(3, text);  // a level left out
    report.heading(2, text);
    report.paragraph(text);
    report.note(text);
    report.bullets({text, text});
    report.definitions({{text, text}});
    report.table({.caption = text,
                  .columns = {text, text},
                  .rows = {{{.text = text, .strong = true, .swatch = "#aabbcc", .footnote = text},
                            number_cell(text)}}});
    report.pictures({{.caption = text, .png_bytes = tiny_png()}}, 2, text);
    if (with_plot) {
        report.plot({.title = text,
                     .caption = text,
                     .x = {.label = text},
                     .y = {.label = text},
                     .series = {{.name = text,
                                 .x = {1, 2},
                                 .y = {3, std::numeric_limits<double>::quiet_NaN()},
                                 .y_error = {1, 1},
                                 .point_colours = {"#112233", "#445566"},
                                 .point_labels = {text, text},
                                 .dots = true}}});
    }
    return report;
}

TEST(Report, IsWellFormed) {
    for (const bool with_plot : {false, true}) {
        const Scan page = scan(full_report("plain *text* `code` [link](#x)", with_plot).html());
        EXPECT_EQ(page.error, "");
        EXPECT_EQ(page.count("h1"), 1);
        EXPECT_EQ(page.count("nav"), 1);
        EXPECT_EQ(page.count("table"), with_plot ? 2 : 1);
        EXPECT_EQ(page.count("img"), 1);
        EXPECT_EQ(std::set(page.ids.begin(), page.ids.end()).size(), page.ids.size());
    }
    EXPECT_EQ(scan(Report("", "").html()).error, "");
}

TEST(Report, TheReaderOfTheseTestsNoticesMistakes) {
    const std::string doctype = "<!doctype html>";
    EXPECT_EQ(scan(doctype + "<p>x</p>").error, "");
    for (const char* wrong : {"<p>", "</p>", "<p><b></p></b>", "a < b", "a & b", "<p id=x></p>",
                              "<p id=\"a\" id=\"b\"></p>", "<script>", "<p onclick=\"x\"></p>"}) {
        EXPECT_NE(scan(doctype + wrong).error, "") << wrong;
    }
}

TEST(Report, NoTextCanBringHtmlAlong) {
    const std::string attack =
        "</script></title></style></pre>--><!--<script>evil()</script><img src=http://e.example "
        "onerror=evil()>\"' onload=\"evil() [x](javascript:evil()) &copy;";
    const std::string html = full_report(attack, true).html();
    const Scan page = scan(html);
    const Scan harmless = scan(full_report("harmless", true).html());
    EXPECT_EQ(page.error, "");
    EXPECT_EQ(page.tags, harmless.tags);
    EXPECT_EQ(page.links.size(), harmless.links.size());
    for (const std::string& link : page.links) EXPECT_EQ(link[0], '#') << link;
    EXPECT_THAT(html, Not(HasSubstr("<script>evil")));
    EXPECT_THAT(html, Not(HasSubstr("<img src=http")));
    EXPECT_THAT(page.text, HasSubstr("&lt;script&gt;evil()&lt;/script&gt;"));
}

TEST(Report, TextThatIsNoUtf8BecomesUtf8) {
    const std::string html = full_report("a\xFF\xC3", true).html();
    EXPECT_EQ(scan(html).error, "");
    EXPECT_THAT(html, HasSubstr("<p>a\uFFFD\uFFFD</p>"));
    EXPECT_THAT(html, Not(HasSubstr("\xFF")));
}

TEST(Report, NeedsNothingFromOutside) {
    const Scan page = scan(full_report("see [the paper](https://example.org/a)", true).html());
    ASSERT_FALSE(page.sources.empty());
    for (const std::string& source : page.sources) EXPECT_EQ(source.substr(0, 5), "data:");
    EXPECT_THAT(page.links, testing::Contains("https://example.org/a"));
    // And browsers are told to fetch nothing.
    const std::string html = Report("t").html();
    EXPECT_THAT(html, HasSubstr("default-src 'none'"));
    EXPECT_THAT(html, Not(HasSubstr("url(")));
    EXPECT_THAT(html, Not(HasSubstr("@import")));
}

TEST(Report, HasNoScriptsAndIsSmall) {
    const std::string html = full_report("x", true).html();
    EXPECT_EQ(scan(html).count("script"), 0);
    EXPECT_THAT(html, Not(HasSubstr("script-src")));
    EXPECT_LT(html.size(), 20'000u);
}

TEST(Report, PlotsAreDrawnWithTitleLegendCaptionAndNumbers) {
    Report report("t");
    report.plot({.title = "Noise",
                 .caption = "of one picture",
                 .x = {.label = "nm"},
                 .y = {.label = "R"},
                 .series = {{.name = "s", .x = {550}, .y = {0.123456789}, .y_error = {0.01}}}});
    const std::string html = report.html();
    const Scan page = scan(html);
    EXPECT_EQ(page.error, "");
    EXPECT_THAT(html, HasSubstr("<p class=\"plot-title\">Noise</p>"));
    EXPECT_THAT(html, HasSubstr("<ul class=\"legend\">"));
    EXPECT_THAT(html, HasSubstr("role=\"img\" aria-label=\"Noise: R against nm\""));
    EXPECT_THAT(html, HasSubstr("<figcaption>of one picture</figcaption>"));
    for (const char* part : {"nm", "550", "0.123457", "0.01"}) {
        EXPECT_THAT(page.text, HasSubstr(part));
    }
}

TEST(Report, PlotsOfEqualScaleAreAsHighAsTheirDataAsk) {
    const auto height = [](double tallest, std::optional<double> end) {
        const Plot plot{.x = {.lo = 0, .hi = end},
                        .y = {.lo = 0, .hi = end ? std::optional(100 * *end) : end},
                        .equal_scale = true,
                        .series = {{.x = {0, 10}, .y = {0, tallest}}}};
        return page_size(plot).height_px;
    };
    EXPECT_GT(height(10, {}), height(7, {}));
    EXPECT_GT(height(7, {}), height(1, {}));
    EXPECT_LE(height(10, 1), 600);  // a tower of 1 to 100 is not asked for
}

TEST(Report, ContentsLinkToHeadings) {
    Report report("t");
    report.heading(1, "The *first*");
    report.heading(2, "The first");
    report.heading(3, "Deep");
    report.heading(1, "1.5 µm", "thin");
    const Scan page = scan(report.html());
    EXPECT_EQ(page.ids, (std::vector<std::string>{"the-first", "the-first-2", "deep", "thin"}));
    EXPECT_EQ(page.links, (std::vector<std::string>{"#the-first", "#the-first-2", "#thin"}));
    EXPECT_THROW(report.heading(1, "x", "thin"), DomainError);
    EXPECT_THROW(report.heading(1, "x", "Thin"), DomainError);
    EXPECT_THROW(report.heading(0, "x"), DomainError);
    EXPECT_THROW(report.heading(4, "x"), DomainError);
}

TEST(Report, EqualFootnotesShareAMark) {
    Report report("t");
    report.table({.columns = {"a", "b", "c"},
                  .rows = {{{.text = "1", .footnote = "n"},
                            {.text = "2", .footnote = "m"},
                            {.text = "3", .footnote = "n"}}}});
    const Scan page = scan(report.html());
    EXPECT_EQ(page.links, (std::vector<std::string>{"#note_1_a", "#note_1_b", "#note_1_a"}));
    EXPECT_EQ(page.ids, (std::vector<std::string>{"note_1_a", "note_1_b"}));
}

TEST(Report, HeadingsOverNumbersStandRight) {
    Report report("t");
    report.table({.columns = {"name", "dB", "none"}, .rows = {{{"x"}, number_cell("1"), {}}}});
    EXPECT_THAT(report.html(), HasSubstr("<th scope=\"col\">name</th><th scope=\"col\" "
                                         "class=\"number\">dB</th><th scope=\"col\">none</th>"));
}

TEST(Report, PicturesAreInThePage) {
    Report report("t");
    report.pictures({{.caption = "a *b*", .png_bytes = tiny_png()}}, 4);
    // python3 -c "import base64;
    // print(base64.b64encode(b'\x89PNG\r\n\x1a\n\0\0\0\x0DIHDR\0\0\0\x03'
    // b'\0\0\0\x02\x08\x02\0\0\0'))"
    EXPECT_THAT(report.html(),
                HasSubstr("<img alt=\"a b\" width=\"3\" height=\"2\" src=\"data:"
                          "image/png;base64,iVBORw0KGgoAAAANSUhEUgAAAAMAAAACCAIAAAA="));
}

TEST(Report, RefusesWhatItCannotShow) {
    Report report("t");
    EXPECT_THROW(report.pictures({{.caption = "x", .png_bytes = "GIF89a"}}, 1), DomainError);
    EXPECT_THROW(report.pictures({{.caption = "x", .png_bytes = ""}}, 1), DomainError);
    EXPECT_THROW(report.pictures({}, 0), DomainError);
    EXPECT_THROW(report.pictures({}, 9), DomainError);
    EXPECT_THROW(report.table({.columns = {"a"}, .rows = {{}}}), DomainError);
    EXPECT_THROW(report.table({.columns = {"a"}, .rows = {{{.swatch = "red"}}}}), DomainError);
    EXPECT_THROW(report.plot({.series = {{.x = {1}}}}), DomainError);
    EXPECT_EQ(report.html(), Report("t").html());  // a refused part leaves nothing behind
}

}  // namespace
}  // namespace nacre::report
