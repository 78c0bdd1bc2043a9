#include "nacre/sparkle/facet_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/core/parallel.h"
#include "nacre/testing/allocations.h"
#include "nacre/testing/directions.h"
#include "nacre/testing/statistics.h"

namespace nacre::sparkle {
namespace {

constexpr double kAlpha = 0.07, kGamma_deg = 3;

using test::direction;

Footprint square_footprint(double u, double v, double area) {
    const float side = static_cast<float>(std::sqrt(area));
    return {u, v, {side, 0}, {0, side}};
}

// A turned and sheared footprint of this area somewhere within the square.
Footprint somewhere(Rng& rng, double area) {
    const double side = std::sqrt(area), turn = 2 * std::numbers::pi * rng.uniform_double();
    const float c = static_cast<float>(side * std::cos(turn));
    const float s = static_cast<float>(side * std::sin(turn));
    const double room = 1 - 2.5 * side;
    const double u = 1.25 * side + room * rng.uniform_double();
    const double v = 1.25 * side + room * rng.uniform_double();
    return {u, v, {c, s}, {-s + 0.5f * c, c + 0.5f * s}};
}

struct Geometry {
    const char* name;
    Vec3f wi, wo;
};
const std::vector<Geometry>& geometries() {
    static const std::vector<Geometry> all = {{"peak", direction(30, 0), direction(30, 180)},
                                              {"flank", direction(30, 0), direction(36, 170)},
                                              {"normal", direction(0, 0), direction(4, 20)},
                                              {"grazing", direction(75, 10), direction(73, 195)}};
    return all;
}

double fraction(const FacetField& field, const Geometry& g) {
    return field.cone_rule().means(g.wi, g.wo).projected * field.cone_rule().solid_angle();
}

TEST(FacetField, CountsTheSameFacetsAsASearchThroughAll) {
    constexpr double kFacets = 30000;
    const FacetField field(kFacets, kAlpha, kGamma_deg, 5);
    std::vector<Facet> all;
    field.for_each_facet(square_footprint(0.5, 0.5, 1), [&](const Facet& f) { all.push_back(f); });
    ASSERT_EQ(all.size(), kFacets);

    Rng rng(3);
    long counted = 0;
    for (const Geometry& g : geometries()) {
        const ReflectionCone cone(g.wi, g.wo, field.cone_rule().chord2());
        for (int i = 0; i < 60; ++i) {
            const Footprint footprint = somewhere(rng, std::pow(10, -4 + 0.03 * i));
            if (!field.is_explicit(footprint)) continue;
            std::uint64_t expected = 0;
            for (const Facet& f : all) {
                expected += footprint.contains(f.u, f.v) && cone.contains(f.normal);
            }
            EXPECT_EQ(field.count(footprint, g.wi, g.wo).count, expected) << g.name;
            counted += static_cast<long>(expected);
        }
    }
    EXPECT_GT(counted, 500);
}

// Explicit footprints up to about 1000 facets, larger cells beyond.
TEST(FacetField, MeanAndVarianceAreThoseOfIndependentFacets) {
    struct Case {
        double facets, expected;
        int footprints;
    };
    constexpr int kSeeds = 4;
    for (const Case& c :
         {Case{1e7, 0.05, 60000}, Case{1e9, 1, 20000}, Case{1e5, 30, 4000}, Case{1e12, 300, 2000},
          Case{1e9, 3000, 2000}, Case{1e12, 1e5, 2000}, Case{1e9, 1e6, 1000}}) {
        std::vector<FacetField> fields;
        for (int seed = 0; seed < kSeeds; ++seed) {
            fields.emplace_back(c.facets, kAlpha, kGamma_deg, seed);
        }
        for (const Geometry& g : geometries()) {
            double sum = 0, squares = 0;
            const double expected = c.expected * fraction(fields[0], g);
            for (int i = 0; i < c.footprints; ++i) {
                Rng rng(17, i);
                const Footprint footprint = somewhere(rng, c.expected / c.facets);
                const double n =
                    static_cast<double>(fields[i % kSeeds].count(footprint, g.wi, g.wo).count) -
                    expected;
                sum += n;
                squares += n * n;
            }
            const double mean = sum / c.footprints;
            const double variance = squares / c.footprints - mean * mean;
            // Both footprints and whole objects vary in how many facets reflect this way.
            const double objects = c.expected / (kSeeds * c.facets);
            EXPECT_NEAR(mean, 0, 4 * std::sqrt(expected * (1.0 / c.footprints + objects)))
                << g.name << ", K " << c.facets << ", " << c.expected << " facets, mean "
                << expected;
            EXPECT_NEAR(variance, expected,
                        5 * expected * std::sqrt((2 + 1 / expected) / c.footprints))
                << g.name << ", K " << c.facets << ", " << c.expected << " facets";
        }
    }
}

TEST(FacetField, PartsOfAFootprintAddUpExactly) {
    const FacetField field(1e9, kAlpha, kGamma_deg, 8);
    Rng rng(4);
    const Geometry& g = geometries()[0];
    std::uint64_t counted = 0;
    for (int i = 0; i < 200; ++i) {
        // Sides that are sums of powers of two: the parts' borders are the same numbers.
        const float side = 0x1p-11f;
        const double u = 0.25 + 0.5 * std::floor(1024 * rng.uniform_double()) / 1024;
        const double v = 0.25 + 0.5 * std::floor(1024 * rng.uniform_double()) / 1024;
        const Footprint whole(u, v, {side, 0}, {0, side});
        ASSERT_TRUE(field.is_explicit(whole));
        std::uint64_t sum = 0;
        for (const double x : {-0.25, 0.25}) {
            for (const double y : {-0.25, 0.25}) {
                const Footprint part(u + x * side, v + y * side, {side / 2, 0}, {0, side / 2});
                sum += field.count(part, g.wi, g.wo).count;
            }
        }
        EXPECT_EQ(field.count(whole, g.wi, g.wo).count, sum);
        counted += sum;
    }
    EXPECT_GT(counted, 1000u);
}

TEST(FacetField, TheSameFacetsAnswerInAnyOrderAndOnAnyThread) {
    constexpr int kQueries = 400;
    const FacetField field(1e8, kAlpha, kGamma_deg, 9), again(1e8, kAlpha, kGamma_deg, 9);
    const auto query = [&](const FacetField& f, std::size_t i) {
        Rng rng(21, i);
        const Footprint footprint = somewhere(rng, std::pow(10, -9 + 6 * rng.uniform_double()));
        const Geometry& g = geometries()[i % geometries().size()];
        const FacetTally t = f.count(footprint, g.wi, g.wo);
        double sum = static_cast<double>(t.count);
        for (int k = 0; k < t.listed; ++k) sum += t.thickness[k];
        return sum;
    };
    std::vector<double> forwards(kQueries), backwards(kQueries), parallel(kQueries);
    for (int i = 0; i < kQueries; ++i) forwards[i] = query(field, i);
    for (int i = kQueries - 1; i >= 0; --i) backwards[i] = query(again, i);
    parallel_for(0, kQueries, [&](std::size_t i) { parallel[i] = query(field, i); });
    EXPECT_EQ(forwards, backwards);
    EXPECT_EQ(forwards, parallel);
    double sum = 0;
    for (double x : forwards) sum += x;
    EXPECT_GT(sum, 1000);
}

TEST(FacetField, IsReciprocal) {
    const FacetField field(1e8, kAlpha, kGamma_deg, 10);
    Rng rng(5);
    long counted = 0;
    for (int i = 0; i < 300; ++i) {
        const Footprint footprint = somewhere(rng, i % 2 ? 1e-6 : 1e-3);
        const Geometry& g = geometries()[i % geometries().size()];
        const auto there = field.count(footprint, g.wi, g.wo).count;
        EXPECT_EQ(there, field.count(footprint, g.wo, g.wi).count);
        counted += static_cast<long>(there);
    }
    EXPECT_GT(counted, 1000);
}

TEST(FacetField, ThicknessesAreEvenAndBelongToTheirFacets) {
    const FacetField field(1e8, kAlpha, kGamma_deg, 11);
    Rng rng(6);
    double sum = 0, squares = 0;
    int count = 0;
    for (int i = 0; i < 2000; ++i) {
        const Footprint footprint = somewhere(rng, 1e-6);
        const FacetTally t = field.count(footprint, geometries()[0].wi, geometries()[0].wo);
        for (int k = 0; k < t.listed; ++k, ++count) {
            sum += t.thickness[k];
            squares += t.thickness[k] * t.thickness[k];
        }
    }
    ASSERT_GT(count, 10000);
    EXPECT_NEAR(sum / count, 0.5, 4 * std::sqrt(1.0 / 12 / count));
    EXPECT_NEAR(squares / count, 1.0 / 3, 4 * std::sqrt(4.0 / 45 / count));
}

TEST(FacetField, QueriesAllocateNothing) {
    const FacetField field(1e9, kAlpha, kGamma_deg, 12);
    Rng rng(7);
    std::uint64_t sum = 0;
    const std::vector<Geometry>& directions = geometries();  // made at first use
    const long before = test::allocations;
    for (int i = 0; i < 300; ++i) {
        const Footprint footprint = somewhere(rng, std::pow(10, -10 + 0.03 * i));
        for (const Geometry& g : directions) sum += field.count(footprint, g.wi, g.wo).count;
    }
    EXPECT_EQ(test::allocations, before);
    EXPECT_GT(sum, 1000u);
}

TEST(FacetField, ObjectsOfNoneOneAndATrillionFacets) {
    const Geometry& g = geometries()[0];
    const Footprint all = square_footprint(0.5, 0.5, 1);
    EXPECT_EQ(FacetField(0, kAlpha, kGamma_deg, 1).count(all, g.wi, g.wo).count, 0u);
    int one = 0;
    for (std::uint64_t seed = 0; seed < 4000; ++seed) {
        const auto n = FacetField(1, kAlpha, 20, seed).count(all, g.wi, g.wo).count;
        ASSERT_LE(n, 1u);
        one += static_cast<int>(n);
    }
    const double p = fraction(FacetField(1, kAlpha, 20, 0), g);
    EXPECT_NEAR(one, 4000 * p, 5 * std::sqrt(4000 * p * (1 - p)));

    const FacetField many(1e12, kAlpha, kGamma_deg, 1);
    const double expected = 1e12 * fraction(many, g);
    EXPECT_NEAR(static_cast<double>(many.count(all, g.wi, g.wo).count), expected,
                5 * std::sqrt(expected));
}

TEST(FacetField, CountsOverItsWholeRangeOfConesAndRoughness) {
    for (const auto& [alpha, gamma_deg] :
         {std::pair{0.001, 0.05}, std::pair{0.001, 1.4}, std::pair{0.02, 28.0},
          std::pair{1.0, 0.05}, std::pair{1.0, 30.0}}) {
        const FacetField field(1e10, alpha, gamma_deg, 3);
        for (const Geometry& g : {geometries()[0], geometries()[3]}) {
            for (const double area : {5e-8, 1e-3}) {
                double sum = 0;
                const Vec3f wo = {-g.wi.x, -g.wi.y, g.wi.z};
                constexpr int kFootprints = 100;
                for (int i = 0; i < kFootprints; ++i) {
                    Rng rng(41, i);
                    sum += static_cast<double>(field.count(somewhere(rng, area), g.wi, wo).count);
                }
                const double fraction =
                    field.cone_rule().means(g.wi, wo).projected * field.cone_rule().solid_angle();
                const double expected = kFootprints * 1e10 * area * fraction;
                EXPECT_NEAR(sum, expected, 5 * std::sqrt(expected) + 1e-3 * expected)
                    << "alpha " << alpha << ", gamma " << gamma_deg << ", area " << area;
            }
        }
    }
}

// Thin and long: touches any number of the smallest cells, so larger ones answer. Needles in one
// field are answered by the same cells: each has a field of its own.
TEST(FacetField, ElongatedFootprintsAreBoundedAndUnbiased) {
    const Geometry& g = geometries()[0];
    test::Sample ratio;
    for (int i = 0; i < 400; ++i) {
        const FacetField field(1e12, kAlpha, kGamma_deg, 13 + i);
        Rng rng(31, i);
        const float turn = 6.2831853f * rng.uniform_float();
        const float c = 0.4f * std::cos(turn), s = 0.4f * std::sin(turn);
        const Footprint needle(0.5, 0.5, {c, s}, {-1e-10f * s, 1e-10f * c});
        EXPECT_FALSE(field.is_explicit(needle));
        ratio.add(static_cast<double>(field.count(needle, g.wi, g.wo).count) /
                  (1e12 * needle.area() * fraction(field, g)));
    }
    EXPECT_NEAR(ratio.mean(), 1, test::kWorstZ * ratio.error());
    EXPECT_LT(ratio.error(), 0.05);
}

TEST(FacetField, RefusesValuesOutOfRange) {
    EXPECT_THROW(FacetField(-1, kAlpha, 3, 0), DomainError);
    EXPECT_THROW(FacetField(1e16, kAlpha, 3, 0), DomainError);
    EXPECT_THROW(FacetField(10.5, kAlpha, 3, 0), DomainError);
    EXPECT_THROW(FacetField(NAN, kAlpha, 3, 0), DomainError);
    EXPECT_THROW(FacetField(10, 0, 3, 0), DomainError);
    EXPECT_THROW(FacetField(10, kAlpha, 0, 0), DomainError);
    EXPECT_THROW(FacetField(10, kAlpha, 45, 0), DomainError);
    EXPECT_THROW(FacetField(10, 0.001, 10, 0), DomainError);  // a cone far wider than the lobe
}

}  // namespace
}  // namespace nacre::sparkle
