#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "nacre/core/file.h"
#include "nacre/measure/measurement.h"
#include "nacre/nacre.h"

// The recipes that ship, against what is published of such paints: docs/effect-pigments.md has the
// statements with their sources. Most are words, of colours and of their order; numbers of panels hardly
// exist.

namespace nacre {
namespace {

/// The hue families of Munsell and their ends in CIELAB hue, deg, where the next one begins: value 5,
/// chroma 8, under illuminant C [newhall-1943]. By colour-science 0.4.7: colour.XYZ_to_Lab of
/// colour.notation.munsell.munsell_colour_to_xyY("10R 5/8"). Over values of 4 to 8 and chromas of 4 to 10
/// they move by up to 5 deg, that between blue and green-blue by up to 7.
struct Family {
    const char* name;
    double end_deg;
};
constexpr std::array<Family, 10> kFamilies = {{{"R", 45.1},
                                               {"YR", 77.6},
                                               {"Y", 101.3},
                                               {"GY", 139.8},
                                               {"G", 174.6},
                                               {"BG", 208.7},
                                               {"B", 251.7},
                                               {"PB", 299.5},
                                               {"P", 333.3},
                                               {"RP", 371.5}}};

std::string family_of(double hue_deg) {
    const double first = kFamilies.back().end_deg - 360;
    const double hue = hue_deg < first ? hue_deg + 360 : hue_deg;
    for (const Family& family : kFamilies) {
        if (hue < family.end_deg) return family.name;
    }
    return "none";
}

/// What a paint has no hue below, in words: silver, white.
constexpr double kNeutralChroma = 16;

struct Look {
    double lightness, chroma, hue_deg;
    /// N without a hue.
    std::string family() const { return chroma < kNeutralChroma ? "N" : family_of(hue_deg); }
};

Paint shipped(const std::string& name) { return open(shipped_file("paints/" + name + ".toml")); }

Measurement readings(const Paint& paint, const std::string& where = "byk-mac") {
    return paint.measure(geometries(where)).measurement;
}

std::vector<Look> looks(const Measurement& measurement) {
    std::vector<Look> all;
    for (const measure::Reading& r : measurement.readings) {
        all.push_back({r.lab[0], measure::chroma(r.lab), measure::hue_deg(r.lab)});
    }
    return all;
}

Look look(const Paint& paint, const std::string& where) { return looks(readings(paint, where))[0]; }

double flop(const Paint& paint) { return *measure::flop_index(readings(paint)); }

/// As [mycolordoc-2026] says it, 17 is the top of "very high"; the recipes go a tenth beyond.
constexpr double kVeryHighFlop = 17, kHighest = 1.1 * kVeryHighFlop;

TEST(PublishedColours, FlopIndicesAreThoseOfSolidAndOfSprayedEffectPaints) {
    for (const char* name : {"white", "tinted-grey", "red-oxide", "solid-red"}) {
        EXPECT_LT(flop(shipped(name)), 0.5) << name;  // "0 for a solid colour"
    }
    for (const char* name : {"metallic-silver",
                             "satin-silver",
                             "blue-metallic",
                             "black-pearl",
                             "effect-pigments/aluminium-corn-flake",
                             "effect-pigments/aluminium-silver-dollar",
                             "effect-pigments/bronze",
                             "effect-pigments/pearl-silver-white",
                             "effect-pigments/pearl-gold",
                             "effect-pigments/pearl-blue",
                             "effect-pigments/pearl-green",
                             "effect-pigments/pearl-bronze",
                             "effect-pigments/pearl-combination-gold",
                             "effect-pigments/synthetic-mica-blue",
                             "effect-pigments/alumina-white",
                             "effect-pigments/glass-flake",
                             "effect-pigments/silver-glass-flake",
                             "effect-pigments/bismuth-oxychloride",
                             "effect-pigments/graphite",
                             "effect-pigments/silica-colour-travel",
                             "effect-pigments/chromium-colour-shift",
                             "effect-pigments/iron-oxide-colour-travel"}) {
        const double index = flop(shipped(name));
        EXPECT_GT(index, 10) << name;
        EXPECT_LT(index, kHighest) << name;
    }
    // "High travel" [sun-chemical-2026]: beyond the sprayed ones, by as much as another very high flop at most.
    const double pvd = flop(shipped("effect-pigments/aluminium-pvd"));
    EXPECT_GT(pvd, kHighest);
    EXPECT_LT(pvd, 2 * kVeryHighFlop);
}

// These lie flatter than a gun leaves flakes, by the comparison that they belong to or so that their
// colour is seen; docs/paints.md says so. As sprayed they have the flop of others.
TEST(PublishedColours, PaintsOfFlatterFlakesHaveTheFlopOfOthersWhereTheyAreTiltedLikeThem) {
    constexpr double kSprayed = 0.16;
    for (const char* name : {"candy-red", "metallic-gray", "tio2-mica-80", "green-violet"}) {
        const Paint flat = shipped(name);
        EXPECT_GT(flop(flat), 25) << name;
        const double index = flop(flat.with("orientation.alpha", kSprayed));
        EXPECT_GT(index, 10) << name;
        EXPECT_LT(index, kHighest) << name;
    }
}

// Eckart: the coarser and rounder a pigment, the more light it reflects, and the more flop; the finer and
// the less regular, the more it scatters, and the whiter is its flop. Sun Chemical: high travel of flakes
// from a vacuum.
TEST(PublishedColours, AluminiumIsBrighterAndFlopsMoreTheCoarserAndRounderItIs) {
    struct Aluminium {
        double near_gloss, away, flop;
    };
    const auto read = [](const Paint& paint) {
        const Measurement m = readings(paint);
        return Aluminium{m.readings[1].lab[0], m.readings.back().lab[0], *measure::flop_index(m)};
    };
    const Paint corn_flake = shipped("effect-pigments/aluminium-corn-flake");
    const auto of_diameter = [&](double um) {
        return read(corn_flake.with("diameter_um", um).with("diameter_spread_um", um / 2));
    };
    const std::vector<std::vector<Aluminium>> orders = {
        {of_diameter(7), of_diameter(14), of_diameter(28)},
        {read(corn_flake), read(shipped("effect-pigments/aluminium-silver-dollar")),
         read(shipped("effect-pigments/aluminium-pvd"))}};
    for (const std::vector<Aluminium>& order : orders) {
        for (std::size_t i = 1; i < order.size(); ++i) {
            EXPECT_GT(order[i].near_gloss, order[i - 1].near_gloss) << i;
            EXPECT_LT(order[i].away, order[i - 1].away) << i;
            EXPECT_GT(order[i].flop, order[i - 1].flop) << i;
        }
    }
}

/// Reflectance factors at 550 nm.
std::vector<double> at_550_nm(const std::string& recipe, const std::string& where) {
    std::vector<double> factors;
    const Readings read =
        shipped(recipe).measure(geometries(where), {.wavelengths_nm = {550, 600}});
    for (const measure::Reading& r : read.measurement.readings) {
        factors.push_back(r.reflectance_factor[0]);
    }
    return factors;
}

// "Mirror, liquid metal or chrome-like", of "strong image clarity combined with high travel"
// [sun-chemical-2026]. Liquid metal has light from ten degrees about the mirror direction in one patch.
// The mirror tells it from what lies ten degrees further, and turns black.
TEST(PublishedColours, FlakesFromAVacuumAreLiquidMetalOrChrome) {
    const std::string where = "45as2,45as10,45as15,45as45";
    const std::vector<double> liquid = at_550_nm("effect-pigments/aluminium-pvd", where);
    EXPECT_GT(liquid[1], 0.5 * liquid[0]);
    const std::vector<double> chrome = at_550_nm("effect-pigments/aluminium-pvd-chrome", where);
    EXPECT_LT(chrome[1], 0.2 * chrome[0]);
    EXPECT_GT(chrome[0], 5 * liquid[0]);
    EXPECT_GT(chrome[2], 0.5);
    EXPECT_LT(chrome[3], 0.005);
    EXPECT_LT(chrome[3], 0.05 * liquid[3]);
}

// The lobe of the mirror is the narrowest that ships, hence the hardest to solve: against random walks,
// within four of their standard errors, besides the 1e-5 of the peak by which the tail may be off
// (docs/solver.md, alpha = 0.02 to 0.05).
TEST(PublishedColours, TheMirrorIsWhatWalksFind) {
    const Paint chrome = shipped("effect-pigments/aluminium-pvd-chrome");
    const std::vector<Geometry> where =
        geometries("45as2,45as5,45as10,45as15,45as25,45as45,70as15");
    const std::vector<double> wavelengths = {450, 650};
    const Readings walks = chrome.measure(where, {.model = WalkModel{},
                                                  .wavelengths_nm = wavelengths,
                                                  .walks = std::uint64_t{1} << 17,
                                                  .seed = 45});
    const Measurement solved = chrome.measure(where, {.wavelengths_nm = wavelengths}).measurement;
    const double peak = solved.readings[0].reflectance_factor[0];
    ASSERT_EQ(walks.standard_error.size(), where.size());
    for (std::size_t i = 0; i < where.size(); ++i) {
        for (std::size_t k = 0; k < wavelengths.size(); ++k) {
            EXPECT_NEAR(solved.readings[i].reflectance_factor[k],
                        walks.measurement.readings[i].reflectance_factor[k],
                        4 * walks.standard_error[i][k] + 1e-5 * peak)
                << i << " " << wavelengths[k];
        }
    }
}

// Graphite and micaceous iron oxide are grey with a metallic sheen [micaceous-haematite-2026], darker than
// any metal; silvered glass is the brightest of what glitters.
TEST(PublishedColours, MineralsAreDarkGreyMetalsAndSilveredGlassIsBright) {
    const Look metal = look(shipped("effect-pigments/aluminium-corn-flake"), "45as15");
    for (const char* name : {"effect-pigments/graphite", "effect-pigments/micaceous-iron-oxide"}) {
        const Paint mineral = shipped(name);
        const std::vector<Look> seen = looks(readings(mineral, "45as15,45as45"));
        for (const Look& at : seen) EXPECT_EQ(at.family(), "N") << name;
        EXPECT_LT(seen[0].lightness, metal.lightness - 30) << name;
        EXPECT_GT(flop(mineral), 5) << name;
    }
    const Look silvered = look(shipped("effect-pigments/silver-glass-flake"), "45as15");
    EXPECT_GT(silvered.lightness,
              look(shipped("effect-pigments/glass-flake"), "45as15").lightness + 10);
    EXPECT_LT(silvered.chroma, 3);
}

// Colours by the names that makers give them, near the gloss. [perales-2011] found lightnesses above 100
// among 91 such samples; so have the brightest of these.
TEST(PublishedColours, PearlsHaveTheHuesOfTheirNames) {
    struct Named {
        const char* recipe;
        const char* family;
    };
    int brighter_than_white = 0;
    for (const Named& named :
         {Named{"pearl-silver-white", "N"}, Named{"pearl-gold", "Y"}, Named{"pearl-blue", "PB"},
          Named{"pearl-green", "G"}, Named{"pearl-bronze", "YR"},
          Named{"pearl-combination-gold", "Y"}, Named{"synthetic-mica-blue", "PB"},
          Named{"alumina-white", "N"}, Named{"glass-flake", "N"}, Named{"bronze", "Y"},
          Named{"aluminium-silver-dollar", "N"}, Named{"silver-glass-flake", "N"},
          Named{"aluminium-pvd", "N"}, Named{"aluminium-pvd-chrome", "N"}}) {
        const Look seen = look(shipped(fmt::format("effect-pigments/{}", named.recipe)), "45as15");
        EXPECT_EQ(seen.family(), named.family) << named.recipe << " " << seen.hue_deg;
        brighter_than_white += seen.lightness > 100;
    }
    EXPECT_GE(brighter_than_white, 4);
}

// Over white, away from the gloss, a pearl shows what it does not reflect.
TEST(PublishedColours, OverWhitePearlsTurnToTheComplementaryColour) {
    for (const char* name : {"pearl-blue", "pearl-gold", "pearl-green"}) {
        const Paint white =
            shipped(fmt::format("effect-pigments/{}", name)).with("substrate.reflectance", 0.9);
        const std::vector<Look> seen = looks(readings(white, "45as15,45as75"));
        const double apart = std::abs(std::remainder(seen[1].hue_deg - seen[0].hue_deg, 360));
        EXPECT_GT(apart, 150) << name;
        EXPECT_GT(seen[1].chroma, 8) << name;
    }
    // Where iron oxide absorbs what the titania does not reflect, gold stays between yellow and bronze.
    const Paint both =
        shipped("effect-pigments/pearl-combination-gold").with("substrate.reflectance", 0.9);
    for (const Look& seen : looks(readings(both))) {
        EXPECT_GT(seen.hue_deg, kFamilies[0].end_deg);
        EXPECT_LT(seen.hue_deg, kFamilies[2].end_deg);
        EXPECT_GT(seen.chroma, 30);
    }
}

/// As light meets the flakes more and more aslant, at 9, 14, 21, 24 and 33 deg; at 36 and 40 deg.
constexpr const char *kToGloss = "15as15,45as45,45as25,45as15,45as-15", *kAslant = "60as-15,80as-5";

/// The families in the order in which they come, each once.
std::vector<std::string> travel(const std::string& name, const std::string& where) {
    std::vector<std::string> order;
    for (const Look& seen : looks(readings(shipped(name), where))) {
        if (order.empty() || order.back() != seen.family()) order.push_back(seen.family());
    }
    return order;
}

TEST(PublishedColours, FlakesThatTravelGoThroughTheColoursThatAreToldOfThem) {
    using Order = std::vector<std::string>;
    // "From green to silver to red to orange" [reisch-2006], of silica flakes. Orange is not reached: hue
    // 33 at 80 deg, where yellow-red begins at 45.
    const std::string everywhere = fmt::format("{},{}", kToGloss, kAslant);
    EXPECT_EQ(travel("effect-pigments/silica-colour-travel", everywhere),
              (Order{"GY", "G", "N", "RP", "R"}));
    // "Reddish purple to gold", of iron oxide and silica on aluminium. Beyond, the gold stays at the end of Y,
    // hue 96 to 102.
    EXPECT_EQ(travel("flip-flop", kToGloss), (Order{"RP", "R", "YR", "Y"}));
    // From green to purple, the travel that is sold most of five-layer flakes.
    EXPECT_EQ(travel("effect-pigments/chromium-colour-shift", everywhere),
              (Order{"GY", "G", "BG", "PB", "P", "RP"}));
}

// Brass of 70 % copper is greenish gold, of less zinc yellow, and copper red [gettens-stout-1942].
TEST(PublishedColours, GoldBronzeIsGreenerThanGoldAndThatThanCopper) {
    const std::string text = read_file(shipped_file("paints/effect-pigments/bronze.toml"));
    const std::string brass = "brass_Cu70Zn30";
    ASSERT_NE(text.find(brass), std::string::npos);
    std::vector<double> hues;
    for (const char* metal : {"Cu", "Au", "brass_Cu70Zn30"}) {
        std::string changed = text;
        changed.replace(changed.find(brass), brass.size(), metal);
        hues.push_back(look(open_text(changed, "bronze.toml"), "45as15").hue_deg);
    }
    EXPECT_GT(hues[1], hues[0] + 10);
    EXPECT_GT(hues[2], hues[1] + 10);
}

}  // namespace
}  // namespace nacre
