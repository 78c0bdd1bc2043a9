#pragma once

#include <string>
#include <vector>

#include "nacre/report/plot_data.h"

// Where an axis carries lines and numbers when no script is there to decide it.

namespace nacre::report {

struct Tick {
    double value = 0;
    std::string text = {};  ///< empty: a line without a number

    friend bool operator==(const Tick&, const Tick&) = default;
};

/// The distance between ticks, of the form 1, 2 or 5 times a power of ten, that gives about
/// `count` of them.
double tick_step(double lo, double hi, double count);

/// The extent with both ends moved outwards to multiples of the tick step, if it may be.
Extent rounded(const Extent& extent, double count);

/// Multiples of tick_step() from lo to hi. An axis that spans less than its numbers resolve
/// (1e16 to 1e16 + 2) has none.
std::vector<Tick> linear_ticks(double lo, double hi, double count);

/// On a logarithmic axis: the powers of ten, with 2 and 5 numbered and the other digits as lines
/// where there is room; over very many decades only every so many; within one decade those of a
/// linear axis.
/// @param lo  > 0
std::vector<Tick> logarithmic_ticks(double lo, double hi, double count);

/// A number with `decimals` digits after the point, or of six digits and more as in 2.5·10⁶.
std::string tick_text(double value, double step);

}  // namespace nacre::report
