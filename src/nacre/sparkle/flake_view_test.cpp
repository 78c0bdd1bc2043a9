#include "nacre/sparkle/flake_view.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "nacre/sparkle/flake_field.h"

namespace nacre::sparkle {
namespace {

/// Flakes on a square patch, on average over places.
double mean_count(const FlakeField& field, double side_mm, bool tilted, FlakeView& view) {
    constexpr int kPatches = 60;
    const auto side = static_cast<float>(side_mm);
    ObjectSpaceFootprint patch;
    if (tilted) {  // three planes have a third of the flakes each
        patch.normal = normalize(Vec3f{1, 1, 1});
        patch.tangent = normalize(Vec3f{1, -1, 0});
    }
    patch.edge_mm[0] = side * patch.tangent;
    patch.edge_mm[1] = side * cross(patch.normal, patch.tangent);
    double sum = 0;
    for (int i = 0; i < kPatches; ++i) {
        const auto n = static_cast<float>(i);
        patch.position_mm = {7.3f * n * side, -3.1f * n * side, 3};
        field.query(patch, view);
        sum += view.count;
    }
    return sum / kPatches;
}

// What does not fit into a view would be lost without a word.
TEST(FlakeView, HasRoomForEveryFlakeThatAPatchTouches) {
    const auto view = std::make_unique<FlakeView>();
    double most = 0;
    for (const double density : {30.0, 4000.0, 2e5}) {
        const FlakePopulation population{.density_per_mm2 = density, .diameter_um = 20};
        const FlakeField field(population, 1);
        for (double cells = 4; cells < 3000; cells *= 1.1) {
            const double side = field.constants().cell_mm[0] * (std::sqrt(cells) - 1) -
                                1e-3 * population.diameter_um;
            if (side <= 0) continue;
            for (const bool tilted : {false, true}) {
                most = std::max(most, mean_count(field, side, tilted, *view));
            }
        }
    }
    EXPECT_LT(most + 6 * std::sqrt(most), FlakeView::kMax) << most;
    EXPECT_GT(most, FlakeView::kMax / 2) << "more room than is needed";
}

}  // namespace
}  // namespace nacre::sparkle
