#include "nacre/measure/measurement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "nacre/core/error.h"

namespace nacre::measure {
namespace {

using spectra::Illuminant;
using spectra::Observer;

std::vector<double> grid() {
    std::vector<double> nm;
    for (int i = 0; i <= 30; ++i) nm.push_back(400 + 10 * i);
    return nm;
}

std::vector<double> wave() {
    std::vector<double> values;
    for (double nm : grid()) {
        values.push_back(0.5 + 0.4 * std::sin((nm - 400) / 300 * M_PI * 1.5));
    }
    return values;
}

struct Published {
    Illuminant illuminant;
    Observer observer;
    Vec3d xyz, lab;
};

// colour-science 0.4.7: sums over 400-700 nm by 10 (A, D65), and over 360-780 nm by 5 of the linear
// interpolation of the same samples, constant beyond them (FL2, FL11):
//   colour.colorimetry.sd_to_XYZ_integration(sd, cmfs, illuminant), cmfs and illuminant aligned to
//   that shape with LinearInterpolator; XYZ_to_Lab relative to the same sums of ones.
constexpr Published kPublished[] = {
    {Illuminant::A,
     Observer::cie1931_2deg,
     {54.856743224107269, 63.887788412397974, 28.565322859875447},
     {83.90731190964155, -33.757481040930017, -13.688901867897506}},
    {Illuminant::D65,
     Observer::cie1964_10deg,
     {55.958031532478465, 71.452515816764873, 83.229146625597238},
     {87.704395460928282, -27.548488021871265, -4.9315885498941281}},
    {Illuminant::FL2,
     Observer::cie1931_2deg,
     {58.23682735347662, 67.759576882733668, 51.75500132109304},
     {85.886087273106426, -20.480391737210002, -7.4845711328640485}},
    {Illuminant::FL11,
     Observer::cie1964_10deg,
     {59.138540620581679, 68.184061518111378, 50.097130253069196},
     {86.098402054780678, -25.66193991047172, -6.7702332453164482}},
};

TEST(Coloured, AgreesWithColourScienceUnderEveryKindOfLight) {
    for (const Published& p : kPublished) {
        const Reading reading =
            coloured(in_plane(45, 15), grid(), wave(), {p.illuminant, p.observer, {}});
        for (int c = 0; c < 3; ++c) {
            // Both are sums of some hundred numbers in double precision over the same tables.
            EXPECT_NEAR(reading.xyz[c], p.xyz[c], 1e-9);
            EXPECT_NEAR(reading.lab[c], p.lab[c], 1e-4);  // white by chromaticity there
        }
        EXPECT_EQ(reading.reflectance_factor, wave());
    }
}

TEST(Coloured, ThePerfectDiffuserIsWhiteUnderEveryLight) {
    const std::vector<double> ones(31, 1.0);
    for (Illuminant illuminant : {Illuminant::A, Illuminant::D50, Illuminant::D65, Illuminant::FL2,
                                  Illuminant::FL11, Illuminant::E}) {
        for (Observer observer : {Observer::cie1931_2deg, Observer::cie1964_10deg}) {
            const Reading reading =
                coloured(in_plane(45, 45), grid(), ones, {illuminant, observer, {}});
            EXPECT_NEAR(reading.xyz[1], 100, 1e-12);
            EXPECT_NEAR(reading.lab[0], 100, 1e-12);
            EXPECT_NEAR(chroma(reading.lab), 0, 1e-10);
            EXPECT_EQ(hue_deg(reading.lab), 0);
        }
    }
}

TEST(Coloured, RefusesWhatIsNoSpectrum) {
    EXPECT_THROW(coloured({}, {400, 500, 700}, {1, 1, 1}, {}), DomainError);
    EXPECT_THROW(coloured({}, {400}, {1}, {}), DomainError);
    EXPECT_THROW(coloured({}, {400, 500}, {1, NAN}, {}), DomainError);
    EXPECT_THROW(coloured({}, {400, 500}, {1}, {Illuminant::FL2, Observer::cie1931_2deg, {}}),
                 DomainError);
}

TEST(Hue, TurnsFromRedOverYellowToBlue) {
    EXPECT_EQ(hue_deg({50, 20, 0}), 0);
    EXPECT_EQ(hue_deg({50, 0, 20}), 90);
    EXPECT_EQ(hue_deg({50, -20, 0}), 180);
    EXPECT_EQ(hue_deg({50, 0, -20}), 270);
    EXPECT_LT(hue_deg({50, 20, -1e-14}), 360);
    EXPECT_EQ(chroma({50, 3, -4}), 5);
}

// colour-science 0.4.7: XYZ_to_sRGB(Lab_to_XYZ(lab, [0.3127, 0.3290])), which adapts between two
// roundings of the same white: hence the tolerance.
TEST(Chip, IsTheSrgbColourWithThePerfectDiffuserAsWhite) {
    const auto expect = [](const Vec3d& lab, const Vec3d& srgb) {
        const Vec3d chip = srgb_chip(lab);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(chip[c], srgb[c], 2e-4);
    };
    expect({50, 20, -30}, {0.496294, 0.429291, 0.666826});
    expect({80, -40, 60}, {0.614591, 0.846191, 0.304597});
    expect({100, 0, 0}, {1, 1, 1});
    expect({0, 0, 0}, {0, 0, 0});
    expect({120, 0, 0}, {1, 1, 1});  // clipped
    const Vec3d clipped = srgb_chip({50, 500, -500});
    for (int c = 0; c < 3; ++c) {
        EXPECT_GE(clipped[c], 0);
        EXPECT_LE(clipped[c], 1);
    }
}

TEST(Chip, AtFullLightKeepsTheHueOfALobe) {
    const Vec3d gold{130, 10, 90}, dim{50, 20, -30};
    const Vec3d chip = srgb_chip_at_full_light(gold);
    EXPECT_DOUBLE_EQ(std::max({chip[0], chip[1], chip[2]}), 1);
    EXPECT_LT(chip[2], 0.7);  // not white, as clipping makes it
    EXPECT_GT(srgb_chip(gold)[1], chip[1]);
    EXPECT_EQ(srgb_chip_at_full_light(dim), srgb_chip(dim));
}

TEST(MeasurementValue, FindsGeometriesInThePlaneOnly) {
    Measurement m;
    m.readings.resize(3);
    m.readings[0].geometry = towards(45, 45, 90);
    m.readings[0].geometry.aspecular_deg = 15;
    m.readings[1].geometry = in_plane(45, 15);
    m.readings[2].geometry = in_plane(15, 15 + 5e-7);
    EXPECT_EQ(m.find(45, 15), &m.readings[1]);
    EXPECT_EQ(m.find(15, 15), &m.readings[2]);
    EXPECT_EQ(m.find(15, 15.1), nullptr);
}

Measurement read_as(std::initializer_list<std::pair<double, Vec3d>> labs) {
    Measurement m;
    for (const auto& [aspecular, lab] : labs) {
        Reading reading;
        reading.geometry = in_plane(45, aspecular);
        reading.lab = lab;
        m.readings.push_back(reading);
    }
    return m;
}

TEST(FlopIndex, IsTheFormula) {
    // By hand: 2.69 * 100^1.11 / 50^0.86 = 2.69 * 165.959 / 28.913.
    const auto m = read_as({{15, {120, 0, 0}}, {45, {50, 0, 0}}, {110, {20, 0, 0}}});
    EXPECT_NEAR(flop_index(m).value(), 15.44, 0.005);
}

TEST(FlopIndex, OfASolidColourIsZero) {
    EXPECT_EQ(flop_index(read_as({{15, {40, 9, 9}}, {45, {40, 9, 9}}, {110, {40, 9, 9}}})), 0);
}

TEST(FindReading, IsTheNearestWithinATenthOfADegree) {
    Measurement m;
    for (const double aspecular_deg : {15.09, 15.02, 25.0}) {
        Reading reading;
        reading.geometry = in_plane(45, aspecular_deg);
        m.readings.push_back(reading);
    }
    EXPECT_EQ(find_reading(m, in_plane(45, 15)), &m.readings[1]);
    EXPECT_EQ(find_reading(m, in_plane(45, 15.08)), &m.readings[0]);
    EXPECT_EQ(find_reading(m, in_plane(45, 25.09)), &m.readings[2]);
    EXPECT_EQ(find_reading(m, in_plane(45, 25.11)), nullptr);
    EXPECT_EQ(find_reading(m, off_plane(45, 15, 90)), nullptr);
}

TEST(CoarseSpectra, AreWarnedOfWhereColoursComeFromThem) {
    const auto warning = [](std::vector<double> nm, bool colour_of_its_own = false) {
        Measurement m{"x", {}, nm, {}};
        m.readings.push_back(
            coloured(in_plane(45, 15), nm, std::vector<double>(nm.size(), 0.3), {}));
        if (colour_of_its_own) m.readings[0].lab = {50, 1, 2};
        return coarse_spectra_warning(m).value_or("");
    };
    std::vector<double> usual, coarse;
    for (double nm = 400; nm <= 700; nm += 10) usual.push_back(nm);
    for (double nm = 420; nm <= 690; nm += 30) coarse.push_back(nm);
    EXPECT_EQ(warning(usual), "");
    EXPECT_EQ(warning(coarse), "");
    EXPECT_THAT(warning({450, 550, 650}), ::testing::HasSubstr("3 wavelengths from 450 to 650 nm"));
    EXPECT_THAT(warning({500, 600}), ::testing::HasSubstr("x: colours of 2 wavelengths"));
    EXPECT_THAT(warning({400, 440, 480, 520, 560, 600, 640, 680}), ::testing::HasSubstr("8 wave"));
    EXPECT_EQ(warning({450, 550, 650}, true), "");
}

TEST(FlopIndex, IsEmptyWhereItHasNoValue) {
    EXPECT_FALSE(flop_index({}));
    EXPECT_FALSE(flop_index(read_as({{15, {40, 0, 0}}, {45, {40, 0, 0}}})));
    EXPECT_FALSE(flop_index(read_as({{15, {30, 0, 0}}, {45, {40, 0, 0}}, {110, {40, 0, 0}}})));
    EXPECT_FALSE(flop_index(read_as({{15, {40, 0, 0}}, {45, {0, 0, 0}}, {110, {30, 0, 0}}})));
}

TEST(ColourTravel, AddsStepsInOrderOfTheAngleWhateverTheOrderOfTheFile) {
    auto m = read_as({{110, {0, 3, 4}}, {-15, {0, 0, 0}}, {45, {9, 3, 0}}});
    Reading other;
    other.geometry = in_plane(15, 15);
    other.lab = {0, 99, 99};
    m.readings.push_back(other);
    other.geometry = off_plane(45, 25, 90);
    m.readings.push_back(other);
    const ColourTravel travel = colour_travel(m);
    ASSERT_EQ(travel.path.size(), 3u);
    EXPECT_EQ(travel.path[0]->geometry.name, "45as-15");
    EXPECT_EQ(travel.path[2]->geometry.name, "45as110");
    EXPECT_DOUBLE_EQ(travel.length, 3 + 4);
    EXPECT_EQ(colour_travel(m, 15).path.size(), 1u);
    EXPECT_EQ(colour_travel(m, 15).length, 0);
    EXPECT_TRUE(colour_travel(m, 65).path.empty());
}

}  // namespace
}  // namespace nacre::measure
