#include "nacre/core/quiet_ceres.h"

#include <glog/logging.h>
#include <gtest/gtest.h>

#include <optional>

namespace nacre {
namespace {

std::string printed() {
    ::testing::internal::CaptureStderr();
    LOG(ERROR) << "a complaint";
    return ::testing::internal::GetCapturedStderr();
}

TEST(QuietCeres, KeepsComplaintsFromStderrWhileOneLives) {
    EXPECT_NE(printed().find("a complaint"), std::string::npos);
    {
        std::optional<QuietCeres> first(std::in_place);
        const QuietCeres second;
        EXPECT_EQ(printed(), "");
        first.reset();
        EXPECT_EQ(printed(), "");
    }
    EXPECT_NE(printed().find("a complaint"), std::string::npos);
}

}  // namespace
}  // namespace nacre
