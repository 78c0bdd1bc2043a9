#include "nacre/io/recipe_file.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/io/table_reader.h"
#include "nacre/paint/recipe_description.h"
#include "nacre/testing/described.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/files.h"
#include "nacre/testing/paints.h"

namespace nacre::io {
namespace {

using nacre::test::message_of;
using nacre::test::replaced;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

// The recipe of docs/recipe.md, every table once.
const std::string kViolet = R"(name = "Violet pearl"
ior = 1.5

[clearcoat]
thickness_um = 45
absorption_per_mm = { wavelengths_nm = [400, 700], values = [0.2, 0.0] }
roughness = 0.0

[[layer]]
thickness_um = 15

[[layer.flakes]]
name = "TiO2 on mica"
volume_fraction = 0.03
diameter_um = 18
diameter_spread_um = 6
orientation = { distribution = "beckmann", alpha = 0.1 }
core  = { material = "mica", thickness_nm = 500, spread_nm = 60 }
coats = [ { material = "TiO2_anatase", thickness_nm = 80, spread_nm = 5, distribution = "uniform" } ]

[[layer.pigment]]
scattering_per_mm = 200.0
absorption_per_mm = 50.0
anisotropy = 0.2

[substrate]
reflectance = 0.05
)";

const std::string kBounded = kViolet + R"([fit]
"layer[0].flakes[0].coats[0].thickness_nm" = [60, 140]
"layer[0].thickness_um" = [10, 20.5]
)";

const std::string kUncertain = kViolet + R"([uncertainty]
"layer[0].flakes[0].coats[0].thickness_nm" = 1.5
"layer[0].thickness_um" = "7 %"
)";

const std::string kGray = R"(ior = 1.5
[[layer]]
thickness_um = 15
[[layer.flakes]]
area_density_per_um = 0.1
orientation = { distribution = "beckmann", alpha = 0.1 }
reflectance = 0.6
transmittance = 0.3
thickness_um = 0.3
)";

const std::string kMicrofacet = R"(ior = 1.5
[microfacet]
alpha = 0.07
film_ior = 1.8
film_thickness_nm = 158.333
base_ior = 1.08
base_extinction = 0.51
[microfacet.facets]
count = 10_000_000
cone_deg = 3.0
thickness_spread_nm = 10.0
)";

paint::Recipe parse(const std::string& text) { return parse_recipe(text, "paint.toml", ""); }

std::string refused_recipe(const std::string& text) {
    return message_of<InputError>([&] { parse(text); });
}

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
    EXPECT_EQ(sheet.quantiles, (paint::DiameterQuantiles{9, 20, 41}));
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
         {paint::Described(*recipe.clearcoat), paint::Described(*recipe.clearcoat->orange_peel),
          paint::Described(recipe.layers[0]), paint::Described(flakes),
          paint::Described(flakes.orientation), paint::Described(film),
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

struct BadRecipe {
    const std::string* base;
    const char* from;      // in the base, replaced by
    const char* to;        // what is wrong
    const char* place;     // what is wrong stands here: line:column, or the line alone
    const char* key;       // with its value where it has one
    const char* expected;  // what would be allowed
};

class BadRecipes : public ::testing::TestWithParam<BadRecipe> {};

TEST_P(BadRecipes, AreRefusedNamingPlaceKeyValueAndRange) {
    const BadRecipe& bad = GetParam();
    const std::string message = refused_recipe(replaced(*bad.base, bad.from, bad.to));
    EXPECT_THAT(message, HasSubstr(std::string("paint.toml:") + bad.place));
    EXPECT_THAT(message, AllOf(HasSubstr(bad.key), HasSubstr(bad.expected)));
    EXPECT_LT(message.size(), 600u);
}

const BadRecipe kBadRecipes[] = {
    // not TOML
    {&kViolet, "ior = 1.5", "ior = ", "2:", "", ""},
    {&kViolet, "ior = 1.5", "ior = 1.5\nior = 1.6", "3:", "ior", ""},
    {&kViolet, "name = \"Violet", "name = \"\xff", "1:", "", ""},
    // unknown keys
    {&kViolet, "ior", "iro", "2:1", "iro = 1.5", "did you mean 'ior'?"},
    {&kViolet, "thickness_um = 15", "thickness = 15", "10:1", "layer[0].thickness = 15",
     "did you mean 'thickness_um'?"},
    {&kViolet, "thickness_um = 15", "thickness_mm = 15", "10:1", "layer[0].thickness_mm",
     "did you mean 'thickness_um'?"},
    {&kViolet, "alpha = 0.1", "apha = 0.1", "17:44", "layer[0].flakes[0].orientation.apha",
     "did you mean 'alpha'?"},
    {&kViolet, "[substrate]", "[subtrate]", "26:2", "subtrate = {...}",
     "did you mean 'substrate'?"},
    {&kViolet, "anisotropy", "colour", "24:1", "layer[0].pigment[0].colour = 0.2",
     "allowed here: from, name, scattering_per_mm, absorption_per_mm, anisotropy, volume_fraction"},
    {&kMicrofacet, "cone_deg", "cone", "10:1", "microfacet.facets.cone = 3",
     "did you mean 'cone_deg'?"},
    // missing keys
    {&kViolet, "ior = 1.5", "", "1:1", "ior", "is missing"},
    {&kViolet, "thickness_um = 15", "", "9:1", "layer[0].thickness_um",
     "is missing; it must be a number in (0, 1000000] um"},
    {&kViolet, "volume_fraction = 0.03", "", "12:1", "layer[0].flakes[0].volume_fraction",
     "(0, 1], or area_density_per_um in (0, 1000000] 1/um"},
    {&kViolet, ", alpha = 0.1", "", "17:15", "layer[0].flakes[0].orientation.alpha", "[0.005, 1]"},
    {&kViolet, "distribution = \"beckmann\", ", "", "17:15",
     "layer[0].flakes[0].orientation.distribution", "one of: beckmann"},
    {&kViolet, "thickness_nm = 500, ", "", "18:", "layer[0].flakes[0].core.thickness_nm",
     "(0, 100000] nm"},
    {&kViolet, "material = \"mica\", ", "", "18:", "layer[0].flakes[0].core.material",
     "is missing"},
    {&kViolet, "reflectance = 0.05", "", "26:1", "substrate.reflectance", "[0, 1]"},
    {&kGray, "reflectance = 0.6\ntransmittance = 0.3\nthickness_um = 0.3\n", "", "4:1",
     "layer[0].flakes[0].core", "is missing"},
    {&kMicrofacet, "alpha = 0.07", "", "2:1", "microfacet.alpha", "[0.001, 1]"},
    // wrong types
    {&kViolet, "ior = 1.5", "ior = true", "2:7", "ior = true", "[1, 3]"},
    {&kViolet, "name = \"Violet pearl\"", "name = 3", "1:8", "name = 3", "must be text"},
    {&kViolet, "thickness_um = 15", "thickness_um = \"15\"", "10:16",
     "layer[0].thickness_um = '15'", "must be a number in (0, 1000000] um"},
    {&kViolet, "thickness_um = 15", "thickness_um = [15]", "10:16",
     "layer[0].thickness_um = [...] (1 entries)", "must be a number"},
    {&kViolet, "thickness_um = 15", "thickness_um = 1979-05-27", "10:16",
     "layer[0].thickness_um = 1979-05-27", "must be a number"},
    {&kViolet, "[clearcoat]", "[[clearcoat]]", "4:1", "clearcoat = [...]", "must be a table"},
    {&kGray, "[[layer]]", "[layer]", "2:1", "layer = {...}", "must be a list of 1 to 64 tables"},
    {&kViolet, "{ distribution = \"beckmann\", alpha = 0.1 }", "\"flat\"", "17:15",
     "layer[0].flakes[0].orientation = 'flat'", "must be a table"},
    {&kViolet, "\"beckmann\"", "\"phong\"", "17:32",
     "layer[0].flakes[0].orientation.distribution = 'phong'",
     "must be one of: beckmann, ggx, tabulated"},
    {&kViolet, "\"beckmann\", alpha = 0.1", "\"ggx\", alpha = 0.01",
     "17:", "layer[0].flakes[0].orientation.alpha = 0.01", "with ggx must be in [0.02, 0.5]"},
    {&kViolet, "\"beckmann\", alpha = 0.1", "\"tabulated\"",
     "17:", "layer[0].flakes[0].orientation.alpha", "or tilts where the law is tabulated"},
    {&kViolet, "\"beckmann\", alpha = 0.1", "\"tabulated\", alpha = 0.1",
     "17:", "layer[0].flakes[0].orientation.distribution", "needs tilts"},
    {&kViolet, "diameter_um = 18", "diameter_um = 18\nd50_um = 20",
     "16:", "layer[0].flakes[0].d50_um = 20", "is said twice"},
    {&kViolet, "diameter_um = 18\ndiameter_spread_um = 6", "d50_um = 20", "",
     "layer[0].flakes[0].d10_um", "is missing"},
    {&kViolet, "diameter_um = 18\ndiameter_spread_um = 6", "d10_um = 9\nd50_um = 20\nd90_um = 19",
     "16:", "layer[0].flakes[0].d50_um = 20", "below d90_um = 19"},
    {&kViolet, "diameter_um = 18", "diameter_um = 18\nedge_um = 9",
     "16:", "layer[0].flakes[0].edge_um = 9", "must be below half of diameter_um = 18"},
    {&kViolet, "diameter_um = 18", "diameter_um = 18\nwaviness = 0.3",
     "16:", "layer[0].flakes[0].waviness = 0.3", "must be at most 0.2"},
    {&kViolet, "\"uniform\"", "\"flat\"",
     "19:", "layer[0].flakes[0].coats[0].distribution = 'flat'", "one of: normal, uniform"},
    {&kViolet, "coats = [ {", "coats = [ 3, {", "19:11", "layer[0].flakes[0].coats[0] = 3",
     "must be a table"},
    {&kGray, "reflectance = 0.6", "reflectance = [0.6, 0.6]", "7:15",
     "layer[0].flakes[0].reflectance = [...]", "3 numbers in [0, 1]"},
    {&kGray, "reflectance = 0.6", "reflectance = [0.6, 1.6, 0.6]", "7:21",
     "layer[0].flakes[0].reflectance[1] = 1.6", "[0, 1]"},
    // numbers out of range
    {&kViolet, "ior = 1.5", "ior = 0.5", "2:7", "ior = 0.5", "[1, 3]"},
    {&kViolet, "thickness_um = 15", "thickness_um = -3", "10:16", "layer[0].thickness_um = -3",
     "(0, 1000000] um"},
    {&kViolet, "thickness_um = 15", "thickness_um = nan", "10:16", "layer[0].thickness_um = nan",
     "(0, 1000000] um"},
    {&kViolet, "thickness_um = 15", "thickness_um = inf", "10:16", "layer[0].thickness_um = inf",
     "(0, 1000000] um"},
    {&kViolet, "thickness_um = 15", "thickness_um = 1e300", "10:16",
     "layer[0].thickness_um = 1e+300", "(0, 1000000] um"},
    {&kViolet, "thickness_um = 45", "thickness_um = -1", "5:16", "clearcoat.thickness_um = -1",
     "[0, 1000000] um"},
    {&kViolet, "roughness = 0.0", "roughness = 1.5", "7:13", "clearcoat.roughness = 1.5",
     "0, a smooth interface, or a number in [0.01, 1]"},
    {&kViolet, "roughness = 0.0", "roughness = 0.005", "7:13", "clearcoat.roughness = 0.005",
     "[0.01, 1]"},
    {&kViolet, "values = [0.2, 0.0]", "values = [0.2, -0.1]",
     "6:", "clearcoat.absorption_per_mm.values[1] = -0.1", "[0, 1000000000] 1/mm"},
    {&kViolet, "values = [0.2, 0.0]", "values = [0.2]",
     "6:", "clearcoat.absorption_per_mm.values = [...]", "as many entries as wavelengths_nm, 2"},
    {&kViolet, "[400, 700]", "[700, 400]", "6:", "clearcoat.absorption_per_mm.wavelengths_nm",
     "must increase, but 400 nm follows 700 nm"},
    {&kViolet, "[400, 700]", "[]", "6:", "clearcoat.absorption_per_mm.wavelengths_nm = []",
     "1 to 10000 numbers in [1, 1000000] nm"},
    {&kViolet, "volume_fraction = 0.03", "volume_fraction = 3", "14:19",
     "layer[0].flakes[0].volume_fraction = 3", "(0, 1]"},
    {&kViolet, "diameter_um = 18", "diameter_um = 0", "15:15", "layer[0].flakes[0].diameter_um = 0",
     "(0, 10000] um"},
    {&kViolet, "alpha = 0.1", "alpha = 0", "17:52", "layer[0].flakes[0].orientation.alpha = 0",
     "[0.005, 1]"},
    {&kViolet, "spread_nm = 60", "spread_nm = -60",
     "18:", "layer[0].flakes[0].core.spread_nm = -60", "[0, 100000] nm"},
    {&kViolet, "anisotropy = 0.2", "anisotropy = 1", "24:14", "layer[0].pigment[0].anisotropy = 1",
     "(-1, 1)"},
    {&kViolet, "anisotropy = 0.2", "material = \"ZnO\"", "24:12",
     "layer[0].pigment[0].material = 'ZnO'", "either coefficients, or a material"},
    {&kWhite, "spread = 0.2", "anisotropy = 0.2", "9:14", "layer[0].pigment[0].anisotropy = 0.2",
     "gets its coefficients from its particles"},
    {&kViolet, "anisotropy = 0.2", "diameter_nm = 200", "24:15",
     "layer[0].pigment[0].diameter_nm = 200", "this pigment has coefficients"},
    {&kWhite, "volume_fraction = 0.15", "volume_fraction = 0.6", "7:19",
     "layer[0].pigment[0].volume_fraction = 0.6", "(0, 0.5]"},
    {&kWhite, "volume_fraction = 0.15", "volume_fraction = 0.15\nmass_fraction = 0.3", "8:17",
     "layer[0].pigment[0].mass_fraction = 0.3", "is said twice"},
    {&kWhite, "volume_fraction = 0.15", "", "4:1", "layer[0].pigment[0]", "is missing"},
    {&kWhite, "density_g_per_cm3 = 1.8", "", "11:1", "layer[0].pigment[1].density_g_per_cm3",
     "is missing"},
    {&kWhite, "spread = 0.2", "spread = 50", "9:10", "layer[0].pigment[0].spread = 50", "[0, 1]"},
    {&kWhite, "\"volume\"", "\"mass\"", "10:13", "layer[0].pigment[0].weighting = 'mass'",
     "number"},
    {&kViolet, "reflectance = 0.05", "reflectance = 1.05", "27:15", "substrate.reflectance = 1.05",
     "[0, 1]"},
    {&kGray, "area_density_per_um = 0.1", "area_density_per_um = 0", "5:23",
     "layer[0].flakes[0].area_density_per_um = 0", "(0, 1000000] 1/um"},
    {&kMicrofacet, "10_000_000", "0.5", "9:9", "microfacet.facets.count = 0.5",
     "[1, 1000000000000000]"},
    {&kMicrofacet, "alpha = 0.07", "alpha = 0.07\ndistribution = \"phong\"", "4:16",
     "microfacet.distribution = 'phong'", "must be one of: beckmann, ggx"},
    {&kMicrofacet, "film_ior = 1.8", "film_ior = -1.8", "4:12", "microfacet.film_ior = -1.8",
     "[0.01, 10]"},
    // what does not go together
    {&kGray, "transmittance = 0.3", "transmittance = 0.5", "8:17",
     "layer[0].flakes[0].transmittance = 0.5", "reflectance + transmittance = 1.1"},
    {&kViolet, "volume_fraction = 0.03", "volume_fraction = 0.03\narea_density_per_um = 0.1",
     "15:23", "layer[0].flakes[0].area_density_per_um = 0.1", "not both"},
    {&kViolet, "core  =", "reflectance = 0.5\ncore =", "18:15",
     "layer[0].flakes[0].reflectance = 0.5", "not both"},
    {&kViolet, "core  =", "thickness_um = 0.5\ncore =", "18:16",
     "layer[0].flakes[0].thickness_um = 0.5", "goes with reflectance"},
    {&kGray, "thickness_um = 0.3", "coats = []", "9:9", "layer[0].flakes[0].coats = []",
     "go with a core"},
    {&kGray, "area_density_per_um = 0.1",
     "volume_fraction = 0.9\norientation = { distribution = "
     "\"beckmann\", alpha = 0.1 }\nreflectance = 0.5\nthickness_um = 0.3\n[[layer.flakes]]\n"
     "volume_fraction = 0.2",
     "10:19", "layer[0].flakes[1].volume_fraction = 0.2", "at most 1"},
    // materials
    {&kViolet, "\"mica\"", "\"unobtainium\"",
     "18:", "layer[0].flakes[0].core.material = 'unobtainium'", "mica"},
    {&kViolet, "\"mica\"", "\"nowhere/glass.csv\"", "18:", "layer[0].flakes[0].core.material",
     "nowhere/glass.csv"},
    {&kViolet, "ior = 1.5", "ior = \"Al\"", "2:7", "ior", "must be"},
    {&kViolet, "\"mica\"", "{ n = [1.5, 1.6] }", "18:", "layer[0].flakes[0].core.material.n",
     "1 numbers"},
    {&kViolet, "\"mica\"", "{ n = [-1.5] }", "18:", "layer[0].flakes[0].core.material.n[0] = -1.5",
     "(0, 1000]"},
    {&kViolet, "\"mica\"", "1000.5", "18:", "layer[0].flakes[0].core.material = 1000.5",
     "a number in (0, 1000]"},
    // bounds of a fit
    {&kBounded, "coats[0].thickness_nm\"", "coats[0].thicknes_nm\"",
     "29:", "fit.layer[0].flakes[0].coats[0].thicknes_nm", "coats[0].thickness_nm'?"},
    {&kBounded, "[60, 140]", "[60]", "29:", "coats[0].thickness_nm = [...] (1 entries)",
     "2 numbers"},
    {&kBounded, "[60, 140]", "60", "29:", "coats[0].thickness_nm = 60", "2 numbers"},
    {&kBounded, "[60, 140]", "[60, \"thick\"]", "29:", "coats[0].thickness_nm[1] = 'thick'",
     "must be a number"},
    {&kBounded, "[60, 140]", "[140, 60]", "29:", "coats[0].thickness_nm = [140, 60]",
     "the first end must be below the second"},
    {&kBounded, "[60, 140]", "[-60, 140]", "29:", "coats[0].thickness_nm = [-60, 140]",
     "must be in (0, 100000] nm"},
    {&kBounded, "[60, 140]", "[90, 140]", "29:", "coats[0].thickness_nm = [90, 140]",
     "the recipe's own 80 is not between them"},
    {&kBounded, "\"layer[0].thickness_um\"", "\"clearcoat.roughness\"",
     "30:", "fit.clearcoat.roughness", "is not a number of this recipe"},
    {&kBounded, "\"layer[0].thickness_um\"", "\"\\u0007\"", "28:", "fit",
     "has a key that is not the name of a number"},
    {&kBounded, "[fit]\n", "[fit.deeper]\n", "28:", "fit.deeper", "is not a number"},
    // standard deviations
    {&kUncertain, "\"layer[0].thickness_um\"", "\"layer[0].thicknes_um\"",
     "30:", "uncertainty.layer[0].thicknes_um", "layer[0].thickness_um'?"},
    {&kUncertain, "thickness_nm\" = 1.5", "thickness_nm\" = -1.5",
     "29:", "coats[0].thickness_nm = -1.5", "must be in [0, 100000] nm"},
    {&kUncertain, "thickness_nm\" = 1.5", "thickness_nm\" = 2e5",
     "29:", "coats[0].thickness_nm = 200000", "must be in [0, 100000] nm"},
    {&kUncertain, "\"7 %\"", "\"107 %\"", "30:", "layer[0].thickness_um = 107 %", "[0 %, 100 %]"},
    {&kUncertain, "\"7 %\"", "\"7\"", "30:", "layer[0].thickness_um = '7'", "percentage"},
    {&kUncertain, "\"7 %\"", "\"seven\"", "30:", "layer[0].thickness_um = seven",
     "must be a standard deviation"},
    {&kUncertain, "\"7 %\"", "[7]", "30:", "layer[0].thickness_um = ", "must be a number"},
    // sizes
    {&kViolet, "name = \"Violet",
     "name = \"VioletVioletVioletVioletVioletVioletVioletVioletViolet"
     "VioletVioletVioletVioletVioletVioletVioletVioletVioletVioletVioletVioletVioletVioletViolet"
     "VioletVioletVioletVioletVioletVioletVioletVioletVioletVioletViolet",
     "1:8", "name = 'Violet", "at most 200 characters"},
};

INSTANTIATE_TEST_SUITE_P(Matrix, BadRecipes, ::testing::ValuesIn(kBadRecipes));

TEST(RecipeFile, RefusesAnEmptyListOfLayers) {
    EXPECT_THAT(refused_recipe("ior = 1.5\n"), HasSubstr("paint.toml:1:1: layer: is missing"));
    EXPECT_THAT(refused_recipe("ior = 1.5\nlayer = []\n"),
                HasSubstr("paint.toml:2:9: layer = []: must be a list of 1 to 64 tables"));
    EXPECT_THAT(refused_recipe(""), HasSubstr("is missing"));
}

TEST(RecipeFile, NamesAFileThatIsNotThere) {
    EXPECT_THAT(message_of<InputError>([&] { read_recipe("no/such/paint.toml"); }),
                HasSubstr("'no/such/paint.toml'"));
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
    EXPECT_THAT(refusal(head + "500,0.2,1\n"), HasSubstr("must have two cells"));
    EXPECT_THAT(refusal(head + "secret,0.2\n"), Not(HasSubstr("secret")));
    EXPECT_THAT(refusal("lambda,R\n400,0.2\n"), HasSubstr("wavelength_nm and one of values"));
    EXPECT_THAT(message_of<InputError>([&] { recipe_of("red"); }),
                HasSubstr("substrate.reflectance = 'red': must be a number in [0, 1], a table"));
}

}  // namespace
}  // namespace nacre::io
