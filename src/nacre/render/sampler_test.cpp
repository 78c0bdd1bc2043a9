#include "nacre/render/sampler.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <vector>

namespace nacre::render {
namespace {

// The (0,2) property, base 2: of the first 2^m points each elementary interval of area 2^-m, of
// whatever shape 2^-a x 2^-(m-a), holds exactly one.
//                                                               [niederreiter-1992, definition 4.1]
TEST(PathSampler, EveryPlaceIsAZeroTwoSequence) {
    constexpr int kLog = 8;
    int checked = 0;
    for (std::uint32_t vertex : {0u, 1u, 5u}) {
        for (int pair : {0, 1, 3}) {
            for (int a = 0; a <= kLog; ++a) {
                std::set<int> cells;
                for (std::uint32_t i = 0; i < (1u << kLog); ++i) {
                    const auto u = PathSampler(7, 1234, i).draw(vertex);
                    const int x = static_cast<int>(u[2 * pair] * (1 << a));
                    const int y = static_cast<int>(u[2 * pair + 1] * (1 << (kLog - a)));
                    cells.insert((x << (kLog - a)) | y);
                }
                EXPECT_EQ(cells.size(), 1u << kLog) << "vertex " << vertex << " pair " << pair;
                ++checked;
            }
        }
    }
    EXPECT_EQ(checked, 3 * 3 * (kLog + 1));
}

// Candidates: four to a sample are the points of four times as many samples.
TEST(PathSampler, EightPathsAtOnceAreThoseOfALongerSequence) {
    for (std::uint32_t sample : {0u, 5u, 1000u, 0x12345678u}) {
        const PathSampler::Threes eight = PathSampler(7, 1234, sample).draw_refined(3);
        for (int k = 0; k < kLanes; ++k) {
            const auto one = PathSampler(7, 1234, kLanes * sample + k).draw(3);
            EXPECT_EQ(eight.x[k], one[0]);
            EXPECT_EQ(eight.y[k], one[1]);
            EXPECT_EQ(eight.choice[k], one[4]);
        }
    }
}

// A place and its choice together are a (1,3)-sequence: each box of volume 2^-(m-1) holds two of the
// first 2^m points.                            [niederreiter-1992, definition 4.1; joe-kuo-2008]
TEST(PathSampler, EveryChoiceIsSpreadWithItsPlace) {
    constexpr int kLog = 8;
    constexpr int kThrees[][3] = {{0, 1, 4}, {2, 3, 5}};
    int checked = 0;
    for (std::uint32_t vertex : {0u, 1u, 5u}) {
        for (const auto& three : kThrees) {
            for (int a = 0; a < kLog; ++a) {
                for (int b = 0; a + b < kLog; ++b) {
                    const int c = kLog - 1 - a - b;
                    std::map<int, int> points;
                    for (std::uint32_t i = 0; i < (1u << kLog); ++i) {
                        const auto u = PathSampler(7, 1234, i).draw(vertex);
                        const auto at = [&](int d, int log) {
                            return static_cast<int>(u[three[d]] * static_cast<float>(1 << log));
                        };
                        ++points[((at(0, a) << b) + at(1, b)) << c | at(2, c)];
                    }
                    for (const auto& [box, count] : points) EXPECT_EQ(count, 2) << box;
                    EXPECT_EQ(points.size(), 1u << (kLog - 1));
                    ++checked;
                }
            }
        }
    }
    EXPECT_EQ(checked, 3 * 2 * kLog * (kLog + 1) / 2);
}

TEST(PathSampler, NumbersLieInTheHalfOpenUnitInterval) {
    for (std::uint32_t i = 0; i < 4096; ++i) {
        for (float u : PathSampler(i, i * 77, i * 1000003).draw(i % 11)) {
            EXPECT_GE(u, 0.0f);
            EXPECT_LT(u, 1.0f);
        }
    }
}

// Correlation between any two numbers of a path, and between neighbouring pixels, seeds and
// vertices, over 2^14 points. Independent pairs give a standard deviation of 2^-7 at most; 5 of
// them for 28 + 3 x 8 pairs is far beyond chance, and the seeds are fixed.
TEST(PathSampler, PairsPixelsVerticesAndSeedsAreUncorrelated) {
    constexpr std::uint32_t kCount = 1 << 14;
    std::vector<std::array<float, 8>> base(kCount), pixel(kCount), vertex(kCount), seed(kCount);
    for (std::uint32_t i = 0; i < kCount; ++i) {
        base[i] = PathSampler(1, 10, i).draw(1);
        pixel[i] = PathSampler(1, 11, i).draw(1);
        vertex[i] = PathSampler(1, 10, i).draw(2);
        seed[i] = PathSampler(2, 10, i).draw(1);
    }
    const auto correlation = [&](const auto& a, int da, const auto& b, int db) {
        double sum = 0;
        for (std::uint32_t i = 0; i < kCount; ++i) sum += (a[i][da] - 0.5) * (b[i][db] - 0.5);
        return 12 * sum / kCount;
    };
    const double bound = 5 / std::sqrt(double{kCount});
    for (int a = 0; a < 8; ++a) {
        for (int b = 0; b < a; ++b) EXPECT_LT(std::abs(correlation(base, a, base, b)), bound);
        EXPECT_LT(std::abs(correlation(base, a, pixel, a)), bound);
        EXPECT_LT(std::abs(correlation(base, a, vertex, a)), bound);
        EXPECT_LT(std::abs(correlation(base, a, seed, a)), bound);
    }
}

}  // namespace
}  // namespace nacre::render
