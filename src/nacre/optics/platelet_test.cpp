#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "nacre/core/error.h"
#include "nacre/core/progress.h"
#include "nacre/optics/fresnel.h"
#include "nacre/optics/thickness_rule.h"
#include "nacre/optics/thin_film.h"

namespace nacre::optics {
namespace {

using Law = ThicknessSpread::Law;

const std::vector<double> kTableCosines{0, .01, .1, .25, .5, .8, 1};
const std::vector<double> kWavelengths{400, 455, 500, 550, 600, 655, 700, 710, 720, 730};

FilmPopulation film(const char* material, double thickness_nm, double spread_nm,
                    Law law = Law::normal) {
    return {find_material(material), thickness_nm, {spread_nm, law}};
}

/// The platelet of given thicknesses (core first), by characteristic matrices.
ReflectanceTransmittance one_flake(const Platelet& platelet, const std::vector<double>& thickness,
                                   double binder, double cosine, double wavelength_nm) {
    std::vector<ThinFilm> films;
    for (std::size_t i = platelet.coats.size(); i > 0; --i) {
        films.push_back({platelet.coats[i - 1].material.index(wavelength_nm), thickness[i]});
    }
    films.push_back({platelet.core.material.index(wavelength_nm), thickness[0]});
    for (std::size_t i = 1; i <= platelet.coats.size(); ++i) {
        films.push_back({platelet.coats[i - 1].material.index(wavelength_nm), thickness[i]});
    }
    return stack_reflectance(binder, films, binder, cosine, wavelength_nm,
                             Polarization::unpolarized);
}

/// The mean over a platelet with at most one coat, on so many nodes that resonances are resolved.
ReflectanceTransmittance dense_sum(const Platelet& platelet, double binder, double cosine,
                                   double wavelength_nm, int core_nodes, int coat_nodes) {
    const auto core = thickness_rule(platelet.core.thickness_nm, platelet.core.spread, core_nodes);
    const auto coat = platelet.coats.empty() ? ThicknessRule{{0}, {1}}
                                             : thickness_rule(platelet.coats[0].thickness_nm,
                                                              platelet.coats[0].spread, coat_nodes);
    ReflectanceTransmittance mean;
    for (std::size_t i = 0; i < core.weights.size(); ++i) {
        for (std::size_t j = 0; j < coat.weights.size(); ++j) {
            const auto r = one_flake(platelet, {core.thickness_nm[i], coat.thickness_nm[j]}, binder,
                                     cosine, wavelength_nm);
            mean.reflectance += core.weights[i] * coat.weights[j] * r.reflectance;
            mean.transmittance += core.weights[i] * coat.weights[j] * r.transmittance;
        }
    }
    return mean;
}

void expect_dense_sum(const Platelet& platelet, int core_nodes, int coat_nodes) {
    const std::vector<double> cosines{.05, .2, .45, 1}, wavelengths{400, 560, 700};
    const auto table = platelet_table(platelet, 1.5, cosines, wavelengths);
    for (std::size_t i = 0; i < cosines.size(); ++i) {
        for (std::size_t j = 0; j < wavelengths.size(); ++j) {
            const auto expected =
                dense_sum(platelet, 1.5, cosines[i], wavelengths[j], core_nodes, coat_nodes);
            const std::size_t k = i * wavelengths.size() + j;
            EXPECT_NEAR(table.reflectance[k], expected.reflectance, kPlateletError)
                << platelet.core.material.name() << " at cos " << cosines[i] << ", "
                << wavelengths[j] << " nm";
            EXPECT_NEAR(table.transmittance[k], expected.transmittance, kPlateletError);
        }
    }
}

TEST(Platelet, TransparentFlakesAreTheDenseSum) {
    expect_dense_sum({film("mica", 500, 60), {film("TiO2_anatase", 80, 5)}}, 300, 40);
    expect_dense_sum({film("mica", 500, 60, Law::uniform), {}}, 500, 1);
    expect_dense_sum({film("mica", 100, 80), {}}, 500, 1);  // cut at zero
    // A core below the binder's index, beyond its critical angle too.
    expect_dense_sum({film("SiO2", 400, 40), {film("ZrO2", 60, 15)}}, 300, 60);
}

TEST(Platelet, CoatsBeyondTheirCriticalAngleAreTheDenseSum) {
    expect_dense_sum({film("mica", 500, 60), {film("MgF2", 100, 10)}}, 400, 40);
    expect_dense_sum({film("TiO2_anatase", 60, 6), {film("SiO2", 40, 20)}}, 100, 100);
}

TEST(Platelet, CoreWithoutSpreadLeavesTheResonancesOfTheCoat) {
    expect_dense_sum({film("mica", 500, 0), {film("TiO2_anatase", 80, 8)}}, 1, 2000);
}

TEST(Platelet, AbsorbingFlakesAreTheDenseSum) {
    expect_dense_sum({film("Al", 30, 5), {}}, 100, 1);
    expect_dense_sum({film("Al", 300, 30), {film("Fe2O3", 180, 15)}}, 40, 60);
    expect_dense_sum({film("SiO2", 400, 40), {film("Fe2O3", 60, 10)}}, 150, 40);
    expect_dense_sum({film("Fe2O3", 200, 30), {}}, 200, 1);
    expect_dense_sum({{Material(ComplexIndex(1.58, 1e-4)), 500, {60, Law::normal}}, {}}, 1000, 1);
}

TEST(Platelet, TwoCoatsMatchAMonteCarloPopulation) {
    const Platelet platelet{film("mica", 400, 50),
                            {film("SiO2", 90, 9), film("TiO2_anatase", 70, 6)}};
    const double cosine = .7, wavelength_nm = 520;
    const auto table =
        platelet_table(platelet, 1.5, std::vector{cosine}, std::vector{wavelength_nm});
    std::mt19937_64 random(7);
    double sum = 0, squares = 0;
    constexpr int count = 100000;
    for (int i = 0; i < count; ++i) {
        std::vector<double> thickness;
        const auto draw = [&](const FilmPopulation& f) {
            std::normal_distribution<double> law(f.thickness_nm, f.spread.standard_deviation_nm);
            double t = law(random);
            while (std::abs(t - f.thickness_nm) > 3 * f.spread.standard_deviation_nm || t < 0) {
                t = law(random);
            }
            thickness.push_back(t);
        };
        draw(platelet.core);
        for (const auto& coat : platelet.coats) draw(coat);
        const double r = one_flake(platelet, thickness, 1.5, cosine, wavelength_nm).reflectance;
        sum += r;
        squares += r * r;
    }
    const double mean = sum / count;
    const double error = std::sqrt((squares / count - mean * mean) / count);
    EXPECT_LT(error, 1e-3);
    EXPECT_NEAR(table.reflectance[0], mean, 4 * error);  // 4 standard errors: 1 run in 16 000
}

TEST(Platelet, UniformSpreadOfOneFilmIsAClosedForm) {
    // E R = C0 + sum_m 2 C_m cos(m (k d + phi)) sinc(m k w) for d in d0 +- w, per polarisation.
    //                                        [belcour-barla-2017, eq. 3, averaged over thickness]
    const double n_binder = 1.5, n = 2.5, d_nm = 300, sd_nm = 25, cosine = .6, wavelength_nm = 520;
    const double half_nm = sd_nm * std::numbers::sqrt3;
    const auto f = fresnel(n_binder, n, cosine);
    const double k =
        4 * std::numbers::pi * normal_wavevector(n_binder, n, cosine).real() / wavelength_nm;
    double expected = 0;
    for (const double r12 : {std::norm(f.r_s), std::norm(f.r_p)}) {
        // The phases of the two inner reflections add to 0 or 2 pi; R = 1 - T.
        const double t2 = (1 - r12) * (1 - r12) / (1 - r12 * r12);
        double transmitted = t2;
        for (int m = 1; m < 60; ++m) {
            const double x = m * k * half_nm;
            transmitted += 2 * t2 * std::pow(r12, m) * std::cos(m * k * d_nm) * std::sin(x) / x;
        }
        expected += (1 - transmitted) / 2;
    }
    const Platelet platelet{{Material(n), d_nm, {sd_nm, Law::uniform}}, {}};
    const auto table =
        platelet_table(platelet, n_binder, std::vector{cosine}, std::vector{wavelength_nm});
    EXPECT_NEAR(table.reflectance[0], expected, 1e-7);
}

TEST(Platelet, LosslessFlakesConserveEnergy) {
    for (const double core_spread : {0.0, 60.0}) {
        const Platelet platelet{film("mica", 500, core_spread),
                                {film("ZrO2", 60, 5), film("SiO2", 90, 0)}};
        for (const auto& coat : platelet.coats) ASSERT_EQ(coat.material.index(400).imag(), 0);
        const auto table = platelet_table(platelet, 1.5, kTableCosines, kWavelengths);
        ASSERT_EQ(table.reflectance.size(), kTableCosines.size() * kWavelengths.size());
        for (std::size_t i = 0; i < table.reflectance.size(); ++i) {
            EXPECT_NEAR(table.reflectance[i] + table.transmittance[i], 1, 1e-12);
            EXPECT_GE(table.reflectance[i], 0);
            EXPECT_GE(table.transmittance[i], 0);
        }
    }
}

TEST(Platelet, AbsorbingFlakesLoseEnergyOnly) {
    for (const char* core : {"Al", "Fe2O3", "brass_Cu70Zn30"}) {
        const auto table = platelet_table({film(core, 100, 20), {film("Fe2O3", 60, 8)}}, 1.5,
                                          kTableCosines, kWavelengths);
        for (std::size_t i = 0; i < table.reflectance.size(); ++i) {
            EXPECT_GE(table.reflectance[i], 0);
            EXPECT_GE(table.transmittance[i], 0);
            EXPECT_LE(table.reflectance[i] + table.transmittance[i], 1 + 1e-12);
        }
    }
}

TEST(Platelet, WithoutSpreadIsOneStack) {
    const Platelet platelet{film("mica", 500, 0), {film("TiO2_anatase", 80, 0)}};
    const auto table = platelet_table(platelet, 1.5, kTableCosines, kWavelengths);
    for (std::size_t i = 0; i < kTableCosines.size(); ++i) {
        for (std::size_t j = 0; j < kWavelengths.size(); ++j) {
            const auto r = one_flake(platelet, {500, 80}, 1.5, kTableCosines[i], kWavelengths[j]);
            // At cos = 0 the table takes the limit at 1e-9.
            EXPECT_NEAR(table.reflectance[i * kWavelengths.size() + j], r.reflectance, 1e-7);
        }
    }
}

TEST(Platelet, MeanIsContinuousAsTheSpreadVanishes) {
    const auto narrow = platelet_table({film("mica", 500, 1e-4), {film("TiO2_anatase", 80, 1e-4)}},
                                       1.5, kTableCosines, kWavelengths);
    const auto none = platelet_table({film("mica", 500, 0), {film("TiO2_anatase", 80, 0)}}, 1.5,
                                     kTableCosines, kWavelengths);
    // At cos = .01 the resonances are so narrow that 1e-4 nm still counts a little.
    for (std::size_t i = kWavelengths.size(); i < none.reflectance.size(); ++i) {
        EXPECT_NEAR(narrow.reflectance[i], none.reflectance[i], 1e-6);
    }
}

TEST(Platelet, VanishesWithItsThickness) {
    const std::vector<double> cosines{.05, .5, 1};
    const auto table = platelet_table({film("mica", 0, 0), {film("TiO2_anatase", 0, 0)}}, 1.5,
                                      cosines, kWavelengths);
    for (double r : table.reflectance) EXPECT_NEAR(r, 0, 1e-12);
    for (double t : table.transmittance) EXPECT_NEAR(t, 1, 1e-12);
}

TEST(Platelet, ThickFrustratingCoatsLetNothingThrough) {
    // Beyond the critical angle of the coat 1 - |r_in|^2 falls below rounding.
    const Platelet platelet{film("mica", 300, 18, Law::uniform), {film("MgF2", 20000, 0)}};
    const std::vector<double> cosines{0, 1e-5, .01, .2};
    const auto table = platelet_table(platelet, 1.7, cosines, kWavelengths);
    for (std::size_t i = 0; i < table.reflectance.size(); ++i) {
        EXPECT_NEAR(table.reflectance[i], 1, 1e-12);
        EXPECT_NEAR(table.transmittance[i], 0, 1e-12);
    }
}

// The far side of a core that is opaque at all wavelengths of a block is left out: of the thicker one
// here. Through the thinner one 1e-11 of the amplitude pass.
TEST(Platelet, OpaqueCoresAreTheLimitOfThickOnes) {
    using Sides = Platelet::CoatedSides;
    for (const auto& [sides, face] : {std::pair(Sides::both, Platelet::Face::any),
                                      std::pair(Sides::one, Platelet::Face::coated),
                                      std::pair(Sides::one, Platelet::Face::bare)}) {
        for (std::size_t coats : {0, 1, 2}) {
            Platelet thin{.core = film("Al", 165, 0), .coats = {}};
            if (coats > 0) thin.coats.push_back(film("SiO2", 330, 15));
            if (coats > 1) thin.coats.push_back(film("Fe2O3", 25, 3));
            thin.coated_sides = sides;
            thin.face = face;
            Platelet thick = thin;
            thick.core.thickness_nm = 400;
            const auto expected = platelet_table(thin, 1.5, kTableCosines, kWavelengths);
            const auto table = platelet_table(thick, 1.5, kTableCosines, kWavelengths);
            EXPECT_GT(
                *std::max_element(expected.transmittance.begin(), expected.transmittance.end()), 0);
            for (std::size_t i = 0; i < table.reflectance.size(); ++i) {
                EXPECT_NEAR(table.reflectance[i], expected.reflectance[i], 1e-9);
                EXPECT_EQ(table.transmittance[i], 0);
                EXPECT_NEAR(expected.transmittance[i], 0, 1e-9);
            }
        }
    }
}

TEST(Platelet, RefusesWhatItCannotAverage) {
    const Platelet mica{film("mica", 500, 60), {}};
    const std::vector<double> one{1}, beyond{1.5}, visible{550}, infrared{2000};
    EXPECT_THROW(platelet_table(mica, 1.5, beyond, visible), DomainError);
    EXPECT_THROW(platelet_table(mica, Material(ComplexIndex(1.5, .1)), one, visible), DomainError);
    EXPECT_THROW(platelet_table({film("mica", -1, 0), {}}, 1.5, one, visible), DomainError);
    EXPECT_THROW(platelet_table({film("mica", 1, -1), {}}, 1.5, one, visible), DomainError);
    EXPECT_THROW(platelet_table({film("Al", 30, 0), {}}, 1.5, one, infrared), DomainError);
    Platelet wide = mica;
    for (int i = 0; i < 6; ++i) wide.coats.push_back(film("TiO2_anatase", 2000, 600));
    EXPECT_THROW(platelet_table(wide, 1.5, one, visible), DomainError);
}

// Films of wide spreads take up to a million combinations of thicknesses for each cosine.
TEST(Platelet, StopsAmongTheCombinationsOfThicknesses) {
    const Platelet platelet{film("mica", 500, 100),
                            {film("TiO2_anatase", 80, 5), film("SiO2", 300, 20)}};
    const auto table = [&](SharedProgress* work) {
        return platelet_table(platelet, 1.5, kTableCosines, kWavelengths, work).reflectance;
    };
    const Progress always = [](double) { return true; }, never = [](double) { return false; };
    SharedProgress going(always, 1), stopped(never, 1);
    EXPECT_EQ(table(&going), table(nullptr));
    stopped.add(0);
    EXPECT_THROW(table(&stopped), Stopped);
}

// The arithmetic is the same, but for the interfaces, which are found once.
TEST(Platelet, SingleOnesReflectAsTheirOwnTables) {
    Platelet kinds[] = {{film("mica", 500, 100), {film("Fe2O3", 70, 5)}},
                        {film("Al", 350, 40), {film("SiO2", 208, 6), film("Fe2O3", 20, 2)}},
                        {film("Al", 350, 40), {film("SiO2", 208, 6)}},
                        {film("SiO2", 400, 20), {}}};
    kinds[2].coated_sides = Platelet::CoatedSides::one;
    kinds[2].face = Platelet::Face::bare;
    const std::size_t size = kTableCosines.size() * kWavelengths.size();
    int cases = 0;
    for (const Platelet& kind : kinds) {
        std::vector<std::vector<double>> thicknesses;
        for (const double factor : {0.02, 0.8, 1.0, 1.3}) {  // aluminium of 7 nm lets light through
            std::vector<double>& films = thicknesses.emplace_back();
            films.push_back(factor * kind.core.thickness_nm);
            for (const FilmPopulation& coat : kind.coats) {
                films.push_back(coat.thickness_nm / factor);
            }
        }
        const auto all = platelet_reflectances(kind, thicknesses, 1.5, kTableCosines, kWavelengths);
        ASSERT_EQ(all.size(), thicknesses.size() * size);
        for (std::size_t i = 0; i < thicknesses.size(); ++i) {
            Platelet one = kind;
            one.core = {kind.core.material, thicknesses[i][0], {}};
            for (std::size_t c = 0; c < kind.coats.size(); ++c) {
                one.coats[c] = {kind.coats[c].material, thicknesses[i][c + 1], {}};
            }
            const auto expected = platelet_table(one, 1.5, kTableCosines, kWavelengths).reflectance;
            for (std::size_t k = 0; k < size; ++k, ++cases) {
                EXPECT_EQ(all[i * size + k], expected[k]);
            }
        }
    }
    EXPECT_EQ(cases, static_cast<int>(4 * 4 * size));
}

TEST(Platelet, SingleOnesNeedAThicknessOfEachFilm) {
    const Platelet coated{film("mica", 500, 100), {film("Fe2O3", 70, 5)}};
    for (const std::vector<double>& films :
         {std::vector<double>{500}, std::vector<double>{500, 70, 20},
          std::vector<double>{500, -1}}) {
        const std::vector<std::vector<double>> one = {films};
        EXPECT_THROW(platelet_reflectances(coated, one, 1.5, kTableCosines, kWavelengths),
                     DomainError);
    }
}

}  // namespace
}  // namespace nacre::optics
