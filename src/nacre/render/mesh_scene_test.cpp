#include "nacre/render/mesh_scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "nacre/core/error.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/files.h"

namespace nacre::render {
namespace {

using nacre::test::message_of;
using nlohmann::json;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// Three triangles of three materials; a camera one metre before the origin, turned by its parent.
json car() {
    const char* const triangle =
        "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
    json primitives = json::array();
    for (int material = 0; material < 3; ++material) {
        primitives.push_back({{"attributes", {{"POSITION", 0}}}, {"material", material}});
    }
    return {{"asset", {{"version", "2.0"}}},
            {"scene", 0},
            {"scenes", {{{"nodes", {0, 1}}}}},
            {"nodes",
             {{{"mesh", 0}},
              // A quarter turn about y: the child's z becomes x.
              {{"children", {2}}, {"rotation", {0, std::sqrt(0.5), 0, std::sqrt(0.5)}}},
              {{"camera", 0}, {"translation", {0, 0.5, 2}}}}},
            {"cameras",
             {{{"name", "front"}, {"type", "perspective"}, {"perspective", {{"yfov", 0.5}}}}}},
            {"materials",
             {{{"name", "body"}},
              {{"name", "rim"},
               {"pbrMetallicRoughness",
                {{"baseColorFactor", {0.9, 0.6, 0.5, 1}}, {"roughnessFactor", 0.5}}}},
              {{"name", "window"},
               {"alphaMode", "BLEND"},
               {"pbrMetallicRoughness", {{"baseColorFactor", {0, 0, 0, 0.3}}}}}}},
            {"meshes", {{{"primitives", primitives}}}},
            {"buffers", {{{"byteLength", 36}, {"uri", triangle}}}},
            {"bufferViews", {{{"buffer", 0}, {"byteLength", 36}}}},
            {"accessors",
             {{{"bufferView", 0},
               {"componentType", 5126},
               {"count", 3},
               {"type", "VEC3"},
               {"min", {0, 0, 0}},
               {"max", {1, 1, 0}}}}}};
}

class MeshScene : public ::testing::Test {
 protected:
    std::filesystem::path write(const std::string& name, const json& gltf) {
        return folder_.write(name, gltf.dump());
    }
    nacre::test::TempFolder folder_;
};

TEST_F(MeshScene, TakesPartsMaterialsAndTheCameraOfAGltf) {
    const SceneDescription scene = scene_of_mesh(write("car.gltf", car()), {.painted = {"body"}});
    ASSERT_EQ(scene.shapes.size(), 3u);
    EXPECT_EQ(std::get<MeshFile>(scene.shapes[1].geometry).part, "rim");
    EXPECT_TRUE(std::holds_alternative<PaintMaterial>(scene.materials.at("body")));
    const auto& rim = std::get<ConductorMaterial>(scene.materials.at("rim"));
    EXPECT_EQ(rim.metal.name(), "Cu");
    EXPECT_DOUBLE_EQ(rim.roughness, 0.25);
    EXPECT_GT(std::get<GlassMaterial>(scene.materials.at("window")).pane_mm, 0);
    // Two metres along the child's z, which is x; its y is up, our z.
    EXPECT_NEAR(scene.camera.position_mm.x, 2000, 1e-2);
    EXPECT_NEAR(scene.camera.position_mm.y, 0, 1e-2);
    EXPECT_NEAR(scene.camera.position_mm.z, 500, 1e-2);
    EXPECT_NEAR(scene.camera.up.z, 1, 1e-6);
    const Vec3f line = normalize(scene.camera.target_mm - scene.camera.position_mm);
    EXPECT_NEAR(line.x, -1, 1e-6);
    EXPECT_NEAR(scene.camera.vertical_fov_deg, 0.5 * 180 / M_PI, 1e-9);
    EXPECT_TRUE(scene.notes.empty());
}

TEST_F(MeshScene, WithoutACameraAllIsSeenAndOnePartIsThePaint) {
    json gltf = car();
    gltf["nodes"].erase(2);
    gltf["nodes"].erase(1);
    gltf["scenes"][0]["nodes"] = {0};
    gltf["meshes"][0]["primitives"].erase(2);
    gltf["meshes"][0]["primitives"].erase(1);
    const SceneDescription scene = scene_of_mesh(write("one.gltf", gltf), {});
    ASSERT_EQ(scene.materials.size(), 1u);
    EXPECT_TRUE(std::holds_alternative<PaintMaterial>(scene.materials.at("body")));
    const Vec3f middle{500, 0, 500};
    EXPECT_LT(length(scene.camera.target_mm - middle), 1);
    EXPECT_GT(length(scene.camera.position_mm - middle), 1500);
}

TEST_F(MeshScene, SaysWhatItChoseAndRefusesWhatDoesNotExist) {
    const auto path = write("car.gltf", car());
    EXPECT_THAT(scene_of_mesh(path, {}).notes,
                ElementsAre(HasSubstr("--painted NAME says which of body, rim, window")));
    EXPECT_THAT(message_of<InputError>([&] { scene_of_mesh(path, {.painted = {"bodi"}}); }),
                AllOf(HasSubstr("car.gltf"), HasSubstr("no part 'bodi'"), HasSubstr("window")));
    EXPECT_THAT(message_of<InputError>([&] { scene_of_mesh(path, {.camera = "rear"}); }),
                HasSubstr("no camera 'rear'; it has front"));
    json wrong = car();
    wrong["materials"][1]["pbrMetallicRoughness"]["baseColorFactor"] = {1, 2};
    EXPECT_THAT(message_of<InputError>([&] { scene_of_mesh(write("w.gltf", wrong), {}); }),
                HasSubstr("baseColorFactor has 2 numbers, not 4"));
    wrong = car();
    wrong["nodes"][2]["camera"] = 7;
    EXPECT_THAT(message_of<InputError>([&] { scene_of_mesh(write("w.gltf", wrong), {}); }),
                HasSubstr("camera that it does not have"));
}

}  // namespace
}  // namespace nacre::render
