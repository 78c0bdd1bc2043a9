#include "nacre/render/scene_description.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "nacre/core/error.h"
#include "nacre/io/described_toml.h"
#include "nacre/testing/described.h"
#include "nacre/testing/errors.h"

namespace nacre::render {
namespace {

using nacre::test::EveryKey;
using nacre::test::KeyOfObject;
using nacre::test::message_of;
using paint::Described;
using ::testing::AllOf;
using ::testing::HasSubstr;

/// One of everything but the environment.
SceneDescription full_scene() {
    SceneDescription scene;
    scene.name = "all";
    scene.materials = {{"gray", DiffuseMaterial{0.4}},
                       {"pearl", PaintMaterial{"pearl.toml"}},
                       {"chrome", ConductorMaterial{optics::find_material("Cr")}},
                       {"window", GlassMaterial{}},
                       {"rubber", PlasticMaterial{0.03}}};
    for (const Geometry& geometry :
         {Geometry(Sphere()), Geometry(MeshFile{.path = "car.obj"}), Geometry(FlatPanel()),
          Geometry(CurvedPanel()), Geometry(SpeedShape()), Geometry(Backdrop()),
          Geometry(GroundPlane())}) {
        scene.shapes.push_back({geometry, "gray", {}});
    }
    scene.lights = {RectangleLight(), DirectionalLight()};
    return scene;
}

std::vector<SceneDescription> full_scenes() {
    std::vector<SceneDescription> scenes(4, full_scene());
    scenes[0].environment = ConstantEnvironment();
    scenes[1].environment = StudioEnvironment{.boxes = {SoftBox()}};
    scenes[2].environment = SkyEnvironment();
    scenes[3].environment = ImageEnvironment{1, 1, {1, 1, 1}};
    scenes[3].materials["tiles"] = DiffusePictureMaterial{1, 1, {1, 1, 1}};
    return scenes;
}

std::string refusal(const SceneDescription& scene) {
    return message_of<DomainError>([&] { validate(scene); });
}

/// The scene as it is read, without its pictures.
SceneDescription parsed(const std::string& text) {
    io::TomlDocument document(text, "scene.toml", References::anywhere(""));
    SceneDescription scene;
    const Described described(scene);
    io::read_described(io::TableReader(document, keys_of(described)), described);
    return scene;
}

std::string reader_error(const std::string& text) {
    return message_of<InputError>([&] { parsed(text); });
}

TEST(SceneDescriptionKeys, EveryNumberOutsideItsRangeIsRefused) {
    int refused = 0;
    for (const SceneDescription& scene : full_scenes()) {
        EXPECT_EQ(refusal(scene), "accepted");
        EveryKey all;
        Described::to_inspect(scene).accept(all);
        for (const KeyOfObject& key : all.keys) {
            if (!key.is_number) continue;
            for (const double value : nacre::test::values_outside(key.field.range)) {
                if (key.field.zero && value == 0) continue;
                SceneDescription wrong = scene;
                EveryKey change(key.path, value);
                describe(change, wrong);
                EXPECT_EQ(change.changes, 1) << key.path;
                EXPECT_EQ(refusal(wrong), fmt::format("{} = {} is outside {}", key.path, value,
                                                      key.field.range.text()));
                if (std::holds_alternative<ImageEnvironment>(*scene.environment)) continue;
                EXPECT_THAT(reader_error(io::write_described(Described(wrong))),
                            AllOf(HasSubstr("scene.toml:"), HasSubstr(": " + key.path),
                                  HasSubstr(fmt::format(" = {}: must be ", value)),
                                  HasSubstr(key.field.range.text())));
                ++refused;
            }
        }
    }
    EXPECT_GE(refused, 3 * 2 * 50);
}

// Each key that the description names is read: the value that was changed comes back.
TEST(SceneDescriptionKeys, EveryKeyIsWrittenAndRead) {
    int changes = 0;
    for (SceneDescription& scene : full_scenes()) {
        if (std::holds_alternative<ImageEnvironment>(*scene.environment)) continue;
        EXPECT_EQ(parsed(io::write_described(Described(scene))), scene);
        EveryKey all;
        describe(all, scene);
        for (const KeyOfObject& key : all.keys) {
            if (key.is_settled) continue;
            SceneDescription changed = scene;
            EveryKey change(key.path);
            describe(change, changed);
            EXPECT_NE(changed, scene) << key.path;
            EXPECT_EQ(parsed(io::write_described(Described(changed))), changed) << key.path;
            ++changes;
        }
    }
    EXPECT_GE(changes, 3 * 60);
}

TEST(SceneDescriptionKeys, TheDocumentationHasItsTables) {
    SceneDescription scene = full_scene();
    DiffuseMaterial diffuse;
    PaintMaterial paint;
    DiffusePictureMaterial diffuse_picture;
    ConductorMaterial conductor;
    GlassMaterial glass;
    PlasticMaterial plastic;
    RectangleLight rectangle;
    DirectionalLight directional;
    Environment environment;
    ConstantEnvironment constant;
    StudioEnvironment studio;
    SoftBox box;
    SkyEnvironment sky;
    ImageEnvironment image;
    std::vector<std::pair<std::string, Described>> tables = {
        {"scene", Described(scene)},
        {"camera", Described(scene.camera)},
        {"diffuse", Described(diffuse)},
        {"paint", Described(paint)},
        {"diffuse-picture", Described(diffuse_picture)},
        {"conductor", Described(conductor)},
        {"glass", Described(glass)},
        {"plastic", Described(plastic)},
        {"shape", Described(scene.shapes[0])},
        {"rectangle", Described(rectangle)},
        {"directional", Described(directional)},
        {"constant", Described(constant)},
        {"studio", Described(studio)},
        {"box", Described(box)},
        {"sky", Described(sky)},
        {"image", Described(image)}};
    const char* shapes[] = {"sphere",      "mesh",     "flat-panel", "curved-panel",
                            "speed-shape", "backdrop", "ground"};
    for (std::size_t i = 0; i < std::size(shapes); ++i) {
        std::visit([&](auto& shape) { tables.emplace_back(shapes[i], Described(shape)); },
                   scene.shapes[i].geometry);
    }
    for (const auto& [name, object] : tables) {
        const std::string expected = markdown_table(object);
        EXPECT_EQ(nacre::test::documented_table("scene.md", name, expected), expected)
            << "run this test with NACRE_WRITE_DOCS=1";
    }
}

}  // namespace
}  // namespace nacre::render
