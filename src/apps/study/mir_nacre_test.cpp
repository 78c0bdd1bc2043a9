#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "apps/study/mir_2022.h"
#include "nacre/core/file.h"
#include "nacre/testing/files.h"

namespace nacre::study {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

/// Every number in it, however deep.
template <class Visit>
void for_each_number(const json& value, const Visit& visit) {
    if (value.is_number()) visit(value.get<double>());
    if (!value.is_structured()) return;
    for (const json& part : value) for_each_number(part, visit);
}

struct Page {
    std::string html;
    json results;
};

/// What the study of the model nacre writes, at the least size; some seconds.
Page make_page() {
    const test::TempFolder folder;
    const auto page = run_mir_2022(
        {.folder = folder.path(),
         .size = 16,
         .samples = 8,
         .quick = true,
         .parts = {MirPart::table_3, MirPart::nacre}},
        [](const std::string&, const std::function<void(const Progress&)>& work) { work({}); });
    return {read_file(page), json::parse(read_file(folder / "results.json"))};
}

void expect_one_model_with_all_capabilities(const Page& page) {
    const json& table = page.results.at("table_3");
    const auto does_all = [](const json& can) {
        return can.at("goniochromism") && can.at("sparkle") && can.at("multiple_scattering");
    };
    for (const auto& [name, can] : table.items()) {
        EXPECT_EQ(does_all(can), name == "nacre") << name;  // what the paper ends with
    }
    EXPECT_THAT(page.html, HasSubstr("<code>nacre</code>"));
}

void expect_timed_pictures(const Page& page) {
    const json& rows = page.results.at("nacre").at("by_number");
    for (const char* key : {"microflake", "1e7", "1e12"}) {
        EXPECT_GT(rows.at(key).at("seconds"), 0) << key;
        EXPECT_GT(rows.at(key).at("peak_mib"), 0) << key;
    }
    EXPECT_EQ(rows.at("microflake").at("ratio_to_microflake"), 1);
    EXPECT_THAT(page.html, HasSubstr("10¹²"));
}

void expect_a_point_for_each_footprint(const Page& page) {
    const json& queries = page.results.at("nacre").at("query_ns");
    const std::size_t footprints = queries.at("footprints").size();
    EXPECT_GE(footprints, 3u);
    EXPECT_EQ(queries.size(), 8u);  // the footprints and seven curves
    for (const auto& [name, curve] : queries.items()) EXPECT_EQ(curve.size(), footprints) << name;
}

void expect_errors_that_fall(const Page& page) {
    const json& cases = page.results.at("nacre").at("equal_time");
    EXPECT_EQ(cases.size(), 2u);
    for (const auto& [name, result] : cases.items()) {
        for (const char* model : {"special-effect", "nacre"}) {
            const json& error = result.at(model).at("square_error_over_square_mean");
            const json& seconds = result.at(model).at("seconds");
            ASSERT_EQ(error.size(), seconds.size());
            ASSERT_GE(error.size(), 3u);
            EXPECT_GT(seconds.back(), seconds.front()) << name;
        }
        // 16 times the samples: a 16th of the error, give or take fireflies.
        const json& error = result.at("nacre").at("square_error_over_square_mean");
        EXPECT_LT(error.back(), error.front()) << name;
    }
}

void expect_finite_and_positive(const Page& page) {
    int count = 0;
    for_each_number(page.results.at("nacre"), [&](double x) {
        EXPECT_TRUE(std::isfinite(x) && x > 0) << x;
        ++count;
    });
    EXPECT_GT(count, 60);
}

// One test, as CTest starts a program for each.
TEST(MirNacre, ResultsAreCompleteAndInOrder) {
    const Page page = make_page();
    expect_one_model_with_all_capabilities(page);
    expect_timed_pictures(page);
    expect_a_point_for_each_footprint(page);
    expect_errors_that_fall(page);
    expect_finite_and_positive(page);
}

}  // namespace
}  // namespace nacre::study
