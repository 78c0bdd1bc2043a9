#pragma once

#include <vector>

namespace nacre::study {

/// The middle of the values, or the mean of the two in the middle: one run that something else
/// disturbed does not count.
/// @throws DomainError if there are none
double median(std::vector<double> values);

}  // namespace nacre::study
