#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/core/parallel.h"
#include "nacre/render/builtin_scenes.h"
#include "nacre/render/render.h"
#include "nacre/spectra/rgb.h"
#include "nacre/testing/render.h"
#include "nacre/testing/statistics.h"

namespace nacre::render {
namespace {

using testing::diffuse_sphere;
using testing::Glossy;
using testing::glossy_scene;

// The estimate against the truth: the difference to a picture of 16 times the samples or more and
// other random numbers, over all pixels, less the share of that picture, whose noise falls no slower
// than with the root of its samples.
TEST(RenderNoise, TheNoiseIsThatAgainstTheConvergedPicture) {
    // The estimate has one pixel of 64, and a quarter of the ball's squared error is in one of a
    // hundred, where a path finds a light by chance: that of a single picture spreads so much. The
    // mean of 30 was within 1.4 % of the truth in each case.
    struct Case {
        const char* scene;
        int samples;
        double spread;
    };
    constexpr int kMany = 256, kPictures = 8;
    for (const char* name : {"sphere", "panel-sun"}) {
        const Scene scene = glossy_scene(name);
        RenderOptions options{.width = 96, .height = 96, .samples_per_pixel = kMany, .seed = 1};
        const RenderResult converged = render(scene, options);
        EXPECT_FALSE(converged.noise);
        options.noise = true;
        for (const auto& [of, samples, spread] :
             {Case{"sphere", 4, 0.125}, Case{"sphere", 16, 0.12}, Case{"panel-sun", 4, 0.09},
              Case{"panel-sun", 16, 0.06}}) {
            if (of != std::string_view(name)) continue;
            options.samples_per_pixel = samples;
            double ratio = 0;
            for (int n = 0; n < kPictures; ++n) {
                options.seed = 2 + n;
                const RenderResult picture = render(scene, options);
                ASSERT_TRUE(picture.noise);
                double squares = 0, sum = 0;
                for (std::size_t p = 0; p < picture.rgb.size(); p += 3) {
                    const float *a = &picture.rgb[p], *b = &converged.rgb[p];
                    const double y = spectra::rec709_luminance<double>(b[0], b[1], b[2]);
                    squares += std::pow(spectra::rec709_luminance<double>(a[0], a[1], a[2]) - y, 2);
                    sum += y;
                }
                const double pixels = 96.0 * 96;
                const double own = squares / (1 + 1.0 * samples / kMany);
                const double one = *picture.noise / (std::sqrt(own / pixels) / (sum / pixels));
                EXPECT_NEAR(one, 1, std::min(test::kWorstZ * spread, 0.35)) << name << ' ' << n;
                ratio += one / kPictures;
            }
            EXPECT_NEAR(ratio, 1, test::kWorstZ * spread / std::sqrt(kPictures))
                << name << ", " << samples;
        }
    }
}

// A glossy ball among soft boxes: with one direction to a light each sample the noise was 21 %.
TEST(RenderNoise, DirectionsToLightsAreChosenByWhatTheSurfaceReflects) {
    const RenderOptions options{.width = 96, .height = 96, .samples_per_pixel = 16};
    EXPECT_LT(noise_of(glossy_scene("sphere"), options), 0.16);
}

// A wide lobe under a clear coat: on the ball most of the noise is that of the soft boxes' mirror
// images; the panel mirrors a backdrop, which samples draw at random in either way.
TEST(RenderNoise, WhatACoatMirrorsIsSeenByEverySample) {
    for (const std::string_view name : {"sphere", "panel"}) {
        SCOPED_TRACE(name);
        const auto scene = [&](bool besides) {
            return Scene(builtin_scene(std::string(name)),
                         {{"paint", std::make_shared<Glossy>(2, 0.3f, besides)}});
        };
        const Scene besides = scene(true), by_lot = scene(false);
        RenderOptions options{.width = 48, .height = 48, .samples_per_pixel = 16};
        const double noise = noise_of(besides, options), before = noise_of(by_lot, options);
        EXPECT_LT(noise, (name == "sphere" ? 0.5 : 1.05) * before);
        const Estimate a = testing::estimate_luminance(besides, options, DirectLight::combined, 10);
        const Estimate b = testing::estimate_luminance(by_lot, options, DirectLight::combined, 10);
        const double error = std::hypot(a.standard_error, b.standard_error);
        EXPECT_NEAR(a.value, b.value, 4.5 * error);
        EXPECT_LT(error, 0.005 * b.value);
    }
}

TEST(RenderNoise, ThePictureDoesNotDependOnAskingForItsNoise) {
    const Scene scene = glossy_scene();
    RenderOptions options{.width = 33, .height = 17, .samples_per_pixel = 8};
    const std::vector<float> plain = render(scene, options).rgb;
    options.noise = true;
    EXPECT_EQ(render(scene, options).rgb, plain);
    // Nor does the estimate on the number of threads.
    std::optional<double> alone, together;
    {
        const ThreadLimit limit(1);
        alone = render(scene, options).noise;
    }
    {
        const ThreadLimit limit(3);
        together = render(scene, options).noise;
    }
    EXPECT_EQ(alone, together);
}

TEST(RenderNoise, AnEvenlyLitWhiteBodyHasNoNoise) {
    SceneDescription description = diffuse_sphere(1);
    description.environment = ConstantEnvironment{};
    RenderOptions options{.width = 24, .height = 24, .samples_per_pixel = 4};
    options.noise = true;
    const Scene scene(description, {});
    EXPECT_LT(*render_with(scene, options, DirectLight::surface_sampling).noise, 1e-5);
}

TEST(RenderNoise, TakesAsManySamplesAsTheNoiseNeeds) {
    const Scene scene = glossy_scene();
    RenderOptions options{.width = 64, .height = 64};
    const int few = samples_for_noise(scene, options, 0.1, 4096);
    const int many = samples_for_noise(scene, options, 0.02, 4096);
    EXPECT_LT(few, many);
    EXPECT_LT(many, 4096);
    options.samples_per_pixel = many;
    EXPECT_LE(noise_of(scene, options), 0.02);
    EXPECT_EQ(samples_for_noise(scene, options, 1e-4, 32), 32);  // not reached
    EXPECT_THROW(samples_for_noise(scene, options, 0, 64), DomainError);
    EXPECT_THROW(noise_of(scene, options, [](double) { return false; }), Stopped);
}

}  // namespace
}  // namespace nacre::render
