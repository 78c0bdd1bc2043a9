#include "nacre/io/measurement_columns.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace nacre::io {
namespace {

std::string column_of(const char* text) {
    const auto heading = heading_of(text);
    if (!heading) return "none";
    return heading->column + (heading->geometry.empty() ? "" : " at " + heading->geometry);
}

TEST(MeasurementColumns, HeadingsAreKnownInTheSpellingsOfTheTrade) {
    for (const auto& [text, column] : {std::pair{"L*", "l"},
                                       {"l", "l"},
                                       {"LAB_L", "l"},
                                       {"Helligkeit", "l"},
                                       {"a*", "a"},
                                       {"h [\u00b0]", "h"},
                                       {"h_deg", "h"},
                                       {"Bunttonwinkel (\u00b0)", "h"},
                                       {"Buntheit", "c"},
                                       {"XYZ_Y", "y"},
                                       {"Winkel", "geometry"},
                                       {"Geometry", "geometry"},
                                       {"Angle [deg]", "geometry"},
                                       {"Glanzwinkel", "aspecular_deg"},
                                       {"aspecular angle", "aspecular_deg"},
                                       {"theta_i_deg", "theta_i"},
                                       {"Probe", "sample"},
                                       {"SAMPLE_ID", "sample_id"},
                                       {"Lichtart", "illuminant"}}) {
        EXPECT_EQ(column_of(text), column) << text;
    }
    for (const char* text : {"", "Date", "Datum", "dL", "dE2000", "L_sd", "cov_La", "SE400",
                             "SD400", "L_standard", "weight", "L*(D65)"}) {
        EXPECT_EQ(column_of(text), "none") << text;
    }
}

TEST(MeasurementColumns, ColoursAtAnAngleAreKnownHoweverTheAngleIsWritten) {
    for (const char* text :
         {"L -15", "L*(-15)", "L* [-15\u00b0]", "-15 L*", "L-15", "L_as-15", "as-15_L",
          "45as-15 L*", "L 45as-15", "L* r45as-15", "L 45/-15", "L 45:as-15", "LAB_L_45as-15",
          "45asMinus15 LAB_L", "L \u221215", "l*_minus15"}) {
        EXPECT_EQ(column_of(text), "l at 45as-15") << text;
    }
    EXPECT_EQ(column_of("as15_a"), "a at 45as15");
    EXPECT_EQ(column_of("15as45 b*"), "b at 15as45");
    EXPECT_EQ(column_of("a 110\u00b0"), "a at 45as110");
    EXPECT_EQ(column_of("L 45/0"), "none") << "two meanings";
    EXPECT_EQ(column_of("L 150"), "none") << "below the horizon";
}

TEST(MeasurementColumns, WavelengthsMayHaveAUnitAnAngleAndAScale) {
    for (const char* text :
         {"R400", "400", "400nm", "r 400 nm", "SPECTRAL_NM400", "SPECTRAL_NM_400", "nm400",
          "SPEC_400", "R_400", "R400 [%]", "%R 400", "R400 [1]"}) {
        const auto heading = heading_of(text);
        ASSERT_TRUE(heading) << text;
        EXPECT_EQ(heading->column, "r") << text;
        EXPECT_EQ(heading->wavelength_nm, 400) << text;
        EXPECT_EQ(heading->percent, std::string(text).find('%') != std::string::npos) << text;
        EXPECT_EQ(heading->factor, std::string(text).find("[1]") != std::string::npos) << text;
        EXPECT_EQ(wavelength_of_heading(text), 400) << text;
    }
    EXPECT_EQ(heading_of("R450,5")->wavelength_nm, 450.5);
    for (const char* text :
         {"R400 45as15", "45as15 400nm", "r45as15 R400", "as15_R400", "R400 (15)"}) {
        const auto heading = heading_of(text);
        ASSERT_TRUE(heading) << text;
        EXPECT_EQ(heading->wavelength_nm, 400) << text;
        EXPECT_EQ(heading->geometry, "45as15") << text;
        EXPECT_FALSE(wavelength_of_heading(text)) << text;
    }
}

TEST(MeasurementColumns, AHeaderIsFoundUnderTheLinesAboveIt) {
    const auto header = find_measurement_header(
        "Instrument: BYK-mac i\nSerial, 12\n\n# remark\nWinkel;L*;a*;b*\n15;1;2;3\n");
    ASSERT_TRUE(header);
    EXPECT_EQ(header->line, 5u);
    EXPECT_EQ(header->separator, ';');
    for (const char* toml : {"wavelengths_nm = [400, 410, 420, 430, 440, 450, 460]\n",
                             "name = \"x\"\nL,a,b\n", "[geometry]\n", "\"L\" = 1\nL,a,b\n"}) {
        EXPECT_FALSE(find_measurement_header(toml)) << toml;
    }
    EXPECT_FALSE(find_measurement_header("ground,thickness_um,400,410,420,430,440\n"));
}

}  // namespace
}  // namespace nacre::io
