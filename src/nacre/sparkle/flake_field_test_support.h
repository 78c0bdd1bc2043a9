#pragma once

#include <cmath>
#include <memory>
#include <numbers>

#include "nacre/sparkle/flake_field.h"

// Only for tests: patches of a field of flakes, and what they reflect.

namespace nacre::sparkle::testing {

inline constexpr FlakePopulation kSilver{
    .density_per_mm2 = 4000, .diameter_um = 20, .diameter_spread_um = 0, .alpha = 0.1, .ior = 1.5};

inline ObjectSpaceFootprint square_patch(double x_mm, double y_mm, double side_mm,
                                         double turn = 0) {
    const float c = static_cast<float>(side_mm * std::cos(turn));
    const float s = static_cast<float>(side_mm * std::sin(turn));
    ObjectSpaceFootprint patch;
    patch.position_mm = {static_cast<float>(x_mm), static_cast<float>(y_mm), 3};
    patch.edge_mm[0] = {c, s, 0};
    patch.edge_mm[1] = {-s, c, 0};
    return patch;
}

/// The side of a square that holds so many flakes on average.
inline double side_of(double flakes, const FlakePopulation& population) {
    return std::sqrt(flakes / population.density_per_mm2);
}

/// The light that a patch reflects for one half vector, relative to the mean over patches.
inline double relative_radiance(const FlakeField& field, const FlakeView& view, Vec2f slope,
                                float cosine) {
    double sum = 0;
    const float background = view.for_each_reflecting_flake(
        field.lobe(), slope, cosine, [&](int, float fraction) { sum += fraction; });
    return background + sum;
}
inline double relative_radiance(const FlakeField& field, const ObjectSpaceFootprint& patch,
                                Vec2f slope, float cosine) {
    static const auto view = std::make_unique<FlakeView>();
    field.query(patch, *view);
    return relative_radiance(field, *view, slope, cosine);
}

/// Int coverage_1 coverage_2 over the place of a disc, in mm^2: the fractions that it covers of a
/// square and of the same square moved by apart_mm along an edge.
inline double place_factor(double side_mm, double diameter_mm, double apart_mm = 0) {
    const double r = diameter_mm / 2;
    if (side_mm == 0) return std::numbers::pi * r * r;
    const float s = static_cast<float>(side_mm), apart = static_cast<float>(apart_mm);
    const double reach = side_mm / 2 + r;
    constexpr int kSteps = 400;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        for (int j = 0; j < kSteps; ++j) {
            const float x = static_cast<float>(reach * (2 * (i + 0.5) / kSteps - 1));
            const float y = static_cast<float>(reach * (2 * (j + 0.5) / kSteps - 1));
            const auto area = [&](float middle) {
                return disc_overlap(splat(x - middle), splat(y), splat(static_cast<float>(r)),
                                    Parallelogram({s, 0}, {0, s}))[0];
            };
            sum += double{area(0)} * (apart_mm == 0 ? area(0) : area(apart));
        }
    }
    return sum * 4 * reach * reach / (kSteps * kSteps) / std::pow(side_mm, 4);
}

}  // namespace nacre::sparkle::testing
