#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <tbb/task_arena.h>

#include <functional>
#include <limits>
#include <string>

#include "nacre/core/error.h"
#include "nacre/reference/reference.h"
#include "nacre/reference/test_support.h"

// What the interface promises: order, determinism, errors, progress.

namespace nacre::reference {
namespace {

using test::brdf;
using test::kGreen;
using test::kWorstZ;
using test::worked_paint;
using test::z_score;

TEST(Reference, ManyEyesAreServedInTheirOrder) {
    // More than one walk serves: two directions in turns, so that a slip shows.
    std::vector<Direction> outgoing;
    for (int i = 0; i < 700; ++i) {
        outgoing.push_back({45, 180});
        outgoing.push_back({60, 180});
    }
    const auto found = brdf(worked_paint(), {45, 0}, outgoing, {.samples = 3000});
    ASSERT_EQ(found.size(), outgoing.size());
    EXPECT_EQ(found[0].mean, found[2].mean) << "the same walks";
    EXPECT_NE(found[0].mean, found[1398].mean) << "other walks";
    EXPECT_LT(std::abs(z_score(found[0], found[1398])), kWorstZ);
    EXPECT_LT(std::abs(z_score(found[1], found[1399])), kWorstZ);
    EXPECT_GT(found[0].mean, 1.2 * found[1].mean);
}

TEST(Reference, ThreadsDoNotChangeTheResult) {
    const auto run = [](int threads) {
        tbb::task_arena arena(threads);
        return arena.execute([] {
            return brdf(worked_paint(), {45, 0}, {{30, 180}, {45, 180}, {30, 90}},
                        {.samples = 20'001, .seed = 42});
        });
    };
    const auto one = run(1), two = run(2);
    for (std::size_t i = 0; i < one.size(); ++i) {
        EXPECT_EQ(one[i].mean, two[i].mean);
        EXPECT_EQ(one[i].standard_error, two[i].standard_error);
    }
}

TEST(Reference, SeedsAreIndependentAndTheirScatterIsTheStandardError) {
    // Sum of z^2 over 64 seeds against their common mean: chi-square with 63 degrees of freedom,
    // within four of its standard deviations, sqrt(126).
    constexpr int kSeeds = 64;
    std::vector<Estimate> found;
    double mean = 0;
    for (int seed = 0; seed < kSeeds; ++seed) {
        found.push_back(brdf(worked_paint(), {45, 0}, {{45, 180}},
                             {.samples = 2000, .seed = static_cast<std::uint64_t>(seed)})[0]);
        mean += found.back().mean / kSeeds;
    }
    double chi_square = 0;
    for (const Estimate& e : found) chi_square += std::pow(z_score(e, mean), 2);
    EXPECT_NEAR(chi_square, kSeeds - 1, 4 * std::sqrt(2.0 * (kSeeds - 1)));
}

TEST(Reference, ReportsProgressAndStopsWhenAsked) {
    double last = 0;
    reference_brdf(worked_paint(), std::vector<Direction>{{45, 0}, {10, 0}},
                   std::vector<Direction>{{45, 180}}, kGreen, {.samples = 1000},
                   [&](double fraction) {
                       EXPECT_GT(fraction, last);
                       last = fraction;
                       return true;
                   });
    EXPECT_DOUBLE_EQ(last, 1);
    int calls = 0;
    EXPECT_THROW(reference_brdf(worked_paint(), std::vector<Direction>{{45, 0}},
                                std::vector<Direction>{{45, 180}}, kGreen, {.samples = 100'000},
                                [&](double) { return ++calls < 3; }),
                 Error);
    EXPECT_EQ(calls, 3);
}

std::string message_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const DomainError& error) {
        return error.what();
    }
    return "no error";
}

TEST(Reference, RefusesArgumentsOutOfRangeByName) {
    using testing::HasSubstr;
    const auto ask = [](Direction in, Direction out, std::uint64_t samples) {
        return message_of([&] { brdf(worked_paint(), in, {out}, {.samples = samples}); });
    };
    EXPECT_THAT(ask({90, 0}, {0, 0}, 10), HasSubstr("incident direction = 90"));
    EXPECT_THAT(ask({0, 0}, {-1, 0}, 10), HasSubstr("outgoing direction = -1"));
    EXPECT_THAT(ask({0, std::numeric_limits<double>::infinity()}, {0, 0}, 10), HasSubstr("phi"));
    EXPECT_THAT(ask({0, 0}, {0, 0}, 1), HasSubstr("samples = 1"));
}

TEST(Reference, EmptyRequestsGiveEmptyAnswers) {
    EXPECT_TRUE(reference_brdf(worked_paint(), {}, {}, kGreen, {}).empty());
}

}  // namespace
}  // namespace nacre::reference
