#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "apps/cli/program_test_support.h"
#include "nacre/io/measurement_file.h"

// Tables between Nacre, instruments and spreadsheets.

namespace nacre::cli::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

// What a German spreadsheet shows of a panel, and what the same panel is in Nacre's own table.
TEST_F(Program, MeasuredTablesOfSpreadsheetsAreReadAsTheyAre) {
    write("own.csv", "geometry,L,a,b\n45as-15,138.5,-0.6,-1.5\n45as110,12.8,-0.4,-1.2\n");
    write("tall.csv", "Winkel;Helligkeit;a*;b*\n-15;138,5;-0,6;-1,5\n110;12,8;-0,4;-1,2\n");
    write("wide.csv", "L*-15;a*-15;b*-15;L*110;a*110;b*110\n138,5;-0,6;-1,5;12,8;-0,4;-1,2\n");
    write("file.txt",
          "CGATS.17\nILLUMINANT \"D65\"\nOBSERVER \"10\"\nBEGIN_DATA_FORMAT\nGEOMETRY LAB_L LAB_A "
          "LAB_B\nEND_DATA_FORMAT\nBEGIN_DATA\nr45as-15 138.5 -0.6 -1.5\nr45as110 12.8 -0.4 -1.2\n"
          "END_DATA\n");
    const auto readings = [&](const std::string& file) {
        const Outcome outcome = nacre("measure " + file);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        auto m = io::parse_measurement(outcome.out, file);
        m.name.clear();
        for (measure::Reading& r : m.readings) {
            if (r.geometry.name.starts_with('r')) r.geometry.name.erase(0, 1);
        }
        return m;
    };
    const auto own = readings("own.csv");
    ASSERT_EQ(own.readings.size(), 2u);
    for (const char* file : {"tall.csv", "wide.csv", "file.txt"})
        EXPECT_EQ(readings(file), own) << file;
    EXPECT_THAT(nacre("measure tall.csv --versus own.csv").err, HasSubstr("greatest 0.00"));
}

TEST_F(Program, MeasuredColoursThatContradictThemselvesAreWarnedOf) {
    write("two.csv",
          "geometry,L,a,b,X,Y,Z\n45as15,50.0,0.0,0.0,17.46,18.42,19.77\n"
          "45as45,40.0,0.0,0.0,17.46,18.42,19.77\n");
    const char* words = "nacre: warning: two.csv:3:1: L, a, b and X, Y, Z contradict each other";
    for (const char* command :
         {"info two.csv", "measure two.csv", "measure gray.toml --versus two.csv",
          "fit two.csv --start gray.toml --free alpha --starts 1 --within 100"}) {
        const Outcome outcome = nacre(command);
        EXPECT_EQ(outcome.status, 0) << command << outcome.err;
        EXPECT_THAT(outcome.err, HasSubstr(words)) << command;
        const Outcome strict = nacre(std::string(command) + " --strict");
        EXPECT_EQ(strict.status, 2) << command;
        EXPECT_THAT(strict.err, HasSubstr("refused by --strict")) << command;
    }
    // What counts goes on.
    EXPECT_EQ(number(nacre("measure two.csv").out, 2, 3), 40);
}

TEST_F(Program, ASampleOfAFileIsChosenBehindItsName) {
    write("panels.csv", "Probe;L 15;a 15;b 15\nSilber 2;120;0;0\nRot;50;60;30\n");
    const Outcome several = nacre("measure panels.csv");
    EXPECT_EQ(several.status, 2);
    EXPECT_THAT(several.err, AllOf(HasSubstr("panels.csv: holds 2 samples: 'Silber 2', 'Rot'"),
                                   HasSubstr("'panels.csv#Silber 2'")));
    EXPECT_THAT(nacre("measure 'panels.csv#Rot'").out, HasSubstr("45as15,45,15,50,60,30,"));
    EXPECT_THAT(nacre("measure 'panels.csv#1'").out, HasSubstr("45as15,45,15,120,0,0,"));
    const Outcome versus = nacre("measure gray.toml --versus 'panels.csv#Silber 2'");
    EXPECT_EQ(versus.status, 0) << versus.err;
    EXPECT_EQ(number(versus.out, 1, 3), 120);
    write("marks.csv", "Probe;L 15;a 15;b 15\nRot #1;50;60;30\n\"#2\";40;60;30\n");
    EXPECT_THAT(nacre("measure 'marks.csv#Rot #1'").out, HasSubstr("45as15,45,15,50,60,30,"));
    EXPECT_THAT(nacre("measure 'marks.csv##2'").out, HasSubstr("45as15,45,15,40,60,30,"));
    // The file is an input, which no output replaces.
    EXPECT_THAT(nacre("measure 'marks.csv#Rot #1' -o marks.csv").err,
                HasSubstr("would replace an input"));
    EXPECT_THAT(nacre("measure 'panels.csv#Rot' -o panels.csv").err,
                HasSubstr("would replace an input"));
}

TEST_F(Program, PercentIsRecognisedAndSaid) {
    write("percent.csv", "geometry,R400,R500,R600,R700\n45as45,45.2,45.2,45.2,45.2\n");
    const Outcome outcome = nacre("measure percent.csv");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_THAT(outcome.err, HasSubstr("nacre: note: percent.csv: reflectances of up to 45.2 are "
                                       "taken as percent"));
    EXPECT_NEAR(number(outcome.out, 1, 3), 73.02, 0.01);  // L* of Y = 45.2
    EXPECT_THAT(nacre("measure percent.csv -q").err, IsEmpty());
    write("both.csv", "geometry,R400,R500\nas15,7.3,7.2\nas45,1.1,1\n");
    const Outcome refused = nacre("measure both.csv");
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.err, AllOf(HasSubstr("may be factors"), HasSubstr("R400 [%] or R400 [1]")));
}

TEST_F(Program, TablesAreWrittenWithDecimalCommas) {
    const Outcome points = nacre("measure gray.toml -q"),
                  commas = nacre("measure gray.toml -q --decimal comma --bom");
    EXPECT_EQ(commas.status, 0) << commas.err;
    EXPECT_THAT(commas.out, StartsWith("\xEF\xBB\xBFgeometry;theta_i;aspecular_deg;L;a;b;C;h;"));
    EXPECT_EQ(io::parse_measurement(commas.out, "comma"),
              io::parse_measurement(points.out, "point"));
    EXPECT_THAT(nacre("film --decimal comma --wavelength 550 --substrate 1.5").out,
                HasSubstr("\n550;0;u;0,04;0,96\n"));
    ASSERT_EQ(nacre("measure gray.toml -q --versus gray.toml --decimal comma -o d.csv").status, 0);
    EXPECT_THAT(contents(folder_ / "d.csv"), AllOf(HasSubstr(";dE2000;"), Not(HasSubstr("."))));
    const Outcome json = nacre("measure gray.toml --format json --decimal comma");
    EXPECT_EQ(json.status, 1);
    EXPECT_THAT(json.err, HasSubstr("--decimal comma belongs to CSV"));
    EXPECT_EQ(nacre("measure gray.toml --decimal dot").status, 1);
}

TEST_F(Program, CsvIsNotWrittenUnderTheNameOfAnotherFormat) {
    const auto refused = [&](const std::string& arguments, const char* words) {
        const Outcome outcome = nacre(arguments);
        EXPECT_EQ(outcome.status, 1) << arguments;
        EXPECT_THAT(outcome.err, HasSubstr(words)) << arguments;
    };
    refused("measure gray.toml -o x.xlsx",
            "x.xlsx: is a spreadsheet by its name, but what is "
            "written is CSV; end the name in .csv, which spreadsheets");
    refused("measure gray.toml -o x.json", "--format json");
    refused("measure gray.toml --format json -o x.csv", "end the name in .json");
    refused("film -o x.ods", "is a spreadsheet");
    refused("materials -o x.XLSX", "is a spreadsheet");
    refused("eval gray.toml --incident 45 --outgoing 45 -o x.png", "is a picture by its name");
    for (const char* name : {"x.xlsx", "x.json", "x.csv", "x.ods", "x.XLSX", "x.png"}) {
        EXPECT_FALSE(exists(name)) << name;
    }
    EXPECT_EQ(nacre("film -o x.txt").status, 0);
}

}  // namespace
}  // namespace nacre::cli::testing
