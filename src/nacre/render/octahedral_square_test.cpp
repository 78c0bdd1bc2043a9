#include "nacre/render/octahedral_square.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "nacre/core/rng.h"

namespace nacre::render {
namespace {

Vec3f uniform_direction(Rng& rng) {
    const float z = 1 - 2 * rng.uniform_float();
    const float r = std::sqrt(std::max(0.0f, 1 - z * z));
    const float phi = 2 * std::numbers::pi_v<float> * rng.uniform_float();
    return {r * std::cos(phi), r * std::sin(phi), z};
}

TEST(OctahedralSquare, EqualAreasFillEqualAreas) {
    // Chi-square over 64 cells of 64 000 directions: the 99.9 % quantile for 63 degrees of freedom
    // is 103.4.
    constexpr int kSide = 8, kCount = 64000;
    std::vector<int> counts(kSide * kSide);
    Rng rng(7, 1);
    for (int i = 0; i < kCount; ++i) {
        const auto [u, v] = octahedral_square(uniform_direction(rng));
        ASSERT_GE(u, 0);
        ASSERT_LE(u, 1);
        ASSERT_GE(v, 0);
        ASSERT_LE(v, 1);
        const int c = std::min(static_cast<int>(u * kSide), kSide - 1);
        const int r = std::min(static_cast<int>(v * kSide), kSide - 1);
        ++counts[r * kSide + c];
    }
    const double expected = static_cast<double>(kCount) / counts.size();
    double chi2 = 0;
    for (int count : counts) chi2 += (count - expected) * (count - expected) / expected;
    EXPECT_LT(chi2, 103.4);
}

TEST(OctahedralSquare, IsContinuousOnTheUpperHalfAndAcrossTheEquator) {
    Rng rng(7, 2);
    constexpr float kStep = 1e-3f;
    for (int i = 0; i < 2000; ++i) {
        Vec3f n = uniform_direction(rng);
        if (n.z < -0.1f) n.z = -n.z;
        const auto p = octahedral_square(n);
        const auto q = octahedral_square(normalize(n + kStep * uniform_direction(rng)));
        // Areas are kept, lengths are stretched by less than 2.
        EXPECT_LT(std::hypot(p[0] - q[0], p[1] - q[1]), 2 * kStep)
            << n.x << ' ' << n.y << ' ' << n.z;
    }
}

TEST(OctahedralSquare, PolesAndAxesLieWhereTheyShould) {
    EXPECT_EQ(octahedral_square({0, 0, 1}), (std::array{0.5, 0.5}));
    EXPECT_EQ(octahedral_square({1, 0, 0}), (std::array{1.0, 0.5}));
    EXPECT_EQ(octahedral_square({0, -1, 0}), (std::array{0.5, 0.0}));
    EXPECT_EQ(octahedral_square({0, 0, -1}), (std::array{1.0, 1.0}));
}

}  // namespace
}  // namespace nacre::render
