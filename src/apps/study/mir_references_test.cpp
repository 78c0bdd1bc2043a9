#include "apps/study/mir_references.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/core/sha256.h"
#include "nacre/io/image_difference.h"
#include "nacre/io/recipe_file.h"
#include "nacre/models/models.h"
#include "nacre/render/builtin_scenes.h"
#include "nacre/render/environment.h"
#include "nacre/render/scene_file.h"
#include "nacre/testing/files.h"

namespace nacre::study {
namespace {

using ::testing::HasSubstr;

void run_at_once(const std::string&, const std::function<void(const Progress&)>& work) { work({}); }

TEST(References, MeanAndStandardErrorAreThoseOfTheBatches) {
    std::vector<io::Image> batches;
    for (float value : {1.0f, 2.0f, 6.0f}) {
        batches.push_back({1, 1, {{"R", {value}}, {"A", {1.0f}}}, {}});
    }
    const io::Image mean = mean_with_standard_error(batches);
    EXPECT_FLOAT_EQ(mean.find("R")->pixels[0], 3);
    // Deviations -2, -1, 3: the variance of one is 7, of the mean 7 / 3.
    EXPECT_FLOAT_EQ(mean.find("stderr.R")->pixels[0], std::sqrt(7.0f / 3));
    EXPECT_EQ(mean.find("stderr.A"), nullptr);
    EXPECT_EQ(mean.metadata.at(io::kBatchesKey), "3");
    batches[1].channels.pop_back();
    EXPECT_THROW(mean_with_standard_error(batches), DomainError);
    EXPECT_THROW(mean_with_standard_error({}), DomainError);
}

/// References at the least size, once for all tests.
const test::TempFolder& references() {
    static const test::TempFolder folder;
    static const auto written = write_references(
        {.folder = folder.path(), .size = 16, .samples = 64, .quick = true}, run_at_once);
    return folder;
}

TEST(References, EveryFileHasItsChecksum) {
    const std::string sums = read_file(references() / "SHA256SUMS");
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(references().path())) {
        const std::string name = entry.path().filename();
        if (name == "SHA256SUMS" || name == ".lock") continue;
        EXPECT_THAT(sums, HasSubstr(sha256_hex(read_file(entry.path(), 1 << 24)) + "  " + name));
        ++files;
    }
    EXPECT_EQ(files, 2 * 5 + 1);
}

TEST(References, RecipeAndSceneReadBackAsWhatWasRendered) {
    const render::SceneDescription scene =
        render::read_scene(references() / "metallic-gray.scene.toml");
    const render::SceneDescription ball = render::builtin_scene("sphere");
    EXPECT_EQ(scene.camera, ball.camera);
    EXPECT_EQ(scene.shapes, ball.shapes);
    auto studio = std::get<render::StudioEnvironment>(*ball.environment);
    studio.boxes = render::studio_soft_boxes();
    EXPECT_EQ(std::get<render::StudioEnvironment>(*scene.environment), studio);
    const auto& paint = std::get<render::PaintMaterial>(scene.materials.at("paint"));
    EXPECT_EQ(io::read_recipe(paint.recipe),
              io::read_recipe(shipped_file("paints/metallic-gray.toml")));
}

TEST(References, AnotherSolutionOfThePaintAgreesWithinTheErrorsThatTheyTell) {
    const io::Image reference = io::read_image(references() / "metallic-gray.exr");
    ASSERT_NE(reference.find("stderr.S0.405,000000nm"), nullptr);
    // By the solver, which shares no code with the walks, at four times the samples.
    const test::TempFolder folder;
    const Gallery gallery(folder.path(), run_at_once);
    PictureJob job;
    job.key = "solved";
    job.paint = shipped_file("paints/metallic-gray.toml");
    job.model = models::named_model("microflake");
    job.render.width = job.render.height = 16;
    job.render.samples_per_pixel = 1024;
    const auto z = io::image_z_scores(gallery.make(job).image, reference, "solved", "reference");
    ASSERT_TRUE(z);
    EXPECT_FALSE(z->has_error_a);
    EXPECT_GT(z->values, 100u);
    EXPECT_LT(std::abs(z->of_mean), 4.5);
    // Sixteen batches of as many samples tell the errors of dark pixels, lit by few paths, too small:
    // of 0.9 % expected, some 4 % are beyond 3.
    EXPECT_LT(z->fraction_above_3, 0.08);
    EXPECT_GT(z->mean_square, 0.5);
}

TEST(References, AreNotMadeAgainAndForeignFilesAreKept) {
    const test::TempFolder folder;
    folder.write("metallic-gray.toml", "name = \"mine\"\n");
    EXPECT_THROW(
        write_references({.folder = folder.path(), .size = 16, .samples = 8, .quick = true},
                         run_at_once),
        InputError);
    int made = 0;
    write_references({.folder = references().path(), .size = 16, .samples = 64, .quick = true},
                     [&](const std::string&, const auto& work) {
                         ++made;
                         work({});
                     });
    EXPECT_EQ(made, 0);
}

}  // namespace
}  // namespace nacre::study
