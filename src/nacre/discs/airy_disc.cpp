#include "nacre/discs/airy_disc.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nacre::discs {
namespace {

// Within kLast lies all but 0.3 % of the power; the rest falls off as 2 / (pi x) on average, its
// rings being too fine to see.
constexpr double kLast = 200;
constexpr int kIntervals = 4096;

/// x at equal steps of t, where the share is 1 - (1 - t)^2: fine where the pattern ends.
struct Table {
    std::array<double, kIntervals + 1> x;
    double share_of_last = encircled_power(kLast);

    Table() {
        for (int i = 0; i <= kIntervals; ++i) {
            const double rest = 1 - static_cast<double>(i) / kIntervals;
            const double share = share_of_last * (1 - rest * rest);
            double lo = 0, hi = kLast;
            for (int step = 0; step < 60; ++step) {
                const double middle = 0.5 * (lo + hi);
                (encircled_power(middle) < share ? lo : hi) = middle;
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

double AiryDisc::radius_of_share(double share) {
    static const Table table;
    if (share >= table.share_of_last) {
        // The tail 2 / (pi x), scaled to fit where it begins.
        return kLast * (1 - table.share_of_last) / (1 - share);
    }
    // Near the centre the share is x^2 / 4, and the table's first step would be too coarse.
    constexpr double kCentre = 3e-3;
    if (share < kCentre) return 2 * std::sqrt(share) * (1 + 0.25 * share);
    const double t = 1 - std::sqrt(1 - share / table.share_of_last);
    const double place = t * kIntervals;
    const int i = std::min(static_cast<int>(place), kIntervals - 1);
    return table.x[i] + (place - i) * (table.x[i + 1] - table.x[i]);
}

}  // namespace nacre::discs
