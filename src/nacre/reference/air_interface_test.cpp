#include "nacre/reference/air_interface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nacre/core/quadrature.h"

namespace nacre::reference {
namespace {

Direction3 direction(double mu) { return {std::sqrt(1 - mu * mu), 0, mu}; }

TEST(SmoothInterface, RaysObeySnell) {
    const auto interface = make_smooth_interface(1.5);
    RandomStream random(1, 2, 3);
    const Direction3 outside(0.6, 0.48, 0.64);
    const auto entry = interface->enter(outside, random);
    EXPECT_NEAR(entry.travel.norm(), 1, 1e-15);
    EXPECT_LT(entry.travel.z(), 0);
    EXPECT_NEAR(entry.travel.x(), -outside.x() / 1.5, 1e-15);
    EXPECT_NEAR(entry.travel.y(), -outside.y() / 1.5, 1e-15);
    EXPECT_EQ(interface->connect(outside, random).travel, -entry.travel);
}

TEST(SmoothInterface, ReflectsFourPercentOfNormalIncidence) {
    const auto interface = make_smooth_interface(1.5);
    RandomStream random(1, 2, 3);
    EXPECT_NEAR(interface->enter({0, 0, 1}, random).weight, 0.96, 1e-15);
    EXPECT_NEAR(interface->reflect_inside({0, 0, 1}, random).weight, 0.04, 1e-15);
}

TEST(SmoothInterface, ReflectsAllBeyondTheCriticalAngle) {
    const auto interface = make_smooth_interface(1.5);
    RandomStream random(1, 2, 3);
    const double critical = std::sqrt(1 - 1 / (1.5 * 1.5));
    EXPECT_EQ(interface->reflect_inside(direction(critical - 1e-6), random).weight, 1);
    EXPECT_LT(interface->reflect_inside(direction(critical + 1e-6), random).weight, 1);
    const auto grazing = interface->reflect_inside(direction(0.1), random);
    EXPECT_DOUBLE_EQ(grazing.travel.z(), -0.1);
    EXPECT_EQ(grazing.weight, 1);
}

TEST(SmoothInterface, LightComesOutAsMuchAsItGoesIn) {
    // Isotropic radiance 1 inside: the flux that the inner side lets through is the flux that
    // connections find outside.
    const double index = 1.7;
    const auto interface = make_smooth_interface(index);
    RandomStream random(1, 2, 3);
    double connected = 0, let_through = 0;
    const Quadrature outside = gauss_legendre(256, 0, 1);
    for (std::size_t i = 0; i < outside.nodes.size(); ++i) {
        const double mu = outside.nodes[i];
        connected += outside.weights[i] * mu * interface->connect(direction(mu), random).weight;
    }
    const Quadrature inside = gauss_legendre(1024, std::sqrt(1 - 1 / (index * index)), 1);
    for (std::size_t i = 0; i < inside.nodes.size(); ++i) {
        const double mu = inside.nodes[i];
        let_through +=
            inside.weights[i] * mu * (1 - interface->reflect_inside(direction(mu), random).weight);
    }
    EXPECT_NEAR(connected, let_through, 1e-6);  // the square root at the critical angle
}

TEST(SmoothInterface, EqualIndicesAreNoInterface) {
    const auto interface = make_smooth_interface(1);
    RandomStream random(1, 2, 3);
    for (double mu : {1e-6, 0.3, 1.0}) {
        EXPECT_EQ(interface->enter(direction(mu), random).weight, 1);
        EXPECT_EQ(interface->reflect_inside(direction(mu), random).weight, 0);
        EXPECT_EQ(interface->connect(direction(mu), random).weight, 1);
    }
}

TEST(SmoothInterface, MeetingsByLotHaveTheWeightsAndDirectionsOfTheOthers) {
    const auto interface = make_smooth_interface(1.5);
    RandomStream random(1, 2, 3);
    constexpr int kMeetings = 40'000;
    for (const double mu : {0.2, 0.8, 0.95}) {
        const Direction3 outside = direction(mu), travel = direction(mu);
        const auto entry = interface->enter(outside, random);
        const auto reflection = interface->reflect_inside(travel, random);
        int entered = 0, reflected = 0;
        for (int i = 0; i < kMeetings; ++i) {
            const auto in = interface->meet_from_outside(outside, random);
            const Direction3 mirrored(-outside.x(), -outside.y(), outside.z());
            EXPECT_LT((in.travel - (in.inside ? entry.travel : mirrored)).norm(), 1e-14);
            entered += in.inside;
            const auto out = interface->meet_from_inside(travel, random);
            if (out.inside) {
                EXPECT_LT((out.travel - reflection.travel).norm(), 1e-14);
            } else {
                EXPECT_NEAR(out.travel.x(), 1.5 * travel.x(), 1e-14) << "Snell";
                EXPECT_NEAR(out.travel.norm(), 1, 1e-14);
                EXPECT_GT(out.travel.z(), 0);
            }
            reflected += out.inside;
        }
        const auto expect_share = [&](int count, double share) {
            const double deviation = std::sqrt(share * (1 - share) * kMeetings);
            EXPECT_NEAR(count, share * kMeetings, 4 * deviation) << mu;
        };
        expect_share(entered, entry.weight);
        expect_share(reflected, reflection.weight);
    }
}

}  // namespace
}  // namespace nacre::reference
