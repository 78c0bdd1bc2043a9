#include "nacre/solver/lane_matrix.h"

#include <cmath>
#include <cstring>
#include <type_traits>

#include "nacre/solver/lane_registers.h"

namespace nacre::solver {

namespace {

using Tile = DoubleLanes[kTile][kTile];

// How many columns have their sums in registers at the same time, of kTile rows each: AVX-512 has 32
// registers, others 16. Fewer sums would wait for their own additions.
constexpr int kColumns = kRegisterLanes == 8 ? 4 : 3;

template <int columns>
using Sums = Register[kTile][columns];

// Calls body(width, j) for columns j to j + width of a multiple of four of them: kColumns at once, and
// two where that would leave one.
template <class Body>
[[gnu::always_inline]] inline void by_columns(int begin, int end, const Body& body) {
    int j = begin;
    while (end - j >= kColumns && end - j != kColumns + 1) {
        body(std::integral_constant<int, kColumns>{}, j);
        j += kColumns;
    }
    for (; j < end; j += 2) body(std::integral_constant<int, 2>{}, j);
}

// Columns of a matrix product, its factors read along k by steps of their own:
// sum[i][c] = sum over k of a[i * a_row + k * a_step] b[c * b_column + k * b_step].
template <int columns, class B>
[[gnu::always_inline]] inline void multiply(Sums<columns>& sum, const DoubleLanes* a, int a_row,
                                            int a_step, const B* b, int b_column, int b_step,
                                            int count, int part) {
#pragma GCC unroll 4
    for (int i = 0; i < kTile; ++i) {
#pragma GCC unroll 4
        for (int c = 0; c < columns; ++c) sum[i][c] = Register{};
    }
    for (int k = 0; k < count; ++k, a += a_step, b += b_step) {
        Register column[columns];
#pragma GCC unroll 4
        for (int c = 0; c < columns; ++c) column[c] = load(b + c * b_column, part);
#pragma GCC unroll 4
        for (int i = 0; i < kTile; ++i) {
            const Register row = load(a + i * a_row, part);
#pragma GCC unroll 4
            for (int c = 0; c < columns; ++c) sum[i][c] += row * column[c];
        }
    }
}

// The whole tile.
template <class B>
inline void multiply(Tile& t, const DoubleLanes* a, int a_row, int a_step, const B* b, int b_column,
                     int b_step, int count) {
    for (int part = 0; part < kRegisters; ++part) {
        by_columns(0, kTile, [&](auto width, int j) {
            Sums<width> sum;
            multiply<width>(sum, a, a_row, a_step, b + j * b_column, b_column, b_step, count, part);
            for (int i = 0; i < kTile; ++i) {
                for (int c = 0; c < width; ++c) store(sum[i][c], &t[i][j + c], part);
            }
        });
    }
}

// Where elements of a matrix stand, that is read as it is or transposed.
struct Strides {
    int row, column;
};

// kTile rows of columns of X = L^-1 B, which may stand in its place: `l` are its rows of L and `solved`
// its columns of X, both from the first of `count` rows of X that are known; `diagonal` is the tile of L
// to solve with.
template <int columns>
inline void substitute(const DoubleLanes* l, const DoubleLanes* diagonal, int n,
                       const DoubleLanes* solved, int count, const DoubleLanes* b, DoubleLanes* to,
                       Strides at) {
    for (int part = 0; part < kRegisters; ++part) {
        Sums<columns> x;
        multiply<columns>(x, l, n, 1, solved, at.column, at.row, count, part);
#pragma GCC unroll 4
        for (int i = 0; i < kTile; ++i) {
#pragma GCC unroll 4
            for (int c = 0; c < columns; ++c) {
                const int element = i * at.row + c * at.column;
                x[i][c] = load(b + element, part) - x[i][c];
#pragma GCC unroll 4
                for (int k = 0; k < i; ++k) x[i][c] -= load(diagonal + i * n + k, part) * x[k][c];
                x[i][c] *= load(diagonal + i * n + i, part);
                store(x[i][c], to + element, part);
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
        by_columns(J + kTile, n, [&](auto width, int i) {
            DoubleLanes* const to = a + i * n + J;
            substitute<width>(rows, rows + J, n, a + i * n, J, to, to, {.row = 1, .column = n});
        });
    }
}

namespace {

// X = L^-1 B, where B is zero above the row first_row(j) in column j and those after it.
template <class FirstRow>
void forward_solve_from(const DoubleLanes* l, const DoubleLanes* b, DoubleLanes* x, int n, int m,
                        FirstRow first_row) {
    by_columns(0, m, [&](auto width, int j) {
        const int start = first_row(j) / kTile * kTile;
        for (int I = start; I < n; I += kTile) {
            substitute<width>(l + I * n + start, l + I * n + I, n, x + start * m + j, I - start,
                              b + I * m + j, x + I * m + j, {.row = m, .column = 1});
        }
    });
}

// C := a C + g W^T W; rows of W above first_row(j) are zero in column j and those after it.
template <class FirstRow>
void add_gram_from(double a, DoubleLanes* c, double g, const DoubleLanes* w, int n, int m,
                   FirstRow first_row) {
    for (int I = 0; I < m; I += kTile) {
        const int start = first_row(I);  // I >= j, so column I starts no earlier than column j
        const DoubleLanes* const rows = w + start * m;
        by_columns(0, I + kTile, [&](auto width, int j) {
            for (int part = 0; part < kRegisters; ++part) {
                constexpr int columns = width;
                Sums<columns> sum;
                multiply<columns>(sum, rows + I, 1, m, rows + j, 1, m, n - start, part);
#pragma GCC unroll 4
                for (int i = 0; i < kTile; ++i) {
#pragma GCC unroll 4
                    for (int k = 0; k < columns; ++k) {
                        DoubleLanes* const at = c + (I + i) * m + j + k;
                        Register x = g * sum[i][k];
                        if (a != 0) x += a * load(at, part);
                        store(x, at, part);
                    }
                }
            }
        });
        for (int i = I; i < I + kTile; ++i) {
            for (int j = 0; j < i; ++j) c[j * m + i] = c[i * m + j];
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
