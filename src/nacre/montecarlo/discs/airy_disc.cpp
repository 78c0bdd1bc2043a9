#include "nacre/montecarlo/discs/airy_disc.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nacre::montecarlo {

namespace {

// Within kLast lies all but 0.3 % of the power; the power beyond x falls off as 2 / (pi x),
// averaged over the rings.
constexpr double kLast = 200;
constexpr int kIntervals = 4096;

/// x at equal steps of t, where the fraction of fraction_of_last is 1 - (1 - t)^2: dense in the
/// tail.
struct Table {
    std::array<double, kIntervals + 1> x;
    double fraction_of_last = encircled_power(kLast);

    Table() {
        for (int i = 0; i <= kIntervals; ++i) {
            const double rest = 1 - static_cast<double>(i) / kIntervals;
            const double fraction = fraction_of_last * (1 - rest * rest);
            double lo = 0, hi = kLast;
            for (int step = 0; step < 60; ++step) {
                const double middle = 0.5 * (lo + hi);
                (encircled_power(middle) < fraction ? lo : hi) = middle;
            }
            x[i] = 0.5 * (lo + hi);
        }
    }
};

}  // namespace

double encircled_power(double x) {
    const double j0 = ::j0(x), j1 = ::j1(x);
    return 1 - j0 * j0 - j1 * j1;
}

double AiryDisc::radius_of_fraction(double fraction) {
    static const Table table;
    if (fraction >= table.fraction_of_last) {
        // The tail 2 / (pi x), scaled to fit where it begins.
        return kLast * (1 - table.fraction_of_last) / (1 - fraction);
    }
    // Near the centre the fraction is x^2 / 4, and the table's first step would be too coarse.
    constexpr double kCentre = 3e-3;
    if (fraction < kCentre) return 2 * std::sqrt(fraction) * (1 + 0.25 * fraction);
    const double t = 1 - std::sqrt(1 - fraction / table.fraction_of_last);
    const double place = t * kIntervals;
    const int i = std::min(static_cast<int>(place), kIntervals - 1);
    return table.x[i] + (place - i) * (table.x[i + 1] - table.x[i]);
}

}  // namespace nacre::montecarlo
