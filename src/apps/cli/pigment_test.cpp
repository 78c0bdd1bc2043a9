#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

#include "apps/cli/program_test_support.h"
#include "nacre/core/csv.h"

// From a drawdown to a pigment, by the program.

namespace nacre::cli::testing {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

/// A recipe of one pigment over a ground, read at 45:0 as a row of a drawdown.
std::string drawn_paint(const std::string& pigment, double ground) {
    return "ior = 1.5\n[[layer]]\nthickness_um = 20\n" + pigment +
           "\n[substrate]\nreflectance = " + std::to_string(ground) + "\n";
}

TEST_F(Program, PigmentFindsWhatADrawdownWasMadeFrom) {
    std::string csv = "ground,thickness_um,volume_fraction,450,550,650\n";
    const auto add = [&](const std::string& row, const std::string& recipe) {
        write("drawn.toml", recipe);
        const Outcome read =
            nacre("measure drawn.toml -q --geometry 45as45 --wavelength 450:650:100 --format csv");
        const auto rows = parse_csv(read.out, "out");
        csv += row;
        for (const char* name : {"R450", "R550", "R650"}) {
            for (std::size_t i = 0; i < rows[0].size(); ++i) {
                if (rows[0][i].text == name) csv += "," + rows[1][i].text;
            }
        }
        csv += "\n";
    };
    const std::string pigment =
        "[[layer.pigment]]\nvolume_fraction = 0.02\nscattering_per_mm = 800\n"
        "absorption_per_mm = { wavelengths_nm = [450, 550, 650], values = [200, 900, 4000] }\n";
    add("black,0,", drawn_paint("", 0.02));
    add("black,20,0.02", drawn_paint(pigment, 0.02));
    add("white,0,", drawn_paint("", 0.85));
    add("white,20,0.02", drawn_paint(pigment, 0.85));
    write("drawdown.csv", csv);

    const Outcome found = nacre(
        "pigment drawdown.csv --geometry 45-0 --name blue -o blue.toml --table table.csv "
        "--plots plots --noise 0.001");
    EXPECT_EQ(found.status, 0) << found.err;
    EXPECT_THAT(
        contents(folder_ / "blue.toml"),
        AllOf(HasSubstr("name = \"blue\""), HasSubstr("source = \"nacre pigment of drawdown.csv")));
    const auto rows = parse_csv(contents(folder_ / "table.csv"), "table.csv");
    ASSERT_EQ(rows.size(), 4u);
    const double absorption[] = {200, 900, 4000};
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(std::stod(rows[i + 1][1].text), 800, 5);
        EXPECT_NEAR(std::stod(rows[i + 1][3].text), absorption[i], 0.005 * absorption[i]);
        EXPECT_GT(std::stod(rows[i + 1][2].text), 0);  // its error
        EXPECT_NEAR(std::stod(rows[i + 1][5].text), 2 * absorption[i], 0.01 * absorption[i]);  // K
    }
    EXPECT_TRUE(exists("plots/coefficients.svg") && exists("plots/reflectance.png"));
    ASSERT_EQ(
        nacre("pigment drawdown.csv --geometry 45-0 -q --table comma.csv --decimal comma --bom")
            .status,
        0);
    const std::string commas = contents(folder_ / "comma.csv");
    EXPECT_THAT(commas, StartsWith("\xEF\xBB\xBFwavelength_nm;scattering_per_mm;"));
    EXPECT_THAT(commas, HasSubstr("\n450;"));
    const Outcome without = nacre("pigment drawdown.csv --geometry 45-0 --decimal comma");
    EXPECT_EQ(without.status, 1);
    EXPECT_THAT(without.err, HasSubstr("--decimal comma belongs to CSV"));

    // The pigment, named by a recipe, reads like the drawdown.
    write("again.toml",
          drawn_paint("[[layer.pigment]]\nfrom = \"blue.toml\"\nvolume_fraction = 0.02\n", 0.85));
    write("first.toml", drawn_paint(pigment, 0.85));
    const Outcome difference =
        nacre("measure again.toml --versus first.toml --geometry 45as45 --wavelength 450:650:100");
    EXPECT_THAT(difference.err, HasSubstr("mean 0.00, greatest 0.0")) << difference.err;
}

TEST_F(Program, PigmentTakesTintsInAKnownWhite) {
    write("white.toml",
          "name = \"w\"\nkubelka_munk = { K = 4, S = 7500 }\nsource = \"invented\"\n");
    const auto ladder = [&](const std::vector<std::pair<double, double>>& tints) {
        std::string csv = "ground,thickness_um,volume_fraction,white_volume_fraction,550\n";
        for (const auto& [pigment, white] : tints) {
            std::string recipe = "ior = 1.5\n[[layer]]\nthickness_um = 100000\n";
            recipe +=
                "[[layer.pigment]]\nscattering_per_mm = 400\nabsorption_per_mm = 1500\n"
                "volume_fraction = " +
                std::to_string(pigment) + "\n";
            if (white > 0) {
                recipe += "[[layer.pigment]]\nfrom = \"white.toml\"\nvolume_fraction = " +
                          std::to_string(white) + "\n";
            }
            write("tint.toml", recipe);
            const Outcome read = nacre(
                "measure tint.toml -q --geometry 45as45 --wavelength 450:650:100 --format csv");
            const auto rows = parse_csv(read.out, "out");
            csv += ",opaque," + std::to_string(pigment) + "," + std::to_string(white);
            for (std::size_t i = 0; i < rows[0].size(); ++i) {
                if (rows[0][i].text == "R550") csv += "," + rows[1][i].text + "\n";
            }
        }
        return csv;
    };
    const std::string arguments =
        " --white white.toml --geometry 45-0 --noise 0.001 -o found.toml --table t.csv";
    const auto found = [&](int column) {
        return std::stod(parse_csv(contents(folder_ / "t.csv"), "t.csv")[1][column].text);
    };
    write("both.csv", ladder({{0.002, 0.1}, {0.02, 0.1}, {0.1, 0}}));
    const Outcome both = nacre("pigment both.csv --plots plots" + arguments);
    EXPECT_EQ(both.status, 0) << both.err;
    EXPECT_NEAR(found(1), 400, 2);
    EXPECT_NEAR(found(3), 1500, 3);
    EXPECT_THAT(both.err, Not(HasSubstr("only absorption")));
    EXPECT_THAT(contents(folder_ / "found.toml"), HasSubstr("white white.toml"));
    EXPECT_THAT(contents(folder_ / "t.csv"), HasSubstr("residual opaque 0.002 in 10 % white"));
    EXPECT_TRUE(exists("plots/coefficients.svg"));

    write("one.csv", ladder({{0.002, 0.1}}));
    const Outcome one = nacre("pigment one.csv" + arguments);
    EXPECT_EQ(one.status, 0) << one.err;
    EXPECT_THAT(one.err, HasSubstr("only absorption can be told; scattering is taken as 0"));
    EXPECT_NEAR(found(3), 1500, 5);

    write("weak.csv", ladder({{0.0005, 0.1}, {0.001, 0.1}}));
    EXPECT_THAT(nacre("pigment weak.csv" + arguments).err, HasSubstr("only absorption shows"));
    const Outcome no_white = nacre("pigment one.csv -o x.toml");
    EXPECT_EQ(no_white.status, 2);
    EXPECT_THAT(no_white.err, HasSubstr("nothing says which white"));
    const Outcome unknown = nacre("pigment one.csv --white rutil-white -o x.toml");
    EXPECT_EQ(unknown.status, 2);
    EXPECT_THAT(unknown.err, HasSubstr("did you mean 'rutile-white'?"));
}

TEST_F(Program, PigmentSaysWhatIsWrongWithADrawdown) {
    write("one.csv", "ground,thickness_um,volume_fraction,550\nblack,0,,0.05\nblack,20,0.1,0.2\n");
    const Outcome one = nacre("pigment one.csv -o x.toml");
    EXPECT_EQ(one.status, 2);
    EXPECT_THAT(one.err, HasSubstr("one.csv: drawdown: needs the paint over two grounds"));
    EXPECT_FALSE(exists("x.toml"));
    EXPECT_EQ(nacre("pigment one.csv --geometry 60-0").status, 1);
    EXPECT_EQ(nacre("pigment one.csv -o one.csv").status, 1);
    EXPECT_EQ(nacre("pigment missing.csv").status, 2);
}

TEST_F(Program, PigmentsListsWhatShips) {
    const Outcome list = nacre("pigments");
    EXPECT_EQ(list.status, 0);
    EXPECT_THAT(list.out,
                StartsWith("name,title,kind,from_nm,to_nm,over_black,over_white,source\n"));
    EXPECT_THAT(list.out, AllOf(HasSubstr("\nrutile-white,rutile white,particles,400,780,#"),
                                HasSubstr("\nzinc-white,zinc white,particles,450,780,#"),
                                HasSubstr("synthetic: no pigment was measured")));
}

}  // namespace
}  // namespace nacre::cli::testing
