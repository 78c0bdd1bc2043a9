#include "nacre/sparkle/flake_field.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/core/estimate.h"
#include "nacre/core/quadrature.h"
#include "nacre/core/random.h"
#include "nacre/testing/statistics.h"
#include "nacre/testing/worst.h"

namespace nacre::sparkle {
namespace {

using test::Moments;

constexpr FlakePopulation kSilver{
    .density_per_mm2 = 4000, .diameter_um = 20, .diameter_spread_um = 0, .alpha = 0.1, .ior = 1.5};

ObjectSpaceFootprint square(double x_mm, double y_mm, double side_mm, double turn = 0) {
    const float c = static_cast<float>(side_mm * std::cos(turn));
    const float s = static_cast<float>(side_mm * std::sin(turn));
    ObjectSpaceFootprint patch;
    patch.position_mm = {static_cast<float>(x_mm), static_cast<float>(y_mm), 3};
    patch.edge_mm[0] = {c, s, 0};
    patch.edge_mm[1] = {-s, c, 0};
    return patch;
}

double side_of(double flakes, const FlakePopulation& population) {
    return std::sqrt(flakes / population.density_per_mm2);
}

// The light that a patch reflects for one half vector, relative to the mean over patches.
double relative_radiance(const FlakeField& field, const FlakeView& view, Vec2f slope,
                         float cosine) {
    double sum = 0;
    const float background = view.for_each_reflecting_flake(
        field.lobe(), slope, cosine, [&](int, float fraction) { sum += fraction; });
    return background + sum;
}
double relative_radiance(const FlakeField& field, const ObjectSpaceFootprint& patch, Vec2f slope,
                         float cosine) {
    static const auto view = std::make_unique<FlakeView>();
    field.look(patch, *view);
    return relative_radiance(field, *view, slope, cosine);
}

template <class F>
Moments moments(int count, F&& sample) {
    std::vector<double> values(count);
    for (int i = 0; i < count; ++i) values[i] = sample(i);
    return Moments(values);
}

// Int coverage_1 coverage_2 over the place of a disc, in mm^2: the fractions that it covers of a
// square and of the same square moved by apart_mm along an edge.
double place_factor(double side_mm, double diameter_mm, double apart_mm = 0) {
    const double r = diameter_mm / 2;
    if (side_mm == 0) return std::numbers::pi * r * r;
    const float s = static_cast<float>(side_mm), apart = static_cast<float>(apart_mm);
    const double reach = side_mm / 2 + r;
    constexpr int kSteps = 400;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        for (int j = 0; j < kSteps; ++j) {
            const float x = static_cast<float>(reach * (2 * (i + 0.5) / kSteps - 1));
            const float y = static_cast<float>(reach * (2 * (j + 0.5) / kSteps - 1));
            const auto area = [&](float middle) {
                return disc_overlap(splat(x - middle), splat(y), splat(static_cast<float>(r)),
                                    Parallelogram({s, 0}, {0, s}))[0];
            };
            sum += double{area(0)} * (apart_mm == 0 ? area(0) : area(apart));
        }
    }
    return sum * 4 * reach * reach / (kSteps * kSteps) / std::pow(side_mm, 4);
}

// Campbell's formula for the covariance of sum_j W_j e_h K_j / (nu P * K), discs all alike,
// W = |disc on S| / (|S| a):
// (1/nu) Int W_1 W_2 Int K_1 K_2 P (e_h / (P * K))_1 (e_h / (P * K))_2, of patches and of
// slopes apart.
double campbell(const FlakePopulation& population, const FlakeField& field, double side_mm,
                Vec2f slope, float cosine, double apart_mm = 0, Vec2f turn = {0, 0}) {
    const double d = population.diameter_um * 1e-3, area = std::numbers::pi / 4 * d * d;
    const double slope2 = double{slope.x} * slope.x + double{slope.y} * slope.y;
    const DiffractionLobe& lobe = field.lobe();
    const float width =
        std::min(lobe.max_radius(), lobe.radius(static_cast<float>(population.diameter_um)) *
                                        lobe.widening(static_cast<float>(1 + slope2), cosine));
    // The second slope has a lobe of nearly the same width: turns are small.
    const Vec2f other = {slope.x + turn.x, slope.y + turn.y};
    const Quadrature rule = gauss_legendre(32, 0.0, 1.0);
    double lobe_integral = 0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        const double r = width * rule.nodes[i];
        for (int k = 0; k < 64; ++k) {
            const double angle = 2 * std::numbers::pi * (k + 0.5) / 64;
            const double x = slope.x + r * std::cos(angle), y = slope.y + r * std::sin(angle);
            const double apart2 = (x - other.x) * (x - other.x) + (y - other.y) * (y - other.y);
            if (apart2 >= width * width) continue;
            lobe_integral += rule.weights[i] * width * r * 2 * std::numbers::pi / 64 *
                             DiffractionLobe::density(static_cast<float>(r * r), width) *
                             DiffractionLobe::density(static_cast<float>(apart2), width) *
                             lobe.slope_density(static_cast<float>(x * x + y * y));
        }
    }
    const auto blurred = [&](Vec2f p) {
        const float square = p.x * p.x + p.y * p.y;
        return lobe.slope_density(square) * lobe.blur(square, width) /
               lobe.lobe_fraction(lobe.exponent(square),
                                  width / static_cast<float>(population.alpha));
    };
    return place_factor(side_mm, d, apart_mm) / (area * area) * lobe_integral /
           (blurred(slope) * blurred(other)) / population.density_per_mm2;
}

TEST(FlakeField, NumberOfFlakesOverAPointIsPoisson) {
    const FlakeField field(kSilver, 5);
    const auto view = std::make_unique<FlakeView>();
    // All discs that touch a point: a Poisson number of mean density times area.
    const double mean = 4000 * std::numbers::pi * 1e-4;
    std::map<int, int> found;
    constexpr int kPatches = 40000;
    for (int i = 0; i < kPatches; ++i) {
        field.look(square(0.1 * (i % 200), 0.1 * (i / 200.0), 0), *view);
        EXPECT_EQ(view->background, 0);
        // Beside them the view lists some that do not touch the point.
        ++found[static_cast<int>(std::count_if(view->weight.begin(),
                                               view->weight.begin() + view->count,
                                               [](float w) { return w > 0; }))];
    }
    double probability = std::exp(-mean), chi_square = 0;
    for (int n = 0; n < 6; ++n) {
        const double expected = kPatches * probability;
        chi_square += (found[n] - expected) * (found[n] - expected) / expected;
        probability *= mean / (n + 1);
    }
    EXPECT_LT(chi_square, 22.5);  // 6 cells: exceeded once in a thousand
}

TEST(FlakeField, KeepsTheMeanAndTheVarianceOfEveryFlakeAtEveryScale) {
    const Vec2f slope = {0.06f, -0.03f};
    const float cosine = 0.9f;
    FlakePopulation dense = kSilver;  // so many reflect that the variance converges soon
    dense.diameter_um = 8;
    dense.density_per_mm2 = 25000;
    for (const double flakes : {0.0, 0.25, 4.0, 12.0, 40.0, 150.0, 1e3, 2e4, 1e6}) {
        const double side = side_of(flakes, dense);
        const double reach = 4 * (side + 0.05);
        Rng rng(static_cast<std::uint64_t>(flakes) + 11);
        const FlakeField field(dense, 3);
        constexpr int kPatches = 60000;
        const Moments m = moments(kPatches, [&](int i) {
            return relative_radiance(
                field,
                square(reach * (i % 300), reach * (i / 300.0), side, 6.28 * rng.uniform_double()),
                slope, cosine);
        });
        const double expected = campbell(dense, field, side, slope, cosine);
        EXPECT_NEAR(m.mean, 1, 4 * m.mean_error) << flakes;
        EXPECT_NEAR(m.variance / expected, 1, 0.03 + 3 * m.variance_error / expected) << flakes;
        EXPECT_LT(m.variance_error, 0.05 * expected)
            << flakes;  // else the line above tests nothing
    }
}

TEST(FlakeField, CovarianceInSpaceAndInAngleFollowsCampbellsFormula) {
    FlakePopulation dense = kSilver;
    dense.diameter_um = 8;
    dense.density_per_mm2 = 25000;
    const FlakeField field(dense, 3);
    const Vec2f slope = {0.06f, -0.03f};
    const float cosine = 0.9f;
    const double side = 0.006;
    struct Case {
        double apart_mm;
        Vec2f turn;
    };
    for (const auto& [apart_mm, turn] :
         {Case{0.003, {0, 0}}, Case{0.009, {0, 0}}, Case{0, {0.01f, 0}}, Case{0, {0, 0.025f}},
          Case{0.004, {0.01f, 0.005f}}}) {
        constexpr int kPairs = 200000;
        double product = 0, products = 0;
        for (int i = 0; i < kPairs; ++i) {
            const double x = 0.05 * (i % 500), y = 0.05 * (i / 500);
            const double here = relative_radiance(field, square(x, y, side), slope, cosine) - 1;
            const double there = relative_radiance(field, square(x + apart_mm, y, side),
                                                   {slope.x + turn.x, slope.y + turn.y}, cosine) -
                                 1;
            product += here * there / kPairs;
            products += here * there * here * there / kPairs;
        }
        const double error = std::sqrt((products - product * product) / kPairs);
        const double expected = campbell(dense, field, side, slope, cosine, apart_mm, turn);
        EXPECT_NEAR(product, expected, 4 * error + 0.01 * expected) << apart_mm << ' ' << turn.x;
        EXPECT_GT(expected, 10 * error);  // else the line above tests nothing
    }
}

// Int K^power P over the slopes of flakes, K about `slope`.
double lobe_moment(const DiffractionLobe& lobe, Vec2f slope, float width, int power) {
    const Quadrature rule = gauss_legendre(32, 0.0, 1.0);
    constexpr int kAngles = 64;
    double sum = 0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        const double r = width * rule.nodes[i];
        for (int k = 0; k < kAngles; ++k) {
            const double angle = 2 * std::numbers::pi * (k + 0.5) / kAngles;
            const double x = slope.x + r * std::cos(angle), y = slope.y + r * std::sin(angle);
            sum += rule.weights[i] * width * r * 2 * std::numbers::pi / kAngles *
                   std::pow(DiffractionLobe::density(static_cast<float>(r * r), width), power) *
                   lobe.slope_density(static_cast<float>(x * x + y * y));
        }
    }
    return sum;
}

// The third moment tells a few bright specks on an even ground from many flakes. Campbell's theorem:
// the third cumulant of sum_j W_j K_j is E[sum_j W_j^3] Int K^3 P over the flakes j that a patch shows,
// the variance the same with squares. What all of them are multiplied by cancels in the skewness.
TEST(FlakeField, SkewnessIsThatOfTheFlakesThatStandForMany) {
    const FlakeField field(kSilver, 7);
    const DiffractionLobe& lobe = field.lobe();
    const Vec2f slope = {0.05f, 0};
    const float slope2 = slope.x * slope.x, cosine = 0.9f;
    const float radius = lobe.radius(20.0f) * lobe.widening(1 + slope2, cosine);
    const auto view = std::make_unique<FlakeView>();
    struct Case {
        double flakes, stand_ins;
    };
    for (const auto& [flakes, stand_ins] : {Case{100, 1.369}, Case{150, 1.319}, Case{250, 1.330}}) {
        const double side = side_of(flakes, kSilver);
        constexpr int kPieces = 20, kPatches = 10'000;  // of each
        std::array<std::array<double, 4>, kPieces> powers{};
        double squares = 0, cubes = 0;  // of the flakes' weights, a patch
        for (int i = 0; i < kPieces * kPatches; ++i) {
            field.look(square(4 * side * (i % 500), 4 * side * (i / 500), side), *view);
            const double x = relative_radiance(field, *view, slope, cosine);
            std::array<double, 4>& sums = powers[i / kPatches];
            for (int n = 0; n < 4; ++n) sums[n] += std::pow(x, n);
            for (int k = 0; k < view->count; ++k) {
                const double w = view->weight[k];
                squares += w * w / (kPieces * kPatches);
                cubes += w * w * w / (kPieces * kPatches);
            }
        }
        const Estimate found = jackknife(powers, [](const std::array<double, 4>& sums) {
            const double mean = sums[1] / sums[0], square = sums[2] / sums[0];
            const double variance = square - mean * mean;
            return (sums[3] / sums[0] - 3 * mean * square + 2 * std::pow(mean, 3)) /
                   std::pow(variance, 1.5);
        });
        const float width = radius * view->widening;
        const double expected = cubes * lobe_moment(lobe, slope, width, 3) /
                                std::pow(squares * lobe_moment(lobe, slope, width, 2), 1.5);
        EXPECT_NEAR(found.value, expected, test::kWorstZ * found.standard_error) << flakes;
        EXPECT_LT(found.standard_error, 0.02 * expected);

        // Of all flakes: W = 1/M inside the patch; K = 3 (1 - u)^2 / (pi r^2), u even in [0, 1], so
        // Int K^3 = 27/7 / (pi r^2)^2 against Int K^2 = 9/5 / (pi r^2): the skewness is
        // (27/7) / (9/5)^(3/2) / sqrt(reflecting), reflecting = M P pi r^2. Levels of fractions rho_l
        // that are shown with weights u_l, and lobes B times as wide, have
        //     Sum_l rho_l u_l^3 / (Sum_l rho_l u_l^2)^(3/2) / B
        // times that: 1 if those shown weighed all the same and B were the root of how many each
        // stands for. As levels fade one by one, and B ends short of that root, it is a third more.
        // The rims of the patch, which take 0.4 %, and the bend of P, which adds 1 % where lobes are
        // wide, are neglected.
        const double reflecting =
            flakes * lobe.slope_density(slope2) * std::numbers::pi * radius * radius;
        const double of_all = 27.0 / 7 / std::pow(1.8, 1.5) / std::sqrt(reflecting);
        EXPECT_NEAR(expected / of_all, stand_ins, 0.02) << flakes;
    }
}

TEST(FlakeField, KeepsTheMeanWhateverTheSizesAndTheLobe) {
    for (const FlakePopulation& population :
         {FlakePopulation{2000, 30, 9, 0.1, 1.5}, FlakePopulation{2e5, 2, 0.5, 0.02, 1.5},
          FlakePopulation{3000, 18, 6, 0.35, 1.33}}) {
        const FlakeField field(population, 9);
        for (const Vec2f relative : {Vec2f{0, 0}, Vec2f{0.9f, 0.4f}, Vec2f{-1.8f, 0}}) {
            const Vec2f slope = {relative.x * static_cast<float>(population.alpha),
                                 relative.y * static_cast<float>(population.alpha)};
            const double side = side_of(200, population);
            const Moments m = moments(40000, [&](int i) {
                return relative_radiance(
                    field, square(4 * side * (i % 200), 4 * side * (i / 200.0), side), slope, 0.8f);
            });
            EXPECT_NEAR(m.mean, 1, 4 * m.mean_error + 2 * DiffractionLobe::kBlurError)
                << population.diameter_um << ' ' << relative.x;
            EXPECT_GT(m.variance, 0);
        }
    }
}

// By Campbell's formula for points, discs all alike and lobes that are Gaussian:
// Int P P_s^2 / (P * P_s)^2 over nu times their area, P_s of waviness v and P of alpha, at the slope 0
// (alpha^2 + v^2)^2 / (2 v^2 (alpha^2 + v^2 / 2)).
TEST(FlakeField, WavinessWidensTheLobesAndKeepsTheMean) {
    // Diffraction, which the formula leaves out, and lobes that end where Gaussians do not: found with
    // eight other seeds, to 0.25 %.
    struct Case {
        double v, contrast;
    };
    double before = 1e9;
    for (const auto& [v, found] :
         {Case{0.02, 0.934}, Case{0.05, 0.965}, Case{0.1, 0.965}, Case{0.2, 0.989}}) {
        FlakePopulation population{
            .density_per_mm2 = 1000, .diameter_um = 40, .alpha = 0.1, .waviness = v};
        const FlakeField field(population, 9);
        const Moments m = moments(240'000, [&](int i) {
            return relative_radiance(field, square(0.16 * (i % 500), 0.16 * (i / 500.0), 0), {0, 0},
                                     0.8f);
        });
        EXPECT_NEAR(m.mean, 1, 4 * m.mean_error + 2 * DiffractionLobe::kBlurError) << v;
        const double a2 = 0.01, v2 = v * v, cover = 1000 * std::numbers::pi / 4 * 0.04 * 0.04;
        const double expected = (a2 + v2) * (a2 + v2) / (2 * v2 * (a2 + v2 / 2)) / cover;
        const double contrast = std::sqrt(m.variance / expected);
        const double error = m.variance_error / (2 * m.variance) * contrast;
        EXPECT_NEAR(contrast, found, 0.0025 + test::kWorstZ * error) << v;
        EXPECT_LT(error, 0.005);
        EXPECT_LT(m.variance, before);
        before = m.variance;
    }
    // Away from the flakes' mean, where the surfaces' slopes are more than the planes'.
    const FlakeField field({.density_per_mm2 = 1000, .diameter_um = 40, .waviness = 0.08}, 9);
    const Moments m = moments(60000, [&](int i) {
        return relative_radiance(field, square(0.16 * (i % 250), 0.16 * (i / 250.0), 0),
                                 {0.15f, 0.1f}, 0.8f);
    });
    EXPECT_NEAR(m.mean, 1, 4 * m.mean_error + 2 * DiffractionLobe::kBlurError);
}

// The limit of flat flakes, to the bit.
TEST(FlakeField, WithoutWavinessIsFlat) {
    FlakePopulation flat = kSilver, sized = kSilver;
    sized.waviness = 0;
    sized.sizes = paint::FlakeSizes(kSilver.diameter_um, kSilver.diameter_spread_um);
    const FlakeField a(flat, 3), b(sized, 3);
    for (int i = 0; i < 100; ++i) {
        EXPECT_EQ(relative_radiance(a, square(0.1 * i, 0, 0.05), {0.02f, 0}, 0.9f),
                  relative_radiance(b, square(0.1 * i, 0, 0.05), {0.02f, 0}, 0.9f));
    }
}

TEST(FlakeField, FootprintsAddUp) {
    const FlakeField field(kSilver, 1);
    const double side = side_of(1, kSilver);
    Rng rng(4);
    int different = 0;
    for (int i = 0; i < 300; ++i) {
        const double x = 50 * rng.uniform_double(), y = 50 * rng.uniform_double();
        // Wide lobes, so that most patches hold a flake that reflects.
        const Vec2f slope = {0.02f, 0};
        const double whole = relative_radiance(field, square(x, y, side), slope, 0.1f);
        double parts = 0;
        for (double dx : {-0.25, 0.25}) {
            for (double dy : {-0.25, 0.25}) {
                parts += relative_radiance(field, square(x + dx * side, y + dy * side, side / 2),
                                           slope, 0.1f) /
                         4;
            }
        }
        // A float resolves 1e-7 of 50 mm, discs are 0.02 mm.
        EXPECT_NEAR(whole, parts, 2e-3 * (1 + whole));
        different += whole > 0.01;
    }
    EXPECT_GT(different, 30);
}

TEST(FlakeField, ResolvesEveryFlakeUpToItsExactSide) {
    const auto view = std::make_unique<FlakeView>();
    for (double density : {10.0, 4000.0, 9000.0}) {
        FlakePopulation population = kSilver;
        population.density_per_mm2 = density;
        const FlakeField field(population, 1);
        const double side = field.exact_side_mm();
        ASSERT_GT(side, 0) << density;
        field.look(square(5, 7, side), *view);
        EXPECT_EQ(view->widening, 1) << density;
        EXPECT_EQ(view->background, 0) << density;
        field.look(square(5, 7, 4 * side), *view);
        EXPECT_GT(view->widening, 1) << density;
    }
    // 60 flakes over every point.
    FlakePopulation overlapping = kSilver;
    overlapping.density_per_mm2 = 2e5;
    EXPECT_EQ(FlakeField(overlapping, 1).exact_side_mm(), 0);
}

TEST(FlakeField, ChangesWithoutJumpsFromACloseUpToADistantView) {
    const FlakeField field(kSilver, 1);
    const auto view = std::make_unique<FlakeView>();
    // By how much all weights change together where the patch grows by a hundredth: levels fade
    // over a factor of 2.3 in cells, rims of discs over the patch's own size.
    constexpr double kStep = 1.01, kMaxChange = 0.15;
    std::map<std::uint64_t, double> before;
    double background = 1, worst = 0;
    int levels_faded = 0;
    for (double side = 1e-3; side < 20; side *= kStep) {
        field.look(square(3.3, 4.4, side), *view);
        std::map<std::uint64_t, double> now;
        for (int k = 0; k < view->count; ++k) {
            now[std::uint64_t{view->place[k]} << 32 | view->kind[k]] = view->weight[k];
        }
        double change = std::abs(view->background - background);
        for (const auto& [flake, weight] : now) change += std::abs(weight - before[flake]);
        for (const auto& [flake, weight] : before) {
            if (!now.contains(flake)) change += weight;
        }
        if (side > 1e-3) worst = test::worse(worst, change);
        levels_faded += view->background > 0 && view->background < 0.999;
        before = now;
        background = view->background;
    }
    EXPECT_LT(worst, kMaxChange);
    EXPECT_GT(levels_faded, 100);
}

TEST(FlakeField, FlakesDoNotDependOnTheTangent) {
    const FlakeField field(kSilver, 1);
    const auto view = std::make_unique<FlakeView>(), turned = std::make_unique<FlakeView>();
    ObjectSpaceFootprint patch = square(7, 5, 0.02);
    patch.normal = normalize(Vec3f{0.3f, 0.2f, 0.9f});
    patch.tangent = normalize(cross({0, 1, 0}, patch.normal));
    const Vec3f bitangent = cross(patch.normal, patch.tangent);
    patch.edge_mm[0] = 0.02f * patch.tangent;
    patch.edge_mm[1] = 0.02f * bitangent;
    field.look(patch, *view);
    ObjectSpaceFootprint other = patch;
    const float c = std::cos(1.0f), s = std::sin(1.0f);
    other.tangent = c * patch.tangent + s * bitangent;
    field.look(other, *turned);
    ASSERT_EQ(view->count, turned->count);
    ASSERT_GT(view->count, 0);
    for (int k = 0; k < view->count; ++k) {
        EXPECT_EQ(view->place[k], turned->place[k]);
        EXPECT_EQ(view->kind[k], turned->kind[k]);
        EXPECT_NEAR(view->weight[k], turned->weight[k], 1e-5);
        EXPECT_NEAR(turned->slope_x[k], c * view->slope_x[k] + s * view->slope_y[k], 1e-6);
        EXPECT_NEAR(turned->slope_y[k], -s * view->slope_x[k] + c * view->slope_y[k], 1e-6);
    }
}

TEST(FlakeField, DensityDoesNotDependOnTheOrientationOfTheSurface) {
    const FlakeField field(kSilver, 1);
    const auto view = std::make_unique<FlakeView>();
    Rng rng(8);
    // Facing one side, two sides about equally, three, and on the way between.
    for (const Vec3f direction : {Vec3f{0, 0, 1}, Vec3f{0, -1, 0}, Vec3f{1, 0, 0.97f},
                                  Vec3f{-1, 1, 1}, Vec3f{0.3f, 0.6f, 0.7f}, Vec3f{1, 0.8f, 0}}) {
        const Vec3f n = normalize(direction);
        const Frame frame = Frame::around(n);
        double sum = 0, squares = 0;
        // The variance has a standard error of 0.5 %.
        constexpr int kPatches = 150000;
        for (int i = 0; i < kPatches; ++i) {
            ObjectSpaceFootprint patch;
            patch.normal = n;
            patch.tangent = frame.s;
            patch.position_mm =
                (60 * rng.uniform_float()) * frame.s + (60 * rng.uniform_float()) * frame.t;
            patch.edge_mm[0] = 0.015f * frame.s;
            patch.edge_mm[1] = 0.015f * frame.t;
            field.look(patch, *view);
            const double x = view->background + view->weight_sum;
            sum += x / kPatches;
            squares += x * x / kPatches;
        }
        const double variance = squares - sum * sum;
        EXPECT_NEAR(sum, 1, 4 * std::sqrt(variance / kPatches)) << n.x << ' ' << n.y;
        // Poisson: place_factor / (density area^2) with patches whose flakes are all resolved.
        const double area = std::numbers::pi * 1e-4;
        EXPECT_NEAR(variance, place_factor(0.015, 0.02) / (4000 * area * area), 0.02 * variance)
            << n.x << ' ' << n.y;
    }
}

TEST(FlakeField, SamplesSlopesWithTheDensityItStates) {
    const FlakeField field(kSilver, 1);
    const auto view = std::make_unique<FlakeView>();
    field.look(square(1, 2, 0.04), *view);
    ASSERT_GT(view->count, 2);
    const Vec3f wi = normalize(Vec3f{0.3f, -0.2f, 0.8f});
    // Pearson's statistic over the cells of a grid.
    constexpr int kSide = 40, kSamples = 400000;
    constexpr float kReach = 0.4f;
    std::vector<double> count(kSide * kSide), expected(kSide * kSide);
    Rng rng(6);
    for (int i = 0; i < kSamples; ++i) {
        const Vec2f p = view->sample_slope(field.lobe(), wi, rng.uniform_float(),
                                           {rng.uniform_float(), rng.uniform_float()});
        const int x = static_cast<int>((p.x / kReach + 1) * kSide / 2);
        const int y = static_cast<int>((p.y / kReach + 1) * kSide / 2);
        ASSERT_TRUE(x >= 0 && x < kSide && y >= 0 && y < kSide);
        ++count[y * kSide + x];
    }
    constexpr int kFine = 40;
    for (int y = 0; y < kSide * kFine; ++y) {
        for (int x = 0; x < kSide * kFine; ++x) {
            const auto at = [&](int i) { return kReach * ((i + 0.5f) * 2 / (kSide * kFine) - 1); };
            expected[y / kFine * kSide + x / kFine] +=
                view->slope_pdf(field.lobe(), wi, {at(x), at(y)}) * kSamples *
                std::pow(2 * kReach / (kSide * kFine), 2);
        }
    }
    double chi_square = 0, total = 0;
    int cells = 0;
    for (int i = 0; i < kSide * kSide; ++i) {
        total += expected[i];
        if (expected[i] < 20) continue;
        chi_square += (count[i] - expected[i]) * (count[i] - expected[i]) / expected[i];
        ++cells;
    }
    EXPECT_NEAR(total, kSamples, 1e-5 * kSamples);  // found: 2e-7
    ASSERT_GT(cells, 10);
    EXPECT_LT(chi_square, cells + 4 * std::sqrt(2.0 * cells));
}

TEST(FlakeField, RefusesWhatIsOutOfRange) {
    FlakePopulation population = kSilver;
    population.density_per_mm2 = 0;
    EXPECT_THROW(FlakeField(population, 0), DomainError);
    population = kSilver;
    population.alpha = 2;
    EXPECT_THROW(FlakeField(population, 0), DomainError);
}

TEST(FlakeField, StaysFiniteOnDegeneratePatches) {
    const FlakeField field(kSilver, 1);
    const auto view = std::make_unique<FlakeView>();
    for (float size : {0.0f, 1e-20f, 1e-6f, 1.0f, 1e6f, 1e20f}) {
        for (float thin : {0.0f, 1e-9f, 1.0f}) {
            ObjectSpaceFootprint patch = square(1e5, -1e5, 0);
            patch.edge_mm[0] = {size, 0, 0};
            patch.edge_mm[1] = {size * 0.5f, size * thin, 0};
            field.look(patch, *view);
            EXPECT_TRUE(std::isfinite(view->weight_sum)) << size << ' ' << thin;
            EXPECT_GE(view->background, 0);
        }
    }
}

}  // namespace
}  // namespace nacre::sparkle
