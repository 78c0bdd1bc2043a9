#include "nacre/io/drawdown_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nacre/core/error.h"
#include "nacre/testing/errors.h"

namespace nacre::io {
namespace {

using nacre::test::message_of;
using ::testing::HasSubstr;

std::string drawdown_refusal(const std::string& text) {
    return message_of<InputError>([&] { parse_drawdown(text, "blue.csv"); });
}

TEST(DrawdownFile, ReadsGroundsThicknessesAndSpectra) {
    const measure::Drawdown drawdown = parse_drawdown(
        "# of Monday\nGround,thickness_um,volume_fraction,R500,400 nm\nblack,0,,0.05,0.04\n"
        "black,25,0.03,0.15,0.14\n",
        "blue.csv");
    EXPECT_EQ(drawdown.wavelengths_nm, (std::vector<double>{400, 500}));
    ASSERT_EQ(drawdown.readings.size(), 2u);
    EXPECT_EQ(drawdown.readings[0].thickness_um, 0);
    EXPECT_EQ(drawdown.readings[1].ground, "black");
    EXPECT_EQ(drawdown.readings[1].volume_fraction, 0.03);
    EXPECT_EQ(drawdown.readings[1].reflectance, (std::vector<double>{0.14, 0.15}));
    // What is written reads back.
    const measure::Drawdown again = parse_drawdown(drawdown_csv(drawdown), "again.csv");
    EXPECT_EQ(again.readings[1].reflectance, drawdown.readings[1].reflectance);
}

TEST(DrawdownFile, TakesDecimalCommasBetweenSemicolons) {
    const std::string head = "ground;thickness_um;volume_fraction;400;500\n";
    const measure::DrawdownReading reading =
        parse_drawdown(head + "black;25,5;0,03;0,04;0,05\n", "blue.csv").readings[0];
    EXPECT_EQ(reading.thickness_um, 25.5);
    EXPECT_EQ(reading.volume_fraction, 0.03);
    EXPECT_EQ(reading.reflectance, (std::vector<double>{0.04, 0.05}));
    EXPECT_THAT(
        drawdown_refusal(head + "black;0;;0,04;0,05\nblack;25;0,03;0,04;0.05\n"),
        HasSubstr("blue.csv:2:10: 0,04 has a decimal comma, but 0.05 in line 3 has a point"));
    EXPECT_THAT(
        drawdown_refusal("ground,thickness_um,volume_fraction,400\nblack,25,0.03,\"0,04\"\n"),
        HasSubstr("blue.csv:2:15: R400 = 0,04: must be a number in [0, 1.2]; decimal commas need "
                  "semicolons or tabs between the cells"));
    EXPECT_THAT(
        drawdown_refusal("ground,thickness_um,volume_fraction,400\nblack,25,0,03,0.04\n"),
        HasSubstr("blue.csv:2:1: has 5 cells; the header has 4; decimal commas need semicolons"));
}

TEST(DrawdownFile, MassBecomesVolumeByTheDensities) {
    const measure::Drawdown drawdown = parse_drawdown(
        "ground,thickness_um,mass_fraction,density_g_per_cm3,550\nblack,20,0.2,1.6,0.3\n", "x.csv");
    EXPECT_NEAR(drawdown.readings[0].volume_fraction, 0.125 / (0.125 + 0.8 / 1.1), 1e-12);
}

TEST(DrawdownFile, TintsHaveWhiteAndMayBeOpaque) {
    const measure::Drawdown drawdown = parse_drawdown(
        "ground,thickness_um,volume_fraction,white_volume_fraction,550\n,opaque,0.01,0.2,0.5\n"
        ",Opaque,,0.2,0.9\nblack,0,,,0.05\nblack,20,0.1,,0.04\n",
        "tints.csv");
    ASSERT_EQ(drawdown.readings.size(), 4u);
    EXPECT_TRUE(drawdown.readings[0].opaque);
    EXPECT_FALSE(drawdown.readings[0].is_bare());
    EXPECT_EQ(drawdown.readings[0].white_volume_fraction, 0.2);
    EXPECT_EQ(drawdown.readings[1].volume_fraction, 0);  // the white alone
    EXPECT_TRUE(drawdown.readings[2].is_bare());
    EXPECT_EQ(drawdown.readings[3].white_volume_fraction, 0);
    const measure::Drawdown again = parse_drawdown(drawdown_csv(drawdown), "again.csv");
    EXPECT_EQ(drawdown_csv(again), drawdown_csv(drawdown));
    EXPECT_TRUE(again.readings[1].opaque);
    // By mass: volumes of what is in 100 g.
    const measure::DrawdownReading tint =
        parse_drawdown(
            "ground,thickness_um,mass_fraction,density_g_per_cm3,white_mass_fraction,"
            "white_density_g_per_cm3,550\n,opaque,0.02,1.6,0.3,4.1,0.3\n",
            "x.csv")
            .readings[0];
    const double all = 2 / 1.6 + 30 / 4.1 + 68 / 1.1;
    EXPECT_NEAR(tint.volume_fraction, 2 / 1.6 / all, 1e-12);
    EXPECT_NEAR(tint.white_volume_fraction, 30 / 4.1 / all, 1e-12);
}

TEST(DrawdownFile, ComplaintsNameLineColumnAndRange) {
    const std::string head = "ground,thickness_um,volume_fraction,550\n";
    EXPECT_THAT(drawdown_refusal(head + "black,20,0.2,45.2\n"),
                HasSubstr("blue.csv:2:14: R550 = 45.2: must be a number in [0, 1.2] (in percent? "
                          "45.2 % is 0.452)"));
    EXPECT_THAT(drawdown_refusal(head + "black,-1,0.2,0.3\n"),
                HasSubstr("thickness_um = -1: must be a number in [0, 100000] um, or opaque"));
    const std::string tint = "ground,thickness_um,volume_fraction,white_volume_fraction,550\n";
    EXPECT_THAT(
        drawdown_refusal(tint + ",opaque,0.1,0.7,0.3\n"),
        HasSubstr("blue.csv:2:13: white_volume_fraction = 0.7: must be a number in [0, 0.5]"));
    EXPECT_THAT(drawdown_refusal(tint + ",20,0.1,0.2,0.3\n"),
                HasSubstr("ground: is missing; only `opaque` paint needs none"));
    EXPECT_THAT(drawdown_refusal(tint + ",opaque,,0,0.3\n"),
                HasSubstr("volume_fraction = : must be a number in (0, 0.5]"));
    EXPECT_THAT(drawdown_refusal("ground,thickness_um,volume_fraction,white_mass_fraction,550\n"
                                 ",opaque,0.1,0.2,0.3\n"),
                HasSubstr("both by volume or both by mass"));
    const std::string mass =
        "ground,thickness_um,mass_fraction,density_g_per_cm3,white_mass_fraction,550\n";
    EXPECT_THAT(drawdown_refusal(mass + ",opaque,0.1,1.5,0.2,0.3\n"),
                HasSubstr("white_mass_fraction needs the column white_density_g_per_cm3"));
    EXPECT_THAT(
        drawdown_refusal(mass + ",opaque,0.6,1.5,0.5,0.3\n"),
        HasSubstr("white_mass_fraction = 0.5: with a mass_fraction of 0.6 nothing is left"));
    EXPECT_THAT(drawdown_refusal(head + "black,20,,0.3\n"),
                HasSubstr("volume_fraction = : must be"));
    EXPECT_THAT(drawdown_refusal(head + ",20,0.1,0.3\n"), HasSubstr("ground: is missing"));
    EXPECT_THAT(drawdown_refusal(head + "black,20,0.1\n"),
                HasSubstr("has 3 cells; the header has 4"));
    EXPECT_THAT(drawdown_refusal("ground,thicknes_um,volume_fraction,550\nblack,1,1,1\n"),
                HasSubstr("(did you mean 'thickness_um'?)"));
    EXPECT_THAT(drawdown_refusal("ground,thickness_um,550\nblack,1,1\n"),
                HasSubstr("volume_fraction or mass_fraction"));
    EXPECT_THAT(drawdown_refusal("ground,thickness_um,volume_fraction\nblack,1,1\n"),
                HasSubstr("no column is called by a wavelength"));
    EXPECT_THAT(drawdown_refusal("ground,thickness_um,mass_fraction,550\nblack,1,0.5,1\n"),
                HasSubstr("density_g_per_cm3"));
    EXPECT_THAT(drawdown_refusal(""), HasSubstr("is empty"));
    EXPECT_THAT(drawdown_refusal(head), HasSubstr("has a header, but no reading"));
}

}  // namespace
}  // namespace nacre::io
