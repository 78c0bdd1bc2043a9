#include "nacre/exchange/gltf_material.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "nacre/spectra/colour.h"

namespace nacre::exchange {
namespace {

TEST(GltfMaterial, WithoutSpecularReflectionIsADiffuser) {
    GltfMaterial m;
    m.base_color = {0.2, 0.5, 0.8};
    m.metallic = m.specular = 0;
    const Vec3d f = gltf_brdf(m, 0.6, 1.1, 2);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(f[c], m.base_color[c] / std::numbers::pi, 1e-12);
}

TEST(GltfMaterial, IsReciprocalWithoutAClearcoat) {
    GltfMaterial m;
    m.base_color = {0.2, 0.5, 0.8};
    m.specular_color = {3, 1, 0.5};
    m.metallic = 0.4;
    m.roughness = 0.4;
    m.iridescence = 0.7;
    int compared = 0;
    for (const double a : {0.1, 0.8, 1.3}) {
        for (const double b : {0.3, 0.9, 1.4}) {
            const Vec3d f = gltf_brdf(m, a, b, 2.5), back = gltf_brdf(m, b, a, -2.5);
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(f[c], back[c], 1e-12 * f[c]);
            ++compared;
        }
    }
    EXPECT_EQ(compared, 9);
    m.clearcoat = 1;
    EXPECT_GT(std::abs(gltf_brdf(m, 0.1, 1.4, 2)[0] - gltf_brdf(m, 1.4, 0.1, 2)[0]), 1e-4);
}

/// Albedo of the first channel by a rule over the hemisphere of views.
double albedo(const GltfMaterial& m, double theta_i) {
    constexpr int kPolar = 400, kAround = 400;
    double sum = 0;
    for (int i = 0; i < kPolar; ++i) {
        const double theta = (i + 0.5) / kPolar * 0.5 * std::numbers::pi;
        for (int k = 0; k < kAround; ++k) {
            sum += gltf_brdf(m, theta_i, theta, (k + 0.5) / kAround * 2 * std::numbers::pi)[0] *
                   std::cos(theta) * std::sin(theta);
        }
    }
    return sum * 0.5 * std::numbers::pi / kPolar * 2 * std::numbers::pi / kAround;
}

// A white metal loses what is scattered between facets and no more. A white diffuser may gain 2 %:
// what is left to it follows the angle with one half vector, not the mean over them.
TEST(GltfMaterial, ConservesEnergy) {
    GltfMaterial m;
    m.roughness = 0.4;
    EXPECT_GT(albedo(m, 0), 0.95);
    EXPECT_LT(albedo(m, 0), 1);
    int compared = 0;
    for (const double metallic : {0.0, 0.5, 1.0}) {
        for (const double roughness : {0.35, 0.7, 1.0}) {
            for (const double coat : {0.0, 1.0}) {
                m = {};
                m.metallic = metallic;
                m.roughness = roughness;
                m.clearcoat = coat;
                m.clearcoat_roughness = coat * 0.4;
                for (const double theta : {0.1, 1.0}) {
                    EXPECT_LT(albedo(m, theta), metallic == 1 ? 1.001 : 1.02);
                    ++compared;
                }
            }
        }
    }
    EXPECT_EQ(compared, 36);
}

/// Colour of Airy's exact reflectance at normal incidence: the interference alone, as the format
/// has it, beside a mean that it takes for white.
Vec3d exact_film(double n1, double film_nm, double n2) {
    const double top = (1 - n1) / (1 + n1), bottom = (n1 - n2) / (n1 + n2);
    // The mean over the phase.
    const double mean = top * top + std::pow(1 - top * top, 2) * bottom * bottom /
                                        (1 - top * top * bottom * bottom);
    Vec3d xyz;
    double white = 0;
    for (double nm = 380; nm <= 780; nm += 1) {
        const std::complex<double> turn = std::polar(1.0, 4 * std::numbers::pi * n1 * film_nm / nm);
        const double r = std::norm((top + bottom * turn) / (1.0 + top * bottom * turn));
        const Vec3d seen = spectra::colour_matching(spectra::Observer::cie1931_2deg, nm);
        xyz += (r - mean) * seen;
        white += seen.y;
    }
    return spectra::xyz_to_linear_rec709(xyz / white) + Vec3d{mean, mean, mean};
}

// The format's Gaussians for the observer, and its two orders of interference, err by a few per
// cent of the reflectance.
TEST(GltfMaterial, IridescenceFollowsAirysFormulaAtNormalIncidence) {
    int compared = 0;
    for (const double nm : {100.0, 200.0, 300.0, 400.0, 600.0}) {
        for (const double base : {2.0, 2.5}) {
            const double r = (base - 1) / (base + 1);
            const Vec3d f = gltf_iridescence(1, 1.5, nm, {r * r, r * r, r * r});
            const Vec3d wanted = exact_film(1.5, nm, base);
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(f[c], std::max(0.0, wanted[c]), 0.012) << nm << " " << base;
            ++compared;
        }
    }
    EXPECT_EQ(compared, 10);
}

TEST(GltfMaterial, AFilmOfNoThicknessIsItsBase) {
    // Interference without a phase is that of the base in air. Two orders leave a remainder.
    const Vec3d f = gltf_iridescence(1, 1.4, 0, {0.2, 0.3, 0.4});
    EXPECT_NEAR(spectra::linear_rec709_to_xyz(f).y,
                spectra::linear_rec709_to_xyz({0.2, 0.3, 0.4}).y, 0.02);
}

}  // namespace
}  // namespace nacre::exchange
