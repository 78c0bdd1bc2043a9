#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nacre/optics/thin_film.h"
#include "nacre/spectra/colour.h"

namespace nacre::optics {
namespace {

struct Colour {
    double lightness, chroma, hue_deg;
};

/// Of the mean flake under D65 at normal incidence, in a binder of index 1.5.
Colour colour_of_mica_with(double coat_nm) {
    std::vector<double> wavelengths_nm;
    for (int w = 380; w <= 780; w += 5) wavelengths_nm.push_back(w);
    const Platelet platelet{{find_material("mica"), 500, {60}},
                            {{find_material("TiO2_anatase"), coat_nm, {3}}}};
    const auto table = platelet_table(platelet, 1.5, std::vector<double>{1}, wavelengths_nm);
    using namespace spectra;
    const auto lab =
        xyz_to_lab(reflectance_to_xyz(wavelengths_nm, table.reflectance, Illuminant::D65,
                                      Observer::cie1931_2deg),
                   white_point(wavelengths_nm, Illuminant::D65, Observer::cie1931_2deg));
    const double hue_deg = std::atan2(lab[2], lab[1]) * 180 / std::numbers::pi;
    return {lab[0], std::hypot(lab[1], lab[2]), std::fmod(hue_deg + 360, 360)};
}

// What pigment makers sell: the colour of TiO2 on mica by the thickness of the coat, good to 10 nm.
// CIELAB hue angles: 0 red-magenta, 90 yellow, 180 green, 270 blue.
TEST(InterferenceColour, ThinTitaniaOnMicaIsSilver) {
    for (double coat_nm : {40.0, 50.0, 60.0}) {
        const auto colour = colour_of_mica_with(coat_nm);
        EXPECT_LT(colour.chroma, 12) << coat_nm;
        EXPECT_GT(colour.lightness, 60) << coat_nm;
    }
}

TEST(InterferenceColour, ThickerTitaniaRunsThroughTheHuesOfTheFirstOrder) {
    struct Case {
        double coat_nm, least_hue_deg, greatest_hue_deg;
        const char* name;
    };
    constexpr Case cases[] = {
        {70, 75, 105, "yellow"},    {80, 70, 100, "gold"},     {90, 30, 75, "orange"},
        {100, 315, 350, "magenta"}, {110, 295, 320, "violet"}, {120, 250, 300, "blue"},
        {130, 230, 270, "blue"},    {150, 140, 190, "green"},  {160, 100, 140, "yellow-green"}};
    for (const auto& c : cases) {
        const auto colour = colour_of_mica_with(c.coat_nm);
        EXPECT_GT(colour.hue_deg, c.least_hue_deg) << c.name << " at " << c.coat_nm << " nm";
        EXPECT_LT(colour.hue_deg, c.greatest_hue_deg) << c.name << " at " << c.coat_nm << " nm";
        EXPECT_GT(colour.chroma, 20) << c.name;
    }
}

}  // namespace
}  // namespace nacre::optics
