#include "nacre/core/progress.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <limits>
#include <thread>

#include "nacre/core/error.h"
#include "nacre/core/parallel.h"

namespace nacre {
namespace {

TEST(Interrupt, TheFirstSignalOnlySetsTheFlag) {
    for (int signal_number : {SIGINT, SIGTERM}) {
        const InterruptHandler handler;
        EXPECT_FALSE(interrupt_requested());
        raise(signal_number);
        EXPECT_TRUE(interrupt_requested());
    }
    EXPECT_FALSE(interrupt_requested());
}

TEST(Interrupt, ThePreviousHandlerComesBack) {
    struct sigaction before, after;
    sigaction(SIGINT, nullptr, &before);
    { const InterruptHandler handler; }
    sigaction(SIGINT, nullptr, &after);
    EXPECT_EQ(before.sa_handler, after.sa_handler);
}

TEST(Interrupt, AnInnerHandlerLeavesTheOuterOneInPlace) {
    const InterruptHandler outer;
    { const InterruptHandler inner; }
    raise(SIGINT);
    EXPECT_TRUE(interrupt_requested());
}

TEST(InterruptDeathTest, TheSecondSignalEndsTheProgram) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(
        {
            const InterruptHandler handler;
            raise(SIGINT);
            raise(SIGINT);
            exit(0);
        },
        testing::KilledBySignal(SIGINT), "");
}

TEST(DurationText, GrowsFromSecondsToHours) {
    EXPECT_EQ(duration_text(0), "0.0 s");
    EXPECT_EQ(duration_text(3.21), "3.2 s");
    EXPECT_EQ(duration_text(59.96), "1:00");
    EXPECT_EQ(duration_text(65), "1:05");
    EXPECT_EQ(duration_text(7384), "2:03:04");
    EXPECT_EQ(duration_text(std::numeric_limits<double>::infinity()), "very long");
    EXPECT_EQ(duration_text(std::numeric_limits<double>::quiet_NaN()), "very long");
}

TEST(ProgressLine, ExtrapolatesTheTimeLeft) {
    EXPECT_EQ(progress_line("render", 0.5, 65, 57),
              "render  [#####-----]  50 %  1:05 elapsed, 1:05 left");
    EXPECT_THAT(progress_line("render", 0.25, 1, 60),
                testing::EndsWith(" 25 %  1.0 s elapsed, 3.0 s left"));
    EXPECT_EQ(progress_line("render", 1, 65, 57), "render  [##########] 100 %  1:05 elapsed");
}

TEST(ProgressLine, FitsTheTerminalWhateverItIsGiven) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (double fraction : {-1.0, 0.0, 0.3, 0.999, 1.0, 7.0, nan}) {
        for (int columns : {0, 1, 10, 40, 79, 300}) {
            const auto line = progress_line("a rather long label", fraction, 1e9, columns);
            EXPECT_LE(line.size(), static_cast<std::size_t>(columns));
        }
    }
    EXPECT_NE(progress_line("x", 0.9999, 1, 79).find(" 99 %"), std::string::npos);
}

TEST(ProgressBar, StopsTheWorkOnAnInterruptEvenWhenQuiet) {
    const InterruptHandler handler;
    ProgressBar bar("work", true);
    const Progress progress = bar.callback();
    EXPECT_TRUE(progress(0.1));
    raise(SIGINT);
    EXPECT_FALSE(progress(0.2));
}

TEST(ProgressBar, IsSilentWhenStderrIsNoTerminal) {
    testing::internal::CaptureStderr();
    {
        ProgressBar bar("work");
        bar.callback()(0.5);
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(SharedProgress, TellsFromOneThreadAtATimeWhatAllHaveDone) {
    int calls = 0;  // no lock of its own
    double last = 0;
    const Progress progress = [&](double fraction) {
        ++calls;
        EXPECT_GE(fraction, last);
        last = fraction;
        return true;
    };
    SharedProgress work(progress, 2000);
    parallel_for(0, 1000, [&](std::size_t) {
        work.add(2);
        work.keep_going();
    });
    EXPECT_GE(calls, 1000);
    EXPECT_EQ(last, 1.0);
    EXPECT_FALSE(work.stopped());
    EXPECT_NO_THROW(work.throw_if_stopped("counting"));
}

TEST(SharedProgress, RemembersThatItWasAskedToStop) {
    int calls = 0;
    const Progress progress = [&](double) { return ++calls < 3; };
    SharedProgress work(progress, 10);
    for (int i = 0; i < 10; ++i) work.add();
    EXPECT_EQ(calls, 3);  // nobody is asked again
    EXPECT_TRUE(work.stopped());
    EXPECT_FALSE(work.keep_going());
    try {
        work.throw_if_stopped("counting");
        FAIL() << "went on";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "counting was stopped");
    }
}

// As where a fit solves paints: the solver's counter asks the fit's.
TEST(SharedProgress, AsksThroughAnother) {
    int calls = 0;
    const Progress progress = [&](double) { return ++calls < 1; };
    SharedProgress outer(progress, 1);
    const Progress asks_outer = [&](double) { return outer.keep_going(); };
    SharedProgress inner(asks_outer, 1);
    std::thread([&] { EXPECT_FALSE(inner.keep_going()); }).join();  // which has asked nobody lately
    EXPECT_EQ(calls, 1);
}

TEST(SharedProgress, NeedsNobodyToTell) {
    const Progress nobody;
    SharedProgress work(nobody, 1);
    work.add();
    EXPECT_TRUE(work.keep_going());
}

}  // namespace
}  // namespace nacre
