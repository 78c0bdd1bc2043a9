#include "nacre/fit/tradeoff.h"

#include <algorithm>
#include <cmath>

namespace nacre::fit {

namespace {

/// Numbers whose component of a direction is below this fraction of the largest are not named.
constexpr double kPartOfTradeoff = 0.15;
/// A direction is not reported if it ends within this fraction of the distance between the bounds.
constexpr double kMinReach = 0.02;
/// A hue turns over a tenth of the cube: longer steps might miss that it comes back.
constexpr double kLongestStride = 0.1;
constexpr int kBisections = 5;
/// Components below this part of the largest do not end the way at their bound.
constexpr double kNoPart = 1e-3;

/// How far a direction leads, in the coordinate that changes most, and the difference there.
struct Reach {
    double distance = 0, rms_delta_e = 0;
};

class Way {
 public:
    /// @param direction  of which the largest component is 1 or -1
    Way(const ColourModel& model, const std::vector<double>& x, std::vector<double> direction)
        : model_(model), x_(x), direction_(std::move(direction)), here_(model.colours(x)) {}

    std::vector<double> at(double distance) const {
        std::vector<double> point = x_;
        for (std::size_t i = 0; i < point.size(); ++i) {
            point[i] = std::clamp(point[i] + distance * direction_[i], 0.0, 1.0);
        }
        return point;
    }

    /// The farthest place up to which the colours stay, forward (1) or backward (-1).
    Reach reach(double sign, double equal_delta_e) const {
        const double room = room_along(sign);
        Reach sure;
        if (!here_) return sure;
        const auto stays = [&](double distance) {
            const auto there = model_.colours(at(sign * distance));
            if (!there) return false;
            const double rms = model_.target().rms_delta_e(*here_, *there);
            if (rms > equal_delta_e) return false;
            sure = {distance, rms};
            return true;
        };
        double stride = kMinReach;
        while (sure.distance < room) {
            double beyond = std::min(room, sure.distance + stride);
            stride = std::min(2 * stride, kLongestStride);
            if (stays(beyond)) continue;
            if (sure.distance == 0) return sure;
            for (int i = 0; i < kBisections; ++i) {
                const double middle = (sure.distance + beyond) / 2;
                if (!stays(middle)) beyond = middle;
            }
            break;
        }
        return sure;
    }

 private:
    double room_along(double sign) const {
        double room = 1;
        for (std::size_t i = 0; i < x_.size(); ++i) {
            const double d = sign * direction_[i];
            if (std::abs(d) > kNoPart)
                room = std::min(room, (d > 0 ? 1 - x_[i] : x_[i]) / std::abs(d));
        }
        return std::max(room, 0.0);
    }

    const ColourModel& model_;
    const std::vector<double>& x_;
    std::vector<double> direction_;
    std::optional<measure::Measurement> here_;
};

}  // namespace

std::optional<Tradeoff> tradeoff(const ColourModel& model, const std::vector<double>& x,
                                 const std::vector<double>& direction, double equal_delta_e) {
    double largest = 0;
    for (const double d : direction) largest = std::max(largest, std::abs(d));
    std::vector<double> unit = direction;
    for (double& d : unit) d /= largest;
    const Way way(model, x, unit);
    const Reach forward = way.reach(1, equal_delta_e), backward = way.reach(-1, equal_delta_e);
    const bool ahead = forward.distance >= backward.distance;
    const Reach& farther = ahead ? forward : backward;
    if (farther.distance < kMinReach) return std::nullopt;

    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < x.size(); ++i) {
        if (std::abs(unit[i]) >= kPartOfTradeoff) order.push_back(i);
    }
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return std::abs(unit[a]) > std::abs(unit[b]);
    });
    Tradeoff found;
    found.rms_delta_e = farther.rms_delta_e;
    const std::vector<double> end = way.at(ahead ? farther.distance : -farther.distance);
    for (const std::size_t i : order) {
        const FreeNumber& number = model.numbers()[i];
        found.changes.push_back(
            {number.bounds.key, number.from_unit(x[i]), number.from_unit(end[i])});
    }
    return found;
}

}  // namespace nacre::fit
