#include "nacre/montecarlo/discs/disc_films.h"

#include <gtest/gtest.h>

#include <cmath>

namespace nacre::montecarlo {
namespace {

const std::vector<double> kGrid{400, 450, 500, 550, 600, 650, 700};
constexpr std::array<double, kLanes> kWavelengths{400, 425, 450, 500, 550, 600, 625, 700};

paint::FlakeSpecies pearl_flakes() {
    paint::FlakeSpecies species;
    optics::Platelet platelet;
    platelet.core = {optics::find_material("mica"), 500, {60}};
    platelet.coats = {
        {optics::find_material("TiO2_anatase"), 110, {5, optics::ThicknessSpread::Law::uniform}}};
    species.body = platelet;
    return species;
}

TEST(DiscFilms, MeanOverTheSetIsThatOfThePopulation) {
    const paint::FlakeSpecies species = pearl_flakes();
    const optics::Material binder(1.5);
    const DiscFilms films(species, binder, kGrid, 3);
    EXPECT_EQ(films.count(), DiscFilms::kFilms);
    const WavelengthPlaces places = bsdf::locate_wavelengths(kGrid, kWavelengths);
    // 0.4671875 lies between nodes of the set's table.
    for (const double cosine : {1.0, 0.8, 0.4671875}) {
        const auto mean = optics::platelet_table(std::get<optics::Platelet>(species.body), binder,
                                                 std::vector{cosine}, kGrid);
        DoubleLanes r{}, t{}, r2{};
        for (int i = 0; i < films.count(); ++i) {
            const auto optics = films.at(i, cosine, places);
            r += optics.reflectance / films.count();
            r2 += optics.reflectance * optics.reflectance / films.count();
            t += optics.transmittance / films.count();
        }
        for (const auto& [lane, grid] : {std::pair{0, 0}, {2, 1}, {3, 2}, {4, 3}, {7, 6}}) {
            const double deviation = std::sqrt(std::max(0.0, r2[lane] - r[lane] * r[lane]));
            // A stratified set errs by less than a random one, whose standard error would be
            // deviation / 16.
            EXPECT_NEAR(r[lane], mean.reflectance[grid], deviation / 16 + 1e-3) << cosine;
            EXPECT_NEAR(r[lane] + t[lane], 1, 1e-3) << "mica and TiO2 absorb next to nothing";
            EXPECT_GT(deviation, 0.003) << "flakes differ";
        }
    }
}

TEST(DiscFilms, PrescribedOpticsAreTheSameAtEveryAngle) {
    paint::FlakeSpecies species;
    species.body = paint::PrescribedFlake{spectra::Spectrum({400, 700}, {0.2, 0.8}), 0.1, 0.3};
    const DiscFilms films(species, optics::Material(1.5), kGrid, 0);
    EXPECT_EQ(films.count(), 1);
    for (const double cosine : {0.0, 0.3, 1.0, 1.0000001}) {
        const auto optics = films.at(0, cosine, bsdf::locate_wavelengths(kGrid, kWavelengths));
        for (int lane = 0; lane < kLanes; ++lane) {
            EXPECT_NEAR(optics.reflectance[lane], 0.2 + 0.002 * (kWavelengths[lane] - 400), 1e-6);
            EXPECT_NEAR(optics.transmittance[lane], 0.1, 1e-6);
        }
    }
}

TEST(DiscFilms, OneWavelengthServesAll) {
    paint::FlakeSpecies species = pearl_flakes();
    std::get<optics::Platelet>(species.body).core.spread = {};
    std::get<optics::Platelet>(species.body).coats[0].spread = {};
    const std::vector<double> green{550};
    const DiscFilms films(species, optics::Material(1.5), green, 0);
    EXPECT_EQ(films.count(), 1) << "no film varies";
    const auto optics = films.at(0, 0.9, bsdf::locate_wavelengths(green, kWavelengths));
    for (int lane = 1; lane < kLanes; ++lane)
        EXPECT_EQ(optics.reflectance[lane], optics.reflectance[0]);
    EXPECT_GT(optics.reflectance[0], 0.001);
}

}  // namespace
}  // namespace nacre::montecarlo
