#include "nacre/solver/order_interpolation.h"

#include <algorithm>
#include <array>

#include "nacre/solver/fourier_kernel.h"

namespace nacre::solver {

namespace {

// From an order that is solved to the next: all orders of a stretch are multiples of it, as is where
// the next stretch begins.
int step_from(int order) {
    int step = 1;
    while (order >= kDenseOrders * step) step *= 2;
    return step;
}

// Neighbours that an order is interpolated from, half of them on either side, but for the last ones.
constexpr int kPoints = 12;

// Lagrange's weights at 0 of points at odd numbers, of which `above` are positive.
std::array<double, kPoints> weights(int above) {
    std::array<double, kPoints> w;
    const auto at = [&](int p) { return 2 * (p - kPoints + above) + 1; };
    for (int p = 0; p < kPoints; ++p) {
        w[p] = 1;
        for (int q = 0; q < kPoints; ++q) {
            if (q != p) w[p] *= static_cast<double>(at(q)) / (at(q) - at(p));
        }
    }
    return w;
}

}  // namespace

int next_solved_order(int order) {
    const int step = step_from(order);
    return (order + step - 1) / step * step;
}

std::vector<int> solved_orders(int orders) {
    std::vector<int> solved;
    for (int l = 0; l < orders;) {
        solved.push_back(l);
        int step = step_from(l);
        while (step > 1 && l + step >= orders) step /= 2;  // so as to end at the last one
        l += step;
    }
    return solved;
}

std::vector<int> probe_orders(int orders) {
    std::vector<int> probes;
    for (int step = 2; kDenseOrders * step / 2 + step < orders; step *= 2) {
        probes.push_back((kDenseOrders + 1) * step / 2);
    }
    return probes;
}

OrderValues interpolate_order(int l, std::span<const OrderValues> known, std::span<const int> first,
                              int nodes, int blocks) {
    const int step = l & -l, last = static_cast<int>(known.size()) - 1;
    int above = 1;
    while (2 * above < kPoints && l + (2 * above + 1) * step <= last) ++above;
    const std::array<double, kPoints> weight = weights(above);
    OrderValues out(triangle(nodes - first[l]) * blocks, DoubleLanes{});
    for (int p = 0; p < kPoints; ++p) {
        const int m = l + (2 * (p - kPoints + above) + 1) * step;
        // Nodes that have no such order are zero there.
        const int from = std::max(first[l], first[m]);
        for (int i = from; i < nodes; ++i) {
            const int count = (i + 1 - from) * blocks;
            const DoubleLanes* const add =
                known[m].data() + (triangle(i - first[m]) + from - first[m]) * blocks;
            DoubleLanes* const to =
                out.data() + (triangle(i - first[l]) + from - first[l]) * blocks;
            for (int k = 0; k < count; ++k) to[k] += weight[p] * add[k];
        }
    }
    return out;
}

}  // namespace nacre::solver
