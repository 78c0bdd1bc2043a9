#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "nacre/core/math.h"
#include "nacre/core/quadrature.h"
#include "nacre/sparkle/diffraction_lobe.h"
#include "nacre/testing/statistics.h"

// The contrast of flakes that diffract, by the model's lobe and by the Airy pattern.
//
// Flakes of slope density P, each with the pattern K_A, under a lamp that fills the disc L of slopes
// about t_h: by Campbell's theorem the square of the contrast goes with
//
//     Int P(t) (K_A * L)(t)^2 dt / (Int_L P * K_A)^2.
//
// Lengths in the plane of slopes are measured in lambda'/d of |q|, in which the pattern is
// K_A(u) = pi/4 (2 J_1(pi u) / (pi u))^2 and its transform 2/pi (acos s - s sqrt(1 - s^2)).
// [born-wolf-1999, sections 8.5.2 and 9.5]

namespace nacre::sparkle {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kIndex = 1.5, kGreen_um = 0.55;
constexpr double kE = DiffractionLobe::kLobePower, kW = DiffractionLobe::kLobeRadius;

// The radius of a lamp of this diameter outside the coat: the half vector inside turns by half of
// what the light does, which is refracted. The index cancels.
double lamp_radius(double lamp_deg, double diameter_um) {
    return std::sin(lamp_deg / 2 * kDegree) * diameter_um / kGreen_um;
}
double in_patterns(double slope, double diameter_um) {
    return slope * 2 * diameter_um * kIndex / kGreen_um;
}

double besinc(double x) { return x < 1e-6 ? 1 : 2 * std::cyl_bessel_j(1.0, x) / x; }
double airy_transform(double s) {
    return s < 1 ? 2 / kPi * (std::acos(s) - s * std::sqrt(1 - s * s)) : 0;
}
double lamp_transform(double radius, double s) { return besinc(2 * kPi * radius * s); }
// Of 3/(pi r^2) (1 - u^2/r^2)^2, r = kW.
double lobe_transform(double s) {
    const double x = 2 * kPi * kW * s;
    return x < 1e-2 ? 1 - x * x / 16 : 48 * std::cyl_bessel_j(3.0, x) / (x * x * x);
}

template <class F>
double integrate(double end, int nodes, F&& f) {
    const Quadrature rule = gauss_legendre(nodes, 0.0, end);
    double sum = 0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) sum += rule.weights[i] * f(rule.nodes[i]);
    return sum;
}

// P wide against all else: Parseval's theorem for Int (K_A * L)^2.
TEST(DiffractionLobe, HasTheContrastOfTheAiryPatternUnderWideLamps) {
    double worst = 0, worst_without = 0;
    for (const double diameter_um : {5, 7, 10, 14, 20, 28, 40, 57, 80, 100}) {
        for (const double lamp_deg : {0.0, 0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0}) {
            const double radius = lamp_radius(lamp_deg, diameter_um);
            const auto contrast2 = [&](double end, int nodes, auto&& transform) {
                return integrate(end, nodes, [&](double s) {
                    return 2 * kPi * s * std::pow(transform(s) * lamp_transform(radius, s), 2);
                });
            };
            const double airy = contrast2(1, 200, airy_transform);
            const double lobe = contrast2(8, 800, lobe_transform);
            worst = test::worse(worst, std::abs(kE * std::sqrt(lobe / airy) - 1));
            // A lobe that holds all of the light.
            const double all = contrast2(8, 800, [](double s) { return lobe_transform(s / kE); });
            worst_without = test::worse(worst_without, std::abs(std::sqrt(all / airy) - 1));
        }
    }
    EXPECT_LT(worst, DiffractionLobe::kContrastError);
    EXPECT_GT(worst_without, 0.1);
}

// Under a rough coat that spreads the pattern by P_s(u) = exp(-u^2/a^2) / (pi a^2), the lamp a point.
TEST(DiffractionLobe, HasTheContrastOfTheAiryPatternThatACoatSpreads) {
    double worst = 0;
    for (const double a : {0.05, 0.1, 0.2, 0.4, 0.6, 0.8, 1.2, 2.0, 3.0, 5.0, 10.0, 30.0}) {
        const double spread = integrate(std::min(1.0, 3 / a), 400, [&](double s) {
            return 2 * kPi * s *
                   std::pow(airy_transform(s) * std::exp(-std::pow(kPi * s * a, 2)), 2);
        });
        const double radius2 = kW * kW + DiffractionLobe::spread_radius2(static_cast<float>(a * a));
        const double e = DiffractionLobe::power_of(static_cast<float>(a * a / (kW * kW)));
        const double lobe = e * e * 9 / (5 * kPi * radius2);
        worst = test::worse(worst, std::abs(std::sqrt(lobe / spread) - 1));
    }
    EXPECT_LT(worst, DiffractionLobe::kSpreadError);
    EXPECT_GT(worst, 0.5 * DiffractionLobe::kSpreadError);
}

// P as narrow as it comes, the lamp a point: there is no transform in this.
struct Narrow {
    double alpha, h;  // in patterns

    double density(double t) const {  // the mean of P on a circle about h
        return std::exp(-(h - t) * (h - t) / (alpha * alpha)) *
               integrate(kPi, 64,
                         [&](double angle) {
                             return std::exp(-2 * h * t * (1 - std::cos(angle)) / (alpha * alpha)) /
                                    kPi;
                         }) /
               (kPi * alpha * alpha);
    }
    template <class Pattern>
    double mean(double end, int nodes, const Pattern& pattern) const {
        return integrate(end, nodes,
                         [&](double t) { return 2 * kPi * t * density(t) * pattern(t); });
    }
};
double airy(double u) { return kPi / 4 * std::pow(besinc(kPi * u), 2); }
double lobe(double u) {
    return u < kW ? 3 / (kPi * kW * kW) * std::pow(1 - u * u / (kW * kW), 2) : 0;
}

TEST(DiffractionLobe, HasTheContrastOfTheAiryPatternWhereSlopesAreFew) {
    for (const double alpha : {0.05, 0.1, 0.2, 0.3}) {
        for (const double diameter_um : {5.0, 10.0, 20.0}) {
            for (const double x : {0.0, 1.0, 1.6, 2.4}) {
                const double a = in_patterns(alpha, diameter_um);
                const Narrow slopes{a, x * a};
                const double reach = (x + 5) * a;
                const double lit = slopes.mean(reach, 600, airy), own = slopes.mean(kW, 64, lobe);
                const double fraction = std::min(1.0, kE * own / lit);
                const auto found = static_cast<double>(DiffractionLobe::lobe_fraction(
                    static_cast<float>(x * x), static_cast<float>(kW / a)));
                EXPECT_NEAR(found, fraction, DiffractionLobe::kLobeFractionError)
                    << alpha << ' ' << diameter_um << ' ' << x;
                const double truth = slopes.mean(reach, 600, [](double u) {
                    return airy(u) * airy(u);
                }) / (lit * lit);
                const double model = fraction * fraction * slopes.mean(kW, 64, [](double u) {
                    return lobe(u) * lobe(u);
                }) / (own * own);
                // A lobe as wide as P holds more than the light that there is: up to 6 %.
                const bool wide = kW > 0.8 * a;
                EXPECT_NEAR(std::sqrt(model / truth), 1, wide ? 0.06 : 0.02)
                    << alpha << ' ' << diameter_um << ' ' << x;
            }
        }
    }
}

// Both at once, over the plane of slopes.
TEST(DiffractionLobe, HasTheContrastOfTheAiryPatternWhereSlopesAreFewAndLampsWide) {
    double worst = 0;
    for (const double alpha : {0.05, 0.1, 0.2}) {
        for (const double diameter_um : {5.0, 10.0, 20.0}) {
            for (const double lamp_deg : {2.0, 8.0}) {
                for (const double x : {0.0, 1.0, 1.6}) {
                    const double a = in_patterns(alpha, diameter_um), h = x * a;
                    const double radius = lamp_radius(lamp_deg, diameter_um);
                    // Truth: K_A * L from its transform.
                    const auto density = [&](double px, double py) {
                        return std::exp(-(px * px + py * py) / (a * a)) / (kPi * a * a);
                    };
                    const Narrow slopes{a, h};
                    const double truth_response =
                        slopes.mean(std::min((x + 4) * a, radius + 12), 200, [&](double t) {
                            return std::pow(integrate(1, 80,
                                                      [&](double s) {
                                                          return 2 * kPi * s * airy_transform(s) *
                                                                 lamp_transform(radius, s) *
                                                                 std::cyl_bessel_j(0.0,
                                                                                   2 * kPi * s * t);
                                                      }),
                                            2);
                        });
                    const double truth_mean = integrate(1, 80, [&](double s) {
                        return 2 * kPi * s * airy_transform(s) * lamp_transform(radius, s) *
                               std::exp(-std::pow(kPi * s * a, 2)) *
                               std::cyl_bessel_j(0.0, 2 * kPi * s * h);
                    });
                    // The model: points of the lamp, and flakes about it.
                    struct Point {
                        double x, y, weight, gain;
                    };
                    std::vector<Point> lamp;
                    const Quadrature rule = gauss_legendre(10, 0.0, 1.0);
                    constexpr int kAngles = 24;
                    const DiffractionLobe slope_lobe(alpha, kIndex);
                    double mean = 0;
                    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
                        for (int k = 0; k < kAngles; ++k) {
                            const double r = radius * rule.nodes[i];
                            const double angle = 2 * kPi * (k + 0.5) / kAngles;
                            Point p{h + r * std::cos(angle), r * std::sin(angle),
                                    2 * rule.nodes[i] * rule.weights[i] / kAngles, 0};
                            mean += p.weight * density(p.x, p.y);
                            const auto square =
                                static_cast<float>((p.x * p.x + p.y * p.y) / (a * a));
                            const auto width = static_cast<float>(kW / a);
                            p.gain = p.weight * DiffractionLobe::lobe_fraction(square, width) /
                                     slope_lobe.blur(square * static_cast<float>(alpha * alpha),
                                                     width * static_cast<float>(alpha));
                            lamp.push_back(p);
                        }
                    }
                    constexpr int kSide = 36;
                    const double reach = radius + kW;
                    double response = 0;
                    for (int i = 0; i < kSide * kSide; ++i) {
                        const double qx = h + reach * (2 * (i % kSide + 0.5) / kSide - 1);
                        const double qy = reach * (2 * (i / kSide + 0.5) / kSide - 1);
                        double sum = 0;
                        for (const Point& p : lamp) {
                            const double d2 = (p.x - qx) * (p.x - qx) + (p.y - qy) * (p.y - qy);
                            if (d2 >= kW * kW) continue;
                            const double fall = 1 - d2 / (kW * kW);
                            sum += p.gain * 3 / (kPi * kW * kW) * fall * fall;
                        }
                        response +=
                            sum * sum * density(qx, qy) * 4 * reach * reach / (kSide * kSide);
                    }
                    const double ratio = std::sqrt(response / truth_response) * truth_mean / mean;
                    const bool wide = kW > 0.8 * a;
                    EXPECT_NEAR(ratio, 1, wide ? 0.06 : DiffractionLobe::kContrastError)
                        << alpha << ' ' << diameter_um << " um, " << lamp_deg << " deg, " << x;
                    worst = test::worse(worst, std::abs(ratio - 1));
                }
            }
        }
    }
    EXPECT_GT(worst, 0.03);  // or the quadrature is blind
}

}  // namespace
}  // namespace nacre::sparkle
