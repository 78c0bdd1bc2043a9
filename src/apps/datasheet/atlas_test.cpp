#include "apps/datasheet/atlas.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "apps/report/svg_raster.h"
#include "nacre/core/error.h"
#include "nacre/core/math.h"
#include "nacre/measure/instrument.h"
#include "nacre/optics/thin_film.h"
#include "nacre/testing/errors.h"

namespace nacre::datasheet {
namespace {

using nacre::test::message_of;

std::vector<double> wavelengths() {
    std::vector<double> all;
    for (int w = 400; w <= 700; w += 10) all.push_back(w);
    return all;
}

AtlasFlake titania_on_mica() {
    return {.core = optics::FilmPopulation{optics::find_material("mica"), 500, {60}},
            .film = optics::find_material("TiO2_anatase"),
            .film_spread = {3}};
}

TEST(AngleOnFlake, IsHalfTheAngleBetweenTheRefractedDirections) {
    // In the mirror direction the flake lies flat: Snell's law alone.
    EXPECT_NEAR(cos_on_flake(measure::in_plane(45, 0), 1.5),
                std::cos(std::asin(std::sin(45 * kDegree) / 1.5)), 1e-15);
    // Without refraction, half of lamp to view.
    EXPECT_NEAR(cos_on_flake(measure::in_plane(45, 15), 1), std::cos(37.5 * kDegree), 1e-15);
    EXPECT_NEAR(cos_on_flake(measure::in_plane(45, 110), 1), std::cos(10 * kDegree), 1e-15);
    // At 45as45 the view is along the normal: half the refracted angle of the lamp.
    EXPECT_NEAR(cos_on_flake(measure::in_plane(45, 45), 1.5),
                std::cos(std::asin(std::sin(45 * kDegree) / 1.5) / 2), 1e-15);
    // Lamp and view may be exchanged; back to the lamp means head on.
    EXPECT_DOUBLE_EQ(cos_on_flake(measure::towards(60, 20, 70), 1.5),
                     cos_on_flake(measure::towards(20, 60, 70), 1.5));
    EXPECT_DOUBLE_EQ(cos_on_flake(measure::towards(45, 45, 0), 1.5), 1);
}

TEST(FlakeAtlas, IsTheReflectanceOfTheFlake) {
    const AtlasFlake flake = titania_on_mica();
    const std::vector geometries = {measure::in_plane(45, 15), measure::in_plane(45, 75)};
    const Atlas atlas = flake_atlas(flake, {60, 120}, geometries, wavelengths());
    ASSERT_EQ(atlas.lab.size(), 4u);
    for (std::size_t g = 0; g < 2; ++g) {
        const optics::Platelet platelet{*flake.core, {{flake.film, 120, {3}}}};
        const std::vector<double> cosine = {cos_on_flake(geometries[g], 1.5)};
        const auto table = optics::platelet_table(platelet, 1.5, cosine, wavelengths());
        const auto lab = measure::coloured(geometries[g], wavelengths(), table.reflectance, {}).lab;
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(atlas.at(g, 1)[i], lab[i], 1e-9);
    }
}

// What makers sell: silver 40 to 60 nm, gold 80, red 95 to 105, violet 110, blue 120 to 130, green
// 150 [pfaff-reynders-1999; buxbaum-pfaff-2005], good to 10 nm; seen far from the gloss, where
// flakes are met almost head on.
TEST(FlakeAtlas, TitaniaOnMicaRunsThroughTheColoursThatAreSold) {
    const Atlas atlas = flake_atlas(titania_on_mica(), {50, 80, 95, 110, 125, 150},
                                    {measure::in_plane(45, 75)}, wavelengths());
    const auto hue = [&](int i) { return measure::hue_deg(atlas.lab[i]); };
    EXPECT_LT(measure::chroma(atlas.lab[0]), 12);
    EXPECT_GT(atlas.lab[0][0], 60);
    EXPECT_TRUE(hue(1) > 70 && hue(1) < 105) << "gold: " << hue(1);
    EXPECT_TRUE(hue(2) > 320 || hue(2) < 50) << "red: " << hue(2);
    EXPECT_TRUE(hue(3) > 290 && hue(3) < 330) << "violet: " << hue(3);
    EXPECT_TRUE(hue(4) > 230 && hue(4) < 300) << "blue: " << hue(4);
    EXPECT_TRUE(hue(5) > 130 && hue(5) < 200) << "green: " << hue(5);
}

TEST(FlakeAtlas, AFilmWithoutACoreIsTheFlake) {
    // Half a wavelength of a lossless film between equal media is invisible.
    AtlasFlake flake{.film = optics::Material(2.0)};
    const double cosine = 1;
    const Atlas atlas =
        flake_atlas(flake, {550.0 / 4}, {measure::towards(0, 0, 0)}, {549, 550, 551});
    const optics::Platelet platelet{{optics::Material(2.0), 550.0 / 4, {}}, {}};
    const auto table = optics::platelet_table(platelet, 1.5, std::span(&cosine, 1),
                                              std::vector<double>{549, 550, 551});
    EXPECT_LT(table.reflectance[1], 1e-12);
    EXPECT_LT(atlas.lab[0][0], 0.01);
}

TEST(FlakeAtlas, ADispersiveBinderRefractsEachWavelengthByItsOwnIndex) {
    AtlasFlake flake = titania_on_mica();
    const std::vector geometries = {measure::in_plane(45, 15)};
    const Atlas plain = flake_atlas(flake, {100}, geometries, wavelengths());
    flake.binder = optics::Material("flat", std::vector{300.0, 900.0}, {{1.5, 0.0}, {1.5, 0.0}});
    const Atlas same = flake_atlas(flake, {100}, geometries, wavelengths());
    flake.binder = optics::Material("steep", std::vector{300.0, 900.0}, {{1.6, 0.0}, {1.4, 0.0}});
    const Atlas other = flake_atlas(flake, {100}, geometries, wavelengths());
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(plain.lab[0][i], same.lab[0][i], 1e-6);
    EXPECT_GT(spectra::delta_e_2000(plain.lab[0], other.lab[0]), 0.05);
}

paint::Recipe opaque_pearl() {
    paint::FlakeSpecies flakes;
    flakes.amount = paint::AreaDensity{0.1};
    flakes.orientation.beckmann_alpha = 0.2;
    flakes.body = optics::Platelet{{optics::find_material("mica"), 500, {60}},
                                   {{optics::find_material("TiO2_anatase"), 80, {3}}}};
    paint::Recipe recipe;
    recipe.name = "pearl";
    recipe.layers = {paint::Layer{15, {flakes}, {}}};
    recipe.substrate_reflectance = 0.03;
    return recipe;
}

constexpr const char* kCoat = "layer[0].flakes[0].coats[0].thickness_nm";

// Films of wide spreads take seconds.
TEST(RecipeAtlas, StopsWhileAPaintIsSolved) {
    paint::Recipe recipe = opaque_pearl();
    std::get<optics::Platelet>(recipe.layers[0].flakes[0].body).coats = {
        {optics::find_material("TiO2_anatase"), 80, {80}},
        {optics::find_material("SiO2"), 300, {1000}}};
    int calls = 0;
    EXPECT_EQ(message_of<Error>([&] {
                  recipe_atlas(recipe, kCoat, {80}, {measure::in_plane(45, 15)}, wavelengths(), {},
                               [&](double) { return ++calls < 3; });
              }),
              "computing the films of a flake was stopped");
    EXPECT_EQ(calls, 3);
}

// The claim on which the map of single flakes rests: it shows the hue of the paint.
TEST(RecipeAtlas, HasTheHuesOfTheFlakeAtlas) {
    // Coarse: three hues need no more than a few wavelengths.
    std::vector<double> coarse;
    for (int w = 400; w <= 700; w += 20) coarse.push_back(w);
    const std::vector<double> thickness = {80, 125, 150};
    const std::vector geometries = {measure::in_plane(45, 25)};
    const Atlas paint = recipe_atlas(opaque_pearl(), kCoat, thickness, geometries, coarse);
    const Atlas flake = flake_atlas(titania_on_mica(), thickness, geometries, coarse);
    EXPECT_EQ(paint.column, kCoat);
    for (std::size_t i = 0; i < thickness.size(); ++i) {
        const double apart =
            std::remainder(measure::hue_deg(paint.lab[i]) - measure::hue_deg(flake.lab[i]), 360);
        // Light that met several flakes has been through them, in the complementary colour, and the
        // flakes' own transmittance dims those below: some degrees.
        EXPECT_LT(std::abs(apart), 15) << thickness[i];
        EXPECT_GT(measure::chroma(paint.lab[i]), 10) << thickness[i];
    }
}

TEST(RecipeAtlas, ChangesOnlyTheNumberThatIsNamed) {
    const std::vector<double> three = {500, 550, 600};
    const std::vector geometries = {measure::in_plane(45, 25)};
    const Atlas atlas = recipe_atlas(opaque_pearl(), kCoat, {80}, geometries, three);
    const solver::SolvedPaint paint = solver::solve(opaque_pearl(), three);
    const auto reading =
        measure::coloured(geometries[0], three,
                          [&] {
                              auto f = paint.brdf(45 * kDegree, 20 * kDegree, std::numbers::pi);
                              for (double& v : f) v *= std::numbers::pi;
                              return f;
                          }(),
                          {});
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(atlas.lab[0][i], reading.lab[i], 1e-6);
}

TEST(Atlas, NamesWhatIsWrong) {
    const std::vector geometries = {measure::in_plane(45, 25)};
    EXPECT_THAT(
        message_of<Error>([&] { flake_atlas(titania_on_mica(), {}, geometries, wavelengths()); }),
        testing::HasSubstr("at least one thickness"));
    EXPECT_THAT(message_of<Error>([&] {
                    flake_atlas(titania_on_mica(), std::vector<double>(100'001, 80.0), geometries,
                                wavelengths());
                }),
                testing::HasSubstr("at most 100000"));
    EXPECT_THAT(
        message_of<Error>([&] { flake_atlas(titania_on_mica(), {-5}, geometries, wavelengths()); }),
        testing::HasSubstr("-5"));
    AtlasFlake dark = titania_on_mica();
    dark.binder = optics::Material(5.0);
    EXPECT_THAT(message_of<Error>([&] { flake_atlas(dark, {80}, geometries, wavelengths()); }),
                testing::HasSubstr("index of the binder = 5"));
    EXPECT_THAT(message_of<Error>([&] {
                    recipe_atlas(opaque_pearl(), "layer[0].glitter", {80}, geometries,
                                 wavelengths());
                }),
                testing::HasSubstr("layer[0].glitter"));
    EXPECT_THAT(message_of<Error>([&] {
                    recipe_atlas(opaque_pearl(), kCoat, {80, -1}, geometries, wavelengths());
                }),
                testing::HasSubstr("-1"));
    EXPECT_EQ(message_of<Error>([&] {
                  flake_atlas(titania_on_mica(), {80}, geometries, wavelengths(), {},
                              [](double) { return false; });
              }),
              "making the atlas was stopped");
}

TEST(AtlasOutput, HasOneChipForEachThicknessAndAngle) {
    const std::vector geometries = {measure::in_plane(45, 15), measure::in_plane(45, 110)};
    const Atlas atlas = flake_atlas(titania_on_mica(), {60, 80, 100}, geometries, wavelengths());
    const std::string csv = atlas_csv(atlas);
    EXPECT_THAT(
        csv, testing::StartsWith("thickness_nm,theta_i,aspecular_deg,L,a,b,C,h,chip\n60,45,15,"));
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 7);
    const std::string svg = atlas_svg(atlas);
    std::size_t chips = 0;
    for (std::size_t at = 0; (at = svg.find("<rect x=", at)) != std::string::npos; ++at) ++chips;
    EXPECT_EQ(chips, 6u);
    EXPECT_FALSE(report::png_of_svg(svg).empty());
}

TEST(AtlasOutput, HostileNamesStayText) {
    Atlas atlas{.title = "</text><script>evil()</script>",
                .quantity = "\"&<>",
                .column = "k",
                .caption = "a <b> & \xFF",
                .values = {1},
                .geometries = {measure::in_plane(45, 15)},
                .lab = {{50, 0, 0}}};
    const std::string svg = atlas_svg(atlas);
    EXPECT_THAT(svg, testing::Not(testing::HasSubstr("<script")));
    EXPECT_FALSE(report::png_of_svg(svg).empty());
}

}  // namespace
}  // namespace nacre::datasheet
