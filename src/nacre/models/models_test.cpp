#include "nacre/models/models.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "nacre/core/angles.h"
#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/core/random.h"
#include "nacre/io/recipe_file.h"
#include "nacre/models/spectral_brdf.h"
#include "nacre/solver/solver.h"

// What the list of models claims (Table 3 of the 2022 comparison) is measured here.

namespace nacre::models {
namespace {

using bsdf::Ingredients;
using bsdf::ModelInfo;

std::shared_ptr<const bsdf::Bsdf> pearl(const ModelInfo* model) {
    static const paint::Recipe recipe =
        io::read_recipe(shipped_file("paints/tio2-mica-80.toml"));
    static const auto solved = std::make_shared<const solver::SolvedPaint>(
        solver::solve(recipe, solver::default_wavelengths_nm(), {}));
    return model->standard().make({recipe, solved, {}});
}

bsdf::Wavelengths visible() { return {420, 460, 500, 540, 580, 620, 660, 690}; }

Vec3f direction(double theta_deg) {
    return {static_cast<float>(std::sin(theta_deg * kDegree)), 0,
            static_cast<float>(std::cos(theta_deg * kDegree))};
}

/// Mean light by wavelength that leaves other than by the mirror, and the share of it that leaves
/// more than 60 deg from the mirror direction, by sampling: all models can do that.
struct Reflected {
    FloatLanes mean{};
    double far_fraction = 0;
};
Reflected reflected(const bsdf::BoundBsdf& surface, double theta_deg) {
    constexpr int kSamples = 20000;
    const Vec3f wi = direction(theta_deg), mirror{-wi.x, -wi.y, wi.z};
    Rng rng(11, 3);
    Reflected out;
    double far = 0, all = 0;
    for (int i = 0; i < kSamples; ++i) {
        const float lobe = rng.uniform_float();
        const auto s = surface.sample(wi, lobe, {rng.uniform_float(), rng.uniform_float()});
        if (!s || dot(s->wo, mirror) > 1 - 1e-5f) continue;
        out.mean += s->weight;
        all += lane_mean(s->weight);
        if (dot(s->wo, mirror) < 0.5f) far += lane_mean(s->weight);
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

TEST(Models, GoniochromismIsAsListed) {
    for (const ModelInfo* model : all_models()) {
        const auto surface = pearl(model)->bind(visible());
        const FloatLanes steep = reflected(*surface, 5).mean, flat = reflected(*surface, 75).mean;
        // Change of the spectrum's shape: correlation of the two, both scaled to mean 1.
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
        const auto bound = surface->bind(visible());
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
                                   .rest = {.position_mm = {mm(u), mm(v), 0},
                                            .edge_mm = {{0.1f, 0, 0}, {0, 0.1f, 0}}}};
            };
            const bsdf::Patch a = patch(0.3), b = patch(0.7);
            differs |= bound->evaluate_on(a, wi, wo).f[3] != bound->evaluate_on(b, wi, wo).f[3];
        }
        EXPECT_EQ(differs, model->can.sparkle) << model->name;
        EXPECT_EQ(surface->varies_over_surface(), model->can.sparkle) << model->name;
    }
}

TEST(Models, MultipleScatteringIsAsListed) {
    // Flakes of alpha 0.1 send light at most some 20 deg off the mirror direction at once, that is
    // 30 deg outside the coat; what leaves farther has met several.
    for (const ModelInfo* model : all_models()) {
        const auto surface = pearl(model)->bind(visible());
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

}  // namespace
}  // namespace nacre::models
