#include "nacre/paint/recipe_description.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nacre/testing/described.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/paints.h"

namespace nacre::paint {
namespace {

using nacre::test::message_of;
using ::testing::AllOf;
using ::testing::HasSubstr;

std::string refusal(const Recipe& recipe) {
    return message_of<DomainError>([&] { validate(recipe, {}); });
}

TEST(RecipeDescription, EveryNumberOutsideItsRangeIsRefused) {
    const Recipe recipe = nacre::test::full_recipe();
    EXPECT_EQ(refusal(recipe), "accepted");
    nacre::test::EveryKey all;
    Described::to_inspect(recipe).accept(all);
    int refused = 0;
    for (const nacre::test::KeyOfObject& key : all.keys) {
        if (!key.is_number) continue;
        for (const double value : nacre::test::values_outside(key.field.range)) {
            Recipe wrong = recipe;
            nacre::test::EveryKey change(key.path, value);
            describe(change, wrong);
            EXPECT_EQ(change.changes, 1) << key.path;
            EXPECT_THAT(refusal(wrong), AllOf(HasSubstr(fmt::format("{} = {}: ", key.path, value)),
                                              HasSubstr(key.field.range.text())));
            ++refused;
        }
    }
    EXPECT_GE(refused, 2 * 37);
}

/// Numbers and spectra that a paint must state, and those with a typical value.
class Typical final : public PathVisitor {
 public:
    void number(const Field& field, double&) override { add(field); }
    void spectrum(const Field& field, spectra::Spectrum&) override { add(field); }
    bool has(const Field&, bool) override { return true; }
    bool visits_all_alternatives() const override { return true; }
    void list(const Field& field, List& list) override {
        list.add();
        PathVisitor::list(field, list);
    }

    int stated = 0, typical = 0;

 private:
    void add(const Field& field) {
        stated += field.required;
        EXPECT_TRUE(field.typical || !field.required) << path_of(field);
        if (!field.typical) return;
        ++typical;
        EXPECT_TRUE(allows(field, *field.typical)) << path_of(field) << " = " << *field.typical;
    }
};

TEST(RecipeDescription, WhatMustBeStatedHasATypicalValue) {
    Recipe recipe;
    Typical values;
    describe(values, recipe);
    EXPECT_GE(values.stated, 20);
    EXPECT_GE(values.typical, 30);
}

TEST(RecipeDescription, TheDocumentationHasItsTables) {
    Recipe recipe;
    Substrate substrate{recipe.substrate_reflectance};
    Clearcoat clearcoat;
    OrangePeel orange_peel;
    FlakeLean lean;
    Layer layer;
    FlakeSpecies flakes;
    Orientation orientation;
    TiltDensity tilts;
    optics::FilmPopulation film;
    Pigment pigment;
    Microfacet microfacet;
    MicrofacetFacets facets;
    const std::pair<const char*, Described> tables[] = {{"paint", Described(recipe)},
                                                        {"lean", Described(lean)},
                                                        {"clearcoat", Described(clearcoat)},
                                                        {"orange_peel", Described(orange_peel)},
                                                        {"layer", Described(layer)},
                                                        {"flakes", Described(flakes)},
                                                        {"orientation", Described(orientation)},
                                                        {"tilts", Described(tilts)},
                                                        {"film", Described(film)},
                                                        {"pigment", Described(pigment)},
                                                        {"substrate", Described(substrate)},
                                                        {"microfacet", Described(microfacet)},
                                                        {"facets", Described(facets)}};
    for (const auto& [name, object] : tables) {
        const std::string expected = markdown_table(object);
        EXPECT_EQ(nacre::test::documented_table("recipe.md", name, expected), expected)
            << "run this test with NACRE_WRITE_DOCS=1";
    }
}

}  // namespace
}  // namespace nacre::paint
