#include "nacre/solver/order_interpolation.h"

#include <algorithm>
#include <array>

#include "nacre/solver/directions.h"

namespace nacre::solver {

namespace {

// From an order that is solved to the next: all orders of a stretch are multiples of it, as is where
// the next stretch begins.
int step_from(int order) {
    int step = 1;
    while (order >= kDenseOrders * step) step *= 2;
    return step;
}

// Lagrange's weights in the middle of points at one distance, of the points on either side from the
// nearest on.
constexpr int kPoints = 6;
constexpr std::array<double, kPoints> kWeights = [] {
    std::array<double, kPoints> w{};
    for (int p = 0; p < kPoints; ++p) {
        w[p] = 0.5;
        for (int q = 0; q < kPoints; ++q) {
            const double a = 2 * p + 1, b = 2 * q + 1;
            if (q != p) w[p] *= b * b / (b * b - a * a);
        }
    }
    return w;
}();

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
    const int distance = l & -l;
    OrderValues out(triangle(nodes - first[l]) * blocks, DoubleLanes{});
    for (int p = 0; p < kPoints; ++p) {
        for (const int m : {l - (2 * p + 1) * distance, l + (2 * p + 1) * distance}) {
            if (m >= static_cast<int>(known.size())) continue;  // zero
            // Nodes that have no such order are zero there.
            const int from = std::max(first[l], first[m]);
            for (int i = from; i < nodes; ++i) {
                const int count = (i + 1 - from) * blocks;
                const DoubleLanes* const add =
                    known[m].data() + (triangle(i - first[m]) + from - first[m]) * blocks;
                DoubleLanes* const to =
                    out.data() + (triangle(i - first[l]) + from - first[l]) * blocks;
                for (int k = 0; k < count; ++k) to[k] += kWeights[p] * add[k];
            }
        }
    }
    return out;
}

}  // namespace nacre::solver
