#pragma once

#include <Eigen/Core>
#include <vector>

// Decompositions and products of dense matrices: the only user of the parts of Eigen that take the
// compiler seconds, so that they are compiled once.

namespace nacre {

/// As arrays in C++ are stored, one row after the other.
using RowMajorMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

struct SymmetricEigen {
    Eigen::VectorXd values;   ///< rising
    Eigen::MatrixXd vectors;  ///< orthonormal, as columns
};

/// Of a symmetric matrix, of which the lower triangle is read.
SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& a);

/// Of the symmetric tridiagonal matrix with `beside` (one shorter) above and below its diagonal.
SymmetricEigen tridiagonal_eigen(const Eigen::VectorXd& diagonal, const Eigen::VectorXd& beside);

/// A^-1 and A^-1/2 of a symmetric positive definite matrix.
RowMajorMatrix inverse_of_positive_definite(const RowMajorMatrix& a);
RowMajorMatrix inverse_square_root(const Eigen::MatrixXd& a);

/// Some columns of a matrix, and how all are combined from them: A is nearly A_S C.
struct ColumnInterpolation {
    std::vector<int> columns;  ///< S, rising
    Eigen::MatrixXd weights;   ///< C [column of S][column]; of a column of S itself 1
};

/// By a QR decomposition that takes the largest of the remaining columns first.  [cheng-2005]
/// @param count  columns to take; as many as the rank, if that is less
ColumnInterpolation interpolative_decomposition(const Eigen::MatrixXd& a, int count);

/// A B, A B^T and A^T A.
using RowMajorView = Eigen::Ref<const RowMajorMatrix>;
RowMajorMatrix product(const RowMajorView& a, const RowMajorView& b);
RowMajorMatrix product_with_transposed(const RowMajorView& a, const RowMajorView& b);
Eigen::MatrixXd gram_matrix(const RowMajorView& a);
/// The right singular vectors of A as columns, those of the largest singular values first: the
/// eigenvectors of A^T A, which is small where A has many more rows than columns, in two steps that
/// also find those of singular values down to 1e-12 of the largest.
Eigen::MatrixXd right_singular_vectors(RowMajorMatrix a);
/// Adds A B^T.
void add_product_with_transposed(RowMajorMatrix& to, const RowMajorView& a, const RowMajorView& b);

}  // namespace nacre
