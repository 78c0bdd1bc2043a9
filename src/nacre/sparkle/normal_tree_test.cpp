#include "nacre/sparkle/normal_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/sparkle/facet_field.h"

namespace nacre::sparkle {
namespace {

TEST(NormalTree, MassesAreThoseOfSampledNormals) {
    constexpr double kFacets = 200000;
    for (const double alpha : {0.02, 0.07, 0.5}) {
        const NormalTree tree(alpha, 0.05);
        const FacetField field(kFacets, alpha, 3, 1);
        std::map<NormalTree::Code, double> found;
        field.for_each_facet({0.5, 0.5, {1, 0}, {0, 1}},
                             [&](const Facet& f) { ++found[tree.locate(f.normal)]; });
        // Pearson's statistic over the triangles where enough is expected.
        double chi2 = 0, cells = 0, mass = 0;
        for (const auto& [leaf, count] : found) {
            const double expected = kFacets * tree.mass(leaf);
            mass += tree.mass(leaf);
            if (expected < 10) continue;
            chi2 += (count - expected) * (count - expected) / expected;
            ++cells;
        }
        EXPECT_GT(cells, 10);
        EXPECT_NEAR(mass, 1, 0.01);
        EXPECT_LT(chi2, cells + 5 * std::sqrt(2 * cells)) << "alpha " << alpha;
    }
}

TEST(NormalTree, SplitsKeepEveryFacet) {
    const NormalTree tree(0.1, 0.05);
    for (std::uint64_t key = 0; key < 50; ++key) {
        for (const std::uint64_t n : {0ull, 1ull, 77ull, 100000ull, 100000000000ull}) {
            const auto octants = NormalTree::split_octants(n, key);
            EXPECT_EQ(octants.count[0] + octants.count[1] + octants.count[2] + octants.count[3], n);
            const auto parts = tree.split(0, n, key);
            EXPECT_EQ(parts.count[0] + parts.count[1] + parts.count[2] + parts.count[3], n);
            // Asking for less gives the same.
            for (int part = 0; part < 4; ++part) {
                EXPECT_EQ(tree.split(0, n, key, 1u << part).count[part], parts.count[part]);
            }
        }
    }
}

TEST(NormalTree, RefusesValuesOutOfRange) {
    EXPECT_THROW(NormalTree(0, 0.1), DomainError);
    EXPECT_THROW(NormalTree(0.1, 0), DomainError);
    EXPECT_THROW(NormalTree(0.1, NAN), DomainError);
}

}  // namespace
}  // namespace nacre::sparkle
