#include "apps/study/equal_time.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "nacre/core/error.h"

namespace nacre::study {
namespace {

io::Image gray(std::vector<float> pixels) {
    io::Image image;
    image.width = static_cast<int>(pixels.size());
    image.height = 1;
    for (const char* name : {"R", "G", "B"}) image.channels.push_back({name, pixels});
    return image;
}

TEST(EqualTime, ErrorsAreTheirDefinitions) {
    const io::Image picture = gray({0.5f, 0.04f}), converged = gray({0.99f, 0.0f});
    // ((0.5 - 0.99) / 1)^2 and (0.04 / 0.01)^2; their mean, to the rounding of floats.
    EXPECT_NEAR(relative_square_error(picture, converged), (0.2401 + 16) / 2, 1e-5);
    EXPECT_NEAR(square_error_over_square_mean(picture, converged),
                0.5 * (0.2401 + 0.0016) / (0.495 * 0.495), 1e-6);
    EXPECT_EQ(relative_square_error(converged, converged), 0);
}

TEST(EqualTime, RefusesPicturesThatCannotBeCompared) {
    const io::Image one = gray({1}), two = gray({1, 1});
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(relative_square_error(one, two), InputError);
    EXPECT_THROW(relative_square_error(gray({nan}), one), InputError);
    EXPECT_THROW(square_error_over_square_mean(one, gray({0})), InputError);
}

/// error = factor / time^power, at 4^i seconds.
ErrorCurve power_law(double factor, double power, double first_s) {
    ErrorCurve curve;
    for (double t = first_s; t < 300 * first_s; t *= 4) {
        curve.seconds.push_back(t);
        curve.error.push_back(factor * std::pow(t, -power));
    }
    return curve;
}

TEST(EqualTime, PowerLawsAreMetBetweenThePoints) {
    const ErrorCurve curve = power_law(3, 1.2, 0.5);
    for (double t : {0.5, 0.7, 2.0, 11.0, 128.0}) {
        EXPECT_NEAR(error_at(curve, t).value() / (3 * std::pow(t, -1.2)), 1, 1e-12) << t;
    }
    EXPECT_FALSE(error_at(curve, 0.49));
    EXPECT_FALSE(error_at(curve, 129));
    EXPECT_FALSE(error_at({}, 1));
}

TEST(EqualTime, TimeToAnErrorIsTheInverseOfErrorAtATime) {
    const ErrorCurve curve = power_law(3, 1.2, 0.5);
    for (double t : {0.7, 2.0, 11.0, 127.0}) {
        EXPECT_NEAR(seconds_at(curve, 3 * std::pow(t, -1.2)).value() / t, 1, 1e-9) << t;
    }
    EXPECT_EQ(seconds_at(curve, curve.error.front()), curve.seconds.front());
    EXPECT_NEAR(seconds_at(curve, curve.error.back()).value(), curve.seconds.back(), 1e-9);
    EXPECT_FALSE(seconds_at(curve, 3 * std::pow(0.49, -1.2)));
    EXPECT_FALSE(seconds_at(curve, 3 * std::pow(129, -1.2)));
    EXPECT_FALSE(seconds_at({}, 1));
}

TEST(EqualTime, RatioIsThatOfTwoPowerLawsWhereverTheirTimesBegin) {
    for (double first_s : {0.01, 1.0, 7.0, 100.0}) {
        EXPECT_NEAR(equal_time_ratio(power_law(50, 1, 1), power_law(2, 1, first_s)).value(), 25,
                    1e-9);
    }
    EXPECT_FALSE(equal_time_ratio(power_law(50, 1, 1), power_law(2, 1, 1000)));
    EXPECT_FALSE(equal_time_ratio({}, power_law(2, 1, 1)));
}

TEST(EqualTime, RatioIsTheInverseOfTheOtherWayRound) {
    const ErrorCurve a = power_law(50, 0.8, 0.3), b = power_law(2, 1.1, 1);
    EXPECT_NEAR(*equal_time_ratio(a, b) * *equal_time_ratio(b, a), 1, 1e-12);
}

}  // namespace
}  // namespace nacre::study
