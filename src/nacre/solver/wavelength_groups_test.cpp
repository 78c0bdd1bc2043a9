#include "nacre/solver/wavelength_groups.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nacre/testing/layers.h"

namespace nacre::solver {
namespace {

using test::flake_paint;

TEST(WavelengthGroups, AGreyPaintIsSolvedOnce) {
    const auto groups =
        group_wavelengths(make_medium(flake_paint(0.1, 0.6, 0, 1, 1.5), {400, 500, 600, 700}));
    ASSERT_EQ(groups.size(), 1u);
    EXPECT_EQ(groups[0].members, std::vector<int>({0, 1, 2, 3}));
    EXPECT_EQ(groups[0].distinct, std::vector<int>({0}));
    EXPECT_EQ(groups[0].solved_as, std::vector<int>({0, 0, 0, 0}));
}

TEST(WavelengthGroups, WavelengthsThatDifferAreSolvedEach) {
    // A reflectance with two steps: 400 and 450 agree, and so do 600 and 700.
    const spectra::Spectrum steps({400, 460, 590, 700}, {0.2, 0.2, 0.7, 0.7});
    const auto groups = group_wavelengths(
        make_medium(flake_paint(0.1, steps, 0, 1, 1.5), {400, 450, 520, 600, 700}));
    ASSERT_EQ(groups.size(), 1u);
    EXPECT_EQ(groups[0].distinct, std::vector<int>({0, 2, 3}));
    EXPECT_EQ(groups[0].solved_as, std::vector<int>({0, 0, 1, 2, 2}));
}

TEST(WavelengthGroups, EachPartOfThePaintTellsWavelengthsApart) {
    const std::vector<double> wavelengths = {400, 700};
    const spectra::Spectrum rising({400, 700}, {0.2, 0.4});
    const auto distinct = [&](const paint::Recipe& recipe) {
        const auto groups = group_wavelengths(make_medium(recipe, wavelengths));
        return groups.size() == 1 ? groups[0].distinct.size() : 0;
    };
    paint::Recipe ground = flake_paint(0.1, 0.6, 0, 1, 1.5), coat = ground, pigment = ground,
                  absorber = ground, passing = flake_paint(0.1, 0.6, rising, 1, 1.5);
    EXPECT_EQ(distinct(ground), 1u);
    ground.substrate_reflectance = rising;
    coat.clearcoat = paint::Clearcoat{40, rising, 0.0};
    pigment.layers[0].pigments.push_back({paint::PigmentCoefficients{rising, 1.0, 0.5}});
    absorber.layers[0].pigments.push_back({paint::PigmentCoefficients{1.0, rising, 0.5}});
    for (const paint::Recipe* recipe : {&ground, &coat, &pigment, &absorber, &passing}) {
        EXPECT_EQ(distinct(*recipe), 2u);
    }
}

TEST(WavelengthGroups, ADispersiveBinderSplitsThem) {
    paint::Recipe recipe = flake_paint(0.2, 0.6, 0, 1, 1.5);
    recipe.binder = optics::Material("binder", {400, 500, 700},
                                     std::vector<optics::ComplexIndex>{1.6, 1.5, 1.5});
    const auto groups = group_wavelengths(make_medium(recipe, {400, 500, 450, 600}));
    ASSERT_EQ(groups.size(), 3u);
    EXPECT_EQ(groups[0].members, std::vector<int>({0}));
    EXPECT_EQ(groups[1].members, std::vector<int>({1, 3}));
    EXPECT_EQ(groups[1].distinct, std::vector<int>({1}));
    EXPECT_EQ(groups[2].members, std::vector<int>({2}));
}

TEST(WavelengthGroups, ADispersivePaintEqualsItsWavelengthsSolvedAlone) {
    const spectra::Spectrum colour({400, 700}, {0.3, 0.8});
    paint::Recipe recipe = flake_paint(0.3, colour, 0.1, 2, 1.5);
    recipe.binder =
        optics::Material("binder", {400, 700}, std::vector<optics::ComplexIndex>{1.62, 1.48});
    recipe.substrate_reflectance = colour;
    SolverSettings settings;  // the same for all, since the choice looks at the smallest index
    settings.exit_nodes = 16;
    settings.inner_nodes = 12;
    settings.max_orders = 40;
    const std::vector<double> wavelengths = {420, 550, 680};
    const SolvedPaint all = solve(recipe, wavelengths, settings);
    for (int w = 0; w < 3; ++w) {
        const SolvedPaint one = solve(recipe, {wavelengths[w]}, settings);
        for (const double theta : {0.1, 0.8, 1.4}) {
            for (const double phi : {0.5, std::numbers::pi}) {
                const double expected = one.brdf(0.7, theta, phi)[0];
                // Compression allows 1e-4 of the largest value of an order, the series 1e-4 of the
                // peak where one group ends earlier than another.
                EXPECT_NEAR(all.brdf(0.7, theta, phi)[w], expected,
                            1e-4 * one.brdf(0.7, 0.7, std::numbers::pi)[0])
                    << w << ' ' << theta << ' ' << phi;
            }
        }
    }
}

TEST(WavelengthGroups, SelectingAllWavelengthsChangesNothing) {
    paint::Recipe recipe = flake_paint(0.2, 0.6, 0, 1, 1.5);
    recipe.layers[0].pigments.push_back(
        {paint::PigmentCoefficients{spectra::Spectrum({400, 700}, {1, 2}), 0.5, 0.3}});
    const PaintMedium medium = make_medium(recipe, {400, 500, 600});
    EXPECT_TRUE(select_wavelengths(medium, {0, 1, 2}) == medium);
    EXPECT_TRUE(select_wavelengths(medium, {2}) == make_medium(recipe, {600}));
}

}  // namespace
}  // namespace nacre::solver
