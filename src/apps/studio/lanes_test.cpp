#include "apps/studio/lanes.h"

#include <gtest/gtest.h>

#include <latch>
#include <semaphore>

#include "apps/studio/outbox.h"

namespace nacre::studio {
namespace {

using std::chrono::hours;
using Seconds = std::chrono::seconds;

/// A job that waits until it is released or told to stop.
struct Held {
    std::binary_semaphore begun{0}, release{0};
    std::atomic<bool> stopped = false;

    Lane::Job job(const std::string& kind) {
        return {kind, [this](const Progress& progress) {
                    begun.release();
                    while (!release.try_acquire_for(std::chrono::milliseconds(1))) {
                        if (!progress(0)) {
                            stopped = true;
                            return;
                        }
                    }
                }};
    }
};

TEST(StudioLane, OfJobsThatWaitTheNewestOfAKindRuns) {
    std::vector<int> ran;
    std::latch all(2);
    Held held;
    Lane lane({.at_least = hours(1)});
    lane.post(1, held.job("paint"));
    held.begun.acquire();
    for (int i = 0; i < 100; ++i) {
        lane.post(1, {"paint", [&, i](const Progress&) {
                          ran.push_back(i);
                          all.count_down();
                      }});
    }
    lane.post(1, {"standard", [&](const Progress&) {
                      ran.push_back(1000);
                      all.count_down();
                  }});
    held.release.release();
    all.wait();
    EXPECT_EQ(ran, (std::vector{99, 1000}));
    EXPECT_FALSE(held.stopped);
}

TEST(StudioLane, PagesTakeTurns) {
    std::vector<int> ran;
    std::latch all(4);
    Held held;
    Lane lane({});
    lane.post(1, held.job("first"));
    held.begun.acquire();
    const auto note = [&](int what) {
        return [&, what](const Progress&) {
            ran.push_back(what);
            all.count_down();
        };
    };
    lane.post(1, {"a", note(11)});
    lane.post(1, {"b", note(12)});
    lane.post(2, {"a", note(21)});
    lane.post(3, {"a", note(31)});
    held.release.release();
    all.wait();
    EXPECT_EQ(ran, (std::vector{11, 21, 31, 12}));
}

TEST(StudioLane, ARunningJobIsStoppedForANewerOfItsKindOnly) {
    Held first, second;
    Lane lane({});
    lane.post(1, first.job("fit"));
    first.begun.acquire();
    lane.post(2, second.job("fit"));
    lane.post(1, {"other", [](const Progress&) {}});
    EXPECT_FALSE(first.stopped);
    Held newer;
    lane.post(1, newer.job("fit"));
    second.begun.acquire();  // the first has ended
    EXPECT_TRUE(first.stopped);
    second.release.release();
    newer.begun.acquire();
    newer.release.release();
}

TEST(StudioLane, ASliderThatNeverRestsIsAnswered) {
    Held first;
    Lane lane({.at_least = Seconds(0), .longest_silence = Seconds(0)});  // any silence is too long
    lane.post(1, first.job("paint"));
    first.begun.acquire();
    std::binary_semaphore done{0};
    lane.post(1, {"paint", [&](const Progress&) { done.release(); }});
    first.release.release();
    done.acquire();
    EXPECT_FALSE(first.stopped);
}

TEST(StudioLane, StopsAndForgetsOnDemandAndAtItsEnd) {
    Held first, last;
    Lane lane({});
    lane.post(1, first.job("fit"));
    first.begun.acquire();
    bool ran = false;
    lane.post(1, {"render", [&](const Progress&) { ran = true; }});
    EXPECT_EQ(lane.stop(1, "render"), 1u);
    EXPECT_EQ(lane.stop(1), 1u);
    EXPECT_EQ(lane.stop(1), 0u);
    lane.post(2, last.job("fit"));
    last.begun.acquire();
    EXPECT_TRUE(first.stopped);
    lane.end();
    EXPECT_TRUE(last.stopped);
    EXPECT_FALSE(ran);
}

TEST(StudioOutbox, KeepsTheNewestAnswerOfEachKind) {
    Outbox outbox;
    for (int i = 0; i < 1000; ++i) {
        outbox.add({"picture", {{std::to_string(i), {}}}});
        outbox.add({"paint", {{std::to_string(i), {}}}});
        EXPECT_LE(outbox.size(), 2u);
    }
    EXPECT_EQ(outbox.take()->frames[0].text, "999");
    EXPECT_EQ(outbox.take()->kind, "paint");
    EXPECT_FALSE(outbox.take());
}

TEST(StudioOutbox, SendsAProgramOnceThoughAnswersWithItAreReplaced) {
    Outbox outbox;
    const auto answer = [](const std::string& text) {
        return Answer{"paint", {{text, {}, "hash", text + " with program"}}};
    };
    outbox.add(answer("first"));
    outbox.add(answer("second"));
    EXPECT_EQ(outbox.take()->frames[0].text, "second with program");
    outbox.add(answer("third"));
    EXPECT_EQ(outbox.take()->frames[0].text, "third");
}

}  // namespace
}  // namespace nacre::studio
