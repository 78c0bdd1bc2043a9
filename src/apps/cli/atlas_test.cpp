#include <gmock/gmock.h>

#include "apps/cli/program_test_support.h"

namespace nacre::cli {
namespace {

using ::testing::HasSubstr;
using Atlas = nacre::cli::testing::Program;
using nacre::cli::testing::cell;
using nacre::cli::testing::contents;
using nacre::cli::testing::number;
using nacre::cli::testing::Outcome;

TEST_F(Atlas, WritesATableAndPicturesOfAFilm) {
    const std::string film =
        "atlas --film TiO2_anatase --core mica:500:60 --thickness 80,125 --aspecular 15,75 ";
    const Outcome csv = nacre(film);
    EXPECT_EQ(csv.status, 0) << csv.err;
    EXPECT_EQ(cell(csv.out, 0, 0), "thickness_nm");
    EXPECT_EQ(cell(csv.out, 2, 2), "75");
    EXPECT_NEAR(number(csv.out, 2, 7), 90, 20);   // gold
    EXPECT_NEAR(number(csv.out, 4, 7), 270, 40);  // blue
    EXPECT_EQ(cell(csv.out, 4, 8).size(), 7u);    // #rrggbb
    EXPECT_EQ(nacre(film + "-o a.svg").status, 0);
    EXPECT_THAT(contents(folder_ / "a.svg"), ::testing::StartsWith("<svg"));
    EXPECT_EQ(nacre(film + "-o a.png").status, 0);
    EXPECT_THAT(contents(folder_ / "a.png"), ::testing::StartsWith("\x89PNG"));
    for (const char* output : {"-o -", "-o /dev/stdout"}) {
        const Outcome printed = nacre(film + output);
        EXPECT_EQ(printed.status, 0) << printed.err;
        EXPECT_EQ(printed.out, csv.out) << output;
    }
    EXPECT_EQ(nacre(film + "-o a.csv").status, 0);
    EXPECT_EQ(contents(folder_ / "a.csv"), csv.out);
}

TEST_F(Atlas, FilmsMayBeNumbersAndHaveCoats) {
    const Outcome outer = nacre(
        "atlas --film 1.46 --core 1.2+7i:350 --outer Fe2O3:25:2 --thickness 388 --spread 8 "
        "--aspecular 75 --illuminant A --observer 2");
    EXPECT_EQ(outer.status, 0) << outer.err;
    const Outcome alone =
        nacre("atlas --film TiO2_anatase --thickness 100 --ior 1.33 --lamp 15 --aspecular 15,45");
    EXPECT_EQ(alone.status, 0) << alone.err;
}

TEST_F(Atlas, VariesANumberOfARecipe) {
    const Outcome outcome =
        nacre("atlas --recipe gray.toml --key alpha --values 0.2,0.4 --aspecular 15,75");
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_EQ(cell(outcome.out, 0, 0), "layer[0].flakes[0].orientation.alpha");
    // Flakes that lie less flat send less light near the mirror direction, and more aside.
    EXPECT_GT(number(outcome.out, 1, 3), number(outcome.out, 3, 3));
    EXPECT_LT(number(outcome.out, 2, 3), number(outcome.out, 4, 3));
}

TEST_F(Atlas, ReadsARecipeByTheModelThatIsChosen) {
    const std::string atlas =
        "atlas --recipe gray.toml --key alpha --values 0.2 --aspecular 15,75 ";
    const std::string by_solution = nacre(atlas).out;
    for (const char* model : {"microflake", "nacre", "nacre --no-hot-spot"}) {
        const Outcome read = nacre(atlas + "--model " + model);
        EXPECT_EQ(read.status, 0) << read.err;
        const Outcome measured = nacre(std::string("measure gray.toml --set alpha=0.2 --geometry "
                                                   "45as15,45as75 --format csv --model ") +
                                       model);
        EXPECT_EQ(measured.status, 0) << measured.err;
        for (const int line : {1, 2}) {
            for (const int column : {3, 4, 5}) {  // L, a, b
                EXPECT_NEAR(number(read.out, line, column), number(measured.out, line, column),
                            2e-4)
                    << model << " " << line << " " << column;
            }
        }
        EXPECT_NEAR(number(read.out, 2, 3), number(by_solution, 2, 3), 5) << model;
    }
    EXPECT_NE(nacre(atlas + "--model nacre").out, nacre(atlas + "--model microflake").out);
    EXPECT_THAT(nacre("atlas --film 2 --model nacre").err,
                HasSubstr("--model = nacre: belongs to --recipe"));
    EXPECT_EQ(nacre(atlas + "--model nacre -o m.svg").status, 0);
    EXPECT_THAT(contents(folder_ / "m.svg"), HasSubstr("by the model nacre"));
}

TEST_F(Atlas, SaysWhatIsWrongWithAnAtlas) {
    const auto complaint = [&](const std::string& arguments, int status) {
        const Outcome outcome = nacre("atlas " + arguments);
        EXPECT_EQ(outcome.status, status) << arguments << "\n" << outcome.err;
        EXPECT_EQ(outcome.out, "");
        return outcome.err;
    };
    EXPECT_THAT(complaint("", 1), HasSubstr("either --film or --recipe"));
    EXPECT_THAT(complaint("--film 2 --recipe gray.toml", 1),
                HasSubstr("either --film or --recipe"));
    EXPECT_THAT(complaint("--film 2 --key alpha", 1), HasSubstr("--key belongs to --recipe"));
    EXPECT_THAT(complaint("--recipe gray.toml --key alpha --ior 1.4", 1),
                HasSubstr("--ior belongs to --film"));
    EXPECT_THAT(complaint("--recipe gray.toml", 1), HasSubstr("--key"));
    EXPECT_THAT(complaint("--film 2 -o a.jpg", 1), HasSubstr(".svg, .png or .csv"));
    EXPECT_THAT(complaint("--film 2 --core mica", 1), HasSubstr("MATERIAL:THICKNESS"));
    EXPECT_THAT(complaint("--film 2 --core mica:-5", 1), HasSubstr("-5"));
    EXPECT_THAT(complaint("--film 2 --outer mica:5", 1), HasSubstr("--outer needs --core"));
    EXPECT_THAT(complaint("--film 2 --thickness 0", 1), HasSubstr("--thickness"));
    EXPECT_THAT(complaint("--film 2 --lamp 90", 1), HasSubstr("--lamp"));
    EXPECT_THAT(complaint("--film unobtainium", 2), HasSubstr("--film: material \"unobtainium\""));
    EXPECT_THAT(complaint("--film 2 --ior unobtainium", 2),
                HasSubstr("--ior: material \"unobtainium\""));
    EXPECT_THAT(complaint("--film 2 --ior 1.5+1i", 2), HasSubstr("absorbs"));
    EXPECT_THAT(complaint("--film 2 --ior 5", 2), HasSubstr("[1, 3]"));
    EXPECT_THAT(complaint("--film 2 --aspecular 150", 2), HasSubstr("150"));
    EXPECT_THAT(complaint("--recipe gray.toml --key glitter --values 1", 2), HasSubstr("glitter"));
    EXPECT_THAT(complaint("--recipe gray.toml --key alpha --values 7", 2), HasSubstr("alpha"));
    EXPECT_THAT(complaint("--recipe missing.toml --key alpha --values 1", 2),
                HasSubstr("missing.toml"));
    EXPECT_THAT(complaint("--recipe gray.toml --key alpha", 1), HasSubstr("needs --values"));
    EXPECT_FALSE(exists("a.jpg"));
}

}  // namespace
}  // namespace nacre::cli
