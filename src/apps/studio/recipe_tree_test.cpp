#include "apps/studio/messages/recipe_tree.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "apps/studio/messages/messages.h"
#include "apps/studio/schema.h"
#include "nacre/core/file.h"
#include "nacre/io/recipe_file.h"
#include "nacre/io/recipe_text.h"
#include "nacre/models/models.h"
#include "nacre/nacre.h"
#include "nacre/paint/recipe_description.h"

namespace nacre::studio {
namespace {

using testing::HasSubstr;

std::string text_of_paint(const std::string& name) { return read_file(find_paint(name)); }

TEST(RecipeTree, EveryShippedPaintComesBackFromItsTree) {
    const std::vector<std::string> names = shipped_paints();
    ASSERT_GT(names.size(), 20u);
    for (const std::string& name : names) {
        const std::string text = text_of_paint(name);
        const References beside = References::of_file(find_paint(name));  // as a primer's spectrum
        const Tree tree = tree_of_toml(text, name);
        const auto before = io::parse_recipe_file(text, name, beside);
        const auto after = io::parse_recipe_file(toml_of_tree(tree), name, beside);
        EXPECT_EQ(before.recipe, after.recipe) << name << "\n" << toml_of_tree(tree);
        EXPECT_EQ(before.bounds, after.bounds) << name;
        EXPECT_EQ(before.deviations, after.deviations) << name;
        // Also by way of JSON, as a page holds it.
        EXPECT_EQ(toml_of_tree(Tree::parse(tree.dump())), toml_of_tree(tree)) << name;
    }
}

TEST(RecipeTree, AChangedValueLeavesCommentsAndLayout) {
    const std::string before =
        "# mine\nior = 1.5  # resin\n[[layer]]\nthickness_um = 15.0\n"
        "pigment = [{scattering_per_mm = 3}]\n";
    Tree tree = tree_of_toml(before, "recipe.toml");
    EXPECT_EQ(toml_of_tree(tree, before), before);
    tree["layer"][0]["thickness_um"] = 20;
    tree["layer"][0]["pigment"][0]["scattering_per_mm"] = 4.5;
    EXPECT_EQ(toml_of_tree(tree, before),
              "# mine\nior = 1.5  # resin\n[[layer]]\nthickness_um = 20\n"
              "pigment = [{scattering_per_mm = 4.5}]\n");
    // What has other keys is written anew.
    tree["name"] = "new";
    EXPECT_EQ(toml_of_tree(tree, before), toml_of_tree(tree));
    EXPECT_THAT(toml_of_tree(tree), HasSubstr("name = \"new\"\n"));
    tree.erase("name");
    tree["layer"].push_back(tree["layer"][0]);
    EXPECT_EQ(toml_of_tree(tree, before), toml_of_tree(tree));
}

TEST(RecipeTree, WhatTomlHasNotIsRefused) {
    EXPECT_THROW(toml_of_tree(Tree::parse("[1]")), InputError);
    EXPECT_THROW(toml_of_tree(Tree::parse(R"({"ior": null})")), InputError);
    Tree deep = Tree::object();
    for (int i = 0; i < 40; ++i) deep = Tree{{"layer", Tree::array({deep})}};
    EXPECT_THROW(toml_of_tree(deep), InputError);
}

TEST(RecipeTree, KeysAndTextsCannotBreakOutOfTheirPlace) {
    const Tree tree = {{"name", "a\"\n[x]\n"}, {"b]\n[c", {{"x", 1}}}};
    const Tree back = tree_of_toml(toml_of_tree(tree), "recipe.toml");
    EXPECT_EQ(back.dump(), tree.dump());
}

TEST(RecipeTree, ATextThatNamesFilesIsMadeToStandAlone) {
    const std::filesystem::path folder = testing::TempDir();
    std::ofstream(folder / "glass.csv") << "wavelength_nm,n,k\n300,1.6,0\n800,1.5,0\n";
    std::ofstream(folder / "own.toml")
        << "ior = 1.5\n[[layer]]\nthickness_um = 15\n[[layer.flakes]]\nvolume_fraction = 0.1\n"
           "orientation = { distribution = \"beckmann\", alpha = 0.1 }\n"
           "core = { material = \"glass.csv\", thickness_nm = 500 }\n";
    const auto path = folder / "own.toml";
    const std::string toml = open(path).recipe_text(References()).text;
    EXPECT_THROW(io::parse_recipe_file(read_file(path), "own.toml", {}), InputError);
    EXPECT_EQ(io::parse_recipe_file(toml, "own.toml", {}).recipe, io::read_recipe(path));
    // One that names none is as it was, comments and all.
    const auto shipped = find_paint("red-gold");
    EXPECT_EQ(open(shipped).recipe_text(References()).text, read_file(shipped));
}

/// The entry of a table in the schema.
const Tree& table_of(const Tree& schema, const std::string& path) {
    for (const Tree& table : schema["tables"]) {
        if (table["path"] == path) return table;
    }
    throw Error("no table " + path);
}

std::vector<std::string> keys_in(const Tree& table) {
    std::vector<std::string> keys;
    for (const Tree& key : table["keys"]) keys.push_back(key["key"]);
    std::ranges::sort(keys);
    return keys;
}

template <class T>
std::vector<std::string> described_keys() {
    T object;
    std::vector<std::string> keys = paint::keys_of(paint::Described(object));
    std::ranges::sort(keys);
    return keys;
}

TEST(StudioSchema, HasEveryKeyOfTheDescription) {
    const Tree schema = recipe_schema();
    EXPECT_EQ(keys_in(table_of(schema, "")), described_keys<paint::Recipe>());
    EXPECT_EQ(keys_in(table_of(schema, "lean")), described_keys<paint::FlakeLean>());
    EXPECT_EQ(keys_in(table_of(schema, "clearcoat")), described_keys<paint::Clearcoat>());
    EXPECT_EQ(keys_in(table_of(schema, "clearcoat.orange_peel")),
              described_keys<paint::OrangePeel>());
    EXPECT_EQ(keys_in(table_of(schema, "layer[]")), described_keys<paint::Layer>());
    EXPECT_EQ(keys_in(table_of(schema, "layer[].flakes[]")), described_keys<paint::FlakeSpecies>());
    EXPECT_EQ(keys_in(table_of(schema, "layer[].flakes[].orientation")),
              described_keys<paint::Orientation>());
    EXPECT_EQ(keys_in(table_of(schema, "layer[].flakes[].core")),
              described_keys<optics::FilmPopulation>());
    EXPECT_EQ(keys_in(table_of(schema, "layer[].flakes[].coats[]")),
              described_keys<optics::FilmPopulation>());
    EXPECT_EQ(keys_in(table_of(schema, "layer[].pigment[]")), described_keys<paint::Pigment>());
    EXPECT_EQ(keys_in(table_of(schema, "layer[].pigment[].kubelka_munk")),
              described_keys<paint::KubelkaMunk>());
    EXPECT_EQ(keys_in(table_of(schema, "microfacet.facets")),
              described_keys<paint::MicrofacetFacets>());
}

// Else a slider of an index would go from -5 to 5.
TEST(StudioSchema, SaysTheRangeOfAnIndexInPlaceOfAMaterial) {
    const Tree schema = recipe_schema();
    const auto key_of = [&](const char* table, const char* name) {
        const Tree& keys = table_of(schema, table)["keys"];
        const auto key =
            std::ranges::find_if(keys, [&](const Tree& k) { return k["key"] == name; });
        return key == keys.end() ? Tree() : *key;
    };
    const Tree binder = key_of("", "ior");
    EXPECT_EQ(binder["kind"], "material");
    EXPECT_EQ(binder["min"], 1);
    EXPECT_EQ(binder["max"], 3);
    const Tree film = key_of("layer[].flakes[].coats[]", "material");
    EXPECT_EQ(film["min"], 0);
    EXPECT_EQ(film["min_excluded"], true);
    EXPECT_EQ(film["max"], 1000);
}

TEST(StudioSchema, SaysRangesAndAlternatives) {
    const Tree schema = recipe_schema();
    const Tree& flakes = table_of(schema, "layer[].flakes[]");
    const auto key = std::ranges::find_if(
        flakes["keys"], [](const Tree& k) { return k["key"] == "volume_fraction"; });
    ASSERT_NE(key, flakes["keys"].end());
    EXPECT_EQ((*key)["kind"], "number");
    EXPECT_EQ((*key)["min"], 0);
    EXPECT_EQ((*key)["min_excluded"], true);
    EXPECT_EQ((*key)["max"], 1);
    ASSERT_EQ(flakes["alternatives"].size(), 4u) << flakes["alternatives"].dump(2);
    EXPECT_EQ(flakes["alternatives"][0]["required"], true);
    EXPECT_EQ(flakes["alternatives"][0]["each"][1]["mark"], "area_density_per_um");
    EXPECT_EQ(flakes["ordered"], true);
    // Within the alternative of quantiles: d50_um alone, or all three.
    const Tree& median = flakes["alternatives"][3]["each"];
    EXPECT_EQ(median[0]["mark"], "");
    EXPECT_EQ(median[0]["keys"], Tree({"d50_um"}));
    EXPECT_EQ(median[1]["mark"], "d10_um");
    // Those of pigments, within alternatives of pigments.
    const Tree& pigment = table_of(schema, "layer[].pigment[]");
    bool particles = false;
    for (const Tree& group : pigment["alternatives"]) {
        particles = particles ||
                    (group["each"].size() == 2 && group["each"][0]["mark"] == "volume_fraction");
    }
    EXPECT_TRUE(particles) << pigment["alternatives"].dump(2);
}

TEST(StudioMessages, AreRefusedNamingKeyAndWhatIsAllowed) {
    const auto refusal = [](const std::string& text) {
        try {
            parse_message(text, models::names_of_fitted());
        } catch (const MessageError& error) {
            return std::string(error.what());
        }
        return std::string("taken");
    };
    EXPECT_THAT(refusal("{"), HasSubstr("is not JSON"));
    EXPECT_THAT(refusal(""), HasSubstr("is not JSON"));
    EXPECT_THAT(refusal("[]"), HasSubstr("must be an object"));
    EXPECT_THAT(refusal(R"({"type": "pant"})"), HasSubstr("did you mean 'paint'"));
    EXPECT_THAT(refusal(R"({"type": "paint", "id": 1})"), HasSubstr("recipe: must be an object"));
    EXPECT_THAT(refusal(R"({"type": "paint", "recipe": {}, "illuminant": "D64"})"),
                HasSubstr("illuminant = \"D64\""));
    EXPECT_THAT(refusal(R"({"type": "paint", "recipe": {}, "geometries": "/etc/passwd.toml"})"),
                HasSubstr("is no set"));
    EXPECT_THAT(refusal(R"({"type": "paint", "recipe": {}, "geometries": "-"})"),
                HasSubstr("is no set"));
    EXPECT_EQ(refusal(R"({"type": "paint", "recipe": {}, "geometries": "45as15,45as15"})"),
              "geometries = \"45as15,45as15\": 45as15 appears twice");
    EXPECT_THAT(refusal(R"({"type": "paint", "recipe": {}, "colour": 1})"),
                HasSubstr("no such key"));
    EXPECT_THAT(refusal(R"({"type": "render", "recipe": {}, "width": 0})"),
                HasSubstr("width = 0: must be a number in [1, 32768] pixels"));
    EXPECT_THAT(refusal(R"({"type": "render", "recipe": {}, "width": 30000, "height": 30000})"),
                HasSubstr("times height"));
    EXPECT_THAT(refusal(R"({"type": "render", "recipe": {}, "scene": {"camera": {"fov_deg": 0}}})"),
                HasSubstr("scene.camera.fov_deg = 0"));
    EXPECT_THAT(refusal(std::string(100'000, '[')), HasSubstr("nests deeper"));
    std::string many = "{";
    for (int i = 0; i < 20'000; ++i) many += "\"" + std::to_string(i) + "\":0,";
    EXPECT_THAT(refusal(many + "\"x\":0}"), HasSubstr("more than 10000 keys"));
    EXPECT_EQ(refusal(R"({"type": "stop", "id": "x"})"), "taken");
}

}  // namespace
}  // namespace nacre::studio
