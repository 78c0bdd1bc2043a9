#include "nacre/measure/flop.h"

#include <algorithm>
#include <cmath>

namespace nacre::measure {

std::optional<double> flop_index(const Measurement& measurement) {
    const Reading* near = measurement.find(45, 15);
    const Reading* face = measurement.find(45, 45);
    const Reading* far = measurement.find(45, 110);
    if (!near || !face || !far) return std::nullopt;
    const double fall = near->lab[0] - far->lab[0], lightness = face->lab[0];
    if (!(fall >= 0 && lightness > 0)) return std::nullopt;
    return 2.69 * std::pow(fall, 1.11) / std::pow(lightness, 0.86);
}

ColourTravel colour_travel(const Measurement& measurement, double theta_i_deg) {
    constexpr double kSame_deg = 1e-6;
    ColourTravel travel;
    for (const Reading& reading : measurement.readings) {
        if (is_in_plane(reading.geometry) &&
            std::abs(reading.geometry.theta_i_deg - theta_i_deg) <= kSame_deg) {
            travel.path.push_back(&reading);
        }
    }
    std::stable_sort(travel.path.begin(), travel.path.end(),
                     [](const Reading* a, const Reading* b) {
                         return a->geometry.aspecular_deg < b->geometry.aspecular_deg;
                     });
    for (std::size_t i = 1; i < travel.path.size(); ++i) {
        const spectra::Vec3 &from = travel.path[i - 1]->lab, &to = travel.path[i]->lab;
        travel.length += std::hypot(to[1] - from[1], to[2] - from[2]);
    }
    return travel;
}

}  // namespace nacre::measure
