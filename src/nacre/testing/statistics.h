#pragma once

#include <cmath>

// Only for tests: how far a random number may be from what is expected.

namespace nacre::test {

/// How many standard errors a right result may be off: one in 30000 normal values lies beyond.
/// Seeds are fixed, so that a test that passes once passes always; the bound says how likely a
/// right result was to be refused. An error of five standard errors is seen four times in five.
inline constexpr double kWorstZ = 4.2;

/// Sums of what is drawn, for its mean and the standard error of that.
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

}  // namespace nacre::test
