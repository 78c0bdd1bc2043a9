#include "nacre/core/reproducible_sum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "nacre/core/random.h"

namespace nacre {
namespace {

/// Numbers of either sign over 24 decades.
std::vector<float> numbers() {
    std::vector<float> all;
    for (std::uint64_t i = 0; i < 10'000; ++i) {
        const double exponent = 24 * to_unit_double(mix_bits(2 * i)) - 12;
        const double sign = mix_bits(2 * i + 1) & 1 ? 1 : -1;
        all.push_back(static_cast<float>(sign * std::pow(10, exponent)));
    }
    return all;
}

template <class Sum>
Sum sum_of(const std::vector<float>& values) {
    Sum sum;
    for (const float value : values) sum.add(value);
    return sum;
}

TEST(ReproducibleSum, DependsNeitherOnOrderNorOnGroups) {
    std::vector<float> values = numbers();
    const LightSum whole = sum_of<LightSum>(values);
    std::sort(values.begin(), values.end());
    EXPECT_EQ(sum_of<LightSum>(values), whole);
    // Of doubles, as a reason for all this.
    double up = 0, down = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        up += values[i];
        down += values[values.size() - 1 - i];
    }
    EXPECT_NE(up, down);
    for (const std::size_t groups : {2u, 3u, 97u}) {
        LightSum sum;
        for (std::size_t g = groups; g-- > 0;) {
            LightSum part;
            for (std::size_t i = g; i < values.size(); i += groups) part.add(values[i]);
            sum.add(part);
        }
        EXPECT_EQ(sum, whole) << groups;
    }
}

TEST(ReproducibleSum, IsExactWhereTheStepIsFineEnough) {
    LightSum sum;
    double expected = 0;
    for (const float value : numbers()) {
        // A float has 24 bits, and 45 hold all these and their sum.
        if (std::abs(value) < 0x1p-8f || std::abs(value) > 0x1p8f) continue;
        sum.add(value);
        expected += value;
    }
    EXPECT_NE(expected, 0);
    EXPECT_EQ(sum.value(), expected);
    LightSum small;
    small.add(0x1.8p-48f);
    small.add(-0x1.8p-48f);
    EXPECT_EQ(small.value(), 0) << "rounded towards 0 on both sides";
}

TEST(ReproducibleSum, HoldsTheLargestAndTheMost) {
    LightSum light;
    const float largest = std::nextafter(0x1p55f, 0.0f);
    for (int i = 0; i < 1 << 24; ++i) light.add(largest);
    EXPECT_EQ(light.value(), static_cast<double>(largest) * (1 << 24));
    UnitSum units;
    for (int i = 0; i < 1 << 24; ++i) units.add(-1);
    EXPECT_EQ(units.value(), -(1 << 24));
}

}  // namespace
}  // namespace nacre
