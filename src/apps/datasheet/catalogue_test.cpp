#include "apps/datasheet/catalogue.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "nacre/optics/material.h"

namespace nacre::datasheet {
namespace {

using ::testing::HasSubstr;

TEST(Catalogue, ListsEveryMaterialWithItsRangeAndSource) {
    const std::string csv = materials_csv();
    EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')),
              optics::material_names().size() + 1);
    EXPECT_THAT(csv, HasSubstr("\nTiO2_rutile,430,780,"));
    EXPECT_THAT(csv, HasSubstr("\nmica,,,1.58,0,#"));
    EXPECT_THAT(csv, HasSubstr("\"J. R. Devore, Refractive indices of rutile"));
}

std::array<int, 3> chip_in(const std::string& csv, const std::string& name) {
    const std::size_t row = csv.find("\n" + name + ","), at = csv.find('#', row);
    const auto part = [&](int i) { return std::stoi(csv.substr(at + 1 + 2 * i, 2), nullptr, 16); };
    return {part(0), part(1), part(2)};
}

TEST(Catalogue, GoldIsYellowAndSilverWhite) {
    // Reflectances of the polished metals: gold keeps little blue, silver all of it.
    const std::string csv = materials_csv();
    const auto gold = chip_in(csv, "Au"), silver = chip_in(csv, "Ag");
    EXPECT_GT(gold[0], gold[1] + 20);
    EXPECT_GT(gold[1], gold[2] + 40);
    EXPECT_GT(silver[2], 230);
}

TEST(Catalogue, WhereDataEndTheChipGoesOnWithTheLastIndex) {
    // Bond's zinc oxide begins at 450 nm.
    const std::string csv = materials_csv();
    EXPECT_THAT(csv, ::testing::ContainsRegex("\nZnO,450,780,[0-9.]+,0,#[0-9a-f]{6},"));
    // Rutile of 430 nm on has a higher index than anatase, and both are grey but for a little blue.
    const auto rutile = chip_in(csv, "TiO2_rutile"), anatase = chip_in(csv, "TiO2_anatase");
    for (int i = 0; i < 3; ++i) {
        EXPECT_GT(rutile[i], anatase[i]);
        EXPECT_LT(rutile[i], anatase[i] + 20);
    }
}

TEST(Catalogue, EveryMaterialAndPigmentHasItsChips) {
    const auto count = [](const std::string& csv) {
        return std::pair(std::count(csv.begin(), csv.end(), '\n') - 1,
                         std::count(csv.begin(), csv.end(), '#'));
    };
    const auto [materials, material_chips] = count(materials_csv());
    EXPECT_EQ(material_chips, materials);
    const auto [pigments, pigment_chips] = count(pigments_csv({}));
    EXPECT_EQ(pigment_chips, 2 * pigments);
}

}  // namespace
}  // namespace nacre::datasheet
