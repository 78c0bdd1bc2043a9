#include "nacre/io/geometry_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nacre/core/error.h"
#include "nacre/testing/errors.h"

namespace nacre::io {
namespace {

using nacre::test::message_of;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string refused_geometry(const std::string& text) {
    return message_of<InputError>([&] { parse_geometry_set(text, "set.toml"); });
}

TEST(GeometryFile, ReadsViewsInThePlaneTurnedAndAnywhere) {
    const measure::GeometrySet set = parse_geometry_set(R"(name = "booth"
summary = "as we look at panels"
[[geometry]]
lamp_deg = 45
aspecular_deg = -15
[[geometry]]
lamp_deg = 45
aspecular_deg = 25
azimuth_deg = 90
[[geometry]]
lamp_deg = 20
view_deg = [30, 90]
name = "window"
)",
                                                        "set.toml");
    EXPECT_EQ(set.name, "booth");
    EXPECT_EQ(set.summary, "as we look at panels");
    ASSERT_EQ(set.geometries.size(), 3u);
    EXPECT_EQ(set.geometries[0], measure::in_plane(45, -15));
    EXPECT_EQ(set.geometries[1], measure::off_plane(45, 25, 90));
    measure::Geometry window = measure::towards(20, 30, 90);
    window.name = "window";
    EXPECT_EQ(set.geometries[2], window);
}

TEST(GeometryFile, RefusalsNameLineKeyAndRange) {
    EXPECT_THAT(refused_geometry(""), HasSubstr("at least one [[geometry]]"));
    EXPECT_THAT(refused_geometry("[[geometry]]\nlamp = 45\n"),
                AllOf(StartsWith("set.toml:2:"), HasSubstr("lamp_deg")));
    EXPECT_THAT(refused_geometry("[[geometry]]\nlamp_deg = 90\naspecular_deg = 15\n"),
                AllOf(StartsWith("set.toml:2:"), HasSubstr("[0, 90) deg")));
    EXPECT_THAT(refused_geometry("[[geometry]]\nlamp_deg = 45\n"), HasSubstr("aspecular_deg"));
    EXPECT_THAT(refused_geometry("[[geometry]]\nlamp_deg = 45\naspecular_deg = 150\n"),
                AllOf(StartsWith("set.toml:1:"), HasSubstr("below the horizon")));
    EXPECT_THAT(refused_geometry("[[geometry]]\nlamp_deg = 45\nview_deg = [30]\n"),
                HasSubstr("view_deg"));
    EXPECT_THAT(
        refused_geometry("[[geometry]]\nlamp_deg = 45\nview_deg = [30, 0]\naspecular_deg = 15\n"),
        HasSubstr("by itself"));
    EXPECT_THAT(refused_geometry("[[geometry]]\nlamp_deg = 45\naspecular_deg = 15\nname = \"\"\n"),
                HasSubstr("must not be empty"));
    EXPECT_THAT(refused_geometry("[[geometry]]\nlamp_deg = 45\naspecular_deg = 15\n"
                                 "[[geometry]]\nlamp_deg = 45\naspecular_deg = 15\n"),
                AllOf(StartsWith("set.toml:4:"), HasSubstr("45as15")));
    EXPECT_THAT(
        refused_geometry("[[geometry]]\nlamp_deg = 45\naspecular_deg = 15\n"
                         "[[geometry]]\nlamp_deg = 45\nview_deg = [30, 180]\nname = \"again\"\n"),
        AllOf(StartsWith("set.toml:4:"), HasSubstr("the direction of 'again'")));
}

}  // namespace
}  // namespace nacre::io
