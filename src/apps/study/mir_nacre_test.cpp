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

class MirNacre : public ::testing::Test {
 protected:
    // Once for all tests of a process: some seconds.
    void SetUp() override {
        if (!html_.empty()) return;
        const test::TempFolder folder;
        const auto page = run_mir_2022(
            {.folder = folder.path(),
             .size = 16,
             .samples = 8,
             .quick = true,
             .parts = {MirPart::table_3, MirPart::nacre}},
            [](const std::string&, const std::function<void(const Progress&)>& work) { work({}); });
        html_ = read_file(page);
        results_ = json::parse(read_file(folder / "results.json"));
    }

    static inline std::string html_;
    static inline json results_;
};

TEST_F(MirNacre, TableThreeHasOneModelWithAllCapabilities) {
    const json& row = results_.at("table_3").at("nacre");
    EXPECT_TRUE(row.at("goniochromism"));
    EXPECT_TRUE(row.at("sparkle"));
    EXPECT_TRUE(row.at("multiple_scattering"));
    int others_do_all = 0;
    for (const auto& [name, can] : results_.at("table_3").items()) {
        others_do_all += name != "nacre" && can.at("goniochromism") && can.at("sparkle") &&
                         can.at("multiple_scattering");
    }
    EXPECT_EQ(others_do_all, 0);  // what the paper ends with
    EXPECT_THAT(html_, HasSubstr("<code>nacre</code>"));
}

TEST_F(MirNacre, PicturesAreTimedForEveryNumberOfFlakes) {
    const json& rows = results_.at("nacre").at("by_number");
    for (const char* key : {"microflake", "1e7", "1e12"}) {
        EXPECT_GT(rows.at(key).at("seconds"), 0) << key;
        EXPECT_GT(rows.at(key).at("peak_mib"), 0) << key;
    }
    EXPECT_EQ(rows.at("microflake").at("ratio_to_microflake"), 1);
    EXPECT_THAT(html_, HasSubstr("10¹²"));
}

TEST_F(MirNacre, EveryCurveOfQueriesHasAPointForEachFootprint) {
    const json& queries = results_.at("nacre").at("query_ns");
    const std::size_t footprints = queries.at("footprints").size();
    EXPECT_GE(footprints, 3u);
    EXPECT_EQ(queries.size(), 8u);  // the footprints and seven curves
    for (const auto& [name, curve] : queries.items()) EXPECT_EQ(curve.size(), footprints) << name;
}

TEST_F(MirNacre, ErrorsFallWithTime) {
    const json& cases = results_.at("nacre").at("equal_time");
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

TEST_F(MirNacre, AllThatIsMeasuredIsFiniteAndPositive) {
    int count = 0;
    for_each_number(results_.at("nacre"), [&](double x) {
        EXPECT_TRUE(std::isfinite(x) && x > 0) << x;
        ++count;
    });
    EXPECT_GT(count, 60);
}

}  // namespace
}  // namespace nacre::study
