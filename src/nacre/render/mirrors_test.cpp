#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "nacre/render/render.h"
#include "nacre/render/scene.h"
#include "nacre/testing/render.h"

// Light that only samples of surfaces find, by way of mirrors.

namespace nacre::render {
namespace {

// The sun's image in a ball is far smaller than a pixel of this picture: it is as bright whichever the
// seed, and as bright as in a picture of 16 times the pixels, whose samples find it as it is.
TEST(Mirrors, TheSunInAGlossyBallDoesNotDependOnTheSeed) {
    SceneDescription description;
    description.materials["ball"] = PlasticMaterial{.reflectance = 0};
    description.shapes.push_back({Sphere{.radius_mm = 50}, "ball", {}});
    description.camera = {.position_mm = {0, -300, 0}, .vertical_fov_deg = 30};
    description.environment = SkyEnvironment{.sun_azimuth_deg = -60, .sun_elevation_deg = 40};
    const Scene scene(description, {});
    RenderOptions options{.width = 16, .height = 16, .samples_per_pixel = 256};
    std::vector<float> brightest;
    for (std::uint64_t seed = 0; seed < 6; ++seed) {
        options.seed = seed;
        const RenderResult r = render(scene, options);
        brightest.push_back(*std::max_element(r.rgb.begin(), r.rgb.end()));
    }
    const auto [least, most] = std::minmax_element(brightest.begin(), brightest.end());
    EXPECT_GT(*least, 0.5f);
    EXPECT_LT(*most, 1.3f * *least);

    // The larger picture by 64 renders of Nacre 0.1.0, which NACRE_WRITE_TRUTH=1 prints; four of
    // today are as bright, within what the 64 scatter by.
    const Estimate known{0.4582341, 2.12e-05};
    constexpr int kKnown = 64, kToday = 4;
    const auto small = testing::estimate_luminance(scene, options, DirectLight::combined, 16);
    EXPECT_NEAR(small.value, known.value,
                4 * std::hypot(small.standard_error, known.standard_error));
    options.width = options.height = 64;
    const auto large = [&](int seeds) {
        return testing::estimate_luminance(scene, options, DirectLight::combined, seeds);
    };
    if (std::getenv("NACRE_WRITE_TRUTH")) {
        const Estimate anew = large(kKnown);
        std::printf("%.7g, %.3g\n", anew.value, anew.standard_error);
    }
    const double error = known.standard_error * std::sqrt(1.0 * kKnown / kToday);
    EXPECT_NEAR(large(kToday).value, known.value, 4 * error);
    EXPECT_LT(error, 0.01 * known.value);
}

}  // namespace
}  // namespace nacre::render
