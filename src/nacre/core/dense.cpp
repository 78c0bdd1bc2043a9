#include "nacre/core/dense.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <numeric>

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

ColumnInterpolation interpolative_decomposition(const Eigen::MatrixXd& a, int count) {
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(a);
    const Eigen::Index taken = std::min<Eigen::Index>(count, qr.rank()), all = a.cols();
    const auto& order = qr.colsPermutation().indices();  // of columns, as they were taken
    // A P = Q [R_1 R_2], so that the columns after the first ones are these times R_1^-1 R_2.
    const Eigen::MatrixXd rest = qr.matrixR()
                                     .topLeftCorner(taken, taken)
                                     .triangularView<Eigen::Upper>()
                                     .solve(qr.matrixR().topRightCorner(taken, all - taken));
    std::vector<Eigen::Index> rising(taken);
    std::iota(rising.begin(), rising.end(), Eigen::Index{0});
    std::sort(rising.begin(), rising.end(),
              [&](Eigen::Index i, Eigen::Index j) { return order[i] < order[j]; });
    ColumnInterpolation out{{}, Eigen::MatrixXd::Zero(taken, all)};
    for (Eigen::Index k = 0; k < taken; ++k) {
        const Eigen::Index i = rising[k];
        out.columns.push_back(order[i]);
        out.weights(k, order[i]) = 1;
        for (Eigen::Index j = taken; j < all; ++j) out.weights(k, order[j]) = rest(i, j - taken);
    }
    return out;
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
