#include "nacre/paint/normal_weights.h"

#include <gtest/gtest.h>

#include "nacre/optics/material.h"
#include "nacre/paint/beckmann.h"

namespace nacre::paint {
namespace {

FlakeTable film_on_mica() {
    const optics::Material oxide(optics::ComplexIndex(2.9, 0.4));
    const optics::Platelet platelet{{1.58, 500, {.standard_deviation_nm = 60}}, {{oxide, 70, {}}}};
    return FlakeTable::of_platelet(platelet, 1.5, std::vector<double>{450, 550, 650});
}

// Both are sums of the same products, in another order.
TEST(NormalWeights, SumsAreThoseOfLookUpsAtTheNormals) {
    constexpr double kRounding = 1e-13;
    const FlakeTable tables[] = {film_on_mica(),
                                 FlakeTable::constant(std::vector<double>{0.4, 0.2, 0.9},
                                                      std::vector<double>{0.5, 0.8, 0.0})};
    int cases = 0;
    for (const FlakeTable& table : tables) {
        for (const double alpha : {0.02, 0.1, 0.5, 1.5}) {
            for (const double mu : {1.0, 0.9, 0.75, 0.3, 0.05, 1e-4, 0.0}) {
                const int nodes = normal_nodes(alpha, table.cosine_count());
                DoubleLanes reflected{}, blocked{}, both{};
                for_each_normal(mu, alpha, nodes, [&](double cosine, double weight) {
                    const DoubleLanes b = 1.0 - table.transmittance(cosine, 0);
                    reflected += weight * table.reflectance(cosine, 0);
                    blocked += weight * b;
                    both += weight * b * b;
                });
                const NormalWeights normals(mu, alpha, nodes);
                const auto blocked_at = [&](int node) {
                    return 1.0 - table.transmittance_at(node, 0);
                };
                const DoubleLanes r =
                    normals.sum([&](int node) { return table.reflectance_at(node, 0); });
                const DoubleLanes b = normals.sum(blocked_at);
                const DoubleLanes b2 = normals.sum_of_square(blocked_at);
                for (int lane = 0; lane < kLanes; ++lane) {
                    EXPECT_NEAR(r[lane], reflected[lane], kRounding * reflected[lane]);
                    EXPECT_NEAR(b[lane], blocked[lane], kRounding * blocked[lane]);
                    EXPECT_NEAR(b2[lane], both[lane], kRounding * both[lane]);
                    EXPECT_GT(b2[lane], 0);
                    ++cases;
                }
            }
        }
    }
    EXPECT_EQ(cases, 2 * 4 * 7 * kLanes);
}

// Of what blocks nothing, nothing: no rounding that would be negative somewhere.
TEST(NormalWeights, NothingSumsToNothing) {
    const NormalWeights normals(0.8, 0.2, kNormalNodes);
    EXPECT_EQ(normals.sum([](int) { return 0.0; }), 0);
    EXPECT_EQ(normals.sum_of_square([](int) { return 0.0; }), 0);
    EXPECT_NEAR(normals.sum([](int) { return 1.0; }), projected_area(0.8, 0.2), 1e-5);
}

}  // namespace
}  // namespace nacre::paint
