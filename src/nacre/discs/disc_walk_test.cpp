#include "nacre/discs/disc_walk.h"

#include <gtest/gtest.h>

#include <cmath>

#include "nacre/core/error.h"
#include "nacre/discs/test_support.h"
#include "nacre/volume/plane_walk.h"

namespace nacre::discs {
namespace {

using test::kOnGrid;
using volume::test::Estimates;

bsdf::Patch patch_at(float x_mm, float y_mm, Vec3f tangent = {1, 0, 0}) {
    bsdf::Patch patch;
    patch.rest.position_mm = {x_mm, y_mm, 0};
    patch.rest.tangent = tangent;
    return patch;
}

/// One mirror across the whole tile: flakes wider than it, hardly tilted.
layers::Recipe one_mirror() {
    layers::Recipe recipe = test::opaque(2, 15, 400, 0.005, 1);
    recipe.binder = optics::Material(1.0);
    return recipe;
}

TEST(DiscWalk, LosesNoLightWhereNothingAbsorbs) {
    layers::Recipe recipe = test::opaque(3, 15, 5, 0.3, 0);
    recipe.layers[0].flakes[0].body = layers::PrescribedFlake{0.7, 0.3, 0.3};
    recipe.layers[0].pigments.push_back({20, 0, 0.5});
    recipe.substrate_reflectance = 1;
    for (const bool diffraction : {false, true}) {
        const auto surface = DiscWalk(recipe, {0.2, 0.2, 1, diffraction}).bind(kOnGrid);
        Rng rng(3, 4);
        for (const double theta : {0., 45., 85.}) {
            for (int i = 0; i < 3000; ++i) {
                const float u_lobe = rng.uniform_float(), u = rng.uniform_float();
                const auto sample = surface->sample(test::from_degrees(theta, 20), u_lobe,
                                                    {u, rng.uniform_float()});
                ASSERT_TRUE(sample);
                for (int lane = 0; lane < kLanes; ++lane)
                    ASSERT_NEAR(sample->weight[lane], 1, 1e-5);
                ASSERT_GT(sample->wo.z, 0);
            }
        }
    }
}

TEST(DiscWalk, FlatFlakesMirror) {
    // Slopes of 0.0035 and no diffraction, no interface: the flash is where geometry has it.
    const auto surface =
        DiscWalk(one_mirror(), {.tile_width_mm = 1, .tile_height_mm = 1, .diffraction = false})
            .bind(kOnGrid);
    const Vec3f wi = test::from_degrees(40, 30);
    int left = 0, once = 0;
    for (int i = 0; i < 500; ++i) {
        const auto sample =
            surface->sample_on(patch_at(0.002f * i, 0.5f), wi, 0.5f, {0.002f * i, 0.3f});
        if (!sample) continue;  // into the black ground
        EXPECT_EQ(sample->exit_mm.z, 0);
        ++left;
        // Down to the flake and back up, 50 to 65 um deep.
        const double way_mm = length(sample->exit_mm);
        once += dot(sample->wo, {-wi.x, -wi.y, wi.z}) > 0.999 &&
                way_mm > 0.1 * std::tan(test::degrees(39)) &&
                way_mm < 0.13 * std::tan(test::degrees(41));
    }
    EXPECT_GT(left, 350);
    EXPECT_GT(once, 0.97 * left) << "but for what goes to and fro between crossing flakes";
}

TEST(DiscWalk, PlacesTurnWithTheFrame) {
    // The same place and the same direction in space, told in two frames.
    const auto surface = DiscWalk(test::opaque(1, 15, 50, 0.2, 1),
                                  {.tile_width_mm = 1, .tile_height_mm = 1, .diffraction = false})
                             .bind(kOnGrid);
    const Vec3f wi = test::from_degrees(30, 0);
    const float c = std::cos(0.7f), s = std::sin(0.7f);
    int found = 0, both = 0;
    for (int i = 0; i < 200; ++i) {
        const float x = 0.005f * i, y = 0.37f;
        // Numbers that let no lot change: opaque white flakes, a black ground, the mirror left out.
        const auto a = surface->sample_on(patch_at(x, y), wi, 0.9f, {0.1f, 0.2f});
        const Vec3f turned{c * wi.x + s * wi.y, -s * wi.x + c * wi.y, wi.z};
        const auto b = surface->sample_on(patch_at(x, y, {c, s, 0}), turned, 0.9f, {0.1f, 0.2f});
        if (!a || !b) continue;
        ++both;
        const Vec3f back{c * b->wo.x - s * b->wo.y, s * b->wo.x + c * b->wo.y, b->wo.z};
        found += length(back - a->wo) < 1e-3f;
    }
    // All but those that the interface has turned back, by lots of their own.
    EXPECT_GT(both, 60);
    EXPECT_GT(found, 0.85 * both);
}

TEST(DiscWalk, DiffractionSpreadsTheMirrorImageByTheAiryPattern) {
    // Flakes of 20 um, nearly flat, in a binder of index 1: the share of the flash within the first
    // dark ring, 1.22 lambda / d, is 0.838 for each wavelength; the mean wavelength is 553.75 nm.
    layers::Recipe recipe = one_mirror();
    recipe.layers[0].flakes[0].diameter_um = 20;
    recipe.layers[0].flakes[0].amount = layers::AreaDensity{0.02 / 15};
    const auto surface = DiscWalk(recipe, {.tile_width_mm = 2, .tile_height_mm = 2}).bind(kOnGrid);
    double mean_nm = 0;
    for (double w : kOnGrid) mean_nm += w / kLanes;
    const double ring = 1.21967 * 1e-3 * mean_nm / 20;
    int within = 0, all = 0;
    Rng rng(5);
    while (all < 4000) {
        const float u_lobe = rng.uniform_float(), u = rng.uniform_float();
        const auto sample = surface->sample({0, 0, 1}, u_lobe, {u, rng.uniform_float()});
        if (!sample) continue;
        ++all;
        within += std::hypot(sample->wo.x, sample->wo.y) < ring;
    }
    // Slopes of 0.0035 turn the flash by 0.007 beside a ring of 0.034: it costs 0.02.
    EXPECT_NEAR(static_cast<double>(within) / all, 0.838, 0.04);
}

Estimates power_by_direction(const bsdf::Bsdf& model, Vec3f wi, int walks, std::uint64_t seed) {
    constexpr int kRings = 3, kSectors = 3;
    return volume::test::estimate(
        *model.bind(kOnGrid), wi, walks, kRings * kSectors, seed,
        [&](const bsdf::BsdfSample& s, std::vector<FloatLanes>& values) {
            if (volume::test::is_mirror_image(wi, s.wo)) return;
            const int ring = std::min(static_cast<int>(s.wo.z * s.wo.z * kRings), kRings - 1);
            const double turn = std::abs(std::atan2(s.wo.y, s.wo.x)) / std::numbers::pi;
            const int sector = std::min(static_cast<int>(turn * kSectors), kSectors - 1);
            values[ring * kSectors + sector] = s.weight;
        });
}

/// Flakes so small that light meets none of them twice.
layers::Recipe fine(layers::Recipe recipe) {
    for (layers::Layer& layer : recipe.layers) {
        for (layers::FlakeSpecies& species : layer.flakes) {
            species.diameter_um = 0.15;
            species.diameter_spread_um = 0.05;
        }
    }
    return recipe;
}

TEST(DiscWalk, SmallFlakesSendLightWhereTheTransferEquationDoes) {
    layers::Recipe recipe = test::opaque(1.5, 15, 1, 0.2);
    recipe.layers[0].flakes[0].body =
        layers::PrescribedFlake{spectra::Spectrum({400, 700}, {0.4, 0.8}), 0.15, 0.3};
    recipe.layers[0].pigments.push_back({30, 10, 0.4});
    recipe.substrate_reflectance = 0.4;
    recipe.clearcoat->absorption_per_mm = spectra::Spectrum({400, 700}, {5, 1});
    recipe = fine(recipe);
    constexpr int kWalks = 200'000;
    const Vec3f wi = test::from_degrees(45, 0);
    const auto expected = power_by_direction(volume::PlaneWalk(recipe), wi, kWalks, 1);
    const auto found = power_by_direction(
        DiscWalk(recipe,
                 {.tile_width_mm = 0.06, .tile_height_mm = 0.06, .seed = 2, .diffraction = false}),
        wi, kWalks, 2);
    for (std::size_t bin = 0; bin < expected.size(); ++bin) {
        for (int lane = 0; lane < kLanes; ++lane) {
            const auto& e = expected[bin][lane];
            EXPECT_GT(e.mean, 3 * e.standard_error);
            // The hot spot of flakes of a hundredth of the layer, and the chance of one drawing.
            EXPECT_NEAR(
                found[bin][lane].mean, e.mean,
                test::kWorstZ * std::hypot(e.standard_error, found[bin][lane].standard_error) +
                    0.02 * e.mean)
                << "bin " << bin << ", " << kOnGrid[lane] << " nm";
        }
    }
}

TEST(DiscWalk, PigmentsAloneScatterAsInTheReference) {
    layers::Recipe recipe = test::paint(1.5, {reference::test::pigment_layer(0.8, 1.0, 0.4)}, 0.3);
    const auto expected = test::walked_albedo(*volume::PlaneWalk(recipe).bind(kOnGrid),
                                              test::from_degrees(30, 0), 100'000);
    const auto found = test::walked_albedo(*DiscWalk(recipe, {1, 1}).bind(kOnGrid),
                                           test::from_degrees(30, 0), 100'000);
    EXPECT_LT(std::abs(test::z_score(found[0], expected[0])), test::kWorstZ);
}

TEST(DiscWalk, PearlsOfManyFilmsHaveTheMeanOfTheReference) {
    const layers::Recipe recipe = fine(volume::test::pearl());
    const Vec3f wi = test::from_degrees(45, 0);
    const auto expected =
        test::walked_albedo(*volume::PlaneWalk(recipe).bind(kOnGrid), wi, 100'000);
    const auto found = test::walked_albedo(
        *DiscWalk(recipe, {.tile_width_mm = 0.05, .tile_height_mm = 0.05, .diffraction = false})
             .bind(kOnGrid),
        wi, 100'000);
    for (int lane = 0; lane < kLanes; ++lane) {
        EXPECT_NEAR(
            found[lane].mean, expected[lane].mean,
            test::kWorstZ * std::hypot(found[lane].standard_error, expected[lane].standard_error) +
                0.01 * expected[lane].mean)
            << kOnGrid[lane] << " nm";
    }
}

TEST(DiscWalk, LargeFlakesAreBrighterThanTheTransferEquationSays) {
    // The hot spot again, through the whole walk.
    const Vec3f wi = test::from_degrees(20, 0);
    const layers::Recipe recipe = test::opaque(2, 15, 20);
    const auto equation = test::walked_albedo(*volume::PlaneWalk(recipe).bind(kOnGrid), wi, 50'000);
    const auto discs = test::walked_albedo(*DiscWalk(recipe, {4, 4}).bind(kOnGrid), wi, 50'000);
    EXPECT_GT(discs[0].mean, 1.1 * equation[0].mean);
}

TEST(DiscWalk, OnlySamplesTellWhatItLooksLike) {
    const DiscWalk model(test::opaque(1, 15, 20), {});
    EXPECT_EQ(model.layout(), bsdf::Layout::rest_space);
    const auto surface = model.bind(kOnGrid);
    const Vec3f wi = test::from_degrees(30, 0), wo = test::from_degrees(30, 180);
    EXPECT_EQ(lane_max(surface->evaluate_on(patch_at(1, 1), wi, wo).f), 0);
    EXPECT_EQ(surface->pdf(wi, wo), 0);
    EXPECT_FALSE(surface->sample_on(patch_at(1, 1), test::from_degrees(91, 0), 0.5f, {0.5f, 0.5f}));
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
    const layers::Recipe recipe = test::opaque(1, 15, 20);
    EXPECT_THROW(DiscWalk(recipe, {.tile_width_mm = 0}), DomainError);
    EXPECT_THROW(DiscWalk(recipe, {.tile_width_mm = 900, .tile_height_mm = 900}), DomainError)
        << "too many flakes";
    layers::Recipe thick = recipe;
    thick.layers[0].thickness_um = 2000;
    EXPECT_THROW(DiscWalk(thick, {.tile_width_mm = 0.1}), DomainError) << "narrower than thick";
    layers::Recipe bad = recipe;
    bad.layers[0].flakes[0].orientation.beckmann_alpha = 0;
    EXPECT_THROW(DiscWalk(bad, {}), DomainError);
}

}  // namespace
}  // namespace nacre::discs
