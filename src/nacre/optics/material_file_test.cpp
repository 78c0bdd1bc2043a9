#include "nacre/optics/material_file.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "nacre/core/error.h"
#include "nacre/optics/dispersion_formula.h"
#include "nacre/testing/errors.h"

namespace nacre::optics {
namespace {

using nacre::test::message_of;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

template <class Parse>
std::string error_of(const Parse& parse, const std::string& text) {
    return message_of<InputError>([&] { parse(text, "file"); });
}
std::string csv_error(const std::string& text) { return error_of(parse_material_csv, text); }
std::string yaml_error(const std::string& text) { return error_of(parse_material_yaml, text); }

TEST(MaterialCsv, ReadsCommentsColumnsAndConstants) {
    const auto m = parse_material_csv(
        "\xEF\xBB\xBF# source: somebody 1999\r\n\r\nwavelength_nm , n,k\r\n400,1.5,0\r\n"
        "500, 1.6 ,2e-1\r\n",
        "m");
    EXPECT_EQ(m.source(), "somebody 1999");
    EXPECT_EQ(m.index(500), ComplexIndex(1.6, .2));
    EXPECT_EQ(parse_material_csv("wavelength_nm,n\n400,1.5\n500,1.6", "m").index(500),
              ComplexIndex(1.6, 0));
    EXPECT_FALSE(parse_material_csv("wavelength_nm,n\n400,1.5\n", "m").is_dispersive());
}

TEST(MaterialCsv, TakesDecimalCommasBetweenSemicolons) {
    const std::string head = "# source: a, b; c\nwavelength_nm;n;k\n400;1,5;0\n";
    EXPECT_EQ(parse_material_csv(head + "500,5;1,6;2e-1\n", "m").index(500.5),
              ComplexIndex(1.6, .2));
    EXPECT_THAT(csv_error(head + "500;1.6;0\n"),
                HasSubstr("file:3:5: 1,5 has a decimal comma, but 1.6 in line 4 has a point"));
    EXPECT_THAT(csv_error("wavelength_nm,n,k\n400,\"1,5\",0\n"),
                HasSubstr("file:2: n is not a finite number; decimal commas need semicolons"));
    EXPECT_THAT(
        csv_error("wavelength_nm,n\n400,1,5\n"),
        HasSubstr("file:2: has 3 fields; the header has 2; decimal commas need semicolons"));
}

TEST(MaterialCsv, ErrorsNameFileLineAndValue) {
    const std::string head = "wavelength_nm,n,k\n400,1.5,0\n";
    EXPECT_THAT(csv_error("lambda,n,k\n"), HasSubstr("file:1: the header must be"));
    EXPECT_THAT(csv_error(head + "500,abc,0\n"), HasSubstr("file:3: n is not a finite number"));
    EXPECT_THAT(csv_error(head + "500,nan,0\n"), HasSubstr("is not a finite number"));
    EXPECT_THAT(csv_error(head + "500,1.5\n"), HasSubstr("file:3: has 2 fields"));
    EXPECT_THAT(csv_error(head + "400,1.5,0\n"), HasSubstr("wavelength_nm = 400 is not above 400"));
    EXPECT_THAT(csv_error(head + "500,0,0\n"), HasSubstr("n = 0 is outside (0, 1000]"));
    EXPECT_THAT(csv_error(head + "500,1.5,-1\n"), HasSubstr("k = -1 is outside [0, 1000]"));
    EXPECT_THAT(csv_error("wavelength_nm,n,k\n"), HasSubstr("no row of data"));
    EXPECT_THAT(csv_error(""), HasSubstr("no row of data"));
}

TEST(MaterialYaml, ReadsTables) {
    const auto m = parse_material_yaml(
        "# comment\nREFERENCES: \"Somebody\"\nDATA:\n  - type: tabulated nk\n    data: |\n"
        "        0.4 1.5 0.1\n        0.5 1.6 0.2\n",
        "m");
    EXPECT_EQ(m.source(), "Somebody");
    EXPECT_EQ(m.index(500), ComplexIndex(1.6, .2));
    EXPECT_EQ(m.first_wavelength_nm(), 400);
    EXPECT_FALSE(parse_material_yaml("DATA: [{type: tabulated nk, data: \"0.5 1.6 0.2\"}]", "m")
                     .is_dispersive());
}

TEST(MaterialYaml, CombinesNAndKWhereBothAreKnown) {
    const auto m = parse_material_yaml(
        "DATA:\n  - type: formula 5\n    wavelength_range: 0.4 0.8\n    coefficients: 1.5 0.01 -2\n"
        "  - type: tabulated k\n    data: |\n        0.3 0\n        0.5 0.2\n        0.7 0.4\n",
        "m");
    EXPECT_EQ(m.first_wavelength_nm(), 400);
    EXPECT_EQ(m.last_wavelength_nm(), 700);
    EXPECT_NEAR(m.index(600).real(), 1.5 + .01 / .36, kFormulaSamplingError);
    EXPECT_NEAR(m.index(600).imag(), .3, 1e-12);
    EXPECT_NEAR(m.index(400).imag(), .1, 1e-12);
}

TEST(MaterialYaml, FormulasAreSampledFinely) {
    // Fused silica from the ultraviolet to the infrared, where it bends most.
    const std::vector<double> c{0, .6961663, .0684043, .4079426, .1162414, .8974794, 9.896161};
    const auto m = parse_material_yaml(
        "DATA:\n  - type: formula 1\n    wavelength_range: 0.21 6.7\n    coefficients: 0 0.6961663 "
        "0.0684043 0.4079426 0.1162414 0.8974794 9.896161\n",
        "m");
    for (double nm = 210; nm <= 6700; nm += .37) {
        ASSERT_NEAR(m.index(nm).real(), dispersion_formula(1, c, nm * 1e-3), kFormulaSamplingError)
            << nm;
    }
    EXPECT_LT(m.samples().size(), 20000u);
}

TEST(MaterialYaml, ReadsEveryFormula) {
    for (int number = 1; number <= kDispersionFormulas; ++number) {
        const double c1 = number == 8 ? .25 : 2.25;
        const std::string page = fmt::format(
            "DATA:\n  - type: formula {}\n    wavelength_range: 0.4 0.7\n"
            "    coefficients: {} 0.001 1\n",
            number, c1);
        const auto m = parse_material_yaml(page, "m");
        EXPECT_NEAR(m.index(550).real(),
                    dispersion_formula(number, std::vector{c1, .001, 1.0}, .55),
                    kFormulaSamplingError)
            << number;
    }
}

TEST(MaterialYaml, ErrorsNameFileLineAndValue) {
    const std::string table = "DATA:\n  - type: tabulated nk\n    data: |\n        0.4 1.5 0\n";
    EXPECT_THAT(yaml_error(table + "        0.5 x 0\n"),
                HasSubstr("file:5: data: holds what is not a finite number"));
    EXPECT_THAT(yaml_error(table + "        0.5 1.5\n"), HasSubstr("file:5: 2 numbers"));
    EXPECT_THAT(yaml_error(table + "        0.5 1.5 -1\n"), HasSubstr("k = -1 is outside"));
    EXPECT_THAT(yaml_error(table + "        0.5 .nan 0\n"), HasSubstr("not a finite number"));
    EXPECT_THAT(yaml_error(table + "        0.4 1.5 0\n"), HasSubstr("is not above"));
    EXPECT_THAT(yaml_error(table + "  - type: tabulated n\n    data: \"0.5 1.5\"\n"),
                HasSubstr("n is given twice"));
    EXPECT_THAT(yaml_error("DATA:\n  - type: formula 10\n"), HasSubstr("file:2: type must be"));
    EXPECT_THAT(yaml_error("DATA:\n  - type: tabulated k\n    data: \"0.5 0.1\"\n"),
                HasSubstr("no entry of DATA gives n"));
    EXPECT_THAT(yaml_error("DATA:\n  - type: formula 1\n    wavelength_range: 0.8 0.4\n"
                           "    coefficients: 0\n"),
                AllOf(HasSubstr("file:3:"), HasSubstr("must increase")));
    EXPECT_THAT(yaml_error("DATA:\n  - type: formula 1\n    wavelength_range: 0.4 0.8\n"
                           "    coefficients: 0 1 0.6\n"),
                HasSubstr("formula 1 gives n ="));
    EXPECT_THAT(yaml_error("DATA:\n  - type: formula 5\n    wavelength_range: 0.4 0.8\n"),
                HasSubstr("\"coefficients\""));
    EXPECT_THAT(yaml_error("DATA:\n  - type: formula 5\n    wavelength_range: 0.4 0.5\n"
                           "    coefficients: 1.5\n  - type: tabulated k\n    data: |\n"
                           "        0.6 0\n        0.7 0\n"),
                HasSubstr("do not overlap"));
}

TEST(MaterialYaml, HostilePagesGetCleanErrors) {
    EXPECT_THAT(yaml_error(""), HasSubstr("not a page of refractiveindex.info"));
    EXPECT_THAT(yaml_error("just text"), HasSubstr("no list under the key DATA"));
    EXPECT_THAT(yaml_error("DATA: {a: b}"), HasSubstr("no list under the key DATA"));
    EXPECT_THAT(yaml_error("DATA: [1, [2]]"), HasSubstr("is not a mapping"));
    EXPECT_THAT(yaml_error("DATA: &a [*a]"), HasSubstr("anchors and aliases"));
    EXPECT_THAT(yaml_error("a: &a [x,x]\nDATA: [*a, *a]"), HasSubstr("anchors and aliases"));
    EXPECT_THAT(yaml_error("DATA: [\"unclosed"), HasSubstr("not valid YAML"));
    for (const char* opening : {"[", "{a: ", "- ", "? "}) {
        std::string deep;
        for (int i = 0; i < 100000; ++i) deep += opening;
        EXPECT_THAT(yaml_error(deep), HasSubstr("file:1:")) << opening;
    }
    EXPECT_THAT(yaml_error(std::string(kMaxMaterialFileBytes + 1, ' ')), HasSubstr("larger than"));
    EXPECT_NE(yaml_error(std::string("DATA:\0\xff\xfe: [", 10)), "accepted");
    // A formula that wiggles faster than it can be sampled.
    EXPECT_THAT(yaml_error("DATA:\n  - type: formula 1\n    wavelength_range: 1e-9 1e6\n"
                           "    coefficients: 0 1e-30 1e300 1 1e5\n"),
                HasSubstr("file:4:"));
}

// A recipe may name any file as a material; the message must not show what is in it.
TEST(MaterialFile, MessagesQuoteNothingOfAFileThatIsNoMaterial) {
    const std::string secret = "hunter2";
    for (const std::string& text :
         {"root:" + secret + ":0:0\n", "wavelength_nm,n\n400," + secret + "\n",
          "wavelength_nm,n\n" + secret + ",1,2\n", "wavelength_nm,n,k\n400,1.5," + secret + "\n"}) {
        EXPECT_THAT(csv_error(text), AllOf(HasSubstr("file:"), Not(HasSubstr(secret))));
    }
    for (const std::string& text :
         {secret, "password: " + secret, "DATA:\n  - type: " + secret + "\n",
          "DATA:\n  - type: tabulated n\n    data: |\n        0.4 " + secret + "\n",
          "DATA:\n  - type: tabulated n\n    data: |\n        0.4 1.5 " + secret + "\n",
          "DATA: [" + secret + ": {" + secret, "DATA: !<" + secret,
          "%" + secret + " x\n--- a: b: " + secret}) {
        EXPECT_THAT(yaml_error(text), AllOf(HasSubstr("file"), Not(HasSubstr(secret)))) << text;
    }
}

}  // namespace
}  // namespace nacre::optics
