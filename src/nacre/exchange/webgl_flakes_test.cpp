#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "nacre/bsdf/models/nacre.h"
#include "nacre/exchange/webgl_shader.h"
#include "nacre/solver/solver.h"
#include "nacre/spectra/spectrum.h"
#include "nacre/testing/paints.h"

namespace nacre::exchange {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::uint64_t bits_of(const nlohmann::json& hex) {
    return std::stoull(hex.get<std::string>(), nullptr, 16);
}

// The shader is held to the same file in a browser (web/studio/test/glints.test.ts).
TEST(WebglFlakes, HashesAreThoseThatTheShaderIsHeldTo) {
    std::ifstream file(NACRE_FLAKE_HASHES);
    const nlohmann::json all = nlohmann::json::parse(file);
    ASSERT_EQ(all.size(), 64u);
    for (const nlohmann::json& one : all) {
        const std::uint64_t cell =
            sparkle::FlakeField::cell_key(bits_of(one["level"]), one["side"], one["u"], one["v"]);
        EXPECT_EQ(cell, bits_of(one["cell"]));
        const auto [place, kind] =
            sparkle::FlakeField::flake_bits<std::uint32_t>(cell, one["n"].get<std::uint32_t>());
        EXPECT_EQ(place, bits_of(one["place"]));
        EXPECT_EQ(kind, bits_of(one["kind"]));
        EXPECT_EQ(hash_of(place, kind), bits_of(one["body"]));
    }
}

std::shared_ptr<const solver::SolvedPaint> two_species(double coat_roughness) {
    paint::Recipe recipe = test::paint_of(
        1.5, {{12, {test::flakes(0.05, 0.1, 0.5), test::flakes(0.02, 0.2, 0.7)}, {}}}, 0.1);
    recipe.layers[0].flakes[1].diameter_spread_um = 4;
    if (coat_roughness > 0) recipe.clearcoat = paint::Clearcoat{40, 0, coat_roughness};
    return std::make_shared<const solver::SolvedPaint>(
        solver::solve(recipe, spectra::default_wavelengths_nm()));
}

std::vector<float> values(const WebglShader& shader, const std::string& name) {
    for (const WebglUniform& u : shader.uniforms) {
        if (u.name == name) return u.values;
    }
    return {};
}

TEST(WebglFlakes, UniformsAreTheFieldsOfTheSpecimen) {
    const auto paint = two_species(0);
    const WebglShader shader = make_live_webgl_shader(paint, 7);
    const auto fields = bsdf::flake_fields(bsdf::Microflake::Tables(paint), 7);
    ASSERT_EQ(fields.size(), 2u);
    const std::vector<float> key = values(shader, "nacreFieldKey");
    const std::vector<float> field = values(shader, "nacreField");
    const std::vector<float> size = values(shader, "nacreFieldSize");
    using Constants = sparkle::FlakeField::Constants;
    ASSERT_EQ(key.size(), 2u * Constants::kLevels * 4);
    for (std::size_t s = 0; s < fields.size(); ++s) {
        const Constants constants = fields[s].constants();
        for (std::size_t level = 0; level < Constants::kLevels; ++level) {
            std::uint64_t bits = 0;
            for (int part = 3; part >= 0; --part) {
                bits = bits << 16 |
                       static_cast<std::uint64_t>(key[4 * (Constants::kLevels * s + level) + part]);
            }
            EXPECT_EQ(bits, constants.key[level]);
            // The shader quadruples the side of the finest.
            EXPECT_NEAR(constants.cell_mm[level],
                        std::ldexp(field[4 * s], 2 * static_cast<int>(level)),
                        1e-6 * constants.cell_mm[level]);
        }
        EXPECT_FLOAT_EQ(size[4 * s + 1],
                        static_cast<float>(0.5e-3 * fields[s].sizes().largest_um()));
    }
    EXPECT_FLOAT_EQ(size[3] + size[7], 1);  // of all light that is scattered once

    const WebglShader other = make_live_webgl_shader(paint, 8);
    EXPECT_EQ(other.program, shader.program);
    EXPECT_NE(values(other, "nacreFieldKey"), key);
    EXPECT_EQ(values(other, "nacreField"), field);
}

TEST(WebglFlakes, AreLeftOutOfFilesOfOnePaint) {
    for (const double roughness : {0.0, 0.1}) {
        const auto paint = two_species(roughness);
        EXPECT_THAT(make_live_webgl_shader(paint).glsl, HasSubstr("#define NACRE_FLAKES 2\n"));
        const WebglShader file = make_webgl_shader(bsdf::nacre_arrays(paint, bsdf::NacreModel{}));
        EXPECT_THAT(file.glsl, Not(HasSubstr("define NACRE_FLAKES")));
        EXPECT_THAT(file.glsl, Not(HasSubstr("nacreRest")));
    }
}

}  // namespace
}  // namespace nacre::exchange
