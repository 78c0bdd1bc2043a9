#include "nacre/layers/solver.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "nacre/core/error.h"
#include "nacre/layers/fourier_kernel.h"
#include "nacre/layers/impedance.h"
#include "nacre/layers/resolution.h"
#include "nacre/layers/rough_interface_operators.h"
#include "nacre/layers/wavelength_groups.h"
#include "nacre/optics/dielectric.h"

namespace nacre::layers {

namespace {

constexpr std::size_t triangle(std::size_t rows) { return rows * (rows + 1) / 2; }

// One layer at the eight wavelengths of a block, on the quadrature nodes.
struct LayerBlock {
    double thickness_um = 0;
    FourierKernel kernel;
    LaneBuffer extinction;     // by node; agrees with the kernel's own sum, see below
    LaneBuffer single_factor;  // by pair of nodes in use: depth integral of single scattering
    int doublings = 0;
};

// All layers at the eight wavelengths of a block, and what lies above and below.
struct PaintBlock {
    std::vector<LayerBlock> layers;
    LaneBuffer coat;    // by node: transmittance of the clearcoat, one way
    LaneBuffer mirror;  // by node: reflectance of the interface from inside
    bool coat_absorbs = false;
    DoubleLanes substrate{};
    double unresolved = 0;
};

// The solver keeps sigma_t = (discrete sum of the kernel) + (exact absorption): what the
// quadrature misses of the scattering cross section is taken from extinction too, so that a flake
// that absorbs nothing loses nothing. Rescaling the kernel instead would break its symmetry.
LaneBuffer balanced_extinction(const LayerMedium& layer, const FourierKernel& kernel,
                               const Directions& d, int block, double& unresolved) {
    const int n = d.size();
    LaneBuffer scattering(n, DoubleLanes{}), total(n);
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j <= i; ++j) {
            const std::size_t at = triangle(i) + j;
            // Widened before they are added, as in set_operators: a sum rounded to single precision
            // would be flux lost or gained, 1e-8 of it per unit of optical depth.
            const DoubleLanes both = 2 * std::numbers::pi *
                                     (__builtin_convertvector(kernel.same(0)[at], DoubleLanes) +
                                      __builtin_convertvector(kernel.opposite(0)[at], DoubleLanes));
            scattering[i] += d.weight[j] * both;
            if (j != i) scattering[j] += d.weight[i] * both;
        }
    }
    for (int i = 0; i < n; ++i) {
        const DoubleLanes lost = absorption(layer, d.mu[i], block);
        total[i] = lost + scattering[i];
        if (i < d.exit_count) {
            const DoubleLanes exact = extinction(layer, d.mu[i], block);
            for (int lane = 0; lane < kLanes; ++lane) {
                const double miss = std::abs(total[i][lane] - exact[lane]);
                unresolved = std::max(unresolved, miss / std::max(exact[lane], 1e-300));
            }
        }
    }
    return total;
}

// Single scattering is wanted between the first `lit` nodes: those that light reaches from outside.
PaintBlock make_block(const PaintMedium& medium, const Directions& d, const ActiveNodes& active,
                      int lit, int block) {
    const int n = d.size();
    PaintBlock out;
    out.substrate = block_lanes(medium.substrate_reflectance, block);
    const DoubleLanes clearcoat = block_lanes(medium.clearcoat_depth, block);
    out.coat_absorbs = lane_max(clearcoat) > 0;
    for (int i = 0; i < n; ++i) {
        out.coat.push_back(make_lanes<DoubleLanes>(
            [&](int lane) { return std::exp(-clearcoat[lane] / d.mu[i]); }));
        out.mirror.push_back(splat(optics::dielectric_reflectance(d.ior, 1.0, d.mu[i])));
    }
    LaneBuffer depth(lit, DoubleLanes{});  // above the layer, one way
    for (const LayerMedium& layer : medium.layers) {
        FourierKernel kernel(layer, d, active, block);
        LaneBuffer total = balanced_extinction(layer, kernel, d, block, out.unresolved);
        DoubleLanes deepest{};
        for (int i = 0; i < n; ++i) {
            deepest = max_lanes(deepest, layer.thickness_um * total[i] * (1 / d.mu[i]));
        }
        LaneBuffer factor(triangle(lit));
        for (int i = 0; i < lit; ++i) {
            for (int j = 0; j <= i; ++j) {
                const DoubleLanes rate = total[i] / d.mu[i] + total[j] / d.mu[j];
                factor[triangle(i) + j] =
                    make_lanes<DoubleLanes>([&](int lane) {
                        const double x = layer.thickness_um * rate[lane];
                        return std::exp(-depth[i][lane] - depth[j][lane]) *
                               (x > 1e-12 ? -std::expm1(-x) / rate[lane] : layer.thickness_um);
                    }) *
                    out.coat[i] * out.coat[j];
            }
        }
        for (int i = 0; i < lit; ++i) depth[i] += layer.thickness_um * total[i] / d.mu[i];
        out.layers.push_back({layer.thickness_um, std::move(kernel), std::move(total),
                              std::move(factor), doublings_for(lane_max(deepest))});
    }
    return out;
}

struct OrderWorkspace {
    explicit OrderWorkspace(int n)
        : e(n * n), f(n * n), y(n * n), u(n * n), impedance(n), scale(n) {}
    LaneBuffer e, f, y, u;
    ImpedanceWorkspace impedance;
    std::vector<double> scale;
};

// The impedance of the Lambertian substrate: order 0 returns the share r of the downward flux
// evenly, R = r e e^T with e_i = sqrt(weight x cosine) normalised; 1 + R inverts in closed form.
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
    const FloatLanes *same = layer.kernel.same(order), *opposite = layer.kernel.opposite(order);
    for (int i = 0; i < m; ++i) {
        for (int j = 0; j <= i; ++j) {
            const std::size_t at = triangle(i) + j;
            const double factor = scale[i] * scale[j];
            const DoubleLanes stay = factor * __builtin_convertvector(same[at], DoubleLanes);
            const DoubleLanes turn = factor * __builtin_convertvector(opposite[at], DoubleLanes);
            DoubleLanes a = -stay;
            if (i == j) a += layer.extinction[first + i] / d.mu[first + i];
            e[i * m + j] = e[j * m + i] = a - turn;
            f[i * m + j] = f[j * m + i] = a + turn;
        }
    }
}

// What meets one flake only, sum of kernel times depth integral, for one pair of active nodes.
DoubleLanes single_scattering(const PaintBlock& block, int order, int first, int i, int j) {
    DoubleLanes once{};
    for (const LayerBlock& layer : block.layers) {
        once +=
            __builtin_convertvector(layer.kernel.opposite(order)[triangle(i) + j], DoubleLanes) *
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

// From impedance to reflection, seen through the clearcoat.
void reflect_under_coat(const PaintBlock& block, DoubleLanes* y, int first, int m,
                        ImpedanceWorkspace& work) {
    impedance_to_reflection(y, m, work);
    for (int i = 0; i < m; ++i) {
        for (int j = 0; j < m; ++j) y[i * m + j] *= block.coat[first + i] * block.coat[first + j];
    }
}

// 2 pi W_i, W = etendue of an active node on the side where f is wanted: operators are
// R_ij = 2 pi f_ij sqrt(W_i W_j).
double flux(const Directions& d, int first, int i, int j) {
    return 2 * std::numbers::pi *
           std::sqrt(d.weight[first + i] * d.mu[first + i] * d.weight[first + j] * d.mu[first + j]);
}

// One azimuthal order of one block under a smooth interface: f_multiple at the exit nodes,
// [pair][lane], without Fresnel's transmittances, into out.
void solve_order(const PaintBlock& block, const Directions& d, const ActiveNodes& active, int order,
                 OrderWorkspace& work, DoubleLanes* out) {
    const int first = active.first(order), m = d.size() - first, exits = d.exit_count - first;
    set_paint_impedance(block, d, order, first, work);
    DoubleLanes *y = work.y.data(), *u = work.u.data();
    reflect_under_coat(block, y, first, m, work.impedance);
    reflect_under_interface(y, block.mirror.data() + first, u, m, exits, work.impedance);

    // Take out what met one flake only, in the same discretisation.
    for (int i = 0; i < exits; ++i) {
        for (int j = 0; j <= i; ++j) {
            *out++ = u[i * exits + j] * (1 / flux(d, first, i, j)) -
                     single_scattering(block, order, first, i, j) *
                         (1 / (d.mu[first + i] * d.mu[first + j]));
        }
    }
}

// The same under a rough interface: f_single and the rest, complete, as seen from outside.
void solve_rough_order(const PaintBlock& block, const RoughInterfaceOperators::Order& interface,
                       const Directions& d, int order, OrderWorkspace& work, DoubleLanes* single,
                       DoubleLanes* rest) {
    const int m = interface.n, exits = interface.exits, first = d.size() - m;
    set_paint_impedance(block, d, order, first, work);
    DoubleLanes *y = work.y.data(), *u = work.u.data(), *s = work.e.data(), *once = work.f.data();
    if (block.coat_absorbs) {
        reflect_under_coat(block, y, first, m, work.impedance);
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
            *rest++ = (u[i * exits + j] - once[i * exits + j]) * scale;
        }
    }
}

// Solves wavelengths that share one index of the binder.
class GroupSolver {
 public:
    GroupSolver(const PaintMedium& medium, const Resolution& resolution)
        : directions_(
              make_directions(medium.ior[0], resolution.exit_nodes, resolution.inner_nodes)),
          active_(directions_, resolution.lobe_alpha, resolution.orders),
          wavelengths_(medium.wavelength_count()) {
        const bool rough = medium.roughness > 0 && directions_.ior > 1;
        if (rough) interface_.emplace(directions_, active_, medium.roughness);
        const int lit = rough ? directions_.size() : directions_.exit_count;
        blocks_.resize(flakes::block_count(wavelengths_));
        tbb::parallel_for(std::size_t{0}, blocks_.size(), [&](std::size_t b) {
            blocks_[b] = make_block(medium, directions_, active_, lit, static_cast<int>(b));
        });
        set_peaks(medium);
    }

    // Solves orders in parallel until they no longer matter.
    GroupSolution run(double tolerance) {
        constexpr int kChunk = 4;
        GroupSolution out;
        out.wavelength_count = wavelengths_;
        out.exit_angle = directions_.exit_angle;
        out.inner_nodes = directions_.size() - directions_.exit_count;
        for (const PaintBlock& block : blocks_) {
            out.unresolved_scattering = std::max(out.unresolved_scattering, block.unresolved);
        }
        if (interface_) {
            out.unresolved_scattering =
                std::max(out.unresolved_scattering, interface_->asymmetry());
        }
        tbb::enumerable_thread_specific<OrderWorkspace> workspaces(
            [&] { return OrderWorkspace(directions_.size()); });
        const int blocks = static_cast<int>(blocks_.size());
        double last_chunk = 0;
        for (int from = 0; from < active_.orders(); from += kChunk) {
            const int count = std::min(kChunk, active_.orders() - from);
            std::vector<LaneBuffer> values(static_cast<std::size_t>(count) * blocks);
            tbb::parallel_for(0, count * blocks, [&](int task) {
                const int order = from + task / blocks;
                const int rows = directions_.exit_count - active_.first(order);
                if (rows <= 0) return;
                const PaintBlock& block = blocks_[task % blocks];
                OrderWorkspace& work = workspaces.local();
                const std::size_t pairs = triangle(rows);
                values[task].resize(interface_ ? 2 * pairs : pairs);
                DoubleLanes* const at = values[task].data();
                if (interface_) {
                    solve_rough_order(block, interface_->order(order), directions_, order, work,
                                      at + pairs, at);
                } else {
                    solve_order(block, directions_, active_, order, work, at);
                }
            });
            double chunk = 0;
            for (int c = 0; c < count; ++c) {
                chunk += 2 * append_order(out, from + c, &values[c * blocks]);
            }
            // What the orders left out would add, if they fall on as they fell from chunk to chunk.
            const double ratio = from > 0 ? chunk / std::max(last_chunk, 1e-300) : 1.0;
            out.azimuthal_tail = ratio < 1 ? chunk * ratio / (1 - ratio) : chunk;
            if (from > 0 && out.azimuthal_tail < tolerance) break;
            last_chunk = chunk;
        }
        return out;
    }

 private:
    // The largest BRDF along the mirror direction of each exit node, for what "small" means: single
    // scattering alone, a lower bound.
    void set_peaks(const PaintMedium& medium) {
        peak_.assign(static_cast<std::size_t>(directions_.exit_count) * blocks_.size(),
                     DoubleLanes{});
        if (interface_) return;  // add_to_peaks
        for (std::size_t b = 0; b < blocks_.size(); ++b) {
            for (int i = 0; i < directions_.exit_count; ++i) {
                const double mu = directions_.mu[i];
                DoubleLanes sum{};
                for (std::size_t k = 0; k < medium.layers.size(); ++k) {
                    sum += backscattering(medium.layers[k], mu, mu, std::numbers::pi,
                                          static_cast<int>(b)) *
                           blocks_[b].layers[k].single_factor[triangle(i) + i] * (1 / (mu * mu));
                }
                peak_[b * directions_.exit_count + i] = sum;
            }
        }
    }

    // Under a rough interface: what the orders so far add up to along the mirror direction.
    void add_to_peaks(int order, int first, const LaneBuffer* by_block) {
        const int rows = directions_.exit_count - first;
        for (std::size_t b = 0; b < blocks_.size(); ++b) {
            for (int i = 0; i < rows; ++i) {
                const std::size_t at = triangle(i) + i;
                peak_[b * directions_.exit_count + first + i] +=
                    (order ? 2.0 : 1.0) * (by_block[b][at] + by_block[b][triangle(rows) + at]);
            }
        }
    }

    // Appends an order's values as [pair][wavelength]; returns its size relative to the peaks.
    double append_order(GroupSolution& out, int order, const LaneBuffer* by_block) {
        const int first = active_.first(order);
        if (first >= directions_.exit_count) return 0;
        const int rows = directions_.exit_count - first;
        out.first.push_back(first);
        if (interface_) add_to_peaks(order, first, by_block);
        double size = 0;
        std::size_t pair = 0;
        const std::size_t pairs = triangle(rows);
        for (int i = 0; i < rows; ++i) {
            for (int j = 0; j <= i; ++j, ++pair) {
                for (std::size_t b = 0; b < blocks_.size(); ++b) {
                    DoubleLanes value = by_block[b][pair];
                    DoubleLanes single{};
                    if (interface_) value += single = by_block[b][pairs + pair];
                    DoubleLanes* peak = peak_.data() + b * directions_.exit_count + first;
                    // Order 0 of what is diffuse counts as peak too.
                    if (order == 0) {
                        peak[i] = max_lanes(peak[i], value);
                        peak[j] = max_lanes(peak[j], value);
                    }
                    const int lanes =
                        std::min<int>(kLanes, wavelengths_ - static_cast<int>(b) * kLanes);
                    for (int lane = 0; lane < lanes; ++lane) {
                        if (!std::isfinite(value[lane])) {
                            throw Error(fmt::format(
                                "the solver broke down in azimuthal order {}: a result is not "
                                "finite; please report the recipe",
                                order));
                        }
                        out.values.push_back(value[lane] - single[lane]);
                        if (interface_) out.single_values.push_back(single[lane]);
                        const double scale = std::min(peak[i][lane], peak[j][lane]);
                        size = std::max(size, std::abs(value[lane]) / std::max(scale, 1e-300));
                    }
                }
            }
        }
        return size;
    }

    Directions directions_;
    ActiveNodes active_;
    std::optional<RoughInterfaceOperators> interface_;  // if rough
    int wavelengths_;
    std::vector<PaintBlock> blocks_;
    LaneBuffer peak_;
};

}  // namespace

std::vector<double> default_wavelengths_nm() {
    std::vector<double> w;
    for (int nm = 400; nm <= 700; nm += 10) w.push_back(nm);
    return w;
}

SolvedPaint solve(const Recipe& recipe, const std::vector<double>& wavelengths_nm,
                  const SolverSettings& settings) {
    SolvedPaint paint;
    paint.recipe = recipe;
    paint.settings = settings;
    paint.medium = make_medium(recipe, wavelengths_nm);
    Resolution resolution = choose_resolution(paint.medium, settings);
    const WavelengthGroups groups = group_wavelengths(paint.medium);
    std::vector<GroupSolution> solutions;
    double unresolved, tail;
    do {
        solutions.clear();
        unresolved = tail = 0;
        for (const WavelengthGroup& group : groups) {
            GroupSolver solver(select_wavelengths(paint.medium, group.distinct), resolution);
            solutions.push_back(solver.run(settings.tolerance));
            unresolved = std::max(unresolved, solutions.back().unresolved_scattering);
            tail = std::max(tail, solutions.back().azimuthal_tail);
        }
    } while (refine(resolution, settings, unresolved, tail));
    merge_groups(groups, solutions, settings.tolerance, paint);
    return paint;
}

}  // namespace nacre::layers
