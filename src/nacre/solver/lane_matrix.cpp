#include "nacre/solver/lane_matrix.h"

#include <cstring>

#include "nacre/solver/lane_registers.h"

namespace nacre::solver {

namespace {

using Tile = DoubleLanes[kTile][kTile];

// How many columns of a tile have their sums in registers at the same time: AVX-512 has 32 of them,
// others 16.
constexpr int kColumns = kRegisterLanes == 8 ? 4 : 2;

// A tile of a matrix product, its factors read along k by steps of their own:
// t[i][j] = sum over k of a[i * a_row + k * a_step] b[j * b_column + k * b_step].
template <class B>
inline void multiply(Tile& t, const DoubleLanes* a, int a_row, int a_step, const B* b, int b_column,
                     int b_step, int count) {
    for (int part = 0; part < kRegisters; ++part) {
        for (int j = 0; j < kTile; j += kColumns) {
            Register sum[kTile][kColumns] = {};
            const DoubleLanes* ak = a;
            const B* bk = b + j * b_column;
            for (int k = 0; k < count; ++k, ak += a_step, bk += b_step) {
                Register column[kColumns];
#pragma GCC unroll 4
                for (int c = 0; c < kColumns; ++c) column[c] = load(bk + c * b_column, part);
#pragma GCC unroll 4
                for (int i = 0; i < kTile; ++i) {
                    const Register row = load(ak + i * a_row, part);
#pragma GCC unroll 4
                    for (int c = 0; c < kColumns; ++c) sum[i][c] += row * column[c];
                }
            }
            for (int i = 0; i < kTile; ++i) {
                for (int c = 0; c < kColumns; ++c) {
                    store(sum[i][c], &t[i][j + c], part);
                }
            }
        }
    }
}

}  // namespace

void cholesky(DoubleLanes* a, int n) {
    Tile t;
    for (int J = 0; J < n; J += kTile) {
        for (int I = J; I < n; I += kTile) {
            multiply(t, a + I * n, n, 1, a + J * n, n, 1, J);
            for (int i = 0; i < kTile; ++i) {
                DoubleLanes* row = a + (I + i) * n + J;
                for (int j = 0; j < kTile; ++j) t[i][j] = row[j] - t[i][j];
            }
            if (I == J) {
                for (int j = 0; j < kTile; ++j) {
                    DoubleLanes d = t[j][j];
                    for (int k = 0; k < j; ++k) d -= t[j][k] * t[j][k];
                    const DoubleLanes inverse = splat(1.0) / sqrt_lanes(d);
                    t[j][j] = inverse;
                    for (int i = j + 1; i < kTile; ++i) {
                        DoubleLanes x = t[i][j];
                        for (int k = 0; k < j; ++k) x -= t[i][k] * t[j][k];
                        t[i][j] = x * inverse;
                    }
                }
                for (int i = 0; i < kTile; ++i) {
                    for (int j = 0; j <= i; ++j) a[(I + i) * n + J + j] = t[i][j];
                }
            } else {
                const DoubleLanes* diagonal = a + J * n + J;
                for (int j = 0; j < kTile; ++j) {
                    for (int i = 0; i < kTile; ++i) {
                        DoubleLanes x = t[i][j];
                        for (int k = 0; k < j; ++k) x -= t[i][k] * diagonal[j * n + k];
                        t[i][j] = x * diagonal[j * n + j];
                    }
                }
                for (int i = 0; i < kTile; ++i) {
                    std::memcpy(a + (I + i) * n + J, t[i], sizeof t[i]);
                }
            }
        }
    }
}

namespace {

// The rows of L^-1 B from block column `first_row(J)` on; B is zero above it there.
template <class FirstRow>
void forward_solve_from(const DoubleLanes* l, DoubleLanes* b, int n, int m, FirstRow first_row) {
    Tile t;
    for (int J = 0; J < m; J += kTile) {
        const int start = first_row(J);
        for (int I = start; I < n; I += kTile) {
            multiply(t, l + I * n + start, n, 1, b + start * m + J, 1, m, I - start);
            const DoubleLanes* diagonal = l + I * n + I;
            for (int i = 0; i < kTile; ++i) {
                DoubleLanes* row = b + (I + i) * m + J;
                for (int j = 0; j < kTile; ++j) {
                    DoubleLanes x = row[j] - t[i][j];
                    for (int k = 0; k < i; ++k) x -= diagonal[i * n + k] * t[k][j];
                    t[i][j] = x * diagonal[i * n + i];
                }
                std::memcpy(row, t[i], sizeof t[i]);
            }
        }
    }
}

// C := a C + g W^T W; rows of W above first_row(J) are zero in block column J.
template <class FirstRow>
void add_gram_from(double a, DoubleLanes* c, double g, const DoubleLanes* w, int n, int m,
                   FirstRow first_row) {
    Tile t;
    for (int I = 0; I < m; I += kTile) {
        const int start = first_row(I);  // I >= J, so block I starts no earlier than block J
        for (int J = 0; J <= I; J += kTile) {
            multiply(t, w + start * m + I, 1, m, w + start * m + J, 1, m, n - start);
            for (int i = 0; i < kTile; ++i) {
                for (int j = 0; j < kTile; ++j) {
                    if (I == J && j > i) continue;
                    DoubleLanes x = g * t[i][j];
                    if (a != 0) x += a * c[(I + i) * m + J + j];
                    c[(I + i) * m + J + j] = x;
                    c[(J + j) * m + I + i] = x;
                }
            }
        }
    }
}

}  // namespace

void forward_solve(const DoubleLanes* l, DoubleLanes* b, int n, int m) {
    forward_solve_from(l, b, n, m, [](int) { return 0; });
}

void add_gram(double a, DoubleLanes* c, double g, const DoubleLanes* w, int n, int m) {
    add_gram_from(a, c, g, w, n, m, [](int) { return 0; });
}

void multiply(const DoubleLanes* a, const double* b, DoubleLanes* c, int n, int m) {
    Tile t;
    for (int I = 0; I < n; I += kTile) {
        for (int J = 0; J < m; J += kTile) {
            multiply(t, a + I * n, n, 1, b + J, 1, m, n);
            for (int i = 0; i < kTile; ++i) {
                std::memcpy(c + (I + i) * m + J, t[i], sizeof t[i]);
            }
        }
    }
}

void multiply_transposed(const double* b, const DoubleLanes* a, DoubleLanes* c, int n, int m) {
    Tile t;
    for (int I = 0; I < m; I += kTile) {
        for (int J = 0; J <= I; J += kTile) {
            multiply(t, a + J, 1, m, b + I, 1, m, n);
            for (int i = 0; i < kTile; ++i) {
                for (int j = 0; j < kTile; ++j) c[(I + i) * m + J + j] = t[j][i];
            }
        }
    }
}

void invert_spd(DoubleLanes* a, DoubleLanes* work, int n) {
    cholesky(a, n);
    std::memset(work, 0, sizeof(DoubleLanes) * n * n);
    for (int i = 0; i < n; ++i) work[i * n + i] = splat(1.0);
    const auto identity = [](int J) { return J; };
    forward_solve_from(a, work, n, n, identity);
    add_gram_from(0.0, a, 1.0, work, n, n, identity);
}

}  // namespace nacre::solver
