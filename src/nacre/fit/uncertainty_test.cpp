#include "nacre/fit/uncertainty.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <iterator>
#include <random>

#include "nacre/core/error.h"
#include "nacre/core/estimate.h"
#include "nacre/core/parallel.h"
#include "nacre/paint/recipe_parameter.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/fit.h"
#include "nacre/testing/paints.h"

namespace nacre::fit {
namespace {

using nacre::test::message_of;
using ::testing::HasSubstr;

const std::string kDepth = "layer[0].thickness_um", kGround = "substrate.reflectance";
const std::string kOnlyFlakes = "layer[0].flakes[0].";
const std::string kTitania = kOnlyFlakes + "coats[0].thickness_nm";
const std::string kVolume = kOnlyFlakes + "volume_fraction";
const std::string kTilt = kOnlyFlakes + "orientation.alpha";

/// A number of standard errors that a right estimate exceeds once in 3e5 tries.
constexpr double kSigmas = 4.7;

/// A reader whose only reading is a function of two numbers, layer and substrate.
PaintReader made_up(std::function<Vec3d(double thickness_um, double reflectance)> lab) {
    return [lab](const paint::Recipe& recipe, const solver::SolverSettings*, SharedProgress&) {
        measure::Reading reading;
        reading.geometry = testing::six_angles()[0];
        reading.lab = lab(recipe.layers[0].thickness_um, recipe.substrate_reflectance.values()[0]);
        return PaintReading{{"made up", {}, {}, {reading}}, {}};
    };
}

paint::Recipe grey_ground() {
    return test::paint_of(1.5, {test::pigment_layer(0.5, 0.1, 0)}, 0.4);  // of 100 um
}

TEST(Uncertainty, OfALinearReadingIsJacobianTimesCovarianceTimesJacobian) {
    const auto lab = [](double t, double r) {
        return Vec3d{50 + 0.1 * t, 20 + 0.2 * t - 30 * r, 10 - 0.3 * t + 40 * r};
    };
    const Uncertainty u = uncertainty(grey_ground(), {{kDepth, 0.02, true}, {kGround, 0.01}},
                                      made_up(lab), {4000, 1});
    ASSERT_EQ(u.readings.size(), 1u);
    const ReadingUncertainty& r = u.readings[0];
    // Standard deviations 2 um and 0.01.
    const Vec3d by_thickness{0.2, 0.4, -0.6}, by_ground{0, -0.3, 0.4};
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(r.change[0][i], by_thickness[i], 1e-12);
        EXPECT_NEAR(r.change[1][i], by_ground[i], 1e-12);
        EXPECT_NEAR(r.mean_shift[i], 0, 1e-12);
        for (int j = 0; j < 3; ++j) {
            const double expected = by_thickness[i] * by_thickness[j] + by_ground[i] * by_ground[j];
            EXPECT_NEAR(r.first_order.covariance[i][j], expected, 1e-12);
            // The error of a covariance of normal numbers.
            const double error =
                std::sqrt((r.first_order.covariance[i][i] * r.first_order.covariance[j][j] +
                           expected * expected) /
                          u.samples);
            EXPECT_NEAR(r.sampled->covariance[i][j], expected, kSigmas * error + 1e-12);
        }
        EXPECT_NEAR(r.sampled->mean[i], r.reading.lab[i],
                    kSigmas * r.first_order.lab()[i] / std::sqrt(u.samples) + 1e-12);
    }
    EXPECT_TRUE(r.doubtful().empty());
    for (const Linearity& linearity : r.linearity) EXPECT_LT(linearity.beyond, 0.05);
    EXPECT_EQ(u.redrawn, 0);
    EXPECT_FALSE(u.first_order_fails());

    const std::vector<double> of_a = variance_fractions(r.change_of(Quantity::a));
    EXPECT_NEAR(of_a[0], 0.16 / 0.25, 1e-10);
    EXPECT_NEAR(of_a[1], 0.09 / 0.25, 1e-10);
    EXPECT_NEAR(variance_fractions(r.change)[0], 0.56 / 0.81, 1e-10);
}

TEST(Uncertainty, ChromaAndHueFollowFromAAndB) {
    const auto lab = [](double t, double r) { return Vec3d{50, 30 + 0.5 * t, 40 + 50 * r}; };
    const paint::Recipe recipe = grey_ground();
    const Uncertainty u =
        uncertainty(recipe, {{kDepth, 1}, {kGround, 0.01}}, made_up(lab), {4000, 2});
    const Spread& spread = u.readings[0].first_order;
    const std::vector<double> by_chroma = u.readings[0].change_of(Quantity::chroma);
    const std::vector<double> by_hue = u.readings[0].change_of(Quantity::hue);
    // At (50, 80, 60), of which C* = 100.
    EXPECT_NEAR(*spread.chroma, std::hypot(0.8 * 0.5, 0.6 * 0.5), 1e-10);
    EXPECT_NEAR(*spread.hue_deg, 0.005 * 180 / std::numbers::pi, 1e-10);
    EXPECT_NEAR(std::hypot(by_chroma[0], by_chroma[1]), *spread.chroma, 1e-12);
    EXPECT_NEAR(std::hypot(by_hue[0], by_hue[1]), *spread.hue_deg, 1e-12);
    const double error = kSigmas / std::sqrt(2.0 * u.samples);
    EXPECT_NEAR(*u.readings[0].sampled->chroma / *spread.chroma, 1, error);
    EXPECT_NEAR(*u.readings[0].sampled->hue_deg / *spread.hue_deg, 1, error);
}

TEST(Uncertainty, GreyHasNoHue) {
    const auto grey = [](double t, double) { return Vec3d{50, 0.01 * (t - 100), 0}; };
    const auto nearly = [](double t, double) { return Vec3d{50, 0.1 * t - 9.9, 0.25}; };
    for (const auto& lab : {made_up(grey), made_up(nearly)}) {
        const Uncertainty u = uncertainty(grey_ground(), {{kDepth, 1}}, lab);
        EXPECT_FALSE(u.readings[0].first_order.hue_deg);
        EXPECT_FALSE(u.readings[0].first_order.chroma);
        EXPECT_GT(u.readings[0].first_order.lab()[1], 0);
    }
}

// L* = c (t - 100)^2 + k (t - 100): for normal t of deviation s about 100 the variance is
// k^2 s^2 + 2 c^2 s^4, the mean c s^2.
TEST(Uncertainty, SaysWhereFirstOrderIsNotEnough) {
    constexpr double kS = 2;
    struct Case {
        double k, c;
        bool fails;
    };
    for (const auto& [k, c, fails] :
         {Case{1, 0.01, false}, Case{1, 0.15, true}, Case{0, 0.15, true}, Case{0, 1e-4, false}}) {
        const auto lab = [k = k, c = c](double t, double) {
            return Vec3d{50 + k * (t - 100) + c * (t - 100) * (t - 100), 20, 0};
        };
        const Uncertainty u = uncertainty(grey_ground(), {{kDepth, kS}}, made_up(lab), {20000, 3});
        const ReadingUncertainty& r = u.readings[0];
        EXPECT_NEAR(r.first_order.lab()[0], k * kS, 1e-9);
        EXPECT_NEAR(r.mean_shift[0], c * kS * kS, 1e-9);
        EXPECT_EQ(r.linearity[0].fails, fails) << k << " " << c;
        EXPECT_FALSE(r.linearity[1].fails);
        EXPECT_EQ(u.first_order_fails(), fails);
        if (k > 0) {
            EXPECT_NEAR(r.linearity[0].beyond, std::sqrt(2.0) * c * kS / k, 1e-6);
        }
        // The kurtosis of a square is 15: its variance is less sure than that of a normal number.
        const double variance = k * k * kS * kS + 2 * c * c * std::pow(kS, 4);
        EXPECT_NEAR(r.sampled->covariance[0][0] / variance, 1,
                    kSigmas * std::sqrt(14.0 / u.samples));
        EXPECT_NEAR(r.sampled->mean[0], 50 + c * kS * kS,
                    kSigmas * std::sqrt(variance / u.samples));
    }
}

TEST(Uncertainty, SaysWhereANumberMeetsItsRange) {
    const auto lab = [](double, double r) { return Vec3d{50 + 10 * r, 20, 0}; };
    paint::Recipe recipe = grey_ground();
    const auto with = [&](double reflectance, double sigma) {
        recipe.substrate_reflectance = reflectance;
        return uncertainty(recipe, {{kGround, sigma}}, made_up(lab), {200, 0});
    };
    EXPECT_FALSE(with(0.5, 0.1).numbers[0].meets_range);
    EXPECT_FALSE(with(0.5, 0.1).first_order_fails());
    const Uncertainty near = with(0.05, 0.02);
    EXPECT_TRUE(near.numbers[0].meets_range);
    EXPECT_FALSE(near.readings[0].linearity[0].unknown);
    EXPECT_TRUE(near.first_order_fails());
    const Uncertainty at_end = with(0, 0.02);  // a one-sided derivative
    EXPECT_NEAR(at_end.readings[0].change[0][0], 0.2, 1e-9);
    EXPECT_TRUE(at_end.readings[0].linearity[0].unknown);
    EXPECT_TRUE(at_end.readings[0].linearity[0].fails);
    EXPECT_GT(at_end.redrawn, 100);
    // Half of a normal law: its deviation is sqrt(1 - 2/pi) times that of the whole.
    EXPECT_NEAR(at_end.readings[0].sampled->lab()[0], 0.2 * std::sqrt(1 - 2 / std::numbers::pi),
                0.2 * kSigmas / std::sqrt(2.0 * 200));
}

TEST(Uncertainty, EllipseHoldsItsProbability) {
    Spread spread;
    spread.mean = {50, 3, -4};
    const double turn = 0.4, major = 2, minor = 0.5;
    const double c = std::cos(turn), s = std::sin(turn);
    spread.covariance[1] = {0, major * major * c * c + minor * minor * s * s,
                            (major * major - minor * minor) * s * c};
    spread.covariance[2] = {0, spread.covariance[1][2],
                            major * major * s * s + minor * minor * c * c};
    // 1 - exp(-k^2 / 2) of a normal colour lies within k standard deviations.
    const Ellipse e = ab_ellipse(spread, 0.95);
    const double k = std::sqrt(-2 * std::log(0.05));
    EXPECT_EQ(e.centre, (std::array{3.0, -4.0}));
    EXPECT_NEAR(e.major[0], k * major * c, 1e-12);
    EXPECT_NEAR(e.major[1], k * major * s, 1e-12);
    EXPECT_NEAR(e.minor[0], -k * minor * s, 1e-12);
    EXPECT_NEAR(e.minor[1], k * minor * c, 1e-12);
    EXPECT_THROW(ab_ellipse(spread, 1), DomainError);
    EXPECT_NEAR(std::hypot(ab_ellipse({}, 0.5).major[0], 0.0), 0, 0);
}

PaintReader solved(bool hot_spot = false) {
    return solution_reader(spectra::default_wavelengths_nm(), testing::six_angles(), {}, hot_spot);
}

TEST(Uncertainty, NothingUncertainGivesZeros) {
    const Uncertainty u =
        uncertainty(testing::pearl(), {{kTitania, 0}, {kVolume, 0, true}}, solved());
    ASSERT_EQ(u.readings.size(), 6u);
    for (const ReadingUncertainty& r : u.readings) {
        EXPECT_EQ(r.first_order.covariance, LabCovariance{});
        EXPECT_EQ(r.first_order.chroma, 0);
        EXPECT_EQ(r.first_order.hue_deg, 0);
        EXPECT_EQ(r.first_order.reflectance_factor, std::vector<double>(31, 0.0));
        EXPECT_EQ(r.mean_shift, Vec3d{});
        EXPECT_TRUE(r.doubtful().empty());
        EXPECT_EQ(variance_fractions(r.change), (std::vector<double>{0, 0}));
    }
    EXPECT_EQ(u.flop_index->first_order, 0);
    EXPECT_FALSE(u.first_order_fails());
}

TEST(Uncertainty, TwiceTheDeviationsAreTwiceTheSpread) {
    const Uncertainty once =
        uncertainty(testing::pearl(), {{kTitania, 1}, {kVolume, 0.02, true}}, solved());
    const Uncertainty twice =
        uncertainty(testing::pearl(), {{kTitania, 2}, {kVolume, 0.04, true}}, solved());
    for (std::size_t i = 0; i < once.readings.size(); ++i) {
        const Spread &a = once.readings[i].first_order, &b = twice.readings[i].first_order;
        for (int c = 0; c < 3; ++c) {
            EXPECT_GT(a.lab()[c], 0.01);
            EXPECT_NEAR(b.lab()[c], 2 * a.lab()[c], 1e-9);
        }
        EXPECT_NEAR(*b.chroma, 2 * *a.chroma, 1e-9);
        EXPECT_NEAR(*b.hue_deg, 2 * *a.hue_deg, 1e-9);
        EXPECT_NEAR(b.reflectance_factor[15], 2 * a.reflectance_factor[15], 1e-12);
    }
    EXPECT_NEAR(twice.flop_index->first_order, 2 * once.flop_index->first_order, 1e-9);
}

// Light that the ground returns comes out with A rho / (1 - B rho), of which two other grounds give
// A and B.                                                                      [saunderson-1942]
TEST(Uncertainty, OfTheGroundIsThatOfItsClosedForm) {
    paint::Recipe clear = test::paint_of(1.5, {test::pigment_layer(0, 0.05, 0)}, 0.4);
    const auto factor = [&](double rho) {
        paint::Recipe recipe = clear;
        recipe.substrate_reflectance = rho;
        return testing::read(recipe).readings[2].reflectance_factor[10];
    };
    const double f1 = factor(0.2), f2 = factor(0.8);
    const double b = (0.2 / f1 - 0.8 / f2) / (0.2 * 0.8 * (1 / f1 - 1 / f2));
    const double a = f1 * (1 - b * 0.2) / 0.2;
    ASSERT_NEAR(factor(0.4), a * 0.4 / (1 - b * 0.4), 1e-6);
    const double sigma = 0.002;
    const Uncertainty u = uncertainty(clear, {{kGround, sigma}}, solved());
    EXPECT_NEAR(u.readings[2].first_order.reflectance_factor[10],
                sigma * a / std::pow(1 - b * 0.4, 2), 1e-5 * sigma);
    for (const ReadingUncertainty& r : u.readings) {
        EXPECT_FALSE(r.first_order.hue_deg)
            << "a grey has none, though its a* and b* are not quite 0";
    }
    EXPECT_FALSE(u.first_order_fails());
}

struct MeanAndDeviation {
    double mean, deviation;
};
struct DrawnReading {
    MeanAndDeviation lab[3];
    double chroma, hue_deg, factor;  ///< deviations; the reflectance factor's at 520 nm
};
/// What recipes drawn at random read.
struct Draws {
    std::size_t count;
    DrawnReading readings[6];
    MeanAndDeviation flop;
};

/// Recipes that are drawn here, solved on their own and read.
Draws draw(const paint::Recipe& recipe, const std::vector<paint::ParameterDeviation>& deviations,
           std::size_t count) {
    std::mt19937_64 rng(20240611);
    std::normal_distribution<double> normal(0, 1);
    std::vector<paint::Recipe> drawn(count, recipe);
    for (paint::Recipe& one : drawn) {
        for (const paint::ParameterDeviation& d : deviations) {
            const double value = paint::find_parameter(recipe, d.key).value;
            paint::set_parameter(one, d.key,
                                 value + paint::standard_deviation(recipe, d) * normal(rng));
        }
    }
    std::vector<measure::Measurement> read(count);
    parallel_for(0, count, [&](std::size_t i) { read[i] = testing::read(drawn[i]); });

    const auto statistics = [&](const auto& quantity) {
        const double n = static_cast<double>(count);
        double mean = 0, variance = 0;
        for (const auto& m : read) mean += quantity(m) / n;
        for (const auto& m : read) variance += std::pow(quantity(m) - mean, 2) / (n - 1);
        return MeanAndDeviation{mean, std::sqrt(variance)};
    };
    Draws draws{count, {}, statistics([](const auto& m) { return *measure::flop_index(m); })};
    for (std::size_t r = 0; r < std::size(draws.readings); ++r) {
        DrawnReading& here = draws.readings[r];
        for (int c = 0; c < 3; ++c) {
            here.lab[c] = statistics([&](const auto& m) { return m.readings[r].lab[c]; });
        }
        here.chroma =
            statistics([&](const auto& m) { return measure::chroma(m.readings[r].lab); }).deviation;
        here.hue_deg = statistics([&](const auto& m) {
                           return measure::hue_deg(m.readings[r].lab);
                       }).deviation;
        here.factor = statistics([&](const auto& m) {
                          return m.readings[r].reflectance_factor[12];
                      }).deviation;
    }
    return draws;
}

void print(const Draws& draws) {
    fmt::print("{{\n");
    for (const DrawnReading& r : draws.readings) {
        fmt::print("{{{{");
        for (const auto& [mean, deviation] : r.lab)
            fmt::print("{{{:.6g}, {:.5g}}}, ", mean, deviation);
        fmt::print("}}, {:.5g}, {:.5g}, {:.5g}}},\n", r.chroma, r.hue_deg, r.factor);
    }
    fmt::print("}}, {{{:.6g}, {:.5g}}}\n", draws.flop.mean, draws.flop.deviation);
}

void expect_like(const Draws& draws, const Uncertainty& u) {
    const double count = static_cast<double>(draws.count);
    SCOPED_TRACE(draws.count);
    // The next terms change a variance by about a fraction beyond^2, a deviation by half of that; as
    // much again for those of higher order. The default solver's error is 1e-3.
    const auto compare_deviation = [&](const std::string& what, double drawn, double sd,
                                       double beyond) {
        EXPECT_NEAR(drawn, sd, kSigmas * sd / std::sqrt(2.0 * count) + beyond * beyond * sd + 2e-3)
            << what;
    };
    const auto compare = [&](const std::string& what, const MeanAndDeviation& drawn, double value,
                             double sd, double shift, double beyond) {
        EXPECT_NEAR(
            drawn.mean, value + shift,
            kSigmas * sd / std::sqrt(count) + beyond * beyond * sd + 0.1 * std::abs(shift) + 2e-3)
            << what;
        compare_deviation(what, drawn.deviation, sd, beyond);
    };
    ASSERT_EQ(u.readings.size(), std::size(draws.readings));
    for (std::size_t r = 0; r < u.readings.size(); ++r) {
        const ReadingUncertainty& here = u.readings[r];
        const DrawnReading& drawn = draws.readings[r];
        const std::string& name = here.reading.geometry.name;
        for (int c = 0; c < 3; ++c) {
            compare(name, drawn.lab[c], here.reading.lab[c], here.first_order.lab()[c],
                    here.mean_shift[c], here.linearity[static_cast<std::size_t>(c)].beyond);
        }
        compare_deviation(name, drawn.chroma, *here.first_order.chroma, here.linearity[3].beyond);
        compare_deviation(name, drawn.hue_deg, *here.first_order.hue_deg, here.linearity[4].beyond);
        EXPECT_NEAR(drawn.factor / here.first_order.reflectance_factor[12], 1,
                    std::max(0.25, kSigmas / std::sqrt(2.0 * count)))
            << name;
    }
    const MetricUncertainty& flop = *u.flop_index;
    compare("flop", draws.flop, flop.value, flop.first_order, flop.mean_shift,
            flop.linearity.beyond);
}

// Means and deviations of recipes that are drawn at random: of a few each time, and of many that
// are frozen. Hues travel with the film: over 2 nm by several degrees, and its interference
// bends.
/// @param of_the_rest  relative deviation of the other numbers
void compare_with_draws(double film_sigma_nm, double of_the_rest, bool holds, const Draws& frozen) {
    const paint::Recipe recipe = testing::pearl(95);
    const std::vector<paint::ParameterDeviation> deviations = {{kTitania, film_sigma_nm},
                                                               {kVolume, of_the_rest, true},
                                                               {kTilt, of_the_rest, true},
                                                               {kDepth, of_the_rest, true}};
    const Uncertainty u = uncertainty(recipe, deviations, solved());
    EXPECT_EQ(u.first_order_fails(), !holds);
    if (std::getenv("NACRE_WRITE_TRUTH")) print(draw(recipe, deviations, frozen.count));
    expect_like(frozen, u);
    expect_like(draw(recipe, deviations, 40), u);
    double max_hue = 0;
    for (const ReadingUncertainty& here : u.readings) {
        max_hue = std::max(max_hue, *here.first_order.hue_deg);
    }
    EXPECT_GT(max_hue, 3 * film_sigma_nm);  // the film is uncertain enough to matter
}

// The draws are of the solver of Nacre 0.1.0, printed by NACRE_WRITE_TRUTH=1 with these filters. Where
// first order is not enough, more of them would show nothing but what it leaves out.
TEST(Uncertainty, AgreesWithRecipesDrawnAtRandom) {
    compare_with_draws(
        0.5, 0.01, true,
        {4000,
         {{{{61.8262, 0.74272}, {9.65001, 0.59992}, {46.1187, 0.43415}},
           0.49193,
           0.67342,
           0.0085049},
          {{{55.5022, 0.71231}, {11.9071, 0.63674}, {41.4201, 0.56572}},
           0.4484,
           0.96415,
           0.0069346},
          {{{50.2988, 0.628}, {11.635, 0.60874}, {36.6485, 0.66311}}, 0.48799, 1.1293, 0.0054179},
          {{{37.0751, 0.42628}, {9.38851, 0.46292}, {23.6536, 0.69409}},
           0.48246,
           1.5362,
           0.0024823},
          {{{19.6664, 0.23049}, {3.00209, 0.1538}, {4.54975, 0.33884}},
           0.30036,
           2.3147,
           0.00043532},
          {{{13.904, 0.046661}, {-0.286226, 0.044298}, {-1.46515, 0.05612}},
           0.059471,
           1.527,
           6.9784e-05}},
         {7.54221, 0.1004}});
}
TEST(Uncertainty, SaysThatInterferenceBendsOverTwoNanometres) {
    compare_with_draws(
        2, 0.05, false,
        {400,
         {{{{61.7508, 3.4064}, {9.80919, 2.4243}, {45.3608, 2.3056}}, 2.4278, 2.8676, 0.036964},
          {{{55.4336, 3.1971}, {12.0517, 2.5661}, {40.4771, 2.8262}}, 2.32, 4.2055, 0.029555},
          {{{50.202, 2.7584}, {11.7534, 2.4403}, {35.7322, 3.0237}}, 2.2627, 4.9441, 0.022668},
          {{{36.9224, 1.7937}, {9.42126, 1.8254}, {22.9658, 2.873}}, 1.9205, 6.6977, 0.010082},
          {{{19.6319, 1.0774}, {2.95448, 0.69855}, {4.41366, 1.4904}}, 1.3841, 10.121, 0.0019759},
          {{{13.9339, 0.231}, {-0.271407, 0.20212}, {-1.40906, 0.28439}},
           0.29615,
           8.3503,
           0.00032098}},
         {7.54484, 0.49269}});
}

TEST(Uncertainty, SamplesDoNotDependOnThreads) {
    const auto run = [&](int threads) {
        const ThreadLimit limit(threads);
        return uncertainty(testing::pearl(), {{kTitania, 2}, {kTilt, 0.1, true}},
                           solution_reader({450, 550, 650}, {testing::six_angles()[0]}, {}, true),
                           {12, 5});
    };
    const Uncertainty one = run(1), two = run(2);
    EXPECT_EQ(one.readings[0].first_order.covariance, two.readings[0].first_order.covariance);
    EXPECT_EQ(one.readings[0].sampled->covariance, two.readings[0].sampled->covariance);
    EXPECT_FALSE(one.flop_index);  // one angle has none
    EXPECT_FALSE(one.colour_travel);
}

TEST(Uncertainty, RefusesWhatItCannotCarry) {
    const auto lab = [](double, double) { return Vec3d{50, 20, 0}; };
    const auto message = [&](const std::vector<paint::ParameterDeviation>& deviations,
                             const UncertaintyOptions& options = {}) {
        return message_of<DomainError>(
            [&] { uncertainty(grey_ground(), deviations, made_up(lab), options); });
    };
    EXPECT_THAT(message({}), HasSubstr("no number"));
    EXPECT_THAT(message({{kGround, 0.1}, {kGround, 0.2}}), HasSubstr("named twice"));
    EXPECT_THAT(message({{"substrate.reflectence", 0.1}}), HasSubstr("did you mean"));
    EXPECT_THAT(message({{kGround, -0.1}}), HasSubstr(kGround + " = -0.1"));
    EXPECT_THAT(message({{kGround, 0.1}}, {3}), HasSubstr("samples"));
    EXPECT_THROW(
        uncertainty(testing::pearl(), {{kTitania, 1}}, solved(), {}, [](double) { return false; }),
        Error);
    EXPECT_THROW(uncertainty(grey_ground(), {{kGround, 0.1}}, made_up(lab), {},
                             [](double) { return false; }),
                 Stopped);
}

}  // namespace
}  // namespace nacre::fit
