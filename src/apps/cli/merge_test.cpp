#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "apps/cli/program_test_support.h"

// `nacre render --shard` and `nacre merge`.

namespace nacre::cli::testing {

namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const std::string kMacro = "render macro --paint gray.toml --size 24x16 --spp 10 -q ";

TEST_F(Program, MergeWritesTheFilesOfOneProcess) {
    ASSERT_EQ(nacre(kMacro + "--sparkle --spectral-bins 5 -o whole.exr").status, 0);
    for (const char* number : {"1", "2", "3"}) {
        const std::string n = number;
        const Outcome shard = nacre(kMacro + "--sparkle --spectral-bins 5 --shard " + n +
                                    "/3 -o part." + n + ".h5 --report part." + n + ".json");
        ASSERT_EQ(shard.status, 0) << shard.err;
    }
    EXPECT_FALSE(exists("part.1.png"));
    const Outcome merged =
        nacre("merge part.3.h5 part.1.h5 part.2.h5 -o merged.exr --report merged.json");
    ASSERT_EQ(merged.status, 0) << merged.err;
    EXPECT_THAT(merged.err, AllOf(HasSubstr("merged.exr and merged.png: 24 x 16 pixels, 10 samples "
                                            "each, noise "),
                                  HasSubstr("of 3 shards")));
    EXPECT_EQ(contents(folder_ / "merged.exr"), contents(folder_ / "whole.exr"));
    EXPECT_EQ(contents(folder_ / "merged.png"), contents(folder_ / "whole.png"));
    // What was done adds up.
    const auto report = nlohmann::json::parse(contents(folder_ / "merged.json"));
    double seconds = 0;
    int samples = 0;
    for (const char* file : {"part.3.json", "part.1.json", "part.2.json"}) {
        const auto part = nlohmann::json::parse(contents(folder_ / file));
        seconds += part["render_s"].get<double>();
        samples += part["samples_per_pixel"].get<int>();
    }
    EXPECT_EQ(report["render_s"], seconds);
    EXPECT_EQ(report["samples_per_pixel"], samples);
    EXPECT_EQ(report["shares"].size(), 3u);

    EXPECT_EQ(nacre("merge part.1.h5 part.2.h5 part.3.h5 --exposure 1 -o bright.exr").status, 0);
    EXPECT_EQ(contents(folder_ / "bright.exr"), contents(folder_ / "whole.exr"));
    EXPECT_NE(contents(folder_ / "bright.png"), contents(folder_ / "whole.png"));
    EXPECT_EQ(nacre("merge part.1.h5 part.2.h5 part.3.h5 --gamut display-p3 -o p3.exr").status, 0);
    EXPECT_EQ(contents(folder_ / "p3.exr"), contents(folder_ / "whole.exr"));
    EXPECT_THAT(contents(folder_ / "p3.png"), HasSubstr("cICP"));
}

TEST_F(Program, MergeSaysAsMuchAsOneProcessOfHowItWasMade) {
    const std::string frame =
        kMacro + "--depth 3 --footprint 0.5 --no-hot-spot --frames 2:2 --turntable light --step 7 ";
    ASSERT_EQ(nacre(frame + "-o whole.exr").status, 0);
    ASSERT_EQ(nacre(frame + "--shard 1/2 -o a.h5").status, 0);
    ASSERT_EQ(nacre(frame + "--shard 2/2 -o b.h5").status, 0);
    ASSERT_EQ(nacre("merge a.0002.h5 b.0002.h5 -o merged.exr --exposure 2 --report r.json").status,
              0);
    EXPECT_EQ(contents(folder_ / "merged.exr"), contents(folder_ / "whole.0002.exr"));
    const auto report = nlohmann::json::parse(contents(folder_ / "r.json"));
    EXPECT_EQ(report["exposure_stops"], 2);
    EXPECT_EQ(report["gamut"], "rec709");
    EXPECT_EQ(report["header"]["nacre:depth"], "3");
    EXPECT_THAT(nacre("info merged.exr").out,
                AllOf(HasSubstr("nacre:depth: 3"), HasSubstr("nacre:turn_deg: 14")));
}

TEST_F(Program, MergeRefusesWhatIsNotOnePicture) {
    ASSERT_EQ(nacre(kMacro + "--shard 1/2 -o a.h5").status, 0);
    ASSERT_EQ(nacre(kMacro + "--shard 2/2 --specimen 3 -o other.h5").status, 0);
    const auto refused = [&](const std::string& shards) {
        const Outcome outcome = nacre("merge " + shards + " -o x.exr");
        EXPECT_EQ(outcome.status, 2) << shards;
        EXPECT_FALSE(exists("x.exr")) << shards;
        return outcome.err;
    };
    EXPECT_THAT(refused("a.h5"), HasSubstr("a.h5: of its picture, shards are missing: 2/2"));
    EXPECT_THAT(refused("a.h5 a.h5"), HasSubstr("a.h5: holds the shard 1/2, as does a.h5"));
    EXPECT_THAT(refused("a.h5 other.h5"),
                HasSubstr("other.h5: nacre:specimen = 3, but a.h5 has 0: they are shards of "
                          "different pictures"));
    EXPECT_THAT(refused("gray.toml"), HasSubstr("gray.toml: is a recipe; a shard of a picture"));
    EXPECT_EQ(nacre("merge a.h5 -o x.png").status, 1);
    EXPECT_THAT(nacre("eval a.h5 --incident 45 --outgoing 30").err,
                HasSubstr("a shard of a picture; nacre merge puts the shards together"));
}

TEST_F(Program, RenderRefusesShardsThatMakeNoSense) {
    const auto refused = [&](const std::string& options) {
        const Outcome outcome = nacre(kMacro + options);
        EXPECT_EQ(outcome.status, 1) << options << outcome.err;
        return outcome.err;
    };
    for (const char* shard : {"3/2", "0/2", "1/11", "1", "1/2/3", "a/b", "1.5/2", "''"}) {
        EXPECT_THAT(refused("-o s.h5 --shard " + std::string(shard)), HasSubstr("--shard"))
            << shard;
    }
    EXPECT_THAT(refused("-o s.exr --shard 1/2"), HasSubstr("must end in .h5"));
    EXPECT_THAT(refused("-o s.h5"), HasSubstr("must end in .exr"));
    EXPECT_THAT(refused("-o s.h5 --shard 1/2 --noise 0.1"), HasSubstr("exclude each other"));
    EXPECT_THAT(refused("-o s.h5 --shard 1/2 --frames 0:1 --turntable light --video v.gif"),
                HasSubstr("makes no pictures for --video"));
    EXPECT_THAT(refused("-o s.h5 --shard 1/2 --exposure 1"), HasSubstr("belong to nacre merge"));
}

TEST_F(Program, FramesHaveShardsToo) {
    const std::string turning = "--frames 1:2 --turntable camera --step 10 ";
    ASSERT_EQ(nacre(kMacro + turning + "-o whole.exr").status, 0);
    ASSERT_EQ(nacre(kMacro + turning + "--shard 1/2 -o a.h5").status, 0);
    ASSERT_EQ(nacre(kMacro + turning + "--shard 2/2 -o b.h5").status, 0);
    ASSERT_EQ(nacre("merge a.0002.h5 b.0002.h5 -o merged.exr").status, 0);
    EXPECT_EQ(contents(folder_ / "merged.exr"), contents(folder_ / "whole.0002.exr"));
    EXPECT_THAT(nacre("merge a.0001.h5 b.0002.h5 -o x.exr").err, HasSubstr("seed = 2, but"));
}

}  // namespace

}  // namespace nacre::cli::testing
