#pragma once

#include <vector>

#include "nacre/core/lanes.h"

// Small dense matrices of eight wavelengths at once: every element is eight numbers, every
// operation on the matrix is done for eight wavelengths. n and m are multiples of kTile, storage is
// row-major, and the inner kernels keep a kTile x kTile block of results in registers.
//
// All matrices to be factored here are symmetric and positive definite by construction (see
// impedance.h), so there is no pivoting and every wavelength takes the same path.

namespace nacre::solver {

inline constexpr int kTile = 4;

using LaneBuffer = std::vector<DoubleLanes>;

/// Lower Cholesky factor in place, A = L L^T, with 1/L_ii on the diagonal. Reads the lower
/// triangle; what stands above the diagonal blocks is left as it was.
void cholesky(DoubleLanes* a, int n);

/// X := L^-1 B for an n x m matrix B, with L from cholesky(); X may be B.
void forward_solve(const DoubleLanes* l, const DoubleLanes* b, DoubleLanes* x, int n, int m);

/// C := a C + g W^T W for an n x m matrix W and a symmetric m x m matrix C, both triangles written.
void add_gram(double a, DoubleLanes* c, double g, const DoubleLanes* w, int n, int m);

/// C := A B for an n x n matrix A and an n x m matrix B of numbers that all wavelengths share.
void multiply(const DoubleLanes* a, const double* b, DoubleLanes* c, int n, int m);
/// C := B^T A, where that is symmetric: the tiles on and below its diagonal. A and B are n x m.
void multiply_transposed(const double* b, const DoubleLanes* a, DoubleLanes* c, int n, int m);

/// A := A^-1 for a symmetric positive definite matrix; `work` holds n * n elements.
void invert_spd(DoubleLanes* a, DoubleLanes* work, int n);
/// The same from the factor of A that cholesky() left in its place.
void invert_factored(DoubleLanes* a, DoubleLanes* work, int n);

}  // namespace nacre::solver
