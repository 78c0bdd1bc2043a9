#include "nacre/solver/lane_matrix.h"

#include <cmath>
#include <cstring>

#include "nacre/solver/lane_registers.h"

namespace nacre::solver {

namespace {

using Tile = DoubleLanes[kTile][kTile];

// How many columns of a tile have their sums in registers at the same time: AVX-512 has 32 of them,
// others 16.
constexpr int kColumns = kRegisterLanes == 8 ? 4 : 2;

using Sums = Register[kTile][kColumns];

// Columns of a tile of a matrix product, its factors read along k by steps of their own:
// sum[i][c] = sum over k of a[i * a_row + k * a_step] b[c * b_column + k * b_step].
template <class B>
[[gnu::always_inline]] inline void multiply(Sums& sum, const DoubleLanes* a, int a_row, int a_step,
                                            const B* b, int b_column, int b_step, int count,
                                            int part) {
#pragma GCC unroll 4
    for (int i = 0; i < kTile; ++i) {
#pragma GCC unroll 4
        for (int c = 0; c < kColumns; ++c) sum[i][c] = Register{};
    }
    for (int k = 0; k < count; ++k, a += a_step, b += b_step) {
        Register column[kColumns];
#pragma GCC unroll 4
        for (int c = 0; c < kColumns; ++c) column[c] = load(b + c * b_column, part);
#pragma GCC unroll 4
        for (int i = 0; i < kTile; ++i) {
            const Register row = load(a + i * a_row, part);
#pragma GCC unroll 4
            for (int c = 0; c < kColumns; ++c) sum[i][c] += row * column[c];
        }
    }
}

// The whole tile.
template <class B>
inline void multiply(Tile& t, const DoubleLanes* a, int a_row, int a_step, const B* b, int b_column,
                     int b_step, int count) {
    for (int part = 0; part < kRegisters; ++part) {
        for (int j = 0; j < kTile; j += kColumns) {
            Sums sum;
            multiply(sum, a, a_row, a_step, b + j * b_column, b_column, b_step, count, part);
            for (int i = 0; i < kTile; ++i) {
                for (int c = 0; c < kColumns; ++c) {
                    store(sum[i][c], &t[i][j + c], part);
                }
            }
        }
    }
}

// Where elements of a matrix stand, that is read as it is or transposed.
struct Strides {
    int row, column;
};

// A tile of X = L^-1 B, which may stand in its place: `l` are its rows of L and `solved` its columns of
// X, both from the first of `count` rows of X that are known; `diagonal` is the tile of L to solve
// with.
inline void substitute(const DoubleLanes* l, const DoubleLanes* diagonal, int n,
                       const DoubleLanes* solved, int count, const DoubleLanes* b, DoubleLanes* to,
                       Strides at) {
    for (int part = 0; part < kRegisters; ++part) {
        for (int j = 0; j < kTile; j += kColumns) {
            Sums x;
            multiply(x, l, n, 1, solved + j * at.column, at.column, at.row, count, part);
#pragma GCC unroll 4
            for (int i = 0; i < kTile; ++i) {
#pragma GCC unroll 4
                for (int c = 0; c < kColumns; ++c) {
                    const int element = i * at.row + (j + c) * at.column;
                    x[i][c] = load(b + element, part) - x[i][c];
#pragma GCC unroll 4
                    for (int k = 0; k < i; ++k) {
                        x[i][c] -= load(diagonal + i * n + k, part) * x[k][c];
                    }
                    x[i][c] *= load(diagonal + i * n + i, part);
                    store(x[i][c], to + element, part);
                }
            }
        }
    }
}

Register sqrt_register(Register a) {
    for (int i = 0; i < kRegisterLanes; ++i) a[i] = std::sqrt(a[i]);
    return a;
}

// A tile on the diagonal of a Cholesky factor, whose rows are known in the `count` columns from `l`.
inline void factor(const DoubleLanes* l, int n, int count, DoubleLanes* diagonal) {
    for (int part = 0; part < kRegisters; ++part) {
        Register t[kTile][kTile] = {};
        for (int k = 0; k < count; ++k) {
            Register row[kTile];
#pragma GCC unroll 4
            for (int i = 0; i < kTile; ++i) {
                row[i] = load(l + i * n + k, part);
#pragma GCC unroll 4
                for (int j = 0; j <= i; ++j) t[i][j] += row[i] * row[j];
            }
        }
#pragma GCC unroll 4
        for (int j = 0; j < kTile; ++j) {
#pragma GCC unroll 4
            for (int i = j; i < kTile; ++i) {
                t[i][j] = load(diagonal + i * n + j, part) - t[i][j];
#pragma GCC unroll 4
                for (int k = 0; k < j; ++k) t[i][j] -= t[i][k] * t[j][k];
                t[i][j] = i == j ? 1 / sqrt_register(t[i][j]) : t[i][j] * t[j][j];
                store(t[i][j], diagonal + i * n + j, part);
            }
        }
    }
}

}  // namespace

void cholesky(DoubleLanes* a, int n) {
    for (int J = 0; J < n; J += kTile) {
        const DoubleLanes* const rows = a + J * n;
        factor(rows, n, J, a + J * n + J);
        // Below, L_IJ^T = L_JJ^-1 (A_IJ^T - sum of L_JK L_IK^T).
        for (int I = J + kTile; I < n; I += kTile) {
            DoubleLanes* const tile = a + I * n + J;
            substitute(rows, rows + J, n, a + I * n, J, tile, tile, {.row = 1, .column = n});
        }
    }
}

namespace {

// The rows of X = L^-1 B from block column `first_row(J)` on; B is zero above it there.
template <class FirstRow>
void forward_solve_from(const DoubleLanes* l, const DoubleLanes* b, DoubleLanes* x, int n, int m,
                        FirstRow first_row) {
    for (int J = 0; J < m; J += kTile) {
        const int start = first_row(J);
        for (int I = start; I < n; I += kTile) {
            substitute(l + I * n + start, l + I * n + I, n, x + start * m + J, I - start,
                       b + I * m + J, x + I * m + J, {.row = m, .column = 1});
        }
    }
}

// C := a C + g W^T W; rows of W above first_row(J) are zero in block column J.
template <class FirstRow>
void add_gram_from(double a, DoubleLanes* c, double g, const DoubleLanes* w, int n, int m,
                   FirstRow first_row) {
    for (int I = 0; I < m; I += kTile) {
        const int start = first_row(I);  // I >= J, so block I starts no earlier than block J
        const DoubleLanes* const rows = w + start * m;
        for (int J = 0; J <= I; J += kTile) {
            for (int part = 0; part < kRegisters; ++part) {
                for (int j = J; j < J + kTile; j += kColumns) {
                    Sums sum;
                    multiply(sum, rows + I, 1, m, rows + j, 1, m, n - start, part);
#pragma GCC unroll 4
                    for (int i = 0; i < kTile; ++i) {
#pragma GCC unroll 4
                        for (int k = 0; k < kColumns; ++k) {
                            DoubleLanes* const at = c + (I + i) * m + j + k;
                            Register x = g * sum[i][k];
                            if (a != 0) x += a * load(at, part);
                            store(x, at, part);
                        }
                    }
                }
            }
            for (int i = 0; i < kTile; ++i) {
                for (int j = 0; j < kTile; ++j) {
                    if (J + j < I + i) c[(J + j) * m + I + i] = c[(I + i) * m + J + j];
                }
            }
        }
    }
}

}  // namespace

void forward_solve(const DoubleLanes* l, const DoubleLanes* b, DoubleLanes* x, int n, int m) {
    forward_solve_from(l, b, x, n, m, [](int) { return 0; });
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
    invert_factored(a, work, n);
}

void invert_factored(DoubleLanes* a, DoubleLanes* work, int n) {
    std::memset(work, 0, sizeof(DoubleLanes) * n * n);
    for (int i = 0; i < n; ++i) work[i * n + i] = splat(1.0);
    const auto identity = [](int J) { return J; };
    forward_solve_from(a, work, work, n, n, identity);
    add_gram_from(0.0, a, 1.0, work, n, n, identity);
}

}  // namespace nacre::solver
