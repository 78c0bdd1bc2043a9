#include "nacre/solver/lane_matrix.h"

#include <cstring>

namespace nacre::solver {

namespace {

using Tile = DoubleLanes[kTile][kTile];

void clear(Tile& t) { std::memset(&t, 0, sizeof t); }

// t += sum over k of a[i][k] b[k][j], a by rows with stride lda, b by rows with stride ldb.
inline void multiply_rows(Tile& t, const DoubleLanes* a, int lda, const DoubleLanes* b, int ldb,
                          int count) {
    for (int k = 0; k < count; ++k) {
        const DoubleLanes *bk = b + k * ldb, *ak = a + k;
        const DoubleLanes b0 = bk[0], b1 = bk[1], b2 = bk[2], b3 = bk[3];
        for (int i = 0; i < kTile; ++i) {
            const DoubleLanes ai = ak[i * lda];
            t[i][0] += ai * b0;
            t[i][1] += ai * b1;
            t[i][2] += ai * b2;
            t[i][3] += ai * b3;
        }
    }
}

// t += sum over k of a[i][k] b[j][k].
inline void multiply_transposed(Tile& t, const DoubleLanes* a, const DoubleLanes* b, int ld,
                                int count) {
    for (int k = 0; k < count; ++k) {
        const DoubleLanes b0 = b[k], b1 = b[k + ld], b2 = b[k + 2 * ld], b3 = b[k + 3 * ld];
        for (int i = 0; i < kTile; ++i) {
            const DoubleLanes ai = a[i * ld + k];
            t[i][0] += ai * b0;
            t[i][1] += ai * b1;
            t[i][2] += ai * b2;
            t[i][3] += ai * b3;
        }
    }
}

// t += sum over k of w[k][i] v[k][j].
inline void multiply_columns(Tile& t, const DoubleLanes* w, const DoubleLanes* v, int ld,
                             int count) {
    for (int k = 0; k < count; ++k, w += ld, v += ld) {
        const DoubleLanes v0 = v[0], v1 = v[1], v2 = v[2], v3 = v[3];
        for (int i = 0; i < kTile; ++i) {
            const DoubleLanes wi = w[i];
            t[i][0] += wi * v0;
            t[i][1] += wi * v1;
            t[i][2] += wi * v2;
            t[i][3] += wi * v3;
        }
    }
}

}  // namespace

void cholesky(DoubleLanes* a, int n) {
    Tile t;
    for (int J = 0; J < n; J += kTile) {
        for (int I = J; I < n; I += kTile) {
            clear(t);
            multiply_transposed(t, a + I * n, a + J * n, n, J);
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
            clear(t);
            multiply_rows(t, l + I * n + start, n, b + start * m + J, m, I - start);
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
            clear(t);
            multiply_columns(t, w + start * m + I, w + start * m + J, m, n - start);
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

void invert_spd(DoubleLanes* a, DoubleLanes* work, int n) {
    cholesky(a, n);
    std::memset(work, 0, sizeof(DoubleLanes) * n * n);
    for (int i = 0; i < n; ++i) work[i * n + i] = splat(1.0);
    const auto identity = [](int J) { return J; };
    forward_solve_from(a, work, n, n, identity);
    add_gram_from(0.0, a, 1.0, work, n, n, identity);
}

}  // namespace nacre::solver
