#include "nacre/core/dense.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <numeric>
#include <utility>

#include "nacre/core/parallel.h"

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

Eigen::MatrixXd gram_matrix(const RowMajorView& a) {
    // Of so many rows at least each, and not of fewer for more threads, which would round otherwise.
    constexpr Eigen::Index kRows = 2048, kMaxPieces = 16;
    const Eigen::Index pieces = std::clamp<Eigen::Index>(a.rows() / kRows, 1, kMaxPieces);
    std::vector<Eigen::MatrixXd> sums(pieces, Eigen::MatrixXd::Zero(a.cols(), a.cols()));
    parallel_for(0, sums.size(), [&](std::size_t k) {
        const auto from = [&](Eigen::Index piece) { return a.rows() * piece / pieces; };
        const auto piece = static_cast<Eigen::Index>(k);
        const auto rows = a.middleRows(from(piece), from(piece + 1) - from(piece));
        sums[k].selfadjointView<Eigen::Lower>().rankUpdate(rows.transpose());
    });
    for (std::size_t k = 1; k < sums.size(); ++k) sums[0] += sums[k];
    return sums[0].selfadjointView<Eigen::Lower>();
}

Eigen::MatrixXd right_singular_vectors(RowMajorMatrix a) {
    // Rounding of A^T A, 1e-16 of its largest eigenvalue, hides singular values below 1e-8 of the
    // largest. So those above 1e-4 lead, and the others are taken from what these leave of each row.
    // There the span of those that lead is given eigenvalues larger than all others, so that all
    // vectors together are orthonormal.
    const Eigen::Index columns = a.cols();
    const SymmetricEigen all = symmetric_eigen(gram_matrix(a));
    const double least = 1e-8 * all.values[columns - 1];
    const Eigen::Index leading = (all.values.array() > least).count(), others = columns - leading;
    const Eigen::MatrixXd lead = all.vectors.rightCols(leading).rowwise().reverse();
    const RowMajorMatrix along = a * lead;
    a.noalias() -= along * lead.transpose();
    const SymmetricEigen rest =
        symmetric_eigen(gram_matrix(a) + 4 * least * lead * lead.transpose());
    Eigen::MatrixXd vectors(columns, columns);
    vectors.leftCols(leading) = lead;
    vectors.rightCols(others) = rest.vectors.leftCols(others).rowwise().reverse();
    return vectors;
}

}  // namespace nacre
