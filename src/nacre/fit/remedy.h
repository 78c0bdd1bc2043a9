#pragma once

#include <string>
#include <vector>

#include "nacre/fit/target.h"

// What would bring a fit nearer to a standard that it did not match.

namespace nacre::fit {

/// One more number that is free, or a bound at which one stands given way.
struct Remedy {
    std::string key;
    bool widens = false;            ///< the number was free, and is at a bound
    paint::ParameterBounds bounds;  ///< between which it was sought
    double value = 0;               ///< where it then ends
    double mean_delta_e_2000 = 0;   ///< of the standard then, all free numbers having followed it
};

/// Tries each number that was not free, within default_bounds(), and each bound at which a free one
/// ended, three times as wide as far as its key allows: first alone, at several places, in the paint
/// that was found and in that from which the fit started; then from the best of them together with
/// the free numbers, by a short descent. The differences are those of the paints that these end at; a
/// whole fit would come nearer.
///
/// @param found       what the fit ended with
/// @param start       what it began with
/// @param free        its numbers, with their values in `found`
/// @param mean_now    mean Delta E 2000 of `found`
/// @param solves      counts those that this takes
/// @return at most three that take a tenth off the difference or more, the best first
std::vector<Remedy> find_remedies(const Target& target, const paint::Recipe& found,
                                  const paint::Recipe& start,
                                  const std::vector<FittedParameter>& free, double mean_now,
                                  SharedProgress& work, int& solves);

}  // namespace nacre::fit
