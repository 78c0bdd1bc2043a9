#include "nacre/bsdf/models/direction_tables.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "nacre/core/parallel.h"
#include "nacre/solver/directions.h"

namespace nacre::bsdf {

double direction_angle(int row) {
    const double x = static_cast<double>(row) / kDirectionIntervals;
    return std::min(2 * std::atan(x), std::numbers::pi / 2 - 1e-4);
}

std::vector<float> tabulate_inside(
    const solver::PaintMedium& medium,
    const std::function<std::vector<DoubleLanes>(double mu, int first, int count)>& value) {
    const int wavelengths = medium.wavelength_count();
    const auto at = [&](int row, int w) { return static_cast<std::size_t>(row) * wavelengths + w; };
    std::vector<float> table(at(kDirectionIntervals + 1, 0));
    parallel_for(0, kDirectionIntervals + 1, [&](std::size_t index) {
        const int row = static_cast<int>(index);
        const double theta = direction_angle(row);
        for (int w = 0; w < wavelengths;) {
            int end = w + 1;
            while (end < wavelengths && medium.ior[end] == medium.ior[w]) ++end;
            const int first = w / kLanes;
            const auto blocks = value(solver::inside_cosine(medium.ior[w], theta), first,
                                      (end - 1) / kLanes - first + 1);
            for (; w < end; ++w) {
                table[at(row, w)] = static_cast<float>(blocks[w / kLanes - first][w % kLanes]);
            }
        }
    });
    return table;
}

std::vector<std::vector<float>> extinction_by_direction(const solver::PaintMedium& medium) {
    std::vector<std::vector<float>> extinction;
    for (const auto& layer : medium.layers) {
        extinction.push_back(tabulate_inside(medium, [&](double mu, int first, int count) {
            return solver::extinctions(layer, mu, first, count);
        }));
    }
    return extinction;
}

}  // namespace nacre::bsdf
