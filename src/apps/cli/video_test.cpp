#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <string>

#include "apps/cli/program_test_support.h"

// `nacre render --frames --video`, with a program in the place of ffmpeg.

namespace nacre::cli::testing {

namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

class Video : public Program {
 protected:
    /// A program called ffmpeg, alone on PATH beside what it needs.
    void put_ffmpeg(const std::string& script) {
        const std::filesystem::path bin = folder_ / "bin";
        std::filesystem::create_directories(bin);
        const std::filesystem::path program = bin / "ffmpeg";
        write("bin/ffmpeg", "#!/bin/sh\n" + script);
        ASSERT_EQ(chmod(program.c_str(), 0755), 0);
        path_ = "PATH=" + bin.string() + ":/usr/bin:/bin";
    }

    std::string path_ = "PATH=.";  // what it runs with
    const std::string frames_ =
        "render macro --paint gray.toml --size 9x7 --spp 1 -q --frames 2:4 --turntable shape "
        "--step 5 -o turn.exr ";
};

TEST_F(Video, IsMadeOfTheFramesAndPutInPlaceWhole) {
    // Says in the video how it was called.
    put_ffmpeg(
        "for last; do :; done\ncase $last in -version) ;; *) echo \"$@\" > \"$last\";; esac\n");
    const Outcome made = nacre(frames_ + "--video turn.mp4 --fps 12", path_);
    ASSERT_EQ(made.status, 0) << made.err;
    EXPECT_THAT(contents(folder_ / "turn.mp4"),
                AllOf(HasSubstr("-framerate 12 -start_number 2 -i turn.%04d.png -frames:v 3"),
                      HasSubstr("-f mp4")));
    EXPECT_TRUE(exists("turn.0004.png"));
}

TEST_F(Video, ThatFailsLeavesTheOldOneAndTheFrames) {
    write("turn.gif", "old");
    put_ffmpeg("case $1 in -version) ;; *) echo 'no such codec' >&2; exit 3;; esac\n");
    const Outcome failed = nacre(frames_ + "--video turn.gif", path_);
    EXPECT_EQ(failed.status, 3);
    EXPECT_THAT(failed.err, AllOf(HasSubstr("turn.gif: ffmpeg could not make the video (exit "
                                            "status 3)"),
                                  HasSubstr("no such codec")));
    EXPECT_EQ(contents(folder_ / "turn.gif"), "old");
    EXPECT_TRUE(exists("turn.0002.exr"));
}

TEST_F(Video, IsRefusedBeforeAnyFrameWhereItCannotBe) {
    const Outcome without = nacre(frames_ + "--video turn.mp4", path_);
    EXPECT_EQ(without.status, 1);
    EXPECT_THAT(without.err, HasSubstr("needs the program ffmpeg"));
    EXPECT_FALSE(exists("turn.0002.exr"));
    EXPECT_THAT(nacre(frames_ + "--video turn.avi").err, HasSubstr("must end in .mp4"));
    EXPECT_THAT(nacre("render macro --paint gray.toml --video a.mp4 -o a.exr").err,
                HasSubstr("--video belongs to --frames"));
}

}  // namespace

}  // namespace nacre::cli::testing
