#include "nacre/optics/thin_film.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/optics/fresnel.h"
#include "nacre/spectra/colour.h"

namespace nacre::optics {
namespace {

struct StackCase {
    double ambient;
    std::vector<ThinFilm> films;
    ComplexIndex substrate;
    double cos_incident, wavelength_nm;
    ReflectanceTransmittance s, p;
};

/// Passes where |found - expected| <= tolerance, in R and T of both polarisations.
void expect_matches(const StackCase& c, double tolerance) {
    for (const bool is_p : {false, true}) {
        const auto found =
            stack_reflectance(c.ambient, c.films, c.substrate, c.cos_incident, c.wavelength_nm,
                              is_p ? Polarization::p : Polarization::s);
        const auto& expected = is_p ? c.p : c.s;
        EXPECT_NEAR(found.reflectance, expected.reflectance, tolerance);
        EXPECT_NEAR(found.transmittance, expected.transmittance, tolerance);
        // T may be tiny; its digits count too.
        EXPECT_NEAR(found.transmittance / expected.transmittance, 1, 1e-9)
            << c.ambient << " " << c.substrate << " at cos " << c.cos_incident;
    }
}

ReflectanceTransmittance unpolarized(double ambient, const std::vector<ThinFilm>& films,
                                     ComplexIndex substrate, double cos_incident,
                                     double wavelength_nm) {
    return stack_reflectance(ambient, films, substrate, cos_incident, wavelength_nm,
                             Polarization::unpolarized);
}

TEST(Stack, MatchesPublishedConstants) {
    // Values in print, to the digits printed: absorbing films on an absorbing substrate, an
    // absorbing pair at 45 degrees, and the quarter wave of MgF2 on glass.
    expect_matches({1,
                    {{{2, 4}, 2}, {{3, .3}, 3}},
                    {1, .1},
                    std::cos(.1),
                    100,
                    {.37273208839139516, .22604491247079261},
                    {.37016110373044969, .22824374314132009}},
                   1e-14);
    const std::vector<ThinFilm> pair{{{2.2, .2}, 100}, {{3.3, .3}, 300}};
    const double cos_45 = std::numbers::sqrt2 / 2;
    EXPECT_NEAR(stack_reflectance(1, pair, 1, cos_45, 400, Polarization::s).reflectance,
                .324162389538, 1e-12);
    EXPECT_NEAR(stack_reflectance(1, pair, 1, cos_45, 400, Polarization::p).reflectance,
                .108390605491, 1e-12);
    EXPECT_NEAR(unpolarized(1, {{1.38, 550 / (4 * 1.38)}}, 1.52, 1, 550).reflectance, .012600790215,
                1e-12);
}

TEST(Stack, MatchesTmmForRandomStacks) {
    // tmm 0.2.0, numpy default_rng(2022): indices, thicknesses and angles rounded as they stand
    // here, then tmm.coh_tmm(polarization, [ambient, films..., substrate], [inf, d..., inf],
    // numpy.arccos(cos), wavelength)["R"] and ["T"].
    // clang-format off
    const StackCase cases[] = {
        {1.0, {{{1.367, 0.0}, 132.2}, {{2.559, 0.055}, 357.1}, {{1.946, 0.0}, 378.7}}, {1.838, 0.0}, 0.75, 751.4, {0.08691449731359373, 0.6372246510881545}, {0.06954739484083737, 0.6536185449702686}},
        {1.5, {{{1.649, 0.031}, 236.8}, {{1.779, 0.042}, 5.2}, {{1.352, 0.0}, 121.4}}, {1.515, 0.0}, 0.271, 437.1, {0.35728475709401186, 0.24508540402845996}, {0.3371486824944956, 0.25665248398758245}},
        {1.5, {{{1.717, 0.0}, 280.8}}, {1.899, 1.996}, 0.487, 381.2, {0.4366802334147214, 0.5633197665852785}, {0.10352626712778956, 0.8964737328722107}},
        {1.5, {{{2.357, 0.0}, 219.5}, {{2.487, 0.301}, 196.1}, {{2.422, 3.601}, 38.0}, {{1.281, 0.0}, 183.2}}, {1.729, 3.631}, 0.249, 381.6, {0.41652487121101356, 7.199187937410702e-07}, {0.1507157368383303, 0.0002804390604847342}},
        {1.5, {{{2.202, 0.0}, 154.8}, {{2.138, 0.252}, 294.8}, {{2.39, 1.454}, 265.1}}, {2.479, 2.143}, 0.854, 423.0, {0.0536069819459905, 4.518166126569856e-07}, {0.020849063713304337, 4.943061505668729e-07}},
        {1.5, {{{2.68, 0.348}, 139.6}, {{2.543, 0.0}, 344.7}, {{2.831, 3.982}, 262.3}}, {1.842, 2.605}, 0.147, 622.2, {0.5984996965493633, 1.5335833039544517e-11}, {0.4007357129517448, 3.536877030827413e-11}},
        {1.0, {{{1.323, 0.041}, 50.3}, {{2.119, 0.021}, 88.5}, {{2.606, 3.863}, 33.8}, {{2.08, 0.0}, 121.9}}, {2.008, 3.57}, 0.23, 687.7, {0.5010596577191548, 0.04853719194865169}, {0.40524442634718005, 0.1033607470481387}},
        {1.0, {{{2.172, 0.348}, 230.9}, {{2.521, 0.0}, 201.0}, {{2.398, 0.0}, 44.5}}, {1.122, 1.687}, 0.823, 473.9, {0.22873369933422635, 0.06228373322821562}, {0.11914509593393093, 0.0738370740507206}},
        {1.5, {{{2.859, 0.164}, 291.9}, {{2.319, 0.0}, 128.7}, {{2.821, 4.269}, 121.9}}, {1.843, 3.676}, 0.724, 552.3, {0.29669244357461433, 6.085678166484865e-07}, {0.11699691213096101, 8.698103485912476e-07}},
        {1.33, {{{1.725, 0.0}, 106.3}, {{2.062, 0.0}, 318.8}, {{1.685, 2.125}, 341.1}}, {2.472, 0.0}, 0.855, 457.5, {0.2878768765230439, 1.7511822906138756e-09}, {0.24556530502925228, 1.6744301177846191e-09}},
        {1.33, {{{1.674, 3.281}, 56.7}, {{1.54, 0.0}, 320.3}, {{1.849, 0.0}, 131.6}, {{1.99, 3.765}, 213.1}}, {1.602, 2.543}, 0.658, 524.4, {0.6771891159795115, 2.769825767602855e-12}, {0.41364806589422237, 1.1381243324770063e-11}},
        {1.5, {{{2.012, 0.0}, 357.9}, {{2.791, 0.0}, 365.8}}, {1.423, 0.068}, 0.292, 679.8, {0.40828664392626285, 0.5917133560737381}, {0.10660570874198234, 0.8933942912580182}},
    };
    // clang-format on
    for (const auto& c : cases) expect_matches(c, 1e-10);
}

TEST(Stack, MatchesFiftyDigitArithmetic) {
    // mpmath 1.3.0, mp.dps = 50: unscaled characteristic matrices. Frustrated total reflection, a
    // flake at grazing incidence, opaque metals, total reflection at an absorbing pair.
    // clang-format off
    const StackCase cases[] = {
        {1.5, {{{1.3, 0.0}, 900.0}}, {1.5, 0.0}, 0.3, 550.0, {0.99998310332935369, 1.6896670646313443e-5}, {0.9999865669602556, 1.3433039744399951e-5}},
        {1.5, {{{2.5, 0.0}, 80.0}, {{1.58, 0.0}, 500.0}, {{2.5, 0.0}, 80.0}}, {1.5, 0.0}, 0.001, 450.0, {0.99999920855613809, 7.9144386190672421e-7}, {0.9999871625464112, 1.2837453588799235e-5}},
        {1.0, {{{1.2, 6.5}, 150.0}}, {1.5, 0.0}, 0.7, 550.0, {0.92789195397265529, 5.3343790183972255e-11}, {0.85841597205263799, 1.279143407664888e-10}},
        {1.5, {{{1.1, 0.0}, 2000.0}, {{2.2, 0.01}, 3000.0}}, {1.7, 2.0}, 0.2, 400.0, {1.0, 1.2585296855923781e-27}, {1.0, 4.553861573281891e-28}},
        {1.0, {{{0.2, 3.4}, 1000.0}}, {1.5, 0.0}, 0.9, 550.0, {0.94487606321080429, 1.2673362817738378e-34}, {0.93159357519883428, 1.6271609719069044e-34}},
    };
    // clang-format on
    for (const auto& c : cases) expect_matches(c, kStackError);

    StackCase mirror{1.0,
                     {},
                     1.52,
                     .8,
                     500,
                     {0.99991380880542612, 8.6191194573878341e-5},
                     {0.99877052033242674, 0.0012294796675732641}};
    for (int i = 0; i < 10; ++i) {
        mirror.films.push_back({2.3, 60});
        mirror.films.push_back({1.45, 95});
    }
    expect_matches(mirror, kStackError);
}

TEST(Stack, WithoutFilmsIsFresnelsInterface) {
    for (double cos_incident : {1e-6, .3, 1.0}) {
        for (ComplexIndex substrate : {ComplexIndex(2.5), ComplexIndex(.2, 3.4)}) {
            const auto f = fresnel(1.5, substrate, cos_incident);
            const auto r = unpolarized(1.5, {}, substrate, cos_incident, 550);
            EXPECT_NEAR(r.reflectance, (std::norm(f.r_s) + std::norm(f.r_p)) / 2, 1e-14);
            EXPECT_NEAR(r.transmittance, 1 - r.reflectance, 1e-14);
        }
    }
}

TEST(Stack, EnergyIsConservedWithoutAbsorption) {
    for (double cos_incident : {1e-9, .01, .2, .4, .8, 1.0}) {
        for (double thickness_nm : {0.0, 1.0, 300.0, 1e5}) {
            const auto r =
                unpolarized(1.5, {{2.5, thickness_nm}, {1.38, 90}}, 1.5, cos_incident, 480);
            EXPECT_NEAR(r.reflectance + r.transmittance, 1, 1e-12)
                << cos_incident << " " << thickness_nm;
        }
    }
}

TEST(Stack, TransmittanceIsReciprocal) {
    const std::vector<ThinFilm> films{{{2.0, .3}, 70}, {1.4, 200}, {{.2, 3.4}, 20}};
    const std::vector<ThinFilm> reversed(films.rbegin(), films.rend());
    for (const auto polarization : {Polarization::s, Polarization::p}) {
        const double cos_down = .6, cos_up = std::sqrt(1 - (1 - .36) / (1.5 * 1.5));
        const auto down = stack_reflectance(1.0, films, 1.5, cos_down, 550, polarization);
        const auto up = stack_reflectance(1.5, reversed, 1.0, cos_up, 550, polarization);
        EXPECT_NEAR(down.transmittance, up.transmittance, 1e-14);
        EXPECT_GT(std::abs(down.reflectance - up.reflectance), 1e-3);  // absorption breaks that one
    }
}

TEST(Stack, FilmVanishesWithItsThickness) {
    const auto bare = unpolarized(1.5, {}, ComplexIndex(.9, 6.4), .4, 550);
    const auto coated = unpolarized(1.5, {{2.5, 1e-9}}, ComplexIndex(.9, 6.4), .4, 550);
    EXPECT_NEAR(coated.reflectance, bare.reflectance, 1e-10);
    const auto matched = unpolarized(1.5, {{1.5, 777}}, 1.5, .4, 550);
    EXPECT_NEAR(matched.reflectance, 0, 1e-30);
    EXPECT_NEAR(matched.transmittance, 1, 1e-14);
}

TEST(Stack, ThickAbsorbingFilmIsASubstrate) {
    const ComplexIndex aluminium(.96, 6.69);
    const auto bulk = unpolarized(1.5, {}, aluminium, .7, 550);
    for (double thickness_nm : {1e4, 1e5, 1e9}) {
        const auto film = unpolarized(1.5, {{aluminium, thickness_nm}, {1.38, 100}}, 1.5, .7, 550);
        EXPECT_NEAR(film.reflectance, bulk.reflectance, 1e-14);
        EXPECT_GE(film.transmittance, 0);
        EXPECT_LT(film.transmittance, 1e-300);
    }
}

TEST(Stack, ManyFilmsNeitherOverflowNorVanish) {
    std::vector<ThinFilm> films;
    for (int i = 0; i < 5000; ++i) {
        films.push_back({2.5, 55});
        films.push_back({1.38, 100});
    }
    EXPECT_NEAR(unpolarized(1.5, films, 1.5, 1, 550).reflectance, 1, 1e-9);
    for (auto& film : films) film.index += ComplexIndex(0, 3);
    const auto r = unpolarized(1.5, films, 1.5, .5, 550);
    EXPECT_TRUE(std::isfinite(r.reflectance) && r.transmittance == 0);
}

TEST(Stack, CriticalAngleInAFilmIsALimit) {
    // n^2 = n_ambient^2 sin^2 exactly: 1.5^2 * .64 = 1.2^2
    const double cos_critical = .6;
    const auto at = unpolarized(1.5, {{1.2, 300}}, 1.5, cos_critical, 550);
    for (double offset : {-1e-9, 1e-9}) {
        const auto near = unpolarized(1.5, {{1.2, 300}}, 1.5, cos_critical + offset, 550);
        EXPECT_NEAR(near.reflectance, at.reflectance, 1e-7);
    }
    EXPECT_NEAR(at.reflectance + at.transmittance, 1, 1e-12);
}

TEST(Stack, GrazingLightIsReflected) {
    const auto r = unpolarized(1.5, {{2.5, 80}}, 1.5, 0, 550);
    EXPECT_EQ(r.reflectance, 1);
    EXPECT_EQ(r.transmittance, 0);
    EXPECT_EQ(unpolarized(1.5, {}, 1.5, 0, 550).transmittance, 1);
}

TEST(Stack, RefusesArgumentsOutOfRange) {
    const std::vector<ThinFilm> negative{{1.5, -1}}, gain{{{1.5, -.1}, 10}};
    EXPECT_THROW(unpolarized(1, negative, 1.5, 1, 550), DomainError);
    EXPECT_THROW(unpolarized(1, gain, 1.5, 1, 550), DomainError);
    EXPECT_THROW(unpolarized(1, {}, 1.5, 1.1, 550), DomainError);
    EXPECT_THROW(unpolarized(1, {}, 1.5, 1, 0), DomainError);
    EXPECT_THROW(unpolarized(1, {}, ComplexIndex(std::nan(""), 0), 1, 550), DomainError);
    EXPECT_THROW(stack_reflectance({1.5, .1}, {}, 1, 1, 550, Polarization::s), DomainError);
}

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

// Colours of TiO2 on mica by the thickness of the coat, good to 10 nm [pfaff-reynders-1999;
// buxbaum-pfaff-2005]. CIELAB hue angles: 0 red-magenta, 90 yellow, 180 green, 270 blue.
TEST(InterferenceColour, ThinTitaniaOnMicaIsSilver) {
    for (double coat_nm : {40.0, 50.0, 60.0}) {
        const auto colour = colour_of_mica_with(coat_nm);
        EXPECT_LT(colour.chroma, 12) << coat_nm;
        EXPECT_GT(colour.lightness, 60) << coat_nm;
    }
}

TEST(InterferenceColour, ThickerTitaniaRunsThroughTheHuesOfTheFirstOrder) {
    struct Case {
        double coat_nm, min_hue_deg, greatest_hue_deg;
        const char* name;
    };
    constexpr Case cases[] = {
        {70, 75, 105, "yellow"},    {80, 70, 100, "gold"},     {90, 30, 75, "orange"},
        {100, 315, 350, "magenta"}, {110, 295, 320, "violet"}, {120, 250, 300, "blue"},
        {130, 230, 270, "blue"},    {150, 140, 190, "green"},  {160, 100, 140, "yellow-green"}};
    for (const auto& c : cases) {
        const auto colour = colour_of_mica_with(c.coat_nm);
        EXPECT_GT(colour.hue_deg, c.min_hue_deg) << c.name << " at " << c.coat_nm << " nm";
        EXPECT_LT(colour.hue_deg, c.greatest_hue_deg) << c.name << " at " << c.coat_nm << " nm";
        EXPECT_GT(colour.chroma, 20) << c.name;
    }
}

}  // namespace
}  // namespace nacre::optics
