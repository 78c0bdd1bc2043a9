#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/report/markup.h"
#include "apps/report/page.h"
#include "nacre/core/file.h"
#include "nacre/core/sha256.h"

namespace nacre::report {
namespace {

struct Vendored {
    const char* name;
    const char* sha256;  // as in data/web/README.md: `sha256sum data/web/*.js`
};

constexpr Vendored kScripts[] = {
    {"web/d3.min.js", "f2094bbf6141b359722c4fe454eb6c4b0f0e42cc10cc7af921fc158fceb86539"},
    {"web/plot.umd.min.js", "4358086467740777dd788d6b27a95cebdbaefdd50c730a3060117073bd7134cb"},
};

TEST(Scripts, AreThoseOfTheirPackages) {
    for (const Vendored& script : kScripts) {
        EXPECT_EQ(sha256_hex(read_file(data_file(script.name))), script.sha256) << script.name;
    }
}

TEST(Scripts, StayAsTheyAreInThePage) {
    for (const Vendored& script : kScripts) {
        const std::string source = read_file(data_file(script.name));
        EXPECT_EQ(clean_utf8(source), source) << script.name;
        EXPECT_EQ(escape_script(source), source) << script.name;
    }
    EXPECT_EQ(escape_script(plots_js()), plots_js());
}

TEST(Scripts, ComeWithTheirLicences) {
    const std::string notice = read_file(data_file("web/NOTICE.txt"));
    for (const char* part : {"d3 7.9.0", "@observablehq/plot 0.6.17", "Mikola Lysenko"}) {
        EXPECT_THAT(notice, testing::HasSubstr(part));
    }
}

}  // namespace
}  // namespace nacre::report
