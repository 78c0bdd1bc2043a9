#include <gtest/gtest.h>

#include "nacre/bsdf/models/microflake.h"
#include "nacre/core/quadrature.h"
#include "nacre/montecarlo/plane_walk.h"
#include "nacre/montecarlo/shell_walk.h"
#include "nacre/optics/fresnel.h"
#include "nacre/solver/solver.h"
#include "nacre/testing/montecarlo.h"
#include "nacre/testing/statistics.h"

// The three models of one paint in one picture: a sphere, seen from far above, in a room whose
// light changes smoothly with direction. The solved BRDF is integrated over the hemisphere of each
// pixel; the walks give estimates with their errors. They are compared by chi-square over the
// pixels.

namespace nacre::montecarlo {
namespace {

using test::kOnGrid;

constexpr int kSide = 24;
constexpr int kGreenLane = 3, kRedLane = 6;  // lanes

/// Radiance from a direction of the world, between 0.3 and 2.7.
float room(Vec3f direction) {
    const float side = 0.5f * direction.x - 0.3f * direction.y;
    return 1 + side + 0.8f * direction.z * direction.z + 0.5f * side * direction.z;
}

struct Pixel {
    Frame frame;
    Vec3f wi;  ///< towards the camera, in the frame
};

/// Those whose centre lies on the sphere, up to 85 deg.
std::vector<Pixel> pixels() {
    std::vector<Pixel> result;
    for (int row = 0; row < kSide; ++row) {
        for (int column = 0; column < kSide; ++column) {
            const double x = 2 * (column + .5) / kSide - 1, y = 2 * (row + .5) / kSide - 1;
            constexpr double kRim = 0.996;
            if (x * x + y * y > kRim * kRim) continue;
            const Frame frame = Frame::around({static_cast<float>(x), static_cast<float>(y),
                                               static_cast<float>(std::sqrt(1 - x * x - y * y))});
            result.push_back({frame, frame.to_local({0, 0, 1})});
        }
    }
    return result;
}

/// Radiance of the solved paint, specular reflection included: Gauss-Legendre in the polar angle
/// times equal steps in azimuth.
std::array<double, kLanes> integrate(const bsdf::BoundBsdf& surface, double index,
                                     const Pixel& pixel, int polar_nodes) {
    const Quadrature polar = gauss_legendre(polar_nodes, 0, std::numbers::pi / 2);
    const int azimuths = 2 * polar_nodes;
    std::array<double, kLanes> sum;
    sum.fill(optics::fresnel_dielectric<double>(index, pixel.wi.z) *
             room(pixel.frame.to_world(Vec3f{-pixel.wi.x, -pixel.wi.y, pixel.wi.z})));
    for (int i = 0; i < polar_nodes; ++i) {
        const double sine = std::sin(polar.nodes[i]), cosine = std::cos(polar.nodes[i]);
        for (int k = 0; k < azimuths; ++k) {
            const double phi = 2 * std::numbers::pi * (k + .5) / azimuths;
            const Vec3f wo{static_cast<float>(sine * std::cos(phi)),
                           static_cast<float>(sine * std::sin(phi)), static_cast<float>(cosine)};
            const double weight = polar.weights[i] * 2 * std::numbers::pi / azimuths * sine *
                                  cosine * room(pixel.frame.to_world(wo));
            const FloatLanes f = surface.eval(pixel.wi, wo);
            for (int lane = 0; lane < kLanes; ++lane) sum[lane] += weight * f[lane];
        }
    }
    return sum;
}

using Picture = std::vector<std::array<Estimate, kLanes>>;

Picture solved_picture(const paint::Recipe& recipe) {
    const bsdf::Microflake model(std::make_shared<const solver::SolvedPaint>(
        solver::solve(recipe, {kOnGrid.begin(), kOnGrid.end()})));
    const auto surface = model.bind(kOnGrid);
    const std::vector<Pixel> all = pixels();
    Picture picture(all.size());
    parallel_for(0, all.size(), [&](std::size_t i) {
        const double index = recipe.binder.index(kOnGrid[0]).real();
        const auto fine = integrate(*surface, index, all[i], 56);
        for (int lane = 0; lane < kLanes; ++lane) picture[i][lane].value = fine[lane];
        if (i % 16 != 0) return;
        const auto coarse = integrate(*surface, index, all[i], 40);
        for (int lane = 0; lane < kLanes; ++lane)
            EXPECT_NEAR(coarse[lane], fine[lane], 1e-3 * fine[lane]) << "the quadrature converges";
    });
    return picture;
}

Picture walked_picture(const bsdf::Bsdf& model, int samples_per_pixel, std::uint64_t seed) {
    const auto surface = model.bind(kOnGrid);
    const std::vector<Pixel> all = pixels();
    Picture picture;
    for (std::size_t i = 0; i < all.size(); ++i) {
        // The room is far away: the radiance does not depend on where light leaves the sphere.
        picture.push_back(
            test::estimate(*surface, all[i].wi, samples_per_pixel, 1, hash_of(seed, i),
                           [&](const bsdf::BsdfSample& s, std::vector<FloatLanes>& values) {
                               values[0] = room(all[i].frame.to_world(s.wo)) * s.weight;
                           })[0]);
    }
    return picture;
}

/// One of two million values of a normal law is beyond; some 9000 are tested.
constexpr double kWorstPixel = 5;

/// Sum of z^2 over n pixels has the mean n and the deviation sqrt(2 n) if the two agree and the
/// errors are what they say. Three deviations: 0.3 % of right pairs would fail, but seeds are
/// fixed.
void expect_agreement(const Picture& a, const Picture& b, const std::string& pair) {
    ASSERT_EQ(a.size(), b.size());
    ASSERT_GT(a.size(), 400u);
    for (const int lane : {kGreenLane, kRedLane}) {
        double chi_square = 0, sum = 0, worst = 0;
        for (std::size_t i = 0; i < a.size(); ++i) {
            const double z = z_score(a[i][lane], b[i][lane]);
            chi_square += z * z;
            sum += z;
            worst = test::worse(worst, std::abs(z));
        }
        const double n = static_cast<double>(a.size());
        EXPECT_LT(std::abs(chi_square - n), 3 * std::sqrt(2 * n)) << pair << ' ' << kOnGrid[lane];
        // The mean z is the more sensitive to a common bias.
        EXPECT_LT(std::abs(sum), 3 * std::sqrt(n)) << pair << ' ' << kOnGrid[lane];
        EXPECT_LT(worst, kWorstPixel) << pair << ' ' << kOnGrid[lane];
        std::printf("%-28s %3.0f nm: chi^2 %.1f of %.0f pixels, mean z %+.3f, worst %.2f\n",
                    pair.c_str(), kOnGrid[lane], chi_square, n, sum / n, worst);
    }
}

void expect_one_picture(const paint::Recipe& recipe, int samples_per_pixel) {
    const Picture solved = solved_picture(recipe);
    const Picture plane = walked_picture(PlaneWalk(recipe), samples_per_pixel, 1);
    const Picture delta =
        walked_picture(ShellWalk(recipe, {.radius_mm = 50}), samples_per_pixel, 2);
    const Picture simpson = walked_picture(
        ShellWalk(recipe, {.radius_mm = 50, .tracking = Tracking::simpson}), samples_per_pixel, 3);
    expect_agreement(plane, solved, "position-free and solved");
    expect_agreement(delta, solved, "delta and solved");
    expect_agreement(simpson, solved, "simpson and solved");
    expect_agreement(delta, plane, "delta and position-free");
    expect_agreement(simpson, delta, "simpson and delta");
}

TEST(Picture, ThreeModelsOfAMetallicPaintAgree) { expect_one_picture(test::worked_paint(), 2048); }

TEST(Picture, ThreeModelsOfAPearlAgree) { expect_one_picture(test::pearl(), 1024); }

}  // namespace

namespace {

/// Between two powers of ten.
double by_magnitude(Rng& rng, double lo, double hi) {
    return lo * std::pow(hi / lo, rng.uniform_double());
}

/// A paint at the limits of what a recipe may say, except for depths of hundreds without
/// absorption, which scatter for ever.
paint::Recipe extreme_paint(Rng& rng) {
    paint::Recipe recipe = test::paint_of(1 + 2 * rng.uniform_double(), {}, rng.uniform_double());
    if (rng.uniform_double() < 0.2) recipe.binder = 1.0;
    const int count = 1 + static_cast<int>(3 * rng.uniform_double());
    for (int i = 0; i < count; ++i) {
        const double thickness_um = by_magnitude(rng, 1e-3, 1e5);
        const double depth = by_magnitude(rng, 1e-6, 1e4);
        paint::Layer layer;
        layer.thickness_um = thickness_um;
        if (rng.uniform_double() < 0.7) {
            const double reflectance = 0.95 * rng.uniform_double();
            layer.flakes.push_back(test::flakes(std::min(depth / thickness_um, 1e6),
                                                by_magnitude(rng, 0.005, 1), reflectance,
                                                (0.95 - reflectance) * rng.uniform_double()));
        }
        if (rng.uniform_double() < 0.5) {
            const double per_mm = std::min(1e3 * depth / thickness_um, 1e9);
            layer.pigments.push_back(
                {paint::PigmentCoefficients{per_mm * rng.uniform_double(), per_mm * 0.1,
                                            1.998 * rng.uniform_double() - 0.999}});
        }
        recipe.layers.push_back(layer);
    }
    if (rng.uniform_double() < 0.5) {
        recipe.clearcoat = paint::Clearcoat{rng.uniform_double() < 0.3 ? 0 : 50.0,
                                            by_magnitude(rng, 1e-3, 1e3), 0};
    }
    return recipe;
}

void expect_sound_samples(const bsdf::Bsdf& model, Rng& rng, int& left) {
    const auto surface = model.bind(test::kOnGrid);
    for (int i = 0; i < 100; ++i) {
        const Vec3f wi =
            test::direction(i % 4 == 0 ? 89.999 * rng.uniform_double() : 89.999 * (1 - 1e-6 * i),
                            360 * rng.uniform_double());
        const float u_select = rng.uniform_float(), u = rng.uniform_float();
        const auto sample = surface->sample(wi, u_select, {u, rng.uniform_float()});
        if (!sample) continue;
        ++left;
        EXPECT_NEAR(length(sample->wo), 1, 1e-5);
        EXPECT_TRUE(std::isfinite(length(sample->exit_mm)));
        for (int lane = 0; lane < kLanes; ++lane) {
            EXPECT_GE(sample->weight[lane], 0);
            EXPECT_TRUE(std::isfinite(sample->weight[lane]));
        }
    }
}

TEST(ExtremeRecipes, WalksAreFiniteAtTheLimitsOfRecipes) {
    Rng rng(11, 12);
    int left = 0;
    for (int i = 0; i < 60; ++i) {
        const paint::Recipe recipe = extreme_paint(rng);
        // From nearly solid paint to nearly flat.
        const double radius_mm = 1e-3 * recipe.thickness_um() * (1 + by_magnitude(rng, 1e-5, 1e12));
        const auto tracking = i % 2 == 0 ? Tracking::delta : Tracking::simpson;
        expect_sound_samples(PlaneWalk(recipe), rng, left);
        expect_sound_samples(ShellWalk(recipe, {radius_mm, tracking}), rng, left);
        expect_sound_samples(ShellWalk(recipe, {.tracking = tracking}), rng, left);
    }
    EXPECT_GT(left, 5000);
}

}  // namespace
}  // namespace nacre::montecarlo
