#include "nacre/core/random.h"

#include <cmath>

#include "nacre/core/error.h"

namespace nacre {

namespace {

constexpr unsigned kPrimes[kMaxHaltonDimensions] = {2,  3,  5,  7,  11, 13, 17, 19, 23, 29, 31, 37,
                                                    41, 43, 47, 53, 59, 61, 67, 71, 73, 79, 83, 89};

}  // namespace

std::vector<std::vector<double>> halton_points(std::size_t count, std::size_t dimensions,
                                               std::uint64_t seed) {
    require_in_range(static_cast<double>(dimensions), 1, kMaxHaltonDimensions,
                     "dimensions of a Halton sequence");
    Rng rng(seed);
    std::vector<double> shift;
    for (std::size_t d = 0; d < dimensions; ++d) shift.push_back(rng.uniform_double());
    std::vector<std::vector<double>> points(count, std::vector<double>(dimensions));
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t d = 0; d < dimensions; ++d) {
            const double x = radical_inverse(i + 1, kPrimes[d]) + shift[d];
            points[i][d] = x - std::floor(x);
        }
    }
    return points;
}

}  // namespace nacre
