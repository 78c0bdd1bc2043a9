#pragma once

#include <cmath>
#include <vector>

// Only for tests: deviations from what is expected, and bounds for those of random estimates.

namespace nacre::test {

/// The larger of two deviations, NaN if one of them is. Of a NaN std::max() would keep the other, and a
/// bound for the worst deviation would hold.
template <class T>
T worse(T worst, T value) {
    return std::isnan(worst) || value <= worst ? worst : value;
}

/// Bound for the error of a right result, in standard errors: one in 30000 normal values lies
/// beyond. Seeds are fixed, so that a test that passes once passes always; the bound says how
/// likely a right result was to be refused. A bias of five standard errors is detected four times
/// in five.
inline constexpr double kWorstZ = 4.2;

/// Sums over random values, for their mean and its standard error.
class Sample {
 public:
    void add(double value) {
        ++count_;
        sum_ += value;
        squares_ += value * value;
    }
    double mean() const { return sum_ / count_; }
    double error() const {
        return std::sqrt(std::fmax(0, squares_ / count_ - mean() * mean()) / count_);
    }

 private:
    double count_ = 0, sum_ = 0, squares_ = 0;
};

/// Mean and variance of independent random values, with their standard errors.
struct Moments {
    double mean = 0, variance = 0, mean_error = 0, variance_error = 0;

    explicit Moments(const std::vector<double>& values) {
        const double count = static_cast<double>(values.size());
        for (double v : values) mean += v / count;
        double fourth = 0;
        for (double v : values) {
            const double d2 = (v - mean) * (v - mean);
            variance += d2 / count;
            fourth += d2 * d2 / count;
        }
        mean_error = std::sqrt(variance / count);
        variance_error = std::sqrt((fourth - variance * variance) / count);
    }
};

}  // namespace nacre::test
