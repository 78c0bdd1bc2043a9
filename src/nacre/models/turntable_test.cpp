#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "nacre/core/random.h"
#include "nacre/render/render.h"
#include "nacre/sparkle/diffraction_lobe.h"
#include "nacre/sparkle/flake_field.h"
#include "nacre/testing/plain_flakes.h"

// Pictures of a painted panel on a turntable: flakes flash for as long as the widths of their lobes
// and of the pixels' patches imply, and nothing flickers beyond that.

namespace nacre::models {
namespace {

constexpr int kFrames = 60;  // of a whole turn: what comes after the last is the first
constexpr int kSide = 40;    // pixels
// Lengths in diameters of a flake: of a pixel, and of the patch of a sample. Neighbours overlap.
constexpr double kPitch = 4.0 / 3, kPatch = 2;
constexpr double kLight_deg = 15;
constexpr double kAlpha = 0.1, kIor = 1.5;

using Turn = std::array<double, kFrames>;  // by frame, by lag, or by frequency
using Frames = std::array<std::vector<float>, kFrames>;

/// The light of single flakes in each pixel and frame of a turn about the panel's normal, under a
/// camera that looks down it. With one sample a pixel and light from one direction, only the flakes
/// are random.
Frames film(const paint::Recipe& recipe, double diameter_um, std::uint64_t seed) {
    const double pitch_mm = 1e-3 * kPitch * diameter_um;
    const render::PaintTable paints{{"paint", testing::nacre_surface(recipe, seed)}};
    Frames frames;
    for (int frame = 0; frame < kFrames; ++frame) {
        render::SceneDescription scene;
        scene.materials["paint"] = render::PaintMaterial{};
        scene.shapes.push_back({render::FlatPanel{.width_mm = 200, .height_mm = 200},
                                "paint",
                                {.rotation_deg = {0, 0, frame * 360.0f / kFrames}}});
        // So far away that all pixels look down the normal to 5e-4 rad.
        constexpr float kDistance_mm = 1000;
        scene.camera = {.position_mm = {0, 0, kDistance_mm},
                        .up = {0, 1, 0},
                        .vertical_fov_deg = 2 * std::atan(0.5 * kSide * pitch_mm / kDistance_mm) *
                                            180 / std::numbers::pi};
        const auto tilt = static_cast<float>(kLight_deg * std::numbers::pi / 180);
        scene.lights.push_back(
            render::DirectionalLight{.to_light = {std::sin(tilt), 0, std::cos(tilt)}});
        frames[frame] = render::render_with(render::Scene(scene, paints),
                                            {.width = kSide,
                                             .height = kSide,
                                             .samples_per_pixel = 1,
                                             .max_depth = 1,
                                             .footprint_pixels = kPatch / kPitch,
                                             .sparkle = true},
                                            render::DirectLight::light_sampling)
                            .sparkle;
    }
    return frames;
}

/// The area that two discs of diameter 1 share at this distance, over that of one.
double lens(double distance) {
    if (distance >= 1) return 0;
    return 2 / std::numbers::pi *
           (std::acos(distance) - distance * std::sqrt(1 - distance * distance));
}

/// Campbell's theorem for the same pixel at two moments: the flakes that its patch shows at both,
/// which have moved on by an angle about the axis.                  [docs/nacre-model.md]
///
/// That the square has turned as well is neglected: after 6 deg it makes 0.2 %, and after 45 deg
/// all lobes have passed.
/// @param place  in diameters
double shared_places(Vec2f place, double angle) {
    const double step = 2 * std::sin(angle / 2);
    const double dx = -step * place.y, dy = step * place.x;
    if (std::hypot(dx, dy) > 1 + std::numbers::sqrt2 * kPatch) return 0;
    // Differences of two points of a square fall off linearly on each axis.
    constexpr int kSteps = 20;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        const double u = 2 * (i + 0.5) / kSteps - 1;
        for (int j = 0; j < kSteps; ++j) {
            const double v = 2 * (j + 0.5) / kSteps - 1;
            sum += (1 - std::abs(u)) * (1 - std::abs(v)) *
                   lens(std::hypot(dx + u * kPatch, dy + v * kPatch));
        }
    }
    return sum;
}

/// The same for slopes: flakes whose lobes (`widening` times as wide as their own,
/// FlakeView::widening) contain both half vectors, which lie at the same tilt, an angle apart about
/// the normal.
double shared_slopes(double diameter_um, double widening, double angle) {
    const sparkle::DiffractionLobe lobe(kAlpha, kIor);
    // In the paint: Snell's law, then half way between the normal and the light, in rad.
    const double tilt = std::asin(std::sin(kLight_deg * std::numbers::pi / 180) / kIor) / 2;
    const auto slope = static_cast<float>(std::tan(tilt));
    const float width =
        lobe.radius_at(splat(static_cast<float>(widening * lobe.radius(diameter_um))),
                       splat(1 + slope * slope), splat(static_cast<float>(std::cos(tilt))))[0];
    const auto x2 = static_cast<float>(slope * std::cos(angle));
    const auto y2 = static_cast<float>(slope * std::sin(angle));
    constexpr int kSteps = 60;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        for (int j = 0; j < kSteps; ++j) {
            const float x = slope + width * (2 * (i + 0.5f) / kSteps - 1);
            const float y = width * (2 * (j + 0.5f) / kSteps - 1);
            const float first = (x - slope) * (x - slope) + y * y;
            const float second = (x - x2) * (x - x2) + (y - y2) * (y - y2);
            if (first >= width * width || second >= width * width) continue;
            sum += double{lobe.slope_density(x * x + y * y)} * lobe.density(first, width) *
                   lobe.density(second, width);
        }
    }
    return sum;
}

/// Power by frequency, in flashes a turn, from a correlation by lag.
Turn power_of(const Turn& correlation) {
    Turn power{};
    for (int f = 0; f < kFrames; ++f) {
        for (int lag = 0; lag < kFrames; ++lag) {
            power[f] +=
                correlation[lag] * std::cos(2 * std::numbers::pi * f * lag / kFrames) / kFrames;
        }
    }
    return power;
}

/// Pixels by how many diameters of a flake they lie from the axis.
struct Ring {
    double from, to;
    bool holds(Vec2f p) const {
        const double r = std::hypot(p.x, p.y);
        return r >= from && r < to;
    }
};

/// In diameters.
Vec2f middle(int pixel) {
    return {static_cast<float>((pixel % kSide + 0.5 - kSide / 2) * kPitch),
            static_cast<float>((kSide / 2 - pixel / kSide - 0.5) * kPitch)};
}

/// Correlation by lag over the pixels of a ring; its value at lag 0 is the variance.
Turn measured(const Frames& frames, const Ring& ring) {
    Turn correlation{};
    int pixels = 0;
    for (int p = 0; p < kSide * kSide; ++p) {
        if (!ring.holds(middle(p))) continue;
        ++pixels;
        for (int a = 0; a < kFrames; ++a) {
            for (int lag = 0; lag < kFrames; ++lag) {
                // Sparkle has mean 0 (sparkle_test.cpp), so none is subtracted. Green only.
                correlation[lag] +=
                    double{frames[a][3 * p + 1]} * frames[(a + lag) % kFrames][3 * p + 1] / kFrames;
            }
        }
    }
    for (double& c : correlation) c /= pixels;
    return correlation;
}

/// The same by Campbell's theorem, up to one factor.
Turn predicted(const Ring& ring, double diameter_um, double widening) {
    constexpr int kPlacesPerPixel = 8;
    Turn correlation{};
    Rng rng(17, 0);
    for (int p = 0; p < kSide * kSide; ++p) {
        const Vec2f at = middle(p);
        if (!ring.holds(at)) continue;
        // Samples lie about the middle of their pixel with the density of a tent.
        const auto tent = [&] {
            return static_cast<float>(kPitch) * (rng.uniform_float() + rng.uniform_float() - 1);
        };
        for (int n = 0; n < kPlacesPerPixel; ++n) {
            const Vec2f place{at.x + tent(), at.y + tent()};
            for (int lag = 0; lag <= kFrames / 2; ++lag) {
                correlation[lag] += shared_places(place, 2 * std::numbers::pi * lag / kFrames);
            }
        }
    }
    for (int lag = 0; lag <= kFrames / 2; ++lag) {
        correlation[lag] *=
            shared_slopes(diameter_um, widening, 2 * std::numbers::pi * lag / kFrames);
        correlation[(kFrames - lag) % kFrames] = correlation[lag];
    }
    return correlation;
}

constexpr int kSeeds = 6;
constexpr std::array<Ring, 3> kRings{{{0, 5}, {25.0 / 3, 12.5}, {50.0 / 3, 65.0 / 3}}};

/// One case for each way in which a patch shows its flakes (sparkle/flake_view.h).
struct Paint {
    const char* name;
    double diameter_um, cover;
    double min_widening, max_widening;  ///< FlakeView::widening must lie between them
};

// One patch shows 11 flakes at a cover of 1, without rims 5.
constexpr Paint kPaints[] = {
    {"EveryFlakeResolved", 6, 1, 1, 1},
    // 450 faint ones. Their lobes are as wide as lobes get; most are in the background.
    {"MostInTheBackground", 6, 40, 1, 1},
    // The level of 15 flakes in 16 has nearly faded out.
    {"DensestLevelFading", 20, 14.6, 1.8, 2.6},
    // It has: lobes are 3 times as wide, and the remaining variance is in the background.
    {"DensestLevelFaded", 20, 20, 3, 3.1},
};

class Turntable : public ::testing::TestWithParam<Paint> {
 protected:
    /// Correlations of each ring, by seed.
    using Films = std::array<std::array<Turn, kSeeds>, kRings.size()>;
    Films films() const {
        const auto [name, diameter_um, cover, min_widening, max_widening] = GetParam();
        const testing::PlainFlakes flakes{.diameter_um = diameter_um,
                                          .alpha = kAlpha,
                                          .ior = kIor,
                                          .cover = cover,
                                          .reflectance = 0.5 / cover,
                                          .transmittance = 1 - 0.5 / cover};
        const paint::Recipe recipe = testing::recipe_of(flakes);
        Films films{};
        for (int seed = 0; seed < kSeeds; ++seed) {
            const Frames frames = film(recipe, diameter_um, static_cast<std::uint64_t>(seed));
            for (std::size_t r = 0; r < kRings.size(); ++r) {
                films[r][seed] = measured(frames, kRings[r]);
            }
        }
        return films;
    }
};

/// FlakeView::widening on a patch of the pictures.
double widening_of(const Paint& paint) {
    const double radius_mm = 0.5e-3 * paint.diameter_um;
    const sparkle::FlakeField field(
        {.density_per_mm2 = paint.cover / (std::numbers::pi * radius_mm * radius_mm),
         .diameter_um = paint.diameter_um,
         .alpha = kAlpha,
         .ior = kIor},
        0);
    const auto side_mm = static_cast<float>(2 * kPatch * radius_mm);
    const auto view = std::make_unique<sparkle::FlakeView>();
    field.query({.position_mm = {}, .edge_mm = {{side_mm, 0, 0}, {0, side_mm, 0}}}, *view);
    return view->widening;
}

/// A quotient of sums over the seeds, and its standard error by leaving out one seed at a time.
struct Fraction {
    double value, error;
};
template <class Part>
Fraction fraction_of_variance(const std::array<Turn, kSeeds>& turns, Part&& part) {
    double a = 0, b = 0, squares = 0;
    for (const Turn& t : turns) a += part(t), b += t[0];
    for (const Turn& t : turns) {
        const double without = (a - part(t)) / (b - t[0]);
        squares += (without - a / b) * (without - a / b);
    }
    return {a / b, std::sqrt(squares * (kSeeds - 1) / kSeeds)};
}

TEST_P(Turntable, CorrelationOverTimeFollowsCampbellsFormulaWithoutFlicker) {
    const double widening = widening_of(GetParam());
    ASSERT_GE(widening, GetParam().min_widening);
    ASSERT_LE(widening, GetParam().max_widening);
    const Films all = films();
    // Power above a quarter of the frame rate. Flicker would be white: half of its power is there.
    const auto fast = [](const Turn& correlation) {
        const Turn power = power_of(correlation);
        double sum = 0;
        for (int f = kFrames / 4; f <= kFrames - kFrames / 4; ++f) sum += power[f];
        return sum;
    };
    for (std::size_t r = 0; r < kRings.size(); ++r) {
        SCOPED_TRACE(r);
        const Turn expected = predicted(kRings[r], GetParam().diameter_um, widening);
        for (int lag = 1; lag <= kFrames / 2; ++lag) {
            const Fraction s = fraction_of_variance(all[r], [&](const Turn& t) { return t[lag]; });
            // Four standard errors, which are themselves estimated from six seeds: Student's t with
            // 5 degrees of freedom exceeds four once in a hundred. Where the correlation is nearly
            // 0 some estimates are much too small by chance: hence the slack.
            const double slack = lag == 1 ? 0.005 : 0.02;
            EXPECT_NEAR(s.value, expected[lag] / expected[0], 4 * s.error + slack) << lag;
        }
        const double explained = fast(expected) / expected[0];
        const Fraction s = fraction_of_variance(all[r], fast);
        EXPECT_NEAR(s.value, explained, 4 * s.error + 0.005);
        EXPECT_LT(s.value, r == 0 ? 0.1 : 0.5);
    }
}

INSTANTIATE_TEST_SUITE_P(Paints, Turntable, ::testing::ValuesIn(kPaints),
                         [](const auto& paint) { return paint.param.name; });

}  // namespace
}  // namespace nacre::models
