#include "apps/study/mir_document.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/testing/errors.h"

namespace nacre::study {
namespace {

using nlohmann::json;
using ::testing::HasSubstr, ::testing::Not;

json small_results() {
    return {{"study", "mir-2022"},
            {"version", "1.2"},
            {"hardware", "an abacus"},
            {"size", 512},
            {"samples_per_pixel", 1024},
            {"seed", 3},
            {"quick", false},
            {"tables",
             {{"times",
               {{"columns", json::array({"model", "time"})},
                {"numeric", {false, true}},
                {"rows", json::array({json::array({"a|b", "3 s"}), json::array({"", "4 s"})})}}}}}};
}

TEST(StudyDocument, TablesReplaceWhatStandsBetweenTheirMarkers) {
    const std::string text =
        "# Title\n<!-- begin: times -->\nold\n<!-- end: times -->\nprose\n"
        "<!-- begin: setting --><!-- end: setting -->\n";
    const std::string expected =
        "# Title\n<!-- begin: times -->\n\n| model | time |\n| --- | ---: |\n| a\\|b | 3 s |\n"
        "| | 4 s |\n\n<!-- end: times -->\nprose\n<!-- begin: setting -->\n\n512 x 512 pixels, "
        "1024 samples each; nacre 1.2, seed 3; an abacus.\n\n<!-- end: setting -->\n";
    EXPECT_EQ(with_tables(text, "page.md", small_results()), expected);
    EXPECT_EQ(with_tables(expected, "page.md", small_results()), expected);
}

TEST(StudyDocument, SaysThatResultsAreScaledDown) {
    json results = small_results();
    const std::string text = "<!-- begin: setting --><!-- end: setting -->";
    EXPECT_THAT(with_tables(text, "page.md", results), Not(HasSubstr("Scaled down")));
    results["samples_per_pixel"] = 64;
    EXPECT_THAT(with_tables(text, "page.md", results), HasSubstr("Scaled down"));
}

TEST(StudyDocument, RefusesMarkersThatLeadNowhere) {
    const auto message = [](const std::string& text) {
        return test::message_of<InputError>([&] { with_tables(text, "page.md", small_results()); });
    };
    EXPECT_THAT(message("no marker"), HasSubstr("page.md: has no marker"));
    EXPECT_THAT(message("<!-- begin: times -->"), HasSubstr("has no '<!-- end: times -->'"));
    EXPECT_THAT(message("<!-- begin: none --><!-- end: none -->"), HasSubstr("no table 'none'"));
    EXPECT_THROW(with_tables("<!-- begin: times --><!-- end: times -->", "page.md", json::object()),
                 InputError);
}

// The documentation shows what the program wrote from the results that are kept beside the recipes.
TEST(StudyDocument, TheDocumentationHasTheTablesOfTheKeptResults) {
    const std::filesystem::path results = shipped_file("studies/mir-2022/results.json");
    const std::filesystem::path docs = results.parent_path().parent_path().parent_path() / "docs";
    const json kept = json::parse(read_file(results));
    for (const char* name : {"mir-2022.md", "tables.md"}) {
        const std::string text = read_file(docs / name);
        EXPECT_TRUE(with_tables(text, name, kept) == text)
            << name << " is not what `nacre study mir-2022 --document` writes: run ./dev study";
    }
}

}  // namespace
}  // namespace nacre::study
