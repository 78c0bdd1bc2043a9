#include "nacre/io/colour_agreement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "nacre/io/measurement_file.h"

namespace nacre::io {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::vector<std::string> contradictions(const std::string& text) {
    std::vector<std::string> all;
    for (const auto& of_sample : parse_measurement_file(text, "f.csv").contradictions)
        all.insert(all.end(), of_sample.begin(), of_sample.end());
    return all;
}

// L* = 50 is Y = 18.4187; the white is X = 94.81, Y = 100, Z = 107.32 (D65, 10 degrees) [cie-15-2018].
constexpr const char* kXyzHeader = "geometry,L,a,b,X,Y,Z\n";

TEST(ColourAgreement, XyzAreThoseOfTheColour) {
    EXPECT_THAT(contradictions(std::string(kXyzHeader) + "45as45,50,0,0,17.46,18.42,19.77\n"),
                IsEmpty());
    EXPECT_THAT(contradictions(std::string(kXyzHeader) + "45as25,50.0,0.0,0.0,17.46,18.42,19.77\n"
                                                         "45as45,52.0,0.0,0.0,17.46,18.42,19.77\n"
                                                         "45as75,51.0,0.0,0.0,17.46,18.42,19.77\n"),
                ElementsAre(AllOf(HasSubstr("f.csv:3:1: L, a, b and X, Y, Z contradict each other"),
                                  HasSubstr("Delta E 2000 = 1.9"),
                                  HasSubstr("what counts is L, a, b; so in 2 rows, here most"))));
}

TEST(ColourAgreement, DigitsThatRoundAreNoContradiction) {
    // Y = 0.1 may be 0.149, L* = 1.35, or 0.051, L* = 0.46.
    EXPECT_THAT(contradictions(std::string(kXyzHeader) + "45as45,1.35,0,0,0.1,0.1,0.1\n"),
                IsEmpty());
    EXPECT_THAT(contradictions(std::string(kXyzHeader) + "45as45,1.35,0,0,0.100,0.101,0.107\n"),
                IsEmpty());
    EXPECT_THAT(
        contradictions(std::string(kXyzHeader) + "45as45,2.35,0.00,0.00,0.095,0.101,0.107\n"),
        ElementsAre(HasSubstr("X, Y, Z")));
    EXPECT_THAT(contradictions("geometry;L;a;b;C;h\n45as45;50;60,0;0,5;60,0;0\n"), IsEmpty());
}

TEST(ColourAgreement, IsASamplesOwn) {
    const auto file = parse_measurement_file(
        "name,geometry,L,a,b,X,Y,Z\nA,45as45,50.0,0.0,0.0,17.46,18.42,19.77\n"
        "B,45as45,55.0,0.0,0.0,17.46,18.42,19.77\n",
        "f.csv");
    ASSERT_EQ(file.samples.size(), 2u);
    ASSERT_EQ(file.contradictions.size(), 2u);
    EXPECT_THAT(file.contradictions[0], IsEmpty());
    EXPECT_THAT(file.contradictions[1], ElementsAre(HasSubstr("f.csv:3:1")));
}

// Instruments state X, Y, Z by the tabulated white; sums over few wavelengths have another.
TEST(ColourAgreement, TristimulusValuesMayBeOfEitherWhite) {
    // L* = 50 of both, D65 and 10 degrees: 94.811, 100, 107.304.
    const std::string header = "geometry,L,a,b,X,Y,Z,R420,R500,R580,R660\n45as45,50,0,0,";
    const std::string grey = ",0.184187,0.184187,0.184187,0.184187\n";
    EXPECT_THAT(contradictions(header + "17.463,18.419,19.764" + grey), IsEmpty());
    EXPECT_THAT(contradictions(header + "19.463,18.419,19.764" + grey),
                ElementsAre(HasSubstr("X, Y, Z")));
}

TEST(ColourAgreement, ChromaAndHueAreThoseOfTheColour) {
    const std::string header = "geometry,L,a,b,C,h\n";
    EXPECT_THAT(contradictions(header + "45as45,50,30.0,40.0,50.0,53.1\n"), IsEmpty());
    EXPECT_THAT(contradictions(header + "45as45,50,30.0,40.0,50.0,36.9\n"),
                ElementsAre(AllOf(HasSubstr("L, a, b and L, C, h contradict"),
                                  HasSubstr("a* = 30.00, b* = 40.00 and L* = 50.00, a* = 39.98"))));
    EXPECT_THAT(contradictions(header + "45as45,50,0,0,0,---\n"), IsEmpty()) << "a grey has no hue";
}

TEST(ColourAgreement, ASpectrumIsComparedUnderTheStatedLight) {
    const std::string grey = ",0.184187,0.184187,0.184187,0.184187\n", lab = "45as45,50,0,0";
    const std::string spectrum = ",R400,R500,R600,R700";
    EXPECT_THAT(contradictions("geometry,L,a,b" + spectrum + "\n" + lab + grey), IsEmpty());
    EXPECT_THAT(contradictions("geometry,L,a,b" + spectrum + "\n45as45,52.0,0.0,0.0" + grey),
                ElementsAre(AllOf(HasSubstr("f.csv:2:1: L, a, b and the spectrum contradict each "
                                            "other under D65 for 10 degrees: L* = 52.00"),
                                  HasSubstr("what counts is L, a, b"))));
    EXPECT_THAT(contradictions("geometry,X,Y,Z" + spectrum + "\n45as45,17.5,30.1,32" + grey),
                ElementsAre(AllOf(HasSubstr("the spectrum and X, Y, Z contradict"),
                                  HasSubstr("what counts is the spectrum"))));
    // Two decimals of a factor.
    EXPECT_THAT(
        contradictions("geometry,L,a,b" + spectrum + "\n45as45,12,0,0,0.01,0.01,0.01,0.01\n"),
        IsEmpty());
}

TEST(ColourAgreement, JsonNamesItsReading) {
    const std::string text =
        R"({"format": "nacre-measurement", "format_version": 1, "readings": [
            {"geometry": "45as45", "lab": [50, 0, 0], "xyz": [17.46, 18.42, 19.77]},
            {"geometry": "45as75", "lab": [53, 0, 0], "xyz": [17.46, 18.42, 19.77]}]})";
    EXPECT_THAT(contradictions(text), ElementsAre(HasSubstr("f.csv: readings[1]: L, a, b and X")));
}

}  // namespace
}  // namespace nacre::io
