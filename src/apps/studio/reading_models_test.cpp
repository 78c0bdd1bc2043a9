#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apps/studio/server_test_support.h"
#include "nacre/core/file.h"
#include "nacre/models/models.h"
#include "nacre/nacre.h"

// The model by which paints are read: that of every answer with readings in it.

namespace nacre::studio {
namespace {

using testing::HasSubstr;

constexpr const char* kFilm = "layer[0].flakes[0].coats[0].thickness_nm";

std::string toml_of(const std::string& paint) { return read_file(find_paint(paint)); }
Tree tree_of(const std::string& paint) { return tree_of_toml(toml_of(paint), "recipe.toml"); }

std::string measured(const Paint& paint, const std::string& model) {
    return paint.measure(geometries("byk-mac"), {.model = models::named_model(model)}).csv();
}

TEST(StudioReadingModels, ReadingsAreThoseOfMeasureByEach) {
    const RunningServer server;
    PageClient page(server);
    // Under a smooth coat and under a rough one.
    for (const char* paint : {"red-gold", "satin-silver"}) {
        const Tree tree = tree_of(paint);
        const Paint same = open_text(toml_of_tree(tree), "recipe.toml");
        const auto read_by = [&](const Tree& model) {
            page.send({{"type", "paint"}, {"id", 1}, {"recipe", tree}, {"model", model}});
            return page.read_until("readings");
        };
        for (const std::string_view name : models::names_of_fitted()) {
            const std::string model(name);
            const Tree readings = read_by(model);
            EXPECT_EQ(readings["model"], model);
            EXPECT_EQ(readings["csv"].get<std::string>(), measured(same, model)) << model;
        }
        EXPECT_NE(measured(same, "microflake"), measured(same, "nacre"));
        EXPECT_EQ(read_by(nullptr)["csv"].get<std::string>(), same.measure().csv());
    }
}

TEST(StudioReadingModels, AStandardThatIsAPaintIsReadByTheSame) {
    const RunningServer server;
    PageClient page(server);
    const Tree tree = tree_of("red-gold");
    for (const std::string_view name : models::names_of_fitted()) {
        const std::string model(name);
        page.send({{"type", "standard"},
                   {"id", 1},
                   {"csv", toml_of_tree(tree)},
                   {"name", "standard.toml"},
                   {"model", model}});
        const Tree told = page.read_until("standard");
        page.send({{"type", "paint"}, {"id", 2}, {"recipe", tree}, {"model", model}});
        const Tree readings = page.read_until("readings");
        EXPECT_EQ(told["lab"], readings["lab"]);
        EXPECT_EQ(readings["standard"]["lab"], readings["lab"]);
        EXPECT_EQ(readings["standard"]["mean"], 0);
    }
    // Measured colours are what was measured.
    page.send(
        {{"type", "standard"}, {"id", 3}, {"csv", measured(open(find_paint("ruby")), "nacre")}});
    const Tree told = page.read_until("standard");
    page.send({{"type", "paint"}, {"id", 4}, {"recipe", tree}, {"model", "microflake"}});
    EXPECT_EQ(page.read_until("readings")["standard"]["lab"], told["lab"]);
}

TEST(StudioReadingModels, FitsSeePaintsByIt) {
    const RunningServer server;
    PageClient page(server);
    const std::string paint = "metallic-silver";
    const Tree tree = tree_of(paint);
    const Paint start = open_text(toml_of_tree(tree), "recipe.toml");
    const std::string csv = measured(start.with(start.whole_key("alpha"), 0.13), "nacre");
    page.send({{"type", "standard"}, {"id", 1}, {"csv", csv}});
    EXPECT_EQ(page.read()["type"], "standard");
    for (const std::string_view name : models::names_of_fitted()) {
        const std::string model(name);
        page.send({{"type", "fit"},
                   {"id", 2},
                   {"recipe", tree},
                   {"free", {"alpha"}},
                   {"starts", 1},
                   {"model", model}});
        const Tree found = page.read_until("matches");
        EXPECT_EQ(found["model"], model);
        FitSettings settings;
        settings.starts = 1;
        settings.target.hot_spot = models::named_model(model).shows_hot_spot();
        const Match match = start.fit(open_text(csv, "standard.csv").measure().measurement,
                                      {start.whole_key("alpha")}, settings);
        const Tree& best = found["matches"][0];
        EXPECT_EQ(best["parameters"][0]["value"].get<double>(), match.parameters[0].value);
        EXPECT_EQ(best["mean_delta_e"].get<double>(), match.difference.mean_delta_e_2000);
        if (model == "nacre") {
            EXPECT_NEAR(match.parameters[0].value, 0.13, 1e-3);
            EXPECT_LT(match.difference.max_delta_e_2000, 0.05);
        }
    }
}

TEST(StudioReadingModels, AtlasesShowWhatIsReadByIt) {
    const RunningServer server;
    PageClient page(server);
    for (const std::string_view name : models::names_of_fitted()) {
        const std::string model(name);
        page.send({{"type", "atlas"},
                   {"id", 1},
                   {"recipe", tree_of("red-gold")},
                   {"key", kFilm},
                   {"values", {220}},
                   {"geometries", "45as15,45as45"},
                   {"model", model}});
        const Tree atlas = page.read_until("atlas");
        EXPECT_EQ(atlas["model"], model);
        const Measurement same =
            open_text(toml_of_tree(tree_of("red-gold")), "recipe.toml")
                .with(kFilm, 220)
                .measure(geometries("45as15,45as45"), {.model = models::named_model(model)})
                .measurement;
        for (int g = 0; g < 2; ++g) {
            for (int c = 0; c < 3; ++c) {
                EXPECT_EQ(atlas["lab"][g][0][c].get<double>(), same.readings[g].lab[c]);
            }
        }
    }
}

TEST(StudioReadingModels, ReportsAreReadByItAndSaySo) {
    const RunningServer server;
    PageClient page(server);
    const auto report = [&](const std::string& model) {
        page.send({{"type", "report"},
                   {"id", 1},
                   {"recipe", tree_of("red-gold")},
                   {"model", model},
                   {"draft", true}});
        return page.read_until("report")["html"].get<std::string>();
    };
    EXPECT_THAT(report("nacre"), AllOf(HasSubstr("by the model nacre (this project)."),
                                       HasSubstr("· model nacre ·")));
    EXPECT_THAT(report("microflake"),
                AllOf(HasSubstr("but for pictures and sparkle, by the model nacre"),
                      HasSubstr("· model microflake (pictures: nacre) ·")));
}

TEST(StudioReadingModels, AnotherIsRefusedByName) {
    const RunningServer server;
    PageClient page(server);
    for (const char* type : {"paint", "standard", "fit", "report", "atlas"}) {
        Tree message = {{"type", type}, {"id", 1}, {"model", "nacer"}, {"values", {1}}};
        if (std::string(type) != "atlas") message.erase("values");
        if (std::string(type) != "standard") message["recipe"] = Tree::object();
        page.send(message);
        EXPECT_EQ(page.read()["message"],
                  "model = \"nacer\": is no model by which paints are read here (did you mean "
                  "'nacre'?); there are: microflake, nacre")
            << type;
    }
    // One that there is for pictures.
    page.send({{"type", "paint"}, {"id", 2}, {"recipe", Tree::object()}, {"model", "volume"}});
    EXPECT_THAT(page.read()["message"].get<std::string>(), HasSubstr("model = \"volume\": is no"));
}

TEST(StudioReadingModels, TheSchemaOffersThem) {
    const auto schema_of = [](const ServerSettings& settings) {
        return Tree::parse(RunningServer(settings).api("/api/schema").body);
    };
    const Tree schema = schema_of({});
    ASSERT_EQ(schema["reading_models"].size(), models::names_of_fitted().size());
    EXPECT_EQ(schema["reading_models"][1]["name"], "nacre");
    // By default as nacre measure.
    EXPECT_EQ(schema["reading_model"], models::default_model().info().name);
    EXPECT_EQ(schema_of({.reading_model = "nacre"})["reading_model"], "nacre");
}

}  // namespace
}  // namespace nacre::studio
