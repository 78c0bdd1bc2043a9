#include "nacre/render/render.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <limits>

#include "nacre/bsdf/models/lambertian.h"
#include "nacre/core/error.h"
#include "nacre/core/parallel.h"
#include "nacre/render/builtin_scenes.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/render.h"

namespace nacre::render {
namespace {

using nacre::test::message_of;
using testing::diffuse_sphere;
using testing::Glossy;
using testing::glossy_scene;

// A convex white body in even light from everywhere cannot be told from the light. Sampling the
// surface alone gives every path the value 1, so the bound is that of float rounding.
TEST(Render, WhiteFurnaceIsExactForEveryPath) {
    SceneDescription description = diffuse_sphere(1);
    description.environment = ConstantEnvironment{};
    const RenderOptions options{.width = 24, .height = 24, .samples_per_pixel = 4};
    const RenderResult r =
        render_with(Scene(description, {}), options, DirectLight::surface_sampling);
    ASSERT_EQ(r.rgb.size(), 3u * 24 * 24);
    for (float value : r.rgb) EXPECT_NEAR(value, 1, 2e-6);
}

TEST(Render, GreyFurnaceIsTheReflectanceOnTheSphereAndOneBesideIt) {
    SceneDescription description = diffuse_sphere(0.5);
    description.environment = ConstantEnvironment{};
    const RenderOptions options{.width = 24, .height = 24, .samples_per_pixel = 4};
    const RenderResult r =
        render_with(Scene(description, {}), options, DirectLight::surface_sampling);
    int on = 0, beside = 0;
    for (std::size_t p = 0; p < r.alpha.size(); ++p) {
        // On the outline the passes that met the sphere weigh a little more or less than others.
        if (r.alpha[p] == 0 || r.alpha[p] == 1) {
            EXPECT_NEAR(r.rgb[3 * p], 1 - 0.5 * r.alpha[p], 2e-6);
        }
        on += r.alpha[p] == 1;
        beside += r.alpha[p] == 0;
    }
    EXPECT_GT(on, 100);
    EXPECT_GT(beside, 100);
}

// Four standard errors over 32 seeds: by chance one run in 10 000, and the seeds are fixed.
TEST(Render, WhiteFurnaceHoldsOnAverageWithLightSampling) {
    SceneDescription description = diffuse_sphere(1);
    description.environment = ConstantEnvironment{};
    const Scene scene(description, {});
    const RenderOptions options{.width = 8, .height = 8, .samples_per_pixel = 16};
    for (DirectLight how : {DirectLight::combined, DirectLight::light_sampling}) {
        const auto e = testing::estimate_luminance(scene, options, how, 32);
        EXPECT_NEAR(e.value, 1, 4 * e.standard_error + 2e-6);
        EXPECT_LT(e.standard_error, 5e-3);
    }
}

// Behind the lamp in an integrating sphere all light has been reflected before:
// L = rho / pi * rho Phi / (4 pi R^2 (1 - rho)), with Phi = pi L_lamp A.   [jacquez-1955]
// The lamp itself shadows 8 mm^2 of 125 664.
TEST(Render, IntegratingSphereHasItsMultipleReflections) {
    constexpr double kRho = 0.6, kRadius = 100, kSide = 2, kLamp = 1000;
    SceneDescription description = diffuse_sphere(kRho);
    description.shapes[0].geometry = Sphere{.radius_mm = kRadius};
    description.lights.push_back(RectangleLight{.center_mm = {0, 0, 0},
                                                .target_mm = {0, 0, 50},
                                                .width_mm = kSide,
                                                .height_mm = kSide,
                                                .radiance = {.scale = kLamp}});
    description.camera = {.position_mm = {0, 30, -5},
                          .target_mm = {0, 30, -90},
                          .up = {0, 1, 0},
                          .vertical_fov_deg = 5};
    const RenderOptions options{.width = 4, .height = 4, .samples_per_pixel = 256, .max_depth = 64};
    const auto e =
        testing::estimate_luminance(Scene(description, {}), options, DirectLight::combined, 16);
    const double flux_over_area = kLamp * kSide * kSide / (4 * kRadius * kRadius);
    const double expected = kRho / M_PI * kRho * flux_over_area / (1 - kRho);
    EXPECT_NEAR(e.value, expected, 4 * e.standard_error + 2e-4 * expected);
    EXPECT_LT(e.standard_error, 0.01 * expected);
}

// Irradiance of a parallel rectangle over the point below its middle: four times the view factor
// of a corner.                                                     [howell-2010, configuration B-4]
TEST(Render, RectangleLightsADiffuseFloorAsInClosedForm) {
    constexpr double kHalfWidth = 60, kHalfHeight = 25, kDistance = 80, kRho = 0.7;
    SceneDescription description;
    description.materials["floor"] = DiffuseMaterial{kRho};
    description.shapes.push_back({GroundPlane{.size_mm = 1000}, "floor", {}});
    description.lights.push_back(RectangleLight{.center_mm = {0, 0, kDistance},
                                                .target_mm = {0, 0, 0},
                                                .width_mm = 2 * kHalfWidth,
                                                .height_mm = 2 * kHalfHeight});
    description.camera = {
        .position_mm = {200, 0, 60}, .target_mm = {0, 0, 0}, .vertical_fov_deg = 0.02};
    const Scene scene(description, {});
    const double x = kHalfWidth / kDistance, y = kHalfHeight / kDistance;
    const double rx = std::sqrt(1 + x * x), ry = std::sqrt(1 + y * y);
    const double view_factor =
        4 / (2 * M_PI) * (x / rx * std::atan(y / rx) + y / ry * std::atan(x / ry));
    const RenderOptions options{.width = 1, .height = 1, .samples_per_pixel = 512, .max_depth = 1};
    for (DirectLight how :
         {DirectLight::combined, DirectLight::surface_sampling, DirectLight::light_sampling}) {
        RenderOptions o = options;
        // A path that samples the surface sees the lamp as its next vertex.
        o.max_depth = how == DirectLight::light_sampling ? 1 : 2;
        const auto e = testing::estimate_luminance(scene, o, how, 32);
        EXPECT_NEAR(e.value, kRho * view_factor, 4 * e.standard_error);
        EXPECT_LT(e.standard_error, 0.005 * e.value);
    }
}

// Even light from everywhere does not show clear glass, whose faces lose nothing: solid or pane,
// smooth to rounding, as each path has the value 1 but where it ends at its last surface.
TEST(Render, ClearGlassIsNotSeenInEvenLight) {
    SceneDescription description = diffuse_sphere(0);
    description.environment = ConstantEnvironment{};
    RenderOptions options{.width = 16, .height = 16, .samples_per_pixel = 16, .max_depth = 200};
    for (const double pane_mm : {0.0, 3.0}) {
        description.materials["wall"] = GlassMaterial{.pane_mm = pane_mm};
        const RenderResult r = render(Scene(description, {}), options);
        for (float value : r.rgb) EXPECT_NEAR(value, 1, 3e-3) << pane_mm;
    }
}

// Light through the middle of a ball of glass meets both faces head on.
TEST(Render, SolidGlassAbsorbsAlongThePathInside) {
    constexpr double kAbsorption = 0.01, kRadius = 50;
    SceneDescription description = diffuse_sphere(0);
    description.materials["wall"] = GlassMaterial{.absorption_per_mm = kAbsorption};
    description.environment = ConstantEnvironment{};
    description.camera.vertical_fov_deg = 0.01;
    const double f = std::pow(0.5 / 2.5, 2), t = std::exp(-2 * kRadius * kAbsorption);
    const RenderOptions options{.width = 4, .height = 4, .samples_per_pixel = 64, .max_depth = 60};
    const auto e =
        testing::estimate_luminance(Scene(description, {}), options, DirectLight::combined, 16);
    // The series of reflections between the two faces, as of a pane.
    const double through = (1 - f) * (1 - f) * t / (1 - f * f * t * t);
    EXPECT_NEAR(e.value, f + f * t * through + through, 4 * e.standard_error);
    EXPECT_LT(e.standard_error, 2e-3);
}

// A light sample goes through panes, and a path that goes through them is still weighed against it:
// each strategy sees the floor under two panes by their transmittance squared.
TEST(Render, PanesWeakenLightAndDoNotHideIt) {
    SceneDescription description;
    description.materials["floor"] = DiffuseMaterial{0.5};
    description.materials["pane"] = GlassMaterial{.pane_mm = 4, .absorption_per_mm = 0.05};
    description.shapes.push_back({GroundPlane{.size_mm = 1000}, "floor", {}});
    for (const float height : {10.0f, 20.0f}) {
        description.shapes.push_back({FlatPanel{.width_mm = 5000, .height_mm = 5000},
                                      "pane",
                                      {.translation_mm = {0, 0, height}}});
    }
    description.camera = {.position_mm = {0, 0, 5}, .up = {0, 1, 0}, .vertical_fov_deg = 1};
    const double f = 0.04, t = std::exp(-0.2);
    const double through = (1 - f) * (1 - f) * t / (1 - f * f * t * t);
    description.lights = {DirectionalLight{.to_light = {0, 0, 1}, .irradiance = {.scale = 2}}};
    const RenderOptions options{.width = 2, .height = 2, .samples_per_pixel = 4, .max_depth = 1};
    for (float value : render(Scene(description, {}), options).rgb) {
        EXPECT_NEAR(value, 0.5 / M_PI * 2 * through * through, 1e-5);
    }
    description.lights = {RectangleLight{.center_mm = {0, 0, 60}, .target_mm = {0, 0, 0}}};
    const Scene scene(description, {});
    const RenderOptions deep{.width = 1, .height = 1, .samples_per_pixel = 256, .max_depth = 12};
    const auto by_surface =
        testing::estimate_luminance(scene, deep, DirectLight::surface_sampling, 32);
    const auto by_both = testing::estimate_luminance(scene, deep, DirectLight::combined, 32);
    EXPECT_NEAR(by_surface.value, by_both.value,
                4 * std::hypot(by_surface.standard_error, by_both.standard_error));
    EXPECT_LT(by_both.standard_error, 0.01 * by_both.value);
}

TEST(Render, DirectionalLightFollowsTheCosineLaw) {
    SceneDescription description;
    description.materials["floor"] = DiffuseMaterial{0.6};
    description.shapes.push_back({GroundPlane{}, "floor", {}});
    description.camera = {.position_mm = {0, 0, 100}, .up = {0, 1, 0}, .vertical_fov_deg = 10};
    for (double angle_deg : {0.0, 30.0, 75.0}) {
        const double angle = angle_deg * M_PI / 180;
        description.lights = {DirectionalLight{.to_light = {static_cast<float>(std::sin(angle)), 0,
                                                            static_cast<float>(std::cos(angle))},
                                               .irradiance = {.scale = 3}}};
        const RenderResult r =
            render(Scene(description, {}), {.width = 2, .height = 2, .samples_per_pixel = 2});
        for (float value : r.rgb) EXPECT_NEAR(value, 0.6 / M_PI * 3 * std::cos(angle), 1e-5);
    }
}

// The three estimators of direct light have one mean: each pair agrees within 4 combined standard
// errors, on paint with a specular and a wide lobe and a ground, under every kind of finite light.
// Under the sky the surface alone would have to hit the sun; it is left out there.
TEST(Render, EstimatorsOfDirectLightAgree) {
    struct Case {
        const char* name;
        SceneDescription scene;
        bool surface_alone;
    };
    std::vector<Case> cases;
    cases.push_back({"studio", builtin_scene("sphere"), true});
    SceneDescription lamp = builtin_scene("sphere");
    lamp.environment = ConstantEnvironment{.radiance = {.scale = 0.1}};
    lamp.lights.push_back(RectangleLight{.center_mm = {150, -250, 200},
                                         .width_mm = 150,
                                         .height_mm = 200,
                                         .radiance = {.scale = 5}});
    cases.push_back({"lamp", lamp, true});
    SceneDescription sky = builtin_scene("sphere");
    sky.environment = SkyEnvironment{.sun_azimuth_deg = -120};
    cases.push_back({"sky", sky, false});
    for (const Case& c : cases) {
        SCOPED_TRACE(c.name);
        // Without the specular lobe, by which the sun would be seen by chance as well.
        const Scene scene(c.scene, {{"paint", std::make_shared<Glossy>(40.0f, 0.0f)}});
        const RenderOptions options{.width = 12, .height = 12, .samples_per_pixel = 64};
        const auto all = testing::estimate_luminance(scene, options, DirectLight::combined, 24);
        const auto light =
            testing::estimate_luminance(scene, options, DirectLight::light_sampling, 24);
        EXPECT_GT(all.value, 0.05);
        EXPECT_LT(all.standard_error, 0.005 * all.value);
        EXPECT_NEAR(all.value, light.value,
                    4 * std::hypot(all.standard_error, light.standard_error));
        if (!c.surface_alone) continue;
        const auto surface =
            testing::estimate_luminance(scene, options, DirectLight::surface_sampling, 24);
        EXPECT_NEAR(all.value, surface.value,
                    4 * std::hypot(all.standard_error, surface.standard_error));
    }
}

TEST(Render, SameBitsForAnyNumberOfThreads) {
    const Scene scene = glossy_scene("curved-panel");
    const RenderOptions options{
        .width = 40, .height = 24, .samples_per_pixel = 3, .seed = 5, .spectral_bins = 7};
    RenderResult one, two;
    {
        const ThreadLimit limit(1);
        one = render(scene, options);
    }
    {
        const ThreadLimit limit(2);
        two = render(scene, options);
    }
    EXPECT_EQ(one.rgb, two.rgb);
    EXPECT_EQ(one.albedo, two.albedo);
    EXPECT_EQ(one.normal, two.normal);
    EXPECT_EQ(one.spectral, two.spectral);
    RenderOptions other = options;
    other.seed = 6;
    EXPECT_NE(one.rgb, render(scene, other).rgb);
}

// Bit for bit. One of fewer samples has other wavelengths, which are even among themselves.
TEST(Render, StoppedRenderIsThePictureOfTheShardsDone) {
    const Scene scene = glossy_scene();
    const RenderOptions options{
        .width = 20, .height = 20, .samples_per_pixel = 40, .spectral_bins = 4};
    double last = 0;
    const RenderResult stopped = render(scene, options, [&](double fraction) {
        last = fraction;
        return fraction < 10.5 / 40;
    });
    EXPECT_FALSE(stopped.complete);
    EXPECT_EQ(stopped.samples, 11);
    EXPECT_DOUBLE_EQ(last, 11.0 / 40);
    RenderSums sums(options);
    for (int number = 1; number <= 11; ++number) {
        sums.add(render_shard(scene, options, {number, options.samples_per_pixel}));
    }
    const RenderResult shards = develop(sums, options);
    EXPECT_EQ(shards.samples, 11);
    EXPECT_EQ(stopped.rgb, shards.rgb);
    EXPECT_EQ(stopped.spectral, shards.spectral);
    EXPECT_EQ(stopped.albedo, shards.albedo);
    // What every sample has, whatever its wavelengths.
    RenderOptions fewer = options;
    fewer.samples_per_pixel = 11;
    EXPECT_EQ(stopped.alpha, render(scene, fewer).alpha);
}

/// A surface on which the user's patience ends: after some paths, work is stopped within a pass.
class Interrupting final : public bsdf::Bsdf {
 public:
    explicit Interrupting(int paths) : paths_(paths) {}

    std::unique_ptr<const bsdf::BoundBsdf> bind(const bsdf::Wavelengths& nm) const override {
        class Bound final : public bsdf::BoundBsdf {
         public:
            Bound(std::unique_ptr<const bsdf::BoundBsdf> white, std::atomic<int>& paths)
                : white_(std::move(white)), paths_(paths) {}
            FloatLanes eval(Vec3f wi, Vec3f wo) const override { return white_->eval(wi, wo); }
            std::optional<bsdf::BsdfSample> sample(Vec3f wi, float u_select,
                                                   Vec2f u) const override {
                if (paths_-- <= 0) throw Stopped("stopped");
                return white_->sample(wi, u_select, u);
            }
            float pdf(Vec3f wi, Vec3f wo) const override { return white_->pdf(wi, wo); }
            FloatLanes albedo(Vec3f wi) const override { return white_->albedo(wi); }

         private:
            std::unique_ptr<const bsdf::BoundBsdf> white_;
            std::atomic<int>& paths_;
        };
        return std::make_unique<Bound>(white_.bind(nm), paths_);
    }

 private:
    bsdf::Lambertian white_{spectra::Spectrum(1.0)};
    mutable std::atomic<int> paths_;
};

// A white panel that fills the picture in white light is white, in whatever pixels a pass got to.
TEST(Render, APassThatIsStoppedInTheMiddleCountsWhereItGotTo) {
    constexpr int kSide = 24, kPixels = kSide * kSide;
    for (const auto& [paths, samples] :
         {std::pair{kPixels / 2, 0}, std::pair{5 * kPixels / 2, 2}}) {
        SceneDescription scene;
        scene.materials["paint"] = PaintMaterial{};
        scene.shapes.push_back({FlatPanel{1000, 1000}, "paint", {}});
        scene.camera.position_mm = {0, 0, 100};
        scene.camera.up = {0, 1, 0};
        scene.environment = ConstantEnvironment{};
        const RenderResult stopped =
            render_with(Scene(scene, {{"paint", std::make_shared<Interrupting>(paths)}}),
                        {.width = kSide, .height = kSide, .samples_per_pixel = 40},
                        DirectLight::surface_sampling);
        EXPECT_FALSE(stopped.complete);
        EXPECT_EQ(stopped.samples, samples);
        int seen = 0;
        for (std::size_t p = 0; p < kPixels; ++p) {
            if (stopped.alpha[p] == 0) continue;
            ++seen;
            EXPECT_EQ(stopped.alpha[p], 1);
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(stopped.rgb[3 * p + c], 1, 1e-5) << p;
        }
        EXPECT_GT(seen, 0);
        EXPECT_EQ(seen == kPixels, samples > 0);
    }
}

/// A surface at fault: its BRDF is not a number.
class Faulty final : public bsdf::Bsdf {
    class Bound final : public bsdf::BoundBsdf {
     public:
        FloatLanes eval(Vec3f, Vec3f) const override {
            return splat(std::numeric_limits<float>::quiet_NaN());
        }
        std::optional<bsdf::BsdfSample> sample(Vec3f, float, Vec2f) const override {
            return bsdf::BsdfSample{{0, 0, 1}, splat(std::numeric_limits<float>::infinity()), 1};
        }
        float pdf(Vec3f, Vec3f) const override { return 1; }
        FloatLanes albedo(Vec3f) const override {
            return splat(std::numeric_limits<float>::quiet_NaN());
        }
    };

 public:
    std::unique_ptr<const bsdf::BoundBsdf> bind(const bsdf::Wavelengths&) const override {
        return std::make_unique<Bound>();
    }
};

TEST(Render, FaultySurfaceIsCountedAndLeavesNoNan) {
    const Scene scene(builtin_scene("sphere"), {{"paint", std::make_shared<Faulty>()}});
    const RenderResult r = render(scene, {.width = 16, .height = 16, .samples_per_pixel = 2});
    EXPECT_GT(r.invalid_paths, 0);
    for (float value : r.rgb) EXPECT_TRUE(std::isfinite(value));
    for (float value : r.albedo) EXPECT_TRUE(std::isfinite(value));
}

TEST(Render, AuxiliaryPicturesShowTheFirstSurface) {
    SceneDescription description = diffuse_sphere(0.3);
    description.environment = ConstantEnvironment{};
    const RenderResult r =
        render(Scene(description, {}), {.width = 33, .height = 33, .samples_per_pixel = 8});
    const std::size_t middle = 33 * 16 + 16;
    EXPECT_EQ(r.alpha[middle], 1);
    EXPECT_NEAR(r.albedo[3 * middle + 1], 0.3, 1e-5);
    EXPECT_NEAR(r.normal[3 * middle + 1], -1, 0.02);  // towards the camera, a pixel's spread
    EXPECT_EQ(r.alpha[0], 0);
    EXPECT_EQ(r.albedo[0], 0);
}

TEST(Render, OptionsOutOfRangeAreRefusedByName) {
    const Scene scene = glossy_scene();
    const auto message = [&](RenderOptions options) -> std::string {
        return message_of<DomainError>([&] { render(scene, options); });
    };
    EXPECT_THAT(message({.width = 0}), ::testing::HasSubstr("width in pixels = 0"));
    EXPECT_NO_THROW(check({.width = 100, .height = 100, .spectral_bins = 300}));
    EXPECT_THAT(message({.height = -3}), ::testing::HasSubstr("height in pixels = -3"));
    EXPECT_THAT(message({.width = 32768, .height = 32768}), ::testing::HasSubstr("width x height"));
    EXPECT_THAT(message({.samples_per_pixel = 0}), ::testing::HasSubstr("samples per pixel = 0"));
    EXPECT_THAT(message({.max_depth = 0}), ::testing::HasSubstr("max depth = 0"));
    EXPECT_THAT(message({.spectral_bins = 301}), ::testing::HasSubstr("spectral bins = 301"));
}

}  // namespace
}  // namespace nacre::render
