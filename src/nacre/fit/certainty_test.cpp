#include "nacre/fit/certainty.h"

#include <gtest/gtest.h>

#include <cmath>

#include "nacre/core/error.h"

namespace nacre::fit {
namespace {

// r = J x + noise with J = [1 0; 0 2; 1 1]: (J^T J)^-1 = [5 -1; -1 2] / 9, by hand.
TEST(Certainty, IsTheCovarianceOfLinearLeastSquares) {
    const std::vector<double> jacobian = {1, 0, 0, 2, 1, 1}, residuals = {0.03, 0, 0.04};
    const Certainty c = certainty(residuals, jacobian, 2, {std::nullopt, 3, 1, 0.01});
    EXPECT_EQ(c.degrees_of_freedom, 1);
    ASSERT_TRUE(c.noise_delta_e);
    EXPECT_NEAR(*c.noise_delta_e, 0.05, 1e-15);  // sqrt(0.03^2 + 0.04^2) over sqrt(1)
    ASSERT_TRUE(c.standard_error[0] && c.standard_error[1]);
    EXPECT_NEAR(*c.standard_error[0], 0.05 * std::sqrt(5.0 / 9), 1e-12);
    EXPECT_NEAR(*c.standard_error[1], 0.05 * std::sqrt(2.0 / 9), 1e-12);
    EXPECT_NEAR(c.correlation[1], -1 / std::sqrt(10.0), 1e-12);
    EXPECT_NEAR(c.correlation[0], 1, 1e-12);
    EXPECT_TRUE(c.weak.empty());
}

TEST(Certainty, NoiseThatIsGivenIsTaken) {
    const Certainty c =
        certainty(std::vector<double>{0.0}, std::vector<double>{2.0}, 1, {0.1, 1, 1, 0.01});
    EXPECT_EQ(c.degrees_of_freedom, 0);
    EXPECT_NEAR(c.standard_error[0].value(), 0.05, 1e-12);
}

TEST(Certainty, WithoutDegreesOfFreedomTheNoiseIsUnknown) {
    const Certainty c = certainty(std::vector<double>{0.0}, std::vector<double>{2.0}, 1,
                                  {std::nullopt, 1, 1, 0.01});
    EXPECT_FALSE(c.noise_delta_e);
    EXPECT_FALSE(c.standard_error[0]);
}

// The second and third number act alike: their difference is not determined, however small the
// noise. The first is.
TEST(Certainty, NamesFlatDirections) {
    const std::vector<double> jacobian = {10, 0, 0, 0, 10, 10, 0, 10, 10};
    const Certainty c = certainty(std::vector<double>(3, 1e-9), jacobian, 3, {1e-6, 3, 1, 0.3});
    EXPECT_TRUE(c.standard_error[0]);
    EXPECT_FALSE(c.standard_error[1]);
    EXPECT_FALSE(c.standard_error[2]);
    ASSERT_EQ(c.weak.size(), 1u);
    const std::vector<double>& step = c.weak[0].step;
    EXPECT_NEAR(step[0], 0, 1e-9);
    EXPECT_NEAR(step[1], -step[2], 1e-9);
    EXPECT_NEAR(std::hypot(step[1], step[2]), 1, 1e-9);  // all of the cube's width
}

// Errors above the standard deviation of the uniform law between the bounds are not reported.
TEST(Certainty, ErrorsAsWideAsTheBoundsAreNotReported) {
    const auto error = [](double noise) {
        return certainty(std::vector<double>{0, 0}, std::vector<double>{1, 0}, 1,
                         {noise, 2, 1, 0.01})
            .standard_error[0];
    };
    EXPECT_TRUE(error(0.28));
    EXPECT_FALSE(error(0.29));  // 1/sqrt(12) = 0.2887
}

TEST(Certainty, RefusesSizesThatDoNotFit) {
    EXPECT_THROW(certainty(std::vector<double>(3), std::vector<double>(5), 2, {}), DomainError);
    EXPECT_THROW(certainty(std::vector<double>(3), std::vector<double>{}, 0, {}), DomainError);
}

}  // namespace
}  // namespace nacre::fit
