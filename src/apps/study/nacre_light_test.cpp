#include <gtest/gtest.h>

#include <cmath>

#include "nacre/bsdf/models/nacre.h"
#include "nacre/core/estimate.h"
#include "nacre/core/file.h"
#include "nacre/io/recipe_file.h"
#include "nacre/render/render.h"
#include "nacre/render/scene.h"
#include "nacre/solver/solver.h"

// The mean light of flakes that flash does not depend on whether lights or flakes are sampled.

namespace nacre::study {
namespace {

using render::DirectLight;

std::shared_ptr<const bsdf::Bsdf> sparkling() {
    const auto solved = std::make_shared<const solver::SolvedPaint>(solver::solve(
        io::read_recipe(shipped_file("paints/metallic-silver.toml")), {450, 500, 550, 600, 650}));
    return std::make_shared<const bsdf::Nacre>(solved, bsdf::NacreModel{.specimen = 3});
}

// A panel so close that each patch holds a flake or two.
render::SceneDescription close_up() {
    render::SceneDescription scene;
    scene.materials["paint"] = render::PaintMaterial{};
    scene.shapes.push_back({render::FlatPanel{}, "paint", {}});
    scene.camera = {.position_mm = {0, -30, 40}, .up = {0, 1, 0}, .vertical_fov_deg = 1};
    return scene;
}

render::Light lamp(float size_mm) {
    return render::RectangleLight{.center_mm = {10, 300, 400},
                                  .width_mm = size_mm,
                                  .height_mm = size_mm,
                                  .radiance = {.scale = 1e5 / (size_mm * size_mm)}};
}

// Mean luminance of the picture by independent renders of the same flakes.
Estimate luminance(const render::Scene& scene, DirectLight how) {
    constexpr int kRenders = 16;
    render::RenderOptions options{
        .width = 32, .height = 32, .samples_per_pixel = 16, .footprint_pixels = 0.5};
    // A path that samples the surface sees the lamp as its next vertex.
    options.max_depth = how == DirectLight::light_sampling ? 3 : 4;
    double sum = 0, squares = 0;
    for (int i = 0; i < kRenders; ++i) {
        options.seed = static_cast<std::uint64_t>(i);
        const auto picture = render::render_with(scene, options, how);
        double y = 0;
        for (std::size_t p = 0; p < picture.rgb.size(); p += 3) y += picture.rgb[p + 1];
        y /= static_cast<double>(picture.rgb.size() / 3);
        sum += y;
        squares += y * y;
    }
    return estimate_of_mean(sum, squares, kRenders);
}

void expect_agreement(const render::SceneDescription& description, const char* name) {
    SCOPED_TRACE(name);
    const render::Scene scene(description, {{"paint", sparkling()}});
    const Estimate all = luminance(scene, DirectLight::combined);
    const Estimate light = luminance(scene, DirectLight::light_sampling);
    const Estimate surface = luminance(scene, DirectLight::surface_sampling);
    EXPECT_GT(all.value, 0.01);
    EXPECT_LT(all.standard_error, 0.02 * all.value);
    // 4 combined standard errors: exceeded once in some 10 000 times.
    EXPECT_NEAR(all.value, light.value, 4 * std::hypot(all.standard_error, light.standard_error));
    EXPECT_NEAR(all.value, surface.value,
                4 * std::hypot(all.standard_error, surface.standard_error));
    // The combination is nearly as good as the better of the two.
    EXPECT_LT(all.standard_error, 1.5 * std::min(light.standard_error, surface.standard_error));
}

TEST(NacreUnderLights, EstimatorsAgreeInACloseUp) {
    auto scene = close_up();
    scene.lights.push_back(lamp(20));
    expect_agreement(scene, "2 deg");
}

// A panel that reflects a sphere of the same paint, both seen flake by flake.
TEST(NacreUnderLights, EstimatorsAgreeOnASphereReflectedInAPanel) {
    auto scene = close_up();
    scene.shapes.push_back(
        {render::Sphere{.radius_mm = 10}, "paint", {.translation_mm = {0, 15, 20}}});
    scene.lights.push_back(lamp(300));
    scene.environment = render::ConstantEnvironment{.radiance = {.scale = 0.2}};
    expect_agreement(scene, "sphere in panel");
}

}  // namespace
}  // namespace nacre::study
