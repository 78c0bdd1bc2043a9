#include "nacre/solver/resolution.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "nacre/core/error.h"
#include "nacre/solver/lane_matrix.h"

namespace nacre::solver {

namespace {

// Lobes this wide err as much for other reasons as by the colours of films (docs/solver.md, Accuracy).
constexpr double kWideLobe = 0.3;

int round_up_to_tile(double x) { return kTile * static_cast<int>(std::ceil(x / kTile)); }

/// How much the colour of films changes with the angle: the total variation of log R over the half
/// vectors of light that comes from air and leaves into it, at the wavelength where that is largest.
double film_variation(const PaintMedium& medium, double n) {
    constexpr double kDark = 0.01;  // of the largest R: what is darker is hidden by other light
    constexpr int kNormal = paint::FlakeTable::kFineIntervals;
    const int first = static_cast<int>(std::ceil(kNormal * std::sqrt(1 - 1 / (n * n))));
    double most = 0;
    for (const LayerMedium& layer : medium.layers) {
        for (const FlakeMedium& flake : layer.flakes) {
            if (flake.table.cosine_count() == 1) continue;
            double brightest = 0;
            for (int node = first; node <= kNormal; ++node) {
                const double* r = flake.table.fine_reflectance(node);
                brightest =
                    std::max(brightest, *std::max_element(r, r + medium.wavelength_count()));
            }
            if (brightest == 0) continue;
            for (int i = 0; i < medium.wavelength_count(); ++i) {
                const auto at = [&](int node) {
                    return std::log(flake.table.fine_reflectance(node)[i] + kDark * brightest);
                };
                double sum = 0, last = at(first);
                for (int node = first + 1; node <= kNormal; ++node) {
                    const double next = at(node);
                    sum += std::abs(next - last);
                    last = next;
                }
                most = std::max(most, sum);
            }
        }
    }
    return most;
}

void check_nodes(int value, int max_value, const char* what) {
    require_in_range(value, 0, max_value, what);
    if (value % kTile != 0) {
        throw DomainError(fmt::format("{} = {} is not a multiple of {}", what, value, kTile));
    }
}

// Under a rough interface single scattering is not split off: its lobes must be resolved by the
// nodes too. The interface's lobes need not be (rough_interface_operators.h), but masking changes
// within its roughness of the horizon, where the spacing of n nodes is of order 1/n^2.
void choose_rough(double alpha, double roughness, double n, double films,
                  const SolverSettings& settings, Resolution& r) {
    const int exit_nodes =
        round_up_to_tile(std::max(15 + 0.7 / alpha, 5 + 6.1 / std::sqrt(roughness)));
    if (exit_nodes > SolverSettings::kMaxNodes && !settings.exit_nodes) {
        throw Error(fmt::format(
            "flakes of alpha = {} under a rough clearcoat need {} nodes, more than the {} there "
            "may be: use wider flakes, a smooth clearcoat, or set exit_nodes",
            alpha, exit_nodes, SolverSettings::kMaxNodes));
    }
    // Lobes as they leave: a coat of index n widens those of flakes n times, and so do the facets that
    // refract them. Between nodes too far apart the dark angles beside a lobe ring.
    const double widened = std::hypot(alpha, std::min(0.25, 0.5 * (n - 1)) * roughness);
    r.exit_nodes = std::max(
        exit_nodes,
        std::min(round_up_to_tile(15 + 1.65 / (n * widened) + films), SolverSettings::kMaxNodes));
    r.inner_nodes = std::min(round_up_to_tile(7 + 0.5 / alpha), SolverSettings::kMaxNodes);
    // For lobes, and for what facets scatter to the horizon. An estimate, as below.
    const double tangent = 1 / std::sqrt(n * n - 1);
    const double orders = 8 + 8 * roughness * tangent + 3 * tangent / widened;
    r.orders = static_cast<int>(std::min<double>(SolverSettings::kMaxOrders, orders));
}

}  // namespace

bool refine(Resolution& resolution, const SolverSettings& settings, double unresolved,
            double azimuthal_tail) {
    bool refined = false;
    const auto raise = [&](int& value, int wanted, int max_value, bool fixed) {
        const int next = std::min(wanted, max_value);
        if (fixed || next <= value) return;
        value = next;
        refined = true;
    };
    if (unresolved > kAcceptedUnresolved) {
        const auto half_again = [](int nodes) { return round_up_to_tile(1.5 * nodes); };
        raise(resolution.exit_nodes, half_again(resolution.exit_nodes), SolverSettings::kMaxNodes,
              settings.exit_nodes != 0);
        raise(resolution.inner_nodes, half_again(resolution.inner_nodes), SolverSettings::kMaxNodes,
              settings.inner_nodes != 0);
    }
    if (azimuthal_tail > settings.tolerance) {
        raise(resolution.orders, 2 * resolution.orders, SolverSettings::kMaxOrders,
              settings.max_orders != 0);
    }
    return refined;
}

void check(const SolverSettings& settings) {
    check_nodes(settings.exit_nodes, SolverSettings::kMaxNodes, "exit_nodes");
    check_nodes(settings.inner_nodes, SolverSettings::kMaxNodes, "inner_nodes");
    require_in_range(settings.max_orders, 0, SolverSettings::kMaxOrders, "max_orders");
    require_in_range(settings.tolerance, SolverSettings::kToleranceRange, "tolerance");
}

Resolution choose_resolution(const PaintMedium& medium, const SolverSettings& settings) {
    check(settings);
    double alpha = 1.0;
    for (const LayerMedium& layer : medium.layers) {
        for (const FlakeMedium& flake : layer.flakes) alpha = std::min(alpha, flake.alpha);
        for (const PigmentMedium& pigment : layer.pigments) {
            alpha = std::min(alpha, 1.5 * (1 - pigment.sharpness()));
        }
    }
    Resolution r;
    r.lobe_alpha = alpha;
    const double n_smallest = *std::min_element(medium.ior.begin(), medium.ior.end());
    const bool bare = n_smallest == 1.0;
    // A lobe times a colour that changes within it is narrower than the lobe; the numbers are those of
    // measured errors (docs/solver.md, Accuracy). Without an interface there are nodes enough.
    const double films =
        bare || alpha >= kWideLobe
            ? 0
            : std::clamp(2 * (film_variation(medium, n_smallest) - 1.7), 0.0, 1.0 * kMaxFilmNodes);
    r.exit_nodes = round_up_to_tile(bare ? 24 + 2 / alpha : 8 + 0.72 / alpha + films);
    r.inner_nodes = round_up_to_tile(4 + 0.45 / alpha);
    r.exit_nodes = std::min(r.exit_nodes, SolverSettings::kMaxNodes);
    r.inner_nodes = std::min(r.inner_nodes, SolverSettings::kMaxNodes);
    r.orders = SolverSettings::kMaxOrders;
    if (!bare) {
        // The widest exit direction inside the coat sets the number. An estimate: the series ends
        // by its own tail, and the solver asks for more orders where it has not.
        const double tangent = 1 / std::sqrt(n_smallest * n_smallest - 1);
        r.orders = static_cast<int>(std::min<double>(r.orders, 12 + 1.8 * tangent / alpha));
    }
    if (medium.roughness > 0 && !bare)
        choose_rough(alpha, medium.roughness, n_smallest, films, settings, r);
    if (settings.exit_nodes) r.exit_nodes = settings.exit_nodes;
    if (settings.inner_nodes) r.inner_nodes = settings.inner_nodes;
    if (settings.max_orders) r.orders = settings.max_orders;
    return r;
}

}  // namespace nacre::solver
