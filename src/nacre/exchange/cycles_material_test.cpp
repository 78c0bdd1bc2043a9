#include "nacre/exchange/cycles_material.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nacre/core/math.h"

namespace nacre::exchange {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// All that a lobe can do: widening, leaning to both sides, ramps that turn; under a rough coat.
CyclesMaterial three_lobes() {
    CyclesMaterial m;
    m.diffuse = {0.05, 0.1, 0.2};
    m.lobes[0] = {
        0.3, 0.5, 0.2, {{{{0.5, 0.3, 0.1}, {0.1, 0.5, 0.2}, {0.3, 0.1, 0.4}, {0.2, 0.2, 0.05}}}}};
    m.lobes[1] = {
        0.5, 0, -0.4, {{{{0.2, 0.2, 0.2}, {0.1, 0.1, 0.3}, {0.3, 0.1, 0.1}, {0.1, 0.4, 0.1}}}}};
    m.lobes[2] = {
        0.8, 1, 0, {{{{0.1, 0.2, 0.1}, {0.2, 0.1, 0.1}, {0.1, 0.3, 0.1}, {0.1, 0.1, 0.1}}}}};
    m.coat = true;
    m.coat_roughness = 0.4;
    return m;
}

// What Cycles of Blender 4.2.0 (PyPI's bpy 4.2.0) renders of cycles_text() of this material, by
// `python python/tests/blender_patch.py SCRIPT` with these angles. 4.5.4 and 5.0.1 give the
// same to 3e-6. Cycles evaluates ramps by tables of 256 colours, in single precision.
TEST(CyclesMaterial, AgreesWithCycles) {
    constexpr double kTableOfRamp = 1e-4;
    const struct {
        double theta_i, theta_o, phi;
        Vec3d f;
    } cases[] = {
        {0, 20, 0, {0.7295083, 1.0685784, 0.60091826}},
        {45, 30, 180, {0.50878942, 0.4623152, 0.76019124}},
        {45, 60, 180, {3.1817103, 2.4625662, 3.6738945}},
        {45, 10, 90, {0.06303311, 0.084442635, 0.10697628}},
        {60, 70, 150, {0.051784194, 0.10003206, 0.087346262}},
        {30, 75, 20, {0.034327441, 0.066822434, 0.069533059}},
        {75, 85, 180, {58.713489, 60.929235, 57.251629}},
        {20, 0, 0, {0.33356087, 0.33890867, 0.33142838}},
    };
    const CyclesMaterial m = three_lobes();
    for (const auto& at : cases) {
        const Vec3d f =
            cycles_brdf(m, at.theta_i * kDegree, at.theta_o * kDegree, at.phi * kDegree);
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(f[c], at.f[c], kTableOfRamp * at.f[c])
                << at.theta_i << " " << at.theta_o << " " << c;
        }
    }
}

// A uniform cubic B-spline keeps straight lines, away from the ends whose stops count twice, and lies
// between its stops.
TEST(CyclesRamp, IsASplineBetweenItsStops) {
    const CyclesRamp line{{{{0, 1, 0.5}, {0.2, 0.8, 0.5}, {0.4, 0.6, 0.5}, {0.6, 0.4, 0.5}}}};
    for (const double place : {1.0 / 3, 0.45, 0.6, 2.0 / 3}) {
        EXPECT_NEAR(line.at(place).x, 0.6 * place, 1e-12);
        EXPECT_NEAR(line.at(place).y, 1 - 0.6 * place, 1e-12);
        EXPECT_NEAR(line.at(place).z, 0.5, 1e-12);
    }
    EXPECT_NEAR(line.at(0).x, 0.2 / 6, 1e-12);
    EXPECT_NEAR(line.at(1).x, 0.6 - 0.2 / 6, 1e-12);
}

/// Of the green channel, by a rule over the hemisphere of lamps.
double reflected_of(const CyclesMaterial& m, double theta_o) {
    constexpr int kPolar = 200, kAround = 200;
    double sum = 0;
    for (int i = 0; i < kPolar; ++i) {
        const double theta = (i + 0.5) / kPolar * 0.5 * std::numbers::pi;
        for (int k = 0; k < kAround; ++k) {
            const double phi = (k + 0.5) / kAround * 2 * std::numbers::pi;
            sum += cycles_brdf(m, theta, theta_o, phi)[1] * std::cos(theta) * std::sin(theta);
        }
    }
    return sum * 0.5 * std::numbers::pi / kPolar * 2 * std::numbers::pi / kAround;
}

// Facets reflect all light but what meets others, so that a material of the fit's largest shares
// keeps below 1 at every angle, and close to it along the normal.
TEST(CyclesMaterial, MakesNoLight) {
    const FormatModel model = cycles_model(false, false, 1.5);
    int compared = 0;
    for (const double lean : {-0.4, 0.0, 0.5}) {
        std::vector<double> values;
        for (const FormatParameter& p : model.parameters) {
            values.push_back(p.name.ends_with("lean")        ? lean
                             : p.name.ends_with("roughness") ? p.start
                             : p.name.ends_with("widening")  ? 0
                                                             : 0.9);
        }
        const CyclesMaterial m = cycles_material(model, values);
        for (int k = 0; k < CyclesRamp::kStops; ++k) {
            double all = m.diffuse.y;
            for (const CyclesLobe& lobe : m.lobes) all += lobe.color.stops[k].y;
            EXPECT_NEAR(all, 1 - std::pow(0.1, 1 + CyclesMaterial::kLobes), 1e-12);
        }
        EXPECT_GT(reflected_of(m, 0), 0.98);
        for (const double theta : {0.0, 0.5, 1.0, 1.3, 1.5}) {
            EXPECT_LT(reflected_of(m, theta), 1) << lean << " " << theta;
            ++compared;
        }
    }
    EXPECT_EQ(compared, 15);
}

TEST(CyclesMaterial, ACoatTakesItsReflectanceFromWhatLiesBelow) {
    CyclesMaterial m;
    m.diffuse = {0.5, 0.5, 0.5};
    m.coat = true;
    EXPECT_NEAR(std::numbers::pi * cycles_brdf(m, 0.7, 0, 0).x, 0.5 * 0.96, 1e-12);
    m.coat_ior = 1;
    EXPECT_NEAR(std::numbers::pi * cycles_brdf(m, 0.7, 1.2, 0).x, 0.5, 1e-12);
}

TEST(CyclesFile, HoldsTheMaterialAndWhatItMisses) {
    MaterialFit fit;
    fit.tested.max_delta_e_2000 = 31.25;
    fit.instrument.angles.resize(1);
    fit.instrument.angles[0].geometry.name = "45as15";
    fit.instrument.angles[0].delta_e_2000 = 3.04;
    const std::string text = cycles_text(three_lobes(), "a \"paint\"\n\\ b", fit, 30);
    EXPECT_THAT(text, HasSubstr("\"name\": \"a \\\"paint\\\"\\n\\\\ b\""));
    EXPECT_THAT(text, HasSubstr("\"flake_size\": 3e-05"));
    EXPECT_THAT(text, HasSubstr("\"coat\": {\"ior\": 1.5, \"roughness\": 0.4}"));
    EXPECT_THAT(text, HasSubstr("31.2 at angles that the fit did not see"));
    EXPECT_THAT(text, HasSubstr("45as15 3.0"));
    EXPECT_THAT(cycles_text({}, "", fit, 30), Not(HasSubstr("\"coat\": {")));
}

TEST(CyclesMaterial, NamesWhatTheScriptHolds) {
    const CyclesMaterial m = three_lobes();
    const auto named = cycles_parameters(m);
    const auto value = [&](const std::string& name) {
        for (const auto& [key, number] : named) {
            if (key == name) return number;
        }
        return std::nan("");
    };
    EXPECT_EQ(value("diffuse[2]"), 0.2);
    EXPECT_EQ(value("lobe 1 color[1][1]"), 0.5);
    EXPECT_EQ(value("lobe 2 lean"), -0.4);
    EXPECT_EQ(value("coat roughness"), 0.4);
}

}  // namespace
}  // namespace nacre::exchange
