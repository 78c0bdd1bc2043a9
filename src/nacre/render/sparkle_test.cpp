#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "nacre/core/parallel.h"
#include "nacre/core/random.h"
#include "nacre/render/builtin_scenes.h"
#include "nacre/testing/render.h"

// RenderResult::sparkle: the light of single flakes, apart from that of their mean.

namespace nacre::render {
namespace {

using testing::Glossy;
using testing::Speckled;

/// Black or twice as bright, at random from one cube of 0.7 mm to the next: 1 on average.
std::shared_ptr<const bsdf::Bsdf> speckles(std::uint64_t seed = 0) {
    return std::make_shared<Speckled>([seed](Vec3f p, Vec3f) {
        const auto cell = [](float x) {
            return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(x / 0.7f)));
        };
        std::uint64_t hash = mix_bits(seed + 1);
        for (float x : {p.x, p.y, p.z}) hash = mix_bits(hash ^ cell(x));
        return hash & 1 ? 2.0f : 0.0f;
    });
}

/// A ball of paint over a panel with a specular clearcoat, close enough to light each other.
SceneDescription ball_over_mirror() {
    SceneDescription scene;
    scene.materials = {{"paint", PaintMaterial{}}, {"mirror", PaintMaterial{}}};
    scene.shapes.push_back({Sphere{.radius_mm = 30},
                            "paint",
                            {.rotation_deg = {20, 30, 40}, .translation_mm = {0, 0, 36}}});
    scene.shapes.push_back({FlatPanel{.width_mm = 300, .height_mm = 300}, "mirror", {}});
    scene.camera = {
        .position_mm = {0, -500, 150}, .target_mm = {0, -20, 10}, .vertical_fov_deg = 15};
    scene.environment = StudioEnvironment{};
    return scene;
}

Scene mirrored(std::shared_ptr<const bsdf::Bsdf> ball) {
    return Scene(ball_over_mirror(),
                 {{"paint", std::move(ball)}, {"mirror", std::make_shared<Glossy>(200.0f, 0.5f)}});
}

constexpr RenderOptions kSparkleOptions{
    .width = 48, .height = 48, .samples_per_pixel = 8, .sparkle = true};

TEST(Sparkle, IsThePictureMinusThatOfTheMean) {
    // The ball of speckles and that of their mean are sampled alike: with the same seed every path
    // is the same one. Also seen in the mirror, and after several reflections between the two.
    const RenderResult speckled = render(mirrored(speckles()), kSparkleOptions);
    const RenderResult smooth = render(mirrored(std::make_shared<Glossy>()), kSparkleOptions);
    ASSERT_EQ(speckled.sparkle.size(), speckled.rgb.size());
    for (std::size_t i = 0; i < speckled.rgb.size(); ++i) {
        // 32 roundings of float along the path and in the sums.
        const float bound = 4e-6f * (1 + std::abs(speckled.rgb[i]) + std::abs(smooth.rgb[i]));
        EXPECT_NEAR(speckled.rgb[i] - speckled.sparkle[i], smooth.rgb[i], bound);
    }
}

TEST(Sparkle, IsSeenDirectlyAndInAMirror) {
    const RenderResult r = render(mirrored(speckles()), kSparkleOptions);
    int on_ball = 0, in_mirror = 0, on_panel = 0;
    for (std::size_t p = 0; p < r.alpha.size(); ++p) {
        if (r.alpha[p] < 1) continue;
        const bool panel = r.normal[3 * p + 2] > 0.9999f;
        const bool sparkles = std::abs(r.sparkle[3 * p + 1]) > 1e-3f;
        on_panel += panel;
        on_ball += !panel && sparkles;
        in_mirror += panel && sparkles;
    }
    EXPECT_GT(on_ball, 200);
    EXPECT_GT(in_mirror, 100);
    EXPECT_LT(in_mirror, on_panel);  // after a diffuse reflection paths meet the ball's mean
}

TEST(Sparkle, IsZeroOnAverage) {
    // Over the picture, for 30 patterns: three standard errors.
    RenderOptions options = kSparkleOptions;
    double sum = 0, squares = 0, light = 0;
    constexpr int kPatterns = 30;
    for (int pattern = 0; pattern < kPatterns; ++pattern) {
        options.seed = static_cast<std::uint64_t>(pattern);
        const RenderResult r = render(mirrored(speckles(options.seed)), options);
        double mean = 0;
        for (float value : r.sparkle) mean += value / static_cast<double>(r.sparkle.size());
        for (float value : r.rgb) light += value / static_cast<double>(r.rgb.size()) / kPatterns;
        sum += mean;
        squares += mean * mean;
    }
    const double mean = sum / kPatterns;
    const double error = std::sqrt((squares / kPatterns - mean * mean) / (kPatterns - 1));
    EXPECT_NEAR(mean, 0, 3 * error);
    EXPECT_LT(error, 0.01 * light);
    EXPECT_GT(error, 0);
}

TEST(Sparkle, AskingForItChangesNothingElse) {
    RenderOptions without = kSparkleOptions;
    without.sparkle = false;
    const Scene scene = mirrored(speckles());
    const RenderResult plain = render(scene, without), split = render(scene, kSparkleOptions);
    EXPECT_TRUE(plain.sparkle.empty());
    EXPECT_EQ(plain.rgb, split.rgb);
    EXPECT_EQ(plain.albedo, split.albedo);
}

TEST(Sparkle, IsZeroOnSurfacesThatDoNotVary) {
    const RenderResult r = render(mirrored(std::make_shared<Glossy>()), kSparkleOptions);
    EXPECT_EQ(r.sparkle, std::vector<float>(r.rgb.size(), 0.0f));
}

TEST(Sparkle, SameBitsForAnyNumberOfThreads) {
    const Scene scene = mirrored(speckles());
    RenderResult one, two;
    {
        const ThreadLimit limit(1);
        Speckled::stale = 0;
        one = render(scene, kSparkleOptions);
        EXPECT_EQ(Speckled::stale, 0);  // no patch got the memory of another
    }
    {
        const ThreadLimit limit(2);
        two = render(scene, kSparkleOptions);
    }
    EXPECT_EQ(one.rgb, two.rgb);
    EXPECT_EQ(one.sparkle, two.sparkle);
}

TEST(Sparkle, TurnsAndMovesWithTheShape) {
    // A smooth pattern of place and direction. The lamp, the camera and the ball, turned alike,
    // show the same picture: with one sample, all light from one direction and no second
    // reflection, without any noise.
    const auto paint = std::make_shared<Speckled>([](Vec3f p, Vec3f h) {
        return 1 +
               0.5f * std::sin(0.4f * p.x + 0.7f * p.y - 0.5f * p.z) * std::sin(9 * h.x + 5 * h.y);
    });
    const Vec3f to_light = {0.5f, -0.6f, 0.6f};
    const auto picture = [&](const Transform& turn, bool pattern_turns) {
        const AffineMap map(turn);
        SceneDescription scene;
        scene.materials["paint"] = PaintMaterial{};
        Transform ball = turn;
        if (!pattern_turns) ball.rotation_deg = {};
        scene.shapes.push_back({Sphere{.radius_mm = 20}, "paint", ball});
        scene.camera = {.position_mm = map.point({30, -200, 60}),
                        .target_mm = map.point({}),
                        .up = map.direction({0, 0, 1}),
                        .vertical_fov_deg = 11};
        scene.lights.push_back(DirectionalLight{.to_light = map.direction(to_light)});
        return render_with(Scene(scene, {{"paint", paint}}),
                           {.width = 40, .height = 40, .samples_per_pixel = 1, .max_depth = 1},
                           DirectLight::light_sampling);
    };
    const RenderResult still = picture({}, true);
    const Transform turn{.rotation_deg = {70, -35, 120}, .translation_mm = {40, 500, -30}};
    const RenderResult turned = picture(turn, true);
    const RenderResult other = picture(turn, false);
    int compared = 0, differ = 0;
    for (std::size_t i = 0; i < still.rgb.size(); ++i) {
        if (still.rgb[i] == 0) continue;
        // Places are known to 1e-4 mm, a float's rounding 500 mm from the origin; rays that graze
        // multiply it, to the camera and to the lamp.
        const float* n = &still.normal[i / 3 * 3];
        const double lit = dot(Vec3f{n[0], n[1], n[2]}, normalize(to_light));
        if (lit < 0.01) continue;
        const double cosine = std::min<double>(std::abs(n[1]), lit);
        EXPECT_NEAR(turned.rgb[i] / still.rgb[i], 1, 1e-3 / std::max(cosine, 0.05)) << i;
        differ += std::abs(other.rgb[i] / still.rgb[i] - 1) > 0.02;
        ++compared;
    }
    EXPECT_GT(compared, 1000);
    EXPECT_GT(differ, compared / 2);  // a pattern that stands still would have shown
}

}  // namespace
}  // namespace nacre::render
