#pragma once

#include <numbers>

#include "nacre/discs/disc_scene.h"
#include "nacre/volume/test_support.h"

namespace nacre::discs::test {

using reference::test::flake_layer;
using reference::test::paint;
using volume::test::from_degrees;
using volume::test::kOnGrid;
using volume::test::kWorstZ;
using volume::test::walked_albedo;
using volume::test::z_score;

/// One layer of opaque flakes of one size. Under 50 um of clearcoat: no flake is moved.
inline layers::Recipe opaque(double depth, double thickness_um, double diameter_um,
                             double alpha = 0.1, double reflectance = 0.6) {
    layers::Layer layer = flake_layer(depth, alpha, reflectance, 0);
    layer.thickness_um = thickness_um;
    layer.flakes[0].amount = layers::AreaDensity{depth / thickness_um};
    layer.flakes[0].diameter_um = diameter_um;
    layer.flakes[0].diameter_spread_um = 0;
    layers::Recipe recipe = paint(1.5, {layer});
    recipe.clearcoat.emplace();
    recipe.clearcoat->thickness_um = 50;
    return recipe;
}

inline double degrees(double d) { return d * std::numbers::pi / 180; }

}  // namespace nacre::discs::test
