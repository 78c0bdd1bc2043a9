#include "nacre/optics/material.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/files.h"

namespace nacre::optics {
namespace {

using nacre::test::message_of;
using ::testing::HasSubstr;

std::string error_of(const std::string& text) {
    return message_of<InputError>([&] { find_material(text); });
}

TEST(Material, NumbersAreMaterials) {
    EXPECT_EQ(find_material("1.5").index(550), ComplexIndex(1.5, 0));
    EXPECT_EQ(find_material("3.18+3.33i").index(550), ComplexIndex(3.18, 3.33));
    EXPECT_EQ(find_material(" 1e0+2.5e-1i ").index(1), ComplexIndex(1, .25));
    EXPECT_EQ(find_material("2+0i"), Material(2.0));
    EXPECT_EQ(find_material("1.5").name(), "1.5");
    EXPECT_FALSE(find_material("1.5").is_dispersive());
    EXPECT_EQ(Material(1.5).last_wavelength_nm(), std::numeric_limits<double>::infinity());
}

TEST(Material, GainAndAbsurdNumbersAreRefused) {
    EXPECT_THAT(error_of("2-0.1i"), HasSubstr("k = -0.1 is outside [0, 1000]"));
    EXPECT_THAT(error_of("0"), HasSubstr("n = 0 is outside (0, 1000]"));
    EXPECT_THAT(error_of("-1.5"), HasSubstr("n = -1.5"));
    EXPECT_THAT(error_of("1e9"), HasSubstr("n = 1"));
    for (const char* text : {"nan", "inf", "1.5+", "1.5+i", "1.5i", "1.5+2", "1.5 + 2i", "1e999",
                             "", "0x1p3", "1.5+2ii", "+-1"}) {
        EXPECT_THAT(error_of(text), HasSubstr("is not an index")) << text;
    }
}

TEST(Material, ShippedDataAreThoseOfTheDatabase) {
    // In print: Malitson's fused silica, 1.4599 at 550 nm; Johnson and Christy's table at 2.26 eV,
    // 548.6 nm: gold 0.43 + 2.455 i, silver 0.06 + 3.586 i.
    const double wavelength_nm = 548.6;
    EXPECT_NEAR(find_material("SiO2").index(550).real(), 1.4599, 1e-4);
    EXPECT_LT(std::abs(find_material("Au").index(wavelength_nm) - ComplexIndex(.43, 2.455)), 5e-3);
    EXPECT_LT(std::abs(find_material("Ag").index(wavelength_nm) - ComplexIndex(.06, 3.586)), 5e-3);
    EXPECT_EQ(find_material("mica").index(550), ComplexIndex(1.58));
    EXPECT_EQ(find_material("synthetic_mica").index(400), ComplexIndex(1.55));
    for (const char* name : {"SnO2", "BiOCl", "polyurethane"}) {
        EXPECT_FALSE(find_material(name).is_dispersive());
        EXPECT_THAT(find_material(name).source(), HasSubstr("not in the database"));
    }
}

// Graphite seen along its axis is measured independently of the set that ships: 31.40 % in air and 17.85 % in
// oil at 546 nm [graphite-peels-2026]. Samples of that work differ by up to 4 %.
TEST(Material, GraphiteReflectsAsItsPeelsDo) {
    const ComplexIndex graphite = find_material("C_graphite_o").index(546);
    const auto reflectance = [&](double ambient) {
        return std::norm((ambient - graphite) / (ambient + graphite));
    };
    EXPECT_NEAR(reflectance(1.0), 0.3140, 0.04 * 0.3140);
    EXPECT_NEAR(reflectance(1.515 /* immersion oil */), 0.1785, 0.04 * 0.1785);
}

// Thin platelets of micaceous iron oxide are red and translucent under the microscope
// [micaceous-haematite-2026], thick ones black.
TEST(Material, HaematiteLetsRedThroughThinPlateletsOnly) {
    const Material haematite = find_material("Fe2O3");
    const auto passes = [&](double wavelength_nm, double thickness_um) {
        return std::exp(-4 * std::numbers::pi * haematite.index(wavelength_nm).imag() * 1000 *
                        thickness_um / wavelength_nm);
    };
    EXPECT_GT(passes(650, 1), 0.2);
    EXPECT_LT(passes(550, 1), 1e-3);
    EXPECT_LT(passes(650, 20), 1e-3);
}

TEST(Material, EveryShippedMaterialCoversTheVisible) {
    const auto names = material_names();
    EXPECT_EQ(names.size(), 29u);
    EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
    for (const auto& name : names) {
        const auto material = find_material(name);
        EXPECT_EQ(material.name(), name);
        EXPECT_FALSE(material.source().empty()) << name;
        // Bond's zinc oxide begins at 450 nm, Dalzell's soot at 440 nm, Devore's rutile at 430 nm.
        EXPECT_LE(material.first_wavelength_nm(), 450) << name;
        EXPECT_GE(material.last_wavelength_nm(), 780) << name;
    }
}

TEST(Material, IsLinearBetweenSamplesAndRefusesToExtrapolate) {
    const Material m("m", {400, 500, 700}, {{1, 0}, {2, .4}, {3, .2}});
    EXPECT_EQ(m.index(400), ComplexIndex(1, 0));
    EXPECT_EQ(m.index(700), ComplexIndex(3, .2));
    EXPECT_NEAR(std::abs(m.index(450) - ComplexIndex(1.5, .2)), 0, 1e-15);
    EXPECT_NEAR(std::abs(m.index(600) - ComplexIndex(2.5, .3)), 0, 1e-15);
    for (double wavelength : {399.999, 700.001, std::nan(""), -1.0}) {
        EXPECT_THROW(m.index(wavelength), DomainError);
    }
    EXPECT_THROW(Material(1.5).index(0), DomainError);
}

TEST(Material, RefusesBadSamples) {
    const std::vector<ComplexIndex> two{{1, 0}, {2, 0}};
    EXPECT_THROW(Material("m", {400}, two), DomainError);
    EXPECT_THROW(Material("m", std::vector<double>{400}, std::vector<ComplexIndex>{1}),
                 DomainError);
    EXPECT_THROW(Material("m", {500, 400}, two), DomainError);
    EXPECT_THROW(Material("m", {400, 400}, two), DomainError);
    EXPECT_THROW(Material("m", {0, 400}, two), DomainError);
    EXPECT_THROW(Material("m", {400, 500}, std::vector<ComplexIndex>{1, {1, -1e-9}}), DomainError);
    EXPECT_THROW(Material("m", ComplexIndex(std::nan(""), 0)), DomainError);
}

TEST(Material, UnknownNameNamesTheClosestAndAll) {
    const auto message = error_of("TiO2_anatas");
    EXPECT_THAT(message, HasSubstr("did you mean 'TiO2_anatase'"));
    for (const auto& name : material_names()) EXPECT_THAT(message, HasSubstr(name));
    EXPECT_THAT(error_of(std::string(100000, 'x')), HasSubstr("xxx..."));
}

TEST(Material, FilesAreTakenFromTheBaseDirectory) {
    const test::TempFolder directory;
    directory.write("mine.csv", "wavelength_nm,n,k\n400,1.5,0\n700,1.4,0.1\n");
    directory.write(
        "page.YML",
        "DATA:\n  - type: tabulated n\n    data: |\n        0.4 1.6\n        0.7 1.5\n");
    EXPECT_NEAR(find_material("mine.csv", directory).index(550).real(), 1.45, 1e-15);
    EXPECT_NEAR(find_material("page.YML", directory).index(550).real(), 1.55, 1e-15);
    EXPECT_EQ(find_material((directory / "mine.csv").string(), "/elsewhere").index(700),
              ComplexIndex(1.4, .1));
    EXPECT_THAT(error_of("absent.csv"), HasSubstr("absent.csv': No such file"));
    std::filesystem::create_directories(directory / "folder.csv");
    EXPECT_THROW(find_material("folder.csv", directory), InputError);
}

}  // namespace
}  // namespace nacre::optics
