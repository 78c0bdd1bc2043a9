#include "nacre/bsdf/flake_films.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "nacre/core/random.h"
#include "nacre/optics/thickness_rule.h"
#include "nacre/testing/statistics.h"

namespace nacre::bsdf {
namespace {

using Law = optics::ThicknessSpread::Law;

const std::vector<double> kGrid = {420, 460, 490, 530, 570, 610, 640, 690};
const Wavelengths kEight = {420, 460, 490, 530, 570, 610, 640, 690};

optics::Platelet pearl(optics::ThicknessSpread core, optics::ThicknessSpread coat) {
    optics::Platelet platelet;
    platelet.core = {optics::find_material("mica"), 500, core};
    platelet.coats = {{optics::find_material("TiO2_anatase"), 110, coat}};
    return platelet;
}

BoundFlakeFilms films_of(const optics::Platelet& platelet, double min_cosine = 0.7) {
    return FlakeFilms(platelet, optics::Material(1.5), kGrid, min_cosine)
        .bind(locate_wavelengths(kGrid, kEight));
}

std::uint32_t bits_of(int set, int sets) {
    return static_cast<std::uint32_t>((set + 0.5) / sets * 0x1p32);
}

TEST(FlakeFilms, RatiosAverageToOneEverywhere) {
    const BoundFlakeFilms films = films_of(pearl({60}, {20}));
    constexpr int kSets = FlakeFilms::kManyFilmsSet;
    for (const float cosine : {0.6f, 0.7f, 0.7531f, 0.9f, 0.99999f, 1.0f, 1.000001f}) {
        DoubleLanes sum{};
        for (int i = 0; i < kSets; ++i) {
            sum += to_double(films.ratio(cosine, bits_of(i, kSets)));
        }
        for (int lane = 0; lane < kLanes; ++lane) {
            EXPECT_NEAR(sum[lane] / kSets, 1, 1e-6);  // single precision
        }
    }
}

TEST(FlakeFilms, AllBitsFindASetAndAllSetsAreFound) {
    const BoundFlakeFilms films = films_of(pearl({}, {20}));
    std::set<float> found;
    Rng rng(1);
    for (int n = 0; n < 4000; ++n) found.insert(films.ratio(0.9f, rng.next_u32())[2]);
    found.insert(films.ratio(0.9f, 0)[2]);
    found.insert(films.ratio(0.9f, 0xffffffffu)[2]);
    EXPECT_EQ(found.size(), static_cast<std::size_t>(FlakeFilms::kOneFilmSet));
}

// Largest difference of E[R R'] / (E[R] E[R']) between the set and the thickness distribution, over
// the geometric mean of that at both wavelengths: the variance of flakes and the correlation of
// their colours.
double worst_second_moment(const optics::Platelet& platelet, double cosine) {
    const BoundFlakeFilms films = films_of(platelet);
    const int sets = static_cast<int>(representative_thicknesses_nm(platelet).size());
    // The distribution by Gauss-Legendre or Gauss-Hermite rules.
    DoubleLanes sum{};
    std::array<DoubleLanes, kLanes> products{};
    const auto core = optics::thickness_rule(platelet.core.thickness_nm, platelet.core.spread, 24);
    const auto coat =
        optics::thickness_rule(platelet.coats[0].thickness_nm, platelet.coats[0].spread, 24);
    for (std::size_t i = 0; i < core.weights.size(); ++i) {
        for (std::size_t j = 0; j < coat.weights.size(); ++j) {
            optics::Platelet one = platelet;
            one.core.thickness_nm = core.thickness_nm[i];
            one.coats[0].thickness_nm = coat.thickness_nm[j];
            one.core.spread = one.coats[0].spread = {};
            const auto table =
                optics::platelet_table(one, optics::Material(1.5), std::vector{cosine}, kGrid);
            const DoubleLanes r = load_lanes(table.reflectance.data());
            const double weight = core.weights[i] * coat.weights[j];
            sum += weight * r;
            for (int lane = 0; lane < kLanes; ++lane) products[lane] += weight * r[lane] * r;
        }
    }
    double worst = 0;
    for (int a = 0; a < kLanes; ++a) {
        for (int b = 0; b < kLanes; ++b) {
            double found = 0;
            for (int i = 0; i < sets; ++i) {
                const FloatLanes r = films.ratio(static_cast<float>(cosine), bits_of(i, sets));
                found += static_cast<double>(r[a]) * r[b] / sets;
            }
            const double expected = products[a][b] / (sum[a] * sum[b]);
            const double size = std::sqrt(products[a][a] * products[b][b]) / (sum[a] * sum[b]);
            worst = test::worse(worst, std::abs(found - expected) / size);
        }
    }
    return worst;
}

TEST(FlakeFilms, SpreadAndCorrelationAreThoseOfTheLaw) {
    for (const double cosine : {0.75, 1.0}) {
        for (const Law law : {Law::uniform, Law::normal}) {
            EXPECT_LT(worst_second_moment(pearl({}, {20, law}), cosine), FlakeFilms::kOneFilmError);
            EXPECT_LT(worst_second_moment(pearl({50, law}, {10, law}), cosine),
                      FlakeFilms::kManyFilmsError);
        }
    }
}

TEST(FlakeFilms, EachFilmTakesEachQuantileOfItsLawOnce) {
    optics::Platelet platelet = pearl({60}, {5});
    platelet.coats.push_back({optics::find_material("SiO2"), 90, {8}});
    platelet.coats.push_back({optics::find_material("TiO2_anatase"), 70, {}});
    const auto set = representative_thicknesses_nm(platelet);
    ASSERT_EQ(set.size(), static_cast<std::size_t>(FlakeFilms::kManyFilmsSet));
    std::set<double> core, first, second, joint;
    for (const std::vector<double>& films_nm : set) {
        ASSERT_EQ(films_nm.size(), 4u);
        core.insert(films_nm[0]);
        first.insert(films_nm[1]);
        second.insert(films_nm[2]);
        EXPECT_EQ(films_nm[3], 70);
        joint.insert((films_nm[0] > 500) + 2 * (films_nm[1] > 110) + 4 * (films_nm[2] > 90));
    }
    for (const auto* film : {&core, &first, &second}) {
        EXPECT_EQ(film->size(), static_cast<std::size_t>(FlakeFilms::kManyFilmsSet));
    }
    EXPECT_EQ(joint.size(), 8u);  // all combinations of thin and thick
    EXPECT_FALSE(FlakeFilms::vary(pearl({}, {})));
}

// The thickness of an opaque core shows nowhere, that of its coat or of a translucent core does.
TEST(FlakeFilms, OpaqueCoresOfAnyThicknessAreAlike) {
    const auto alike = [](double core_nm, optics::ThicknessSpread oxide) {
        optics::Platelet platelet;
        platelet.core = {optics::find_material("Al"), core_nm, {0.15 * core_nm}};
        platelet.coats = {{optics::find_material("Al2O3"), 10, oxide}};
        return FlakeFilms(platelet, optics::Material(1.5), kGrid, 0.7).alike();
    };
    EXPECT_TRUE(alike(400, {}));
    EXPECT_FALSE(alike(400, {3}));
    EXPECT_FALSE(alike(20, {}));
}

}  // namespace
}  // namespace nacre::bsdf
