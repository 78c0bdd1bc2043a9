#include "nacre/io/measurement_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "nacre/core/csv.h"
#include "nacre/core/error.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/files.h"

// Tables as instruments and spreadsheets write them.

namespace nacre::io {
namespace {

using nacre::test::message_of;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

std::string refused_table(const std::string& text) {
    return message_of<InputError>([&] { parse_measurement_file(text, "m.csv"); });
}

TEST(MeasurementTable, ReadsDecimalCommasBetweenSemicolonsAndTabs) {
    for (const char separator : {';', '\t'}) {
        std::string text = "Winkel;L*;a*;b*\n-15;122,4;-0,6;-1,1\n45;58,9;-0,5;1\n";
        std::replace(text.begin(), text.end(), ';', separator);
        const auto m = parse_measurement(text, "m.csv");
        ASSERT_EQ(m.readings.size(), 2u);
        EXPECT_EQ(m.readings[0].geometry, measure::in_plane(45, -15));
        EXPECT_EQ(m.readings[0].lab, (Vec3d{122.4, -0.6, -1.1}));
        EXPECT_EQ(m.readings[1].lab, (Vec3d{58.9, -0.5, 1}));
    }
}

TEST(MeasurementTable, RefusesDecimalCommasBetweenCommasAndMixedMarks) {
    EXPECT_THAT(refused_table("geometry,L,a,b\n45as15,122,4,-0,6,-1,1\n"),
                AllOf(StartsWith("m.csv:2:1: has 7 cells; the header has 4"),
                      HasSubstr("decimal commas need semicolons or tabs")));
    EXPECT_THAT(refused_table("geometry,L,a,b\n45as15,\"122,4\",0,0\n"),
                AllOf(StartsWith("m.csv:2:8: L = 122,4: "), HasSubstr("semicolons")));
    EXPECT_THAT(refused_table("geometry;X;Y;Z\n45as15;1,234;56.7;8\n"),
                AllOf(StartsWith("m.csv:2:8: 1,234 has a decimal comma"),
                      HasSubstr("56.7 in line 2 has a point")));
    EXPECT_THAT(refused_table("geometry;L;a;b\n45as15;1.234,5;0;0\n"), HasSubstr("thousands"));
}

TEST(MeasurementTable, ReadsARowASampleWithColumnsByAngle) {
    const auto file = parse_measurement_file(
        "Report 7\nProbe;L* -15;a* -15;b* -15;L* 110;a* 110;b* 110;Datum\n"
        "Silber;138,5;-0,6;-1,5;12,8;-0,4;-1,2;2.3.2026\nRot;;;;20;50;30;\n;;;;;;;\n",
        "m.csv");
    ASSERT_EQ(file.samples.size(), 2u);
    EXPECT_THAT(file.notes, ElementsAre("m.csv: does not state illuminant and observer; taken as "
                                        "D65 and 10 degrees"));
    const measure::Measurement& silver = file.samples[0];
    EXPECT_EQ(silver.name, "Silber");
    ASSERT_EQ(silver.readings.size(), 2u);
    EXPECT_EQ(silver.readings[0].geometry, measure::in_plane(45, -15));
    EXPECT_EQ(silver.readings[0].lab, (Vec3d{138.5, -0.6, -1.5}));
    EXPECT_EQ(silver.readings[1].geometry.aspecular_deg, 110);
    // An angle that was not read on a panel is no reading.
    EXPECT_EQ(file.samples[1].name, "Rot");
    ASSERT_EQ(file.samples[1].readings.size(), 1u);
    EXPECT_EQ(file.samples[1].readings[0].lab, (Vec3d{20, 50, 30}));
}

TEST(MeasurementTable, ReadsSpectraByAngle) {
    const auto m = parse_measurement(
        "45as15_R400,45as15_R500,45as15_R600,45as110_R400,45as110_R500,45as110_R600\n"
        "1,1,1,0.5,0.5,0.5\n",
        "m.csv");
    EXPECT_EQ(m.wavelengths_nm, (std::vector<double>{400, 500, 600}));
    ASSERT_EQ(m.readings.size(), 2u);
    EXPECT_NEAR(m.readings[0].lab[0], 100, 1e-9);
    EXPECT_NEAR(m.readings[1].xyz[1], 50, 1e-9);
    const auto some =
        parse_measurement("L 15,a 15,b 15,45as110_R400,45as110_R500\n90,1,2,0.5,0.5\n", "m.csv");
    EXPECT_TRUE(some.readings[0].reflectance_factor.empty());
    EXPECT_THAT(some.readings[1].reflectance_factor, ElementsAre(0.5, 0.5));
    EXPECT_THAT(refused_table("45as15_R400,45as15_R500,45as45_R400,45as45_R600\n1,1,1,1\n"),
                HasSubstr("other wavelengths"));
}

TEST(MeasurementTable, OneSampleOfSeveralIsNamedOrNumbered) {
    const std::string text = "sample,geometry,L,a,b\nA,as15,90,0,0\nA,as45,50,0,0\nB,as15,80,1,2\n";
    EXPECT_EQ(parse_measurement(text, "m.csv", {}, "B").readings[0].lab, (Vec3d{80, 1, 2}));
    EXPECT_EQ(parse_measurement(text, "m.csv", {}, "1").readings.size(), 2u);
    EXPECT_THAT(refused_table(text + "B,as15,1,0,0\n"), HasSubstr("has been read before"));
    const auto refused = [&](const std::string& sample) {
        return message_of<InputError>([&] { parse_measurement(text, "m.csv", {}, sample); });
    };
    EXPECT_THAT(refused(""), AllOf(HasSubstr("holds 2 samples: 'A', 'B'"), HasSubstr("m.csv#A")));
    EXPECT_THAT(refused("C"), HasSubstr("has no sample 'C'"));
    EXPECT_THAT(refused("3"), HasSubstr("has no sample '3'"));
    const std::string twice = "name,L 15,a 15,b 15\nA,1,0,0\nA,2,0,0\n";
    EXPECT_EQ(parse_measurement(twice, "m.csv", {}, "2").readings[0].lab[0], 2);
    EXPECT_THAT(message_of<InputError>([&] { parse_measurement(twice, "m.csv", {}, "A"); }),
                HasSubstr("2 samples are called 'A'"));
}

TEST(MeasurementTable, AFileIsTakenApartFromTheSampleInIt) {
    EXPECT_EQ(split_sample_name("panels.csv#Silver 2").file, "panels.csv");
    EXPECT_EQ(split_sample_name("panels.csv#Silver 2").sample, "Silver 2");
    EXPECT_EQ(split_sample_name("panels.csv").sample, "");
    EXPECT_EQ(split_sample_name("#1.csv").file, "#1.csv");
    EXPECT_EQ(split_sample_name("panels.csv#").file, "panels.csv#");
    EXPECT_EQ(split_sample_name("line#1/panels.csv#Silver 2").file, "line#1/panels.csv");
}

TEST(MeasurementTable, ASampleAndAFileMayHaveTheMarkInTheirNames) {
    const nacre::test::TempFolder folder;
    const auto parts = [&](const std::string& name) {
        const SampleName found = split_sample_name(folder / name);
        return std::pair(found.file.filename().string(), found.sample);
    };
    using Parts = std::pair<std::string, std::string>;
    EXPECT_EQ(parts("p.csv#Red #3"), Parts("p.csv", "Red #3")) << "no file: the first mark";
    folder.write("p.csv", "x");
    EXPECT_EQ(parts("p.csv#Red #3"), Parts("p.csv", "Red #3"));
    EXPECT_EQ(parts("p.csv##3"), Parts("p.csv", "#3"));
    EXPECT_EQ(parts("p.csv#3#"), Parts("p.csv", "3#"));
    folder.write("p.csv#Red ", "x");
    EXPECT_EQ(parts("p.csv#Red #3"), Parts("p.csv#Red ", "3")) << "the longest file";
    EXPECT_EQ(parts("p.csv#Red "), Parts("p.csv#Red ", ""));
    std::filesystem::create_directory(folder / "q");
    folder.write("q#1.csv", "x");
    EXPECT_EQ(parts("q#1.csv#A"), Parts("q#1.csv", "A")) << "a folder is no file";
    folder.write("a#b.csv", "x");
    EXPECT_EQ(parts("a#b.csv#c#d"), Parts("a#b.csv", "c#d"));
}

TEST(MeasurementTable, RowsThatAreTakenForCommentsAreTold) {
    const std::string header =
        "# by hand; with, all; of it;\nname;L 15;a 15;b 15;illuminant;observer\n";
    const auto notes = [&](const std::string& rows) {
        return parse_measurement_file(header + rows, "m.csv").notes;
    };
    EXPECT_THAT(notes("A;1;2;3;A;2\n# the last one is doubtful\n\"#2\";1;2;3;A;2\n"), IsEmpty());
    EXPECT_THAT(
        notes("#1;1;2;3;A;2\nA;1;2;3;A;2\n#2;1;2;3;A;2\n"),
        ElementsAre("m.csv:3: begins with # as comments do, and is passed over, as is one line "
                    "more; a name that begins so stands in quotes"));
    EXPECT_EQ(parse_measurement(header + "\"#2\";1;2;3;A;2\n", "m.csv", {}, "#2").name, "#2");
}

// Factors and percent, told apart by what the file says.

TEST(MeasurementTable, PercentThatTheFileStatesIsTakenAsSuch) {
    for (const char* text :
         {"geometry,R400 [%],R500 [%]\n45as15,50,50\n", "geometry,%R400,%R500\n45as15,50,50\n",
          "geometry,R400,R500\n45as15,50%,50 %\n"}) {
        const auto file = parse_measurement_file(text, "m.csv");
        EXPECT_THAT(file.samples[0].readings[0].reflectance_factor, ElementsAre(0.5, 0.5)) << text;
        EXPECT_THAT(file.notes, IsEmpty());
    }
    const auto factor = parse_measurement_file("geometry,R400 [1],R500 [1]\n45as45,50,50\n", "m");
    EXPECT_THAT(factor.samples[0].readings[0].reflectance_factor, ElementsAre(50, 50));
    EXPECT_THAT(refused_table("geometry,R400 [1],R500 [%]\n45as45,50,50\n"), HasSubstr("percent"));
}

TEST(MeasurementTable, PercentIsToldByTheColoursBesideIt) {
    const std::string header =
        "geometry,illuminant,observer,L,a,b,R400,R500,R600,R700\n45as15,D65,10,";
    const auto percent = parse_measurement_file(header + "76.07,0,0,50,50,50,50\n", "m.csv");
    EXPECT_NEAR(percent.samples[0].readings[0].reflectance_factor[0], 0.5, 1e-12);
    ASSERT_EQ(percent.notes.size(), 1u);
    EXPECT_THAT(percent.notes[0], AllOf(HasSubstr("m.csv: reflectances of up to 50"),
                                        HasSubstr("percent"), HasSubstr("colours beside")));
    // A mirror-like flake near the gloss: L* of Y = 5000.
    const auto factor = parse_measurement_file(header + "411.34,0,0,50,50,50,50\n", "m.csv");
    EXPECT_EQ(factor.samples[0].readings[0].reflectance_factor[0], 50);
    EXPECT_THAT(factor.notes, IsEmpty());
    EXPECT_THAT(refused_table(header + "50,0,0,50,50,50,50\n"),
                AllOf(HasSubstr("under D65 and 10 degrees"), HasSubstr("Delta E 2000")));
}

// Of another light than is taken, colours agree with neither scale, but with one by far less.
TEST(MeasurementTable, PercentIsToldByColoursOfAnotherLight) {
    const auto scale_of = [](const std::string& text) {
        const auto file = parse_measurement_file(text, "m.csv");
        return file.samples[0].readings[0].reflectance_factor[0];
    };
    const std::string xyz = "geometry,X,Y,Z,R400,R450,R500,R550,R600,R650,R700\n45as45,";
    const std::string d50 = "43.4,45,37.1,", factors = "0.434,0.45,0.371,";
    EXPECT_NEAR(scale_of(xyz + d50 + "45,45,45,45,45,45,45\n"), 0.45, 1e-12);
    EXPECT_NEAR(scale_of(xyz + d50 + ".45,.45,.45,.45,.45,.45,.45\n"), 0.45, 1e-12);
    // Of which 1 is white, where it should be 100.
    EXPECT_NEAR(scale_of(xyz + factors + "45,45,45,45,45,45,45\n"), 0.45, 1e-12);
    EXPECT_NEAR(scale_of(xyz + "1.42,1.5,1.61,1.5,1.5,1.5,1.5,1.5,1.5,1.5\n"), 0.015, 1e-12);
    const auto file = parse_measurement_file(xyz + d50 + "45,45,45,45,45,45,45\n", "m.csv");
    EXPECT_THAT(file.notes, ::testing::Contains(HasSubstr("the colours beside them are nearer")));
    EXPECT_THAT(file.notes,
                ::testing::Contains(HasSubstr("does not state illuminant and observer")));
    ASSERT_EQ(file.contradictions.size(), 1u);
    EXPECT_EQ(file.contradictions[0].size(), 1u);
}

TEST(MeasurementTable, AColourInPartSaysWhichColumnsBelongTogether) {
    EXPECT_THAT(refused_table("geometry,L,a,b\n45as15,50,,\n"),
                HasSubstr("L, a and b: one is given without the others"));
    EXPECT_THAT(refused_table("geometry,L,C,h\n45as15,50,10,\n"),
                HasSubstr("L, C and h: one is given without the others"));
}

TEST(MeasurementTable, PercentIsToldByTheValuesOfTheWholeFile) {
    const auto first = [](const MeasurementFile& file) {
        return file.samples[0].readings[0].reflectance_factor[0];
    };
    const std::string header = "geometry,R400,R500\n";
    // A silver in percent, in factors, and in factors that pass 1 near the gloss.
    const auto percent =
        parse_measurement_file(header + "as15,180,182\nas45,27,28\nas110,1.4,1.5\n", "m.csv");
    EXPECT_NEAR(first(percent), 1.8, 1e-12);
    ASSERT_EQ(percent.notes.size(), 1u);
    EXPECT_THAT(percent.notes[0], HasSubstr("up to 182 are taken as percent"));
    for (const char* rows : {"as15,1.8,1.82\nas45,0.27,0.28\nas110,0.014,0.015\n",
                             "as15,4.5,4.6\nas45,0.27,0.28\nas110,0.014,0.015\n"}) {
        const auto factor = parse_measurement_file(header + rows, "m.csv");
        EXPECT_GT(first(factor), 1) << rows;
        EXPECT_THAT(factor.notes, IsEmpty()) << rows;
    }
    // One angle far from the gloss: brighter than two perfect diffusers is no paint.
    EXPECT_NEAR(first(parse_measurement_file(header + "as45,45.2,45.2\n", "m.csv")), 0.452, 1e-12);
    // A dark pearl in percent, or a bright one in factors.
    EXPECT_THAT(refused_table(header + "as15,7.3,7.2\nas45,1.1,1\nas110,0.4,0.5\n"),
                AllOf(HasSubstr("from 0.4 to 7.3 may be factors"), HasSubstr("R400 [%]")));
}

TEST(MeasurementTable, WhatSpreadsheetsAddIsPassedOver) {
    const auto m = parse_measurement(
        "\xEF\xBB\xBF"
        "Geometry;L*;a*;b*;;\r\n45as15;1,5;2;3;;\r\n;;;;;\r\n45as45;1;2;3;;;\r\n",
        "m.csv");
    EXPECT_EQ(m.readings.size(), 2u);
    const auto signs = parse_measurement(
        "angle;L;a;b\n\u221215;1;\u22122;3\n45\u00b0;1;2;3\n45as 110;1;2;3\n", "m.csv");
    EXPECT_EQ(signs.readings[0].geometry, measure::in_plane(45, -15));
    EXPECT_EQ(signs.readings[0].lab[1], -2);
    EXPECT_EQ(signs.readings[1].geometry.name, "45as45");
    EXPECT_EQ(signs.readings[2].geometry, measure::in_plane(45, 110));
}

TEST(MeasurementTable, ABareAngleBelongsToTheLampThatIsStated) {
    const auto m = parse_measurement("theta_i;angle;L;a;b\n15;-15;1;0;0\n45;15;1;0;0\n", "m.csv");
    EXPECT_EQ(m.readings[0].geometry, measure::in_plane(15, -15));
    EXPECT_EQ(m.readings[1].geometry, measure::in_plane(45, 15));
    EXPECT_THAT(refused_table("angle,L,a,b\n45/0,1,0,0\n"), HasSubstr("45as45"));
    // Beside directions a number is a label.
    const auto labels =
        parse_measurement("geometry,theta_i,theta_o,phi,L,a,b\n1,45,30,180,9,0,0\n", "m.csv");
    EXPECT_EQ(labels.readings[0].geometry.name, "1");
    EXPECT_EQ(parse_measurement(measurement_csv(labels), "m.csv"), labels);
}

TEST(MeasurementTable, AnUnknownHeaderIsToldWhichAreKnown) {
    EXPECT_THAT(refused_table("# x\nkey,value\n1,2\n"),
                AllOf(StartsWith("m.csv:2:1: 'key' is in no header that is known"),
                      HasSubstr("geometry (45as15"), HasSubstr("Winkel"), HasSubstr("L -15")));
    EXPECT_THAT(refused_table("Date;L*;a*;b*\n1;2;3;4\n"), HasSubstr("geometry: is missing"));
    EXPECT_THAT(refused_table(std::string("\xFF\xFEL\0", 4)), HasSubstr("save the file as UTF-8"));
    EXPECT_THAT(refused_table("Pr\xfc"
                              "fling;Winkel;L;a;b\n"),
                HasSubstr("save the file as UTF-8"));
}

// Files made to keep the reader busy.
TEST(MeasurementTable, RefusesExcessiveColumnsAndAngles) {
    std::string wide = "L 0.001,a 0.001,b 0.001";
    for (int i = 2; i < 1200; ++i) wide += ",L " + std::to_string(i * 0.1);
    EXPECT_THAT(refused_table(wide + "\n1,2,3\n"), HasSubstr("more than 1000 angles"));
    EXPECT_THAT(refused_table("geometry" + std::string(30'000, ',') + "\n1\n"),
                HasSubstr("more than 20000 columns"));
}

}  // namespace
}  // namespace nacre::io
