#include "nacre/solver/impedance.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace nacre::solver {

namespace {

// Of a slab, in units of which a mode's half depth F x is at least: an empty slab, or one that is
// empty at some of the wavelengths, has F = 0 and no Z_a. Far below rounding of the results, and
// its inverse far from the largest number.
constexpr double kMinDepth = 1e-30;

void copy(DoubleLanes* to, const DoubleLanes* from, int count) {
    std::memcpy(to, from, sizeof(DoubleLanes) * count);
}

}  // namespace

int doublings_for(double largest_optical_depth) {
    // x <= 0.16 for every mode of total optical depth 10 or less: relative error 1.5e-5 at 10,
    // 1e-9 at 1. Deeper modes are opaque: what they are started as matters only until 4^k exceeds
    // their depth (see the header), with a factor 8 to spare.
    const double relevant = std::min(largest_optical_depth, 10.0);
    const double thin = std::log2(std::max(relevant, 1e-300) / 0.32);
    const double thick = 0.5 * std::log2(std::max(8.0 * largest_optical_depth, 1e-300));
    const double needed = largest_optical_depth > 10.0 ? std::max(thin, thick) : thin;
    return std::max(0, static_cast<int>(std::ceil(needed)));
}

void slab_impedance(DoubleLanes* e, DoubleLanes* f, double thickness, int doublings, int n,
                    ImpedanceWorkspace& work) {
    const int count = n * n;
    const double x = std::ldexp(thickness, -doublings - 1);
    DoubleLanes *factor = work.a.data(), *solved = work.b.data();

    // Z_a = (F x)^-1 + E x/3,  Z_s = E x - (E x) Z_a^-1 (E x)/3: tanh x = x/(1 + x^2/3).
    for (int i = 0; i < n; ++i) f[i * n + i] += splat(kMinDepth / x);
    invert_spd(f, solved, n);
    for (int i = 0; i < count; ++i) {
        e[i] *= x;
        f[i] = f[i] * (1.0 / x) + e[i] * (1.0 / 3.0);
    }
    copy(factor, f, count);
    copy(solved, e, count);
    cholesky(factor, n);
    forward_solve(factor, solved, n, n);
    add_gram(1.0, e, -1.0 / 3.0, solved, n, n);

    for (int k = 0; k < doublings; ++k) {
        for (int i = 0; i < count; ++i) {
            factor[i] = e[i] + f[i];
            f[i] = 0.5 * factor[i];
        }
        copy(solved, e, count);
        cholesky(factor, n);
        forward_solve(factor, solved, n, n);
        add_gram(2.0, e, -2.0, solved, n, n);
    }
}

void stack_on(const DoubleLanes* zs, const DoubleLanes* za, DoubleLanes* y, int n,
              ImpedanceWorkspace& work) {
    const int count = n * n;
    DoubleLanes *factor = work.a.data(), *solved = work.b.data();
    for (int i = 0; i < count; ++i) {
        solved[i] = y[i] + zs[i];
        factor[i] = solved[i] + 0.5 * (za[i] - zs[i]);
        y[i] = solved[i] + zs[i];
    }
    cholesky(factor, n);
    forward_solve(factor, solved, n, n);
    add_gram(1.0, y, -1.0, solved, n, n);
}

void impedance_to_reflection(DoubleLanes* y, int n, ImpedanceWorkspace& work) {
    for (int i = 0; i < n; ++i) y[i * n + i] += splat(1.0);
    invert_spd(y, work.b.data(), n);
    for (int i = 0; i < n * n; ++i) y[i] *= 2.0;
    for (int i = 0; i < n; ++i) y[i * n + i] -= splat(1.0);
}

void reflect_under_interface(DoubleLanes* r, const DoubleLanes* interface_reflectance,
                             DoubleLanes* u, int n, int rows, ImpedanceWorkspace& work) {
    DoubleLanes *factor = work.a.data(), *solved = work.b.data(), *root = work.c.data();
    for (int i = 0; i < n; ++i) root[i] = sqrt_lanes(interface_reflectance[i]);
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < n; ++j) factor[i * n + j] = -root[i] * r[i * n + j] * root[j];
        factor[i * n + i] += splat(1.0);
        for (int j = 0; j < rows; ++j) solved[i * rows + j] = root[i] * r[i * n + j];
    }
    for (int i = 0; i < rows; ++i) copy(u + i * rows, r + i * n, rows);
    cholesky(factor, n);
    forward_solve(factor, solved, n, rows);
    add_gram(1.0, u, 1.0, solved, n, rows);
}

}  // namespace nacre::solver
