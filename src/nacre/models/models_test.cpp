#include "nacre/models/models.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "nacre/bsdf/models/microflake.h"
#include "nacre/bsdf/models/nacre.h"
#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/core/math.h"
#include "nacre/core/random.h"
#include "nacre/io/recipe_file.h"
#include "nacre/models/spectral_brdf.h"
#include "nacre/models/traced/traced_models.h"
#include "nacre/montecarlo/discs/disc_walk.h"
#include "nacre/montecarlo/shell_walk.h"
#include "nacre/solver/solver.h"
#include "nacre/spectra/spectrum.h"
#include "nacre/testing/directions.h"
#include "nacre/testing/errors.h"

// The capabilities that the list of models states (Table 3 of Mir et al. 2022) are measured here.

namespace nacre::models {
namespace {

using bsdf::Ingredients;
using bsdf::ModelInfo;
using test::direction;
using test::kOnGrid;
using test::message_of;

std::shared_ptr<const bsdf::Bsdf> pearl(const ModelInfo* model) {
    static const paint::Recipe recipe = io::read_recipe(shipped_file("paints/tio2-mica-80.toml"));
    static const auto solved = std::make_shared<const solver::SolvedPaint>(
        solver::solve(recipe, spectra::default_wavelengths_nm(), {}));
    return model->standard().make({recipe, solved, {}});
}

/// Albedo by wavelength without the specular lobe, and the fraction of it that leaves more than
/// 60 deg from the mirror direction, by sampling: all models can do that.
struct Reflected {
    FloatLanes mean{};
    double far_fraction = 0;
};
Reflected reflected(const bsdf::BoundBsdf& surface, double theta_deg) {
    constexpr int kSamples = 20000;
    const Vec3f wi = direction(theta_deg), specular{-wi.x, -wi.y, wi.z};
    Rng rng(11, 3);
    Reflected out;
    double far = 0, all = 0;
    for (int i = 0; i < kSamples; ++i) {
        const float u_select = rng.uniform_float();
        const auto s = surface.sample(wi, u_select, {rng.uniform_float(), rng.uniform_float()});
        if (!s || dot(s->wo, specular) > 1 - 1e-5f) continue;
        out.mean += s->weight;
        all += lane_mean(s->weight);
        if (dot(s->wo, specular) < 0.5f) far += lane_mean(s->weight);
    }
    out.mean *= 1.0f / kSamples;
    out.far_fraction = far / all;
    return out;
}

TEST(Models, NamesAreFoundAndUnknownOnesAreNot) {
    ASSERT_FALSE(all_models().empty());
    for (const ModelInfo* model : all_models()) {
        EXPECT_EQ(find_model(model->name), model);
        EXPECT_EQ(&model->standard().info(), model);
    }
    EXPECT_EQ(find_model("no-such-model"), nullptr);
}

TEST(Models, AreMadeByTheirNames) {
    ASSERT_FALSE(all_models().empty());
    for (const ModelInfo* model : all_models()) {
        EXPECT_EQ(named_model(model->name), model->standard());
    }
    EXPECT_EQ(message_of<DomainError>([] { named_model("pearl"); }),
              "model = pearl: is no model; there are: microflake, thin-film, special-effect, "
              "nacre, walk, volume");
}

TEST(Models, ThoseWithArraysBeginWithThatOfPictures) {
    EXPECT_THAT(names_with_arrays(), ::testing::ElementsAre("nacre", "microflake"));
    EXPECT_EQ(names_with_arrays().front(), default_picture_model().info().name);
    EXPECT_TRUE(default_model().makes_arrays());
    EXPECT_FALSE(bsdf::Model(bsdf::MicroflakeModel{.table = bsdf::MicroflakeModel::Table::svd})
                     .makes_arrays());
}

TEST(Models, PaintsAreSoughtByThoseOfSolutionsAlone) {
    int fitted = 0;
    for (const ModelInfo* model : all_models()) {
        EXPECT_EQ(model->can.fitted, model->solution != bsdf::Solution::none) << model->name;
        fitted += model->can.fitted;
        // What a fit does not see must not be asked of it.
        EXPECT_TRUE(model->can.fitted || !model->standard().shows_hot_spot()) << model->name;
    }
    EXPECT_EQ(fitted, 2);
}

TEST(Models, GoniochromismIsAsListed) {
    for (const ModelInfo* model : all_models()) {
        const auto surface = pearl(model)->bind(kOnGrid);
        const FloatLanes steep = reflected(*surface, 5).mean, flat = reflected(*surface, 75).mean;
        // Change of the spectrum's shape: mean difference of the two, both scaled to mean 1.
        double change = 0;
        for (int i = 0; i < kLanes; ++i) {
            change += std::abs(steep[i] / lane_mean(steep) - flat[i] / lane_mean(flat)) / kLanes;
        }
        EXPECT_EQ(change > 0.1, model->can.goniochromism) << model->name << ": " << change;
    }
}

TEST(Models, SparkleIsAsListed) {
    for (const ModelInfo* model : all_models()) {
        const auto surface = pearl(model);
        const auto bound = surface->bind(kOnGrid);
        const Vec3f wi = direction(20), wo = direction(-20);
        bool differs = false;
        for (double u : {0.1, 0.2, 0.3, 0.4}) {
            // A thousandth of the object's side; on one of 100 mm.
            const auto patch = [&](double v) {
                const auto mm = [](double x) { return static_cast<float>(100 * x); };
                return bsdf::Patch{.u = u,
                                   .v = v,
                                   .edge_1 = {1e-3f, 0},
                                   .edge_2 = {0, 1e-3f},
                                   .footprint = {.position_mm = {mm(u), mm(v), 0},
                                                 .edge_mm = {{0.1f, 0, 0}, {0, 0.1f, 0}}}};
            };
            const bsdf::Patch a = patch(0.3), b = patch(0.7);
            differs |= bound->evaluate_on(a, wi, wo).f[3] != bound->evaluate_on(b, wi, wo).f[3];
        }
        EXPECT_EQ(differs, model->can.sparkle) << model->name;
        EXPECT_EQ(surface->varies_over_surface(), model->can.sparkle) << model->name;
        EXPECT_EQ(surface->surface_coordinates(), model->coordinates) << model->name;
    }
}

TEST(Models, MultipleScatteringIsAsListed) {
    // One reflection off flakes of alpha 0.1 sends light at most some 20 deg off the mirror
    // direction, 30 deg outside the coat; light that leaves farther has met several.
    for (const ModelInfo* model : all_models()) {
        const auto surface = pearl(model)->bind(kOnGrid);
        const double far = reflected(*surface, 30).far_fraction;
        EXPECT_EQ(far > 1e-3, model->can.multiple_scattering) << model->name << ": " << far;
    }
}

TEST(Models, ReferencesGiveNoValuesAndTheOthersDo) {
    for (const ModelInfo* model : all_models()) {
        const SpectralBrdf brdf(*pearl(model), {500, 550, 600});
        const std::vector<double> f = brdf(20 * kDegree, 20 * kDegree, 180 * kDegree);
        ASSERT_EQ(f.size(), 3u);
        EXPECT_EQ(std::accumulate(f.begin(), f.end(), 0.0) == 0, model->can.reference_only)
            << model->name;
    }
}

TEST(Models, RecipeWithoutWhatTheModelReadsIsRefused) {
    paint::Recipe no_facets = io::read_recipe(shipped_file("paints/metallic-gray.toml"));
    int refused = 0;
    for (const ModelInfo* model : all_models()) {
        if (model->ingredients == Ingredients::layers) continue;
        EXPECT_THROW(model->standard().make({.recipe = no_facets}), DomainError) << model->name;
        ++refused;
    }
    EXPECT_EQ(refused, 2);
    paint::Recipe no_layers = io::read_recipe(shipped_file("studies/mir-2022/facets-570.toml"));
    for (const ModelInfo* model : all_models()) {
        if (model->ingredients != Ingredients::layers) continue;
        EXPECT_THROW(model->standard().make({.recipe = no_layers}), DomainError) << model->name;
    }
}

/// All entries, those of models that trace rays included.
std::vector<const ModelInfo*> all_entries() {
    std::vector<const ModelInfo*> entries(all_models().begin(), all_models().end());
    entries.insert(entries.end(), traced_models().begin(), traced_models().end());
    return entries;
}

TEST(Models, EachEntrySaysWhatItIs) {
    ASSERT_GT(all_entries().size(), all_models().size());
    for (const ModelInfo* model : all_entries()) {
        SCOPED_TRACE(model->name);
        EXPECT_FALSE(model->name.empty());
        EXPECT_FALSE(model->summary.empty());
        EXPECT_FALSE(model->source.empty());
        EXPECT_EQ(&model->standard().info(), model);
        EXPECT_EQ(model->standard(), model->standard());
        EXPECT_EQ(model->coordinates != bsdf::SurfaceCoordinates::none, model->can.sparkle);
        // A model with estimated values is a reference; one with parts needs a solved paint.
        EXPECT_TRUE(model->can.reference_only || !model->can.estimated_values);
        EXPECT_TRUE(model->solution != bsdf::Solution::none || !model->can.parts);
        // With default settings no model renders from a table.
        EXPECT_FALSE(model->standard().makes_table());
    }
}

std::string refusal(const bsdf::Model& model, const bsdf::ModelOption& option,
                    const std::string& text) {
    bsdf::Model changed = model;
    return message_of<DomainError>([&] { set_option(changed, option, text); });
}

TEST(Models, OptionsTakeWhatIsAllowedAndNameItWhenTheyRefuse) {
    using ::testing::AllOf, ::testing::HasSubstr;
    int found = 0;
    for (const ModelInfo* model : all_entries()) {
        for (const bsdf::ModelOption& option : model->options) {
            SCOPED_TRACE(option.flag);
            ++found;
            EXPECT_EQ(option.flag.substr(0, 2), "--");
            // The help of options says whose they are.
            EXPECT_EQ(option.help.substr(0, model->name.size()), model->name);
            const bsdf::Model standard = model->standard();
            std::vector<std::string> allowed, refused = {"", "no-such-value"}, named;
            if (!option.names.empty()) {
                allowed.assign(option.names.begin(), option.names.end());
                named = allowed;
            } else if (option.range) {
                const auto [lo, hi] = *option.range;
                allowed = named = {std::to_string(lo), std::to_string(hi)};
                refused.push_back(std::to_string(lo - 1));
                refused.push_back(std::to_string(hi + 1));
                refused.push_back(std::to_string(lo) + ".5");
            } else {
                allowed = named = {"on", "off"};
            }
            int changes = 0;
            for (const std::string& text : allowed) {
                bsdf::Model changed = standard;
                set_option(changed, option, text);
                EXPECT_EQ(option_text(changed, option), text);
                EXPECT_EQ(changed == standard, text == option_text(standard, option)) << text;
                changes += changed != standard;
            }
            EXPECT_GT(changes, 0);
            for (const std::string& text : refused) {
                const std::string message = refusal(standard, option, text);
                EXPECT_THAT(message, HasSubstr(fmt::format("{} = {}: must be", option.flag, text)));
                for (const std::string& value : named) EXPECT_THAT(message, HasSubstr(value));
            }
        }
    }
    EXPECT_EQ(found, 6);
}

TEST(Models, TextsTellAnyTwoModelsApart) {
    std::vector<bsdf::Model> different;
    for (const ModelInfo* model : all_entries()) {
        different.push_back(model->standard());
        for (const bsdf::ModelOption& option : model->options) {
            different.push_back(model->standard());
            const bool on = option.get(different.back()) != 0;
            const int last = option.range           ? option.range->second
                             : option.names.empty() ? !on
                                                    : static_cast<int>(option.names.size()) - 1;
            option.set(different.back(), last);
        }
        if (!model->standard().specimen()) continue;
        different.push_back(model->standard());
        different.back().set_specimen((std::uint64_t{1} << 60) + 1);
    }
    // What is no option.
    different.push_back(bsdf::MicroflakeModel{.table_size = {.angles = 32}});
    different.push_back(bsdf::MicroflakeModel{.table_size = {.azimuths = 32}});
    different.push_back(bsdf::MicroflakeModel{.compression = {.rank = 4}});
    different.push_back(bsdf::MicroflakeModel{.compression = {.tolerance = 1e-4}});
    different.push_back(bsdf::MicroflakeModel{.compression = {.clip_to_gamut = true}});
    different.push_back(montecarlo::VolumeModel{.radius_mm = 50});
    different.push_back(montecarlo::ExplicitFlakesModel{.tile_width_mm = 3});
    different.push_back(montecarlo::ExplicitFlakesModel{.tile_height_mm = 3});
    different.push_back(montecarlo::ExplicitFlakesModel{.diffraction = false});
    for (const bsdf::Model& a : different) {
        EXPECT_EQ(bsdf::Model(a).text(), a.text());
        for (const bsdf::Model& b : different) {
            EXPECT_EQ(a.text() == b.text(), a == b) << a.text();
            EXPECT_EQ(a == b, &a == &b) << a.text();
        }
    }
}

// Of microflake in the waves of its coat.
TEST(Models, SpecimensDifferWhereSingleFlakesOrWavesAreShown) {
    for (const ModelInfo* model : all_entries()) {
        bsdf::Model other = model->standard();
        other.set_specimen(7);
        const bool waves = model->standard().get<bsdf::MicroflakeModel>() != nullptr;
        EXPECT_EQ(other != model->standard(), model->can.sparkle || waves) << model->name;
    }
}

TEST(Models, AlternativesTakeOverWhatWasChosen) {
    ASSERT_FALSE(traced_models().empty());
    for (const ModelInfo* model : traced_models()) {
        ASSERT_NE(model->alternative, nullptr);
        const bsdf::Alternative& alternative = *model->alternative;
        EXPECT_EQ(find_model(alternative.to->name), alternative.to);
        EXPECT_EQ(model->name, alternative.to->name);
        bsdf::Model other = alternative.to->standard(), same = model->standard();
        other.set_specimen(7);
        same.set_specimen(7);
        EXPECT_EQ(alternative.from(other), same);
    }
    EXPECT_THROW(montecarlo::ExplicitFlakesModel::info.alternative->from(
                     bsdf::NacreModel{.hot_spot = false}),
                 DomainError);
}

TEST(Models, ModelsThatFollowAShapeRefuseOthers) {
    using bsdf::PaintedShape;
    const PaintedShape ball{.kind = PaintedShape::Kind::sphere, .radius_mm = 50},
        small_ball{.kind = PaintedShape::Kind::sphere, .radius_mm = 20},
        panel{.kind = PaintedShape::Kind::panel, .width_mm = 150, .height_mm = 100},
        small_panel{.kind = PaintedShape::Kind::panel, .width_mm = 15, .height_mm = 10}, mesh{};
    const auto accepts = [](bsdf::Model model, const std::vector<PaintedShape>& shapes) {
        const std::string message = message_of<DomainError>([&] { model.lie_on("red", shapes); });
        if (message == "accepted") return true;
        EXPECT_THAT(message, ::testing::HasSubstr("the material red is on"));
        return false;
    };
    const montecarlo::VolumeModel volume;
    EXPECT_TRUE(accepts(volume, {ball, ball}));
    EXPECT_TRUE(accepts(volume, {panel, small_panel}));
    EXPECT_FALSE(accepts(volume, {ball, small_ball}));
    EXPECT_FALSE(accepts(volume, {ball, panel}));
    EXPECT_FALSE(accepts(volume, {mesh}));
    bsdf::Model on_ball = volume;
    on_ball.lie_on("red", std::vector{ball});
    EXPECT_EQ(on_ball, montecarlo::VolumeModel{.radius_mm = 50});

    const montecarlo::ExplicitFlakesModel flakes;
    EXPECT_TRUE(accepts(flakes, {panel, panel}));
    EXPECT_FALSE(accepts(flakes, {panel, small_panel}));
    EXPECT_FALSE(accepts(flakes, {ball}));
    bsdf::Model under_panel = flakes;
    under_panel.lie_on("red", std::vector{panel});
    EXPECT_EQ(under_panel,
              (montecarlo::ExplicitFlakesModel{.tile_width_mm = 150, .tile_height_mm = 100}));

    for (const ModelInfo* model : all_models()) {
        if (model != &montecarlo::VolumeModel::info) {
            EXPECT_TRUE(accepts(model->standard(), {ball, panel, mesh})) << model->name;
        }
    }
}

}  // namespace
}  // namespace nacre::models
