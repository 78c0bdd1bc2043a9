#include "nacre/measure/geometry.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "nacre/core/error.h"

namespace nacre::measure {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

// Directions are computed through sines and arc tangents.
constexpr double kRounding_deg = 1e-10;

std::vector<std::string> names(const char* set) {
    std::vector<std::string> result;
    for (const Geometry& g : find_geometry_set(set)->geometries) result.push_back(g.name);
    return result;
}

TEST(Geometry, AspecularAnglesCountFromTheMirrorTowardsTheNormal) {
    const Geometry near = in_plane(45, 15), far = in_plane(45, 110), behind = in_plane(45, -15);
    EXPECT_EQ(near, (Geometry{"45as15", 45, 15, 30, 180}));
    EXPECT_EQ(far, (Geometry{"45as110", 45, 110, 65, 0}));
    EXPECT_EQ(behind, (Geometry{"45as-15", 45, -15, 60, 180}));
    EXPECT_EQ(in_plane(45, 45).theta_o_deg, 0);
    EXPECT_EQ(in_plane(0, 30), (Geometry{"0as30", 0, 30, 30, 0}));
}

TEST(Geometry, OffPlaneTurnsAboutTheMirrorDirection) {
    // Both ends of the turn lie in the plane: away from the normal and towards it.
    EXPECT_EQ(off_plane(45, 15, 0), in_plane(45, -15));
    EXPECT_EQ(off_plane(45, 15, 180), in_plane(45, 15));
    EXPECT_EQ(off_plane(45, 15, -180), in_plane(45, 15));
    for (double azimuth : {1.0, 30.0, 90.0, 125.3, 179.0}) {
        const Geometry one = off_plane(45, 25, azimuth), other = off_plane(45, 25, -azimuth);
        // The aspecular angle is that between the directions, on either side.
        EXPECT_NEAR(separation_deg(one, in_plane(45, 0)), 25, kRounding_deg);
        EXPECT_DOUBLE_EQ(one.theta_o_deg, other.theta_o_deg);
        EXPECT_NEAR(one.phi_deg + other.phi_deg, 360, kRounding_deg);
        EXPECT_LT(one.phi_deg, 180);
    }
}

// Unit vectors of two detectors and the names of what they read, as the maker's software has them
// [xrite-2026]: at (0.640856, 0.422618, 0.640856) and (0, 0.7071, 0.7071), the light
// travelling in the plane y = 0.
TEST(Geometry, NamesOfTheMakersDetectorsAreTheirDirections) {
    const double theta_a = std::acos(0.640856) * 180 / M_PI,
                 phi_a = 180 - std::atan2(0.422618, 0.640856) * 180 / M_PI;
    // The names are rounded to a tenth of a degree.
    constexpr double kRounded_deg = 0.05 * 1.42;
    EXPECT_LT(separation_deg(off_plane(45, 25, 90), towards(45, theta_a, phi_a)), kRounded_deg);
    EXPECT_LT(separation_deg(off_plane(15, 38.3, 43), towards(15, theta_a, phi_a)), kRounded_deg);
    EXPECT_LT(separation_deg(off_plane(45, 60, 125.3), towards(45, 45, 90)), kRounded_deg);
    EXPECT_LT(separation_deg(off_plane(15, 46.9, 104.5), towards(15, 45, 90)), kRounded_deg);
}

TEST(Geometry, EveryViewHasOneName) {
    EXPECT_EQ(towards(45, 30, 180), in_plane(45, 15));
    EXPECT_EQ(towards(45, 30, -180), in_plane(45, 15));
    EXPECT_EQ(towards(45, 65, 0), in_plane(45, 110));
    EXPECT_EQ(towards(45, 65, 360), in_plane(45, 110));
    EXPECT_EQ(towards(45, 0, 77), in_plane(45, 45));
    const Geometry aside = towards(45, 30, -90);
    EXPECT_EQ(aside.name, "45to30,270");
    EXPECT_NEAR(aside.aspecular_deg,
                std::acos(std::cos(M_PI / 4) * std::cos(M_PI / 6)) * 180 / M_PI, kRounding_deg);
}

TEST(Geometry, NamesAreReadAsInstrumentsWriteThem) {
    EXPECT_EQ(parse_geometry("45as15"), in_plane(45, 15));
    EXPECT_EQ(parse_geometry("45as-15"), in_plane(45, -15));
    EXPECT_EQ(parse_geometry("r45as-15"), in_plane(45, -15));
    EXPECT_EQ(parse_geometry("45asMinus15"), in_plane(45, -15));
    EXPECT_EQ(parse_geometry("45AS15"), in_plane(45, 15));
    EXPECT_EQ(parse_geometry("45as25az-90"), off_plane(45, 25, -90));
    EXPECT_EQ(parse_geometry("45to30,90"), towards(45, 30, 90));
    for (const char* name : {"as-15", "AS-15", "45/-15", "45:as-15", "45/as-15", "asMinus15",
                             "45\u00b0:as-15\u00b0", "45\u00b0/-15\u00b0", "45as-15\u00b0"}) {
        EXPECT_EQ(parse_geometry(name), in_plane(45, -15)) << name;
    }
    std::size_t checked = 0;
    for (const GeometrySet& set : geometry_sets()) {
        for (const Geometry& g : set.geometries) {
            EXPECT_LT(separation_deg(parse_geometry(g.name), g), 0.1) << g.name;
            ++checked;
        }
    }
    EXPECT_GT(checked, 100u);
}

TEST(Geometry, RefusesWhatIsNoneOrBelowTheHorizon) {
    for (const char* text : {"", "45", "as", "45/", "45:15", "45as", "45as15x", "45as25az",
                             "45to30", "45to30,", "nanas15", "45asinf", "45 as 15", "1e999as1"}) {
        EXPECT_THAT([&] { parse_geometry(text); },
                    ThrowsMessage<DomainError>(HasSubstr("is no geometry")))
            << text;
    }
    EXPECT_THAT([] { parse_geometry("45/0"); },
                ThrowsMessage<DomainError>(AllOf(HasSubstr("45as45"), HasSubstr("45as0"))));
    EXPECT_THAT([] { in_plane(45, -45); },
                ThrowsMessage<DomainError>(AllOf(HasSubstr("-45"), HasSubstr("(-45, 135)"))));
    EXPECT_THROW(in_plane(45, 135), DomainError);
    EXPECT_THROW(in_plane(90, 15), DomainError);
    EXPECT_THROW(in_plane(-1, 15), DomainError);
    EXPECT_THROW(in_plane(45, NAN), DomainError);
    EXPECT_THROW(off_plane(80, 20, 30), DomainError);
    EXPECT_THROW(off_plane(45, 180, 30), DomainError);
    EXPECT_THROW(off_plane(45, 15, 181), DomainError);
    EXPECT_THROW(towards(45, 90, 0), DomainError);
    EXPECT_THROW(towards(45, 30, NAN), DomainError);
}

TEST(Geometry, ListsHoldTheCommaOfAView) {
    EXPECT_THAT(parse_geometries("45as15,45to30,90,45as25az90"),
                ElementsAre(parse_geometry("45as15"), parse_geometry("45to30,90"),
                            parse_geometry("45as25az90")));
    EXPECT_THAT([] { parse_geometries("45as15,45/15"); },
                ThrowsMessage<DomainError>("45as15 appears twice"));
    EXPECT_THAT([] { parse_geometries("45as15,"); },
                ThrowsMessage<DomainError>(HasSubstr("'' is no geometry")));
}

TEST(GeometrySets, AreWhatTheStandardsAndTheInstrumentsRead) {
    EXPECT_THAT(names("astm-e2194"), ElementsAre("45as15", "45as45", "45as110"));
    EXPECT_THAT(names("astm-e2539"),
                ElementsAre("45as-15", "45as15", "45as25", "45as45", "45as75", "45as110", "15as-15",
                            "15as15", "65as-15", "65as15"));
    EXPECT_THAT(names("byk-mac"),
                ElementsAre("45as-15", "45as15", "45as25", "45as45", "45as75", "45as110"));
    EXPECT_THAT(names("ma-t12"),
                ElementsAre("45as-15", "45as15", "45as25", "45as45", "45as75", "45as110", "15as-45",
                            "15as-15", "15as15", "15as45", "15as80", "45as25az90", "45as60az125.3",
                            "15as38.3az43", "15as46.9az104.5"));
    EXPECT_EQ(names("ma98").size(), 19u);
    EXPECT_EQ(find_geometry_set("byk"), nullptr);
}

TEST(GeometrySets, HoldEachDirectionOnce) {
    for (const GeometrySet& set : geometry_sets()) {
        EXPECT_FALSE(set.summary.empty());
        std::set<std::string> seen;
        for (std::size_t i = 0; i < set.geometries.size(); ++i) {
            const Geometry& g = set.geometries[i];
            EXPECT_TRUE(seen.insert(g.name).second) << set.name << ": " << g.name;
            // The directions agree with the names.
            EXPECT_NEAR(separation_deg(g, towards(g.theta_i_deg, g.theta_o_deg, g.phi_deg)), 0,
                        kRounding_deg);
            for (std::size_t j = 0; j < i; ++j) {
                EXPECT_GT(separation_deg(g, set.geometries[j]), 1) << set.name << ": " << g.name;
            }
        }
    }
}

TEST(GeometrySets, FullSpansTheHemisphere) {
    const GeometrySet& full = *find_geometry_set("full");
    // Lamps at 0 (6 views), and 5 more with the view along the normal and 5 times 7 azimuths.
    EXPECT_EQ(full.geometries.size(), 6u + 5 * (1 + 5 * 7));
}

}  // namespace
}  // namespace nacre::measure
