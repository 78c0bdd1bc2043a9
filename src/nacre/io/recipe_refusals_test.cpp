#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nacre/io/recipe_test_support.h"
#include "nacre/testing/files.h"

// What is wrong with a recipe is said with its place, key, value and what would be allowed.

namespace nacre::io {
namespace {

using namespace recipes;
using nacre::test::message_of;
using nacre::test::replaced;
using ::testing::AllOf;
using ::testing::HasSubstr;

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
    {&kViolet, "diameter_um = 18\ndiameter_spread_um = 6", "d10_um = 9\nd50_um = 20", "",
     "layer[0].flakes[0].d90_um", "is missing"},
    {&kViolet, "diameter_um = 18\ndiameter_spread_um = 6", "d50_um = 20\nd90_um = 40", "16:10",
     "layer[0].flakes[0].d90_um = 40", "goes with d10_um"},
    {&kViolet, "diameter_um = 18\ndiameter_spread_um = 6", "d10_um = 9", "15:10",
     "layer[0].flakes[0].d10_um = 9", "goes with d50_um"},
    {&kViolet, "diameter_um = 18\ndiameter_spread_um = 6", "d50_um = 0", "15:10",
     "layer[0].flakes[0].d50_um = 0", "must be a number in [0.001, 10000] um"},
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
     "[0.001, 10000] um"},
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
     "only with a core"},
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
    // correlations
    {&kCorrelated, "= 0.8", "= 1.8", "35:15", "uncertainty.correlation[0].coefficient = 1.8",
     "must be a number in [-1, 1]"},
    {&kCorrelated, "coefficient = 0.8\n", "", "33:1", "uncertainty.correlation[0].coefficient",
     "is missing; it must be a number in [-1, 1]"},
    {&kCorrelated, "of = [\"layer[0].thickness_um\", \"cl", "of = [\"layer[0].thicknes_um\", \"cl",
     "34:6", "uncertainty.correlation[0].of[0] = layer[0].thicknes_um", "layer[0].thickness_um'?"},
    {&kCorrelated, "\"clearcoat.thickness_um\"]", "\"layer[0].thickness_um\"]", "34:6",
     "of[1] = layer[0].thickness_um", "is named twice"},
    {&kCorrelated, "\"clearcoat.thickness_um\"]", "\"substrate.reflectance\"]", "34:6",
     "of[1] = substrate.reflectance",
     "has no standard deviation; those that have: clearcoat.thickness_um, layer[0].thickness_um"},
    {&kCorrelated, ", \"clearcoat.thickness_um\"]", "]", "34:6",
     "uncertainty.correlation[0].of = ", "must be a list of 2 to 64 texts"},
    {&kCorrelated, "\"clearcoat.thickness_um\"]", "7]",
     "34:", "uncertainty.correlation[0].of[1] = 7", "must be text of 1 to 200 characters"},
    {&kCorrelated, "coefficient = 0.8", "coeficient = 0.8", "35:1",
     "uncertainty.correlation[0].coeficient", "did you mean 'coefficient'?"},
    {&kCorrelated, "\"layer[0].flakes[0].coats[0].thickness_nm\"]", "\"clearcoat.thickness_um\"]",
     "33:", "that of layer[0].thickness_um and clearcoat.thickness_um", "is stated twice"},
    {&kCorrelated, "= -0.25", "= -0.65", "33:",
     "uncertainty.correlation: 0.8 of clearcoat.thickness_um and layer[0].thickness_um, -0.65 of",
     "all must be in [0, inf)"},
    {&kUncertain, "\"7 %\"\n", "\"7 %\"\ncorrelation = 0.5\n",
     "31:", "uncertainty.correlation = 0.5", "must be a list of 1 to 4096 tables"},
    // a key whose 0 says something else than its range
    {&kViolet, "roughness = 0.0", "roughness = \"matte\"", "7:", "clearcoat.roughness = 'matte'",
     "must be 0, a smooth interface, or a number in [0.01, 1]"},
    {&kViolet, "roughness = 0.0", "roughness = nan", "7:", "clearcoat.roughness = nan",
     "must be 0, a smooth interface, or a number in [0.01, 1]"},
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

}  // namespace
}  // namespace nacre::io
