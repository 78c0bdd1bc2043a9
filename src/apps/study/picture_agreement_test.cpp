#include "apps/study/picture_agreement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/core/random.h"

namespace nacre::study {
namespace {

double normal(Rng& rng) {
    const double u = 1 - rng.uniform_float();
    return std::sqrt(-2 * std::log(u)) * std::cos(2 * std::numbers::pi * rng.uniform_float());
}

/// Gray batches of the given means with normal noise; the first rows have none.
std::vector<io::Image> batches(int count, double mean, double sigma, std::uint64_t stream) {
    constexpr int kSide = 64, kQuiet = kSide * kSide / 2;
    Rng rng(5, stream);
    std::vector<io::Image> out(count);
    for (io::Image& image : out) {
        image.width = image.height = kSide;
        std::vector<float> y(kSide * kSide);
        for (int i = 0; i < kSide * kSide; ++i) {
            y[i] = static_cast<float>(i < kQuiet ? 0.25 : mean + sigma * normal(rng));
        }
        for (const char* name : {"R", "G", "B"}) image.channels.push_back({name, y});
    }
    return out;
}

TEST(PictureAgreement, EqualMeansGiveStudentsDistribution) {
    const auto result = picture_agreement(batches(16, 1, 0.1, 1), batches(16, 1, 0.1, 2));
    EXPECT_EQ(result.pixels, 64 * 32);
    // The same noise in both: 30 degrees of freedom, mean z^2 = 30 / 28 with standard error
    // sqrt(2 / 2048) = 0.03.
    EXPECT_NEAR(result.mean_square_z, 30.0 / 28, 4 * 0.035);
    EXPECT_LT(result.mean_square_z, result.expected_mean_square_z + 0.1);
    EXPECT_LT(result.fraction_above_3, result.expected_fraction_above_3);
    EXPECT_LT(std::abs(result.relative_difference), 4 * result.relative_standard_error);
}

TEST(PictureAgreement, SeesADifferenceOfOneStandardErrorInEachPixel) {
    const double error = 0.1 * std::sqrt(2.0 / 16);
    const auto result = picture_agreement(batches(16, 1 + error, 0.1, 3), batches(16, 1, 0.1, 4));
    EXPECT_GT(result.mean_square_z, 1.8);  // 1 + 1, less the noise of 2048 pixels
    EXPECT_GT(result.relative_difference, 4 * result.relative_standard_error);
}

TEST(PictureAgreement, ExpectationsAreThoseOfStudentsDistribution) {
    // SciPy 1.17: 2 * scipy.stats.t.sf(3, 15) = 0.008972737
    const auto result = picture_agreement(batches(16, 1, 0.1, 1), batches(16, 1, 0.1, 2));
    EXPECT_NEAR(result.expected_fraction_above_3, 0.008972737, 1e-7);
    EXPECT_DOUBLE_EQ(result.expected_mean_square_z, 15.0 / 13);
}

TEST(PictureAgreement, RefusesBatchesThatDoNotMatch) {
    EXPECT_THROW(picture_agreement(batches(3, 1, 1, 1), batches(3, 1, 1, 2)), DomainError);
    EXPECT_THROW(picture_agreement(batches(4, 1, 1, 1), batches(5, 1, 1, 2)), DomainError);
}

}  // namespace
}  // namespace nacre::study
