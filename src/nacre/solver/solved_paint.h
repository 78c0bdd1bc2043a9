#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/core/part.h"
#include "nacre/solver/medium.h"
#include "nacre/solver/multiple_scattering.h"

namespace nacre::solver {

/// How finely to solve. Zero means: chosen from the recipe.
struct SolverSettings {
    int exit_nodes = 0;       ///< directions that leave the coat, a multiple of 4 up to kMaxNodes
    int inner_nodes = 0;      ///< directions beyond the critical angle, a multiple of 4
    int max_orders = 0;       ///< azimuthal Fourier orders at most
    double tolerance = 1e-4;  ///< of the peak: where the Fourier series may end, in kToleranceRange

    static constexpr int kMaxNodes = 128;
    static constexpr int kMaxOrders = 1024;
    static constexpr Range kToleranceRange{1e-12, 0.1};
    friend bool operator==(const SolverSettings&, const SolverSettings&) = default;
};

/// The resolution that was used, and the solver's estimates of its own errors.
struct SolverReport {
    int exit_nodes = 0, inner_nodes = 0, orders = 0;
    /// Largest scattering that the quadrature misses or adds at an exit node, over the extinction
    /// there; extinction is changed by as much, so that no energy is lost. Under a rough interface
    /// at least ten times the interface's asymmetry, the error of reciprocity of its own
    /// quadratures (RoughInterfaceOperators::asymmetry()).
    double unresolved_scattering = 0;
    /// Estimate of the truncation error of the azimuthal series, over the peak: the sum of the
    /// largest values of all omitted orders, if they fall on as the last ones that were solved
    /// fell; that of the last ones themselves where these did not fall.
    double azimuthal_tail = 0;

    friend bool operator==(const SolverReport&, const SolverReport&) = default;
};

/// A paint whose light transport has been solved: a value, complete in itself, that evaluates its
/// BRDF at the wavelengths it was solved for. The specular lobe of a smooth interface is left out;
/// the lobe of a rough one (rough_interface.h) is part of the total, but neither of single nor of
/// multiple.
struct SolvedPaint {
    paint::Recipe recipe;
    SolverSettings settings;
    SolverReport report;
    PaintMedium medium;
    /// f_multiple: without Fresnel factors under a smooth interface, complete under a rough one.
    MultipleScattering multiple_scattering;
    /// f_single, complete, if medium.roughness > 0; empty otherwise, where single_scattering() is
    /// exact. Zero at wavelengths at which the binder's index is 1: there is no interface.
    MultipleScattering rough_single;

    /// Whether the interface is rough at this wavelength, which decides what the two tensors hold.
    bool is_rough(int wavelength) const {
        return medium.roughness > 0 && medium.ior[wavelength] > 1;
    }

    const std::vector<double>& wavelengths_nm() const { return medium.wavelengths_nm; }

    /// BRDF in 1/sr at all wavelengths for polar angles in [0, pi/2) and phi = phi_o - phi_i.
    /// Exact single scattering under a smooth interface, interpolated multiple scattering; never
    /// negative.
    /// @throws DomainError if an angle is out of range
    std::vector<double> brdf(double theta_i, double theta_o, double phi,
                             Part part = Part::total) const;

    friend bool operator==(const SolvedPaint&, const SolvedPaint&) = default;
};

/// A factor of the light that was scattered in a layer whose optical depth along both directions
/// together is `depth`, at the wavelengths of a block.
using LayerFactor =
    std::function<DoubleLanes(std::size_t layer, int block, const DoubleLanes& depth)>;

/// Closed form of the light that met exactly one flake or pigment, in 1/sr, at all wavelengths,
/// under a smooth interface, its Fresnel factors included; theta outside the coat, phi = phi_o -
/// phi_i.
/// @param factor  by which it differs from the equation of transfer; empty: not at all
std::vector<double> single_scattering(const PaintMedium& medium, double theta_i, double theta_o,
                                      double phi, const LayerFactor& factor = {});

/// Fresnel transmittances in and out over n^2, the change of solid angle across a smooth interface:
/// of light that is given without Fresnel factors.
double interface_factor(double ior, double theta_i, double theta_o);

}  // namespace nacre::solver
