#include "nacre/io/recipe_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/core/text.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/files.h"

namespace nacre::io {
namespace {

using nacre::test::message_of;
using nacre::test::replaced;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

const std::string kMine = R"(# Trial 7, for the green bonnet.
name = "Trial 7"
ior = 1.5 # PMMA

[[layer]]
thickness_um = 15 # wet: 40

[[layer.flakes]]
volume_fraction = 0.03
orientation = { distribution = "beckmann", alpha = 0.1 } # sprayed by robot
core  = { material = "mica", thickness_nm = 500 }
coats = [
    { material = "TiO2_anatase", thickness_nm = 80 }, # the colour
]

[[layer.pigment]]
[layer.pigment.absorption_per_mm] # a dye
wavelengths_nm = [400, 550, 700]
values = [
    60, # blue
    40,
    4,  # red
]

[substrate]
reflectance = 0.05
[fit]
"layer[0].thickness_um" = [10, 20]
)";

RecipeFile parse_file(const std::string& text) { return parse_recipe_file(text, "mine.toml", {}); }

std::string text_with(const std::string& text, const std::string& key, double value) {
    RecipeFile file = parse_file(text);
    paint::set_parameter(file.recipe, key, value);
    const RecipeText written = recipe_text(file, {});
    EXPECT_THAT(written.rewritten, IsEmpty()) << key;
    EXPECT_EQ(write_recipe(parse_file(written.text).recipe), write_recipe(file.recipe)) << key;
    return written.text;
}

TEST(RecipeText, OnlyTheNumbersThatDifferAreReplaced) {
    EXPECT_EQ(recipe_text(parse_file(kMine), {}).text, kMine);
    const struct {
        const char* key;
        double value;
        const char *from, *to;
    } cases[] = {
        {"ior", 1.52, "1.5 # PMMA", "1.52 # PMMA"},
        {"layer[0].thickness_um", 12.25, "15 # wet", "12.25 # wet"},
        {"layer[0].flakes[0].orientation.alpha", 0.25, "0.1 } #", "0.25 } #"},
        {"layer[0].flakes[0].coats[0].thickness_nm", 110, "80 }, #", "110 }, #"},
        {"layer[0].pigment[0].absorption_per_mm.max", 30, "60, # blue\n    40,\n    4,  # red",
         "30, # blue\n    20,\n    2,  # red"},
        {"substrate.reflectance", 0.5, "0.05\n", "0.5\n"},
        // Not written there, but by default 0.
        {"layer[0].flakes[0].core.spread_nm", 50, "= 500 }", "= 500, spread_nm = 50 }"},
        {"layer[0].flakes[0].diameter_spread_um", 5, "]\n\n[[layer.pigment]]",
         "]\ndiameter_spread_um = 5\n\n[[layer.pigment]]"},
        {"layer[0].pigment[0].anisotropy", 0.5, "[[layer.pigment]]\n",
         "[[layer.pigment]]\nanisotropy = 0.5\n"},
    };
    for (const auto& [key, value, from, to] : cases) {
        EXPECT_EQ(text_with(kMine, key, value), replaced(kMine, from, to)) << key;
    }
}

TEST(RecipeText, WhatItHasByDefaultIsWrittenWhereItIsMissing) {
    const std::string bare = replaced(kMine, "[substrate]\nreflectance = 0.05\n", "");
    EXPECT_EQ(text_with(bare, "substrate.reflectance", 0.25),
              bare + "\n[substrate]\nreflectance = 0.25\n");
}

TEST(RecipeText, ColoursBecomeSpectra) {
    const std::string red = replaced(kMine, "reflectance = 0.05", "reflectance = [0.4, 0.1, 0.1]");
    const std::string text = text_with(red, "substrate.reflectance.max", 0.25);
    EXPECT_THAT(text, AllOf(StartsWith(red.substr(0, red.find("[substrate]"))),
                            HasSubstr("reflectance = { wavelengths_nm = [")));
}

TEST(RecipeText, APigmentFromElsewhereIsWrittenDownWhereItChanges) {
    const struct {
        const char *pigment, *number;
    } cases[] = {{"rutile-white", "diameter_nm"},
                 {"organic-blue-synthetic", "absorption_per_mm.max"}};
    for (const auto& [pigment, number] : cases) {
        const std::string from =
            replaced(kMine, "[[layer.pigment]]\n",
                     std::string("[[layer.pigment]]\nfrom = \"") + pigment +
                         "\" # ours\nvolume_fraction = 0.01\n[[layer.pigment]]\n");
        const std::string key = std::string("layer[0].pigment[0].") + number;
        EXPECT_EQ(text_with(from, "layer[0].pigment[0].volume_fraction", 0.02),
                  replaced(from, "volume_fraction = 0.01", "volume_fraction = 0.02"));
        const double before = paint::find_parameter(parse_file(from).recipe, key).value;
        EXPECT_THAT(text_with(from, key, 0.9 * before),
                    AllOf(Not(HasSubstr("from =")), HasSubstr(" # ours\nvolume_fraction = 0.01\n"),
                          HasSubstr("# a dye"), HasSubstr("# sprayed by robot")));
    }
}

// All numbers of every paint that ships at once: the comments stay, and lines are but added.
TEST(RecipeText, ShippedPaintsKeepTheirComments) {
    const auto comments = [](const std::string& text) {
        std::vector<std::string> found;
        for (const std::string_view line : split(text, '\n')) {
            if (line.find('#') != std::string_view::npos) {
                found.emplace_back(line.substr(line.find('#')));
            }
        }
        return found;
    };
    const std::filesystem::path folder = shipped_file("paints/ruby.toml").parent_path();
    int paints = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".toml") continue;
        RecipeFile file = read_recipe_file(entry.path());
        for (const paint::RecipeParameter& number : paint::recipe_parameters(file.recipe)) {
            // Slightly less, which keeps what must be below 1 together.
            if (number.range.contains(0.99 * number.value)) {
                paint::set_parameter(file.recipe, number.key, 0.99 * number.value);
            }
        }
        const RecipeText written = recipe_text(file, References::of_file(entry.path()));
        EXPECT_THAT(written.rewritten, IsEmpty()) << entry.path();
        EXPECT_NE(written.text, file.source->text) << entry.path();
        EXPECT_EQ(comments(written.text), comments(file.source->text)) << entry.path();
        ++paints;
    }
    EXPECT_GT(paints, 10);
}

TEST(RecipeText, WhatCannotBeKeptIsWrittenAnewAndSaid) {
    const test::TempFolder folder, other;
    folder.write("primer.csv", "wavelength_nm,r\n400,0.1\n700,0.3\n");
    const std::string text = replaced(kMine, "reflectance = 0.05", "reflectance = \"primer.csv\"");
    RecipeFile file = read_recipe_file(folder.write("mine.toml", text));
    paint::set_parameter(file.recipe, "ior", 1.52);
    const RecipeText here = recipe_text(file, References::of_file(folder / "b.toml"));
    EXPECT_THAT(here.rewritten, IsEmpty());
    EXPECT_EQ(here.text, replaced(text, "1.5 #", "1.52 #"));
    // Elsewhere the name of the file means another, or none.
    const RecipeText there = recipe_text(file, References::of_file(other / "b.toml"));
    EXPECT_THAT(there.rewritten, HasSubstr("primer.csv"));
    EXPECT_EQ(write_recipe(parse_file(there.text).recipe), write_recipe(file.recipe));
    other.write("primer.csv", "wavelength_nm,r\n400,0.2\n700,0.3\n");
    EXPECT_THAT(recipe_text(file, References::of_file(other / "b.toml")).rewritten,
                HasSubstr("not that recipe"));
    // A recipe that no text holds loses nothing.
    file.source = nullptr;
    EXPECT_THAT(recipe_text(file, {}).rewritten, IsEmpty());
}

std::string text_after(const std::string& key, const std::string& value,
                       const std::string& text = kMine) {
    return with_settings(parse_file(text), {{key, value}}).source->text;
}

TEST(RecipeSettings, TakeNumbersAndTextsByTheEndsOfTheirKeys) {
    const std::string kRough = "\n[clearcoat]\nthickness_um = 45\n";
    const struct {
        const char *key, *value;
        std::string from, to;
    } cases[] = {
        {"alpha", "0.3", "0.1 } #", "0.3 } #"},
        {"coats[0].material", "SiO2", "\"TiO2_anatase\"", "\"SiO2\""},
        {"coats[0].material", "\"SiO2\"", "\"TiO2_anatase\"", "\"SiO2\""},
        {"name", "Trial 8", "\"Trial 7\"", "\"Trial 8\""},
        {"layer[0].flakes[0].orientation.distribution", "'ggx'", "\"beckmann\"", "'ggx'"},
        {"coated_sides", "one", "]\n\n[[layer.pigment]]",
         "]\ncoated_sides = \"one\"\n\n[[layer.pigment]]"},
        {"substrate.reflectance", "[0.1, 0.2, 0.3]", "0.05\n", "[0.1, 0.2, 0.3]\n"},
        {"absorption_per_mm.max", "30", "60, # blue\n    40,\n    4,  # red",
         "30, # blue\n    20,\n    2,  # red"},
        {"clearcoat.thickness_um", "45", "20]\n", "20]\n" + kRough},
    };
    for (const auto& [key, value, from, to] : cases) {
        EXPECT_EQ(text_after(key, value), replaced(kMine, from, to)) << key;
    }
    // Several, which only make sense together, and all that match.
    const RecipeFile file = with_settings(parse_file(kMine), {{"clearcoat.thickness_um", "40"},
                                                              {"clearcoat.roughness", "0.2"},
                                                              {"*thickness_nm", "90"}});
    EXPECT_EQ(file.recipe.clearcoat->roughness, 0.2);
    for (const char* film : {"core", "coats[0]"}) {
        const std::string key = std::string("layer[0].flakes[0].") + film + ".thickness_nm";
        EXPECT_EQ(paint::find_parameter(file.recipe, key).value, 90);
    }
    EXPECT_EQ(file.bounds.size(), 1u);
}

TEST(RecipeSettings, AddTables) {
    const RecipeFile file =
        with_settings(parse_file(kMine), {{"clearcoat", "{ thickness_um = 10, roughness = 0.2 }"}});
    ASSERT_TRUE(file.recipe.clearcoat);
    EXPECT_EQ(file.recipe.clearcoat->thickness_um, 10);
    EXPECT_EQ(file.recipe.clearcoat->roughness, 0.2);
    // One that stands there on lines of its own is not written over.
    EXPECT_THAT(message_of<DomainError>([&] { text_after("layer", "[{ thickness_um = 10 }]"); }),
                HasSubstr("over several lines"));
    EXPECT_THAT(message_of<DomainError>([&] { text_after("clearcoat", "10"); }),
                HasSubstr("clearcoat"));
}

TEST(RecipeSettings, TakeListsAndTablesByTheEndsOfTheirKeys) {
    const std::string kFilm = "{ material = \"SiO2\", thickness_nm = 120 }";
    const std::string kCoats =
        "[\n    { material = \"TiO2_anatase\", thickness_nm = 80 }, # the colour\n]";
    const std::string kLying = "{ distribution = \"ggx\", alpha = 0.2 }";
    const struct {
        const char* key;
        std::string value, from;
    } cases[] = {
        {"coats", "[" + kFilm + "]", kCoats},
        {"flakes[0].coats", "[" + kFilm + ", " + kFilm + "]", kCoats},
        {"coats[0]", kFilm, "{ material = \"TiO2_anatase\", thickness_nm = 80 }"},
        {"orientation", kLying, "{ distribution = \"beckmann\", alpha = 0.1 }"},
        {"*orientation", kLying, "{ distribution = \"beckmann\", alpha = 0.1 }"},
    };
    for (const auto& [key, value, from] : cases) {
        EXPECT_EQ(text_after(key, value), replaced(kMine, from, value)) << key;
    }
    // A list that is empty is there too.
    const std::string bare = replaced(kMine, "coats = " + kCoats + "\n", "");
    EXPECT_EQ(text_after("coats", "[" + kFilm + "]", bare),
              replaced(bare, "thickness_nm = 500 }\n",
                       "thickness_nm = 500 }\ncoats = [" + kFilm + "]\n"));

    const std::string two = replaced(kMine, "[[layer.pigment]]\n",
                                     "[[layer.flakes]]\nvolume_fraction = 0.01\n"
                                     "orientation = " +
                                         kLying +
                                         "\n"
                                         "core = { material = \"Al\", thickness_nm = 300 }\n"
                                         "[[layer.pigment]]\n");
    EXPECT_THAT(message_of<DomainError>([&] { text_after("orientation", kLying, two); }),
                AllOf(StartsWith("orientation={"),
                      HasSubstr("orientation: may mean layer[0].flakes[0].orientation, "
                                "layer[0].flakes[1].orientation; write more of the key")));
    EXPECT_THAT(message_of<DomainError>([&] { text_after("orientatoin", kLying); }),
                HasSubstr("did you mean 'orientation'"));
}

TEST(RecipeSettings, ComplaintsNameKeyValueAndRange) {
    const auto refused = [](const std::string& key, const std::string& value) {
        return message_of<DomainError>([&] { text_after(key, value); });
    };
    EXPECT_THAT(
        refused("alpha", "3"),
        StartsWith("alpha=3: layer[0].flakes[0].orientation.alpha = 3: must be a number in"));
    EXPECT_THAT(refused("alpha", "0,3"), HasSubstr("orientation.alpha = '0,3': must be a number"));
    EXPECT_THAT(refused("alhpa", "0.3"), AllOf(StartsWith("alhpa=0.3: is not a key of this recipe"),
                                               HasSubstr("did you mean")));
    EXPECT_THAT(refused("thickness_nm", "3"), HasSubstr("may mean"));
    for (const char* key : {"layer.0.thickness_um", "layer.thickness_um", "substrate[0].x"}) {
        EXPECT_THAT(refused(key, "3"), HasSubstr("is not a key of this recipe")) << key;
    }
    EXPECT_THAT(refused("layer.0.thickness_um", "3"),
                HasSubstr("did you mean 'layer[0].thickness_um'"));
    EXPECT_THAT(refused("layer[3].thickness_um", "3"), HasSubstr("layer[3]"));
    EXPECT_THAT(refused("substrate.reflectence", "0.3"), HasSubstr("did you mean 'reflectance'"));
    EXPECT_THAT(refused("coats[0].material", "TiO3"), HasSubstr("material = 'TiO3'"));
    EXPECT_THAT(refused("absorption_per_mm.max", "much"), HasSubstr("must be a number"));
    EXPECT_THAT(refused("absorption_per_mm.max", "-1"), HasSubstr("must be in (0,"));
    EXPECT_THAT(refused("alpha", ""), HasSubstr("alpha="));
    EXPECT_THAT(refused("layer[0].thickness_um", "25"), HasSubstr("[10, 20]"));
    EXPECT_THAT(
        message_of<DomainError>([&] {
            with_settings(parse_file(kMine), {{"alpha", "0.2"}, {"orientation.alpha", "0.3"}});
        }),
        HasSubstr("is set twice"));
}

}  // namespace
}  // namespace nacre::io
