#include "nacre/core/memory.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "nacre/core/error.h"
#include "nacre/testing/errors.h"

namespace nacre {
namespace {

using test::message_of;

TEST(Memory, WorkThatNeedsMoreThanThereIsIsRefusedAndSaysWhatToDo) {
    EXPECT_NO_THROW(require_memory(1e6, "work", "do less"));
    EXPECT_THAT(message_of<Error>([] { require_memory(1e18, "work", "do less"); }),
                testing::MatchesRegex(
                    "work takes 1000000000.0 GB of memory, and [0-9.]+ GB are free: do less"));
}

// A tree of control groups, and what a process says of its own.
class ControlGroups : public testing::Test {
 protected:
    void TearDown() override { std::filesystem::remove_all(root_); }

    void write(const std::filesystem::path& path, const std::string& text) const {
        std::filesystem::create_directories((root_ / path).parent_path());
        std::ofstream(root_ / path) << text;
    }
    std::uint64_t left(const std::string& membership) const {
        write("self", membership);
        return detail::control_group_memory(root_ / "self", root_ / "groups");
    }

 private:
    const std::filesystem::path root_ = [] {
        std::string name = testing::TempDir() + "control_groups_XXXXXX";
        return std::filesystem::path(mkdtemp(name.data()));
    }();
};

TEST_F(ControlGroups, WithoutLimitsLeaveAll) {
    EXPECT_EQ(left("0::/user.slice/job\n"), UINT64_MAX);
    write("groups/user.slice/job/memory.max", "max\n");
    EXPECT_EQ(left("0::/user.slice/job\n"), UINT64_MAX);
    EXPECT_EQ(left("of another kind\n"), UINT64_MAX);
}

TEST_F(ControlGroups, LeaveTheLeastOfTheirOwnAndOfThoseAbove) {
    write("groups/user.slice/job/memory.max", "5000\n");
    write("groups/user.slice/job/memory.current", "1000\n");
    EXPECT_EQ(left("0::/user.slice/job\n"), 4000u);
    write("groups/user.slice/memory.max", "6000\n");
    write("groups/user.slice/memory.current", "3500\n");
    EXPECT_EQ(left("0::/user.slice/job\n"), 2500u);
    write("groups/memory.max", "100\n");  // as a container sees its own
    write("groups/memory.current", "200\n");
    EXPECT_EQ(left("0::/user.slice/job\n"), 0u);
    EXPECT_EQ(left("0::/not/seen/here\n"), 0u);
}

TEST_F(ControlGroups, DoNotCountPagesOfFilesThatAreDropped) {
    write("groups/job/memory.max", "5000\n");
    write("groups/job/memory.current", "4500\n");
    write("groups/job/memory.stat", "anon 500\ninactive_file 3000\nactive_file 1000\n");
    EXPECT_EQ(left("0::/job\n"), 3500u);
}

TEST_F(ControlGroups, OfVersion1AreReadWhereMemoryIsTheirs) {
    write("groups/memory/job/memory.limit_in_bytes", "5000\n");
    write("groups/memory/job/memory.usage_in_bytes", "4500\n");
    write("groups/memory/job/memory.stat", "inactive_file 1\ntotal_inactive_file 3000\n");
    write("groups/memory/memory.limit_in_bytes", "9223372036854771712\n");
    EXPECT_EQ(left("4:cpu,memory:/job\n3:pids:/other\n0::/\n"), 3500u);
    EXPECT_EQ(left("4:cpu,memory_like:/job\n"), UINT64_MAX);
}

}  // namespace
}  // namespace nacre
