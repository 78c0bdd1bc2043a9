#include "nacre/optics/fresnel.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <string>

#include "nacre/core/error.h"
#include "nacre/testing/errors.h"

namespace nacre::optics {
namespace {

using nacre::test::message_of;
using Complex = std::complex<double>;

TEST(Fresnel, MatchesFiftyDigitArithmetic) {
    // mpmath 1.3.0, mp.dps = 50: the same equations in their textbook form, arguments being the
    // doubles below.
    struct Case {
        Complex n_i, n_t;
        double cos_i;
        FresnelAmplitudes expected;
    };
    // clang-format off
    const Case cases[] = {
        {{1.934, 0.223}, {2.839, 4.439}, 0.048, {{-0.97958680195831087, -0.02780448341671786}, {-0.82666129509326435, 0.15719712194726404}, {0.020413198041689135, -0.02780448341671786}, {0.085480872278752903, -0.012953796056771203}}},
        {{2.164, 0.0}, {2.723, 0.0}, 0.871, {{-0.14163910664533974, 0.0}, {0.086957826485449737, 0.0}, {0.85836089335466026, 0.0}, {0.863818118440879, 0.0}}},
        {{1.816, 0.0}, {2.247, 0.0}, 0.918, {{-0.12155573947491434, 0.0}, {0.090551197954900622, 0.0}, {0.87844426052508566, 0.0}, {0.88137115063911869, 0.0}}},
        {{1.239, 0.0}, {1.93, 0.0}, 0.001, {{-0.99832683977297633, 0.0}, {-0.99594499322264416, 0.0}, {0.0016731602270236698, 0.0}, {0.0026031882886755871, 0.0}}},
        {{1.314, 0.0}, {2.643, 0.0}, 1.0, {{-0.335860500379075, 0.0}, {0.335860500379075, 0.0}, {0.664139499620925, 0.0}, {0.664139499620925, 0.0}}},
        {{1.939, 0.055}, {0.751, 0.0}, 0.313, {{-0.77237726101705144, -0.64083537521388844}, {-1.0008941713123576, -0.10837570703449977}, {0.22762273898294856, -0.64083537521388844}, {0.0056283165276114055, -0.27987972751274931}}},
        {{1.622, 0.0}, {0.382, 1.808}, 1.0, {{-0.10760698872184576, -0.80511305608328484}, {0.10760698872184576, 0.80511305608328484}, {0.89239301127815424, -0.80511305608328484}, {0.89239301127815424, -0.80511305608328484}}},
        {{2.017, 0.0}, {1.195, 1.836}, 0.329, {{-0.76545562943656884, -0.3843252417938561}, {-0.60248123298201125, 0.26438232584245584}, {0.23454437056343116, -0.3843252417938561}, {0.4036760031208382, -0.17396651925156949}}},
    };
    // clang-format on
    for (const auto& c : cases) {
        const auto f = fresnel(c.n_i, c.n_t, c.cos_i);
        const std::pair<Complex, Complex> pairs[] = {{f.r_s, c.expected.r_s},
                                                     {f.r_p, c.expected.r_p},
                                                     {f.t_s, c.expected.t_s},
                                                     {f.t_p, c.expected.t_p}};
        for (const auto& [found, expected] : pairs) {
            EXPECT_LE(std::abs(found - expected), kFresnelError * std::max(1.0, std::abs(expected)))
                << c.n_i << " to " << c.n_t << " at cos " << c.cos_i;
        }
    }
}

TEST(Fresnel, EnergyIsConservedWithoutAbsorption) {
    for (double n_t : {1.01, 1.5, 2.4, 0.8}) {
        for (double cos_i : {0.7, 0.9, 1.0}) {
            const auto f = fresnel(1.0, n_t, cos_i);
            const double q = normal_wavevector(1.0, n_t, cos_i).real();
            EXPECT_NEAR(std::norm(f.r_s) + q / cos_i * std::norm(f.t_s), 1, 1e-14);
            EXPECT_NEAR(std::norm(f.r_p) + q / cos_i * std::norm(f.t_p), 1, 1e-14);
        }
    }
}

TEST(Fresnel, StokesRelationsHoldBothWays) {
    const Complex n_1 = 1.5, n_2(2.2, 0.3);
    const double cos_1 = 0.6;
    // Back from medium 2 the cosine is complex; normal incidence has real cosines both ways.
    const auto down = fresnel(n_1, n_2, 1.0), up = fresnel(n_2, n_1, 1.0);
    EXPECT_LT(std::abs(down.r_s + up.r_s), 1e-15);
    EXPECT_LT(std::abs(down.t_s * up.t_s - down.r_s * up.r_s - 1.0), 1e-15);
    const double cos_2 = normal_wavevector(1.5, 2.2, cos_1).real() / 2.2;
    const auto there = fresnel(1.5, 2.2, cos_1), back = fresnel(2.2, 1.5, cos_2);
    EXPECT_LT(std::abs(there.r_p + back.r_p), 1e-15);
    EXPECT_LT(std::abs(there.t_p * back.t_p - there.r_p * back.r_p - 1.0), 1e-15);
}

TEST(Fresnel, ParallelReflectionVanishesAtBrewstersAngle) {
    for (double n_t : {1.3, 1.5, 2.5}) {
        EXPECT_LT(std::abs(fresnel(1.0, n_t, std::cos(std::atan(n_t))).r_p), 1e-15);
    }
}

TEST(Fresnel, TotalReflectionBeyondTheCriticalAngle) {
    const double cos_critical = std::sqrt(1 - 1 / (1.5 * 1.5));
    for (double fraction : {0.001, 0.5, 0.999}) {
        const auto f = fresnel(1.5, 1.0, fraction * cos_critical);
        EXPECT_NEAR(std::abs(f.r_s), 1, 1e-15);
        EXPECT_NEAR(std::abs(f.r_p), 1, 1e-15);
        EXPECT_NE(f.r_s.imag(), 0);  // with a phase
    }
    EXPECT_LT(std::abs(fresnel(1.5, 1.0, 1.001 * cos_critical).r_s), 0.97);
}

TEST(Fresnel, ConductorWithZeroExtinctionIsADielectric) {
    const auto limit = fresnel(1.5, Complex(2.0, 1e-15), 0.3), dielectric = fresnel(1.5, 2.0, 0.3);
    EXPECT_LT(std::abs(limit.r_s - dielectric.r_s), 1e-14);
    EXPECT_LT(std::abs(limit.r_p - dielectric.r_p), 1e-14);
}

TEST(Fresnel, EqualMediaDoNotReflectEvenAtGrazingIncidence) {
    const auto f = fresnel(1.5, 1.5, 1e-12);
    EXPECT_LT(std::abs(f.r_s), 1e-15);
    EXPECT_LT(std::abs(f.r_p), 1e-15);
}

TEST(Fresnel, RefusesGainAndCosinesOutOfRange) {
    const auto message = [](Complex n_i, Complex n_t, double cos_i) -> std::string {
        return message_of<DomainError>([&] { fresnel(n_i, n_t, cos_i); });
    };
    using ::testing::HasSubstr;
    EXPECT_THAT(message(1.0, {1.5, -0.1}, 0.5), HasSubstr("n_t = 1.5-0.1i"));
    EXPECT_THAT(message(0.0, 1.5, 0.5), HasSubstr("n_i = 0"));
    EXPECT_THAT(message(1.0, 1.5, 0.0), HasSubstr("cos_i = 0 is outside (0, 1]"));
    EXPECT_THAT(message(1.0, 1.5, 1.5), HasSubstr("cos_i = 1.5"));
    EXPECT_THAT(message(1.0, 1.5, std::nan("")), HasSubstr("cos_i = nan"));
}

TEST(DielectricInterface, ReflectanceIsThatOfTheComplexAmplitudes) {
    int total = 0;
    for (double n_i : {1.0, 1.5}) {
        for (double n_t : {1.0, 1.33, 1.5, 2.5}) {
            for (int i = 1; i <= 100; ++i) {
                const double cos_i = i / 100.0;
                const auto f = fresnel(n_i, n_t, cos_i);
                const double expected = (std::norm(f.r_s) + std::norm(f.r_p)) / 2;
                EXPECT_NEAR(dielectric_reflectance(n_i, n_t, cos_i), expected, 1e-14)
                    << n_i << " " << n_t << " " << cos_i;
                total += expected > 1 - 1e-12;
            }
        }
    }
    EXPECT_GT(total, 50) << "the sweep must reach total reflection";
}

TEST(DielectricInterface, SnellsLawHolds) {
    for (double cos_i : {0.76, 0.8, 0.95, 1.0}) {
        const double cos_t = refracted_cos(1.5, 1.0, cos_i);
        EXPECT_NEAR(1.5 * std::sqrt(1 - cos_i * cos_i), std::sqrt(1 - cos_t * cos_t), 1e-14);
    }
    EXPECT_EQ(refracted_cos(1.5, 1.0, 0.5), 0);
}

TEST(DielectricInterface, GrazingLightIsReflectedUnlessThereIsNoInterface) {
    EXPECT_EQ(dielectric_reflectance(1.0, 1.5, 0.0), 1);
    EXPECT_EQ(dielectric_reflectance(1.5, 1.0, 0.0), 1);
    EXPECT_EQ(dielectric_reflectance(1.5, 1.5, 0.0), 0);
    EXPECT_EQ(dielectric_reflectance(1.5, 1.5, 1e-12), 0);
}

TEST(DielectricInterface, LanesAgreeWithScalars) {
    const auto cosines = make_lanes<DoubleLanes>([](int i) { return i / 7.0; });
    for (double n_t : {1.0, 1.5, 2.5}) {
        const DoubleLanes r = dielectric_reflectance(splat(1.5), splat(n_t), cosines);
        const DoubleLanes c = refracted_cos(splat(1.5), splat(n_t), cosines);
        const FloatLanes single =
            fresnel_dielectric(splat(static_cast<float>(n_t / 1.5)), to_float(cosines));
        for (int i = 0; i < kLanes; ++i) {
            // Lanes may fuse multiplications that scalars do not.
            EXPECT_NEAR(r[i], dielectric_reflectance(1.5, n_t, cosines[i]), 1e-15);
            EXPECT_NEAR(c[i], refracted_cos(1.5, n_t, cosines[i]), 1e-15);
            EXPECT_NEAR(single[i], r[i], 4e-6);  // float, near grazing incidence
        }
    }
}

}  // namespace
}  // namespace nacre::optics
