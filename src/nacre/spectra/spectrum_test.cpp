#include "nacre/spectra/spectrum.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "nacre/core/error.h"

namespace nacre::spectra {
namespace {

TEST(Spectrum, IsLinearBetweenSamplesAndConstantBeyond) {
    const Spectrum s({400, 500, 700}, {1, 3, -1});
    EXPECT_EQ(s(100), 1);
    EXPECT_EQ(s(400), 1);
    EXPECT_DOUBLE_EQ(s(450), 2);
    EXPECT_EQ(s(500), 3);
    EXPECT_DOUBLE_EQ(s(600), 1);
    EXPECT_EQ(s(700), -1);
    EXPECT_EQ(s(std::numeric_limits<double>::infinity()), -1);
    EXPECT_EQ(s.min(), -1);
    EXPECT_EQ(s.max(), 3);
    EXPECT_FALSE(s.is_constant());
}

TEST(Spectrum, ANumberIsASpectrum) {
    const Spectrum s = 0.25;
    EXPECT_TRUE(s.is_constant());
    EXPECT_EQ(s(123), 0.25);
    EXPECT_EQ(s, Spectrum(0.25));
    EXPECT_NE(s, Spectrum(0.5));
    EXPECT_TRUE(std::isnan(s(std::nan(""))));
}

TEST(Spectrum, RefusesWhatIsNotAFunction) {
    const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
    EXPECT_THROW(Spectrum({}, {}), DomainError);
    EXPECT_THROW(Spectrum({400, 500}, {1}), DomainError);
    EXPECT_THROW(Spectrum({500, 400}, {1, 1}), DomainError);
    EXPECT_THROW(Spectrum({400, 400}, {1, 1}), DomainError);
    EXPECT_THROW(Spectrum({400, nan}, {1, 1}), DomainError);
    EXPECT_THROW(Spectrum({400, 500}, {1, inf}), DomainError);
    EXPECT_THROW(Spectrum{nan}, DomainError);
}

}  // namespace
}  // namespace nacre::spectra
