#include "nacre/optics/dielectric.h"

#include <gtest/gtest.h>

#include <complex>

#include "nacre/optics/fresnel.h"

namespace nacre::optics {
namespace {

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
        const FloatLanes single = fresnel_dielectric(splat(static_cast<float>(n_t / 1.5)),
                                                     __builtin_convertvector(cosines, FloatLanes));
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
