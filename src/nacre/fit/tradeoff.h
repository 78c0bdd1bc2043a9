#pragma once

#include <optional>
#include <string>
#include <vector>

#include "nacre/fit/target.h"

namespace nacre::fit {

/// A change of several numbers together that leaves the colours nearly the same, all the way from
/// one end to the other.
struct Tradeoff {
    struct Change {
        std::string key;
        double from = 0, to = 0;
    };
    std::vector<Change> changes;  ///< of those that take part, the largest first
    /// Of the colours at the far end from those of the fit, root mean square, read off the paint
    /// that was solved there.
    double rms_delta_e = 0;
};

/// Follows a direction of the unit cube from x, in the sense in which that leads farther, as long as
/// the colours, solved anew at each step, stay within `equal_delta_e` of those at x. What the
/// derivatives say about so long a way is not relied on.
/// @param direction  with a length above 0
/// @return empty if that is no farther than a fiftieth of the distance between the bounds
std::optional<Tradeoff> tradeoff(const ColourModel& model, const std::vector<double>& x,
                                 const std::vector<double>& direction, double equal_delta_e);

}  // namespace nacre::fit
