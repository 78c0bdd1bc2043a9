#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <string>

// The main() of every test program. GoogleTest reports the tests of a suite whose SetUpTestSuite()
// has failed as skipped, which CTest takes for no failure. Here they fail. A test counts as skipped
// only if it says why,
//
//     GTEST_SKIP() << "needs a GPU";
//
// and fails if it does not. Whoever runs no test at all has mistaken its name: a failure too.

namespace {

/// What a skipped test gave as its reason; "" if nothing.
std::string reason_of_skip(const testing::TestResult& result) {
    for (int i = 0; i < result.total_part_count(); ++i) {
        const testing::TestPartResult& part = result.GetTestPartResult(i);
        if (!part.skipped()) continue;
        // Traces, which GoogleTest appends, are no reason.
        std::string text = part.message();
        text.erase(std::min(text.size(), text.find("\nGoogle Test trace:")));
        if (text.find_first_not_of(" \n") != std::string::npos) return text;
    }
    return "";
}

/// Appended to the list of listeners: hears of a test's start after the one that prints, and of its
/// end before, which then prints what has become of the test here.
class SkipsFail final : public testing::EmptyTestEventListener {
    void OnTestStart(const testing::TestInfo&) override {
        const auto* suite = testing::UnitTest::GetInstance()->current_test_suite();
        if (suite->ad_hoc_test_result().Failed()) ADD_FAILURE() << "the suite's set-up has failed";
    }
    void OnTestEnd(const testing::TestInfo& test) override {
        if (!test.result()->Skipped()) return;
        const std::string reason = reason_of_skip(*test.result());
        if (reason.empty()) {
            ADD_FAILURE() << "skipped without a reason; write GTEST_SKIP() << \"why\"";
        } else {
            std::printf("skipped, for a reason: %s\n", reason.c_str());  // for check_skips.py
        }
    }
};

}  // namespace

int main(int argc, char** argv) {
    testing::InitGoogleMock(&argc, argv);
    testing::UnitTest& tests = *testing::UnitTest::GetInstance();
    tests.listeners().Append(new SkipsFail);  // the list deletes it
    const int status = RUN_ALL_TESTS();
    if (!testing::GTEST_FLAG(list_tests) && tests.test_to_run_count() == 0) {
        std::printf("no test has this name\n");
        return 1;
    }
    return status;
}
