#include "nacre/measure/difference.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "nacre/core/error.h"
#include "nacre/spectra/lab.h"

namespace nacre::measure {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

const std::vector<double> kGrid = {400, 450, 500, 550, 600, 650, 700};

Measurement spectral(double level, spectra::Illuminant illuminant = spectra::Illuminant::D65) {
    Measurement m{"spectral", {illuminant, spectra::Observer::cie1964_10deg, {}}, kGrid, {}};
    for (double aspecular : {15.0, 45.0, 110.0}) {
        std::vector<double> r;
        for (double nm : kGrid) r.push_back(level * nm / 700 * 30 / (15 + aspecular));
        m.readings.push_back(coloured(in_plane(45, aspecular), kGrid, r, m.conditions));
    }
    return m;
}

Measurement colours_only(Measurement m) {
    m.name = "colours";
    m.wavelengths_nm.clear();
    for (Reading& r : m.readings) r.reflectance_factor.clear();
    return m;
}

TEST(Difference, IsDeltaE2000AngleByAngle) {
    const Measurement a = spectral(0.5), b = spectral(0.6);
    const Difference d = difference(a, b);
    ASSERT_EQ(d.angles.size(), 3u);
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const AngleDifference& angle = d.angles[i];
        EXPECT_EQ(angle.delta_e_2000, spectra::delta_e_2000(a.readings[i].lab, b.readings[i].lab));
        EXPECT_DOUBLE_EQ(angle.delta_lab[0], b.readings[i].lab[0] - a.readings[i].lab[0]);
        sum += angle.delta_e_2000;
    }
    EXPECT_NEAR(d.mean_delta_e_2000, sum / 3, 1e-14 * sum);
    EXPECT_EQ(d.max_delta_e_2000, std::max({d.angles[0].delta_e_2000, d.angles[1].delta_e_2000,
                                            d.angles[2].delta_e_2000}));
    EXPECT_EQ(difference(a, a).max_delta_e_2000, 0);
}

TEST(Difference, SplitsIntoLightnessChromaAndHue) {
    // Delta E*ab^2 = Delta L*^2 + Delta C*^2 + Delta H*^2, by the definition of Delta H*.
    const AngleDifference angle{{}, {}, 0, 1, {50, 20, -30}, {57, -12, 8}};
    const double ab = std::hypot(32.0, 38.0);
    EXPECT_NEAR(std::hypot(angle.delta_chroma(), angle.delta_hue()), ab, 1e-12);
    // From red to yellow the hue angle grows.
    EXPECT_GT((AngleDifference{{}, {}, 0, 1, {50, 20, 1}, {50, 20, 3}}).delta_hue(), 0);
    EXPECT_LT((AngleDifference{{}, {}, 0, 1, {50, 20, 1}, {50, 20, -3}}).delta_hue(), 0);
    // Opposite hues and grey: no division by zero.
    EXPECT_NEAR((AngleDifference{{}, {}, 0, 1, {50, 20, 0}, {50, -5, 0}}).delta_hue(), 20, 1e-12);
    // Opposite hues whose products round.
    EXPECT_NEAR((AngleDifference{{}, {}, 0, 1, {50, 5, 5}, {50, -5, -5}}).delta_hue(),
                2 * std::sqrt(50.0), 1e-12);
    EXPECT_EQ((AngleDifference{{}, {}, 0, 1, {50, 20, 0}, {50, 0, 0}}).delta_hue(), 0);
}

TEST(Difference, WeighsTheMeanByName) {
    const Measurement a = spectral(0.5), b = spectral(0.6);
    const Difference even = difference(a, b);
    const Difference one = difference(a, b, {{"45as15", 0}, {"45as110", 0}});
    EXPECT_DOUBLE_EQ(one.mean_delta_e_2000, even.angles[1].delta_e_2000);
    EXPECT_EQ(one.max_delta_e_2000, even.max_delta_e_2000);
    EXPECT_THAT(
        [&] {
            difference(a, b, {{"45as25", 1}});
        },
        ThrowsMessage<DomainError>(HasSubstr("45as25")));
    EXPECT_THROW(difference(a, b, {{"45as15", -1}}), DomainError);
    EXPECT_THROW(difference(a, b, {{"45as15", NAN}}), DomainError);
    EXPECT_THROW(difference(a, b, {{"45as15", 0}, {"45as45", 0}, {"45as110", 0}}), DomainError);
}

TEST(Difference, ComparesTheGeometriesThatBothHave) {
    const Measurement a = spectral(0.5);
    Measurement b = spectral(0.6);
    b.readings.erase(b.readings.begin());
    std::swap(b.readings[0], b.readings[1]);
    b.readings[0].geometry.name = "far";  // compared by directions, not names
    const Difference d = difference(a, b);
    ASSERT_EQ(d.angles.size(), 2u);
    EXPECT_EQ(d.angles[0].geometry.name, "45as45");
    EXPECT_EQ(d.angles[1].geometry.name, "45as110");
    EXPECT_EQ(difference(a, b, {{"far", 3}}).angles[1].weight, 3);
    b.readings.clear();
    EXPECT_THAT([&] { difference(a, b); },
                ThrowsMessage<DomainError>(HasSubstr("no geometry in common")));
}

TEST(Difference, TakesTheNearestOfGeometriesWithinATenthOfADegree) {
    const Measurement a = spectral(0.5);
    Measurement b = spectral(0.6);
    b.readings[0].geometry = in_plane(45, 15.06);
    b.readings.push_back(a.readings[0]);
    b.readings.back().geometry = in_plane(45, 15.01);
    EXPECT_EQ(difference(a, b).angles[0].delta_e_2000, 0);
}

TEST(Difference, ConvertsWhicheverHasSpectraToTheOthersLight) {
    const Measurement day = spectral(0.5), lamp = spectral(0.6, spectra::Illuminant::A);
    // To the standard's light if the sample has spectra ...
    EXPECT_NEAR(difference(day, lamp).mean_delta_e_2000,
                difference(day, spectral(0.6)).mean_delta_e_2000, 1e-12);
    EXPECT_NEAR(difference(colours_only(day), lamp).mean_delta_e_2000,
                difference(day, spectral(0.6)).mean_delta_e_2000, 1e-12);
    // ... else to the sample's.
    const Difference other = difference(day, colours_only(lamp));
    EXPECT_EQ(other.conditions.illuminant, spectra::Illuminant::A);
    EXPECT_NEAR(other.mean_delta_e_2000,
                difference(spectral(0.5, spectra::Illuminant::A), lamp).mean_delta_e_2000, 1e-12);
    EXPECT_THAT([&] { difference(colours_only(day), colours_only(lamp)); },
                ThrowsMessage<DomainError>(HasSubstr("neither has spectra")));
}

}  // namespace
}  // namespace nacre::measure
