#include "nacre/measure/sparkle_camera.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "nacre/bsdf/models/lambertian.h"
#include "nacre/bsdf/models/microflake.h"
#include "nacre/bsdf/models/nacre.h"
#include "nacre/bsdf/tilted_coat.h"
#include "nacre/core/error.h"
#include "nacre/core/parallel.h"
#include "nacre/measure/sparkle_measurement.h"
#include "nacre/solver/solver.h"
#include "nacre/sparkle/diffraction_lobe.h"
#include "nacre/testing/directions.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/paints.h"

namespace nacre::measure {
namespace {

using nacre::test::message_of;
using ::testing::HasSubstr;

struct Panel {
    std::shared_ptr<const solver::SolvedPaint> paint;
    explicit Panel(const paint::Recipe& recipe)
        : paint(std::make_shared<const solver::SolvedPaint>(
              solver::solve(recipe, {400, 475, 550, 625, 700}))) {}
    bsdf::Nacre sparkling(std::uint64_t specimen = 1, bool hot_spot = true) const {
        return bsdf::Nacre(paint, {.specimen = specimen, .hot_spot = hot_spot});
    }
};

// Gray mirrors, so that colour does not matter.
paint::Recipe mirrors(double diameter_um, double depth, double alpha = 0.12) {
    constexpr double kThickness_um = 20;
    paint::FlakeSpecies flake = test::flakes(depth / kThickness_um, alpha, 0.8);
    flake.diameter_um = diameter_um;
    return test::paint_of(1.5, {{kThickness_um, {flake}, {}}});
}

/// `sparkle` of flakes under a lamp at 45 deg.
Estimate sparkle_of(double diameter_um, double waviness) {
    paint::Recipe recipe = mirrors(diameter_um, 2, 0.16);
    recipe.layers[0].flakes[0].waviness = waviness;
    const Panel panel(recipe);
    const SparkleCamera camera{
        .pixel_um = 40, .field_mm = 6, .lamps_deg = {45}, .diffuse_samples = 0};
    return measure_pictures(camera, take_pictures(panel.sparkling(), camera))
        .by_lamp.at(0)
        .sparkle_per_cm2;
}

// At the same area and volume. Of flat flakes a quarter as many flash, each in a lobe of a quarter of
// the solid angle; the lobes of wavy ones stay as wide.                     [docs/sparkle.md]
TEST(SparkleCamera, LargerFlakesSparkleMoreIfTheyAreWavyAndLessIfFlat) {
    const auto larger = [](double waviness) {
        const Estimate small = sparkle_of(18, waviness), large = sparkle_of(36, waviness);
        return (large.value - small.value) / std::hypot(small.standard_error, large.standard_error);
    };
    EXPECT_LT(larger(0), -4);
    EXPECT_GT(larger(0.05), 4);
}

SparkleCamera small_camera() { return {.pixel_um = 25, .field_mm = 3}; }

double standard_error_of_mean(const PanelPicture& picture) {
    // Pixels that share a flake are correlated; sixteen pieces are nearly independent.
    double sum[kPicturePieces] = {}, count[kPicturePieces] = {};
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const int piece = piece_of(x, y, picture.width, picture.height);
            sum[piece] += picture.luminance(static_cast<std::size_t>(y) * picture.width + x);
            count[piece] += 1;
        }
    }
    const double mean = mean_luminance(picture);
    double variance = 0;
    for (int i = 0; i < kPicturePieces; ++i) variance += std::pow(sum[i] / count[i] - mean, 2);
    return std::sqrt(variance / (kPicturePieces * (kPicturePieces - 1.0)));
}

TEST(SparkleCamera, SeesAWhiteDiffuserAsWhite) {
    const bsdf::Lambertian white(spectra::Spectrum(1.0));
    const PanelPictures pictures = take_pictures(white, small_camera());
    ASSERT_EQ(pictures.by_lamp.size(), 3u);
    ASSERT_EQ(pictures.diffuse.size(), 2u);
    for (const PanelPicture* p :
         {&pictures.by_lamp[0], &pictures.by_lamp[2], &pictures.diffuse[1]}) {
        EXPECT_NEAR(p->xyz[1], 1, 1e-5);
        // White point of D65 for the 2 degree observer; sums at 20 nm from 400 to 700 nm.
        EXPECT_NEAR(p->xyz[0], 0.9505, 0.01);
        EXPECT_NEAR(p->xyz[2], 1.089, 0.02);
    }
}

TEST(SparkleCamera, FindsNeitherSparkleNorGrainOnSmoothSurfaces) {
    const bsdf::Lambertian gray(spectra::Spectrum(0.3));
    const Panel panel(mirrors(20, 1.5));
    const bsdf::Microflake smooth(panel.paint);
    const SparkleCamera camera = small_camera();
    for (const bsdf::Bsdf* surface :
         {static_cast<const bsdf::Bsdf*>(&gray), static_cast<const bsdf::Bsdf*>(&smooth)}) {
        const auto m = measure_pictures(camera, take_pictures(*surface, camera));
        for (const Sparkle& s : m.by_lamp) {
            EXPECT_EQ(s.density_per_cm2.value, 0);
            EXPECT_EQ(s.area_fraction.value, 0);
            EXPECT_EQ(s.pixel_contrast.value, 0);
        }
        EXPECT_EQ(m.diffuse->graininess.value, 0);
    }
}

paint::Recipe with_waves(paint::Recipe recipe, const paint::OrangePeel& peel) {
    recipe.clearcoat = paint::Clearcoat{0, 0.0, 0, peel};
    return recipe;
}

// Of a paint without single flakes each pixel is known: the lamp's light through the coat at the slope of
// its middle, x to the right and y up.
TEST(SparkleCamera, SeesTheWavesOfACoat) {
    const Panel panel(with_waves(mirrors(20, 1.5), {.wb = 0.02, .wc = 0.02}));
    const bsdf::Microflake smooth(panel.paint, 5);
    const SparkleCamera camera{.pixel_um = 50,
                               .field_mm = 3,
                               .lamps_deg = {20},
                               .lamp_half_angle_deg = 0,
                               .diffuse_samples = 0};
    const PanelPicture picture = take_pictures(smooth, camera).by_lamp.at(0);
    const auto bound = smooth.bind({400, 440, 480, 520, 560, 600, 640, 680});
    constexpr float kSide_mm = 0.05f;
    const Vec3f lamp = test::direction(20, 0);
    double least = 1e9, most = 0;
    for (int y = 0; y < 60; y += 7) {
        for (int x = 0; x < 60; x += 7) {
            const Vec3d rise =
                smooth.coat_waves()->gradient({kSide_mm * (static_cast<float>(x) - 29.5f),
                                               kSide_mm * (29.5f - static_cast<float>(y)), 0});
            const bsdf::TiltedCoat coat(
                *bound, {static_cast<float>(rise.x), static_cast<float>(rise.y)}, {0, 0, 1});
            // Gray: the same at all wavelengths, but for what the sums of the colours leave.
            const double expected = std::numbers::pi * coat.eval({0, 0, 1}, lamp)[4];
            const double found = picture.luminance(static_cast<std::size_t>(y) * 60 + x);
            EXPECT_NEAR(found, expected, 1e-5 * expected);  // found: 3e-7
            least = std::min(least, found);
            most = std::max(most, found);
        }
    }
    EXPECT_GT(most, 1.2 * least);
}

// As many flakes are seen, at other places, and as bright on the whole.
TEST(SparkleCamera, WavesMoveFlashes) {
    const SparkleCamera camera{.field_mm = 6, .lamps_deg = {20}, .diffuse_samples = 0};
    const auto seen = [&](const paint::OrangePeel& peel) {
        const Panel panel(with_waves(mirrors(20, 1.0), peel));
        return take_pictures(panel.sparkling(), camera).by_lamp.at(0);
    };
    const PanelPicture flat = seen({}), still = seen({.wa = 1e-7}), wavy = seen({.wb = 0.02});
    ASSERT_EQ(flat.pixel_count(), wavy.pixel_count());
    const auto difference = [&](const PanelPicture& picture) {
        double sum = 0;
        for (std::size_t i = 0; i < flat.pixel_count(); ++i) {
            sum += std::abs(picture.luminance(i) - flat.luminance(i));
        }
        return sum / static_cast<double>(flat.pixel_count()) / mean_luminance(flat);
    };
    EXPECT_LT(difference(still), 5e-5);  // found: 7e-6
    EXPECT_GT(difference(wavy), 0.1);
    EXPECT_NEAR(mean_luminance(wavy), mean_luminance(flat),
                4 * std::hypot(standard_error_of_mean(wavy), standard_error_of_mean(flat)));
}

TEST(SparkleCamera, SeesOnAverageWhatTheSmoothPaintShows) {
    const Panel panel(mirrors(20, 1.0, 0.3));
    const SparkleCamera camera{.pixel_um = 25, .field_mm = 6, .lamps_deg = {15, 45}};
    const bsdf::Microflake smooth(panel.paint);
    const PanelPictures mean = take_pictures(smooth, camera);
    const PanelPictures seen = take_pictures(panel.sparkling(1, false), camera);
    EXPECT_TRUE(seen.flakes_resolved);
    for (std::size_t i = 0; i < camera.lamps_deg.size(); ++i) {
        const double error = standard_error_of_mean(seen.by_lamp[i]);
        EXPECT_LT(error, 0.25 * mean.by_lamp[i].luminance(0));
        EXPECT_NEAR(mean_luminance(seen.by_lamp[i]), mean.by_lamp[i].luminance(0), 4 * error);
    }
    // In diffuse light: the albedo less the specular reflectance of the interface.
    const auto bound = smooth.bind({400, 440, 480, 520, 560, 600, 640, 680});
    const double specular = std::pow((1.5 - 1) / (1.5 + 1), 2);
    const double expected = bound->albedo({0, 0, 1})[4] - specular;
    const double error = standard_error_of_mean(seen.diffuse[0]);
    EXPECT_LT(error, 0.03 * expected);
    EXPECT_NEAR(mean_luminance(seen.diffuse[0]), expected, 4 * error);
}

// A few specular flakes under uniform light: all are equally bright, whatever their slopes. Then
// the picture is shot noise of discs, whose relative power spectrum is, by Campbell's theorem,
//   P(q) = (2 J_1(x)/x)^2 / density,  x = pi d q                       [kingman-1993, section 3.2]
// but for the light in the rings of the lobes, which the model spreads over all flakes.
TEST(SparkleCamera, GrainOfSparseMirrorsIsThatOfShotNoise) {
    constexpr double kDiameter_mm = 0.06, kDepth = 0.02;
    paint::Recipe recipe = mirrors(1e3 * kDiameter_mm, kDepth);
    recipe.binder = optics::Material(1.0);  // no light returns from the interface
    const Panel panel(recipe);
    const SparkleCamera camera{
        .pixel_um = 25, .field_mm = 12, .lamps_deg = {}, .diffuse_samples = 16};
    const Viewing viewing;
    double mean = 0, error = 0;
    constexpr int kPanels = 3;
    for (int i = 0; i < kPanels; ++i) {
        const auto m = measure_pictures(camera, take_pictures(panel.sparkling(i), camera), viewing);
        mean += m.diffuse->graininess.value / kPanels;
        error += std::pow(m.diffuse->graininess.standard_error / kPanels, 2);
    }
    error = std::sqrt(error);
    const double density = kDepth / (std::numbers::pi / 4 * kDiameter_mm * kDiameter_mm);
    const double per_degree = mm_per_degree(viewing);
    const double luminance = luminance_cd_m2(viewing, 0.8 * kDepth);
    double squared = 0;
    constexpr double kStep = 0.01;  // per deg
    for (double u = 0.5 * kStep; u < 80; u += kStep) {
        const double x = std::numbers::pi * kDiameter_mm * u / per_degree;
        const double disc = 2 * std::cyl_bessel_j(1, x) / x;
        const double s = contrast_sensitivity(u, luminance, kPanelSide_mm / per_degree);
        squared += 2 * std::numbers::pi * u * kStep * s * s * disc * disc;
    }
    const double expected =
        sparkle::DiffractionLobe::kLobePower * std::sqrt(2 * squared / density) / per_degree;
    EXPECT_LT(error, 0.04 * expected);
    // Light reflected by two flakes, and the depth of a flake, contribute 2 % at most.
    EXPECT_NEAR(mean, expected, 4 * error + 0.02 * expected);
}

// Large pixels hold so many flakes that the model would represent several by one: they are
// evaluated in patches.
TEST(SparkleCamera, GrainDoesNotDependOnThePixels) {
    const Panel panel(mirrors(15, 2));
    const bsdf::Nacre surface = panel.sparkling();
    double grain[2], error = 0;
    for (int i = 0; i < 2; ++i) {
        const SparkleCamera camera{.pixel_um = i == 0 ? 20.0 : 50.0,
                                   .field_mm = 5,
                                   .lamps_deg = {},
                                   .diffuse_samples = 64};
        const Estimate g =
            measure_pictures(camera, take_pictures(surface, camera)).diffuse->graininess;
        grain[i] = g.value;
        error = g.standard_error;
    }
    // The same flakes. The pixel's own blur differs by 2 %, the noise of the directions makes 3 %.
    // Without patches graininess would be more than three times as large.
    EXPECT_NEAR(grain[1] / grain[0], 1, 0.08);
    EXPECT_LT(error, 0.2 * grain[0]);
}

TEST(SparkleCamera, ValuesDoNotDependOnTheNumberOfThreads) {
    const Panel panel(mirrors(20, 1.5));
    const bsdf::Nacre surface = panel.sparkling();
    const SparkleCamera camera{.pixel_um = 25, .field_mm = 1.5};
    PanelPictures by_threads[2];
    for (int i = 0; i < 2; ++i) {
        const ThreadLimit threads(i + 1);
        by_threads[i] = take_pictures(surface, camera);
    }
    for (std::size_t lamp = 0; lamp < camera.lamps_deg.size(); ++lamp) {
        EXPECT_EQ(by_threads[0].by_lamp[lamp].xyz, by_threads[1].by_lamp[lamp].xyz);
    }
    EXPECT_EQ(by_threads[0].diffuse[1].xyz, by_threads[1].diffuse[1].xyz);
    EXPECT_NE(by_threads[0].diffuse[0].xyz, by_threads[0].diffuse[1].xyz);
}

TEST(SparkleCamera, StopsWhenAsked) {
    const Panel panel(mirrors(20, 1.5));
    EXPECT_THROW(
        take_pictures(panel.sparkling(), small_camera(), [](double done) { return done < 0.3; }),
        Error);
}

TEST(SparkleCamera, NumbersOutOfRangeAreRefusedByName) {
    const auto complaint = [](const SparkleCamera& camera) {
        return message_of<DomainError>([&] { check(camera); });
    };
    EXPECT_THAT(complaint({.pixel_um = 0.1}), HasSubstr("pixel in um = 0.1"));
    EXPECT_THAT(complaint({.field_mm = 500}), HasSubstr("field of the camera in pixels = 20000"));
    EXPECT_THAT(complaint({.field_mm = std::nan("")}), HasSubstr("field of the camera"));
    EXPECT_THAT(complaint({.lamps_deg = {15, 90}}), HasSubstr("angle of a lamp in deg = 90"));
    EXPECT_THAT(complaint({.lamps_deg = std::vector<double>(17, 15)}),
                HasSubstr("number of lamps = 17"));
    EXPECT_EQ(complaint({.lamps_deg = std::vector<double>(16, 15)}), "accepted");
    EXPECT_THAT(complaint({.lamp_half_angle_deg = 5}), HasSubstr("half-angle"));
    EXPECT_THAT(complaint({.diffuse_samples = 3}), HasSubstr("must be even"));
    EXPECT_EQ(complaint({}), "accepted");
}

}  // namespace
}  // namespace nacre::measure
