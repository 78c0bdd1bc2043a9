#include "nacre/core/interrupt.h"

#include <gtest/gtest.h>
#include <signal.h>

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

}  // namespace
}  // namespace nacre
