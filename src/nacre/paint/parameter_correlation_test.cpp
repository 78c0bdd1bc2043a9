#include "nacre/paint/parameter_correlation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "nacre/core/random.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/paints.h"

namespace nacre::paint {
namespace {

using nacre::test::message_of;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

const std::string kFirst = "layer[0].thickness_um", kSecond = "layer[1].thickness_um",
                  kThird = "layer[2].thickness_um", kGround = "substrate.reflectance";

Recipe three_layers() {
    return test::paint_of(1.5,
                          {test::pigment_layer(0.5, 1, 0), test::pigment_layer(0.5, 1, 0),
                           test::pigment_layer(0.5, 1, 0)},
                          0.3);
}

std::vector<ParameterDeviation> deviations_of_layers() {
    return {{kFirst, 1}, {kSecond, 0.02, true}, {kThird, 1}};
}

std::string refused(const std::vector<ParameterCorrelation>& correlations) {
    return message_of<DomainError>(
        [&] { check_correlations(three_layers(), deviations_of_layers(), correlations); });
}

TEST(ParameterCorrelation, TextIsReadBack) {
    const ParameterCorrelation c{{kFirst, kSecond}, -0.8};
    EXPECT_EQ(correlation_text(c), "layer[0].thickness_um,layer[1].thickness_um=-0.8");
    EXPECT_EQ(parse_correlation(correlation_text(c)), c);
    EXPECT_EQ(parse_correlation(" a , *b,c = 1e-1 "),
              (ParameterCorrelation{{"a", "*b", "c"}, 0.1}));
    for (const char* wrong : {"", "a,b", "a,b=", "a,b=x", "a,,b=1", "=1", ",=1"}) {
        EXPECT_THAT(message_of<DomainError>([&] { parse_correlation(wrong); }),
                    HasSubstr("is not A,B=COEFFICIENT"))
            << wrong;
    }
}

TEST(ParameterCorrelation, WhatIsWrongIsSaid) {
    EXPECT_EQ(refused({{{kFirst, kSecond, kThird}, 1}}), "accepted");
    EXPECT_EQ(
        refused({{{kFirst, kSecond}, -1}, {{kFirst, kThird}, 0.5}, {{kSecond, kThird}, -0.5}}),
        "accepted");
    EXPECT_THAT(refused({{{kFirst, kSecond}, 1.01}}),
                HasSubstr("coefficient = 1.01: must be a number in [-1, 1]"));
    EXPECT_THAT(refused({{{kFirst, kSecond}, std::nan("")}}), HasSubstr("[-1, 1]"));
    EXPECT_THAT(refused({{{kFirst}, 0.5}}), HasSubstr("must be 2 to 64 numbers"));
    EXPECT_THAT(refused({{{kFirst, "layer[1].thicknes_um"}, 0.5}}),
                AllOf(HasSubstr("of[1] = layer[1].thicknes_um: "),
                      HasSubstr("did you mean 'layer[1].thickness_um'?")));
    EXPECT_THAT(refused({{{kFirst, kSecond, kFirst}, 0.5}}),
                HasSubstr("of[2] = layer[0].thickness_um: is named twice"));
    EXPECT_THAT(refused({{{kFirst, kGround}, 0.5}}),
                HasSubstr("of[1] = substrate.reflectance: has no standard deviation; those that "
                          "have: layer[0].thickness_um, layer[1].thickness_um"));
    EXPECT_THAT(
        refused({{{kFirst, kSecond, kThird}, 0.5}, {{kThird, kFirst}, 0.5}}),
        HasSubstr("that of layer[2].thickness_um and layer[0].thickness_um is stated twice"));
}

// Two numbers that both go with a third must go with each other.
TEST(ParameterCorrelation, CoefficientsThatCannotBeTogetherAreNamed) {
    const std::string two = refused({{{kFirst, kSecond}, 0.9}, {{kSecond, kThird}, 0.8}});
    EXPECT_THAT(two, AllOf(HasSubstr("0.9 of layer[0].thickness_um and layer[1].thickness_um"),
                           HasSubstr("0.8 of layer[1].thickness_um and layer[2].thickness_um"),
                           HasSubstr("eigenvalue -0.204"),  // 1 - sqrt(0.9^2 + 0.8^2)
                           HasSubstr("[0, inf)"), Not(HasSubstr("0 of layer"))));
    // 1 + 2 r >= 0 for three alike.
    EXPECT_EQ(refused({{{kFirst, kSecond, kThird}, -0.5}}), "accepted");
    EXPECT_THAT(refused({{{kFirst, kSecond, kThird}, -0.51}}), HasSubstr("eigenvalue -0.02"));
}

TEST(ParameterCorrelation, ChangesReplaceSinglePairs) {
    const std::vector<ParameterCorrelation> known = {{{"a", "b", "c"}, 0.5}, {{"d", "e"}, 0.1}};
    EXPECT_EQ(with_correlations(known, {{{"f", "a"}, 0.2}}),
              (std::vector<ParameterCorrelation>{known[0], known[1], {{"f", "a"}, 0.2}}));
    EXPECT_EQ(with_correlations(known, {{{"c", "a"}, 0.2}}),
              (std::vector<ParameterCorrelation>{
                  {{"a", "b"}, 0.5}, {{"b", "c"}, 0.5}, known[1], {{"c", "a"}, 0.2}}));
    EXPECT_EQ(correlations_among(known, [](const std::string& key) { return key > "a"; }),
              (std::vector<ParameterCorrelation>{{{"b", "c"}, 0.5}, known[1]}));
    EXPECT_EQ(correlations_among(known, [](const std::string& key) { return key < "e"; }),
              (std::vector<ParameterCorrelation>{known[0]}));
}

TEST(ParameterCorrelation, RootTimesItsTransposeIsTheMatrix) {
    EXPECT_TRUE(correlation_matrix(deviations_of_layers(), {}).empty());
    const auto expect_root = [](const std::vector<double>& matrix) {
        const auto n = static_cast<std::size_t>(std::lround(std::sqrt(matrix.size())));
        const std::vector<double> root = correlation_root(matrix);
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < n; ++j) {
                double product = 0;
                for (std::size_t k = 0; k < n; ++k) product += root[i * n + k] * root[j * n + k];
                EXPECT_NEAR(product, matrix[i * n + j], 1e-9) << n << ": " << i << ", " << j;
                if (j > i) {
                    EXPECT_EQ(root[i * n + j], 0);
                }
            }
        }
    };
    const auto matrix = [](const std::vector<ParameterCorrelation>& c) {
        return correlation_matrix(deviations_of_layers(), c);
    };
    // Independent numbers stay what they are, to the last bit.
    EXPECT_EQ(correlation_root(matrix({{{kFirst, kSecond}, 0}})),
              (std::vector<double>{1, 0, 0, 0, 1, 0, 0, 0, 1}));
    expect_root(matrix({{{kSecond, kThird}, 0.7}}));
    for (const double r : {1.0, -0.5, 0.3}) expect_root(matrix({{{kFirst, kSecond, kThird}, r}}));
    expect_root(
        matrix({{{kFirst, kSecond}, -1}, {{kFirst, kThird}, 0.5}, {{kSecond, kThird}, -0.5}}));
    // Of n numbers that are made of m independent ones: rank m.
    Rng rng(3);
    for (const std::size_t n : {2u, 5u, 12u}) {
        for (const std::size_t m : {1u, 3u, 12u}) {
            std::vector<double> rows(n * m), r(n * n);
            for (double& x : rows) x = rng.uniform_double() - 0.5;
            for (std::size_t i = 0; i < n; ++i) {
                double length = 0;
                for (std::size_t k = 0; k < m; ++k) length += rows[i * m + k] * rows[i * m + k];
                for (std::size_t k = 0; k < m; ++k) rows[i * m + k] /= std::sqrt(length);
            }
            for (std::size_t i = 0; i < n; ++i) {
                for (std::size_t j = 0; j < n; ++j) {
                    for (std::size_t k = 0; k < m; ++k) {
                        r[i * n + j] += rows[i * m + k] * rows[j * m + k];
                    }
                }
            }
            expect_root(r);
        }
    }
}

}  // namespace
}  // namespace nacre::paint
