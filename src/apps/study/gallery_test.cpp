#include "apps/study/gallery.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "nacre/bsdf/models/nacre.h"
#include "nacre/core/file.h"
#include "nacre/paint/recipe.h"

namespace nacre::study {
namespace {

PictureJob flakes_job() {
    PictureJob job;
    job.paint = shipped_file("studies/mir-2022/flakes-570.toml");
    job.model = bsdf::NacreModel{};
    return job;
}

TEST(Gallery, FlakesOnABallAreTheirCoverageOverTheirArea) {
    const paint::Recipe recipe = recipe_of(flakes_job());
    const paint::FlakeSpecies& flake = recipe.layers[0].flakes[0];
    // Mean area of discs whose diameters have this mean and this standard deviation.
    const double area_um2 =
        std::numbers::pi / 4 *
        (std::pow(flake.diameter_um, 2) + std::pow(flake.diameter_spread_um, 2));
    const double ball_um2 = 4 * std::numbers::pi * 50e3 * 50e3;
    const double expected =
        flake.area_density_per_um() * recipe.layers[0].thickness_um * ball_um2 / area_um2;
    // Diameters are cut off where they would be too small, which moves their moments by 1 %.
    EXPECT_NEAR(flakes_on_ball(recipe, 50) / expected, 1, 0.02);
    EXPECT_NEAR(flakes_on_ball(recipe, 50) / 1e8, 1, 0.02);  // as the recipe says
}

TEST(Gallery, FlakesOfHalfTheDiameterAreFourTimesAsMany) {
    PictureJob job = flakes_job();
    const double count = flakes_on_ball(recipe_of(job), 50);
    job.flake_scale = 0.5;
    EXPECT_NEAR(flakes_on_ball(recipe_of(job), 50) / count, 4, 1e-9);
    EXPECT_NEAR(flakes_on_ball(recipe_of(job), 25) / count, 1, 1e-9);
}

TEST(Gallery, WhateverChangesThePictureChangesItsFingerprint) {
    std::set<std::string> prints;
    const auto add = [&](auto&& change) {
        PictureJob job = flakes_job();
        change(job);
        prints.insert(fingerprint(job));
    };
    add([](PictureJob&) {});
    add([](PictureJob& job) { job.flake_scale = 2; });
    add([](PictureJob& job) { job.scene_scale = 2; });
    add([](PictureJob& job) { job.scene = "panel-sun"; });
    add([](PictureJob& job) { job.model = bsdf::MicroflakeModel{}; });
    add([](PictureJob& job) { job.model = bsdf::NacreModel{.specimen = 2}; });
    add([](PictureJob& job) { job.model = bsdf::NacreModel{.hot_spot = true}; });
    add([](PictureJob& job) { job.render.footprint_pixels = 0.5; });
    EXPECT_EQ(prints.size(), 8u);
}

TEST(Gallery, FacetsCannotBeSetWhereThereAreNone) {
    PictureJob job = flakes_job();
    job.facet_count = 1e7;
    EXPECT_THROW(recipe_of(job), InputError);
}

}  // namespace
}  // namespace nacre::study
