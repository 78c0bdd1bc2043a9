#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/core/random.h"
#include "nacre/fit/drawdown.h"
#include "nacre/spectra/lab.h"
#include "nacre/spectra/xyz.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/h_function.h"

// A pigment's coefficients from its tints in a known white.

namespace nacre::fit {
namespace {

using nacre::test::message_of;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::vector<double> kTint_nm = {430, 550, 620};
const auto kTintGeometry = DrawdownGeometry::diffuse_8_included;

/// A pigment whose absorption goes from weak to strong.
paint::PigmentCoefficients tinter(std::vector<double> scattering_per_mm = {600, 400, 300}) {
    return {spectra::Spectrum(kTint_nm, std::move(scattering_per_mm)),
            spectra::Spectrum(kTint_nm, {100.0, 1500.0, 6000.0})};
}

/// Scatters as rutile does, and absorbs a trace.
paint::Pigment white() { return {paint::PigmentCoefficients{20000.0, 3.0, 0.5}, "white"}; }

struct Tint {
    double pigment, white;  ///< volume fractions
};

/// An opaque layer of these.
DrawdownReading tinted(const Tint& tint, const paint::PigmentCoefficients& pigment,
                       const std::vector<double>& wavelengths_nm = kTint_nm) {
    paint::Recipe recipe;
    recipe.binder = optics::Material(1.5);
    paint::Layer& layer = recipe.layers.emplace_back();
    layer.thickness_um = kOpaqueThickness_um;
    const auto add = [&](paint::PigmentCoefficients coefficients, double volume) {
        if (volume == 0) return;
        coefficients.amount = paint::PigmentVolume{volume};
        layer.pigments.push_back({coefficients});
    };
    add(pigment, tint.pigment);
    add(std::get<paint::PigmentCoefficients>(white().body), tint.white);
    return {"",           0,
            tint.pigment, drawdown_reflectance(recipe, wavelengths_nm, kTintGeometry),
            tint.white,   true};
}

Drawdown ladder(const std::vector<Tint>& tints,
                const paint::PigmentCoefficients& pigment = tinter()) {
    Drawdown out{kTint_nm, {}};
    for (const Tint& tint : tints) out.readings.push_back(tinted(tint, pigment));
    return out;
}

DrawdownSettings in_white(std::optional<double> noise = {}) {
    return {.geometry = kTintGeometry, .noise = noise, .white = white()};
}

void add_noise(Drawdown& drawdown, double deviation, std::uint64_t seed) {
    Rng rng(seed);
    for (DrawdownReading& reading : drawdown.readings) {
        for (double& value : reading.reflectance) {
            // Twelve uniform numbers less six: nearly normal, of variance 1.
            double normal = -6;
            for (int k = 0; k < 12; ++k) normal += rng.uniform_double();
            value = std::max(0.0, value + deviation * normal);
        }
    }
}

const std::vector<Tint> kLadder = {
    {0.001, 0.15}, {0.005, 0.15}, {0.02, 0.1}, {0.1, 0.02}, {0.1, 0}};

TEST(Tints, OfALadderGiveTheCoefficientsThatTheyWereMadeFrom) {
    const PigmentEstimate estimate = estimate_pigment(ladder(kLadder), in_white());
    for (std::size_t i = 0; i < kTint_nm.size(); ++i) {
        const double s = tinter().scattering_per_mm(kTint_nm[i]);
        const double a = tinter().absorption_per_mm(kTint_nm[i]);
        EXPECT_NEAR(estimate.scattering_per_mm[i], s, 5e-3 * s) << i;
        EXPECT_NEAR(estimate.absorption_per_mm[i], a, 2e-3 * a) << i;
    }
    EXPECT_LT(estimate.rms_residual, 1e-4);
    EXPECT_FALSE(estimate.scattering_assumed);
    EXPECT_EQ(estimate.residuals[0].place_text(), " in 15 % white");
    EXPECT_EQ(estimate.residuals[0].thickness_text(), "opaque");
    // A tint that was not among them reads within a Delta E of 0.1, by its coefficients to five digits.
    const Tint other{0.01, 0.2};
    const paint::Pigment found = estimate.pigment("found", 0);
    const auto lab = [](const DrawdownReading& reading) {
        const auto light = spectra::Illuminant::D65;
        const auto eye = spectra::Observer::cie1964_10deg;
        return spectra::xyz_to_lab(
            spectra::reflectance_to_xyz(spectra::Spectrum(kTint_nm, reading.reflectance), light,
                                        eye),
            spectra::white_point(light, eye));
    };
    EXPECT_LT(
        spectra::delta_e_2000(lab(tinted(other, tinter())),
                              lab(tinted(other, std::get<paint::PigmentCoefficients>(found.body)))),
        0.1);
}

// Over black as well, a thin one, in one table.
TEST(Tints, MayStandBesideDrawdowns) {
    Drawdown both = ladder({{0.002, 0.15}});
    paint::Recipe thin;
    thin.binder = optics::Material(1.5);
    thin.substrate_reflectance = 0.02;
    thin.layers.push_back({15, {}, {}});
    both.readings.push_back({"black", 0, 0, drawdown_reflectance(thin, kTint_nm, kTintGeometry)});
    paint::PigmentCoefficients pigment = tinter();
    pigment.amount = paint::PigmentVolume{0.01};
    thin.layers[0].pigments.push_back({pigment});
    both.readings.push_back(
        {"black", 15, 0.01, drawdown_reflectance(thin, kTint_nm, kTintGeometry)});
    const PigmentEstimate estimate = estimate_pigment(both, in_white());
    EXPECT_NEAR(estimate.absorption_per_mm[1], 1500, 3);
    EXPECT_NEAR(estimate.scattering_per_mm[0], 600, 30);
}

// One ratio of pigment to white tells one number.
TEST(Tints, OfOneRatioGiveAbsorptionAlone) {
    const paint::PigmentCoefficients dye = tinter({0, 0, 0});
    const PigmentEstimate one = estimate_pigment(ladder({{0.002, 0.1}}, dye), in_white(1e-3));
    // Twice as much of both hides no more: the same ratio.
    const PigmentEstimate two =
        estimate_pigment(ladder({{0.002, 0.1}, {0.004, 0.2}}, dye), in_white(1e-3));
    for (const PigmentEstimate& estimate : {one, two}) {
        EXPECT_TRUE(estimate.scattering_assumed);
        EXPECT_EQ(estimate.absorption_only_nm, kTint_nm);
        for (std::size_t i = 0; i < kTint_nm.size(); ++i) {
            const double a = dye.absorption_per_mm(kTint_nm[i]);
            EXPECT_NEAR(estimate.absorption_per_mm[i], a, 1e-3 * a) << i;
            EXPECT_EQ(estimate.scattering_per_mm[i], 0);
            EXPECT_TRUE(std::isinf(*estimate.scattering_error[i]));
            EXPECT_GT(*estimate.absorption_error[i], 0);
            EXPECT_LT(*estimate.absorption_error[i], 0.1 * a);
        }
    }
    // Of a pigment that scatters, what is left out is the mixture's K/S times its own S/K.
    const PigmentEstimate real = estimate_pigment(ladder({{0.002, 0.1}}), in_white(1e-3));
    for (std::size_t i = 0; i < kTint_nm.size(); ++i) {
        const double a = tinter().absorption_per_mm(kTint_nm[i]);
        const double s = tinter().scattering_per_mm(kTint_nm[i]);
        const double left_out = (3 * 0.1 + a * 0.002) / (10000 * 0.1 + s * 0.002) * s / a;
        EXPECT_LT(left_out, 0.004);
        EXPECT_NEAR(real.absorption_per_mm[i], a * (1 - left_out), 5e-4 * a) << i;
    }
}

// In much white only absorption shows; the masstone tells scattering.
TEST(Tints, SayWhereScatteringIsNotTold) {
    constexpr double kNoise = 5e-4;
    const std::vector<Tint> weak = {{0.0005, 0.15}, {0.001, 0.15}, {0.003, 0.15}};
    const PigmentEstimate without = estimate_pigment(ladder(weak), in_white(kNoise));
    EXPECT_EQ(without.absorption_only_nm, kTint_nm);
    std::vector<Tint> more = weak;
    more.push_back({0.1, 0});
    const PigmentEstimate with = estimate_pigment(ladder(more), in_white(kNoise));
    EXPECT_THAT(with.absorption_only_nm, IsEmpty());
    for (std::size_t i = 0; i < kTint_nm.size(); ++i) {
        EXPECT_GT(*without.scattering_error[i], 5 * *with.scattering_error[i]);
        EXPECT_LT(*with.absorption_error[i], 0.1 * with.absorption_per_mm[i]);
    }
}

TEST(Tints, StandardErrorsAreThoseOfRepeatedReadings) {
    constexpr int kRepeats = 6;
    constexpr double kNoise = 0.001;
    Drawdown exact{{430, 550}, {}};  // those that are asked below
    for (const Tint& tint : {Tint{0.005, 0.15}, Tint{0.1, 0.02}, Tint{0.1, 0}}) {
        exact.readings.push_back(tinted(tint, tinter(), exact.wavelengths_nm));
    }
    double z2 = 0;
    for (int repeat = 0; repeat < kRepeats; ++repeat) {
        Drawdown noisy = exact;
        add_noise(noisy, kNoise, 50 + static_cast<std::uint64_t>(repeat));
        const PigmentEstimate estimate = estimate_pigment(noisy, in_white(kNoise));
        z2 += std::pow((estimate.scattering_per_mm[0] - 600) / *estimate.scattering_error[0], 2);
        z2 += std::pow((estimate.absorption_per_mm[1] - 1500) / *estimate.absorption_error[1], 2);
    }
    // Chi square with 12 degrees of freedom, between its quantiles of 0.0005 and 0.9995.
    EXPECT_GT(z2, 2.21);
    EXPECT_LT(z2, 34.8);
}

/// Of light that comes in at a cosine, what a half space of isotropic scatterers of albedo w without a
/// surface sends back in all directions: 1 - H(mu) sqrt(1 - w).      [chandrasekhar-1960, chapter V]
double half_space_albedo(double w, double mu) {
    const nacre::test::HFunction h([w](double) { return w / 2; });
    return 1 - h(mu) * std::sqrt(1 - w);
}

// Readings in closed form, of mixtures whose coefficients are added.                  [duncan-1940]
TEST(Tints, OfHalfSpacesInClosedFormGiveTheirCoefficients) {
    const paint::PigmentCoefficients of_white{5000.0, 4.0}, of_pigment{300.0, 700.0};
    DrawdownSettings settings = in_white();
    settings.geometry = DrawdownGeometry::diffuse_8_excluded;
    settings.binder = optics::Material(1.0);
    settings.white = paint::Pigment{of_white};
    Drawdown mixed{{550}, {}};
    for (const Tint& tint : {Tint{0.002, 0.1}, Tint{0.02, 0.1}, Tint{0.1, 0.02}, Tint{0.1, 0}}) {
        const double scattering = 5000 * tint.white + 300 * tint.pigment;
        const double absorption = 4 * tint.white + 700 * tint.pigment;
        const double w = scattering / (scattering + absorption);
        mixed.readings.push_back({"",
                                  0,
                                  tint.pigment,
                                  {half_space_albedo(w, std::cos(8 * std::numbers::pi / 180))},
                                  tint.white,
                                  true});
    }
    const PigmentEstimate estimate = estimate_pigment(mixed, settings);
    EXPECT_NEAR(estimate.absorption_per_mm[0], 700, 0.002 * 700);
    EXPECT_NEAR(estimate.scattering_per_mm[0], 300, 0.01 * 300);
    EXPECT_LT(estimate.rms_residual, 1e-4);
}

// So thick a layer is opaque: another ground changes nothing.
TEST(Tints, AnOpaqueLayerHidesItsGround) {
    paint::Recipe recipe;
    recipe.binder = optics::Material(1.5);
    recipe.layers.push_back({kOpaqueThickness_um, {}, {white()}});
    auto& body = std::get<paint::PigmentCoefficients>(recipe.layers[0].pigments[0].body);
    body.amount = paint::PigmentVolume{0.05};
    body.absorption_per_mm = 0.0;  // the least opaque
    recipe.substrate_reflectance = 0.0;
    const double over_black = drawdown_reflectance(recipe, {550}, kTintGeometry)[0];
    recipe.substrate_reflectance = 1.0;
    EXPECT_NEAR(over_black, drawdown_reflectance(recipe, {550}, kTintGeometry)[0], 1e-4);
    EXPECT_GT(over_black, 0.999);
}

TEST(Tints, RefuseWhatCannotBe) {
    const auto refused = [](const Drawdown& drawdown, const DrawdownSettings& settings) {
        return message_of<DomainError>([&] { estimate_pigment(drawdown, settings); });
    };
    const Drawdown tint{{550}, {{"", 0, 0.01, {0.5}, 0.1, true}}};
    EXPECT_THAT(refused(tint, {}), HasSubstr("nothing says which white"));
    Drawdown masstone{{550}, {{"", 0, 0.01, {0.5}, 0, true}, {"", 0, 0.1, {0.5}, 0, true}}};
    EXPECT_THAT(refused(masstone, in_white()), HasSubstr("no reading is a tint"));
    EXPECT_THAT(refused(masstone, {}), HasSubstr("or in tints of white"));
    const Drawdown alone{{550}, {{"", 0, 0, {0.9}, 0.1, true}}};
    EXPECT_THAT(refused(alone, in_white()), HasSubstr("cannot tell scattering"));
    const Drawdown full{{550}, {{"", 0, 0.01, {0.5}, 0.7, true}}};
    EXPECT_THAT(refused(full, in_white()),
                HasSubstr("white_volume_fraction = 0.7: must be in (0, 0.5]"));
    const Drawdown none{{550}, {{"", 0, 0, {0.5}, 0, true}, {"", 0, 0.1, {0.5}, 0.1, true}}};
    EXPECT_THAT(refused(none, in_white()), HasSubstr("volume_fraction = 0: must be in (0, 0.5]"));
}

}  // namespace
}  // namespace nacre::fit
