#include "nacre/measure/instrument.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>
#include <numbers>
#include <thread>
#include <utility>

#include "nacre/core/error.h"
#include "nacre/core/math.h"
#include "nacre/core/parallel.h"
#include "nacre/testing/layers.h"

namespace nacre::measure {
namespace {

const std::vector<double> kTwo = {500, 600};

struct Vector {
    double x, y, z;
};
Vector unit_vector(double theta, double phi) {
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}
double dot(const Vector& a, const Vector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

Conditions with_aperture(double lamp_deg, double detector_deg) {
    Conditions conditions;
    conditions.aperture = {lamp_deg, detector_deg};
    return conditions;
}

std::vector<Geometry> every_geometry() {
    std::vector<Geometry> all;
    for (const GeometrySet& set : geometry_sets()) {
        all.insert(all.end(), set.geometries.begin(), set.geometries.end());
    }
    return all;
}

double read(const Brdf& brdf, const Geometry& geometry, const Conditions& conditions) {
    return measure("", brdf, kTwo, std::vector{geometry}, conditions)
        .readings[0]
        .reflectance_factor[0];
}

TEST(Instrument, ThePerfectDiffuserReadsWhiteEverywhere) {
    const Brdf white = [](double, double, double) {
        return std::vector<double>(2, 1 / std::numbers::pi);
    };
    for (const Conditions& conditions :
         {Conditions{}, with_aperture(3, 0), with_aperture(0, 5), with_aperture(10, 10)}) {
        const Measurement m = measure("white", white, kTwo, every_geometry(), conditions);
        ASSERT_EQ(m.readings.size(), every_geometry().size());
        for (const Reading& reading : m.readings) {
            for (double r : reading.reflectance_factor) EXPECT_NEAR(r, 1, 1e-13);
            EXPECT_NEAR(reading.xyz[1], 100, 1e-11);
            EXPECT_NEAR(reading.lab[0], 100, 1e-11);
        }
        EXPECT_EQ(m.conditions, conditions);
        EXPECT_EQ(m.name, "white");
    }
}

TEST(Instrument, APointReadsPiTimesTheBrdfAtTheGeometry) {
    const Brdf probe = [](double theta_i, double theta_o, double phi) {
        return std::vector<double>{theta_i / kDegree + 1000 * theta_o / kDegree, phi / kDegree};
    };
    const Measurement m =
        measure("", probe, kTwo, std::vector{in_plane(45, 15), towards(15, 45, 90)}, {});
    EXPECT_NEAR(m.readings[0].reflectance_factor[0], std::numbers::pi * 30045, 1e-8);
    EXPECT_NEAR(m.readings[0].reflectance_factor[1], std::numbers::pi * 180, 1e-11);
    EXPECT_NEAR(m.readings[1].reflectance_factor[0], std::numbers::pi * 45015, 1e-8);
    EXPECT_NEAR(m.readings[1].reflectance_factor[1], std::numbers::pi * 90, 1e-11);
}

// The projected solid angle of a cone of half angle a about theta is pi sin^2 a cos theta, so that
// the mean of 1 / cos theta over it is 2 / (cos theta (1 + cos a)).
TEST(Instrument, AveragesOverProjectedSolidAngle) {
    const Brdf inverse = [](double theta_i, double theta_o, double) {
        return std::vector<double>(2,
                                   1 / (std::numbers::pi * std::cos(theta_i) * std::cos(theta_o)));
    };
    const double a = 4 * kDegree, b = 7 * kDegree;
    const double expected = 2 / (std::cos(45 * kDegree) * (1 + std::cos(a))) * 2 /
                            (std::cos(30 * kDegree) * (1 + std::cos(b)));
    EXPECT_NEAR(read(inverse, in_plane(45, 15), with_aperture(4, 7)), expected,
                kApertureTolerance * expected);
}

// A lobe e^(k (cos - 1)) about the middle of the detector's cone, over cos theta: its mean is
// 2 (1 - e^(-k (1 - cos b))) / (k sin^2 b cos theta).
TEST(Instrument, AveragesALobeOverTheCone) {
    for (double width_deg : {20.0, 5.0, 2.0}) {
        const double k = 1 / std::pow(width_deg * kDegree, 2), b = 5 * kDegree;
        const Vector axis = unit_vector(30 * kDegree, std::numbers::pi);
        const Brdf lobe = [&](double, double theta, double phi) {
            return std::vector<double>(2, std::exp(k * (dot(unit_vector(theta, phi), axis) - 1)) /
                                              (std::numbers::pi * std::cos(theta)));
        };
        const double expected = 2 * -std::expm1(-k * (1 - std::cos(b))) /
                                (k * std::pow(std::sin(b), 2) * std::cos(30 * kDegree));
        EXPECT_NEAR(read(lobe, in_plane(45, 15), with_aperture(0, 5)), expected,
                    kApertureTolerance * expected)
            << width_deg;
    }
}

// Both cones at once, against a plain midpoint sum: a lobe about the mirror direction of the lamp.
TEST(Instrument, ConvolvesALobeWithBothCones) {
    const double k = 1 / std::pow(6 * kDegree, 2), a = 3 * kDegree, b = 5 * kDegree;
    const Brdf lobe = [&](double theta_i, double theta_o, double phi) {
        const double cosine =
            dot(unit_vector(theta_o, phi), unit_vector(theta_i, std::numbers::pi));
        return std::vector<double>(2, std::exp(k * (cosine - 1)) / std::numbers::pi);
    };
    // Midpoint rule in solid angle and azimuth; its error falls as 1/n^2: 4e-4 / 4 at n = 24.
    constexpr int kRings = 16, kSteps = 24;
    double sum = 0, weights = 0;
    const auto node = [&](double theta, double half, int ring, int step) {
        const double fall = (1 - std::cos(half)) * (ring + 0.5) / kRings;
        const double turn = 2 * std::numbers::pi * step / kSteps,
                     across = std::sqrt(fall * (2 - fall));
        const double x = (1 - fall) * std::sin(theta) + across * std::cos(turn) * std::cos(theta),
                     z = (1 - fall) * std::cos(theta) - across * std::cos(turn) * std::sin(theta);
        return Vector{x, across * std::sin(turn), z};
    };
    for (int i = 0; i < kRings * kSteps; ++i) {
        const Vector in = node(45 * kDegree, a, i / kSteps, i % kSteps);
        for (int j = 0; j < kRings * kSteps; ++j) {
            Vector out = node(35 * kDegree, b, j / kSteps, j % kSteps);
            out = {-out.x, out.y, out.z};  // on the mirror side
            const Vector specular{-in.x, -in.y, in.z};
            sum += in.z * out.z * std::exp(k * (dot(out, specular) - 1));
            weights += in.z * out.z;
        }
    }
    EXPECT_NEAR(read(lobe, in_plane(45, 10), with_aperture(3, 5)), sum / weights,
                2e-4 * sum / weights);
}

TEST(Instrument, RulesOverConesConvergeAndSumToOne) {
    const Vector far = unit_vector(50 * kDegree, 2.0);
    double last = 0, previous = 0;
    for (int rings : {1, 2, 3, 4}) {
        double mean = 0, weights = 0;
        for (const ConeNode& node : cone_rule(40 * kDegree, 1.0, 10 * kDegree, rings)) {
            EXPECT_GT(node.weight, 0);
            weights += node.weight;
            mean += node.weight * std::exp(8 * dot(unit_vector(node.theta, node.phi), far));
        }
        EXPECT_NEAR(weights, 1, 1e-14);
        // Each rule is far better than the one before it.
        if (rings > 2) {
            EXPECT_LT(std::abs(mean - last), 1e-3 * std::abs(last - previous));
        }
        previous = last;
        last = mean;
    }
    EXPECT_EQ(cone_rule(0.3, 1.0, 0, 4).size(), 1u);
}

TEST(Instrument, RaysBelowTheHorizonCarryNothing) {
    const Brdf white = [](double theta_i, double theta_o, double) {
        EXPECT_LT(theta_i, std::numbers::pi / 2);
        EXPECT_LT(theta_o, std::numbers::pi / 2);
        return std::vector<double>(2, 1 / std::numbers::pi);
    };
    EXPECT_NEAR(read(white, in_plane(85, 170), with_aperture(10, 10)), 1, 1e-13);
}

/// A metallic under a clearcoat, at two wavelengths that differ in reflectance.
Brdf metallic() {
    const auto paint = std::make_shared<const solver::SolvedPaint>(solver::solve(
        solver::test::flake_paint(0.2, spectra::Spectrum({500, 600}, {0.3, 0.7}), 0.0, 1.5, 1.5),
        kTwo));
    return [paint](double theta_i, double theta_o, double phi) {
        return paint->brdf(theta_i, theta_o, phi);
    };
}

// Lamp and detector change places: 45as15 and 30as-15 are the same pair of directions. The solver's
// tables are reciprocal to 1e-6 of the peak.
TEST(Instrument, IsReciprocal) {
    const Brdf brdf = metallic();
    const Geometry there = in_plane(45, 15), back = in_plane(30, -15);
    const double point = read(brdf, there, {});
    EXPECT_GT(point, 0.1);
    EXPECT_NEAR(point, read(brdf, back, {}), 1e-5 * point);
    for (const auto& [lamp, detector] : {std::pair{2.0, 2.0}, std::pair{1.0, 3.0}}) {
        const double wide = read(brdf, there, with_aperture(lamp, detector));
        EXPECT_NEAR(wide, read(brdf, back, with_aperture(detector, lamp)),
                    2 * kApertureTolerance * wide);
    }
}

TEST(Instrument, BothSidesOfThePlaneReadAlike) {
    const Brdf brdf = metallic();
    for (const Conditions& conditions : {Conditions{}, with_aperture(3, 3)}) {
        const double left = read(brdf, off_plane(45, 25, 90), conditions);
        EXPECT_NEAR(left, read(brdf, off_plane(45, 25, -90), conditions), 1e-9 * left);
    }
}

TEST(Instrument, SmallConesApproachThePoint) {
    const Brdf brdf = metallic();
    const double point = read(brdf, in_plane(45, 25), {});
    const auto off = [&](double cone_deg) {
        return read(brdf, in_plane(45, 25), with_aperture(cone_deg, cone_deg)) - point;
    };
    // The mean differs by the curvature of the lobe times the square of the angle: a cone twice as
    // wide by four times as much, but for a term of the fourth power, a quarter of it with each
    // halving. The sixth power is 0.3 % of that here.
    const double first = off(4) / off(2) - 4, second = off(2) / off(1) - 4;
    EXPECT_NEAR(second, 0, 0.01);
    EXPECT_NEAR(first / second, 4, 0.04);
    EXPECT_LT(std::abs(off(1e-6)), 1e-9 * point);
}

TEST(Instrument, GivesTheSameBitsOnAnyNumberOfThreads) {
    const Brdf brdf = metallic();
    const auto all = [&] {
        return measure("", brdf, kTwo, find_geometry_set("ma98")->geometries, with_aperture(2, 3));
    };
    const Measurement many = all();
    const ThreadLimit one(1);
    EXPECT_EQ(many, all());
}

TEST(Instrument, RefusesAperturesOutOfRangeAndViewsBelowTheHorizon) {
    const Brdf white = [](double, double, double) {
        return std::vector<double>(2, 1 / std::numbers::pi);
    };
    EXPECT_THROW(read(white, in_plane(45, 15), with_aperture(-1, 0)), DomainError);
    EXPECT_THROW(read(white, in_plane(45, 15), with_aperture(0, 10.1)), DomainError);
    EXPECT_THROW(read(white, in_plane(45, 15), with_aperture(NAN, 0)), DomainError);
    EXPECT_THROW(read(white, Geometry{"below", 45, 140, 95, 0}, {}), DomainError);
    EXPECT_THROW(measure("", white, {500, 600, 700}, std::vector{in_plane(45, 15)}, {}),
                 DomainError);  // values at two wavelengths only
}

TEST(Instrument, RefusesLobesThatItCannotIntegrate) {
    // A lobe narrower than the spacing of the nodes of the largest rule.
    const Vector axis = unit_vector(31.234 * kDegree, std::numbers::pi);
    const Brdf needle = [&](double, double theta, double phi) {
        return std::vector<double>(2, std::exp(3e4 * (dot(unit_vector(theta, phi), axis) - 1)));
    };
    EXPECT_THROW(read(needle, in_plane(45, 15), with_aperture(0, 10)), Error);
}

TEST(Instrument, StopsWhenAskedTo) {
    const Brdf white = [](double, double, double) {
        return std::vector<double>(2, 1 / std::numbers::pi);
    };
    int asked = 0;
    const auto geometries = every_geometry();
    EXPECT_THROW(measure("", white, kTwo, geometries, {},
                         [&](double fraction) {
                             EXPECT_GE(fraction, 0);
                             EXPECT_LE(fraction, 1);
                             return ++asked < 3;
                         }),
                 Error);
    EXPECT_EQ(asked, 3);
}

TEST(Instrument, StopsWithinAReading) {
    std::atomic<int> asked = 0, values = 0;
    const Brdf slow = [&](double, double, double) {
        ++values;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        return std::vector<double>(2, 1 / std::numbers::pi);
    };
    EXPECT_THROW(measure("", slow, kTwo, std::vector{in_plane(45, 15)}, with_aperture(5, 5),
                         [&](double fraction) {
                             EXPECT_EQ(fraction, 0);
                             return ++asked < 2;
                         }),
                 Stopped);
    EXPECT_EQ(asked, 2);
    EXPECT_GT(values, 0);
}

}  // namespace
}  // namespace nacre::measure
