#include "nacre/solver/azimuthal_order.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/core/lane_math.h"
#include "nacre/optics/fresnel.h"

namespace nacre::solver {

namespace {

LaneBuffer balanced_extinction(const std::vector<Losses>& losses, const FourierKernel& kernel,
                               const Directions& d, int block, double& unresolved) {
    const int n = d.size();
    LaneBuffer scattering(n, DoubleLanes{}), total(n);
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j <= i; ++j) {
            const std::size_t at = triangle(i) + j;
            // Widened before they are added, as in set_operators: a sum rounded to single precision
            // would be flux lost or gained, 1e-8 of it per unit of optical depth.
            const DoubleLanes both =
                2 * std::numbers::pi *
                (to_double(kernel.same(block, 0)[at]) + to_double(kernel.opposite(block, 0)[at]));
            scattering[i] += d.weight[j] * both;
            if (j != i) scattering[j] += d.weight[i] * both;
        }
    }
    for (int i = 0; i < n; ++i) {
        total[i] = losses[i].absorption[block] + scattering[i];
        if (i < d.exit_count) {
            const DoubleLanes& exact = losses[i].extinction[block];
            for (int lane = 0; lane < kLanes; ++lane) {
                const double miss = std::abs(total[i][lane] - exact[lane]);
                unresolved = std::max(unresolved, miss / std::max(exact[lane], 1e-300));
            }
        }
    }
    return total;
}

}  // namespace

PaintBlock make_block(const PaintMedium& medium, const Directions& d,
                      std::span<const FourierKernel> kernels,
                      std::span<const std::vector<Losses>> losses, int lit, int block) {
    const int n = d.size();
    PaintBlock out;
    out.substrate = block_lanes(medium.substrate_reflectance, block);
    const DoubleLanes clearcoat = block_lanes(medium.clearcoat_depth, block);
    out.coat_absorbs = lane_max(clearcoat) > 0;
    for (int i = 0; i < n; ++i) {
        out.coat.push_back(make_lanes<DoubleLanes>(
            [&](int lane) { return std::exp(-clearcoat[lane] / d.mu[i]); }));
        out.returned.push_back(out.coat[i] * out.coat[i] *
                               optics::dielectric_reflectance(d.ior, 1.0, d.mu[i]));
    }
    LaneBuffer depth(lit, DoubleLanes{});  // above the layer, one way
    for (std::size_t k = 0; k < medium.layers.size(); ++k) {
        const LayerMedium& layer = medium.layers[k];
        LaneBuffer total = balanced_extinction(losses[k], kernels[k], d, block, out.unresolved);
        DoubleLanes deepest{};
        for (int i = 0; i < n; ++i) {
            deepest = max_lanes(deepest, layer.thickness_um * total[i] * (1 / d.mu[i]));
        }
        LaneBuffer factor(triangle(lit));
        for (int i = 0; i < lit; ++i) {
            for (int j = 0; j <= i; ++j) {
                const DoubleLanes rate = total[i] / d.mu[i] + total[j] / d.mu[j];
                factor[triangle(i) + j] = make_lanes<DoubleLanes>([&](int lane) {
                                              const double x = layer.thickness_um * rate[lane];
                                              return std::exp(-depth[i][lane] - depth[j][lane]) *
                                                     layer.thickness_um * mean_attenuation(x);
                                          }) *
                                          out.coat[i] * out.coat[j];
            }
        }
        for (int i = 0; i < lit; ++i) depth[i] += layer.thickness_um * total[i] / d.mu[i];
        out.layers.push_back({&kernels[k], block, layer.thickness_um, std::move(total),
                              std::move(factor), doublings_for(lane_max(deepest))});
    }
    return out;
}

namespace {

// The impedance of the Lambertian substrate of reflectance r: order 0 is R = r e e^T with e_i =
// sqrt(weight x cosine) normalised, the others 0; 1 + R inverts in closed form.
void set_substrate(DoubleLanes* y, const PaintBlock& block, const Directions& d, int order, int m) {
    std::fill(y, y + m * m, DoubleLanes{});
    for (int i = 0; i < m; ++i) y[i * m + i] = splat(1.0);
    if (order != 0) return;
    double norm = 0;
    for (int i = 0; i < m; ++i) norm += d.weight[i] * d.mu[i];
    const DoubleLanes factor = 2.0 * block.substrate / (1.0 + block.substrate);
    for (int i = 0; i < m; ++i) {
        for (int j = 0; j < m; ++j) {
            y[i * m + j] -=
                factor * (std::sqrt(d.weight[i] * d.mu[i] * d.weight[j] * d.mu[j]) / norm);
        }
    }
}

// E = A - B and F = A + B of impedance.h for one order of one layer.
void set_operators(DoubleLanes* e, DoubleLanes* f, const LayerBlock& layer, const Directions& d,
                   int order, int first, int m, const double* scale) {
    const FloatLanes *same = layer.same(order), *opposite = layer.opposite(order);
    for (int i = 0; i < m; ++i) {
        for (int j = 0; j <= i; ++j) {
            const std::size_t at = triangle(i) + j;
            const double factor = scale[i] * scale[j];
            const DoubleLanes stay = factor * to_double(same[at]);
            const DoubleLanes turn = factor * to_double(opposite[at]);
            DoubleLanes a = -stay;
            if (i == j) a += layer.extinction[first + i] / d.mu[first + i];
            e[i * m + j] = e[j * m + i] = a - turn;
            f[i * m + j] = f[j * m + i] = a + turn;
        }
    }
}

// Single scattering, the sum over layers of kernel times depth integral, for one pair of active
// nodes.
DoubleLanes single_scattering(const PaintBlock& block, int order, int first, int i, int j) {
    DoubleLanes once{};
    for (const LayerBlock& layer : block.layers) {
        once += to_double(layer.opposite(order)[triangle(i) + j]) *
                layer.single_factor[triangle(first + i) + first + j];
    }
    return once;
}

// The impedance of all layers and the substrate, at the active nodes, into work.y.
void set_paint_impedance(const PaintBlock& block, const Directions& d, int order, int first,
                         OrderWorkspace& work) {
    const int m = d.size() - first;
    for (int i = 0; i < m; ++i) {
        work.scale[i] = std::sqrt(2 * std::numbers::pi * d.weight[first + i] / d.mu[first + i]);
    }
    DoubleLanes *e = work.e.data(), *f = work.f.data(), *y = work.y.data();
    set_substrate(y, block, d, order, m);
    for (auto layer = block.layers.rbegin(); layer != block.layers.rend(); ++layer) {
        set_operators(e, f, *layer, d, order, first, m, work.scale.data());
        slab_impedance(e, f, layer->thickness_um, layer->doublings, m, work.impedance);
        stack_on(e, f, y, m, work.impedance);
    }
}

// 2 pi sqrt(W_i W_j) with W = weight x cosine of an active node inside the coat: the operator of an
// order f_ij of the BRDF is R_ij = 2 pi sqrt(W_i W_j) f_ij.
double flux(const Directions& d, int first, int i, int j) {
    return 2 * std::numbers::pi *
           std::sqrt(d.weight[first + i] * d.mu[first + i] * d.weight[first + j] * d.mu[first + j]);
}

}  // namespace

void solve_order(const PaintBlock& block, const Directions& d, const ActiveNodes& active, int order,
                 OrderWorkspace& work, DoubleLanes* out) {
    const int first = active.first(order), m = d.size() - first, exits = d.exit_count - first;
    set_paint_impedance(block, d, order, first, work);
    DoubleLanes* const u = work.u.data();
    reflect_under_interface(work.y.data(), block.returned.data() + first, u, m, exits,
                            work.impedance);

    // Subtract single scattering, in the same discretisation.
    const DoubleLanes* const coat = block.coat.data() + first;
    for (int i = 0; i < exits; ++i) {
        for (int j = 0; j <= i; ++j) {
            *out++ = u[i * exits + j] * coat[i] * coat[j] * (1 / flux(d, first, i, j)) -
                     single_scattering(block, order, first, i, j) *
                         (1 / (d.mu[first + i] * d.mu[first + j]));
        }
    }
}

void solve_rough_order(const PaintBlock& block, const RoughInterfaceOperators::Order& interface,
                       const Directions& d, int order, OrderWorkspace& work, DoubleLanes* single,
                       DoubleLanes* multiple) {
    const int m = interface.n, exits = interface.exits, first = d.size() - m;
    set_paint_impedance(block, d, order, first, work);
    DoubleLanes *y = work.y.data(), *u = work.u.data(), *s = work.e.data(), *once = work.f.data();
    if (block.coat_absorbs) {
        impedance_to_reflection(y, m, work.impedance);
        for (int i = 0; i < m; ++i) {
            for (int j = 0; j < m; ++j) {
                y[i * m + j] *= block.coat[first + i] * block.coat[first + j];
            }
        }
        impedance_to_reflection(y, m, work.impedance);  // its own inverse
    }
    reflect_under_rough_interface(interface, y, u, work.impedance);
    for (int i = 0; i < m; ++i) {
        for (int j = 0; j <= i; ++j) {
            s[i * m + j] = s[j * m + i] =
                single_scattering(block, order, first, i, j) *
                (flux(d, first, i, j) / (d.mu[first + i] * d.mu[first + j]));
        }
    }
    reflect_once_under_rough_interface(interface, s, once, work.impedance);
    for (int i = 0; i < exits; ++i) {
        for (int j = 0; j <= i; ++j) {
            const double scale = 1 / (d.ior * d.ior * flux(d, first, i, j));
            *single++ = once[i * exits + j] * scale;
            *multiple++ = (u[i * exits + j] - once[i * exits + j]) * scale;
        }
    }
}

}  // namespace nacre::solver
