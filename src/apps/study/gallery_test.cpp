#include "apps/study/gallery.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <set>

#include "nacre/bsdf/models/nacre.h"
#include "nacre/bsdf/models/thin_film.h"
#include "nacre/core/file.h"
#include "nacre/paint/recipe.h"
#include "nacre/testing/files.h"

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
    add([](PictureJob& job) { job.model = bsdf::NacreModel{.hot_spot = false}; });
    add([](PictureJob& job) { job.render.footprint_pixels = 0.5; });
    EXPECT_EQ(prints.size(), 8u);
}

TEST(Gallery, FacetsCannotBeSetWhereThereAreNone) {
    PictureJob job = flakes_job();
    job.facet_count = 1e7;
    EXPECT_THROW(recipe_of(job), InputError);
}

class GalleryFolder : public ::testing::Test {
 protected:
    void SetUp() override {
        job_.key = "ball";
        job_.paint = shipped_file("studies/mir-2022/facets-570.toml");
        job_.model = bsdf::ThinFilmModel{};
        job_.render.width = job_.render.height = 8;
        job_.render.samples_per_pixel = 2;
    }

    /// The picture of the job, and whether it had to be rendered.
    std::pair<Picture, bool> make(std::uint64_t seed = 0) {
        bool rendered = false;
        const Gallery gallery(folder_, [&](const std::string&, const auto& work) {
            rendered = true;
            work({});
        });
        PictureJob job = job_;
        job.render.seed = seed;
        return {gallery.make(job), rendered};
    }

    test::TempFolder folder_;
    PictureJob job_;
};

TEST_F(GalleryFolder, APictureThatIsNotItsOwnIsMadeAgain) {
    const std::filesystem::path exr = folder_ / "pictures/ball.exr",
                                png = folder_ / "pictures/ball.png",
                                record = folder_ / "pictures/ball.json";
    const auto [first, was_rendered] = make();
    EXPECT_TRUE(was_rendered);
    EXPECT_FALSE(make().second);
    const auto pixels = [](const Picture& picture) { return picture.image.channels[0].pixels; };
    // Killed between the picture of another seed and its record.
    const std::string old_record = read_file(record);
    EXPECT_NE(pixels(make(1).first), pixels(first));
    write_file_atomically(record, old_record);
    const auto [again, again_rendered] = make();
    EXPECT_TRUE(again_rendered);
    EXPECT_EQ(pixels(again), pixels(first));
    for (const std::filesystem::path& file : {exr, png}) {
        const std::string bytes = read_file(file);
        write_file_atomically(file, bytes.substr(0, bytes.size() / 2));
        EXPECT_TRUE(make().second) << file;
        std::filesystem::remove(file);
        EXPECT_TRUE(make().second) << file;
    }
    EXPECT_FALSE(make().second);
}

}  // namespace
}  // namespace nacre::study
