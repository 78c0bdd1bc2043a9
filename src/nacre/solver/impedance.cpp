#include "nacre/solver/impedance.h"

#include <algorithm>
#include <cmath>

namespace nacre::solver {

namespace {

// Of a slab, in units of which a mode's half depth F x is at least: an empty slab, or one that is
// empty at some of the wavelengths, has F = 0 and no Z_a. Far below rounding of the results, and
// its inverse far from the largest number.
constexpr double kMinDepth = 1e-30;

// Calls body(element) for the elements of an n x n matrix on and below its diagonal, all that
// Cholesky factors are made from.
template <class Body>
void lower_triangle(int n, const Body& body) {
    for (int i = 0; i < n; ++i) {
        for (int at = i * n; at <= i * n + i; ++at) body(at);
    }
}

}  // namespace

int doublings_for(double largest_optical_depth) {
    // x <= 0.375 for modes of total optical depth d up to 6: relative error 1.8e-6 at 6, 3e-8 at 3,
    // as in all the half-thicknesses that follow. Those of deeper modes err more, but move Z less,
    // as it approaches its limit: d/2 sech^2(d/2) x^6/1575 is at most 5e-8. What opaque modes start
    // as matters only until their half-thickness 2^k 6/x is 16, where tanh is 1 to 3e-14.
    const double thin = std::log2(std::clamp(largest_optical_depth, 1e-300, 6.0) / 0.75);
    const double thick = 0.5 * std::log2(std::max(largest_optical_depth * 4 / 3, 1e-300));
    const double needed = largest_optical_depth > 6.0 ? std::max(thin, thick) : thin;
    return std::max(0, static_cast<int>(std::ceil(needed)));
}

void slab_impedance(DoubleLanes* e, DoubleLanes* f, double thickness, int doublings, int n,
                    ImpedanceWorkspace& work) {
    const double x = std::ldexp(thickness, -doublings - 1);
    DoubleLanes *factor = work.a.data(), *solved = work.b.data(), *second = work.c.data();

    // With a = E x and b = (F x)^-1, tanh x = x/(1 + x^2/(3 + x^2/5)) and its inverse:
    // Z_a = b + a/3 - a (5 b + a/3)^-1 a/9,  Z_s = a - a (3 b + 6 a/5)^-1 a.
    for (int i = 0; i < n; ++i) f[i * n + i] += splat(kMinDepth / x);
    invert_spd(f, solved, n);
    for (int i = 0; i < n * n; ++i) e[i] *= x;
    lower_triangle(n, [&](int i) {
        const DoubleLanes a = e[i], b = f[i] * (1.0 / x);
        f[i] = b + a * (1.0 / 3.0);
        factor[i] = 5.0 * b + a * (1.0 / 3.0);
        second[i] = 3.0 * b + 1.2 * a;
    });
    cholesky(factor, n);
    forward_solve(factor, e, solved, n, n);
    add_gram(1.0, f, -1.0 / 9.0, solved, n, n);
    cholesky(second, n);
    forward_solve(second, e, solved, n, n);
    add_gram(1.0, e, -1.0, solved, n, n);

    for (int k = 0; k < doublings; ++k) {
        lower_triangle(n, [&](int i) {
            factor[i] = e[i] + f[i];
            f[i] = 0.5 * factor[i];
        });
        cholesky(factor, n);
        forward_solve(factor, e, solved, n, n);
        add_gram(2.0, e, -2.0, solved, n, n);
    }
}

void stack_on(const DoubleLanes* zs, const DoubleLanes* za, DoubleLanes* y, int n,
              ImpedanceWorkspace& work) {
    DoubleLanes *factor = work.a.data(), *q = work.b.data();
    for (int i = 0; i < n * n; ++i) {
        q[i] = y[i] + zs[i];
        y[i] = q[i] + zs[i];
    }
    lower_triangle(n, [&](int i) { factor[i] = q[i] + 0.5 * (za[i] - zs[i]); });
    cholesky(factor, n);
    forward_solve(factor, q, q, n, n);
    add_gram(1.0, y, -1.0, q, n, n);
}

void impedance_to_reflection(DoubleLanes* y, int n, ImpedanceWorkspace& work) {
    for (int i = 0; i < n; ++i) y[i * n + i] += splat(1.0);
    invert_spd(y, work.b.data(), n);
    for (int i = 0; i < n * n; ++i) y[i] *= 2.0;
    for (int i = 0; i < n; ++i) y[i * n + i] -= splat(1.0);
}

void reflect_under_interface(const DoubleLanes* y, const DoubleLanes* interface_reflectance,
                             DoubleLanes* u, int n, int rows, ImpedanceWorkspace& work) {
    DoubleLanes *factor = work.a.data(), *last = work.b.data(), *inverse = work.c.data();
    // From the last node to the first: the factor of the inverse's block of the first `rows` nodes
    // is then the last block of the factor.
    for (int i = 0; i < n; ++i) {
        const int from = (n - 1 - i) * n + n - 1;
        for (int j = 0; j <= i; ++j) factor[i * n + j] = y[from - j];
        const DoubleLanes& f = interface_reflectance[n - 1 - i];
        factor[i * n + i] += (1.0 - f) / (1.0 + f);
    }
    cholesky(factor, n);
    for (int i = 0; i < rows; ++i) {
        std::copy_n(factor + (n - rows + i) * n + n - rows, i + 1, last + i * rows);
    }
    invert_factored(last, inverse, rows);
    for (int i = 0; i < rows; ++i) {
        const DoubleLanes row = 1.0 / (1.0 + interface_reflectance[i]);
        for (int j = 0; j < rows; ++j) {
            const DoubleLanes& at = last[(rows - 1 - i) * rows + rows - 1 - j];
            u[i * rows + j] = 2.0 * row * at / (1.0 + interface_reflectance[j]);
        }
        u[i * rows + i] -= row;
    }
}

}  // namespace nacre::solver
