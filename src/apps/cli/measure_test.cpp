#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "apps/cli/program_test_support.h"
#include "nacre/io/measurement_file.h"
#include "nacre/measure/measurement.h"

// `nacre measure` as a colour designer meets it.

namespace nacre::cli::testing {

namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

measure::Measurement measured(const Outcome& outcome) {
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return io::parse_measurement(outcome.out, "stdout");
}

TEST_F(Program, MeasureReadsAPaintAtTheAnglesOfAnInstrument) {
    const Outcome csv = nacre("measure gray.toml --geometry byk-mac");
    EXPECT_THAT(csv.out, StartsWith("geometry,theta_i,aspecular_deg,L,a,b,C,h,X,Y,Z,R400,R410,"));
    EXPECT_THAT(csv.err, HasSubstr("gray: flop index"));
    const measure::Measurement m = measured(csv);
    ASSERT_EQ(m.readings.size(), 6u);
    EXPECT_EQ(m.wavelengths_nm.size(), 31u);
    EXPECT_EQ(m.readings[1].geometry, measure::in_plane(45, 15));
    // Grey flakes in a clear binder: no colour, and Y is the reflectance in percent.
    const measure::Reading& near = m.readings[1];
    EXPECT_NEAR(near.lab[1], 0, 1e-9);
    EXPECT_NEAR(near.xyz[1], 100 * near.reflectance_factor[0], 1e-9);
    // Both say pi f.
    const Outcome eval = nacre("eval gray.toml --incident 45 --outgoing 30,180");
    EXPECT_NEAR(near.reflectance_factor[15], M_PI * number(eval.out, 16, 5),
                1e-8 * near.reflectance_factor[15]);
    EXPECT_THAT(nacre("measure gray.toml -q").err, IsEmpty());
}

TEST_F(Program, MeasureStatesItsConditions) {
    const measure::Measurement m = measured(
        nacre("measure gray.toml --geometry 45as15,45to30,90 --illuminant FL11 --observer 2 "
              "--aperture 1,2.5 --wavelength 380:780:5 --format json"));
    EXPECT_EQ(m.conditions.illuminant, spectra::Illuminant::FL11);
    EXPECT_EQ(m.conditions.observer, spectra::Observer::cie1931_2deg);
    EXPECT_EQ(m.conditions.aperture, (measure::Aperture{1, 2.5}));
    EXPECT_EQ(m.wavelengths_nm.size(), 81u);
    ASSERT_EQ(m.readings.size(), 2u);
    EXPECT_EQ(m.readings[1].geometry.name, "45to30,90");
}

TEST_F(Program, MeasureJsonTellsWhatWasMeasured) {
    const Outcome outcome = nacre("measure gray.toml --format json --report report.json");
    const auto json = nlohmann::json::parse(outcome.out);
    const measure::Measurement m = measured(outcome);
    EXPECT_EQ(json["flop_index"], *measure::flop_index(m));
    EXPECT_EQ(json["model"], "microflake");
    EXPECT_EQ(json["file"], "gray.toml");
    EXPECT_EQ(json["recipe_sha256"].get<std::string>().size(), 64u);
    const auto report = nlohmann::json::parse(contents(folder_ / "report.json"));
    EXPECT_EQ(report["command"], "measure");
    EXPECT_EQ(report["flop_index"], json["flop_index"]);
}

TEST_F(Program, MeasureTakesASetFromAFile) {
    write("set.toml", "[[geometry]]\nlamp_deg = 30\naspecular_deg = 15\nname = \"booth\"\n");
    const measure::Measurement m = measured(nacre("measure gray.toml --geometry set.toml"));
    ASSERT_EQ(m.readings.size(), 1u);
    EXPECT_EQ(m.readings[0].geometry.name, "booth");
    EXPECT_EQ(m.readings[0].geometry.theta_o_deg, 15);
}

TEST_F(Program, MeasuredFilesAreReadAgainUnderAnotherLight) {
    ASSERT_EQ(nacre("measure gray.toml -q -o day.csv").status, 0);
    ASSERT_EQ(nacre("measure gray.toml -q --illuminant A -o lamp.csv").status, 0);
    EXPECT_EQ(nacre("measure day.csv --illuminant A -q").out, contents(folder_ / "lamp.csv"));
    EXPECT_EQ(nacre("measure day.csv -q").out, contents(folder_ / "day.csv"));
    EXPECT_EQ(measured(nacre("measure day.csv --geometry 45as110,45as15")).readings.size(), 2u);
    EXPECT_THAT(nacre("measure day.csv --geometry 45as30").err, HasSubstr("no reading at 45as30"));
    EXPECT_THAT(nacre("measure day.csv --aperture 1,1").err, HasSubstr("half angles of 0 and 0"));
    write("lab.csv", "geometry,L,a,b\n45as15,90,1,2\n");
    EXPECT_EQ(nacre("measure lab.csv").status, 0);
    // An aperture that the file does not state may be given.
    EXPECT_EQ(measured(nacre("measure lab.csv --aperture 1,2")).conditions.aperture,
              (measure::Aperture{1, 2}));
    EXPECT_EQ(nacre("measure lab.csv --model mircoflake").status, 1);
    const Outcome refused = nacre("measure lab.csv --illuminant A");
    EXPECT_EQ(refused.status, 2);
    EXPECT_THAT(refused.err, HasSubstr("no spectrum"));
}

TEST_F(Program, MeasureVersusTellsTheDifferenceAtEachAngle) {
    ASSERT_EQ(nacre("measure gray.toml -q --geometry astm-e2194 -o standard.csv").status, 0);
    // A paint is read as the measured file was, and is no different from itself.
    const Outcome same = nacre("measure gray.toml --versus standard.csv");
    EXPECT_THAT(same.out, StartsWith("geometry,theta_i,aspecular_deg,L_standard,"));
    EXPECT_EQ(cell(same.out, 1, 0), "45as15");
    EXPECT_EQ(cell(same.out, 3, 0), "45as110");
    for (int row = 1; row <= 3; ++row) EXPECT_EQ(number(same.out, row, 14), 0);
    EXPECT_THAT(same.err, HasSubstr("mean 0.00, greatest 0.00"));

    // Flakes that reflect half as much are darker; weights choose the mean.
    std::string darker = contents(folder_ / "gray.toml");
    darker.replace(darker.find("0.6"), 3, "0.3");
    write("dark.toml", darker);
    const auto json = nlohmann::json::parse(
        nacre("measure dark.toml --versus gray.toml --geometry astm-e2194 --format json "
              "--weights 45as15=0,45as110=0 --report report.json")
            .out);
    ASSERT_EQ(json["angles"].size(), 3u);
    EXPECT_LT(json["angles"][0]["delta_lab"][0].get<double>(), -10);
    EXPECT_EQ(json["mean_delta_e_2000"], json["angles"][1]["delta_e_2000"]);
    EXPECT_EQ(json["standard"]["file"], "gray.toml");
    EXPECT_EQ(nlohmann::json::parse(contents(folder_ / "report.json"))["mean_delta_e_2000"],
              json["mean_delta_e_2000"]);
}

TEST_F(Program, MeasureTakesASolvedPaintAndAnyModelWithValues) {
    ASSERT_EQ(nacre("solve gray.toml -q -o gray.h5").status, 0);
    EXPECT_EQ(nacre("measure gray.h5 -q").out, nacre("measure gray.toml -q").out);
    const auto exact = measured(nacre("measure gray.toml")),
               sparkling = measured(nacre("measure gray.toml --model nacre --no-hot-spot")),
               hot_spot = measured(nacre("measure gray.toml --model nacre"));
    for (std::size_t i = 0; i < exact.readings.size(); ++i) {
        // The renderer's tables are in single precision.
        EXPECT_NEAR(sparkling.readings[i].lab[0], exact.readings[i].lab[0], 0.2) << i;
        if (i < 3) {
            EXPECT_GT(hot_spot.readings[i].lab[0], sparkling.readings[i].lab[0] + 1) << i;
        }
    }
}

TEST_F(Program, MeasureByTheReferenceAgreesWithinItsStandardErrors) {
    const std::string set = " --geometry 45as15,45as45,15as15 --wavelength 500:600:100";
    const auto exact = measured(nacre("measure gray.toml" + set));
    const std::string walk = "measure gray.toml --model walk --samples 20000" + set;
    const auto json = nlohmann::json::parse(nacre(walk + " --format json").out);
    const Outcome csv = nacre(walk);
    const auto walked = measured(csv);
    EXPECT_THAT(csv.out, HasSubstr(",sample,SE500,SE600\n"));
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 2; ++k) {
            const double error = json["readings"][i]["standard_error"][k];
            EXPECT_GT(error, 0);
            // A fraction of 6e-5 of normal errors exceeds four standard deviations.
            EXPECT_NEAR(walked.readings[i].reflectance_factor[k],
                        exact.readings[i].reflectance_factor[k], 4 * error);
        }
    }
    EXPECT_THAT(nacre("measure gray.toml --model walk --aperture 1,1").err, HasSubstr("points"));
    EXPECT_THAT(nacre("measure gray.toml --model walk --no-hot-spot").err, HasSubstr("belongs to"));
}

TEST_F(Program, MeasureSaysWhatIsWrong) {
    const auto expect = [&](const std::string& arguments, int status, const std::string& message) {
        const Outcome outcome = nacre("measure " + arguments);
        EXPECT_EQ(outcome.status, status) << arguments;
        EXPECT_THAT(outcome.err, HasSubstr(message)) << arguments;
        EXPECT_THAT(outcome.out, IsEmpty()) << arguments;
    };
    expect("gray.toml --geometry bykmac", 1, "did you mean 'byk-mac'");
    expect("gray.toml --geometry 45as150", 1, "below the horizon");
    expect("gray.toml --geometry 45as15,45as15", 1, "appears twice");
    expect("gray.toml --geometry none.toml", 2, "none.toml");
    expect("gray.toml --illuminant D66", 1, "did you mean 'D65'");
    expect("gray.toml --observer 4", 1, "--observer = 4");
    expect("gray.toml --aperture 3", 1, "half angles of lamp and detector");
    expect("gray.toml --aperture 3,11", 1, "[0, 10] deg");
    expect("gray.toml --wavelength 400,500,700", 1, "equal steps");
    expect("gray.toml --weights 45as15=1", 1, "--versus");
    expect("gray.toml --versus gray.toml --weights 45as15", 1, "NAME=W");
    expect("gray.toml --versus gray.toml --weights 45as30=1", 2, "45as30");
    expect("gray.toml --model volume", 1, "volume");
    expect("gray.toml --samples 100", 1, "--model walk");
    expect("none.toml", 2, "none.toml");
    write("broken.csv", "geometry,L,a,b\n45as15,90,1\n");
    expect("broken.csv", 2, "broken.csv:2:1");
    expect("gray.toml -o none/out.csv", 2, "none");
}

const std::string kKnown =
    "\n[uncertainty]\n\"layer[0].thickness_um\" = \"5 %\"\n"
    "\"layer[0].flakes[0].orientation.alpha\" = 0.002\n";

TEST_F(Program, MeasureSaysHowSureItIs) {
    write("known.toml", contents(folder_ / "gray.toml") + kKnown);
    const Outcome plain = nacre("measure gray.toml");
    const Outcome outcome = nacre("measure known.toml --contributions parts.csv");
    // The same readings, and more columns, which readers pass over.
    measure::Measurement expected = measured(plain), read = measured(outcome);
    read.name = expected.name;
    EXPECT_EQ(read, expected);
    EXPECT_THAT(outcome.out, HasSubstr(",L_sd,a_sd,b_sd,C_sd,h_sd,cov_La,cov_Lb,cov_ab,"));
    EXPECT_THAT(outcome.out, HasSubstr(",first order,"));
    EXPECT_THAT(outcome.err, HasSubstr("flop index"));
    EXPECT_THAT(outcome.err, HasSubstr(" +- "));
    EXPECT_THAT(outcome.err, HasSubstr("of the variance from layer[0].flakes[0]"));
    const std::string parts = contents(folder_ / "parts.csv");
    EXPECT_THAT(parts, StartsWith("geometry,quantity,number,value,sd,change,share\n"));
    EXPECT_THAT(parts, HasSubstr("45as15,L,layer[0].thickness_um,15,0.75,"));
    EXPECT_THAT(parts, HasSubstr("\n,flop_index,layer[0].flakes[0].orientation.alpha,0.2,0.002,"));
    EXPECT_EQ(nacre("measure known.toml --no-uncertainty -q").out,
              nacre("measure known.toml --no-uncertainty -q --seed 3").out);
    EXPECT_THAT(nacre("measure known.toml --no-uncertainty").out, Not(HasSubstr("L_sd")));

    // The command line says the same of another recipe.
    const auto json = [&](const std::string& arguments) {
        const Outcome said = nacre("measure " + arguments + " --format json");
        EXPECT_EQ(said.status, 0) << said.err;
        return nlohmann::json::parse(said.out)["uncertainty"];
    };
    const auto of_file = json("known.toml");
    EXPECT_EQ(json("gray.toml --uncertainty layer[0].thickness_um=5% --uncertainty alpha=0.002"),
              of_file);
    EXPECT_EQ(of_file["numbers"].size(), 2u);
    EXPECT_GT(of_file["flop_index"]["sd"], 0);
    const auto drawn = json("known.toml --uncertainty-samples 20 --seed 1");
    EXPECT_EQ(drawn["samples"], 20);
    EXPECT_EQ(drawn["readings"][0]["first_order"], of_file["readings"][0]["first_order"]);
    EXPECT_NE(drawn, json("known.toml --uncertainty-samples 20 --seed 2"));
}

TEST_F(Program, MeasureCarriesCorrelations) {
    const std::string pair = "layer[0].thickness_um,alpha";
    write("known.toml", contents(folder_ / "gray.toml") + kKnown);
    write("together.toml", contents(folder_ / "known.toml") +
                               "\n[[uncertainty.correlation]]\nof = [\"layer[0].thickness_um\", "
                               "\"layer[0].flakes[0].orientation.alpha\"]\ncoefficient = 0.8\n");
    const auto json = [&](const std::string& arguments) {
        const Outcome said = nacre("measure " + arguments + " --format json");
        EXPECT_EQ(said.status, 0) << said.err;
        return nlohmann::json::parse(said.out)["uncertainty"];
    };
    const auto of_file = json("together.toml"), independent = json("known.toml");
    EXPECT_EQ(of_file["correlation"], (nlohmann::json{{1, 0.8}, {0.8, 1}}));
    EXPECT_EQ(independent["correlation"], (nlohmann::json{{1, 0}, {0, 1}}));
    EXPECT_EQ(json("known.toml --correlation " + pair + "=0.8"), of_file);
    EXPECT_EQ(json("known.toml --correlation *=0.8"), of_file);  // of all that are uncertain
    EXPECT_EQ(json("together.toml --correlation " + pair + "=0"), independent);
    EXPECT_NE(of_file["readings"][0]["first_order"], independent["readings"][0]["first_order"]);
    EXPECT_EQ(of_file["readings"][0]["change"], independent["readings"][0]["change"]);
    const double first = of_file["flop_index"]["share"][0],
                 second = of_file["flop_index"]["share"][1];
    EXPECT_NEAR(first + second, 1, 1e-12);
}

TEST_F(Program, MeasureRefusesUncertaintyThatItCannotTell) {
    const auto refused = [&](const std::string& arguments, int status, const char* words) {
        const Outcome outcome = nacre("measure " + arguments);
        EXPECT_EQ(outcome.status, status) << arguments;
        EXPECT_THAT(outcome.err, HasSubstr(words));
        EXPECT_THAT(outcome.out, IsEmpty());
    };
    refused("gray.toml --uncertainty alpha", 1, "is not KEY=SD");
    refused("gray.toml --uncertainty alpha=wide", 1, "alpha = wide");
    refused("gray.toml --uncertainty alhpa=5%", 2, "is not a number of this recipe");
    refused("gray.toml --uncertainty alpha=500%", 2, "[0 %, 100 %]");
    refused("gray.toml --uncertainty alpha=5% --no-uncertainty", 1, "exclude");
    refused("gray.toml --uncertainty alpha=5% --model walk", 2, "no exact values");
    const std::string two =
        "gray.toml --uncertainty alpha=5% --uncertainty layer[0].thickness_um=5% ";
    refused(two + "--correlation alpha", 1, "is not A,B=COEFFICIENT");
    refused(two + "--correlation alpha,layer[0].thickness_um=2", 2,
            "coefficient = 2: must be a number in [-1, 1]");
    refused(two + "--correlation alpha,substrate.reflectance=0.5", 2,
            "gray.toml: --correlation = alpha,substrate.reflectance=0.5: of[1] = "
            "substrate.reflectance: has no standard deviation");
    refused(two + "--correlation alhpa,layer[0].thickness_um=0.5", 2,
            "is not a number of this recipe");
    refused(two + "--correlation alpha,alpha=0.5", 2, "is named twice");
    refused(two + "--correlation alpha,layer[0].thickness_um=0.5 --no-uncertainty", 1, "exclude");
    refused("gray.toml --uncertainty alpha=5% --versus gray.toml", 1, "--versus");
    refused("gray.toml --contributions parts.csv", 1, "--contributions");
    refused("gray.toml --uncertainty-samples 20", 2, "[uncertainty]");
    refused("gray.toml --uncertainty alpha=5% --contributions gray.toml", 1, "gray.toml");
    ASSERT_EQ(nacre("measure gray.toml -q -o read.csv").status, 0);
    refused("read.csv --uncertainty alpha=5%", 1, "no recipe");
}

TEST_F(Program, MeasureJudgesByATolerance) {
    write("light.toml",
          "ior = 1.5\n[[layer]]\nthickness_um = 15\n[[layer.flakes]]\narea_density_per_um = 0.1\n"
          "orientation = { distribution = \"beckmann\", alpha = 0.2 }\nreflectance = 0.62\n");
    const std::string compare =
        "measure light.toml --versus gray.toml --geometry 45as15,45as45,45as110 ";
    const Outcome plain = nacre(compare);
    const double nearest = number(plain.out, 1, 14), farthest = number(plain.out, 3, 14);
    ASSERT_GT(nearest, 0.1);
    ASSERT_GT(farthest, 0.1);

    const Outcome passes = nacre(compare + "--tolerance 20");
    EXPECT_EQ(passes.status, 0) << passes.err;
    EXPECT_EQ(cell(passes.out, 0, 17), "verdict");
    EXPECT_EQ(cell(passes.out, 2, 16), "20");
    EXPECT_EQ(cell(passes.out, 2, 17), "pass");

    const Outcome fails = nacre(compare + "--tolerance 20,45as15=0.01 --report judged.json");
    EXPECT_EQ(fails.status, 4);
    EXPECT_EQ(cell(fails.out, 1, 17), "fail");
    EXPECT_EQ(cell(fails.out, 2, 17), "pass");
    EXPECT_THAT(fails.err, HasSubstr("does not pass: beyond the tolerance (cie2000) at 1 of 3"));
    const auto report = nlohmann::json::parse(contents(folder_ / "judged.json"));
    EXPECT_EQ(report["passes"], false);
    EXPECT_EQ(report["angles"][0]["passes"], false);

    // Only the standard's lightness enters for greys: dL / (2 S_L).
    const Outcome cmc = nacre(compare + "--formula cmc");
    EXPECT_EQ(cell(cmc.out, 0, 16), "dE_cmc2:1");
    const double l = number(cmc.out, 1, 3), dl = number(cmc.out, 1, 9);
    EXPECT_NEAR(number(cmc.out, 1, 16), dl / (2 * 0.040975 * l / (1 + 0.01765 * l)), 1e-9);

    EXPECT_EQ(nacre("measure gray.toml --tolerance 1").status, 1);
    EXPECT_THAT(nacre(compare + "--tolerance -1").err, HasSubstr("must be a number in [0, 1000]"));
    EXPECT_THAT(nacre(compare + "--tolerance 1,2").err, HasSubstr("appears twice"));
    EXPECT_THAT(nacre(compare + "--formula cie94").err, HasSubstr("--formula = cie94: must be"));
    EXPECT_THAT(nacre(compare + "--tolerance 45as99=1").err, HasSubstr("45as99"));
}

TEST_F(Program, MeasurePrintsATableForPeople) {
    const Outcome text = nacre("measure gray.toml --geometry 45as-15,45as110 --format text");
    EXPECT_EQ(text.status, 0) << text.err;
    EXPECT_THAT(text.out,
                ::testing::MatchesRegex("angle +L\\* +a\\* +b\\* +C\\* +h\n"
                                        "45as-15 +[0-9.]+ +0\\.00 +0\\.00 +0\\.00 +[0-9.]+\n"
                                        "45as110 +[0-9.]+ +0\\.00 +0\\.00 +0\\.00 +[0-9.]+\n"));
    const Outcome difference =
        nacre("measure gray.toml --versus gray.toml --geometry 45as15 --format text --tolerance 1");
    EXPECT_THAT(difference.out, HasSubstr("dE2000  tolerance  verdict"));
    EXPECT_THAT(difference.out, HasSubstr("0.00          1     pass"));
}

TEST_F(Program, UncertaintiesAreNamedOnce) {
    const Outcome twice = nacre("measure gray.toml --uncertainty alpha=1% --uncertainty alpha=2%");
    EXPECT_EQ(twice.status, 1) << twice.err;
    EXPECT_THAT(twice.err, HasSubstr("--uncertainty = alpha=2%: alpha appears twice"));
    const Outcome none = nacre("measure gray.toml --uncertainty-samples 10");
    EXPECT_EQ(none.status, 2);
    EXPECT_THAT(none.err, AllOf(HasSubstr("--uncertainty: "),
                                Not(HasSubstr("--uncertainty: --uncertainty"))));
}

}  // namespace

}  // namespace nacre::cli::testing
