#include "nacre/core/estimate.h"

#include <numbers>

#include "nacre/core/error.h"

namespace nacre {

// By the midpoint rule on the density after t = tan(u) sqrt(nu), which is proportional to
// cos(u)^(nu - 1).
double student_two_sided(double x, double nu) {
    constexpr int kSteps = 4000;
    const double half_pi = std::numbers::pi / 2, u0 = std::atan(x / std::sqrt(nu));
    const auto integral = [&](double from) {
        const double h = (half_pi - from) / kSteps;
        double sum = 0;
        for (int i = 0; i < kSteps; ++i) sum += std::pow(std::cos(from + (i + 0.5) * h), nu - 1);
        return sum * h;
    };
    return integral(u0) / integral(0);
}

double median(std::vector<double> values) {
    if (values.empty()) throw DomainError("there is no median of no values");
    std::sort(values.begin(), values.end());
    const std::size_t middle = values.size() / 2;
    return values.size() % 2 ? values[middle] : 0.5 * (values[middle - 1] + values[middle]);
}

}  // namespace nacre
