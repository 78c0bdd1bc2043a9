#include "apps/datasheet/composition.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nacre/paint/recipe_description.h"
#include "nacre/testing/described.h"
#include "nacre/testing/paints.h"

namespace nacre::datasheet {
namespace {

using ::testing::HasSubstr;

paint::Recipe pearl() {
    paint::FlakeSpecies flakes;
    flakes.name = "TiO2 on mica";
    flakes.amount = paint::VolumeFraction{0.05};
    flakes.diameter_um = 18;
    flakes.diameter_spread_um = 6;
    flakes.orientation.beckmann_alpha = 0.1;
    flakes.body = optics::Platelet{{optics::find_material("mica"), 500, {100}},
                                   {{optics::find_material("TiO2_anatase"), 80, {5}}}};
    paint::Recipe recipe = test::paint_of(
        1.5, {{15, {flakes}, {{paint::PigmentCoefficients{200.0, 50.0, 0}}}}, {30, {}, {}}}, 0.03);
    recipe.clearcoat = paint::Clearcoat{45, 0.0, 0};
    return recipe;
}

TEST(Composition, NamesMaterialsAsChemistsWriteThem) {
    EXPECT_EQ(material_text(optics::find_material("TiO2_anatase")), "TiO₂ (anatase)");
    EXPECT_EQ(material_text(optics::find_material("TiO2_rutile_o")), "TiO₂ (rutile o)");
    EXPECT_EQ(material_text(optics::find_material("Fe2O3")), "Fe₂O₃");
    EXPECT_EQ(material_text(optics::find_material("Al")), "Al");
    EXPECT_EQ(material_text(optics::find_material("synthetic_mica")), "synthetic mica");
    EXPECT_EQ(material_text(optics::find_material("1.58")), "n = 1.58");
    EXPECT_EQ(material_text(optics::Material("my_own", {2.0, 0.0})), "my_own");
}

TEST(Composition, WordsHoldEveryNumber) {
    const auto sentences = layers_in_words(pearl());
    ASSERT_EQ(sentences.size(), 4u);
    EXPECT_THAT(sentences[0], HasSubstr("45 µm"));
    for (const char* part :
         {"15 µm", "TiO2 on mica", "mica, 500 ± 100 nm", "TiO₂ (anatase), 80 ± 5 nm", "18 ± 6 µm",
          "0.66 µm thick", "5 % by volume", "1.14 times", "4.8°", "scatters 200 /mm"}) {
        EXPECT_THAT(sentences[1], HasSubstr(part));
    }
    EXPECT_THAT(sentences[2], HasSubstr("binder alone"));
    EXPECT_THAT(sentences[3], HasSubstr("3 %"));
}

TEST(Composition, AMedianDiameterAloneIsSaidToBeATypicalPigments) {
    paint::Recipe paint = pearl();
    paint.layers[0].flakes[0].quantiles = paint::MedianDiameter{18};
    EXPECT_THAT(layers_in_words(paint)[1],
                HasSubstr("half of their volume below 18 µm, a tenth below half and nine tenths "
                          "below twice that (typical)"));
}

TEST(Composition, TheTableHasARowForEachIngredient) {
    const report::Table table = layers_table(pearl());
    std::vector<std::string> first, second;
    for (const auto& row : table.rows) {
        ASSERT_EQ(row.size(), table.columns.size());
        first.push_back(row[0].text);
        second.push_back(row[1].text);
    }
    using ::testing::ElementsAre;
    EXPECT_THAT(first,
                ElementsAre("Clear coat, 45 µm", "Layer 1, 15 µm", "", "Layer 2, 30 µm", "Ground"));
    EXPECT_THAT(second,
                ElementsAre("clear", "TiO2 on mica", "pigment", "binder alone", "reflects 3 %"));
}

TEST(Composition, ParticlesAreStatedByMaterialSizeAndAmount) {
    paint::Recipe paint = pearl();
    paint.layers[0].pigments = {{paint::PigmentParticles{paint::PigmentVolume{0.15},
                                                         {optics::find_material("TiO2_rutile"), 250,
                                                          0.2, optics::DiameterWeighting::volume}},
                                 "rutile white"}};
    EXPECT_THAT(layers_in_words(paint)[1],
                HasSubstr("rutile white of TiO₂ (rutile), 250 nm across, median by "
                          "volume, log-normal with a deviation of 0.2 in the logarithm, 15 % by "
                          "volume"));
    const auto& row = layers_table(paint).rows[2];
    EXPECT_EQ(row[1].text, "rutile white");
    EXPECT_EQ(row[2].text, "15 % by volume");
    EXPECT_THAT(row[4].text, HasSubstr("TiO₂"));
}

TEST(Composition, SpectraAreStatedByTheirRange) {
    paint::Recipe paint = pearl();
    paint.substrate_reflectance = spectra::Spectrum({400, 700}, {0.02, 0.6});
    EXPECT_THAT(layers_in_words(paint).back(), HasSubstr("2 to 60 %"));
}

TEST(Composition, FacetsAreDescribedByFilmAndBase) {
    paint::Microfacet facets;
    facets.film_ior = 2.5;
    facets.film_thickness_nm = 80;
    const auto without = facets_in_words(facets);
    ASSERT_EQ(without.size(), 1u);
    EXPECT_THAT(without[0], HasSubstr("80 nm with n = 2.5"));
    facets.facets = paint::MicrofacetFacets{1e7, 3, 5};
    ASSERT_EQ(facets_in_words(facets).size(), 2u);
    EXPECT_THAT(facets_in_words(facets)[1], HasSubstr("10⁷ facets"));
}

/// All that a data sheet says of a composition.
std::string sheet(const paint::Recipe& recipe) {
    std::string words;
    for (const std::string& sentence : layers_in_words(recipe)) words += sentence + "\n";
    for (const std::string& sentence : facets_in_words(*recipe.microfacet))
        words += sentence + "\n";
    return words;
}

std::string sheet_table(const paint::Recipe& recipe) {
    std::string words;
    for (const auto& row : layers_table(recipe).rows) {
        for (const report::Cell& cell : row) words += cell.text + "|";
    }
    return words;
}

// The recipe has a value for every key that there is: RecipeFile.EveryDescribedKeyIsWrittenAndRead.
TEST(Composition, EveryKeyIsTold) {
    const paint::Recipe recipe = nacre::test::full_recipe();
    nacre::test::EveryKey all;
    paint::Described::to_inspect(recipe).accept(all);
    int told = 0;
    for (const nacre::test::KeyOfObject& key : all.keys) {
        const bool deliberately_not = key.field.phrase && !*key.field.phrase;
        if (key.is_settled || deliberately_not) continue;
        paint::Recipe changed = recipe;
        nacre::test::EveryKey change(key.path);
        describe(change, changed);
        ASSERT_EQ(change.changes, 1) << key.path;
        EXPECT_TRUE(sheet(changed) != sheet(recipe)) << key.path << " is not told";
        if (!key.path.starts_with("microfacet")) {  // these have no table
            EXPECT_TRUE(sheet_table(changed) != sheet_table(recipe)) << key.path;
        }
        ++told;
    }
    EXPECT_GE(told, 40);
}

TEST(Composition, NumbersUnitsAndChoicesAreWrittenAsPeopleDo) {
    paint::Recipe recipe = nacre::test::full_recipe();
    std::get<paint::PigmentCoefficients>(recipe.layers[0].pigments[0].body).absorption_per_mm =
        2e-5;
    auto& platelet = std::get<optics::Platelet>(recipe.layers[0].flakes[0].body);
    platelet.coats[0].spread.law = optics::ThicknessSpread::Law::uniform;
    platelet.coats.push_back(platelet.coats[0]);
    recipe.microfacet->film_thickness_nm = 12345;
    recipe.microfacet->distribution = paint::FacetDistribution::ggx;
    const std::string words = sheet(recipe);
    for (const char* part :
         {"40 ± 0.25 µm with a matte surface (roughness 0.1), orange peel with slopes of 0.001 "
          "(0.1 to "
          "0.3 "
          "mm), 0.002 (0.3 to 1 mm), 0.003 (1 to 3 mm), 0.004 (3 to 10 mm), 0.005 (10 to 30 mm): "
          "absorbs 2 to 8 /mm",
          "500 ± 30 nm; on both sides n = 2.5, 80 ± 5 nm, uniformly spread; then n = 2.5, 80 ± 5",
          "(reflects 60 %; transmits 20 %)", "scatters 20 /mm, absorbs 2·10⁻⁵ /mm, g = 0.3",
          "(GGX, roughness 0.1) under a film of 12345 nm", "within 3° of its mirror direction"}) {
        EXPECT_THAT(words, HasSubstr(part));
    }
    recipe.clearcoat->roughness = 0;
    recipe.clearcoat->absorption_per_mm = 0.0;
    recipe.clearcoat->orange_peel.reset();
    EXPECT_THAT(sheet(recipe), HasSubstr("with a smooth surface: clear."));
}

}  // namespace
}  // namespace nacre::datasheet
