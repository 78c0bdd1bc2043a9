#include "nacre/optics/film_nodes.h"

#include <algorithm>
#include <cmath>

namespace nacre::optics {

namespace {

/// Few different counts, so that few rules are made.
int rounded_count(double n) {
    const int rounded = n < 16 ? static_cast<int>(std::ceil(n))
                               : 8 * static_cast<int>(std::ceil(std::min(n, 1e4) / 8));
    return std::clamp(rounded, 1, kMostNodesPerFilm);
}

}  // namespace

int nodes_for_wave(double half_phase, double p, double target_error) {
    p = std::clamp(p, 1e-12, 1 - 1e-9);
    const double pole = -std::log(p) / std::max(half_phase, 1e-12);
    return rounded_count(-std::log(target_error) / (2 * std::asinh(pole)) + 1);
}

int nodes_for_decay(double lo_nm, double hi_nm, double decay_per_nm, double target_error) {
    const double half_nm = (hi_nm - lo_nm) / 2;
    const double pole = std::max((lo_nm + hi_nm) / 2 / half_nm, 1.05);
    return rounded_count(-std::log(target_error) / (2 * std::acosh(pole)) +
                         decay_per_nm * half_nm / 2 + 1);
}

}  // namespace nacre::optics
