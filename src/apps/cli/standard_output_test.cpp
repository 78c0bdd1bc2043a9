#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "apps/cli/program_test_support.h"

// What goes to the standard output, and messages: whole, in order, and never with success when it is
// lost.

namespace nacre::cli::testing {

namespace {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

using StandardOutput = Program;

TEST_F(StandardOutput, MessagesThatNobodyCanReadEndNothing) {
    for (const char* sink : {"2>&-", "2>/dev/full"}) {
        const auto status = [&](const std::string& arguments) {
            return shell("\"$NACRE\" " + arguments + " " + sink).status;
        };
        EXPECT_EQ(status("info none.toml"), 2) << sink;
        EXPECT_EQ(status("nonsense"), 1) << sink;
        EXPECT_EQ(status("solve gray.toml --wavelength 550 -o s.h5"), 0) << sink;
        EXPECT_EQ(nacre("info s.h5").status, 0) << sink;  // no message went into it
        ASSERT_EQ(nacre(kRender + "-o a.exr").status, 0);
        EXPECT_EQ(status("diff a.exr a.exr --min-psnr 1 --max-relative -1"), 4) << sink;
    }
    EXPECT_EQ(shell("\"$NACRE\" solve gray.toml -o s.h5 --wavelength 550 <&- >&- 2>&-").status, 0);
    EXPECT_EQ(nacre("info s.h5").status, 0);
}

TEST_F(StandardOutput, DataThatAreLostAreAnError) {
    ASSERT_EQ(nacre(kRender + "-o a.exr").status, 0);
    for (const std::string& arguments :
         {kEval, std::string("info gray.toml"), std::string("film"), kAtlas,
          std::string("diff a.exr a.exr"), std::string("--help"), std::string("--version"),
          std::string("eval --help")}) {
        const Outcome full = shell("\"$NACRE\" " + arguments + " > /dev/full");
        EXPECT_EQ(full.status, 3) << arguments;
        EXPECT_EQ(full.err, "nacre: cannot write to standard output: No space left on device\n");
        const Outcome closed = shell("\"$NACRE\" " + arguments + " >&-");
        EXPECT_EQ(closed.status, 3) << arguments;
        EXPECT_EQ(closed.err, "nacre: cannot write to standard output: Bad file descriptor\n");
    }
}

TEST_F(StandardOutput, AReaderThatHasGoneEndsTheProgramSilentlyOnceItsFilesAreWritten) {
    // A pipe, open for writing as 4, whose reader has gone.
    const std::string pipe = "mkfifo pipe; (exec 3< pipe) & exec 4> pipe; wait; ";
    const Outcome data =
        shell(pipe + "\"$NACRE\" " + kEval + "--report r.json >&4; echo $?; rm pipe");
    EXPECT_EQ(data.out, "141\n");  // 128 + SIGPIPE, as of any program
    EXPECT_THAT(data.err, Not(HasSubstr("nacre:")));
    EXPECT_TRUE(exists("r.json"));
    const Outcome ignored =
        shell(pipe + "trap '' PIPE; \"$NACRE\" " + kEval + ">&4; echo $?; rm pipe");
    EXPECT_EQ(ignored.out, "3\n");
    EXPECT_THAT(ignored.err, HasSubstr("cannot write to standard output"));
    // Of messages, the program goes on.
    const Outcome messages =
        shell(pipe + "\"$NACRE\" solve gray.toml --wavelength 550 -o s.h5 2>&4; echo $?; rm pipe");
    EXPECT_EQ(messages.out, "0\n");
    EXPECT_EQ(nacre("info s.h5").status, 0);
}

TEST_F(StandardOutput, AnOpenFileIsAppendedTo) {
    const Outcome outcome =
        shell("echo old > log; \"$NACRE\" " + kEval + "-o /dev/stdout >> log; echo $?");
    EXPECT_EQ(outcome.out, "0\n");
    EXPECT_THAT(contents(folder_ / "log"), AllOf(HasSubstr("old\ntheta_i"), HasSubstr("\n45,")));
}

TEST_F(StandardOutput, OneOutputGoesToTheStandardOutput) {
    write("a.png", "any");
    const std::string fit = "fit gray.toml --start gray.toml --free alpha --starts 1 -q ";
    for (const std::string& arguments :
         {fit + "-o -", fit + "-o /dev/stdout", fit + "-o fitted.toml --report /dev/fd/1",
          std::string("measure gray.toml -q --report -"),
          std::string("measure gray.toml -q -o - --report /dev/stdout"),
          std::string("measure gray.toml -q --uncertainty alpha=1% --contributions -"),
          std::string("diff a.png a.png --report -")}) {
        for (const char* into : {"> out", ">> out", "| cat > out"}) {
            const Outcome outcome =
                shell("rm -f out; { \"$NACRE\" " + arguments + "; echo $? >&2; } " + into);
            EXPECT_THAT(outcome.err, HasSubstr("\n1\n")) << arguments << into;
            EXPECT_THAT(outcome.err, AnyOf(HasSubstr("another output of the same command"),
                                           HasSubstr("is the same file as")))
                << arguments;
            EXPECT_THAT(contents(folder_ / "out"), IsEmpty()) << arguments << into;
        }
    }
    // The file to which it is redirected.
    EXPECT_EQ(shell("\"$NACRE\" " + fit + "-o out.toml > out.toml").status, 1);
    EXPECT_EQ(shell("\"$NACRE\" measure gray.toml -q -o /dev/null > /dev/null").status, 0);
}

TEST_F(StandardOutput, WhatIsInTheStandardOutputStays) {
    const std::string table = nacre(kEval).out;
    for (const char* into : {"> out", ">> out", "1<> out"}) {
        write("out", "");
        const Outcome outcome =
            shell("{ echo first; \"$NACRE\" " + kEval + "-o /dev/stdout; \"$NACRE\" " + kEval +
                  "; echo last; } " + into);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_EQ(contents(folder_ / "out"), "first\n" + table + table + "last\n") << into;
    }
}

}  // namespace

}  // namespace nacre::cli::testing
