#include "nacre/solver/solved_paint.h"

#include <algorithm>
#include <cmath>

#include "nacre/core/error.h"
#include "nacre/core/lane_math.h"
#include "nacre/core/math.h"
#include "nacre/optics/fresnel.h"
#include "nacre/solver/rough_interface.h"

namespace nacre::solver {

double interface_factor(double ior, double theta_i, double theta_o) {
    const double t_i = 1 - optics::dielectric_reflectance(1.0, ior, std::cos(theta_i));
    const double t_o = 1 - optics::dielectric_reflectance(1.0, ior, std::cos(theta_o));
    return t_i * t_o / (ior * ior);
}

namespace {

template <class F>
DoubleLanes map_lanes(const DoubleLanes& x, F&& f) {
    return make_lanes<DoubleLanes>([&](int i) { return f(x[i]); });
}

// Single scattering of one block whose wavelengths share the binder's index.
DoubleLanes single_block(const PaintMedium& medium, int block, double ior, double theta_i,
                         double theta_o, double phi, const LayerFactor& factor) {
    const double mu_i = inside_cosine(ior, theta_i), mu_o = inside_cosine(ior, theta_o);
    DoubleLanes depth = block_lanes(medium.clearcoat_depth, block) * (1 / mu_i + 1 / mu_o);
    DoubleLanes sum{};
    for (std::size_t l = 0; l < medium.layers.size(); ++l) {
        const LayerMedium& layer = medium.layers[l];
        const DoubleLanes here = layer.thickness_um * (extinction(layer, mu_i, block) / mu_i +
                                                       extinction(layer, mu_o, block) / mu_o);
        const DoubleLanes once = backscattering(layer, mu_i, mu_o, phi, block) *
                                 (layer.thickness_um / (mu_i * mu_o)) *
                                 map_lanes(here, [](double x) { return mean_attenuation(x); }) *
                                 map_lanes(-depth, [](double x) { return std::exp(x); });
        sum += factor ? once * factor(l, block, here) : once;
        depth += here;
    }
    return interface_factor(ior, theta_i, theta_o) * sum;
}

// Calls add(wavelength, value) with the values of a tensor. A truncated series may dip below zero
// by its own error.
template <class Add>
void add_tensor(const MultipleScattering& tensor, double theta_i, double theta_o, double phi,
                Add&& add) {
    std::vector<double> coefficient(tensor.rank());
    MultipleScatteringSlice(tensor, theta_i).coefficients(theta_o, phi, coefficient);
    for (int w = 0; w < tensor.wavelength_count; ++w) {
        double value = 0;
        for (int k = 0; k < tensor.rank(); ++k) {
            value += coefficient[k] * tensor.basis[k * tensor.wavelength_count + w];
        }
        add(w, std::max(0.0, value));
    }
}

}  // namespace

std::vector<double> single_scattering(const PaintMedium& medium, double theta_i, double theta_o,
                                      double phi, const LayerFactor& factor) {
    const int count = medium.wavelength_count();
    std::vector<double> f(count);
    for (int block = 0; block < paint::block_count(count); ++block) {
        const int end = std::min(kLanes, count - block * kLanes);
        DoubleLanes value{};
        for (int lane = 0; lane < end; ++lane) {
            const int w = block * kLanes + lane;
            if (lane == 0 || medium.ior[w] != medium.ior[w - 1]) {
                value = single_block(medium, block, medium.ior[w], theta_i, theta_o, phi, factor);
            }
            f[w] = value[lane];
        }
    }
    return f;
}

std::vector<double> SolvedPaint::brdf(double theta_i, double theta_o, double phi, Part part) const {
    require_in_range(theta_i, 0, kHorizon, "theta_i in rad");
    require_in_range(theta_o, 0, kHorizon, "theta_o in rad");
    require_in_range(phi, -1e6, 1e6, "phi in rad");
    const int count = medium.wavelength_count();
    const bool any_rough = medium.roughness > 0;
    std::vector<double> f(count, 0.0);
    if (part != Part::multiple) {
        if (any_rough)
            add_tensor(rough_single, theta_i, theta_o, phi,
                       [&](int w, double value) { f[w] = value; });
        // At an index of 1 there is no interface, hence nothing rough.
        const auto one = std::find(medium.ior.begin(), medium.ior.end(), 1.0);
        if (!any_rough || one != medium.ior.end()) {
            const std::vector<double> single = single_scattering(medium, theta_i, theta_o, phi);
            for (int w = 0; w < count; ++w) {
                if (!is_rough(w)) f[w] = single[w];
            }
        }
    }
    if (part == Part::single) return f;
    add_tensor(multiple_scattering, theta_i, theta_o, phi, [&](int w, double multiple) {
        const double factor = is_rough(w) ? 1.0 : interface_factor(medium.ior[w], theta_i, theta_o);
        f[w] += factor * multiple;
    });
    if (part == Part::multiple) return f;
    double ior = 1, interface = 0;  // of the wavelength before: many binders have one index
    for (int w = 0; w < count; ++w) {
        if (!is_rough(w)) continue;
        if (medium.ior[w] != ior) {
            ior = medium.ior[w];
            interface = rough_interface_brdf(ior, medium.roughness, theta_i, theta_o, phi);
        }
        f[w] += interface;
    }
    return f;
}

}  // namespace nacre::solver
