#include "nacre/optics/complex_lanes.h"

#include <gtest/gtest.h>

namespace nacre::optics {
namespace {

TEST(ComplexLanes, ExponentialMatchesLongDouble) {
    for (int i = 0; i < 20000; ++i) {
        const double x = -700.0 * i / 20000 - 1e-3 * i;
        const DoubleLanes found = exp_lanes(nacre::splat(x));
        const double expected = x < -708 ? 0.0 : static_cast<double>(std::exp((long double)x));
        EXPECT_NEAR(found[0], expected, kExpLanesRelativeError * expected) << x;
    }
    EXPECT_EQ(exp_lanes(nacre::splat(-0.0))[3], 1);
    EXPECT_EQ(exp_lanes(nacre::splat(-1e300))[3], 0);
}

TEST(ComplexLanes, SineAndCosineMatchLongDouble) {
    for (int i = -20000; i <= 20000; ++i) {
        const double x = i % 2 == 0 ? i * 5.0 : i * 1e-3;
        const ComplexLanes found = cis_lanes(nacre::splat(x));
        EXPECT_NEAR(found.re[0], static_cast<double>(std::cos((long double)x)), kSinCosLanesError)
            << x;
        EXPECT_NEAR(found.im[0], static_cast<double>(std::sin((long double)x)), kSinCosLanesError)
            << x;
    }
}

TEST(ComplexLanes, ArithmeticIsThatOfStdComplex) {
    const std::complex<double> a(1.5, -2), b(.3, .7);
    const ComplexLanes x = splat(a), y = splat(b);
    const std::pair<ComplexLanes, std::complex<double>> pairs[] = {
        {x + y, a + b},
        {x - y, a - b},
        {x * y, a * b},
        {x / y, a / b},
        {-x, -a},
        {conj(x), std::conj(a)},
        {exp_i(y), std::exp(std::complex<double>(0, 1) * b)}};
    for (const auto& [found, expected] : pairs) {
        EXPECT_NEAR(found.re[5], expected.real(), 4e-15);
        EXPECT_NEAR(found.im[5], expected.imag(), 4e-15);
    }
    EXPECT_NEAR(norm(x)[0], std::norm(a), 1e-15);
}

}  // namespace
}  // namespace nacre::optics
