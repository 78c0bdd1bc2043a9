#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "nacre/bsdf/flake_films.h"
#include "nacre/core/math.h"
#include "nacre/core/quadrature.h"
#include "nacre/optics/thickness_rule.h"
#include "nacre/solver/directions.h"
#include "nacre/testing/nacre_model.h"
#include "nacre/testing/statistics.h"

// Mean and variance of the nacre model over patches, against the smooth model and against
// Campbell's theorem.

namespace nacre::bsdf {
namespace {

// Turning both directions together turns the half vector, so that other flakes reflect: eight turns
// make eight values of each patch.
constexpr int kTurns = 8;

TEST(Nacre, MeanOverPatchesIsTheMicroflakeModel) {
    for (const bool rough : {false, true}) {
        SCOPED_TRACE(rough);
        const SparklingModel& model = model_with_every_feature(rough);
        const auto smooth = Microflake(model.paint).bind(kOnGrid);
        PatchMemory memory(model.bound->patch_memory_bytes());
        struct Pair {
            double theta_i, theta_o, phi;
        };
        const std::vector<Pair> pairs = {{35, 27, 176}, {60, 50, 190}};
        const std::vector<double> numbers =
            rough ? std::vector<double>{0.25, 64, 1e4}
                  : std::vector<double>{0, 0.25, 4, 64, 1e3, 1e4, 1e6};
        for (const double flakes : numbers) {
            const double side = std::sqrt(flakes / model.flakes_per_mm2());
            // Patches of a million flakes overlap if there are more.
            const int count = flakes > 1e5 ? 10000 : 50000;
            std::vector<DoubleLanes> sum(pairs.size()), squares(pairs.size());
            Rng rng(21, static_cast<std::uint64_t>(flakes));
            for (int n = 0; n < count; ++n) {
                Patch patch = random_square_patch(rng, side);
                memory.forget();
                patch.memory = &memory;
                for (std::size_t p = 0; p < pairs.size(); ++p) {
                    FloatLanes f{};
                    for (int t = 0; t < kTurns; ++t) {
                        const double turn = 360.0 * t / kTurns;
                        f += model.bound
                                 ->evaluate_on(patch, direction(pairs[p].theta_i, turn),
                                               direction(pairs[p].theta_o, pairs[p].phi + turn))
                                 .f;
                    }
                    const DoubleLanes d = to_double(f * (1.0f / kTurns));
                    sum[p] += d;
                    squares[p] += d * d;
                }
            }
            for (std::size_t p = 0; p < pairs.size(); ++p) {
                const FloatLanes expected = smooth->eval(direction(pairs[p].theta_i, 0),
                                                         direction(pairs[p].theta_o, pairs[p].phi));
                for (const int lane : {0, 4, 7}) {
                    const double mean = sum[p][lane] / count;
                    const double error =
                        std::sqrt((squares[p][lane] / count - mean * mean) / count);
                    EXPECT_GT(error, 0);
                    EXPECT_LT(error, 0.025 * mean);
                    EXPECT_NEAR(mean, expected[lane], test::kWorstZ * error)
                        << flakes << " flakes, pair " << p << ", lane " << lane;
                }
            }
        }
    }
}

// Which flakes reflect is decided with the mean index, their light with that of each wavelength.
TEST(Nacre, MeanOverPatchesHoldsForABinderThatDisperses) {
    paint::Recipe recipe = paint_of({pearl_flake(20)});
    recipe.binder = optics::Material("crown", {400, 700}, {{1.56, 0}, {1.48, 0}});
    const SparklingModel model(recipe);
    const Vec3f wi = direction(45, 0), wo = direction(36, 175);
    constexpr int kPatches = 100000;
    DoubleLanes sum{}, squares{};
    Rng rng(22);
    PatchMemory memory(model.bound->patch_memory_bytes());
    for (int n = 0; n < kPatches; ++n) {
        Patch patch = random_square_patch(rng, 0.1);
        memory.forget();
        patch.memory = &memory;
        const DoubleLanes f = to_double(model.bound->evaluate_on(patch, wi, wo).f);
        sum += f;
        squares += f * f;
    }
    for (int lane = 0; lane < kLanes; ++lane) {
        const double mean = sum[lane] / kPatches;
        const double error = std::sqrt((squares[lane] / kPatches - mean * mean) / kPatches);
        EXPECT_LT(error, 0.02 * mean);
        EXPECT_NEAR(mean, model.bound->eval(wi, wo)[lane], 3 * error) << lane;
    }
}

TEST(Nacre, WithoutAPatchIsTheMicroflakeModel) {
    for (const bool rough : {false, true}) {
        SCOPED_TRACE(rough);
        const SparklingModel& model = model_with_every_feature(rough);
        const auto smooth = Microflake(model.paint).bind(kOnGrid);
        Rng rng(2);
        int pairs = 0;
        for (int n = 0; n < 200; ++n) {
            const Vec3f wi = direction(89 * rng.uniform_double(), 360 * rng.uniform_double());
            const float u_select = rng.uniform_float();
            const Vec2f u = {rng.uniform_float(), rng.uniform_float()};
            const auto a = smooth->sample(wi, u_select, u),
                       b = model.bound->sample(wi, u_select, u);
            ASSERT_EQ(a.has_value(), b.has_value());
            const FloatLanes albedo_a = smooth->albedo(wi), albedo_b = model.bound->albedo(wi);
            for (int lane = 0; lane < kLanes; ++lane) EXPECT_EQ(albedo_a[lane], albedo_b[lane]);
            if (!a || a->kind == SampleKind::specular) continue;
            EXPECT_EQ(a->pdf, b->pdf);
            EXPECT_EQ(smooth->pdf(wi, a->wo), model.bound->pdf(wi, a->wo));
            const FloatLanes f_a = smooth->eval(wi, a->wo), f_b = model.bound->eval(wi, a->wo);
            for (int lane = 0; lane < kLanes; ++lane) {
                EXPECT_EQ(a->weight[lane], b->weight[lane]);
                EXPECT_EQ(f_a[lane], f_b[lane]);
            }
            ++pairs;
        }
        EXPECT_GT(pairs, 100);  // the others are specular or empty
    }
}

// Campbell's theorem for one species of flakes of one diameter, independent of the code under test:
// Var X = nu Int W^2 dy  Int P K^2/(P * K)^2 dt  E[R^2]/E[R]^2  E[V^2]/E[V]^2.
struct Campbell {
    double ior = 1.5, alpha = 0.1, diameter_um, flakes_per_mm2;

    // Int W^2 dy, W = |disc on S| / (|S| nu a), S a square: by the covariograms of disc and square.
    double place(double side_mm) const {
        const double r = 0.5e-3 * diameter_um, disc = std::numbers::pi * r * r;
        const double cover = flakes_per_mm2 * disc;
        if (side_mm == 0) return disc / (cover * cover);
        const Quadrature radial = gauss_legendre(400, 0.0, 2 * r);
        const Quadrature angular = gauss_legendre(400, 0.0, std::numbers::pi / 2);
        double sum = 0;
        for (std::size_t i = 0; i < radial.nodes.size(); ++i) {
            const double t = radial.nodes[i];
            const double lens =
                2 * r * r * std::acos(t / (2 * r)) - t / 2 * std::sqrt(4 * r * r - t * t);
            for (std::size_t j = 0; j < angular.nodes.size(); ++j) {
                const double x = t * std::cos(angular.nodes[j]);
                const double y = t * std::sin(angular.nodes[j]);
                sum += 4 * radial.weights[i] * angular.weights[j] * t * lens *
                       std::max(0.0, side_mm - x) * std::max(0.0, side_mm - y);
            }
        }
        return sum / std::pow(side_mm * side_mm * cover, 2);
    }

    // e^2 Int P(t) K(t_h - t)^2 dt / (P * K_A)(t_h)^2, with the lobe of docs/nacre-model.md and the Airy
    // pattern K_A.
    double slope(Vec3f inside_i, Vec3f inside_o) const {
        const Vec3f h = inside_i + inside_o;
        const double hx = h.x / h.z, hy = h.y / h.z, sec = std::sqrt(1 + hx * hx + hy * hy);
        const double cosine = 0.5 * length(h);
        const double pattern = 0.55 / ior / (2 * diameter_um * cosine) * std::pow(sec, 1.5);
        const double e = 0.92, w = e * 1.26 * pattern;
        const Quadrature radial = gauss_legendre(40, 0.0, w);
        constexpr int kAngles = 64;
        double twice = 0;
        for (std::size_t i = 0; i < radial.nodes.size(); ++i) {
            for (int j = 0; j < kAngles; ++j) {
                const double t = radial.nodes[i], angle = 2 * std::numbers::pi * j / kAngles;
                const double x = hx + t * std::cos(angle), y = hy + t * std::sin(angle);
                const double p = std::exp(-(x * x + y * y) / (alpha * alpha)) /
                                 (std::numbers::pi * alpha * alpha);
                const double k = 3 / (std::numbers::pi * w * w) * std::pow(1 - t * t / (w * w), 2);
                const double weight = radial.weights[i] * t * 2 * std::numbers::pi / kAngles * p;
                twice += weight * k * k;
            }
        }
        const double airy = airy_lit(std::hypot(hx, hy), pattern);
        return e * e * twice / (airy * airy);
    }

    // (P * K_A)(t_h): of the pattern 2 J_1(x)^2 / x dx lies on a circle about t_h, with P's mean there.
    double airy_lit(double h, double pattern) const {
        const Quadrature rule = gauss_legendre(400, 0.0, 5 * alpha);
        double sum = 0;
        for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
            const double t = rule.nodes[i], x = std::numbers::pi * t / pattern;
            const double p = std::exp(-(h * h + t * t) / (alpha * alpha)) *
                             std::cyl_bessel_i(0.0, 2 * h * t / (alpha * alpha)) /
                             (std::numbers::pi * alpha * alpha);
            const double j = std::cyl_bessel_j(1.0, x);
            sum += rule.weights[i] * p * 2 * j * j / x * std::numbers::pi / pattern;
        }
        return sum;
    }

    // E[V^2] / E[V]^2 for V = exp(-u x), u = z / H uniform in [0, 1] and x = kappa H.
    static double depth(double x) { return x / 2 * (1 + std::exp(-x)) / -std::expm1(-x); }
};

// X of the only species of the paint: single scattering on the patch over its mean.
class Factor {
 public:
    Factor(const SparklingModel& model, double theta_i, double theta_o, double phi)
        : model_(model), theta_i_(theta_i), theta_o_(theta_o) {
        const auto single =
            model.paint->brdf(theta_i * kDegree, theta_o * kDegree, phi * kDegree, Part::single);
        for (int t = 0; t < kTurns; ++t) {
            const double turn = 360.0 * t / kTurns;
            wi_[t] = direction(theta_i, turn);
            wo_[t] = direction(theta_o, phi + turn);
        }
        mean_ = model.bound->eval(wi_[0], wo_[0]);
        for (int l = 0; l < kLanes; ++l) {
            single_[l] = static_cast<float>(single[static_cast<int>((kOnGrid[l] - 400) / 10)]);
        }
    }
    FloatLanes operator()(const Patch& patch, int turn) const {
        return 1.0f + (model_.bound->evaluate_on(patch, wi_[turn], wo_[turn]).f - mean_) / single_;
    }
    Vec3f wi() const { return wi_[0]; }
    Vec3f wo() const { return wo_[0]; }
    double theta_i() const { return theta_i_; }
    double theta_o() const { return theta_o_; }

 private:
    const SparklingModel& model_;
    double theta_i_, theta_o_;
    Vec3f wi_[kTurns], wo_[kTurns];
    FloatLanes mean_, single_{};
};

/// E[(X - 1)^2] over patches of this side, by lane; a patch's turns count as one value.
std::array<test::Sample, kLanes> variance(const Factor& x, const SparklingModel& model,
                                          double side_mm, int patches, std::uint64_t seed) {
    std::array<test::Sample, kLanes> found;
    Rng rng(seed, 5);
    PatchMemory memory(model.bound->patch_memory_bytes());
    for (int n = 0; n < patches; ++n) {
        Patch patch = random_square_patch(rng, side_mm);
        memory.forget();
        patch.memory = &memory;
        DoubleLanes squares{};
        for (int t = 0; t < kTurns; ++t) {
            const DoubleLanes d = to_double(x(patch, t) - 1.0f);
            squares += d * d;
        }
        for (int lane = 0; lane < kLanes; ++lane) found[lane].add(squares[lane] / kTurns);
    }
    return found;
}

double optical_depth(const SparklingModel& model, double theta_i, double theta_o, int lane) {
    const solver::LayerMedium& layer = model.paint->medium.layers[0];
    const int w = static_cast<int>((kOnGrid[lane] - 400) / 10);
    double sum = 0;
    for (const double theta : {theta_i, theta_o}) {
        const double mu = solver::inside_cosine(1.5, theta * kDegree);
        sum += solver::extinction(layer, mu, w / kLanes)[w % kLanes] / mu;
    }
    return sum * layer.thickness_um;
}

Vec3f inside(Vec3f w) {
    const float x = w.x / 1.5f, y = w.y / 1.5f;
    return {x, y, std::sqrt(1 - x * x - y * y)};
}

// From a point to a million flakes. 250 000 patches, each at eight turns with a probability of some
// 8 % that any flake reflects, give the variance to 1 %.
constexpr double kVarianceError = 0.01;

TEST(Nacre, VarianceIsThatOfACompoundPoissonProcess) {
    const SparklingModel model(paint_of({metal_flake(10, 0.6)}));
    const Campbell campbell{.diameter_um = 10, .flakes_per_mm2 = model.flakes_per_mm2()};
    struct Case {
        double flakes, theta_i, theta_o, phi;
    };
    for (const Case& c : {Case{0, 35, 25, 180}, Case{0.05, 50, 45, 172}, Case{1, 35, 25, 180},
                          Case{20, 50, 45, 172}, Case{400, 35, 25, 180}, Case{1e4, 50, 45, 172},
                          Case{1e6, 35, 25, 180}}) {
        const Factor x(model, c.theta_i, c.theta_o, c.phi);
        const double side = std::sqrt(c.flakes / model.flakes_per_mm2());
        const double place = model.flakes_per_mm2() * campbell.place(side);
        const double expected = place * campbell.slope(inside(x.wi()), inside(x.wo())) *
                                Campbell::depth(optical_depth(model, c.theta_i, c.theta_o, 4));
        const test::Sample found = variance(x, model, side, 250000, 7)[4];
        EXPECT_LT(found.error(), kVarianceError * expected);
        EXPECT_NEAR(found.mean(), expected, test::kWorstZ * found.error())
            << c.flakes << " flakes, from " << c.theta_i << " deg";
        // It falls as the area.
        EXPECT_TRUE(c.flakes < 1e5 || std::abs(place * c.flakes - 1) < 1e-3);
    }
}

// Films add E[R^2] / E[R]^2, and correlate wavelengths by E[R R'] / (E[R] E[R']).
TEST(Nacre, FilmsAddTheirOwnVariance) {
    const SparklingModel model(paint_of({pearl_flake(10)}));
    const Campbell campbell{.diameter_um = 10, .flakes_per_mm2 = model.flakes_per_mm2()};
    const Factor x(model, 45, 35, 180);
    const double cosine = 0.5 * length(inside(x.wi()) + inside(x.wo()));
    const auto& flake = std::get<optics::Platelet>(model.paint->recipe.layers[0].flakes[0].body);
    // The thickness distribution itself, by a thousand of its quantiles.
    DoubleLanes sum{}, squares{};
    constexpr int kFilms = 1000;
    for (int i = 0; i < kFilms; ++i) {
        optics::Platelet one = flake;
        one.coats[0].thickness_nm = optics::thickness_quantile(
            flake.coats[0].thickness_nm, flake.coats[0].spread, (i + 0.5) / kFilms);
        one.coats[0].spread = {};
        const auto table =
            optics::platelet_table(one, model.paint->recipe.binder, std::vector{cosine}, kOnGrid);
        const DoubleLanes r = load_lanes(table.reflectance.data());
        sum += r;
        squares += r * r;
    }
    const auto found = variance(x, model, 0, 400000, 9);
    double smallest = INFINITY, largest = 0;
    for (int lane = 0; lane < kLanes; ++lane) {
        const double films = squares[lane] * kFilms / (sum[lane] * sum[lane]);
        const double expected = model.flakes_per_mm2() * campbell.place(0) *
                                campbell.slope(inside(x.wi()), inside(x.wo())) * films *
                                Campbell::depth(optical_depth(model, 45, 35, lane));
        EXPECT_LT(found[lane].error(), kVarianceError * expected);
        EXPECT_NEAR(found[lane].mean(), expected, test::kWorstZ * found[lane].error()) << lane;
        smallest = std::min(smallest, films);
        largest = std::max(largest, films);
    }
    EXPECT_GT(smallest, 1.05);  // films matter, and not everywhere alike
    EXPECT_GT(largest, 1.3 * smallest);
}

// The flakes of a species do not depend on what the others reflect.
TEST(Nacre, SpeciesAdd) {
    const auto difference = [](double first, double second) {
        const SparklingModel model(paint_of({metal_flake(20, first), metal_flake(9, second, 0.2)}));
        std::vector<double> all;
        Rng rng(3);
        for (int n = 0; n < 50; ++n) {
            const Patch patch = random_square_patch(rng, 0.02);
            const Vec3f wi = direction(35, 0), wo = direction(32, 178);
            all.push_back(model.bound->evaluate_on(patch, wi, wo).f[3] -
                          model.bound->eval(wi, wo)[3]);
        }
        return all;
    };
    // Nothing is transmitted, so flakes extinguish the same whatever they reflect.
    const auto both = difference(0.5, 0.4), one = difference(0.5, 0), two = difference(0, 0.4);
    double size = 0;
    for (std::size_t n = 0; n < both.size(); ++n) {
        EXPECT_NEAR(both[n], one[n] + two[n], 2e-5 * (std::abs(one[n]) + std::abs(two[n])) + 1e-5);
        size += std::abs(one[n]) + std::abs(two[n]);
    }
    EXPECT_GT(size, 10);
}

}  // namespace
}  // namespace nacre::bsdf
