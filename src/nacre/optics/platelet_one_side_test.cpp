#include <gtest/gtest.h>

#include <cmath>

#include "nacre/core/error.h"
#include "nacre/optics/thickness_rule.h"
#include "nacre/optics/thin_film.h"

// Platelets with a coat on one side.

namespace nacre::optics {
namespace {

using Face = Platelet::Face;

PlateletTable face_table(Platelet platelet, Face face, double cosine, double wavelength_nm) {
    platelet.coated_sides = Platelet::CoatedSides::one;
    platelet.face = face;
    return platelet_table(platelet, 1.5, std::vector{cosine}, std::vector{wavelength_nm});
}

TEST(PlateletOneSide, FacesAreThoseOfTmm) {
    // tmm 0.2.0: th = arccos(cosine); R and T the means over p in "sp" of
    // tmm.coh_tmm(p, [1.5, coat, core, 1.5], [inf, coat_nm, core_nm, inf], th, wavelength), and of
    // the films the other way round.
    struct Case {
        ComplexIndex core, coat;
        double core_nm, coat_nm, cosine, wavelength_nm, coated_r, coated_t, bare_r, bare_t;
    };
    const ComplexIndex mica = 1.58, titania = 2.5, metal(0.9, 6), tinted(2.9, 0.05);
    const Case cases[] = {
        {mica, titania, 500, 80, 1, 450, .0285808465108, .971419153489, .0285808465108,
         .971419153489},
        {mica, titania, 500, 80, .8, 620, .205321784182, .794678215818, .205321784182,
         .794678215818},
        {mica, titania, 500, 80, .4, 450, .291335268827, .708664731173, .291335268827,
         .708664731173},
        {metal, tinted, 40, 90, 1, 450, .621857851175, .00130648936914, .868318096551,
         .00130648936914},
        {metal, tinted, 40, 90, .8, 620, .771914668323, .00491724887099, .861248044495,
         .00491724887099},
        {metal, tinted, 40, 90, .4, 450, .71624996485, .0011760350773, .849109826136,
         .0011760350773},
    };
    for (const Case& c : cases) {
        const Platelet platelet{{Material(c.core), c.core_nm, {}},
                                {{Material(c.coat), c.coat_nm, {}}}};
        const auto coated = face_table(platelet, Face::coated, c.cosine, c.wavelength_nm);
        const auto bare = face_table(platelet, Face::bare, c.cosine, c.wavelength_nm);
        EXPECT_NEAR(coated.reflectance[0], c.coated_r, 1e-10);
        EXPECT_NEAR(coated.transmittance[0], c.coated_t, 1e-10);
        EXPECT_NEAR(bare.reflectance[0], c.bare_r, 1e-10);
        EXPECT_NEAR(bare.transmittance[0], c.bare_t, 1e-10);
    }
}

// Averages over thicknesses, with a core that transmits and one that absorbs, against dense sums.
TEST(PlateletOneSide, AveragesAreDenseSums) {
    const FilmPopulation mica{find_material("mica"), 500, {60}},
        titania{find_material("TiO2_anatase"), 90, {6}}, metal{find_material("Al"), 40, {5}},
        oxide{find_material("Fe2O3"), 150, {12}};
    for (const Platelet& platelet : {Platelet{mica, {titania}}, Platelet{metal, {oxide}}}) {
        const auto core = thickness_rule(platelet.core.thickness_nm, platelet.core.spread, 600);
        const auto coat =
            thickness_rule(platelet.coats[0].thickness_nm, platelet.coats[0].spread, 60);
        for (const Face face : {Face::coated, Face::bare}) {
            for (const double cosine : {0.1, 0.5, 0.9, 1.0}) {
                for (const double wavelength_nm : {420.0, 560.0, 690.0}) {
                    double r = 0, t = 0;
                    for (std::size_t i = 0; i < core.weights.size(); ++i) {
                        for (std::size_t j = 0; j < coat.weights.size(); ++j) {
                            std::vector<ThinFilm> films = {
                                {platelet.coats[0].material.index(wavelength_nm),
                                 coat.thickness_nm[j]},
                                {platelet.core.material.index(wavelength_nm),
                                 core.thickness_nm[i]}};
                            if (face == Face::bare) std::swap(films[0], films[1]);
                            const auto one = stack_reflectance(
                                1.5, films, 1.5, cosine, wavelength_nm, Polarization::unpolarized);
                            r += core.weights[i] * coat.weights[j] * one.reflectance;
                            t += core.weights[i] * coat.weights[j] * one.transmittance;
                        }
                    }
                    const auto table = face_table(platelet, face, cosine, wavelength_nm);
                    EXPECT_NEAR(table.reflectance[0], r, kPlateletError);
                    EXPECT_NEAR(table.transmittance[0], t, kPlateletError);
                }
            }
        }
    }
}

// Without a coat there are no sides.
TEST(PlateletOneSide, WithoutCoatsIsBare) {
    const Platelet bare{{Material(1.58), 500, {50}}, {}};
    const auto plain = platelet_table(bare, 1.5, std::vector{.6}, std::vector{550.});
    for (const Face face : {Face::coated, Face::bare}) {
        const auto table = face_table(bare, face, .6, 550);
        EXPECT_NEAR(table.reflectance[0], plain.reflectance[0], 1e-12);
        EXPECT_NEAR(table.transmittance[0], plain.transmittance[0], 1e-12);
    }
    EXPECT_THROW(face_table(bare, Face::any, .6, 550), DomainError);
}

}  // namespace
}  // namespace nacre::optics
