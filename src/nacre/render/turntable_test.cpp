#include "nacre/render/turntable.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "nacre/bsdf/models/lambertian.h"
#include "nacre/core/error.h"
#include "nacre/render/builtin_scenes.h"
#include "nacre/render/render.h"

namespace nacre::render {
namespace {

using ::testing::ElementsAre;
using ::testing::FloatNear;
using ::testing::HasSubstr;
using ::testing::Pair;
using ::testing::ThrowsMessage;

constexpr float kClose_mm = 1e-3f;

TEST(Turntable, TurnsAboutTheVerticalThroughTheTarget) {
    SceneDescription scene = builtin_scene("curved-panel");
    scene.camera.target_mm = {10, 20, 30};
    scene.shapes.back().transform.translation_mm = {110, 20, 5};
    const SceneDescription quarter = turned(scene, Turning::shape, 90);
    const Transform& transform = quarter.shapes.back().transform;
    EXPECT_NEAR(transform.translation_mm.x, 10, kClose_mm);
    EXPECT_NEAR(transform.translation_mm.y, 120, kClose_mm);
    EXPECT_NEAR(transform.translation_mm.z, 5, kClose_mm);
    EXPECT_NEAR(transform.rotation_deg.z, scene.shapes.back().transform.rotation_deg.z + 90, 1e-4);
    EXPECT_EQ(quarter.shapes[0], scene.shapes[0]);  // the backdrop
    EXPECT_EQ(quarter.camera, scene.camera);
    EXPECT_EQ(quarter.environment, scene.environment);
    EXPECT_THAT(quarter.turned_deg, ElementsAre(Pair("shape", 90)));
}

TEST(Turntable, AWholeTurnLeadsBack) {
    for (const char* name : {"sphere", "curved-panel", "macro", "panel-sun"}) {
        for (const Turning what : {Turning::shape, Turning::camera, Turning::light}) {
            const SceneDescription scene = builtin_scene(name);
            SceneDescription round = scene;
            for (int i = 0; i < 8; ++i) round = turned(std::move(round), what, 45);
            validate(round);
            EXPECT_THAT(length(round.camera.position_mm - scene.camera.position_mm),
                        FloatNear(0, kClose_mm));
            for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
                const Transform &a = scene.shapes[i].transform, &b = round.shapes[i].transform;
                EXPECT_THAT(length(a.translation_mm - b.translation_mm), FloatNear(0, kClose_mm));
                EXPECT_NEAR(std::remainder(a.rotation_deg.z - b.rotation_deg.z, 360), 0, 1e-3);
            }
        }
    }
}

// Only what stands to each other shows: the camera turned one way is all else turned the other.
TEST(Turntable, TheCameraTurnedIsAllElseTurnedBack) {
    const PaintTable paint = {
        {"paint", std::make_shared<bsdf::Lambertian>(spectra::Spectrum(0.5))}};
    const SceneDescription scene = builtin_scene("macro");
    const RenderOptions options{.width = 24, .height = 24, .samples_per_pixel = 64};
    const auto mean = [&](const SceneDescription& turned_scene) {
        const RenderResult result = render(Scene(turned_scene, paint), options);
        double sum = 0;
        for (const float value : result.rgb) sum += value;
        return sum / static_cast<double>(result.rgb.size());
    };
    const double camera = mean(turned(scene, Turning::camera, 35));
    const double others = mean(turned(turned(scene, Turning::shape, -35), Turning::light, -35));
    EXPECT_NEAR(camera, others, 0.01 * camera);
}

TEST(Turntable, RefusesWhatCannotTurn) {
    SceneDescription scene = builtin_scene("sphere");
    scene.environment = ConstantEnvironment{};
    EXPECT_THAT([&] { turned(scene, Turning::light, 10); },
                ThrowsMessage<DomainError>(HasSubstr("no light that could turn")));
    scene.materials["paint"] = DiffuseMaterial{};
    EXPECT_THAT([&] { turned(scene, Turning::shape, 10); },
                ThrowsMessage<DomainError>(HasSubstr("no painted shape")));
}

}  // namespace
}  // namespace nacre::render
