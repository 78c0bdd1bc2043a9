#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "nacre/core/error.h"
#include "nacre/io/measurement_file.h"
#include "nacre/io/recipe_file.h"
#include "nacre/library.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/files.h"
#include "nacre/testing/fit.h"

namespace nacre {
namespace {

using nacre::test::message_of;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::UnorderedElementsAre;

const std::string kLibraryFilm = "layer[0].flakes[0].coats[0].thickness_nm";

/// A folder of records as nacre-library writes them, as far as they are read here.
class PaintLibrary : public ::testing::Test {
 protected:
    void add(const std::string& id, const paint::Recipe& recipe, const std::string& construction,
             const nlohmann::json& swept) {
        const std::string folder = "records/" + id.substr(0, 2) + "/" + id;
        std::filesystem::create_directories(folder_ / folder);
        folder_.write(folder + "/recipe.toml", io::write_recipe(recipe));
        folder_.write(folder + "/readings.csv", io::measurement_csv(fit::testing::read(recipe)));
        folder_.write(
            folder + "/record.json",
            nlohmann::json{{"name", recipe.name}, {"construction", construction}, {"swept", swept}}
                .dump());
    }
    std::filesystem::path path() const { return folder_ / ""; }

    nacre::test::TempFolder folder_;
};

TEST_F(PaintLibrary, FitsEachOfTheNearestConstructionsFromItsNearestRecord) {
    using fit::testing::pearl;
    add("aa1", pearl(80), "pearl", {{kLibraryFilm, 80}});
    add("aa2", pearl(120), "pearl",
        {{kLibraryFilm, 120},
         {"layer[0].flakes[0].diameter_um", 20},  // which no fit can tell
         {"layer[0].flakes[0].waviness", 0},      // no number of a recipe where it is 0
         {"layer[0].flakes[0].core", "mica"}});
    add("bb1", fit::testing::solid(), "solid", nlohmann::json::object());
    const Measurement standard = fit::testing::read(pearl(127));

    const std::vector<NearestRecord> nearest = nearest_constructions(path(), standard, 5);
    ASSERT_EQ(nearest.size(), 2u);
    EXPECT_EQ(nearest[0].construction, "pearl");
    EXPECT_EQ(nearest[0].folder.filename(), "aa2");
    using Bounds = paint::ParameterBounds;
    EXPECT_THAT(nearest[0].swept,
                UnorderedElementsAre(Bounds{kLibraryFilm, 80, 120},
                                     Bounds{"layer[0].flakes[0].diameter_um", 20, 20},
                                     Bounds{"layer[0].flakes[0].waviness", 0, 0}));
    EXPECT_EQ(nearest[0].shared_geometries, standard.readings.size());
    EXPECT_GT(nearest[1].mean_delta_e_2000, nearest[0].mean_delta_e_2000);
    EXPECT_EQ(nearest_constructions(path(), standard, 1).size(), 1u);

    FitSettings settings;
    settings.starts = 1;
    const std::vector<ConstructionMatch> matches = fit_from_library(path(), standard, 2, settings);
    ASSERT_EQ(matches.size(), 2u);
    EXPECT_EQ(matches[0].start.construction, "pearl");
    EXPECT_TRUE(matches[0].match.matched());
    EXPECT_NEAR(matches[0].match.parameters[0].value, 127, 0.1);
    // From no sweep: the pigment's coefficients, and nothing else, are turned.
    EXPECT_FALSE(matches[1].match.matched());
    for (const auto& parameter : matches[1].match.parameters) {
        EXPECT_THAT(parameter.number.bounds.key, HasSubstr("pigment[0]"));
    }

    // Of more constructions than are to be fitted, what rough fits say is nearest.
    std::vector<double> told;
    const std::vector<ConstructionMatch> one =
        fit_from_library(path(), standard, 1, settings, [&](double fraction) {
            told.push_back(fraction);
            return true;
        });
    ASSERT_EQ(one.size(), 1u);
    EXPECT_EQ(one[0].start.construction, "pearl");
    EXPECT_EQ(one[0].match.recipe, matches[0].match.recipe);
    EXPECT_TRUE(std::ranges::is_sorted(told));
    EXPECT_THROW(fit_from_library(path(), standard, 1, settings, [](double) { return false; }),
                 Stopped);
}

TEST_F(PaintLibrary, RefusesWhatIsNone) {
    const Measurement standard = fit::testing::read(fit::testing::pearl(80));
    const auto refusal = [&] {
        return message_of<InputError>([&] { nearest_constructions(path(), standard, 3); });
    };
    EXPECT_THAT(refusal(), HasSubstr("has no records"));
    add("aa1", fit::testing::pearl(80), "pearl", nlohmann::json::object());
    folder_.write("records/aa/aa1/record.json", "{}");
    EXPECT_THAT(refusal(), AllOf(HasSubstr("aa1"), HasSubstr("is no record")));
    folder_.write("records/aa/aa1/readings.csv", "geometry,L,a,b\n20as20,1,2,3\n");
    EXPECT_THAT(refusal(), HasSubstr("none of its 1 records has readings at a geometry"));
    folder_.write("records/aa/aa1/readings.csv", "no table");
    EXPECT_THAT(refusal(), HasSubstr("readings.csv"));
}

}  // namespace
}  // namespace nacre
