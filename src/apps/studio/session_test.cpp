#include "apps/studio/session.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "apps/studio/server_test_support.h"
#include "nacre/core/file.h"
#include "nacre/exchange/webgl_shader.h"
#include "nacre/nacre.h"
#include "nacre/render.h"

// A page's session with the server, through its socket: readings, standards, fits and pictures.

namespace nacre::studio {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

TEST(StudioSession, ReadingsAreThoseOfMeasure) {
    const RunningServer server;
    PageClient page(server);
    page.send({{"type", "open"}, {"id", 1}, {"toml", red_gold()}});
    const Tree opened = page.read();
    EXPECT_EQ(opened["type"], "recipe");
    EXPECT_EQ(opened["id"], 1);
    EXPECT_EQ(opened["toml"], red_gold());

    page.send({{"type", "paint"},
               {"id", "two"},
               {"recipe", opened["tree"]},
               {"geometries", "byk-mac"},
               {"illuminant", "D65"},
               {"observer", "10"}});
    const Tree recipe = page.read(), readings = page.read(), done = page.read();
    EXPECT_EQ(recipe["type"], "recipe");
    EXPECT_EQ(recipe["toml"], red_gold());
    EXPECT_EQ(readings["type"], "readings");
    EXPECT_EQ(readings["id"], "two");
    EXPECT_EQ(done, Tree({{"type", "done"}, {"id", "two"}}));
    const Readings measured =
        open(find_paint("red-gold"))
            .measure(geometries("byk-mac"),
                     {.illuminant = Illuminant::D65, .observer = Observer::cie1964_10deg});
    EXPECT_EQ(readings["csv"].get<std::string>(), measured.csv());
    ASSERT_EQ(readings["lab"].size(), measured.measurement.readings.size());
    EXPECT_EQ(readings["lab"][0][1].get<double>(), measured.measurement.readings[0].lab[1]);
    EXPECT_EQ(readings["reflectance"][5].size(), readings["wavelengths_nm"].size());
    EXPECT_TRUE(readings["standard"].is_null());
    ASSERT_GT(recipe["numbers"].size(), 5u);
    EXPECT_LT(recipe["numbers"][0]["min"].get<double>(), recipe["numbers"][0]["max"].get<double>());
}

TEST(StudioSession, OfManyMessagesTheLastIsAnswered) {
    const RunningServer server;
    PageClient page(server);
    Tree tree = red_gold_tree();
    constexpr int kMessages = 100;
    for (int i = 1; i <= kMessages; ++i) {
        tree["layer"][0]["thickness_um"] = 10 + 0.1 * i;
        page.send({{"type", "paint"}, {"id", i}, {"recipe", tree}});
    }
    int answers = 0, last = 0;
    Tree readings;
    while (last != kMessages) {
        const Tree recipe = page.read_until("recipe");
        readings = page.read_until("readings");
        ASSERT_GT(readings["id"].get<int>(), last);
        last = readings["id"];
        EXPECT_EQ(recipe["id"], last);
        EXPECT_EQ(recipe["tree"]["layer"][0]["thickness_um"].get<double>(), 10 + 0.1 * last);
        ++answers;
    }
    EXPECT_LT(answers, kMessages / 2);
    const Paint same = open_text(toml_of_tree(tree), "recipe.toml");
    EXPECT_EQ(readings["csv"].get<std::string>(), same.measure().csv());
}

TEST(StudioSession, TheShaderIsThatOfTheSolvedPaint) {
    const RunningServer server;
    PageClient page(server);
    Tree tree = red_gold_tree();
    for (const int thickness : {15, 20}) {
        tree["layer"][0]["thickness_um"] = thickness;
        const auto lamp = thickness == 15 ? Illuminant::D65 : Illuminant::FL11;
        page.send({{"type", "paint"},
                   {"id", thickness},
                   {"recipe", tree},
                   {"shader", true},
                   {"lamp", spectra::name(lamp)}});
        page.read_until("readings");
        const Tree told = page.read();
        ASSERT_EQ(told["type"], "shader");
        const std::string bytes = page.read_bytes();
        EXPECT_EQ(page.read()["type"], "done");
        page.send({{"type", "films"}, {"id", 1}, {"recipe", tree}});
        const Tree told_films = page.read();
        ASSERT_EQ(told_films["type"], "films");
        const std::string bytes_of_films = page.read_bytes();
        const auto solved = open_text(toml_of_tree(tree), "recipe.toml").solved();
        const auto shader = exchange::make_live_webgl_shader(solved, 0, lamp);
        EXPECT_EQ(told["program"], shader.program);
        // Its text is sent once: the second paint has the same structure.
        EXPECT_EQ(told.contains("glsl"), thickness == 15);
        if (thickness == 15) {
            EXPECT_EQ(told["glsl"], shader.glsl);
        }
        ASSERT_EQ(told["uniforms"].size(), shader.uniforms.size());
        EXPECT_EQ(told["uniforms"][0]["values"].get<std::vector<float>>(),
                  shader.uniforms[0].values);
        std::size_t at = 0;
        ASSERT_EQ(told["binary"].size(), shader.textures.size());
        for (std::size_t i = 0; i < shader.textures.size(); ++i) {
            const auto& texture = shader.textures[i];
            std::size_t count = 1;
            for (const Tree& side : told["binary"][i]["shape"]) count *= side.get<std::size_t>();
            ASSERT_EQ(count, texture.rgba.size());
            EXPECT_EQ(std::memcmp(bytes.data() + at, texture.rgba.data(), 2 * count), 0);
            at += 2 * count;
        }
        EXPECT_EQ(at, bytes.size());
        const auto films = exchange::make_live_webgl_films(*solved);
        EXPECT_EQ(told_films["uniforms"][0]["values"].get<std::vector<float>>(),
                  films.uniform.values);
        ASSERT_EQ(bytes_of_films.size(), 2 * films.texture.rgba.size());
        EXPECT_EQ(
            std::memcmp(bytes_of_films.data(), films.texture.rgba.data(), bytes_of_films.size()),
            0);
    }
}

TEST(StudioSession, ErrorsSayWhere) {
    const RunningServer server;
    PageClient page(server);
    Tree tree = red_gold_tree();
    tree["layer"][0]["thickness_um"] = -3;
    page.send({{"type", "paint"}, {"id", 1}, {"recipe", tree}});
    const Tree error = page.read();
    EXPECT_EQ(error["type"], "error");
    EXPECT_EQ(error["id"], 1);
    EXPECT_EQ(error["about"], "paint");
    EXPECT_EQ(error["key"], "layer[0].thickness_um");
    EXPECT_EQ(error["range"], "(0, 1000000] um");
    // The line is that of the text that the tree becomes.
    const std::string toml = toml_of_tree(tree);
    std::size_t start = 0;
    for (int line = 1; line < error["line"]; ++line) start = toml.find('\n', start) + 1;
    EXPECT_THAT(toml.substr(start), StartsWith("thickness_um = -3\n"));

    page.send_text("nonsense");
    EXPECT_THAT(page.read()["message"], HasSubstr("is not JSON"));
    page.send({{"type", "paint"}, {"id", 2}, {"recipe", red_gold_tree()}});
    EXPECT_EQ(page.read_until("done")["id"], 2);
}

TEST(StudioSession, ErrorsNameTheFileThatWasOpened) {
    const RunningServer server;
    PageClient page(server);
    const auto error_of = [&](Tree message) {
        message.update({{"type", "open"}, {"id", 1}, {"toml", "ior = 1.5\nlayer = 3\n"}});
        page.send(message);
        return page.read_until("error");
    };
    EXPECT_EQ(error_of(Tree::object())["message"].get<std::string>().find("recipe.toml:2:"), 0u);
    const Tree named = error_of({{"name", "mine.toml"}});
    EXPECT_EQ(named["message"].get<std::string>().find("mine.toml:2:"), 0u) << named.dump();
    EXPECT_EQ(named["line"], 2);
}

TEST(StudioSession, ARecipeFromThePageNamesNoFiles) {
    const RunningServer server;
    PageClient page(server);
    const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "secret.csv";
    write_file_atomically(file, "wavelength_nm,n,k\n300,1.6,0\n800,1.5,0\n");
    const auto refused = [&](const Tree& recipe) {
        page.send({{"type", "paint"}, {"id", 1}, {"recipe", recipe}});
        const Tree answer = page.read();
        EXPECT_EQ(answer["type"], "error") << answer.dump();
        page.send({{"type", "open"}, {"id", 2}, {"toml", toml_of_tree(recipe)}});
        EXPECT_EQ(page.read()["type"], "error");
    };
    Tree tree = red_gold_tree();
    tree["ior"] = file.string();
    refused(tree);
    tree = red_gold_tree();
    tree["layer"][0]["pigment"] =
        Tree::array({{{"from", file.string()}, {"volume_fraction", 0.1}}});
    refused(tree);
    tree = red_gold_tree();
    tree["substrate"] = {{"reflectance", file.string()}};
    refused(tree);
    // What it names by itself in the program's data is no such file.
    tree = red_gold_tree();
    tree["layer"][0]["pigment"] =
        Tree::array({{{"from", "carbon-black-fine"}, {"volume_fraction", 0.001}}});
    page.send({{"type", "paint"}, {"id", 3}, {"recipe", tree}});
    EXPECT_EQ(page.read_until("done")["id"], 3);
}

TEST(StudioSession, ComparesWithAStandard) {
    const RunningServer server;
    PageClient page(server);
    const Paint other = open(find_paint("tio2-mica-80"));
    const Readings standard = other.measure(geometries("45as15,45as45,45as110"));
    page.send({{"type", "standard"}, {"id", 1}, {"csv", standard.csv()}, {"name", "panel.csv"}});
    const Tree told = page.read();
    ASSERT_EQ(told["type"], "standard") << told.dump();
    EXPECT_EQ(told["geometries"], Tree({"45as15", "45as45", "45as110"}));

    page.send(
        {{"type", "paint"}, {"id", 2}, {"recipe", red_gold_tree()}, {"tolerance", {{"limit", 1}}}});
    const Tree compared = page.read_until("readings")["standard"];
    const Readings sample = open(find_paint("red-gold")).measure(geometries("byk-mac"));
    const auto difference = measure::difference(standard.measurement, sample.measurement);
    ASSERT_EQ(compared["delta_e_2000"].size(), 6u) << compared.dump();
    EXPECT_TRUE(compared["delta_e_2000"][0].is_null());  // 45as-15 was not read
    EXPECT_DOUBLE_EQ(compared["delta_e_2000"][1].get<double>(), difference.angles[0].delta_e_2000);
    EXPECT_DOUBLE_EQ(compared["mean"].get<double>(), difference.mean_delta_e_2000);
    EXPECT_EQ(compared["passes"][1], false);
    EXPECT_EQ(compared["all_pass"], false);

    page.send({{"type", "standard"}, {"id", 3}, {"csv", "no,colours\n1,2\n"}});
    EXPECT_EQ(page.read_until("done")["id"], 2);
    EXPECT_EQ(page.read()["type"], "error");
    page.send({{"type", "standard"}, {"id", 4}, {"csv", nullptr}});
    EXPECT_TRUE(page.read()["name"].is_null());
}

TEST(StudioSession, FitsFromThePage) {
    const RunningServer server;
    PageClient page(server);
    Tree tree = tree_of_toml(read_file(find_paint("tio2-mica-80")), "recipe.toml");
    const std::string key = "layer[0].flakes[0].coats[0].thickness_nm";
    const Paint wanted = open(find_paint("tio2-mica-80")).with(key, 95);
    page.send({{"type", "standard"}, {"id", 1}, {"csv", wanted.measure().csv()}});
    EXPECT_EQ(page.read()["type"], "standard");
    page.send({{"type", "fit"}, {"id", 2}, {"recipe", tree}, {"free", {key}}, {"starts", 1}});
    const Tree found = page.read_until("matches");
    EXPECT_EQ(found["id"], 2);
    EXPECT_EQ(found["matched"], true);
    const Tree& best = found["matches"][0];
    EXPECT_NEAR(best["parameters"][0]["value"].get<double>(), 95, 0.1);
    EXPECT_EQ(best["parameters"][0]["unit"], "nm");
    EXPECT_NEAR(best["recipe"]["layer"][0]["flakes"][0]["coats"][0]["thickness_nm"].get<double>(),
                95, 0.1);
    EXPECT_EQ(best["recipe"].dump(),
              tree_of_toml(best["toml"].get<std::string>(), "recipe.toml").dump());
}

TEST(StudioSession, AnAtlasIsThePaintAtEachValue) {
    const RunningServer server;
    PageClient page(server);
    const std::string key = "layer[0].flakes[0].coats[0].thickness_nm";
    page.send({{"type", "atlas"},
               {"id", 1},
               {"recipe", red_gold_tree()},
               {"key", key},
               {"values", {200, 220}},
               {"geometries", "45as15,45as45"}});
    const Tree atlas = page.read_until("atlas");
    ASSERT_EQ(atlas["lab"].size(), 2u);
    const Measurement other = open(find_paint("red-gold"))
                                  .with(key, 220)
                                  .measure(geometries("45as15,45as45"))
                                  .measurement;
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(atlas["lab"][1][1][c].get<double>(), other.readings[1].lab[c], 1e-9);
    }
    page.send({{"type", "atlas"}, {"id", 2}, {"recipe", red_gold_tree()}, {"values", {1}}});
    EXPECT_EQ(page.read()["type"], "error");
}

TEST(StudioSession, AFitStopsWhenItIsTold) {
    const RunningServer server;
    PageClient page(server);
    page.send({{"type", "standard"}, {"id", 1}, {"csv", open(find_paint("ruby")).measure().csv()}});
    EXPECT_EQ(page.read()["type"], "standard");
    page.send({{"type", "fit"},
               {"id", 2},
               {"recipe", red_gold_tree()},
               {"free", {"*"}},
               {"starts", 256}});
    page.read_until("progress");
    page.send({{"type", "stop"}, {"id", 3}, {"what", "fit"}});
    const Tree stopped = page.read_until("stopped");
    EXPECT_EQ(stopped["id"], 3);
    EXPECT_EQ(stopped["jobs"], 1);
    // The lane is free for the next, which answers at once that no number is named so.
    page.send({{"type", "fit"}, {"id", 4}, {"recipe", red_gold_tree()}, {"free", {"nothing"}}});
    Tree answer = page.read();
    while (answer["type"] == "progress") answer = page.read();
    EXPECT_EQ(answer["type"], "error");
    EXPECT_EQ(answer["id"], 4);
}

TEST(StudioSession, PicturesConvergeToThatOfTheCommandLine) {
    const RunningServer server;
    PageClient page(server);
    page.send({{"type", "render"},
               {"id", 1},
               {"recipe", red_gold_tree()},
               {"scene", {{"shape", "ball"}, {"light", "studio"}}},
               {"width", 24},
               {"height", 16},
               {"samples", 6},
               {"linear", true}});
    std::vector<int> samples;
    std::string bytes;
    while (samples.empty() || samples.back() != 6) {
        const Tree picture = page.read_until("picture");
        samples.push_back(picture["samples"]);
        EXPECT_EQ(picture["of"], 6);
        bytes = page.read_bytes();
        ASSERT_EQ(bytes.size(), 24u * 16 * 3 * 5);
    }
    // Those that a slow reader missed aside.
    EXPECT_THAT(samples, testing::IsSubsetOf({1, 4, 6}));
    const Scene scene(scene_of({}), {.slot = open(find_paint("red-gold"))});
    const Picture whole =
        scene.render({.width = 24, .height = 16, .samples_per_pixel = 6, .noise = true});
    std::vector<float> linear(24 * 16 * 3);
    std::memcpy(linear.data(), bytes.data() + linear.size(), 4 * linear.size());
    EXPECT_EQ(linear, whole.result.rgb);
}

}  // namespace
}  // namespace nacre::studio
