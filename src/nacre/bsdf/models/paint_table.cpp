#include "nacre/bsdf/models/paint_table.h"

#include <algorithm>

#include "nacre/bsdf/models/bound_microflake.h"

namespace nacre::bsdf {
namespace {

// Roughness that the grid of the smooth table must resolve.
double narrowest_alpha(const solver::PaintMedium& medium) {
    double alpha = 1.0;
    for (const auto& layer : medium.layers) {
        for (const auto& flake : layer.flakes) alpha = std::min(alpha, flake.alpha);
    }
    // Under a rough interface the table holds single scattering too, whose lobe is narrower by
    // sqrt(3) and makes up the peak: a third keeps kMicroflakeRoughError (microflake_test.cpp).
    return medium.roughness > 0 ? alpha / 3 : alpha;
}

}  // namespace

std::vector<const solver::MultipleScattering*> tabulated_tensors(const solver::SolvedPaint& paint) {
    if (has_rough_interface(paint)) return {&paint.multiple_scattering, &paint.rough_single};
    return {&paint.multiple_scattering};
}

SmoothTable smooth_table(const solver::SolvedPaint& paint) {
    return {tabulated_tensors(paint), narrowest_alpha(paint.medium), mean_ior(paint.medium)};
}

BoundSmoothTable bind_table(const SmoothTable& table, const solver::SolvedPaint& paint,
                            const std::array<WavelengthPosition, kLanes>& where, bool single_only) {
    const int count = paint.medium.wavelength_count();
    int first = 0;
    std::vector<FloatLanes> basis;
    for (const solver::MultipleScattering* tensor : tabulated_tensors(paint)) {
        if (single_only && tensor != &paint.rough_single) {
            first += tensor->table_rank;
            continue;
        }
        for (int k = 0; k < tensor->table_rank; ++k) {
            basis.push_back(
                at_wavelengths(where, [&](int w) { return tensor->basis[k * count + w]; }));
        }
    }
    return table.bind(first, basis);
}

}  // namespace nacre::bsdf
