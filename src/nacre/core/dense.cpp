#include "nacre/core/dense.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

namespace nacre {

using Solver = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>;

SymmetricEigen symmetric_eigen(const Eigen::MatrixXd& a) {
    const Solver solver(a);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

SymmetricEigen tridiagonal_eigen(const Eigen::VectorXd& diagonal, const Eigen::VectorXd& beside) {
    Solver solver;
    solver.computeFromTridiagonal(diagonal, beside);
    return {solver.eigenvalues(), solver.eigenvectors()};
}

RowMajorMatrix inverse_of_positive_definite(const RowMajorMatrix& a) {
    return Eigen::LLT<RowMajorMatrix>(a).solve(RowMajorMatrix::Identity(a.rows(), a.cols()));
}

RowMajorMatrix inverse_square_root(const Eigen::MatrixXd& a) {
    return Solver(a).operatorInverseSqrt();
}

RowMajorMatrix product(const RowMajorView& a, const RowMajorView& b) { return a * b; }

RowMajorMatrix product_with_transposed(const RowMajorView& a, const RowMajorView& b) {
    return a * b.transpose();
}

void add_product_with_transposed(RowMajorMatrix& to, const RowMajorView& a, const RowMajorView& b) {
    to.noalias() += a * b.transpose();
}

Eigen::MatrixXd gram_matrix(const RowMajorView& a) { return a.transpose() * a; }

}  // namespace nacre
