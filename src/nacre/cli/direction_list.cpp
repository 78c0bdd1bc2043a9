#include "nacre/cli/direction_list.h"

#include <fmt/format.h>

#include "nacre/cli/number_list.h"
#include "nacre/cli/usage_error.h"

namespace nacre::cli {

namespace {

constexpr Range kTheta{0, 90, "deg", false, true};
constexpr Range kPhi{-360, 360, "deg"};

}  // namespace

std::vector<Direction> parse_directions(const std::string& option,
                                        const std::vector<std::string>& texts) {
    std::vector<Direction> directions;
    for (const std::string& text : texts) {
        const std::vector<std::string> parts = split(text, ',');
        if (parts.size() > 2) {
            throw UsageError(
                fmt::format("{} = {}: must be theta or theta,phi in degrees", option, text));
        }
        const std::vector<double> thetas = parse_numbers(option + " (theta)", parts[0], kTheta);
        const std::vector<double> phis = parts.size() == 2
                                             ? parse_numbers(option + " (phi)", parts[1], kPhi)
                                             : std::vector<double>{0.0};
        if (thetas.size() * phis.size() + directions.size() > kMostDirections) {
            throw UsageError(fmt::format("{}: more than {} directions", option, kMostDirections));
        }
        for (double theta : thetas) {
            for (double phi : phis) directions.push_back({theta, phi});
        }
    }
    return directions;
}

}  // namespace nacre::cli
