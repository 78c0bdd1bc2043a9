#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "nacre/core/error.h"
#include "nacre/io/measurement_formats.h"
#include "nacre/testing/errors.h"

namespace nacre::io {
namespace {

using nacre::test::message_of;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

/// A file of the format with these keywords, fields and sets.
std::string cgats_text(const std::string& keywords, const std::string& fields,
                       const std::string& sets) {
    return "CGATS.17\nORIGINATOR \"a program\"\n" + keywords + "BEGIN_DATA_FORMAT\n" + fields +
           "\nEND_DATA_FORMAT\nBEGIN_DATA\n" + sets + "END_DATA\n";
}

constexpr const char* kLight =
    "MEASUREMENT_SOURCE \"Illumination=D65 ObserverAngle=10 WhiteBase=Abs Filter=no\"\n";

std::string refused_cgats(const std::string& text) {
    return message_of<InputError>([&] { parse_measurement_file(text, "m.txt"); });
}

TEST(Cgats, ReadsASetForEachGeometry) {
    const auto file = parse_measurement_file(
        cgats_text(
            "ILLUMINATION_NAME \"D50\"\nOBSERVER_ANGLE \"2\"\nNUMBER_OF_FIELDS 6\n"
            "NUMBER_OF_SETS 2 # two\n",
            "SAMPLE_ID SAMPLE_NAME GEOMETRY LAB_L LAB_A LAB_B",
            "1 \"Silver 2\" r45as-15 138.5 -0.6 -1.5\r\n2 \"Silver 2\" r45as45 58.9 -0.5\n-1\n"),
        "m.txt");
    ASSERT_EQ(file.samples.size(), 1u);
    EXPECT_THAT(file.notes, IsEmpty());
    const measure::Measurement& m = file.samples[0];
    EXPECT_EQ(m.name, "Silver 2");
    EXPECT_EQ(m.conditions.illuminant, spectra::Illuminant::D50);
    EXPECT_EQ(m.conditions.observer, spectra::Observer::cie1931_2deg);
    ASSERT_EQ(m.readings.size(), 2u);
    EXPECT_EQ(m.readings[0].geometry.aspecular_deg, -15);
    EXPECT_EQ(m.readings[1].lab, (Vec3d{58.9, -0.5, -1}));
}

TEST(Cgats, ReadsFieldsByAngleAndNamesWithSpacesBetweenTabs) {
    const auto file = parse_measurement_file(
        cgats_text(kLight, "SAMPLE_NAME\tLAB_L_45as15\tLAB_A_45as15\tLAB_B_45as15",
                   "Red car\t50,5\t60\t30\nBlue\t20\t0\t-30\n"),
        "m.txt");
    ASSERT_EQ(file.samples.size(), 2u);
    EXPECT_EQ(file.samples[0].name, "Red car");
    EXPECT_EQ(file.samples[0].readings[0].lab, (Vec3d{50.5, 60, 30}));
    EXPECT_EQ(file.samples[0].conditions.observer, spectra::Observer::cie1964_10deg);
}

TEST(Cgats, ScalesSpectraByWhatTheFileSays) {
    const auto factors = [](const std::string& text) {
        return parse_measurement(text, "m.txt").readings[0].reflectance_factor;
    };
    EXPECT_THAT(
        factors(cgats_text(kLight, "GEOMETRY SPECTRAL_NM SPECTRAL_PCT SPECTRAL_NM SPECTRAL_PCT",
                           "45as45 400 25 500 50\n")),
        ElementsAre(0.25, 0.5));
    EXPECT_THAT(
        factors(cgats_text(kLight, "GEOMETRY SPECTRAL_NM SPECTRAL_DEC SPECTRAL_NM SPECTRAL_DEC",
                           "45as15 400 3 500 4\n")),
        ElementsAre(3, 4));
    EXPECT_THAT(factors(cgats_text(std::string(kLight) + "SPECTRAL_NORM \"100.0\"\n",
                                   "GEOMETRY SPEC_400 SPEC_500", "45as45 1 2\n")),
                ElementsAre(0.01, 0.02));
    EXPECT_THAT(
        factors(cgats_text(kLight, "GEOMETRY SPECTRAL_NM400 SPECTRAL_NM500", "45as45 0.25 0.5\n")),
        ElementsAre(0.25, 0.5));
}

TEST(Cgats, AGeometryMayStandInAKeyword) {
    const auto file =
        parse_measurement_file(cgats_text(std::string(kLight) + "MEASUREMENT_GEOMETRY \"45as15\"\n",
                                          "SAMPLE_ID LAB_L LAB_A LAB_B", "A1 50 0 0\nA2 60 0 0\n"),
                               "m.txt");
    ASSERT_EQ(file.samples.size(), 2u);
    EXPECT_EQ(file.samples[1].name, "A2");
    EXPECT_EQ(file.samples[1].readings[0].geometry, measure::in_plane(45, 15));
}

TEST(Cgats, SaysWhichLightItTakesWhereNoneIsStated) {
    const auto file = parse_measurement_file(
        cgats_text("", "GEOMETRY LAB_L LAB_A LAB_B", "45as15 50 0 0\n"), "m.txt");
    ASSERT_EQ(file.notes.size(), 1u);
    EXPECT_EQ(file.notes[0],
              "m.txt: does not state illuminant and observer; taken as D65 and 10 degrees");
    const auto weighting = parse_measurement_file(
        cgats_text(
            "WEIGHTING_FUNCTION \"ILLUMINANT, A\"\nWEIGHTING_FUNCTION \"OBSERVER, 2 degree\"\n",
            "GEOMETRY LAB_L LAB_A LAB_B", "45as15 50 0 0\n"),
        "m.txt");
    EXPECT_THAT(weighting.notes, IsEmpty());
    EXPECT_EQ(weighting.samples[0].conditions.illuminant, spectra::Illuminant::A);
    EXPECT_EQ(weighting.samples[0].conditions.observer, spectra::Observer::cie1931_2deg);
}

TEST(Cgats, TheObserverMayHaveItsUnitAsInTables) {
    for (const std::string unit : {"", "degree", " degree", "deg", " Grad", "\u00b0", " \u00b0"}) {
        for (const std::string& text :
             {cgats_text("MEASUREMENT_SOURCE \"Illumination=D50 ObserverAngle=2" + unit +
                             " WhiteBase=Abs\"\n",
                         "GEOMETRY LAB_L LAB_A LAB_B", "45as15 50 0 0\n"),
              cgats_text("OBSERVER \"2" + unit + " (1931)\"\n", "GEOMETRY LAB_L LAB_A LAB_B",
                         "45as15 50 0 0\n"),
              "geometry,L,a,b,observer\n45as15,50,0,0,2" + unit + "\n"}) {
            EXPECT_EQ(parse_measurement_file(text, "m.txt").samples.at(0).conditions.observer,
                      spectra::Observer::cie1931_2deg)
                << text;
        }
    }
    EXPECT_THAT(message_of<InputError>([] {
                    parse_measurement_file("geometry,L,a,b,observer\n45as15,50,0,0,3 deg\n", "m");
                }),
                HasSubstr("m:2:15: observer: observer '3 deg' is unknown; use 2 (CIE 1931)"));
}

TEST(Cgats, RefusalsNameLineAndColumn) {
    const std::string fields = "GEOMETRY LAB_L LAB_A LAB_B";
    EXPECT_THAT(refused_cgats(cgats_text("", fields, "45as15 50 0 0 1\n")),
                AllOf(StartsWith("m.txt:7:1: "), HasSubstr("has 5 values"), HasSubstr("4 fields")));
    EXPECT_THAT(refused_cgats(cgats_text("", fields, "45as15 50 0\n")), HasSubstr("has 3 values"));
    EXPECT_THAT(refused_cgats(cgats_text("", fields, "45as15 x 0 0\n")),
                AllOf(StartsWith("m.txt:7:8: "), HasSubstr("LAB_L = x")));
    EXPECT_THAT(refused_cgats(cgats_text("NUMBER_OF_SETS 3\n", fields, "45as15 50 0 0\n")),
                AllOf(StartsWith("m.txt:3:16: "), HasSubstr("NUMBER_OF_SETS = 3: there are 1")));
    EXPECT_THAT(refused_cgats(cgats_text("ILLUMINANT \"D66\"\n", fields, "45as15 50 0 0\n")),
                AllOf(StartsWith("m.txt:3:12: "), HasSubstr("D65")));
    EXPECT_THAT(refused_cgats(cgats_text("", "SAMPLE_ID LAB_L LAB_A LAB_B", "1 50 0 0\n")),
                HasSubstr("geometry: is missing"));
    EXPECT_THAT(refused_cgats(cgats_text("SPECTRAL_NORM 255\n", fields, "45as15 50 0 0\n")),
                HasSubstr("must be 1 or 100"));
    EXPECT_THAT(refused_cgats(cgats_text("", fields, "\"45as15 50 0 0\n")),
                HasSubstr("not closed"));
    const std::string whole = cgats_text("", fields, "45as15 50 0 0\n");
    EXPECT_THAT(refused_cgats(whole + whole), HasSubstr("a second table begins here"));
    EXPECT_THAT(refused_cgats(whole.substr(0, whole.find("END_DATA\n"))),
                HasSubstr("ends without END_DATA"));
    EXPECT_THAT(refused_cgats(cgats_text("", "GEOMETRY SPECTRAL_NM SPECTRAL_PCT",
                                         "45as15 400 1\n45as45 410 1\n")),
                HasSubstr("SPECTRAL_NM = 410: is 400 in the first set"));
}

}  // namespace
}  // namespace nacre::io
