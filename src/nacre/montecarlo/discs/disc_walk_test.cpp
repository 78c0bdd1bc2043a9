#include "nacre/montecarlo/discs/disc_walk.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/montecarlo/plane_walk.h"
#include "nacre/testing/discs.h"
#include "nacre/testing/statistics.h"

namespace nacre::montecarlo {
namespace {

using test::Estimates;
using test::kOnGrid;

bsdf::Patch patch_at(float x_mm, float y_mm, Vec3f tangent = {1, 0, 0}) {
    bsdf::Patch patch;
    patch.footprint.position_mm = {x_mm, y_mm, 0};
    patch.footprint.tangent = tangent;
    return patch;
}

/// One mirror across the whole tile: flakes wider than it, hardly tilted.
paint::Recipe one_mirror() {
    paint::Recipe recipe = test::opaque(2, 15, 400, 0.005, 1);
    recipe.binder = optics::Material(1.0);
    return recipe;
}

TEST(DiscWalk, LosesNoLightWhereNothingAbsorbs) {
    paint::Recipe recipe = test::opaque(3, 15, 5, 0.3, 0);
    recipe.layers[0].flakes[0].body = paint::PrescribedFlake{0.7, 0.3, 0.3};
    recipe.layers[0].pigments.push_back({paint::PigmentCoefficients{20, 0, 0.5}});
    recipe.substrate_reflectance = 1;
    for (const bool diffraction : {false, true}) {
        const auto surface = DiscWalk(recipe, {0.2, 0.2, 1, diffraction}).bind(kOnGrid);
        Rng rng(3, 4);
        for (const double theta : {0., 45., 85.}) {
            for (int i = 0; i < 3000; ++i) {
                const float u_select = rng.uniform_float(), u = rng.uniform_float();
                const auto sample =
                    surface->sample(test::direction(theta, 20), u_select, {u, rng.uniform_float()});
                ASSERT_TRUE(sample);
                for (int lane = 0; lane < kLanes; ++lane)
                    ASSERT_NEAR(sample->weight[lane], 1, 1e-5);
                ASSERT_GT(sample->wo.z, 0);
            }
        }
    }
}

TEST(DiscWalk, FlatFlakesReflectSpecularly) {
    // Slopes of 0.0035, no diffraction, no interface: the exit is where geometry puts it.
    const auto surface =
        DiscWalk(one_mirror(), {.tile_width_mm = 1, .tile_height_mm = 1, .diffraction = false})
            .bind(kOnGrid);
    const Vec3f wi = test::direction(40, 30);
    int left = 0, once = 0;
    for (int i = 0; i < 500; ++i) {
        const auto sample =
            surface->sample_on(patch_at(0.002f * i, 0.5f), wi, 0.5f, {0.002f * i, 0.3f});
        if (!sample) continue;  // into the black substrate
        EXPECT_EQ(sample->exit_mm.z, 0);
        ++left;
        // Down to the flake and back up, 50 to 65 um deep.
        const double way_mm = length(sample->exit_mm);
        once += dot(sample->wo, {-wi.x, -wi.y, wi.z}) > 0.999 &&
                way_mm > 0.1 * std::tan(test::degrees(39)) &&
                way_mm < 0.13 * std::tan(test::degrees(41));
    }
    EXPECT_GT(left, 350);
    EXPECT_GT(once, 0.97 * left)
        << "the others were reflected several times between crossing flakes";
}

TEST(DiscWalk, PositionsTurnWithTheFrame) {
    // The same position and direction in space, given in two frames.
    const auto surface = DiscWalk(test::opaque(1, 15, 50, 0.2, 1),
                                  {.tile_width_mm = 1, .tile_height_mm = 1, .diffraction = false})
                             .bind(kOnGrid);
    const Vec3f wi = test::direction(30, 0);
    const float c = std::cos(0.7f), s = std::sin(0.7f);
    int found = 0, both = 0;
    for (int i = 0; i < 200; ++i) {
        const float x = 0.005f * i, y = 0.37f;
        // Opaque white flakes over black, and u_select beyond the specular lobe: no random choice
        // differs.
        const auto a = surface->sample_on(patch_at(x, y), wi, 0.9f, {0.1f, 0.2f});
        const Vec3f turned{c * wi.x + s * wi.y, -s * wi.x + c * wi.y, wi.z};
        const auto b = surface->sample_on(patch_at(x, y, {c, s, 0}), turned, 0.9f, {0.1f, 0.2f});
        if (!a || !b) continue;
        ++both;
        const Vec3f back{c * b->wo.x - s * b->wo.y, s * b->wo.x + c * b->wo.y, b->wo.z};
        found += length(back - a->wo) < 1e-3f;
    }
    // All but those that the interface has reflected internally, at random.
    EXPECT_GT(both, 60);
    EXPECT_GT(found, 0.85 * both);
}

/// Fraction of the light reflected by flat flakes of Gaussian slopes within a radius of the Airy
/// pattern in x. Reflection turns light by twice the slope; `turn` is the deviation of that on each
/// axis, in x. A sum over quantiles of the pattern and of Rayleigh's law, and over the angle
/// between the two.
double power_within(double radius, double turn) {
    constexpr int kRings = 300, kTurns = 60, kAngles = 60;
    double within = 0;
    for (int i = 0; i < kRings; ++i) {
        const double x = AiryDisc::radius_of_fraction((i + 0.5) / kRings);
        for (int j = 0; j < kTurns; ++j) {
            const double r = turn * std::sqrt(-2 * std::log(1 - (j + 0.5) / kTurns));
            for (int k = 0; k < kAngles; ++k) {
                const double cosine = std::cos(std::numbers::pi * (k + 0.5) / kAngles);
                within += x * x + r * r + 2 * x * r * cosine < radius * radius;
            }
        }
    }
    return within / (kRings * kTurns * kAngles);
}

TEST(DiscWalk, DiffractionSpreadsTheMirrorImageByTheAiryPattern) {
    // Flakes of 8 um, nearly flat, in a binder of index 1, each lit alone: slopes of deviation
    // alpha / sqrt(2) on each axis turn the flash by twice as much.
    constexpr double kDiameter_um = 8, kAlpha = 0.005;
    paint::Recipe recipe = one_mirror();
    recipe.layers[0].flakes[0].orientation.beckmann_alpha = kAlpha;
    recipe.layers[0].flakes[0].diameter_um = kDiameter_um;
    recipe.layers[0].flakes[0].amount = paint::AreaDensity{0.02 / 15};
    const auto surface = DiscWalk(recipe, {.tile_width_mm = 2, .tile_height_mm = 2}).bind(kOnGrid);
    double mean_um = 0;
    for (double w : kOnGrid) mean_um += 1e-3 * w / kLanes;
    const double x_per_q = std::numbers::pi * kDiameter_um / mean_um;
    // Half of the maximum, where the enclosed power grows fastest with the radius, and the first
    // dark ring, which tests the tail.
    constexpr std::array<double, 2> kRadii{1.6163, 3.8317};
    constexpr int kCount = 20'000;
    std::array<int, 2> within{};
    Rng rng(5);
    for (int all = 0; all < kCount;) {
        const float u_select = rng.uniform_float(), u = rng.uniform_float();
        const auto sample = surface->sample({0, 0, 1}, u_select, {u, rng.uniform_float()});
        if (!sample) continue;
        ++all;
        const double x = x_per_q * std::hypot(sample->wo.x, sample->wo.y);
        for (std::size_t r = 0; r < kRadii.size(); ++r) within[r] += x < kRadii[r];
    }
    for (std::size_t r = 0; r < kRadii.size(); ++r) {
        // The part of the pattern beyond the horizon is drawn anew.
        const double expected =
            power_within(kRadii[r], std::sqrt(2.0) * kAlpha * x_per_q) / encircled_power(x_per_q);
        // The slopes of some thousand flakes fluctuate less than the samples.
        const double error = std::sqrt(expected * (1 - expected) / kCount);
        EXPECT_NEAR(static_cast<double>(within[r]) / kCount, expected, test::kWorstZ * error);
    }
}

/// Power by bins of exit direction, cosine times azimuth, then in total.
constexpr int kRings = 3, kSectors = 3, kDirections = kRings * kSectors;
Estimates power_by_direction(const bsdf::Bsdf& model, Vec3f wi, int walks, std::uint64_t seed) {
    return test::estimate(
        *model.bind(kOnGrid), wi, walks, kDirections + 1, seed,
        [&](const bsdf::BsdfSample& s, std::vector<FloatLanes>& values) {
            if (s.kind == bsdf::SampleKind::specular) return;
            const int ring = std::min(static_cast<int>(s.wo.z * s.wo.z * kRings), kRings - 1);
            const double turn = std::abs(std::atan2(s.wo.y, s.wo.x)) / std::numbers::pi;
            const int sector = std::min(static_cast<int>(turn * kSectors), kSectors - 1);
            values[ring * kSectors + sector] = s.weight;
            values[kDirections] = s.weight;
        });
}

/// Within the noise and 0.5 % of the light: for the hot spot of flakes of 1/200 of the layer's
/// thickness, and for the fluctuation of one specimen of some 300 000 flakes.
void expect_same_light(const Estimate& found, const Estimate& expected) {
    EXPECT_NEAR(found.value, expected.value,
                test::kWorstZ * std::hypot(expected.standard_error, found.standard_error) +
                    0.005 * expected.value);
}

/// Flakes so small that the light's way in and its way out are uncorrelated.
paint::Recipe fine(paint::Recipe recipe) {
    for (paint::Layer& layer : recipe.layers) {
        for (paint::FlakeSpecies& species : layer.flakes) {
            species.diameter_um = 0.075;
            species.diameter_spread_um = 0.025;
        }
    }
    return recipe;
}

TEST(DiscWalk, SmallFlakesFollowTheTransferEquation) {
    paint::Recipe recipe = test::opaque(1.5, 15, 1, 0.2);
    recipe.layers[0].flakes[0].body =
        paint::PrescribedFlake{spectra::Spectrum({400, 700}, {0.4, 0.8}), 0.15, 0.3};
    recipe.layers[0].pigments.push_back({paint::PigmentCoefficients{30, 10, 0.4}});
    recipe.substrate_reflectance = 0.4;
    recipe.clearcoat->absorption_per_mm = spectra::Spectrum({400, 700}, {5, 1});
    recipe = fine(recipe);
    const Vec3f wi = test::direction(45, 0);
    const Estimates expected = power_by_direction(PlaneWalk(recipe), wi, 300'000, 1);
    const Estimates found = power_by_direction(
        DiscWalk(
            recipe,
            {.tile_width_mm = 0.03, .tile_height_mm = 0.03, .specimen = 2, .diffraction = false}),
        wi, 150'000, 2);
    for (std::size_t bin = 0; bin < expected.size(); ++bin) {
        SCOPED_TRACE(bin < kDirections ? testing::Message() << "bin " << bin
                                       : testing::Message() << "all");
        for (int lane = 0; lane < kLanes; ++lane) {
            EXPECT_GT(expected[bin][lane].value, 10 * expected[bin][lane].standard_error);
            expect_same_light(found[bin][lane], expected[bin][lane]);
        }
    }
}

// As above, of flakes with all that they may have besides: the walk in depth has laws of slopes of the
// surfaces where the discs have planes and pieces of them.
TEST(DiscWalk, FlakesAsTheyAreFollowTheTransferEquation) {
    paint::Recipe recipe = fine(test::opaque(0.5, 15, 1, 0.15));
    paint::FlakeSpecies ragged = recipe.layers[0].flakes[0], wavy = ragged, pearl = ragged;
    ragged.orientation.law = paint::Orientation::Law::ggx;
    ragged.orientation.alpha_bottom = 0.2;
    ragged.edge_um = 0.005;
    wavy.body = paint::PrescribedFlake{0.6, 0.2, 0.3};
    wavy.waviness = 0.2;
    pearl.body = optics::Platelet{{optics::Material(optics::ComplexIndex(0.9, 6)), 40, {}},
                                  {{optics::Material(2.9), 90, {}}},
                                  optics::Platelet::CoatedSides::one};
    recipe.layers[0].flakes = {ragged, wavy, pearl};
    const Vec3f wi = test::direction(45, 0);
    const Estimates expected = power_by_direction(PlaneWalk(recipe), wi, 300'000, 1);
    const Estimates found = power_by_direction(
        DiscWalk(
            recipe,
            {.tile_width_mm = 0.03, .tile_height_mm = 0.03, .specimen = 2, .diffraction = false}),
        wi, 150'000, 2);
    for (std::size_t bin = 0; bin < expected.size(); ++bin) {
        SCOPED_TRACE(bin);
        for (int lane = 0; lane < kLanes; ++lane) {
            expect_same_light(found[bin][lane], expected[bin][lane]);
        }
    }
    // Flat flakes in place of wavy ones are another paint.
    recipe.layers[0].flakes[1].waviness = 0;
    const Estimates flat = power_by_direction(PlaneWalk(recipe), wi, 300'000, 1);
    double apart = 0;
    for (int bin = 0; bin < kDirections; ++bin) {
        apart = test::worse(
            apart, std::abs(flat[bin][0].value - expected[bin][0].value) / expected[bin][0].value);
    }
    EXPECT_GT(apart, 0.05);
}

TEST(DiscWalk, PigmentsAloneScatterAsInTheReference) {
    paint::Recipe recipe = test::paint_of(1.5, {test::pigment_layer(0.8, 1.0, 0.4)}, 0.3);
    const Vec3f wi = test::direction(30, 0);
    const auto expected = test::walked_albedo(*PlaneWalk(recipe).bind(kOnGrid), wi, 200'000);
    const auto found = test::walked_albedo(*DiscWalk(recipe, {1, 1}).bind(kOnGrid), wi, 200'000, 2);
    // To see 2 %. Without films all wavelengths are alike.
    EXPECT_LT(expected[0].standard_error, 0.005 * expected[0].value);
    EXPECT_LT(std::abs(z_score(found[0], expected[0])), test::kWorstZ);
}

TEST(DiscWalk, PearlsOfManyFilmsHaveTheMeanOfTheReference) {
    const paint::Recipe recipe = fine(test::pearl());
    const Vec3f wi = test::direction(45, 0);
    const auto expected = test::walked_albedo(*PlaneWalk(recipe).bind(kOnGrid), wi, 150'000);
    const auto found = test::walked_albedo(
        *DiscWalk(recipe, {.tile_width_mm = 0.035, .tile_height_mm = 0.035, .diffraction = false})
             .bind(kOnGrid),
        wi, 100'000, 2);
    for (int lane = 0; lane < kLanes; ++lane) {
        SCOPED_TRACE(kOnGrid[lane]);
        expect_same_light(found[lane], expected[lane]);
    }
}

TEST(DiscWalk, LargeFlakesAreBrighterThanTheTransferEquationSays) {
    // The hot spot again, through the whole walk.
    const Vec3f wi = test::direction(20, 0);
    const paint::Recipe recipe = test::opaque(2, 15, 20);
    const auto equation = test::walked_albedo(*PlaneWalk(recipe).bind(kOnGrid), wi, 50'000);
    const auto discs = test::walked_albedo(*DiscWalk(recipe, {4, 4}).bind(kOnGrid), wi, 50'000);
    EXPECT_GT(discs[0].value, 1.1 * equation[0].value);
}

TEST(DiscWalk, EvalAndPdfAreZeroAndTheTileRepeats) {
    const DiscWalk model(test::opaque(1, 15, 20), {});
    EXPECT_EQ(model.surface_coordinates(), bsdf::SurfaceCoordinates::object_space);
    const auto surface = model.bind(kOnGrid);
    const Vec3f wi = test::direction(30, 0), wo = test::direction(30, 180);
    EXPECT_EQ(lane_max(surface->evaluate_on(patch_at(1, 1), wi, wo).f), 0);
    EXPECT_EQ(surface->pdf(wi, wo), 0);
    EXPECT_FALSE(surface->sample_on(patch_at(1, 1), test::direction(91, 0), 0.5f, {0.5f, 0.5f}));
    // Far outside the tile it repeats.
    for (int i = 0; i < 20; ++i) {
        const float x = 0.37f * i;
        const auto here = surface->sample_on(patch_at(x, 2), wi, 0.9f, {0.1f, 0.2f});
        const auto there = surface->sample_on(patch_at(x - 50, 72), wi, 0.9f, {0.1f, 0.2f});
        ASSERT_EQ(here.has_value(), there.has_value());
        EXPECT_TRUE(!here || length(here->wo - there->wo) < 0.05f) << "float";
    }
}

TEST(DiscWalk, RefusesWhatItCannotDo) {
    const paint::Recipe recipe = test::opaque(1, 15, 20);
    EXPECT_THROW(DiscWalk(recipe, {.tile_width_mm = 0}), DomainError);
    EXPECT_THROW(DiscWalk(recipe, {.tile_width_mm = 900, .tile_height_mm = 900}), DomainError)
        << "too many flakes";
    paint::Recipe thick = recipe;
    thick.layers[0].thickness_um = 2000;
    EXPECT_THROW(DiscWalk(thick, {.tile_width_mm = 0.1}), DomainError) << "narrower than thick";
    paint::Recipe bad = recipe;
    bad.layers[0].flakes[0].orientation.beckmann_alpha = 0;
    EXPECT_THROW(DiscWalk(bad, {}), DomainError);
}

TEST(DiscWalk, StopsWhileItIsMade) {
    for (const paint::Recipe& recipe : {test::opaque(1, 15, 20), test::pearl()}) {
        int calls = 0;
        EXPECT_THROW(
            DiscWalk(recipe, {.tile_width_mm = 1, .tile_height_mm = 1},
                     spectra::default_wavelengths_nm(), [&](double) { return ++calls < 1; }),
            Stopped);
        EXPECT_EQ(calls, 1);
    }
}

}  // namespace
}  // namespace nacre::montecarlo
