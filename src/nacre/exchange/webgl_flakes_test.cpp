#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "nacre/bsdf/models/nacre.h"
#include "nacre/core/file.h"
#include "nacre/core/half.h"
#include "nacre/core/random.h"
#include "nacre/exchange/webgl_shader.h"
#include "nacre/io/recipe_file.h"
#include "nacre/solver/solver.h"
#include "nacre/spectra/rgb.h"
#include "nacre/spectra/spectrum.h"
#include "nacre/testing/bsdf.h"
#include "nacre/testing/paints.h"
#include "nacre/testing/statistics.h"

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

/// Three kinds of flakes: alike, of one film that varies, and of two.
std::shared_ptr<const solver::SolvedPaint> three_kinds() {
    const auto pearl = [](double core_spread_nm) {
        optics::Platelet platelet;
        platelet.core = {optics::find_material("mica"), 500, {core_spread_nm}};
        platelet.coats = {{optics::find_material("TiO2_anatase"), 110, {12}}};
        paint::FlakeSpecies species = test::flakes(0.03, 0.15, 0.0);
        species.body = platelet;
        return species;
    };
    return std::make_shared<const solver::SolvedPaint>(
        solver::solve(test::paint_of(1.5, {{12, {test::flakes(0.05, 0.1, 0.5), pearl(0)}, {}},
                                           {10, {pearl(60), pearl(0)}, {}}}),
                      spectra::default_wavelengths_nm()));
}

// By half floats, whose steps are 1/2048 or less, and every other of the cosines.
TEST(WebglFlakes, FilmsAreThoseOfThePathTracer) {
    const auto paint = three_kinds();
    const auto [texture, uniform] = make_live_webgl_films(*paint);
    const bsdf::SpeciesFilms films = bsdf::species_films(*paint, {paint->wavelengths_nm()});
    const std::vector<float>& found = uniform.values;
    ASSERT_EQ(found.size(), 4 * films.size());
    EXPECT_EQ(found[0], 0);
    EXPECT_EQ(found[4], bsdf::FlakeFilms::kOneFilmSet);
    EXPECT_EQ(found[8], bsdf::FlakeFilms::kManyFilmsSet);
    EXPECT_EQ(found[13], found[5]) << "flakes of one kind share their films";
    const std::vector<float> before =
        values(make_live_webgl_shader(paint), uniform.name);  // until they come
    ASSERT_EQ(before.size(), found.size());
    for (std::size_t s = 0; s < films.size(); ++s) EXPECT_EQ(before[4 * s], 0);
    const std::vector<double> nm = paint->wavelengths_nm();
    double worst = 0, farthest = 0;
    Rng rng(5);
    for (const std::size_t s : {1u, 2u, 3u}) {
        const float* const kind = &found[4 * s];
        for (int half = 0; half < 2; ++half) {
            bsdf::Wavelengths bands;
            for (int b = 0; b < kLanes; ++b) {
                bands[b] = static_cast<float>(nm.front() + (nm.back() - nm.front()) *
                                                               (8 * half + b) / (kWebglBands - 1));
            }
            const bsdf::BoundFlakeFilms own = films[s]->bind(bsdf::locate_wavelengths(nm, bands));
            for (int n = 0; n < 2000; ++n) {
                const std::uint32_t bits = rng.next_u32();
                const float cosine = std::lerp(kind[2], 1.0f, rng.uniform_float());
                const FloatLanes want = own.ratio(cosine, bits);
                const float y = (cosine - kind[2]) * kind[3];
                const int low = std::min(static_cast<int>(y), 31);
                const auto set = static_cast<std::size_t>(
                    (std::uint64_t{bits} * static_cast<std::uint64_t>(kind[0])) >> 32);
                const auto at = [&](int row, int b) {
                    const std::size_t texel =
                        (static_cast<std::size_t>(kind[1]) + row) * texture.size[0] + 4 * set;
                    return half_value(texture.rgba[4 * texel + 8 * half + b]);
                };
                for (int b = 0; b < kLanes; ++b) {
                    const float got = at(low, b) + (y - low) * (at(low + 1, b) - at(low, b));
                    worst = test::worse(worst, std::abs(got - double{want[b]}));
                    farthest = std::max(farthest, std::abs(want[b] - 1.0));
                }
            }
        }
    }
    EXPECT_GT(farthest, 0.5);
    EXPECT_LT(worst, 0.01 * farthest);
}

// Flakes of a shipped paint, one by one, as the path tracer's class has them. The shader is held to the
// same file in a browser. WRITE_FLAKE_COLOURS=1 in the environment writes it anew.
TEST(WebglFlakes, ColoursAreThoseThatTheShaderIsHeldTo) {
    const auto paint = std::make_shared<const solver::SolvedPaint>(solver::solve(
        io::read_recipe(shipped_file("paints/red-gold.toml")), spectra::default_wavelengths_nm()));
    const bsdf::Nacre nacre(paint);
    const std::vector<double> nm = paint->wavelengths_nm();
    const std::vector<Vec3d> weights = spectra::rec709_weights(nm);
    std::vector<std::unique_ptr<const bsdf::BoundBsdf>> bound;
    for (std::size_t w = 0; w < nm.size(); w += kLanes) {
        bsdf::Wavelengths eight;
        for (std::size_t l = 0; l < kLanes; ++l) {
            eight[l] = static_cast<float>(nm[std::min(w + l, nm.size() - 1)]);
        }
        bound.push_back(nacre.bind(eight));
    }
    const sparkle::FlakeField& field = nacre.tables().species[0].field;
    nlohmann::json all = nlohmann::json::array();
    std::vector<bsdf::FlakeSample> samples;
    Rng rng(11);
    while (all.size() < 32) {
        // A square of 5 um.
        const float side = 0.005f;
        bsdf::Patch patch;
        patch.footprint = {{100 * rng.uniform_float(), 100 * rng.uniform_float(), 0},
                           {0, 0, 1},
                           {1, 0, 0},
                           {Vec3f{side, 0, 0}, Vec3f{0, side, 0}}};
        patch.flakes = bsdf::Patch::Flakes::sampled;
        const float sine = 0.9f * rng.uniform_float();
        const Vec3f wi = {sine, 0, std::sqrt(1 - sine * sine)};
        samples = bsdf::flake_samples(*bound[0], patch, wi, rng.next_u32());
        sparkle::FlakeView view;
        field.query(patch.footprint, view, {1});
        if (samples.empty()) continue;
        bsdf::FlakeSample& flake = samples.front();
        flake.pdf = flake.wo.z;  // what is asked for times the cosine over this
        const auto inside = [](Vec3f w) {
            return Vec3f{w.x / 1.5f, w.y / 1.5f, std::sqrt(1 - (w.x * w.x + w.y * w.y) / 2.25f)};
        };
        const Vec3f h = inside(wi) + inside(flake.wo);
        const Vec2f slope = {h.x / h.z, h.y / h.z};
        const float fraction = view.fraction(field.lobe(), slope, 0.5f * length(h), flake.flake, 0);
        if (fraction < 1e-3f) continue;
        Vec3d rgb;
        for (std::size_t w = 0; w < nm.size(); ++w) {
            rgb += bound[w / kLanes]->flake_weight(patch, wi, flake)[w % kLanes] / fraction *
                   weights[w];
        }
        all.push_back({{"place", view.place[flake.flake]},
                       {"kind", view.kind[flake.flake]},
                       {"wi", {wi.x, wi.y, wi.z}},
                       {"wo", {flake.wo.x, flake.wo.y, flake.wo.z}},
                       {"rgb", {rgb.x, rgb.y, rgb.z}}});
    }
    if (std::getenv("WRITE_FLAKE_COLOURS")) {
        std::ofstream(NACRE_FLAKE_COLOURS) << all.dump(4) << "\n";
    }
    std::ifstream file(NACRE_FLAKE_COLOURS);
    const nlohmann::json known = nlohmann::json::parse(file);
    ASSERT_EQ(known.size(), all.size());
    for (std::size_t n = 0; n < all.size(); ++n) {
        EXPECT_EQ(known[n]["place"], all[n]["place"]);
        EXPECT_EQ(known[n]["kind"], all[n]["kind"]);
        const std::vector<double> want = known[n]["rgb"], got = all[n]["rgb"];
        const double largest = *std::max_element(want.begin(), want.end());
        // Single precision, summed on processors of all kinds.
        for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(got[c], want[c], 1e-4 * largest);
    }
}

// What a patch resolves of the flakes of a shipped paint, from those that it touches one by one to those of
// the coarsest level. WRITE_FLAKE_LEVELS=1 in the environment writes the file anew.
TEST(WebglFlakes, LevelsAreThoseThatTheShaderIsHeldTo) {
    const auto paint = std::make_shared<const solver::SolvedPaint>(solver::solve(
        io::read_recipe(shipped_file("paints/red-gold.toml")), spectra::default_wavelengths_nm()));
    const bsdf::Nacre nacre(paint);
    const sparkle::FlakeField& field = nacre.tables().species[0].field;
    nlohmann::json all = nlohmann::json::array();
    int resolving = 0;
    const auto view = std::make_unique<sparkle::FlakeView>();
    for (int i = 0; i < 48; ++i) {
        const float x = 0.01f * std::pow(1.25f, static_cast<float>(i)),
                    y = i % 3 == 0 ? 0.5f * x : x;
        for (const float light_area : {0.0f, 0.5f, 2.0f}) {
            const sparkle::ObjectSpaceFootprint patch{
                {}, {0, 0, 1}, {1, 0, 0}, {Vec3f{x, 0, 0}, Vec3f{0, y, 0}}};
            field.leave_out(patch, *view, {light_area});
            all.push_back({{"side_mm", {x, y}},
                           {"light_area", light_area},
                           {"resolved", 1 - view->background},
                           {"widening", view->widening}});
            resolving += view->background > 0 && view->background < 1;
        }
    }
    EXPECT_GT(resolving, 50);
    if (std::getenv("WRITE_FLAKE_LEVELS")) {
        std::ofstream(NACRE_FLAKE_LEVELS) << all.dump(4) << "\n";
    }
    std::ifstream file(NACRE_FLAKE_LEVELS);
    const nlohmann::json known = nlohmann::json::parse(file);
    ASSERT_EQ(known.size(), all.size());
    for (std::size_t n = 0; n < all.size(); ++n) {
        for (const char* key : {"light_area", "resolved", "widening"}) {
            const double want = known[n][key], got = all[n][key];
            EXPECT_NEAR(got, want, 1e-5 * want) << key << " of " << n;
        }
    }
}

TEST(WebglFlakes, AreLeftOutOfFilesOfOnePaint) {
    for (const double roughness : {0.0, 0.1}) {
        const auto paint = two_species(roughness);
        EXPECT_THAT(make_live_webgl_shader(paint).glsl, HasSubstr("#define NACRE_FLAKES 2\n"));
        const WebglShader file = make_webgl_shader(
            bsdf::nacre_arrays(paint, bsdf::NacreModel{}, bsdf::ArrayParts::mean));
        EXPECT_THAT(file.glsl, Not(HasSubstr("define NACRE_FLAKES")));
        EXPECT_THAT(file.glsl, Not(HasSubstr("nacreRest")));
    }
}

}  // namespace
}  // namespace nacre::exchange
