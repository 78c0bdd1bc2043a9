#include "nacre/solver/fourier_kernel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "nacre/core/parallel.h"
#include "nacre/core/quadrature.h"
#include "nacre/paint/beckmann.h"
#include "nacre/solver/lane_matrix.h"
#include "nacre/solver/lane_registers.h"
#include "nacre/solver/order_interpolation.h"

namespace nacre::solver {

namespace {

// A lobe is cut where it falls below exp(-kNegligible) of its peak.
constexpr double kNegligible = 22.0;
// Orders whose sums run side by side: each is a chain of dependent additions.
constexpr int kOrdersAtOnce = 4;

// Scratch memory of the azimuthal transform of one pair of nodes; reused from pair to pair.
struct PairScratch {
    std::vector<DoubleLanes> value;  // [block][node]
    std::vector<double> weight, cosine, twice_cos, now, before;
    std::array<std::vector<double>, kOrdersAtOnce> harmonic;  // cos l phi of the orders at hand

    void resize(std::size_t count, int blocks) {
        value.resize(count * blocks);
        for (auto* numbers : {&weight, &cosine, &twice_cos, &now, &before}) numbers->resize(count);
        for (auto& numbers : harmonic) numbers.resize(count);
    }
};

// p_l of flakes for the travel cosines mu_i and sign * mu_j, given to out(block, l). Nodes follow
// `all_orders` that the pair has, so that an order does not depend on what is asked with it.
template <class Out>
void transform_pair(const FlakeMedium& flake, double mu_i, double s_i, double mu_j, double s_j,
                    bool opposite, int all_orders, OrderRange orders, int blocks,
                    PairScratch& scratch, Out&& out) {
    if (orders.begin >= orders.end) return;
    const double delta = opposite ? mu_i + mu_j : std::abs(mu_i - mu_j);
    if (delta == 0.0) return;  // p_l -> 0 with |delta|
    const double across = (opposite ? mu_i - mu_j : mu_i + mu_j) / (s_i + s_j);
    const double a2 = flake.alpha * flake.alpha;
    if (across * across > kNegligible * 1.5 * a2) return;

    const double along2 = 4 * s_i * s_j / (delta * delta);
    const double reach = along2 > 0 ? std::sqrt(kNegligible * a2 / along2) : 1.0;
    const double phi_max = reach < 1 ? 2 * std::asin(reach) : std::numbers::pi;
    const int count = 8 * ((16 + static_cast<int>(0.6 * all_orders * phi_max) + 7) / 8);
    const Quadrature& rule = unit_gauss_legendre(count);
    scratch.resize(count, blocks);
    for (int k = 0; k < count; ++k) {
        const double phi = phi_max * rule.nodes[k];
        const double half = std::sin(0.5 * phi);
        const double tan2 = across * across + along2 * half * half;
        scratch.cosine[k] = std::min(1.0, 0.5 * delta * std::sqrt(1 + tan2));
        scratch.weight[k] = 0.5 * flake.area_density_per_um * std::numbers::inv_pi * phi_max *
                            rule.weights[k] * paint::flake_density(tan2, flake.alpha);
        scratch.now[k] = 1.0;
        scratch.before[k] = 1 - 2 * half * half;  // cos phi
        scratch.twice_cos[k] = 2 * scratch.before[k];
    }
    for (int b = 0; b < blocks; ++b) {
        DoubleLanes* const value = scratch.value.data() + static_cast<std::size_t>(b) * count;
        for (int k = 0; k < count; ++k) {
            value[k] = scratch.weight[k] * flake.table.reflectance(scratch.cosine[k], b);
        }
    }
    for (int l = 0; l < orders.end; l += kOrdersAtOnce) {
        for (std::vector<double>& harmonic : scratch.harmonic) {
            for (int k = 0; k < count; ++k) {
                harmonic[k] = scratch.now[k];
                const double next = scratch.twice_cos[k] * scratch.now[k] - scratch.before[k];
                scratch.before[k] = scratch.now[k];
                scratch.now[k] = next;
            }
        }
        if (l + kOrdersAtOnce <= orders.begin) continue;
        for (int b = 0; b < blocks; ++b) {
            const DoubleLanes* const value =
                scratch.value.data() + static_cast<std::size_t>(b) * count;
            Register sum[kOrdersAtOnce][kRegisters] = {};
            for (int k = 0; k < count; ++k) {
                for (int part = 0; part < kRegisters; ++part) {
                    const Register of_part = load(value + k, part);
#pragma GCC unroll 4
                    for (int i = 0; i < kOrdersAtOnce; ++i) {
                        sum[i][part] += scratch.harmonic[i][k] * of_part;
                    }
                }
            }
            for (int i = std::max(0, orders.begin - l); i < std::min(kOrdersAtOnce, orders.end - l);
                 ++i) {
                DoubleLanes of_order;
                for (int part = 0; part < kRegisters; ++part) store(sum[i][part], &of_order, part);
                out(b, l + i, of_order);
            }
        }
    }
}

}  // namespace

ActiveNodes::ActiveNodes(const Directions& d, double alpha, int orders) {
    const int n = d.size();
    for (int i = 0; i < n; ++i) {
        // e^(-B) I_l(B) with B = tan^2 theta/(2 alpha^2) falls below 1e-5 of its first term at
        // l = sqrt(23 B) = 3.4 tan theta/alpha; wide lobes need a few orders more.
        const double tangent = std::sqrt(1 - d.mu[i] * d.mu[i]) / d.mu[i];
        const double needed = std::min<double>(std::ceil(3.4 * tangent / alpha) + 10, orders);
        order_count_.push_back(
            std::min(next_solved_order(static_cast<int>(needed) - 1) + 1, orders));
    }
    for (int l = 0; l < orders; ++l) {
        int first = 0;
        while (first < n && order_count_[first] <= l) ++first;
        if (first == n) break;
        first_.push_back(first / kTile * kTile);
    }
    // Every node of a tile takes part as long as one does.
    for (int i = 0; i < n; i += kTile) {
        const auto tile = order_count_.begin() + i;
        std::fill(tile, tile + kTile, *std::max_element(tile, tile + kTile));
    }
}

FourierKernel::FourierKernel(const LayerMedium& layer, const Directions& d,
                             const ActiveNodes& active, int blocks, SharedProgress* work,
                             OrderRange orders)
    : orders_{orders.begin, std::min(orders.end, active.orders())} {
    std::size_t total = 0;
    for (int l = orders_.begin; l < orders_.end; ++l) {
        offset_.push_back(total);
        total += triangle(d.size() - active.first(l));
    }
    same_.assign(blocks, std::vector<FloatLanes>(total, FloatLanes{}));
    opposite_ = same_;
    for (const FlakeMedium& flake : layer.flakes) add_flakes(flake, d, active, work);
    for (const PigmentMedium& pigment : layer.pigments) add_pigment(pigment, d, active, work);
}

std::size_t FourierKernel::bytes(const Directions& d, const ActiveNodes& active) {
    std::size_t total = 0;
    for (int l = 0; l < active.orders(); ++l) total += triangle(d.size() - active.first(l));
    return 2 * total * sizeof(FloatLanes);
}

void FourierKernel::add_flakes(const FlakeMedium& flake, const Directions& d,
                               const ActiveNodes& active, SharedProgress* work) {
    const int blocks = static_cast<int>(same_.size());
    parallel_for(0, d.size(), [&](int i) {
        if (work) work->throw_if_stopped(kSolving);
        thread_local PairScratch scratch;
        const double s_i = std::sqrt((1 - d.mu[i]) * (1 + d.mu[i]));
        for (int j = 0; j <= i; ++j) {
            const double s_j = std::sqrt((1 - d.mu[j]) * (1 + d.mu[j]));
            const int shared = std::min(active.order_count(i), active.order_count(j));
            const OrderRange orders{orders_.begin, std::min(orders_.end, shared)};
            for (const bool opposite : {false, true}) {
                auto& kernel = opposite ? opposite_ : same_;  // [block]
                transform_pair(flake, d.mu[i], s_i, d.mu[j], s_j, opposite, shared, orders, blocks,
                               scratch, [&](int block, int l, const DoubleLanes& value) {
                                   const int first = active.first(l);
                                   kernel[block][offset(l) + triangle(i - first) + j - first] +=
                                       to_float(value);
                               });
            }
        }
    });
}

namespace {

// Of (2n + 1)/(4 pi) chi_n, as far as they matter; those of Henyey and Greenstein are one number for
// all wavelengths.                                                  [chandrasekhar-1960, sec. 48]
std::vector<double> series_of(double anisotropy) {
    std::vector<double> terms;
    double power = 1;
    do {
        terms.push_back((2.0 * terms.size() + 1) / (4 * std::numbers::pi) * power);
        power *= anisotropy;
    } while (std::abs(power) * (2.0 * terms.size() - 1) > 1e-9);
    return terms;
}

std::vector<DoubleLanes> series_of(const optics::PhaseFunction& phase, int block) {
    std::vector<DoubleLanes> terms;
    for (int n = 0; n < phase.degrees(); ++n) {
        terms.push_back(make_lanes<DoubleLanes>([&](int lane) {
            const int w = std::min(block * kLanes + lane, phase.wavelength_count() - 1);
            return (2 * n + 1) / (4 * std::numbers::pi) * phase.coefficient(n, w);
        }));
    }
    return terms;
}

}  // namespace

void FourierKernel::add_pigment(const PigmentMedium& pigment, const Directions& d,
                                const ActiveNodes& active, SharedProgress* work) {
    parallel_for(std::size_t{0}, same_.size(), [&](std::size_t at) {
        const int block = static_cast<int>(at);
        const DoubleLanes scattering = block_lanes(pigment.scattering_per_um, block);
        if (pigment.phase) {
            add_legendre(series_of(*pigment.phase, block), scattering, d, active, block, work);
        } else {
            add_legendre(series_of(pigment.anisotropy), scattering, d, active, block, work);
        }
    });
}

template <class T>
void FourierKernel::add_legendre(const std::vector<T>& series, const DoubleLanes& scattering,
                                 const Directions& d, const ActiveNodes& active, int block,
                                 SharedProgress* work) {
    // sum over n >= l of the terms times Lambda_n^l(mu_i) Lambda_n^l(mu_j), Lambda the Legendre
    // functions normalised by sqrt((n - l)!/(n + l)!).        [chandrasekhar-1960, sec. 48]
    const int degrees = static_cast<int>(series.size());
    const int end = std::max(orders_.begin, std::min(orders_.end, degrees));
    parallel_for(orders_.begin, end, [&](int l) {
        if (work) work->throw_if_stopped(kSolving);
        const int first = active.first(l), m = d.size() - first;
        const int terms = degrees - l;
        std::vector<double> lambda(static_cast<std::size_t>(m) * terms);
        for (int i = 0; i < m; ++i) {
            const double mu = d.mu[first + i], s = std::sqrt((1 - mu) * (1 + mu));
            double* value = lambda.data() + static_cast<std::size_t>(i) * terms;
            value[0] = 1.0;
            for (int k = 1; k <= l; ++k) value[0] *= s * std::sqrt((2 * k - 1) / (2.0 * k));
            if (terms > 1) value[1] = std::sqrt(2.0 * l + 1) * mu * value[0];
            for (int k = 2; k < terms; ++k) {
                const double n = l + k;
                value[k] = ((2 * n - 1) * mu * value[k - 1] -
                            std::sqrt((n - 1) * (n - 1) - 1.0 * l * l) * value[k - 2]) /
                           std::sqrt(n * n - 1.0 * l * l);
            }
        }
        for (int i = 0; i < m; ++i) {
            for (int j = 0; j <= i; ++j) {
                const double* a = lambda.data() + static_cast<std::size_t>(i) * terms;
                const double* b = lambda.data() + static_cast<std::size_t>(j) * terms;
                T even{}, odd{};
                for (int k = 0; k < terms; k += 2) even += series[l + k] * (a[k] * b[k]);
                for (int k = 1; k < terms; k += 2) odd += series[l + k] * (a[k] * b[k]);
                const std::size_t at = offset(l) + triangle(i) + j;
                same_[block][at] += to_float((even + odd) * scattering);
                opposite_[block][at] += to_float((even - odd) * scattering);
            }
        }
    });
}

}  // namespace nacre::solver
