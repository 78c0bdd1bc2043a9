#include "nacre/optics/particles.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/core/quadrature.h"
#include "nacre/optics/mie.h"
#include "nacre/testing/errors.h"

namespace nacre::optics {
namespace {

const std::vector<double> kGreenLight = {550};

// ------------------------------------------------------------------ structure factor

TEST(PercusYevick, ForwardsIsTheCompressibility) {
    for (double v : {0.01, 0.1, 0.3, 0.5}) {
        EXPECT_NEAR(percus_yevick(0, v), std::pow(1 - v, 4) / std::pow(1 + 2 * v, 2), 1e-13) << v;
    }
}

TEST(PercusYevick, IsOneWithoutNeighboursAndFarFromForwards) {
    for (double x : {0.0, 0.5, 3.0, 30.0}) EXPECT_EQ(percus_yevick(x, 0), 1);
    EXPECT_NEAR(percus_yevick(1000, 0.4), 1, 1e-4);
}

TEST(PercusYevick, FirstOrderInTheVolumeIsThatOfAnExcludedSphere) {
    // 1 - 24 v (sin x - x cos x)/x^3: one sphere keeps the others out of its double radius.
    constexpr double kVolume = 1e-5;
    for (double x : {0.3, 1.9, 2.1, 6.0, 15.0}) {
        const double excluded = 24 * (std::sin(x) - x * std::cos(x)) / (x * x * x);
        EXPECT_NEAR((1 - percus_yevick(x, kVolume)) / kVolume, excluded, 5e-3) << x;
    }
}

TEST(PercusYevick, ClosedFormMeetsTheIntegral) {
    for (double v : {0.05, 0.3, 0.5}) {
        EXPECT_NEAR(percus_yevick(2 - 1e-9, v), percus_yevick(2 + 1e-9, v), 1e-8) << v;
    }
}

TEST(PercusYevick, PeaksWhereNeighboursTouch) {
    // The first peak of the solution at v = 0.4, near 2 pi/d.            [kinning-thomas-1984]
    double best = 0, at = 0;
    for (double x = 1; x < 12; x += 0.01) {
        if (percus_yevick(x, 0.4) > best) best = percus_yevick(at = x, 0.4);
    }
    EXPECT_NEAR(at, 2 * std::numbers::pi, 0.5);
    EXPECT_GT(best, 1.5);
}

// ------------------------------------------------------------------ phase functions

std::vector<double> henyey_greenstein_series(double g) {
    std::vector<double> series;
    for (double power = 1; std::abs(power) > 1e-12; power *= g) series.push_back(power);
    return series;
}

TEST(PhaseFunction, TabulatesItsSeries) {
    const PhaseFunction phase({henyey_greenstein_series(0.5)});
    const double peak = phase.value(1, 0)[0];
    for (double c = -1; c <= 1; c += 0.013) {
        const double exact = 0.75 / (4 * std::numbers::pi * std::pow(1.25 - c, 1.5));
        EXPECT_NEAR(phase.value(c, 0)[0], exact, PhaseFunction::kTableError * peak) << c;
    }
}

TEST(PhaseFunction, IsAsSharpAsTheHenyeyGreensteinAboveIt) {
    EXPECT_NEAR(PhaseFunction({henyey_greenstein_series(0.8)}).sharpness(), 0.8, 1e-12);
    EXPECT_NEAR(PhaseFunction({{1.0}, {1.0, -0.3}}).sharpness(), 0.3, 1e-12);
    EXPECT_NEAR(PhaseFunction({{1, 0, 0.1}}).sharpness(), std::sqrt(0.1), 1e-12);  // Rayleigh's
    EXPECT_EQ(PhaseFunction(std::vector<std::vector<double>>{{1.0}}).sharpness(), 0);
}

TEST(PhaseFunction, PicksWavelengths) {
    const PhaseFunction phase({{1, 0.1}, {1, 0.2}, {1, 0.3, 0.05}});
    EXPECT_EQ(phase.at({2, 0}), PhaseFunction({{1, 0.3, 0.05}, {1, 0.1}}));
    EXPECT_EQ(phase.coefficient(2, 0), 0);
    EXPECT_EQ(phase.coefficient(2, 2), 0.05);
}

TEST(PhaseFunction, RefusesWhatIsNone) {
    const auto message = [](std::vector<std::vector<double>> series) {
        return test::message_of<DomainError>([&] { PhaseFunction{std::move(series)}; });
    };
    EXPECT_THAT(message({}), testing::HasSubstr("without wavelengths"));
    EXPECT_THAT(message({{0.5}}), testing::HasSubstr("chi_0 = 1"));
    EXPECT_THAT(message({{1, 1.5}}), testing::HasSubstr("chi_n"));
}

// ------------------------------------------------------------------ particles

Spheres rutile(double diameter_nm, double spread, Crowding crowding = Crowding::independent) {
    return {Material(2.75), diameter_nm, spread, DiameterWeighting::volume, crowding};
}

TEST(Particles, OfOneSizeScatterByTheirNumber) {
    const double volume = 0.02, d_um = 0.25, k_per_um = 2 * std::numbers::pi * 1.5 / 0.55;
    Spheres spheres = rutile(1e3 * d_um, 0);
    spheres.material = Material(ComplexIndex(2.5, 0.2));
    const ParticleOptics optics = particle_optics(spheres, volume, 1.5, kGreenLight);
    const MieEfficiencies e =
        MieSeries(k_per_um * d_um / 2, ComplexIndex(2.5, 0.2) / 1.5).efficiencies();
    // N pi d^2/4 = 3 v/(2 d)
    const double area_per_um = 1.5 * volume / d_um;
    EXPECT_NEAR(optics.scattering_per_um[0] / (area_per_um * e.scattering), 1, 1e-12);
    EXPECT_NEAR(optics.absorption_per_um[0] / (area_per_um * e.absorption()), 1, 1e-12);
    EXPECT_NEAR(optics.phase.coefficient(1, 0), e.asymmetry, 1e-12);
}

TEST(Particles, LegendreSeriesIsThePhaseFunctionOfMie) {
    const double x = std::numbers::pi * 300 * 1.5 / 550;
    const MieSeries series(x, 2.75 / 1.5);
    const ParticleOptics optics = particle_optics(rutile(300, 0), 0.01, 1.5, kGreenLight);
    const double whole = std::numbers::pi * x * x * series.efficiencies().scattering;
    for (int node = 0; node <= PhaseFunction::kIntervals; node += 64) {
        const double exact = series.intensity(PhaseFunction::node_cosine(node)) / whole;
        EXPECT_NEAR(optics.phase.row(node)[0], exact, 1e-4 * exact + 1e-8) << node;
    }
}

// Sums over very many sizes, by the trapezoidal rule, which converges geometrically here.
struct Sum {
    double scattering = 0, absorption = 0, forward = 0;
};
/// @param median_nm  by volume
Sum brute_force(const Spheres& s, double volume, double median_nm, double wavelength_nm) {
    constexpr int kSizes = 16000;
    const double k = 2 * std::numbers::pi * 1.5 / wavelength_nm;
    const ComplexIndex index = s.material.index(wavelength_nm) / 1.5;
    Sum sum;
    double law = 0;
    for (int i = 0; i <= kSizes; ++i) {
        const double t = kSpreadCut * (2.0 * i / kSizes - 1),
                     d = median_nm * std::exp(s.spread * t);
        const double weight = std::exp(-t * t / 2);
        const MieEfficiencies e = MieSeries(k * d / 2, index).efficiencies();
        law += weight;
        sum.scattering += weight * 1500 * volume / d * e.scattering;
        sum.absorption += weight * 1500 * volume / d * e.absorption();
        sum.forward += weight * 1500 * volume / d * e.scattering * e.asymmetry;
    }
    return {sum.scattering / law, sum.absorption / law, sum.forward / sum.scattering};
}

TEST(Particles, AveragesOverTheirSizes) {
    for (double spread : {0.1, 0.2, 0.3, 0.5}) {
        Spheres spheres = rutile(250, spread);
        spheres.material = Material(ComplexIndex(2.75, 0.02));
        const Sum sum = brute_force(spheres, 0.1, 250, 550);
        const ParticleOptics optics = particle_optics(spheres, 0.1, 1.5, kGreenLight);
        EXPECT_NEAR(optics.scattering_per_um[0] / sum.scattering, 1, kParticleError) << spread;
        EXPECT_NEAR(optics.absorption_per_um[0] / sum.absorption, 1, kParticleError) << spread;
        EXPECT_NEAR(optics.phase.coefficient(1, 0), sum.forward, kParticleError) << spread;
    }
}

// Without absorption resonances are as narrow as they can be; at 400 nm rutile has the highest index.
TEST(Particles, AveragesOverTheResonancesOfClearSpheres) {
    for (const auto& [wavelength_nm, index] :
         {std::pair{400.0, 3.13}, {440.0, 2.96}, {487.0, 2.84}, {550.0, 2.75}, {700.0, 2.64}}) {
        for (const double diameter_nm : {100.0, 250.0, 350.0, 500.0}) {
            for (const double spread : {0.05, 0.1, 0.3, 0.5}) {
                Spheres spheres = rutile(diameter_nm, spread);
                spheres.material = Material(index);
                const Sum sum = brute_force(spheres, 0.1, diameter_nm, wavelength_nm);
                const ParticleOptics optics =
                    particle_optics(spheres, 0.1, 1.5, std::vector{wavelength_nm});
                const auto where =
                    fmt::format("{} nm, {} nm, {}", wavelength_nm, diameter_nm, spread);
                EXPECT_NEAR(optics.scattering_per_um[0] / sum.scattering, 1, kParticleError)
                    << where;
                EXPECT_NEAR(optics.phase.coefficient(1, 0), sum.forward, kParticleError) << where;
            }
        }
    }
}

TEST(Particles, MediansByNumberAndByVolumeMeetAtHatchAndChoate) {
    Spheres by_number = rutile(200, 0.3);
    by_number.weighting = DiameterWeighting::number;
    const Spheres by_volume = rutile(200 * std::exp(3 * 0.09), 0.3);
    EXPECT_NEAR(particle_optics(by_number, 0.1, 1.5, kGreenLight).scattering_per_um[0] /
                    particle_optics(by_volume, 0.1, 1.5, kGreenLight).scattering_per_um[0],
                1, kParticleError);
}

TEST(Particles, CrowdingFadesWithDilution) {
    const double volume = 1e-4;
    const auto crowded =
        particle_optics(rutile(250, 0.2, Crowding::hard_spheres), volume, 1.5, kGreenLight);
    const auto alone = particle_optics(rutile(250, 0.2), volume, 1.5, kGreenLight);
    EXPECT_NEAR(crowded.scattering_per_um[0] / alone.scattering_per_um[0], 1, 8 * volume);
}

TEST(Particles, SmallParticlesCrowdByTheirCompressibility) {
    // Where q d -> 0 at every angle, each particle scatters S(0) of what it would alone.
    const auto crowded =
        particle_optics(rutile(5, 0, Crowding::hard_spheres), 0.2, 1.5, kGreenLight);
    const auto alone = particle_optics(rutile(5, 0), 0.2, 1.5, kGreenLight);
    EXPECT_NEAR(crowded.scattering_per_um[0] / alone.scattering_per_um[0],
                std::pow(0.8, 4) / std::pow(1.4, 2), 1e-3);
}

TEST(Particles, CrowdingTakesLightOutOfTheForwardLobe) {
    double before = 1e9;
    for (double volume : {0.01, 0.1, 0.2, 0.3}) {
        const auto crowded =
            particle_optics(rutile(250, 0.2, Crowding::hard_spheres), volume, 1.5, kGreenLight);
        const auto alone = particle_optics(rutile(250, 0.2), volume, 1.5, kGreenLight);
        EXPECT_LT(crowded.phase.coefficient(1, 0), alone.phase.coefficient(1, 0));
        EXPECT_EQ(crowded.absorption_per_um[0], alone.absorption_per_um[0]);
        // What hides: sigma_s (1 - g) per particle falls, by 5 to 20 % at 20 %.
        const double hiding =
            crowded.scattering_per_um[0] * (1 - crowded.phase.coefficient(1, 0)) / volume;
        EXPECT_LT(hiding, before);
        before = hiding;
        if (volume == 0.2) {
            const double lost = 1 - hiding / (alone.scattering_per_um[0] *
                                              (1 - alone.phase.coefficient(1, 0)) / volume);
            EXPECT_GT(lost, 0.05);
            EXPECT_LT(lost, 0.2);
        }
    }
}

TEST(Particles, OfTheBindersIndexVanish) {
    Spheres glass = rutile(1000, 0.2);
    glass.material = Material(1.5);
    const ParticleOptics optics = particle_optics(glass, 0.1, 1.5, kGreenLight);
    EXPECT_LT(optics.scattering_per_um[0], 1e-25);
    EXPECT_EQ(optics.absorption_per_um[0], 0);
}

// A pigment in the colours and amounts of paint: order of magnitude and rank as painters know them.
TEST(Particles, RutileHidesBestAtAQuarterMicrometre) {
    Spheres spheres = rutile(100, 0.25);
    spheres.material = find_material("TiO2_rutile");
    const auto hiding = [&](double diameter_nm) {
        spheres.diameter_nm = diameter_nm;
        const ParticleOptics o = particle_optics(spheres, 0.05, 1.5, kGreenLight);
        return o.scattering_per_um[0] * (1 - o.phase.coefficient(1, 0));
    };
    double best = 0, at = 0;
    for (double d = 100; d <= 600; d += 20) {
        if (hiding(d) > best) best = hiding(at = d);
    }
    EXPECT_GE(at, 200);
    EXPECT_LE(at, 320);
}

TEST(Particles, NameWhatIsOutOfRange) {
    const auto message = [](const Spheres& s, double volume, double wavelength, Material binder) {
        const std::vector<double> wavelengths{wavelength};
        return test::message_of<DomainError>(
            [&] { particle_optics(s, volume, binder, wavelengths); });
    };
    EXPECT_THAT(message(rutile(0.1, 0), 0.1, 550, 1.5), testing::HasSubstr("diameter_nm = 0.1"));
    EXPECT_THAT(message(rutile(250, 2), 0.1, 550, 1.5), testing::HasSubstr("spread = 2"));
    EXPECT_THAT(message(rutile(250, 0), 0.7, 550, 1.5),
                testing::HasSubstr("volume_fraction = 0.7: must be in (0, 0.5]"));
    EXPECT_THAT(message(rutile(250, 0), 0.1, 550, ComplexIndex(1.5, 0.1)),
                testing::HasSubstr("must not absorb"));
    Spheres oxide = rutile(250, 0);
    oxide.material = find_material("TiO2_rutile");
    EXPECT_THAT(message(oxide, 0.1, 400, 1.5), testing::HasSubstr("430"));
}

}  // namespace
}  // namespace nacre::optics
