#include "nacre/render/scene_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "nacre/core/error.h"
#include "nacre/io/image.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/files.h"

namespace nacre::render {
namespace {

using nacre::test::message_of;
using nacre::test::replaced;
using ::testing::AllOf;
using ::testing::HasSubstr;

const std::string kScene = R"(name = "Test"
[camera]
position_mm = [0, -500, 100]
target_mm = [0, 0, 40]
vertical_fov_deg = 20
aperture_radius_mm = 2

[materials.paint]
type = "paint"

[materials.gray]
type = "diffuse"
reflectance = 0.4

[materials.pearl]
type = "paint"
recipe = "pearl.toml"

[[shapes]]
type = "sphere"
material = "paint"
radius_mm = 40
translation_mm = [0, 0, 40]

[[shapes]]
type = "mesh"
material = "pearl"
path = "car.glb"
mm_per_unit = 1000
y_up = true

[[shapes]]
type = "backdrop"
material = "gray"

[[lights]]
type = "rectangle"
center_mm = [0, -300, 600]
illuminant = "A"
scale = 3

[[lights]]
type = "directional"
to_light = [0, -1, 1]

[environment]
type = "studio"
scale = 0.5
[[environment.boxes]]
azimuth_deg = 30
width_deg = 20
)";

SceneDescription parse(const std::string& text) {
    return parse_scene(text, "scene.toml", "folder");
}

std::string error_of(const std::string& text) {
    return message_of<InputError>([&] { parse(text); });
}

TEST(SceneFile, ReadsCameraMaterialsShapesLightsAndEnvironment) {
    const SceneDescription scene = parse(kScene);
    EXPECT_EQ(scene.name, "Test");
    EXPECT_EQ(scene.camera.position_mm, (Vec3f{0, -500, 100}));
    EXPECT_EQ(scene.camera.aperture_radius_mm, 2);
    EXPECT_EQ(scene.camera.up, Camera().up);  // what is not said keeps its default
    ASSERT_EQ(scene.materials.size(), 3u);
    EXPECT_TRUE(std::get<PaintMaterial>(scene.materials.at("paint")).recipe.empty());
    EXPECT_EQ(std::get<PaintMaterial>(scene.materials.at("pearl")).recipe,
              std::filesystem::path("folder/pearl.toml"));
    EXPECT_EQ(std::get<DiffuseMaterial>(scene.materials.at("gray")).reflectance(550), 0.4);
    ASSERT_EQ(scene.shapes.size(), 3u);
    EXPECT_EQ(std::get<Sphere>(scene.shapes[0].geometry).radius_mm, 40);
    EXPECT_EQ(scene.shapes[0].transform.translation_mm, (Vec3f{0, 0, 40}));
    const auto& mesh = std::get<MeshFile>(scene.shapes[1].geometry);
    EXPECT_EQ(mesh.path, std::filesystem::path("folder/car.glb"));
    EXPECT_EQ(mesh.mm_per_unit, 1000);
    EXPECT_TRUE(mesh.y_up);
    EXPECT_TRUE(std::holds_alternative<Backdrop>(scene.shapes[2].geometry));
    ASSERT_EQ(scene.lights.size(), 2u);
    const auto& box = std::get<RectangleLight>(scene.lights[0]);
    EXPECT_EQ(box.radiance.illuminant, spectra::Illuminant::A);
    EXPECT_EQ(box.radiance.scale, 3);
    const auto& studio = std::get<StudioEnvironment>(*scene.environment);
    EXPECT_EQ(studio.radiance.scale, 0.5);
    ASSERT_EQ(studio.boxes.size(), 1u);
    EXPECT_EQ(studio.boxes[0].azimuth_deg, 30);
}

TEST(SceneFile, ReadsEveryKindOfShapeAndEnvironment) {
    int kinds = 0;
    for (const char* type : {"sphere", "flat-panel", "curved-panel", "speed-shape", "ground"}) {
        const SceneDescription scene =
            parse(replaced(kScene, "type = \"backdrop\"", std::string("type = \"") + type + "\""));
        EXPECT_NE(scene.shapes[2].geometry.index(), Geometry(Backdrop()).index());
        ++kinds;
    }
    EXPECT_EQ(kinds, 5);
    const std::string plain = kScene.substr(0, kScene.find("[environment]"));
    EXPECT_FALSE(parse(plain).environment);  // the lights are enough
    EXPECT_TRUE(std::holds_alternative<ConstantEnvironment>(
        *parse(plain + "[environment]\ntype = \"constant\"\nilluminant = \"E\"\n").environment));
    EXPECT_TRUE(std::holds_alternative<SkyEnvironment>(
        *parse(plain + "[environment]\ntype = \"sky\"\nturbidity = 4\n").environment));
}

TEST(SceneFile, ReadsAnEnvironmentPictureAlongWithTheScene) {
    const nacre::test::TempFolder folder;
    io::write_exr(folder / "sky.exr", {2, 1, {{"R", {1, 2}}, {"G", {3, 4}}, {"B", {5, 6}}}, {}});
    const std::string text = kScene.substr(0, kScene.find("[environment]")) +
                             "[environment]\ntype = \"image\"\npath = \"sky.exr\"\n";
    const SceneDescription scene = parse_scene(text, "scene.toml", folder);
    const auto& image = std::get<ImageEnvironment>(*scene.environment);
    EXPECT_EQ(image.width, 2);
    EXPECT_EQ(image.rgb, (std::vector<float>{1, 3, 5, 2, 4, 6}));
    EXPECT_THAT(error_of(text), AllOf(HasSubstr("environment.path = 'sky.exr'"), HasSubstr("sky")));
}

// As pictures of saturated paints have, which Nacre writes itself.
TEST(SceneFile, NegativeLightOfAnEnvironmentIsLeftOutIfItIsLittle) {
    const nacre::test::TempFolder folder;
    const std::string text = kScene.substr(0, kScene.find("[environment]")) +
                             "[environment]\ntype = \"image\"\npath = \"sky.exr\"\n";
    const auto write = [&](float green) {
        io::write_exr(folder / "sky.exr",
                      {2, 1, {{"R", {1, 2}}, {"G", {green, 4}}, {"B", {5, 6}}}, {}});
    };
    write(-0.01f);
    const SceneDescription scene = parse_scene(text, "scene.toml", folder);
    EXPECT_EQ(std::get<ImageEnvironment>(*scene.environment).rgb,
              (std::vector<float>{1, 0, 5, 2, 4, 6}));
    ASSERT_EQ(scene.notes.size(), 1u);
    EXPECT_THAT(scene.notes[0],
                AllOf(HasSubstr("sky.exr: 1 of 6 values are negative"), HasSubstr("0.056 %")));
    write(-1);  // a difference of pictures is no light
    EXPECT_THROW(parse_scene(text, "scene.toml", folder), InputError);
    write(3);
    EXPECT_TRUE(parse_scene(text, "scene.toml", folder).notes.empty());
}

TEST(SceneFile, MayBeKeptToItsFolder) {
    const nacre::test::TempFolder folder;
    const auto error = [&](const std::string& from, const std::string& to) {
        try {
            parse_scene(replaced(kScene, from, to), "scene.toml", References::within(folder));
        } catch (const InputError& e) {
            return std::string(e.what());
        }
        return std::string("accepted");
    };
    EXPECT_EQ(error("car.glb", "meshes/car.glb"), "accepted");
    EXPECT_THAT(error("car.glb", "../car.glb"),
                AllOf(HasSubstr("scene.toml:"), HasSubstr("shapes[1].path = '../car.glb'"),
                      HasSubstr("is outside the folder")));
    EXPECT_THAT(error("pearl.toml", "/etc/pearl.toml"),
                AllOf(HasSubstr("materials.pearl.recipe"), HasSubstr("is outside the folder")));
    EXPECT_THAT(error(kScene.substr(kScene.find("[environment]")),
                      "[environment]\ntype = \"image\"\npath = \"/dev/zero\"\n"),
                AllOf(HasSubstr("environment.path"), HasSubstr("is outside the folder")));
    const SceneDescription scene = parse_scene(kScene, "scene.toml", References::within(folder));
    EXPECT_EQ(scene.references, References::within(folder)) << "for the recipes that it names";
    EXPECT_THROW(parse_scene(kScene, "scene.toml", {}), InputError);
}

TEST(SceneFile, IsToldFromARecipe) {
    const std::string recipe = "ior = 1.5\n[[layer]]\nthickness_um = 1\n";
    EXPECT_EQ(error_of(recipe),
              "scene.toml: is a recipe; needed here is a scene, whose paint it may be");
    EXPECT_THAT(error_of("ior = 1.5\n" + kScene), HasSubstr("ior = 1.5: unknown key"));
}

struct BadScene {
    const char* from;
    const char* to;
    const char* place;
    const char* key;
    const char* expected;
};

class BadScenes : public ::testing::TestWithParam<BadScene> {};

TEST_P(BadScenes, AreRefusedNamingPlaceKeyValueAndRange) {
    const BadScene& bad = GetParam();
    const std::string message = error_of(replaced(kScene, bad.from, bad.to));
    EXPECT_THAT(message, HasSubstr(std::string("scene.toml:") + bad.place));
    EXPECT_THAT(message, AllOf(HasSubstr(bad.key), HasSubstr(bad.expected)));
}

const BadScene kBadScenes[] = {
    {"[camera]", "[camra]", "2:2", "camra = {...}", "did you mean 'camera'?"},
    {"vertical_fov_deg", "vertical_fov", "5:1", "camera.vertical_fov = 20",
     "did you mean 'vertical_fov_deg'?"},
    {"vertical_fov_deg = 20", "vertical_fov_deg = 200", "5:20", "camera.vertical_fov_deg = 200",
     "179"},
    {"vertical_fov_deg = 20", "vertical_fov_deg = nan", "5:20", "camera.vertical_fov_deg = nan",
     "must be a number"},
    {"[0, -500, 100]", "[0, -500]", "3:15", "camera.position_mm = [...]", "3 numbers"},
    {"[0, -500, 100]", "[0, \"x\", 100]", "3:19", "camera.position_mm[1] = 'x'", "a number"},
    {"[0, 0, 40]\nvertical", "[0, -500, 100]\nvertical", "4:13", "camera.target_mm", "same point"},
    {"type = \"diffuse\"", "type = \"metal\"", "12:8", "materials.gray.type = 'metal'",
     "one of: diffuse, paint"},
    {"type = \"diffuse\"\n", "", "11:1", "materials.gray.type", "is missing"},
    {"reflectance = 0.4", "reflectance = 1.4", "13:15", "materials.gray.reflectance = 1.4",
     "[0, 1]"},
    {"reflectance = 0.4", "recipe = \"a\"", "13:1", "materials.gray.recipe = 'a'", "unknown key"},
    {"\"sphere\"", "\"cube\"", "20:8", "shapes[0].type = 'cube'", "one of: sphere, mesh"},
    {"radius_mm = 40", "radius = 40", "22:1", "shapes[0].radius = 40", "did you mean 'radius_mm'?"},
    {"radius_mm = 40", "radius_mm = -40", "22:13", "shapes[0].radius_mm = -40", "mm"},
    {"material = \"paint\"", "material = \"wood\"", "21:12", "shapes[0].material = 'wood'",
     "gray, paint, pearl"},
    {"material = \"paint\"\n", "", "19:1", "shapes[0].material", "is missing"},
    {"path = \"car.glb\"\n", "", "25:1", "shapes[1].path", "is missing"},
    {"y_up = true", "y_up = 1", "30:8", "shapes[1].y_up = 1", "true or false"},
    {"illuminant = \"A\"", "illuminant = \"D99\"", "39:14", "lights[0].illuminant = 'D99'", "D65"},
    {"scale = 3", "scale = -3", "40:9", "lights[0].scale = -3", "[0, "},
    {"to_light = [0, -1, 1]", "to_light = [0, 0, 0]", "44:12", "lights[1].to_light",
     "has no length"},
    {"\"studio\"", "\"disco\"", "47:8", "environment.type = 'disco'",
     "one of: constant, studio, sky, image"},
    {"azimuth_deg = 30", "azimuth = 30", "50:1", "environment.boxes[0].azimuth = 30",
     "did you mean 'azimuth_deg'?"},
    {"width_deg = 20", "width_deg = 200", "51:13", "environment.boxes[0].width_deg = 200", "170"},
};

INSTANTIATE_TEST_SUITE_P(Matrix, BadScenes, ::testing::ValuesIn(kBadScenes));

TEST(SceneFile, RefusesScenesWithoutShapesOrLight) {
    EXPECT_THAT(error_of("name = \"empty\"\n"), HasSubstr("shapes: is missing"));
    EXPECT_THAT(error_of("[materials.g]\ntype = \"diffuse\"\nreflectance = 0.5\n[[shapes]]\n"
                         "type = \"sphere\"\nmaterial = \"g\"\n"),
                HasSubstr("environment: is missing"));
}

}  // namespace
}  // namespace nacre::render
