#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "nacre/core/parallel.h"
#include "nacre/core/random.h"
#include "nacre/spectra/rgb.h"
#include "nacre/testing/directions.h"
#include "nacre/testing/plain_flakes.h"
#include "nacre/testing/render.h"
#include "nacre/testing/statistics.h"

// The model nacre on whole shapes: the same statistics at any place and orientation, under any
// light.

namespace nacre::models {
namespace {

using test::Moments;

using test::direction;

/// A square of a sphere of 500 mm about where its normal is n, turned by an angle in its plane: so
/// large that squares at random places of a region hardly overlap, and are independent.
bsdf::Patch square(Vec3f n, float side_mm, double turn) {
    const Frame frame = Frame::around(n);
    const Vec3f along = frame.to_world(direction(90, turn));
    bsdf::Patch patch;
    patch.footprint = {500.0f * n, n, frame.s, {side_mm * along, side_mm * cross(n, along)}};
    return patch;
}

TEST(NacreOnShapes, MeanAndVarianceAreThoseOfAFlatPanelAllOverASphere) {
    // Where one, two and three of the planes of object space give the flakes.
    struct Region {
        const char* name;
        bool (*holds)(const std::array<float, 3>& squares);  // of the normal's parts, ascending
    };
    constexpr std::array<Region, 4> kRegions{{
        {"along an axis", [](const auto& s) { return s[2] > 0.98f; }},
        {"between, one axis", [](const auto& s) { return s[2] > 0.6f && s[2] < 0.8f; }},
        {"at an edge", [](const auto& s) { return s[2] - s[1] < 0.03f && s[0] < 0.1f; }},
        {"at a corner", [](const auto& s) { return s[2] - s[0] < 0.06f; }},
    }};
    constexpr int kPatches = 20000;
    const testing::PlainFlakes flakes{.diameter_um = 6};
    const auto surface = testing::nacre_surface(testing::recipe_of(flakes), 3);
    const auto bound = surface->bind({550, 550, 550, 550, 550, 550, 550, 550});
    const Vec3f wi = direction(30, 20), wo = direction(24, 205);
    const double mean = bound->eval(wi, wo)[0];
    // A few flakes, and so many that only some levels are resolved.
    for (float side_mm : {0.015f, 0.15f}) {
        Rng rng(5, 1);
        const auto values = [&](auto&& normal) {
            std::vector<double> v(kPatches);
            for (double& value : v) {
                const bsdf::Patch patch = square(normal(), side_mm, 360 * rng.uniform_float());
                value = bound->evaluate_on(patch, wi, wo).f[0] / mean;
            }
            return Moments(v);
        };
        const auto anywhere = [&] {
            return direction(180 / std::numbers::pi * std::acos(1 - 2 * rng.uniform_float()),
                             360 * rng.uniform_float());
        };
        // The panel: patches of one plane, far apart.
        std::vector<double> v(kPatches);
        for (double& value : v) {
            bsdf::Patch patch = square({0, 0, 1}, side_mm, 360 * rng.uniform_float());
            patch.footprint.position_mm = {500 * rng.uniform_float(), 500 * rng.uniform_float(), 0};
            value = bound->evaluate_on(patch, wi, wo).f[0] / mean;
        }
        const Moments panel(v);
        EXPECT_GT(panel.variance, 10 * panel.variance_error);
        EXPECT_NEAR(panel.mean, 1, 3 * panel.mean_error);
        for (const Region& region : kRegions) {
            const Moments here = values([&] {
                for (;;) {
                    const Vec3f n = anywhere();
                    std::array<float, 3> s{n.x * n.x, n.y * n.y, n.z * n.z};
                    std::sort(s.begin(), s.end());
                    if (region.holds(s)) return n;
                }
            });
            EXPECT_NEAR(here.mean, 1, 3 * here.mean_error) << region.name << ", " << side_mm;
            EXPECT_NEAR(here.variance, panel.variance,
                        3 * std::hypot(here.variance_error, panel.variance_error))
                << region.name << ", " << side_mm;
        }
    }
}

/// A ball of paint in the middle of the world, close enough to see its flakes.
render::SceneDescription ball() {
    render::SceneDescription scene;
    scene.materials["paint"] = render::PaintMaterial{};
    scene.shapes.push_back({render::Sphere{.radius_mm = 1}, "paint", {}});
    scene.camera = {.position_mm = {0, -30, 8}, .vertical_fov_deg = 4};
    return scene;
}

double luminance(const render::RenderResult& r, std::size_t pixel) {
    const float* const rgb = &r.rgb[3 * pixel];
    return spectra::rec709_luminance<double>(rgb[0], rgb[1], rgb[2]);
}

TEST(NacreOnShapes, FlakesTurnWithTheirShape) {
    // With one sample a pixel and light from one direction there is no noise. Ball, lamp and camera
    // turned alike show the same flakes.
    const render::PaintTable paints{
        {"paint", testing::nacre_surface(testing::recipe_of({.diameter_um = 20}), 1)}};
    const auto picture = [&](const render::Transform& turn) {
        const render::AffineMap map(turn);
        render::SceneDescription scene = ball();
        scene.shapes[0].transform = turn;
        scene.camera.position_mm = map.point(scene.camera.position_mm);
        scene.camera.target_mm = map.point({});
        scene.camera.up = map.direction({0, 0, 1});
        scene.lights.push_back(
            render::DirectionalLight{.to_light = map.direction({0.3f, -0.8f, 0.5f})});
        return render::render_with(
            render::Scene(scene, paints),
            {.width = 64, .height = 64, .samples_per_pixel = 1, .max_depth = 1},
            render::DirectLight::light_sampling);
    };
    const render::RenderResult still = picture({});
    const render::RenderResult turned =
        picture({.rotation_deg = {70, -35, 120}, .translation_mm = {3, 5, -2}});
    double difference = 0, contrast = 0, mean = 0;
    int pixels = 0;
    for (std::size_t p = 0; p < still.alpha.size(); ++p) {
        if (luminance(still, p) == 0) continue;
        mean += luminance(still, p);
        difference += std::abs(luminance(turned, p) - luminance(still, p));
        ++pixels;
    }
    mean /= pixels;
    for (std::size_t p = 0; p < still.alpha.size(); ++p) {
        if (luminance(still, p) > 0) contrast += std::abs(luminance(still, p) - mean);
    }
    EXPECT_GT(pixels, 1000);
    EXPECT_GT(contrast / pixels, 0.3 * mean);  // flakes are there
    EXPECT_LT(difference, 0.01 * contrast);    // and the same ones: but for rounding
}

// Four standard errors over 16 seeds. Lights that fill different parts of a flake's lobe: a studio
// all around, a window, and a lamp as small as the sun, which surface sampling alone hardly finds.
TEST(NacreOnShapes, EstimatorsOfDirectLightAgree) {
    struct Case {
        std::string name;
        render::SceneDescription scene;
        double side_mm;  // of a lamp at 100 mm
        int samples;     // the fewer flakes reflect, the more
        bool surface_alone;
    };
    std::vector<Case> cases{{"studio", ball(), 0, 8, true},
                            {"window", ball(), 60, 8, true},
                            {"lamp of 0.53 deg", ball(), 0.925, 48, false}};
    const render::PaintTable paints{
        {"paint", testing::nacre_surface(testing::recipe_of({.diameter_um = 20}), 1)}};
    for (Case& c : cases) {
        SCOPED_TRACE(c.name);
        if (c.side_mm == 0) c.scene.environment = render::StudioEnvironment{};
        if (c.side_mm > 0) {
            c.scene.lights.push_back(render::RectangleLight{
                .center_mm = {36, -80, 48}, .width_mm = c.side_mm, .height_mm = c.side_mm});
        }
        const render::Scene scene(c.scene, paints);
        // Footprints of whole pixels, so that samples of one pixel see the same flakes.
        const render::RenderOptions options{
            .width = 24, .height = 24, .samples_per_pixel = c.samples, .footprint_pixels = 1};
        const auto estimate = [&](render::DirectLight how) {
            return render::testing::estimate_luminance(scene, options, how, 16);
        };
        const auto all = estimate(render::DirectLight::combined);
        EXPECT_GT(all.value, 0);
        EXPECT_LT(all.standard_error, 0.04 * all.value);
        const auto light = estimate(render::DirectLight::light_sampling);
        EXPECT_NEAR(all.value, light.value,
                    4 * std::hypot(all.standard_error, light.standard_error));
        if (!c.surface_alone) continue;
        const auto surface = estimate(render::DirectLight::surface_sampling);
        EXPECT_NEAR(all.value, surface.value,
                    4 * std::hypot(all.standard_error, surface.standard_error));
    }
}

// The light of single flakes averages to 0 over many specimens of a paint, seen directly and in the
// specular reflection of a clearcoated panel: three standard errors.
TEST(NacreOnShapes, SparkleIsZeroOnAverageAlsoInSpecularReflection) {
    constexpr int kPaints = 16;
    const paint::Recipe recipe = testing::recipe_of({.diameter_um = 20});
    std::array<std::vector<double>, 2> means;
    double light = 0;
    for (int seed = 0; seed < kPaints; ++seed) {
        render::SceneDescription scene = ball();
        scene.environment = render::StudioEnvironment{};
        scene.materials["panel"] = render::PaintMaterial{};
        scene.shapes[0].transform.translation_mm = {0, 0, 1.1f};
        scene.shapes.push_back({render::FlatPanel{.width_mm = 8, .height_mm = 8}, "panel", {}});
        const auto paint = testing::nacre_surface(recipe, static_cast<std::uint64_t>(seed));
        const auto picture =
            render::render(render::Scene(scene, {{"paint", paint}, {"panel", paint}}),
                           {.width = 32,
                            .height = 32,
                            .samples_per_pixel = 8,
                            .seed = static_cast<std::uint64_t>(seed),
                            .sparkle = true});
        std::array<double, 2> sums{};
        for (std::size_t p = 0; p < picture.alpha.size(); ++p) {
            // Below, the panel that reflects the ball; above, the ball.
            sums[p < picture.alpha.size() / 2] += picture.sparkle[3 * p + 1] / 512;
            light += picture.rgb[3 * p + 1] / 1024 / kPaints;
        }
        means[0].push_back(sums[0]);
        means[1].push_back(sums[1]);
    }
    for (const std::vector<double>& half : means) {
        const Moments m(half);
        EXPECT_NEAR(m.mean, 0, 3 * m.mean_error);
        EXPECT_LT(m.mean_error, 0.05 * light);
        EXPECT_GT(m.mean_error, 0);
    }
}

TEST(NacreOnShapes, SameBitsForAnyNumberOfThreads) {
    render::SceneDescription scene = ball();
    scene.environment = render::StudioEnvironment{};
    const render::Scene compiled(
        scene, {{"paint", testing::nacre_surface(testing::recipe_of({.diameter_um = 20}), 1)}});
    const render::RenderOptions options{
        .width = 40, .height = 40, .samples_per_pixel = 3, .sparkle = true};
    render::RenderResult one, two;
    {
        const ThreadLimit limit(1);
        one = render::render(compiled, options);
    }
    {
        const ThreadLimit limit(2);
        two = render::render(compiled, options);
    }
    EXPECT_EQ(one.rgb, two.rgb);
    EXPECT_EQ(one.sparkle, two.sparkle);
    EXPECT_EQ(one.invalid_paths, 0);
}

}  // namespace
}  // namespace nacre::models
