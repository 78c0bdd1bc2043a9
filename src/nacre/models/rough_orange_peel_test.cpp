#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "nacre/bsdf/models/interface_lobe.h"
#include "nacre/bsdf/models/microflake.h"
#include "nacre/bsdf/tilted_coat.h"
#include "nacre/montecarlo/depth_walk.h"
#include "nacre/solver/solver.h"
#include "nacre/testing/directions.h"
#include "nacre/testing/paints.h"
#include "nacre/testing/statistics.h"

// A rough interface that is tilted, against random walks through one.

namespace nacre::models {
namespace {

using montecarlo::AirInterface;
using montecarlo::RandomStream;
using test::direction;
using test::kOnGrid;

/// An interface turned about the layers, which stay as they are.
class TurnedInterface final : public AirInterface {
 public:
    TurnedInterface(std::unique_ptr<const AirInterface> interface, Vec3d normal)
        : interface_(std::move(interface)), n_(normal) {
        s_ = normalize(Vec3d{1, 0, 0} - n_.x * n_);
        t_ = cross(n_, s_);
    }

    Weighted enter(const Vec3d& towards_light, RandomStream& random) const override {
        return downwards(interface_->enter(local(towards_light), random));
    }
    Weighted reflect_inside(const Vec3d& travel, RandomStream& random) const override {
        // Almost along the layers, light may arrive at the interface from its other side.
        Vec3d arriving = local(travel);
        arriving.z = std::max(arriving.z, 1e-6);
        return downwards(interface_->reflect_inside(normalize(arriving), random));
    }
    Passage sample_from_outside(const Vec3d&, RandomStream&) const override { return {}; }
    Passage sample_from_inside(const Vec3d&, RandomStream&) const override { return {}; }
    Weighted connect(const Vec3d& towards_detector, RandomStream& random) const override {
        Weighted inside = interface_->connect(local(towards_detector), random);
        inside.travel = world(inside.travel);
        if (inside.travel.z <= 0) return {{0, 0, 1}, 0};
        return inside;
    }
    bool scatters() const override { return interface_->scatters(); }
    double reflect_outside(const Vec3d&, const Vec3d&, RandomStream&) const override { return 0; }

 private:
    Vec3d local(Vec3d w) const { return {dot(w, s_), dot(w, t_), dot(w, n_)}; }
    Vec3d world(Vec3d w) const { return w.x * s_ + w.y * t_ + w.z * n_; }
    Weighted downwards(Weighted inside) const {
        inside.travel = world(inside.travel);
        inside.travel.z = -std::abs(inside.travel.z);
        return inside;
    }

    std::unique_ptr<const AirInterface> interface_;
    Vec3d n_, s_, t_;
};

struct Pair {
    double theta_i, phi_i, theta_o, phi_o;
};
constexpr Pair kPairs[] = {{0, 0, 20, 0},    {10, 0, 25, 180}, {30, 0, 30, 180},
                           {45, 0, 30, 180}, {45, 60, 10, 90}, {60, 0, 45, 170}};

/// Of light that was in the layers, with the standard error of its mean.
test::Moments walked(const paint::Recipe& recipe, double roughness, Vec2f slope, const Pair& pair,
                     int walks) {
    constexpr double kWavelengths[] = {550.0};
    const montecarlo::Medium medium(recipe, kWavelengths);
    const Vec3d m = normalize(Vec3d{-slope.x, -slope.y, 1});
    const TurnedInterface interface(montecarlo::make_rough_interface(medium.index, roughness), m);
    const Vec3d eye = to_double(direction(pair.theta_i, pair.phi_i));
    const Vec3d light = to_double(direction(pair.theta_o, pair.phi_o));
    // A plane wave of unit irradiance on the mean surface falls on the tilted one, and spreads over the
    // layers behind that prism.
    const double cosine = dot(light, m), n = medium.index;
    const double inside = std::sqrt(1 - (1 - cosine * cosine) / (n * n));
    const double inside_z = (light.z + (n * inside - cosine) * m.z) / n;
    const double power = cosine / light.z * inside_z / inside;
    RandomStream random(11, 0, 0);
    montecarlo::WalkTally tally;
    tally.radiance.resize(1);
    constexpr int kBatch = 1000;
    std::vector<double> means;
    for (int batch = 0; batch < walks / kBatch; ++batch) {
        double sum = 0;
        for (int i = 0; i < kBatch; ++i) {
            tally.clear();
            const montecarlo::Connection connection(interface.connect(eye, random), medium);
            montecarlo::walk(medium, interface, light, {&connection, 1}, nacre::Part::total, random,
                             tally);
            sum += tally.radiance[0][0];
        }
        means.push_back(power * sum / kBatch);
    }
    return test::Moments(means);
}

struct Tilt {
    double roughness;
    Vec2f slope;
};

// To 1 %, and the errors of the walks; without the tilt values are off by 5 to 20 %.
TEST(RoughOrangePeel, LayersAreSeenAsByWalksThroughATiltedRoughInterface) {
    paint::Recipe recipe = test::metallic(0.2, 0.6);
    int compared = 0, told_apart = 0;
    for (const Tilt& tilt : {Tilt{0.1, {0.04f, 0}}, Tilt{0.25, {-0.03f, 0.05f}}}) {
        recipe.clearcoat = paint::Clearcoat{0, 0.0, tilt.roughness};
        const auto solved = std::make_shared<const solver::SolvedPaint>(
            solver::solve(recipe, spectra::default_wavelengths_nm()));
        const auto bound = bsdf::Microflake(solved).bind(kOnGrid);
        const bsdf::InterfaceLobe& lobe = *bound->interface_lobe();
        for (const Pair& pair : kPairs) {
            const Vec3f wi = direction(pair.theta_i, pair.phi_i);
            const Vec3f wo = direction(pair.theta_o, pair.phi_o);
            const bsdf::TiltedCoat coat(*bound, tilt.slope, wi);
            const Frame frame = Frame::around(coat.normal());
            const Vec3f out = frame.to_local(wo);
            const double seen =
                coat.eval(wi, wo)[0] - lobe.eval(frame.to_local(wi), out)[0] * out.z / wo.z;
            const double flat = bound->eval(wi, wo)[0] - lobe.eval(wi, wo)[0];
            const test::Moments walks = walked(recipe, tilt.roughness, tilt.slope, pair, 10'000);
            ASSERT_LT(walks.mean_error, 0.015 * walks.mean);
            const double bound_of_walks = 0.01 * walks.mean + test::kWorstZ * walks.mean_error;
            EXPECT_NEAR(seen, walks.mean, bound_of_walks)
                << tilt.roughness << " " << pair.theta_i << " " << pair.theta_o;
            told_apart += std::abs(flat - walks.mean) > bound_of_walks;
            ++compared;
        }
    }
    EXPECT_EQ(compared, 12);
    EXPECT_GE(told_apart, 4);
}

}  // namespace
}  // namespace nacre::models
