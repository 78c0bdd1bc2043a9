#include "nacre/fit/uncertain_values.h"

#include <limits>

namespace nacre::fit {

Values values_of(const measure::Measurement& measurement) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    Values values;
    for (const measure::Reading& reading : measurement.readings) {
        for (int c = 0; c < 3; ++c) values.push_back(reading.lab[c]);
        values.insert(values.end(), reading.reflectance_factor.begin(),
                      reading.reflectance_factor.end());
    }
    values.push_back(measure::flop_index(measurement).value_or(kNone));
    const measure::ColourTravel travel = measure::colour_travel(measurement);
    values.push_back(travel.path.size() > 1 ? travel.length : kNone);
    return values;
}

}  // namespace nacre::fit
