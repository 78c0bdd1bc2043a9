#include "nacre/measure/tolerance.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "nacre/core/error.h"
#include "nacre/spectra/lab.h"

namespace nacre::measure {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

Measurement colours(double shift) {
    Measurement m{"colours", {}, {}, {}};
    for (double aspecular : {15.0, 45.0, 110.0}) {
        Reading reading;
        reading.geometry = in_plane(45, aspecular);
        reading.lab = {100 - aspecular / 2, 10 + shift, -20 + 2 * shift};
        m.readings.push_back(reading);
    }
    return m;
}

TEST(Tolerance, FormulasAreNamedAndReadBack) {
    for (const char* name : {"cielab", "cie2000", "cmc2:1", "cmc1:1", "cmc1.5:1"}) {
        EXPECT_EQ(parse_formula(name).name(), name);
    }
    EXPECT_EQ(parse_formula(" CMC ").name(), "cmc2:1");
    for (const char* wrong : {"", "cie94", "cmc2", "cmc0:1", "cmc2:1:1", "cmc2:x"}) {
        EXPECT_THAT([&] { parse_formula(wrong); },
                    ThrowsMessage<DomainError>(HasSubstr("must be cielab, cie2000, cmc")))
            << wrong;
    }
}

TEST(Tolerance, FormulasAreThoseOfTheirNames) {
    const Vec3d a{50, 20, -30}, b{52, 18, -33};
    EXPECT_DOUBLE_EQ(parse_formula("cielab")(a, b), std::sqrt(4.0 + 4 + 9));
    EXPECT_EQ(parse_formula("cie2000")(a, b), spectra::delta_e_2000(a, b));
    EXPECT_EQ(parse_formula("cmc1:1")(a, b), spectra::delta_e_cmc(a, b, 1, 1));
}

TEST(Tolerance, EveryAngleMustStayWithinItsLimit) {
    const Difference d = difference(colours(0), colours(1));  // Delta E*ab = sqrt(5) = 2.236
    ASSERT_EQ(d.angles.size(), 3u);
    const DifferenceFormula cielab = parse_formula("cielab");
    EXPECT_TRUE(judge(d, {cielab, 2.3}).passes());
    EXPECT_FALSE(judge(d, {cielab, 2.2}).passes());
    const std::string name = d.angles[1].geometry.name;
    const Verdict verdict = judge(d, {cielab, 2.2, {{name, 3}}});
    EXPECT_FALSE(verdict.passes());
    EXPECT_FALSE(verdict.angles[0].passes());
    EXPECT_TRUE(verdict.angles[1].passes());
    EXPECT_EQ(verdict.angles[1].limit, 3);
    EXPECT_TRUE(judge(d, {cielab, {}, {{name, 3}}}).passes());
    EXPECT_FALSE(judge(d, {cielab, {}, {{name, 0}}}).passes());
    EXPECT_TRUE(judge(d, {cielab}).passes());
    EXPECT_TRUE(judge(difference(colours(0), colours(0)), {cielab, 0.0}).passes());
}

TEST(Tolerance, RefusesLimitsThatCannotBe) {
    const Difference d = difference(colours(0), colours(1));
    EXPECT_THAT(
        [&] {
            judge(d, {{}, -1.0});
        },
        ThrowsMessage<DomainError>(HasSubstr("tolerance = -1: must be in [0, 1000]")));
    EXPECT_THAT(
        [&] {
            judge(d, {{}, 1.0, {{"45as99", 1}}});
        },
        ThrowsMessage<DomainError>(HasSubstr("tolerance of 45as99")));
}

}  // namespace
}  // namespace nacre::measure
