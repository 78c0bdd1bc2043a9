#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "nacre/core/quadrature.h"
#include "nacre/optics/fresnel.h"
#include "nacre/solver/lane_matrix.h"
#include "nacre/solver/solver.h"
#include "nacre/testing/paints.h"

// Only for tests of lane matrices: eight Eigen matrices to one buffer of lanes, and back.

namespace nacre::solver::test {

using namespace paint;

using Matrices = std::array<Eigen::MatrixXd, kLanes>;

/// One matrix per lane, elements uniform in [-1, 1].
inline Matrices random_matrices(int rows, int columns, unsigned seed) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> element(-1, 1);
    Matrices all;
    for (Eigen::MatrixXd& m : all) {
        m = Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return element(engine); });
    }
    return all;
}

inline LaneBuffer to_lanes(const Matrices& all) {
    const Eigen::Index rows = all[0].rows(), columns = all[0].cols();
    LaneBuffer out(rows * columns);
    for (Eigen::Index i = 0; i < rows; ++i) {
        for (Eigen::Index j = 0; j < columns; ++j) {
            out[i * columns + j] =
                make_lanes<DoubleLanes>([&](int lane) { return all[lane](i, j); });
        }
    }
    return out;
}

inline Matrices from_lanes(const LaneBuffer& buffer, int rows, int columns) {
    Matrices all;
    for (int lane = 0; lane < kLanes; ++lane) {
        all[lane].resize(rows, columns);
        for (int i = 0; i < rows; ++i) {
            for (int j = 0; j < columns; ++j) all[lane](i, j) = buffer[i * columns + j][lane];
        }
    }
    return all;
}

// Only for tests of the solver: recipes, and albedos of the parts of a BRDF.

inline const std::vector<double> kOneWavelength = {550.0};

inline FlakeSpecies flake_species(double alpha, const spectra::Spectrum& reflectance,
                                  const spectra::Spectrum& transmittance) {
    return nacre::test::flakes(0.1, alpha, reflectance, transmittance);
}

/// Flakes of the given reflectance and transmittance at all angles; c = 0.1 per um, so that a layer
/// of 10 beta um has the dimensionless depth beta.
inline Recipe flake_paint(double alpha, const spectra::Spectrum& reflectance,
                          const spectra::Spectrum& transmittance, double depth, double ior) {
    return nacre::test::paint_of(
        ior, {{10 * depth, {flake_species(alpha, reflectance, transmittance)}, {}}});
}

/// One layer of a Henyey-Greenstein pigment with the given albedo and optical depth.
inline Recipe pigment_paint(double albedo, double depth, double anisotropy, double ior) {
    return nacre::test::paint_of(ior, {nacre::test::pigment_layer(albedo, depth, anisotropy)});
}

/// Light that meets exactly one flake or pigment and leaves, over the incident light from theta_i,
/// at the first wavelength: the closed form summed over outgoing directions. One layer only, so
/// that the kernel alone depends on azimuth and attenuation is computed once per polar angle.
inline double single_albedo(const SolvedPaint& paint, double theta_i) {
    constexpr int kPolar = 96, kAzimuths = 128;
    static const Quadrature polar = gauss_legendre(kPolar, 0, std::numbers::pi / 2);
    static const Quadrature azimuth = gauss_legendre(kAzimuths, 0, 1);
    const PaintMedium& medium = paint.medium;
    const double mu_i = inside_cosine(medium.ior[0], theta_i);
    double sum = 0;
    for (int i = 0; i < kPolar; ++i) {
        const double theta = polar.nodes[i], mu_o = inside_cosine(medium.ior[0], theta);
        const auto kernel = [&](double phi) {
            return backscattering(medium.layers.at(0), mu_i, mu_o, phi, 0)[0];
        };
        const double in_plane = kernel(std::numbers::pi);
        if (in_plane == 0) continue;  // so far off the lobe that it underflows
        double ring = 0;
        for (int k = 0; k < kAzimuths; ++k) {
            // phi = pi (1 - x^2) packs nodes around the mirror direction.
            const double x = azimuth.nodes[k];
            ring += 4 * std::numbers::pi * x * azimuth.weights[k] *
                    kernel(std::numbers::pi * (1 - x * x));
        }
        sum += polar.weights[i] * std::sin(theta) * std::cos(theta) * ring / in_plane *
               single_scattering(medium, theta_i, theta, std::numbers::pi)[0];
    }
    return sum;
}

/// Order 0 of the multiple scattering at the first wavelength, between theta_i and every exit node.
inline std::vector<double> multiple_by_node(const SolvedPaint& paint, double theta_i) {
    const MultipleScattering& r = paint.multiple_scattering;
    const MultipleScatteringSlice slice(r, theta_i);
    std::vector<double> by_order(static_cast<std::size_t>(r.rank()) * r.orders()), out;
    for (const double theta_o : r.exit_angle) {
        slice.by_order({&theta_o, 1}, by_order);
        double sum = 0;
        for (int k = 0; k < r.rank(); ++k) {
            sum += r.basis[static_cast<std::size_t>(k) * r.wavelength_count] * by_order[k];
        }
        out.push_back(sum);
    }
    return out;
}

/// The same of light that meets more than one; a smooth interface.
inline double multiple_albedo(const SolvedPaint& paint, double theta_i) {
    const double ior = paint.medium.ior[0];
    const Directions d =
        make_directions(ior, static_cast<int>(paint.multiple_scattering.exit_angle.size()), 4);
    const std::vector<double> f = multiple_by_node(paint, theta_i);
    const auto enter = [&](double theta) {
        return 1 - optics::dielectric_reflectance(1.0, ior, std::cos(theta));
    };
    double sum = 0;
    for (int j = 0; j < d.exit_count; ++j) {
        sum += 2 * std::numbers::pi * d.weight[j] * d.mu[j] * enter(d.exit_angle[j]) * f[j];
    }
    return enter(theta_i) * sum;
}

/// All light that leaves, without the specular lobe of the interface.
inline double albedo(const SolvedPaint& paint, double theta_i) {
    return single_albedo(paint, theta_i) + multiple_albedo(paint, theta_i);
}

}  // namespace nacre::solver::test
