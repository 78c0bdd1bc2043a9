#pragma once

#include <cstddef>

#include "nacre/fit/uncertain_paint.h"
#include "nacre/fit/uncertain_values.h"
#include "nacre/fit/uncertainty.h"

// Uncertainty by recipes that are drawn from the laws of their numbers.

namespace nacre::fit {

/// Sums over samples of what is spread, less its value at the recipe, so that they stay small.
class SampledSums {
 public:
    explicit SampledSums(const ValueLayout& layout);

    void add(const Values& centre, const Values& values);
    /// The standard deviation of a value, from two samples or more.
    double deviation(std::size_t i) const;
    Spread spread(std::size_t reading, const Values& centre) const;

 private:
    double covariance(double sum_of_products, double sum_a, double sum_b) const {
        return (sum_of_products - sum_a * sum_b / count_) / (count_ - 1);
    }

    ValueLayout layout_;
    double count_ = 0;
    Values sum_, squares_;  // by value
    Values products_;       // by reading: L* a*, L* b*, a* b*
    Values chroma_, hue_;   // by reading: the change and its square
};

/// Of options.samples recipes.
/// @param redrawn  counts the draws that made no valid recipe
/// @throws Error if one of them has no colours; Stopped
SampledSums sampled_sums(UncertainPaint& paint, const ValueLayout& layout, const Values& centre,
                         const UncertaintyOptions& options, int& redrawn);

}  // namespace nacre::fit
