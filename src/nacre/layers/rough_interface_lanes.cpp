#include "nacre/layers/rough_interface_operators.h"

namespace nacre::layers {

void reflect_under_rough_interface(const RoughInterfaceOperators::Order& interface, DoubleLanes* y,
                                   DoubleLanes* u, ImpedanceWorkspace& work) {
    const int n = interface.n, exits = interface.exits;
    DoubleLanes* solved = work.b.data();
    for (int i = 0; i < n * n; ++i) y[i] += splat(interface.impedance[i]);
    for (int i = 0; i < n * exits; ++i) solved[i] = splat(interface.through[i]);
    for (int i = 0; i < exits * exits; ++i) u[i] = splat(-interface.direct[i]);
    cholesky(y, n);
    forward_solve(y, solved, n, exits);
    add_gram(1.0, u, 2.0, solved, n, exits);
}

void reflect_once_under_rough_interface(const RoughInterfaceOperators::Order& interface,
                                        const DoubleLanes* s, DoubleLanes* u,
                                        ImpedanceWorkspace& work) {
    const int n = interface.n, exits = interface.exits;
    const double* enter = interface.enter.data();
    DoubleLanes* half = work.b.data();  // S T^T, n x exits
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < exits; j += kTile) {
            DoubleLanes sum[kTile] = {};
            for (int k = 0; k < n; ++k) {
                for (int t = 0; t < kTile; ++t) sum[t] += s[i * n + k] * enter[k * exits + j + t];
            }
            for (int t = 0; t < kTile; ++t) half[i * exits + j + t] = sum[t];
        }
    }
    for (int i = 0; i < exits; ++i) {
        for (int j = 0; j < exits; j += kTile) {
            DoubleLanes sum[kTile] = {};
            for (int k = 0; k < n; ++k) {
                for (int t = 0; t < kTile; ++t) {
                    sum[t] += enter[k * exits + i] * half[k * exits + j + t];
                }
            }
            for (int t = 0; t < kTile; ++t) u[i * exits + j + t] = sum[t];
        }
    }
}

}  // namespace nacre::layers
