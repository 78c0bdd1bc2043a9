#include "apps/datasheet/catalogue.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>

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

TEST(Catalogue, GoldIsYellowAndSilverWhite) {
    // Reflectances of the polished metals: gold keeps little blue, silver all of it.
    const std::string csv = materials_csv();
    const auto chip = [&](const std::string& name) {
        const std::size_t row = csv.find("\n" + name + ","), at = csv.find('#', row);
        const auto part = [&](int i) {
            return std::stoi(csv.substr(at + 1 + 2 * i, 2), nullptr, 16);
        };
        return std::array{part(0), part(1), part(2)};
    };
    const auto gold = chip("Au"), silver = chip("Ag");
    EXPECT_GT(gold[0], gold[1] + 20);
    EXPECT_GT(gold[1], gold[2] + 40);
    EXPECT_GT(silver[2], 230);
}

TEST(Catalogue, WhereDataEndThereIsNoChip) {
    // Bond's zinc oxide begins at 450 nm.
    EXPECT_THAT(materials_csv(), ::testing::ContainsRegex("\nZnO,450,780,[0-9.]+,0,,"));
}

}  // namespace
}  // namespace nacre::datasheet
