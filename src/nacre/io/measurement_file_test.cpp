#include "nacre/io/measurement_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "nacre/core/csv.h"
#include "nacre/core/error.h"
#include "nacre/measure/measurement.h"
#include "nacre/testing/errors.h"

namespace nacre::io {
namespace {

using nacre::test::message_of;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using ::testing::ThrowsMessage;

measure::Measurement example_measurement() {
    measure::Measurement m{"Silver, \"bright\"\nsecond line",
                           {spectra::Illuminant::A, spectra::Observer::cie1931_2deg, {1.5, 2.25}},
                           {400, 450.5, 501, 551.5},
                           {}};
    for (const measure::Geometry& g :
         {measure::in_plane(45, 0.1), measure::in_plane(45, 110), measure::off_plane(45, 25, -90),
          measure::towards(15, 45, 90)}) {
        const double level = 1 / (3 + g.aspecular_deg);
        m.readings.push_back(measure::coloured(
            g, m.wavelengths_nm, {level, level / 3, 0.7 * level, 1e-17}, m.conditions));
    }
    m.readings[1].geometry.name = "looking, back";
    return m;
}

std::string refused_measurement(const std::string& text) {
    return message_of<InputError>([&] { parse_measurement(text, "m.csv"); });
}

TEST(MeasurementFile, CsvComesBackBitForBit) {
    const measure::Measurement m = example_measurement();
    EXPECT_EQ(parse_measurement(measurement_csv(m), "m.csv"), m);
}

TEST(MeasurementFile, JsonComesBackBitForBit) {
    const measure::Measurement m = example_measurement();
    EXPECT_EQ(parse_measurement(measurement_json(m).dump(), "m.json"), m);
    EXPECT_EQ(parse_measurement("\xEF\xBB\xBF \n" + measurement_json(m).dump(2), "m.json"), m);
}

TEST(MeasurementFile, SomeReadingsMayLackASpectrum) {
    measure::Measurement m = example_measurement();
    m.readings[2].reflectance_factor.clear();
    EXPECT_EQ(parse_measurement(measurement_csv(m), "m.csv"), m);
    EXPECT_EQ(parse_measurement(measurement_json(m).dump(), "m.json"), m);
}

TEST(MeasurementFile, CsvStartsWithTheColumnsThatOthersRelyOn) {
    EXPECT_THAT(measurement_csv(example_measurement()),
                StartsWith("geometry,theta_i,aspecular_deg,L,a,b,C,h,X,Y,Z,R400,R450.5,R501,"
                           "R551.5,theta_o,phi,lamp_half_angle_deg,detector_half_angle_deg,"
                           "illuminant,observer,chip,sample\n45as0.1,45,0.1,"));
}

TEST(MeasurementFile, JsonHasTheFlopIndexAndTheTravel) {
    measure::Measurement m;
    for (double aspecular : {15.0, 45.0, 110.0}) {
        measure::Reading r;
        r.geometry = measure::in_plane(45, aspecular);
        r.lab = {120 - aspecular, aspecular, 0};
        m.readings.push_back(r);
    }
    const nlohmann::json json = measurement_json(m);
    EXPECT_EQ(json["flop_index"], *measure::flop_index(m));
    EXPECT_EQ(json["colour_travel"]["length"], 95);
    m.readings.pop_back();
    EXPECT_TRUE(measurement_json(m)["flop_index"].is_null());
}

TEST(MeasurementFile, ReadsColoursWithoutSpectraAsInstrumentsExportThem) {
    const measure::Measurement m = parse_measurement(
        "\xEF\xBB\xBF# made by hand\r\nDate;Geometry;L*;A*;B*\r\n"
        "2026-01-02;r45as15;110.5;-2;3.25\r\n\r\n2026-01-02;\"45asMinus15\";120;0;0\r\n",
        "m.csv", {spectra::Illuminant::A, spectra::Observer::cie1931_2deg, {}});
    ASSERT_EQ(m.readings.size(), 2u);
    EXPECT_EQ(m.readings[0].geometry.aspecular_deg, 15);
    EXPECT_EQ(m.readings[1].geometry.theta_o_deg, 60);
    EXPECT_EQ(m.readings[0].lab, (Vec3d{110.5, -2, 3.25}));
    EXPECT_EQ(m.conditions.illuminant, spectra::Illuminant::A);
    EXPECT_TRUE(m.wavelengths_nm.empty());
    // XYZ follows from L*a*b*: grey is as the white, of which Y is 100.
    const Vec3d white =
        spectra::white_point(spectra::Illuminant::A, spectra::Observer::cie1931_2deg);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(m.readings[1].xyz[c] / m.readings[1].xyz[1], white[c] / 100, 1e-14);
    }
}

TEST(MeasurementFile, ReadsSpectraAndMakesTheirColours) {
    const measure::Measurement m = parse_measurement(
        "theta_i,Aspecular,400,500nm,R600,r700\n45,15,1,1,1,1\n45,45,0.5,0.5,0.5,0.5\n", "m.csv");
    EXPECT_EQ(m.wavelengths_nm, (std::vector<double>{400, 500, 600, 700}));
    EXPECT_NEAR(m.readings[0].lab[0], 100, 1e-12);
    EXPECT_NEAR(m.readings[1].xyz[1], 50, 1e-12);
    EXPECT_EQ(m.readings[1].geometry.name, "45as45");
}

TEST(MeasurementFile, ReadsLightnessChromaHueAndTristimulusValues) {
    const auto lch = parse_measurement("geometry,L,C,h\n45as15,50,20,90\n", "m.csv");
    EXPECT_NEAR(lch.readings[0].lab[1], 0, 1e-14);
    EXPECT_NEAR(lch.readings[0].lab[2], 20, 1e-14);
    const auto xyz = parse_measurement("geometry,X,Y,Z\n45as15,20,21,22\n", "m.csv");
    EXPECT_EQ(xyz.readings[0].xyz[1], 21);
    EXPECT_NEAR(xyz.readings[0].lab[0], 116 * std::cbrt(0.21) - 16, 1e-12);
}

TEST(MeasurementFile, OffPlaneNamesAreUnderstoodWithoutMoreColumns) {
    const auto m =
        parse_measurement("geometry,theta_i,aspecular_deg,L,a,b\n45as25az90,45,25,9,0,0\n", "m");
    EXPECT_EQ(m.readings[0].geometry, measure::off_plane(45, 25, 90));
}

TEST(MeasurementFile, RefusalsNameLineAndColumn) {
    EXPECT_THAT(refused_measurement(""), HasSubstr("m.csv: is empty"));
    EXPECT_THAT(refused_measurement("geometry,L,a,b\n"), HasSubstr("no reading"));
    EXPECT_THAT(refused_measurement("geometry,L,a,b\n45as15,50,0,0\n45as45,50,x,0\n"),
                AllOf(StartsWith("m.csv:3:11: "), HasSubstr("a = x"), HasSubstr("number")));
    EXPECT_THAT(refused_measurement("geometry,L,a,b\n45as15,50,0\n"),
                AllOf(StartsWith("m.csv:2:1: "), HasSubstr("3 cells"), HasSubstr("has 4")));
    EXPECT_THAT(refused_measurement("geometry,L,a,b\n45at15,50,0,0\n"),
                AllOf(StartsWith("m.csv:2:1: "), HasSubstr("45at15"), HasSubstr("45as15")));
    EXPECT_THAT(refused_measurement("geometry,L,a,b\n45as150,50,0,0\n"),
                HasSubstr("below the horizon"));
    EXPECT_THAT(refused_measurement("geometry,L,a\n45as15,50,0\n"),
                HasSubstr("without the others"));
    EXPECT_THAT(refused_measurement("geometry,C\n45as15,50\n"), HasSubstr("without the others"));
    EXPECT_THAT(refused_measurement("geometry,date\n45as15,today\n"), HasSubstr("no colour"));
    EXPECT_THAT(refused_measurement("L,a,b\n1,2,3\n"), HasSubstr("geometry: is missing"));
    EXPECT_THAT(refused_measurement("geometry,\"L,a,b\n45as15,50,0,0\n"),
                AllOf(StartsWith("m.csv:1:10: "), HasSubstr("not closed")));
    EXPECT_THAT(refused_measurement("geometry,\"L\"x,a,b\n45as15,50,0,0\n"),
                HasSubstr("follows the quoted"));
    EXPECT_THAT(refused_measurement("geometry,L,a,b,l\n45as15,50,0,0,0\n"),
                HasSubstr("appears twice"));
    EXPECT_THAT(refused_measurement("geometry,L,a,b,iluminant\n45as15,50,0,0,A\n"),
                AllOf(HasSubstr("iluminant"), HasSubstr("did you mean 'illuminant'")));
    EXPECT_THAT(refused_measurement("geometry,L,a,b\n45as15,1,0,0\n45as15,1,0,0\n"),
                HasSubstr("read before"));
    EXPECT_THAT(refused_measurement("geometry,L,a,b\n45as15,nan,0,0\n"), HasSubstr("L = nan"));
    EXPECT_THAT(refused_measurement("geometry,L,a,b\n45as15,1e7,0,0\n"),
                HasSubstr("[-1000000, 1000000]"));
}

TEST(MeasurementFile, RefusesInvalidSpectra) {
    EXPECT_THAT(refused_measurement("geometry,R400,R500,R700\n45as15,1,1,1\n"),
                HasSubstr("unequal steps"));
    EXPECT_THAT(refused_measurement("geometry,R400\n45as15,1\n"), HasSubstr("2 wavelengths"));
    EXPECT_THAT(refused_measurement("geometry,R500,R400\n45as15,1,1\n"),
                HasSubstr("must be above"));
    EXPECT_THAT(refused_measurement("geometry,R4,R5\n45as15,1,1\n"), HasSubstr("[100, 10000] nm"));
    EXPECT_THAT(refused_measurement("geometry,R400,R500\n45as15,1,\n"), HasSubstr("R500"));
    // The wrong light, or the wrong panel, is caught by the colours beside the spectrum.
    EXPECT_THAT(
        refused_measurement("geometry,L,a,b,R400,R500,R600,R700\n45as15,50,0,0,50,50,50,50\n"),
        AllOf(HasSubstr("Delta E 2000"), HasSubstr("factor")));
}

TEST(MeasurementFile, RefusesGeometriesThatContradictThemselves) {
    EXPECT_THAT(refused_measurement("geometry,aspecular_deg,L,a,b\n45as15,25,1,0,0\n"),
                HasSubstr("contradicts"));
    EXPECT_THAT(refused_measurement("geometry,theta_i,L,a,b\n45as15,40,1,0,0\n"),
                HasSubstr("contradicts"));
    EXPECT_THAT(refused_measurement("geometry,theta_i,theta_o,phi,L,a,b\n45as15,45,30,0,1,0,0\n"),
                HasSubstr("60 deg off"));
    EXPECT_THAT(refused_measurement("theta_i,theta_o,L,a,b\n45,30,1,0,0\n"),
                HasSubstr("phi: is missing"));
}

TEST(MeasurementFile, RefusesRowsUnderDifferentLight) {
    EXPECT_THAT(
        refused_measurement("geometry,illuminant,L,a,b\n45as15,D65,1,0,0\n45as45,A,1,0,0\n"),
        AllOf(StartsWith("m.csv:3:8: "), HasSubstr("same in all rows")));
    EXPECT_THAT(refused_measurement("geometry,illuminant,L,a,b\n45as15,D65,1,0,0\n45as45,,1,0,0\n"),
                HasSubstr("missing here"));
    EXPECT_THAT(refused_measurement("geometry,illuminant,L,a,b\n45as15,,1,0,0\n45as45,A,1,0,0\n"),
                HasSubstr("missing in the rows above"));
    EXPECT_THAT(refused_measurement("geometry,illuminant,L,a,b\n45as15,D66,1,0,0\n"),
                HasSubstr("D65"));
    EXPECT_THAT(refused_measurement("geometry,lamp_half_angle_deg,L,a,b\n45as15,11,1,0,0\n"),
                HasSubstr("[0, 10] deg"));
}

TEST(MeasurementFile, JsonRefusalsNameTheMember) {
    nlohmann::json json = measurement_json(example_measurement());
    const auto with = [&](const char* key, const nlohmann::json& value) {
        nlohmann::json changed = json;
        changed[nlohmann::json::json_pointer(key)] = value;
        return refused_measurement(changed.dump());
    };
    EXPECT_THAT(refused_measurement("{"), AllOf(StartsWith("m.csv: "), HasSubstr("line 1")));
    EXPECT_THAT(refused_measurement("{}"), HasSubstr("format"));
    EXPECT_THAT(with("/format_version", 2), HasSubstr("format_version: must be 1"));
    EXPECT_THAT(with("/readings/2/lab/1", "red"),
                AllOf(HasSubstr("readings[2].lab"), HasSubstr("number")));
    EXPECT_THAT(with("/readings/2/lab", {1, 2}), HasSubstr("three numbers"));
    EXPECT_THAT(with("/readings/1", 3), HasSubstr("must be an object"));
    EXPECT_THAT(with("/readings/0/reflectance_factor", {1, 2}), HasSubstr("4 wavelengths"));
    EXPECT_THAT(with("/illuminant", "X"), HasSubstr("illuminant"));
    EXPECT_THAT(with("/observer", 2), HasSubstr("must be text"));
    EXPECT_THAT(with("/readings", nlohmann::json::array()), HasSubstr("readings"));
}

// Files made to exhaust the memory, or the stack of a recursive reader.
TEST(MeasurementFile, RefusesExcessiveDepthAndNumbersOfCells) {
    const std::string deep =
        R"({"format": "nacre-measurement", "lab": )" + std::string(500'000, '[');
    EXPECT_THAT(refused_measurement(deep),
                HasSubstr("m.csv: lists and objects are nested deeper than 64"));
    EXPECT_THAT(refused_measurement("geometry" + std::string(kMaxCsvCells, ',')),
                AllOf(StartsWith("m.csv:1:"), HasSubstr("more than 5000000 cells")));
}

TEST(MeasurementFile, IsToldFromARecipe) {
    EXPECT_TRUE(looks_like_measurement(measurement_csv(example_measurement())));
    EXPECT_TRUE(looks_like_measurement(measurement_json(example_measurement()).dump()));
    EXPECT_TRUE(looks_like_measurement("# comment\n\nL;a;b;Geometry\n"));
    EXPECT_TRUE(looks_like_measurement("theta_i,theta_o,phi,L,a,b\n"));
    for (const char* text : {"", "name = \"geometry\"\n", "[geometry]\n", "# geometry,L,a,b\n",
                             "\x89HDF\r\n\x1a\n", "\"geometry"}) {
        EXPECT_FALSE(looks_like_measurement(text)) << text;
    }
}

}  // namespace
}  // namespace nacre::io
