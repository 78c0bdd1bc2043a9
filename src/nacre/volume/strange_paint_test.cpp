#include <gtest/gtest.h>

#include "nacre/volume/plane_walk.h"
#include "nacre/volume/shell_walk.h"
#include "nacre/volume/test_support.h"

namespace nacre::volume {
namespace {

/// Between two powers of ten.
double by_magnitude(Rng& rng, double least, double most) {
    return least * std::pow(most / least, rng.uniform_double());
}

/// A paint at the limits of what a recipe may say, but for what scatters for ever: a depth of
/// hundreds that absorbs nothing.
layers::Recipe strange_paint(Rng& rng) {
    layers::Recipe recipe = test::paint(1 + 2 * rng.uniform_double(), {}, rng.uniform_double());
    if (rng.uniform_double() < 0.2) recipe.binder = 1.0;
    const int count = 1 + static_cast<int>(3 * rng.uniform_double());
    for (int i = 0; i < count; ++i) {
        const double thickness_um = by_magnitude(rng, 1e-3, 1e5);
        const double depth = by_magnitude(rng, 1e-6, 1e4);
        layers::Layer layer;
        layer.thickness_um = thickness_um;
        if (rng.uniform_double() < 0.7) {
            const double reflectance = 0.95 * rng.uniform_double();
            layer.flakes.push_back(reference::test::flakes(
                std::min(depth / thickness_um, 1e6), by_magnitude(rng, 0.005, 1), reflectance,
                (0.95 - reflectance) * rng.uniform_double()));
        }
        if (rng.uniform_double() < 0.5) {
            const double per_mm = std::min(1e3 * depth / thickness_um, 1e9);
            layer.pigments.push_back({per_mm * rng.uniform_double(), per_mm * 0.1,
                                      1.998 * rng.uniform_double() - 0.999});
        }
        recipe.layers.push_back(layer);
    }
    if (rng.uniform_double() < 0.5) {
        recipe.clearcoat = layers::Clearcoat{rng.uniform_double() < 0.3 ? 0 : 50.0,
                                             by_magnitude(rng, 1e-3, 1e3), 0};
    }
    return recipe;
}

void expect_sound_samples(const bsdf::Bsdf& model, Rng& rng, int& left) {
    const auto surface = model.bind(test::kOnGrid);
    for (int i = 0; i < 100; ++i) {
        const Vec3f wi =
            test::from_degrees(i % 4 == 0 ? 89.999 * rng.uniform_double() : 89.999 * (1 - 1e-6 * i),
                               360 * rng.uniform_double());
        const float u_lobe = rng.uniform_float(), u = rng.uniform_float();
        const auto sample = surface->sample(wi, u_lobe, {u, rng.uniform_float()});
        if (!sample) continue;
        ++left;
        EXPECT_NEAR(length(sample->wo), 1, 1e-5);
        EXPECT_TRUE(std::isfinite(length(sample->exit_mm)));
        for (int lane = 0; lane < kLanes; ++lane) {
            EXPECT_GE(sample->weight[lane], 0);
            EXPECT_TRUE(std::isfinite(sample->weight[lane]));
        }
    }
}

TEST(StrangePaint, WalksAreFiniteAtTheLimitsOfRecipes) {
    Rng rng(11, 12);
    int left = 0;
    for (int i = 0; i < 60; ++i) {
        const layers::Recipe recipe = strange_paint(rng);
        double thickness_um = recipe.clearcoat ? recipe.clearcoat->thickness_um : 0;
        for (const layers::Layer& layer : recipe.layers) thickness_um += layer.thickness_um;
        // From nearly solid paint to nearly flat.
        const double radius_mm = 1e-3 * thickness_um * (1 + by_magnitude(rng, 1e-5, 1e12));
        const auto tracking = i % 2 == 0 ? Tracking::delta : Tracking::simpson;
        expect_sound_samples(PlaneWalk(recipe), rng, left);
        expect_sound_samples(ShellWalk(recipe, {radius_mm, tracking}), rng, left);
        expect_sound_samples(ShellWalk(recipe, {.tracking = tracking}), rng, left);
    }
    EXPECT_GT(left, 5000);
}

}  // namespace
}  // namespace nacre::volume
