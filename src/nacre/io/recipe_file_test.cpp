#include "nacre/io/recipe_file.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/io/recipe_test_support.h"
#include "nacre/io/table_reader.h"
#include "nacre/paint/expansion.h"
#include "nacre/paint/recipe_description.h"
#include "nacre/paint/recipe_parameter.h"
#include "nacre/testing/described.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/files.h"
#include "nacre/testing/paints.h"

namespace nacre::io {
namespace {

using namespace recipes;
using nacre::test::message_of;
using nacre::test::replaced;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(RecipeFile, ReadsEveryKeyWithItsUnit) {
    const paint::Recipe recipe = parse(kViolet);
    EXPECT_EQ(recipe.name, "Violet pearl");
    EXPECT_EQ(recipe.binder.index(550), 1.5);
    ASSERT_TRUE(recipe.clearcoat);
    EXPECT_EQ(recipe.clearcoat->thickness_um, 45);
    EXPECT_DOUBLE_EQ(recipe.clearcoat->absorption_per_mm(550), 0.1);
    ASSERT_EQ(recipe.layers.size(), 1u);
    const paint::Layer& layer = recipe.layers[0];
    EXPECT_EQ(layer.thickness_um, 15);
    ASSERT_EQ(layer.flakes.size(), 1u);
    const paint::FlakeSpecies& flakes = layer.flakes[0];
    EXPECT_EQ(flakes.name, "TiO2 on mica");
    EXPECT_EQ(std::get<paint::VolumeFraction>(flakes.amount).value, 0.03);
    EXPECT_EQ(flakes.diameter_um, 18);
    EXPECT_EQ(flakes.diameter_spread_um, 6);
    EXPECT_EQ(flakes.orientation.beckmann_alpha, 0.1);
    const auto& platelet = std::get<optics::Platelet>(flakes.body);
    EXPECT_EQ(platelet.core.material.name(), "mica");
    EXPECT_EQ(platelet.core.thickness_nm, 500);
    EXPECT_EQ(platelet.core.spread.standard_deviation_nm, 60);
    EXPECT_EQ(platelet.core.spread.law, optics::ThicknessSpread::Law::normal);
    ASSERT_EQ(platelet.coats.size(), 1u);
    EXPECT_EQ(platelet.coats[0].thickness_nm, 80);
    EXPECT_EQ(platelet.coats[0].spread.law, optics::ThicknessSpread::Law::uniform);
    ASSERT_EQ(layer.pigments.size(), 1u);
    const auto& pigment = std::get<paint::PigmentCoefficients>(layer.pigments[0].body);
    EXPECT_EQ(pigment.scattering_per_mm(550), 200);
    EXPECT_EQ(pigment.absorption_per_mm(550), 50);
    EXPECT_EQ(pigment.anisotropy, 0.2);
    EXPECT_EQ(recipe.substrate_reflectance(550), 0.05);
    EXPECT_FALSE(recipe.microfacet);
}

const std::string kWhite = R"(ior = 1.5
[[layer]]
thickness_um = 30
[[layer.pigment]]
name = "rutile"
material = "TiO2_rutile"
volume_fraction = 0.15
diameter_nm = 250
spread = 0.2
weighting = "volume"
[[layer.pigment]]
material = "carbon_black"
mass_fraction = 0.01
density_g_per_cm3 = 1.8
diameter_nm = 20
crowding = "independent"
)";

TEST(RecipeFile, ReadsPigmentsByTheirParticles) {
    const paint::Recipe recipe = parse(kWhite);
    ASSERT_EQ(recipe.layers[0].pigments.size(), 2u);
    EXPECT_EQ(recipe.layers[0].pigments[0].name, "rutile");
    const auto& white = std::get<paint::PigmentParticles>(recipe.layers[0].pigments[0].body);
    EXPECT_EQ(volume_fraction(white.amount), 0.15);
    EXPECT_EQ(white.spheres, (optics::Spheres{optics::find_material("TiO2_rutile"), 250, 0.2,
                                              optics::DiameterWeighting::volume}));
    const auto& black = std::get<paint::PigmentParticles>(recipe.layers[0].pigments[1].body);
    EXPECT_EQ(std::get<paint::PigmentMass>(black.amount), (paint::PigmentMass{0.01, 1.8, 1.1}));
    EXPECT_EQ(black.spheres.weighting, optics::DiameterWeighting::number);
    EXPECT_EQ(black.spheres.crowding, optics::Crowding::independent);
    EXPECT_EQ(parse(write_recipe(recipe)), recipe);
}

TEST(RecipeFile, ReadsTheDistributionOfFacets) {
    std::string text = kMicrofacet;
    text.insert(text.find("alpha"), "distribution = \"ggx\"\n");
    const paint::Recipe recipe = parse(text);
    ASSERT_TRUE(recipe.microfacet);
    EXPECT_EQ(recipe.microfacet->distribution, paint::FacetDistribution::ggx);
    EXPECT_EQ(parse(write_recipe(recipe)), recipe);
}

TEST(RecipeFile, ReadsTheMicrofacetTables) {
    const paint::Recipe recipe = parse(kMicrofacet);
    ASSERT_TRUE(recipe.microfacet);
    EXPECT_EQ(recipe.microfacet->film_thickness_nm, 158.333);
    EXPECT_EQ(recipe.microfacet->distribution, paint::FacetDistribution::beckmann);
    ASSERT_TRUE(recipe.microfacet->facets);
    EXPECT_EQ(recipe.microfacet->facets->count, 1e7);
    EXPECT_TRUE(recipe.layers.empty());
}

TEST(RecipeFile, AReflectanceMayBeANumberAColourOrASpectrum) {
    const auto reflectance = [](const std::string& value) {
        const paint::Recipe recipe =
            parse(replaced(replaced(kGray, "transmittance = 0.3\n", ""), "= 0.6", "= " + value));
        return std::get<paint::PrescribedFlake>(recipe.layers[0].flakes[0].body).reflectance;
    };
    EXPECT_EQ(reflectance("0.25")(500), 0.25);
    EXPECT_DOUBLE_EQ(reflectance("{ wavelengths_nm = [400, 500], values = [0.2, 0.4] }")(450), 0.3);
    const spectra::Spectrum red = reflectance("[0.89, 0.0, 0.13]");
    EXPECT_GT(red(650), 0.5);
    EXPECT_LT(red(540), 0.2);
}

TEST(RecipeFile, WritingAndReadingGivesTheSameRecipe) {
    for (const std::string& text : {kViolet, kGray, kMicrofacet}) {
        const paint::Recipe recipe = parse(text);
        const std::string written = write_recipe(recipe);
        EXPECT_EQ(parse(written), recipe) << written;
        EXPECT_EQ(write_recipe(parse(written)), written);
    }
}

TEST(RecipeFile, AWrittenRecipeCarriesMaterialsOfTheUsersOwn) {
    paint::Recipe recipe = parse(kViolet);
    auto& platelet = std::get<optics::Platelet>(recipe.layers[0].flakes[0].body);
    platelet.core.material = optics::Material("my \"glass\"\n", {400, 550.5, 700},
                                              {{1.6, 0.0}, {1.55, 0.01}, {1.5, 0.1}}, "measured");
    platelet.coats[0].material = optics::Material("metal", optics::ComplexIndex(3.18, 3.33));
    recipe.binder = optics::Material(1.0 / 3.0 + 1);  // needs every digit
    EXPECT_EQ(parse(write_recipe(recipe)), recipe);
}

// In the order of the recipe's numbers, whatever the order in the file.
TEST(RecipeFile, BoundsOfAFitStandBesideTheRecipe) {
    const RecipeFile file = parse_recipe_file(kBounded, "paint.toml", "");
    const std::vector<paint::ParameterBounds> expected = {
        {"layer[0].thickness_um", 10, 20.5}, {"layer[0].flakes[0].coats[0].thickness_nm", 60, 140}};
    EXPECT_EQ(file.bounds, expected);
    EXPECT_EQ(file.recipe, parse(kViolet));
    EXPECT_EQ(recipe_hash(file.recipe), recipe_hash(parse(kViolet)));
    const RecipeFile again =
        parse_recipe_file(write_recipe(file.recipe, file.bounds), "again.toml", "");
    EXPECT_EQ(again.recipe, file.recipe);
    EXPECT_EQ(again.bounds, file.bounds);
}

TEST(RecipeFile, StandardDeviationsAreReadBesideTheRecipe) {
    const RecipeFile file = parse_recipe_file(kUncertain, "paint.toml", "");
    const std::vector<paint::ParameterDeviation> expected = {
        {"layer[0].thickness_um", 0.07, true},
        {"layer[0].flakes[0].coats[0].thickness_nm", 1.5, false}};
    EXPECT_EQ(file.deviations, expected);  // in the order of the recipe's numbers
    EXPECT_EQ(recipe_hash(file.recipe), recipe_hash(parse_recipe(kViolet, "paint.toml", "")));
    const std::string again = write_recipe(file.recipe, {}, file.deviations);
    EXPECT_THAT(again, HasSubstr("\"layer[0].thickness_um\" = \"7 %\"\n"));
    EXPECT_EQ(parse_recipe_file(again, "again.toml", "").deviations, expected);
}

TEST(RecipeFile, CorrelationsAreReadBesideTheRecipe) {
    const RecipeFile file = parse_recipe_file(kCorrelated, "paint.toml", "");
    const std::vector<paint::ParameterCorrelation> expected = {
        {{"layer[0].thickness_um", "clearcoat.thickness_um"}, 0.8},
        {{"layer[0].thickness_um", "layer[0].flakes[0].coats[0].thickness_nm"}, -0.25}};
    EXPECT_EQ(file.correlations, expected);
    EXPECT_EQ(file.deviations.size(), 3u);
    EXPECT_EQ(recipe_hash(file.recipe), recipe_hash(parse_recipe(kViolet, "paint.toml", "")));
    const std::string again = write_recipe(file.recipe, {}, file.deviations, file.correlations);
    const RecipeFile read = parse_recipe_file(again, "again.toml", "");
    EXPECT_EQ(read.correlations, expected);
    EXPECT_EQ(read.deviations, file.deviations);
    EXPECT_EQ(write_recipe(read.recipe, {}, read.deviations, read.correlations), again);
    EXPECT_TRUE(parse_recipe_file(kUncertain, "paint.toml", "").correlations.empty());
}

TEST(RecipeFile, FlakesHaveOtherKeysToo) {
    const std::string text = R"(ior = 1.5
[[layer]]
thickness_um = 15
[[layer.flakes]]
area_density_per_um = 0.1
d10_um = 9
d50_um = 20
d90_um = 41
edge_um = 0.3
waviness = 0.02
orientation = { distribution = "ggx", alpha = 0.1, alpha_bottom = 0.2 }
core = { material = 1.58, thickness_nm = 500 }
coats = [{ material = 2.5, thickness_nm = 80 }]
coated_sides = "one"
[[layer.flakes]]
area_density_per_um = 0.1
orientation = { distribution = "tabulated", tilts = [
    { tilt_deg = 0, density = 0 }, { tilt_deg = 3, density = 1 }, { tilt_deg = 12, density = 0 }] }
reflectance = 0.6
)";
    const paint::Recipe recipe = parse(text);
    const paint::FlakeSpecies& sheet = recipe.layers[0].flakes[0];
    EXPECT_EQ(sheet.quantiles, paint::StatedQuantiles(paint::DiameterQuantiles{9, 20, 41}));
    EXPECT_EQ(sheet.edge_um, 0.3);
    EXPECT_EQ(sheet.waviness, 0.02);
    EXPECT_EQ(sheet.orientation.law, paint::Orientation::Law::ggx);
    EXPECT_EQ(sheet.orientation.alpha_bottom, 0.2);
    EXPECT_EQ(std::get<optics::Platelet>(sheet.body).coated_sides,
              optics::Platelet::CoatedSides::one);
    const paint::Orientation& measured = recipe.layers[0].flakes[1].orientation;
    ASSERT_TRUE(measured.table.has_value());
    ASSERT_EQ(measured.table->tilts.size(), 3u);
    EXPECT_EQ(measured.table->tilts[1].tilt_deg, 3);
    EXPECT_EQ(parse(write_recipe(recipe)), recipe);
}

// A median alone is kept as such, with a typical pigment's d10 and d90 in what is solved.
TEST(RecipeFile, FlakesMayHaveAMedianDiameterAlone) {
    const auto with_sizes = [](const std::string& sizes) {
        std::string text = kViolet;
        const std::string plain = "diameter_um = 18\ndiameter_spread_um = 6";
        return text.replace(text.find(plain), plain.size(), sizes);
    };
    paint::Recipe recipe = parse(with_sizes("d50_um = 20"));
    const paint::Recipe all = parse(with_sizes("d10_um = 10\nd50_um = 20\nd90_um = 40"));
    EXPECT_EQ(recipe.layers[0].flakes[0].quantiles,
              paint::StatedQuantiles(paint::MedianDiameter{20}));
    EXPECT_EQ(paint::expanded(recipe), paint::expanded(all));
    EXPECT_NE(recipe, all);

    paint::set_parameter(recipe, "layer[0].flakes[0].d50_um", 15);
    const std::string text = write_recipe(recipe);
    EXPECT_NE(text.find("\nd50_um = 15\n"), std::string::npos) << text;
    for (const char* key : {"d10_um", "d90_um", "diameter_um", "diameter_spread_um"}) {
        EXPECT_EQ(text.find(key), std::string::npos) << key;
    }
    EXPECT_EQ(parse(text), recipe);
    EXPECT_EQ(paint::expanded(parse(text)),
              paint::expanded(parse(with_sizes("d10_um = 7.5\nd50_um = 15\nd90_um = 30"))));
    EXPECT_THROW(paint::set_parameter(recipe, "layer[0].flakes[0].d90_um", 30), DomainError);
}

// What a recipe does not have is not written, and a plain recipe keeps its hash.
TEST(RecipeFile, PlainFlakesAreWrittenAsBefore) {
    const std::string text = write_recipe(parse(kViolet));
    for (const char* key :
         {"d50_um", "edge_um", "waviness", "alpha_bottom", "coated_sides", "tilts"}) {
        EXPECT_EQ(text.find(key), std::string::npos) << key;
    }
}

// Each key that a description names is written, and what is written is read: the value that was
// changed comes back.
TEST(RecipeFile, EveryDescribedKeyIsWrittenAndRead) {
    paint::Recipe recipe = nacre::test::full_recipe();
    recipe.layers[0].flakes[0].orientation.beckmann_alpha = 0.125;
    nacre::test::EveryKey all;
    paint::describe(all, recipe);
    std::set<std::string> seen;
    int changes = 0;
    for (const nacre::test::KeyOfObject& key : all.keys) {
        seen.insert(nacre::test::last_key(key.path));
        if (key.is_settled) continue;
        paint::Recipe changed = recipe;
        nacre::test::EveryKey change(key.path);
        paint::describe(change, changed);
        EXPECT_EQ(change.changes, 1) << key.path;
        EXPECT_NE(changed, recipe) << key.path;
        EXPECT_EQ(parse(write_recipe(changed)), changed) << key.path;
        ++changes;
    }
    EXPECT_GE(changes, 40);
    // The recipe above has a value for every key that there is.
    paint::Substrate substrate{recipe.substrate_reflectance};
    paint::FlakeSpecies& flakes = recipe.layers[0].flakes[0];
    auto& film = std::get<optics::Platelet>(flakes.body).core;
    for (const paint::Described& object :
         {paint::Described(*recipe.lean), paint::Described(*recipe.clearcoat),
          paint::Described(*recipe.clearcoat->orange_peel), paint::Described(recipe.layers[0]),
          paint::Described(flakes), paint::Described(flakes.orientation), paint::Described(film),
          paint::Described(recipe.layers[0].pigments[0]), paint::Described(substrate),
          paint::Described(*recipe.microfacet), paint::Described(*recipe.microfacet->facets)}) {
        const std::vector<std::string> keys = keys_of(object);
        EXPECT_FALSE(keys.empty());
        for (const std::string& key : keys) {
            // Others hold keys, or stand for what is written out.
            const bool holds_others = key == "kubelka_munk" || key == "from" || key == "flakes" ||
                                      key == "pigment" || key == "orientation" || key == "core" ||
                                      key == "coats" || key == "facets" || key == "orange_peel";
            // In place of others: FlakesHaveOtherKeysToo.
            if (key == "d10_um" || key == "d50_um" || key == "d90_um" || key == "tilts") continue;
            EXPECT_TRUE(holds_others || seen.contains(key)) << key;
        }
    }
}

TEST(RecipeFile, EveryNumberOutsideItsRangeIsRefused) {
    const paint::Recipe recipe = nacre::test::full_recipe();
    nacre::test::EveryKey all;
    paint::Described::to_inspect(recipe).accept(all);
    int refused = 0;
    for (const nacre::test::KeyOfObject& key : all.keys) {
        if (!key.is_number) continue;
        for (const double value : nacre::test::values_outside(key.field.range)) {
            paint::Recipe wrong = recipe;
            nacre::test::EveryKey change(key.path, value);
            paint::describe(change, wrong);
            EXPECT_THAT(refused_recipe(write_recipe(wrong)),
                        AllOf(HasSubstr("paint.toml:"),
                              HasSubstr(fmt::format(": {} = {}: must be ", key.path, value)),
                              HasSubstr(key.field.range.text())));
            ++refused;
        }
    }
    EXPECT_GE(refused, 2 * 33);
}

// The keys of paint/recipe_parameter.h are those of the file: a number that is set comes back
// under its key.
TEST(RecipeFile, EveryNumberOfEveryPaintSurvivesTheFile) {
    int numbers = 0;
    const auto paints = shipped_file("paints/metallic-gray.toml").parent_path();
    for (const auto& entry : std::filesystem::recursive_directory_iterator(paints)) {
        if (entry.path().extension() != ".toml") continue;
        const paint::Recipe recipe = read_recipe(entry.path());
        for (const paint::RecipeParameter& parameter : paint::recipe_parameters(recipe)) {
            paint::Recipe changed = recipe;
            const double value = parameter.value > 0 ? 0.97 * parameter.value : 0.01;
            set_parameter(changed, parameter.key, value);
            const paint::Recipe again = parse(write_recipe(changed));
            EXPECT_EQ(again, changed) << entry.path() << " " << parameter.key;
            EXPECT_EQ(find_parameter(again, parameter.key).value, value) << parameter.key;
            ++numbers;
        }
    }
    EXPECT_GT(numbers, 100);
}

TEST(RecipeFile, HashDependsOnMeaningNotOnLayout) {
    const paint::Recipe recipe = parse(kViolet);
    EXPECT_EQ(recipe_hash(parse("# a comment\n" + kViolet)), recipe_hash(recipe));
    EXPECT_NE(recipe_hash(parse(replaced(kViolet, "alpha = 0.1", "alpha = 0.11"))),
              recipe_hash(recipe));
    EXPECT_EQ(recipe_hash(recipe).size(), 64u);
}

TEST(RecipeFile, LooksForMaterialsBesideTheRecipe) {
    const nacre::test::TempFolder folder;
    folder.write("glass.csv", "wavelength_nm,n,k\n400,1.6,0\n700,1.5,0\n");
    const paint::Recipe recipe =
        read_recipe(folder.write("paint.toml", replaced(kViolet, "\"mica\"", "\"glass.csv\"")));
    const auto& platelet = std::get<optics::Platelet>(recipe.layers[0].flakes[0].body);
    EXPECT_DOUBLE_EQ(platelet.core.material.index(550).real(), 1.55);
}

TEST(RecipeFile, NamesOnlyTheFilesThatItMay) {
    const nacre::test::TempFolder folder;
    std::filesystem::create_directory(folder / "inner");
    for (const char* file : {"glass.csv", "inner/glass.csv"}) {
        folder.write(file, "wavelength_nm,n,k\n400,1.6,0\n700,1.5,0\n");
    }
    const auto error = [&](const std::string& material, const References& references) {
        try {
            parse_recipe(replaced(kViolet, "\"mica\"", "\"" + material + "\""), "paint.toml",
                         references);
        } catch (const InputError& e) {
            return std::string(e.what());
        }
        return std::string("accepted");
    };
    const References within = References::within(folder / "inner");
    const std::string absolute = (folder / "glass.csv").string();
    EXPECT_EQ(error("glass.csv", within), "accepted");
    EXPECT_THAT(error("../glass.csv", within),
                AllOf(HasSubstr("paint.toml:"), HasSubstr("core.material"),
                      HasSubstr("is outside the folder")));
    EXPECT_THAT(error(absolute, within), HasSubstr("is outside the folder"));
    EXPECT_EQ(error("../glass.csv", folder / "inner"), "accepted");
    EXPECT_EQ(error(absolute, "elsewhere"), "accepted");
    EXPECT_THAT(error(absolute, {}), HasSubstr("may name none"));
}

TEST(RecipeFile, ReadsSpectraFromFiles) {
    const nacre::test::TempFolder folder;
    folder.write("primer.csv", "# grey primer\nwavelength_nm,reflectance\n400,0.2\n700,0.4\n");
    const auto recipe_of = [&](const std::string& ground) {
        return parse_recipe(
            "ior = 1.5\n[[layer]]\nthickness_um = 20\n[substrate]\nreflectance = \"" + ground +
                "\"\n",
            "paint.toml", folder.path());
    };
    EXPECT_EQ(recipe_of("primer.csv").substrate_reflectance,
              spectra::Spectrum({400, 700}, {0.2, 0.4}));
    const auto refusal = [&](const std::string& text) {
        folder.write("bad.csv", text);
        return message_of<InputError>([&] { recipe_of("bad.csv"); });
    };
    const std::string head = "wavelength_nm,R\n";
    EXPECT_THAT(
        refusal(head + "400,0.2\n500,45\n"),
        HasSubstr("paint.toml:5:15: substrate.reflectance = 'bad.csv': bad.csv:3: the value, "
                  "45, must be a number in [0, 1]"));
    EXPECT_THAT(refusal(head + "500,0.2\n400,0.2\n"),
                HasSubstr("bad.csv:3: wavelength_nm must be above"));
    EXPECT_THAT(refusal(head + "500,0.2,1\n"),
                HasSubstr("must have two cells; decimal commas need semicolons or tabs"));
    EXPECT_THAT(refusal(head + "secret,0.2\n"), Not(HasSubstr("secret")));
    folder.write("german.csv", "wavelength_nm;R\n400;0,2\n700,5;0,4\n");
    EXPECT_EQ(recipe_of("german.csv").substrate_reflectance,
              spectra::Spectrum({400, 700.5}, {0.2, 0.4}));
    EXPECT_THAT(
        refusal("wavelength_nm;R\n400;0,2\n700;0.4\n"),
        HasSubstr("paint.toml:5:15: substrate.reflectance = 'bad.csv': bad.csv:2:5: 0,2 has "
                  "a decimal comma, but 0.4 in line 3 has a point"));
    EXPECT_THAT(refusal(head + "400,\"0,2\"\n"),
                HasSubstr("bad.csv:2: the value must be a number in [0, 1]; decimal commas need "
                          "semicolons or tabs between the cells"));
    EXPECT_THAT(refusal("lambda,R\n400,0.2\n"), HasSubstr("wavelength_nm and one of values"));
    EXPECT_THAT(message_of<InputError>([&] { recipe_of("red"); }),
                HasSubstr("substrate.reflectance = 'red': must be a number in [0, 1], a table"));
}

}  // namespace
}  // namespace nacre::io
