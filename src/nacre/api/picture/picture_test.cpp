#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>

#include "nacre/core/file.h"
#include "nacre/render.h"
#include "nacre/render/turntable.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/files.h"
#include "nacre/testing/fit.h"

namespace nacre {
namespace {

using nacre::test::message_of;
using ::testing::AllOf;
using ::testing::HasSubstr;

const RenderSettings kTiny{.width = 8, .height = 8, .samples_per_pixel = 1};

TEST(Picture, OfAScenePaintedThroughTheDoor) {
    const Paint paint(fit::testing::pearl());
    const Scene scene(find_scene("sphere"), {.slot = paint});
    ASSERT_EQ(scene.paints().size(), 1u);
    EXPECT_EQ(scene.model_name(), "nacre");
    const Picture picture = scene.render(kTiny), again = Scene(scene).render(kTiny);
    EXPECT_EQ(picture.result.rgb, again.result.rgb);
    EXPECT_EQ(picture.metadata.at("nacre:scene"), "sphere");
    EXPECT_EQ(picture.metadata.at("nacre:recipe_sha256:paint"), paint.recipe_sha256());
    EXPECT_EQ(picture.image().width, 8);
    // Flakes, and other flakes, make other pictures; the paint is not solved again for them.
    const auto solved = paint.solved();
    render::SceneDescription close = find_scene("macro");
    const auto flakes_of = [&](std::uint64_t specimen) {
        return Scene(close, {.slot = paint, .model = NacreModel{.specimen = specimen}});
    };
    const Scene first = flakes_of(0), second = flakes_of(1);
    EXPECT_NE(Scene(close, {.slot = paint, .model = MicroflakeModel{}}).render(kTiny).result.rgb,
              first.render(kTiny).result.rgb);
    EXPECT_NE(second.render(kTiny).result.rgb, first.render(kTiny).result.rgb);
    EXPECT_EQ(paint.solved(), solved);
    EXPECT_EQ(second.render(kTiny).metadata.at("nacre:specimen"), "1");
    EXPECT_EQ(second.render(kTiny).metadata.at("nacre:seed"), "0");
    EXPECT_EQ(Scene(close, {.slot = paint}).specimen(), 0u);
    EXPECT_EQ(Scene(find_scene("sphere"), {.slot = paint, .model = VolumeModel{}}).specimen(),
              std::nullopt);
    // The scene may say which specimen; the model's own counts more.
    close.specimen = 1;
    EXPECT_EQ(flakes_of(0).specimen(), 1u);
    EXPECT_EQ(flakes_of(2).specimen(), 2u);
    EXPECT_EQ(flakes_of(0).render(kTiny).result.rgb, second.render(kTiny).result.rgb);
    RenderSettings two_passes = kTiny;
    two_passes.samples_per_pixel = 2;
    EXPECT_FALSE(scene.render(two_passes, [](double) { return false; }).result.complete);
}

TEST(Picture, SaysHowItWasMade) {
    const Paint paint(fit::testing::pearl());
    const auto said = [&](const ScenePaints& paints, const RenderSettings& settings,
                          const render::SceneDescription& description) {
        return Scene(description, paints).render(settings).metadata;
    };
    const render::SceneDescription panel = find_scene("panel");
    const auto usual = said({.slot = paint}, kTiny, panel);
    EXPECT_EQ(usual.at("nacre:depth"), "8");
    EXPECT_EQ(usual.at("nacre:footprint_pixels"), "0");
    EXPECT_EQ(usual.at("nacre:model_settings:paint"), "nacre specimen=0 hot_spot=true");
    EXPECT_FALSE(usual.contains("nacre:turntable"));
    // The hash is that of its shards.
    EXPECT_EQ(usual.at("nacre:scene_sha256"),
              Scene(panel, {.slot = paint}).render_shard(kTiny, {}).scene_sha256);
    RenderSettings others = kTiny;
    others.max_depth = 3;
    others.footprint_pixels = 0.5;
    const auto other =
        said({.slot = paint, .model = NacreModel{.hot_spot = false}}, others,
             render::turned(render::turned(render::turned(panel, render::Turning::shape, 12.5),
                                           render::Turning::camera, -4),
                            render::Turning::shape, 30));
    EXPECT_EQ(other.at("nacre:depth"), "3");
    EXPECT_EQ(other.at("nacre:footprint_pixels"), "0.5");
    EXPECT_EQ(other.at("nacre:model_settings:paint"), "nacre specimen=0 hot_spot=false");
    EXPECT_EQ(other.at("nacre:turntable"), "camera, shape");
    EXPECT_EQ(other.at("nacre:turn_deg"), "-4, 42.5");
    EXPECT_NE(other.at("nacre:scene_sha256"), usual.at("nacre:scene_sha256"));
    // What the model was told of the shapes.
    EXPECT_THAT(said({.slot = paint, .model = VolumeModel{}}, kTiny, find_scene("sphere"))
                    .at("nacre:model_settings:paint"),
                HasSubstr("volume radius_mm=50 tracking="));
    render::SceneDescription small = panel;
    for (render::Shape& shape : small.shapes) shape.geometry = render::FlatPanel{5, 4};
    EXPECT_EQ(said({.slot = paint, .model = ExplicitFlakesModel{}}, kTiny, small)
                  .at("nacre:model_settings:paint"),
              "nacre flakes=explicit tile_width_mm=5 tile_height_mm=4 specimen=0 diffraction=true");
}

TEST(Picture, ModelsThatCannotShowWhereACoatVariesRefuseIt) {
    paint::Recipe recipe = fit::testing::pearl();
    const auto refusal = [&](const paint::Clearcoat& coat) {
        recipe.clearcoat = coat;
        const Paint paint(recipe);
        EXPECT_EQ(Scene(find_scene("sphere"), {.slot = paint}).model_name(), "nacre");
        return message_of<SettingError>(
            [&] { Scene(find_scene("sphere"), {.slot = paint, .model = VolumeModel{}}); });
    };
    EXPECT_THAT(refusal({40, 0.0, 0, paint::OrangePeel{.wd = 0.002}}),
                HasSubstr("orange_peel of the paint of the material paint; must be nacre or "
                          "microflake"));
    EXPECT_THAT(
        refusal({40, 10.0, 0, {}, 4}),
        HasSubstr("thickness_spread_um of the paint of the material paint; must be nacre or "
                  "microflake"));
    // Of a coat without colour nothing is seen of it.
    EXPECT_EQ(refusal({40, 0.0, 0, {}, 4}), "accepted");
}

TEST(Picture, OfATableIsByTheModelThatTablesHold) {
    const Paint table =
        open_text(read_file(shipped_file("fuzz/corpus/brdf_table/raw.h5")), "raw.h5");
    const Scene scene(find_scene("sphere"), {.slot = table, .specimen = 3});
    EXPECT_EQ(scene.model_name(), "microflake");
    EXPECT_EQ(scene.specimen(), 3u);
    const Scene chosen(find_scene("sphere"),
                       {.slot = table, .model = MicroflakeModel{.specimen = 3}});
    EXPECT_EQ(scene.sha256(), chosen.sha256());
    EXPECT_EQ(scene.model_settings(), chosen.model_settings());
    EXPECT_EQ(scene.render(kTiny).metadata, chosen.render(kTiny).metadata);
    EXPECT_THROW(Scene(find_scene("sphere"), {.slot = table, .model = NacreModel{}}), InputError);
}

TEST(Picture, IsMergedFromItsShardsAndNoOthers) {
    const Paint paint(fit::testing::pearl());
    const Scene scene(find_scene("sphere"), {.slot = paint});
    RenderSettings four = kTiny;
    four.samples_per_pixel = 4;
    const test::TempFolder folder;
    const auto shard = [&](const std::string& name, const Scene& of, const RenderSettings& how,
                           const Shard& which) {
        write_shard(folder / name, of.render_shard(how, which));
        return folder / name;
    };
    const auto first = shard("first.h5", scene, four, {1, 2});
    const auto second = shard("second.h5", scene, four, {2, 2});
    const Picture merged = merge_shards(std::vector{second, first});
    EXPECT_EQ(merged.image(), scene.render(four).image());
    EXPECT_EQ(merged.result.seconds,
              read_shard(first).sums.seconds + read_shard(second).sums.seconds);

    // A shard of an earlier run is found, and no other.
    EXPECT_EQ(scene.find_shard(first, four, {1, 2}), read_shard(first));
    EXPECT_FALSE(scene.find_shard(first, four, {2, 2}));
    EXPECT_FALSE(scene.find_shard(first, kTiny, {1, 1}));
    EXPECT_FALSE(scene.find_shard(folder / "none.h5", four, {1, 2}));
    folder.write("broken.h5", read_file(first).substr(0, 600));
    EXPECT_FALSE(scene.find_shard(folder / "broken.h5", four, {1, 2}));

    const auto refused = [&](const std::filesystem::path& other) {
        return message_of<InputError>([&] { merge_shards(std::vector{first, other}); });
    };
    EXPECT_THAT(message_of<InputError>([&] { merge_shards(std::vector{second}); }),
                HasSubstr("second.h5: of its picture, shards are missing: 1/2"));
    EXPECT_THAT(message_of<InputError>([] { merge_shards({}); }), HasSubstr("no shards"));
    EXPECT_THAT(refused(first), HasSubstr("first.h5: holds the shard 1/2, as does "));
    RenderSettings other_seed = four;
    other_seed.seed = 9;
    EXPECT_THAT(refused(shard("seed.h5", scene, other_seed, {2, 2})),
                AllOf(HasSubstr("seed.h5: seed = 9, but "), HasSubstr("first.h5 has 0")));
    EXPECT_THAT(refused(shard("thirds.h5", scene, four, {2, 3})), HasSubstr("count of shards = 3"));
    const Scene by_another_model(find_scene("sphere"), {paint, MicroflakeModel{}});
    EXPECT_THAT(refused(shard("model.h5", by_another_model, four, {2, 2})),
                HasSubstr("model.h5: nacre:model = microflake, but "));
    const Scene of_another_paint(find_scene("sphere"),
                                 {.slot = paint.with("coats[0].thickness_nm", 60)});
    EXPECT_THAT(refused(shard("paint.h5", of_another_paint, four, {2, 2})),
                HasSubstr("paint.h5: nacre:recipe_sha256:paint = "));
    render::SceneDescription moved = find_scene("sphere");
    moved.camera.position_mm.x += 1;
    EXPECT_THAT(refused(shard("moved.h5", Scene(moved, {.slot = paint}), four, {2, 2})),
                HasSubstr("moved.h5: scene_sha256 = "));
    // What a scene is called, and where it lies, is not what it shows.
    render::SceneDescription renamed = find_scene("sphere");
    renamed.name = "ball";
    const auto ball = shard("ball.h5", Scene(renamed, {.slot = paint}), four, {2, 2});
    EXPECT_EQ(merge_shards(std::vector{first, ball}).result.rgb, merged.result.rgb);
}

TEST(Picture, AShardsSceneHasItsFilesContents) {
    const test::TempFolder folder;
    folder.write("a.obj", "v 0 0 0\nv 20 0 0\nv 0 10 0\nf 1 2 3\n");
    folder.write("b.obj", "v 0 0 0\nv 20 0 0\nv 0 10 0\nf 1 2 3\n");
    folder.write("c.obj", "v 0 0 0\nv 20 0 0\nv 0 11 0\nf 1 2 3\n");
    const auto sha256 = [&](const std::string& mesh, float sky, float tile = 0.5f) {
        render::SceneDescription scene;
        scene.materials["grey"] = render::DiffuseMaterial{};
        scene.materials["tiles"] =
            render::DiffusePictureMaterial{.width = 1, .height = 1, .rgb = {tile, 0.5f, 0.5f}};
        scene.shapes.push_back({render::MeshFile{.path = folder / mesh}, "grey", {}});
        scene.environment = render::ImageEnvironment{.width = 1, .height = 1, .rgb = {1, 1, sky}};
        return Scene(scene).render_shard(kTiny, {}).scene_sha256;
    };
    EXPECT_EQ(sha256("a.obj", 1), sha256("b.obj", 1));
    EXPECT_NE(sha256("a.obj", 1), sha256("c.obj", 1));
    EXPECT_NE(sha256("a.obj", 1), sha256("a.obj", 0.5f));
    EXPECT_NE(sha256("a.obj", 1), sha256("a.obj", 1, 0.25f));
    // Materials of an OBJ are not read.
    folder.write("m.obj", "mtllib m.mtl\nv 0 0 0\nv 20 0 0\nv 0 10 0\nf 1 2 3\n");
    folder.write("m.mtl", "newmtl a\n");
    const std::string before = sha256("m.obj", 1);
    folder.write("m.mtl", "newmtl b\n");
    EXPECT_EQ(sha256("m.obj", 1), before);
}

TEST(Picture, SaysWhatDoesNotFit) {
    const auto message = [](const std::string& name, const ScenePaints& paints) {
        return message_of<SettingError>([&] { Scene(find_scene(name), paints); });
    };
    EXPECT_THAT(message("sphere", {}), HasSubstr("slot: the material paint has no recipe"));
    const Paint paint(fit::testing::pearl());
    EXPECT_THAT(message("speed-shape", {paint, VolumeModel{}}),
                HasSubstr("model = volume: the material paint is on a shape"));
    EXPECT_THAT(message("sphere", {paint, ExplicitFlakesModel{}}), HasSubstr("no flat panel"));
    EXPECT_THROW(find_scene("nowhere"), InputError);
    EXPECT_THROW(find_scene("nowhere.toml"), InputError);
    EXPECT_EQ(paint_slots(find_scene("sphere")), std::vector<std::string>{"paint"});
    EXPECT_THROW(Scene(find_scene("sphere"), {paint}).render(kTiny).write("p.jpg"), SettingError);
}

TEST(Picture, ASceneKeptToItsFolderKeepsItsRecipesThere) {
    namespace fs = std::filesystem;
    const test::TempFolder folder;
    fs::create_directories(folder / "scene" / "paints");
    for (const char* file : {"glass.csv", "scene/glass.csv"}) {
        folder.write(file, "wavelength_nm,n\n300,1.5\n900,1.5\n");
    }
    folder.write("scene/scene.toml", R"([materials.paint]
type = "paint"
recipe = "paints/paint.toml"
[[shapes]]
type = "sphere"
material = "paint"
[environment]
type = "constant"
)");
    const auto message = [&](const std::string& glass, const References& references) {
        folder.write("scene/paints/paint.toml",
                     "ior = \"" + glass +
                         "\"\n[[layer]]\nthickness_um = 5\n[[layer.flakes]]\n"
                         "area_density_per_um = 0.1\nreflectance = 0.6\n"
                         "orientation = { distribution = \"beckmann\", alpha = 0.3 }\n");
        try {
            Scene(find_scene((folder / "scene" / "scene.toml").string(), references),
                  {.model = WalkModel{}});
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("accepted");
    };
    const References within = References::within(folder / "scene");
    EXPECT_EQ(message("../glass.csv", within), "accepted");
    EXPECT_THAT(message("../../glass.csv", within), HasSubstr("is outside the folder"));
    EXPECT_THAT(message((folder / "glass.csv").string(), within), HasSubstr("is outside"));
    EXPECT_EQ(message("../../glass.csv", References::anywhere(folder / "scene")), "accepted");
    EXPECT_THAT(message("../glass.csv", {}), HasSubstr("may name none"));
}

TEST(Picture, AllPaintsOfASceneAreReadBeforeTheFirstIsSolved) {
    const test::TempFolder folder;
    const std::string recipe =
        "ior = \"@.csv\"\n[[layer]]\nthickness_um = 5\n[[layer.flakes]]\n"
        "area_density_per_um = 0.1\nreflectance = 0.6\n"
        "orientation = { distribution = \"beckmann\", alpha = 0.3 }\n";
    std::string scene = "[environment]\ntype = \"constant\"\n";
    for (const char* name : {"a", "b"}) {
        folder.write(name + std::string(".csv"), "wavelength_nm,n\n380,1.5\n780,1.5\n");
        folder.write(name + std::string(".toml"), test::replaced(recipe, "@", name));
        scene +=
            test::replaced(
                test::replaced("[materials.@]\ntype = \"paint\"\nrecipe = \"@.toml\"\n", "@", name),
                "@", name) +
            test::replaced("[[shapes]]\ntype = \"sphere\"\nmaterial = \"@\"\n", "@", name);
    }
    const std::string file = folder.write("scene.toml", scene).string();
    std::vector<std::string> named;
    const References checked =
        References::of_file(file).checked_by([&](const std::filesystem::path& path) {
            named.push_back(path.filename().string());
            if (named.back() == "b.csv") throw std::runtime_error("is an output");
        });
    int steps = 0;
    const Progress count = [&](double) { return ++steps > 0; };
    EXPECT_THAT([&] { Scene(find_scene(file, checked), {.model = MicroflakeModel{}}, count); },
                testing::ThrowsMessage<std::runtime_error>("is an output"));
    EXPECT_THAT(named, testing::ElementsAre("a.toml", "b.toml", "a.csv", "b.csv"));
    EXPECT_EQ(steps, 0);
    // Of another picture of the scene nothing is read again.
    const Scene once(find_scene(file), {.model = MicroflakeModel{}}, count);
    EXPECT_GT(steps, 0);
    steps = 0;
    for (const char* gone : {"a.toml", "b.toml"}) std::filesystem::remove(folder / gone);
    const Scene again(find_scene(file), {.model = MicroflakeModel{}, .known = once.named_paints()},
                      count);
    EXPECT_EQ(again.sha256(), once.sha256());
}

TEST(Picture, APaintOfTheSlotIsNotTakenForTheFileThatItWasReadFrom) {
    const test::TempFolder folder;
    folder.write(
        "a.toml",
        "ior = 1.5\n[[layer]]\nthickness_um = 5\n[[layer.flakes]]\narea_density_per_um = 0.1\n"
        "reflectance = 0.6\norientation = { distribution = \"beckmann\", alpha = 0.3 }\n");
    const std::string file =
        folder
            .write("scene.toml",
                   "[environment]\ntype = \"constant\"\n"
                   "[materials.Slot]\ntype = \"paint\"\n"  // comes before the other
                   "[materials.named]\ntype = \"paint\"\nrecipe = \"a.toml\"\n"
                   "[[shapes]]\ntype = \"sphere\"\nmaterial = \"Slot\"\n"
                   "[[shapes]]\ntype = \"sphere\"\nmaterial = \"named\"\n")
            .string();
    const Paint read = open(folder / "a.toml"), slot = read.with(read.whole_key("alpha"), 0.4);
    const Scene once(find_scene(file), {.slot = slot, .model = MicroflakeModel{}});
    const Scene again(find_scene(file),
                      {.slot = slot, .model = MicroflakeModel{}, .known = once.named_paints()});
    EXPECT_EQ(once.paints().size(), 2u);
    EXPECT_EQ(once.named_paints().size(), 1u);
    EXPECT_EQ(again.recipe_sha256(), once.recipe_sha256());
    EXPECT_EQ(again.recipe_sha256().at("named"), read.recipe_sha256());
}

}  // namespace
}  // namespace nacre
