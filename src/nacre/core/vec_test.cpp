#include "nacre/core/vec.h"

#include <gtest/gtest.h>

#include <cmath>

#include "nacre/core/random.h"

namespace nacre {
namespace {

template <class T>
Vec3<T> random_vector(Rng& rng) {
    const auto coordinate = [&] { return static_cast<T>(rng.uniform_double() - 0.5); };
    const T x = coordinate(), y = coordinate();
    return {x, y, coordinate()};
}

TEST(Vec3, NormalizedDoublesAreCorrectlyRoundedQuotients) {
    Rng rng(1);
    for (int i = 0; i < 10000; ++i) {
        // Whole numbers, whose squares are exact however the sum of them is compiled.
        const Vec3d r = 2000.0 * random_vector<double>(rng);
        const Vec3d v{std::round(r.x), std::round(r.y), std::round(r.z)};
        const double root = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
        EXPECT_EQ(normalize(v), (Vec3d{v.x / root, v.y / root, v.z / root}));
    }
}

template <class T>
void expect_unit_length(T error) {
    Rng rng(2);
    for (int i = 0; i < 10000; ++i) {
        const Vec3<T> v = random_vector<T>(rng);
        EXPECT_NEAR(length(normalize(v)), 1, error);
        EXPECT_NEAR(dot(normalize(v), v), length(v), error);
    }
}

TEST(Vec3, NormalizedHasLengthOneAndKeepsItsDirection) {
    expect_unit_length<double>(4e-16);
    expect_unit_length<float>(3e-7f);
}

TEST(Vec3, PerpendicularIsOfUnitLengthAndAtRightAngles) {
    Rng rng(3);
    for (int i = 0; i < 1000; ++i) {
        const Vec3d v = random_vector<double>(rng), p = perpendicular(v);
        EXPECT_NEAR(length(p), 1, 4e-16);
        EXPECT_NEAR(dot(p, v), 0, 2e-16);
        EXPECT_EQ(p.z, 0);
    }
    EXPECT_EQ(perpendicular(Vec3d{0, 0, 2}), (Vec3d{0, -1, 0}));
}

}  // namespace
}  // namespace nacre
