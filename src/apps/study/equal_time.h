#pragma once

#include <optional>
#include <vector>

#include "nacre/io/image.h"

namespace nacre::study {

// How far pictures are from converged ones, by the time that they took.

/// Mean over pixels and R, G, B of ((a - b) / (|b| + 0.01))^2: relative in the light, absolute in
/// the dark, as io::ImageDifference::relative_error.
/// @throws InputError if sizes differ, colours are missing or a value is not finite
double relative_square_error(const io::Image& picture, const io::Image& converged);

/// Mean over pixels and R, G, B of (a - b)^2, over the square of the mean of b.
/// @throws InputError as relative_square_error(), or if the converged picture is black
double square_error_over_square_mean(const io::Image& picture, const io::Image& converged);

/// Errors of one way to make a picture, by growing time.
struct ErrorCurve {
    std::vector<double> seconds;  ///< growing, all above 0
    std::vector<double> error;    ///< as many, all above 0
};

/// The error at a time between the first and the last, by lines between the logarithms of both:
/// noise falls as a power of time. Empty outside.
std::optional<double> error_at(const ErrorCurve& curve, double seconds);

/// The time at which the error has fallen to this, by the same lines. Empty if it has not by the
/// last time, or had before the first.
std::optional<double> seconds_at(const ErrorCurve& curve, double error);

/// How many times the error of `a` is that of `b` at equal times: the geometric mean over the times
/// that both have, in equal steps of their logarithm. Empty if there are none.
std::optional<double> equal_time_ratio(const ErrorCurve& a, const ErrorCurve& b);

}  // namespace nacre::study
