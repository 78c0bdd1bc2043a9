#include "nacre/core/dense.h"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <cmath>
#include <random>

namespace nacre {
namespace {

// The orthonormal factor of a matrix of random numbers.
Eigen::MatrixXd orthonormal_columns(int rows, int columns, unsigned seed) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const Eigen::MatrixXd a =
        Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return uniform(engine); });
    return Eigen::HouseholderQR<Eigen::MatrixXd>(a).householderQ() *
           Eigen::MatrixXd::Identity(rows, columns);
}

constexpr int kRows = 3000, kColumns = 12;

TEST(RightSingularVectors, AreTrueFarBelowTheRoundingOfProducts) {
    // U S V^T with singular values 1, 0.1 and so on.
    const Eigen::MatrixXd u = orthonormal_columns(kRows, kColumns, 1),
                          v = orthonormal_columns(kColumns, kColumns, 2);
    Eigen::VectorXd s(kColumns);
    for (int k = 0; k < kColumns; ++k) s[k] = std::pow(0.1, k);
    const RowMajorMatrix a = u * s.asDiagonal() * v.transpose();

    const Eigen::MatrixXd found = right_singular_vectors(a);
    EXPECT_LT((found.transpose() * found - Eigen::MatrixXd::Identity(kColumns, kColumns))
                  .cwiseAbs()
                  .maxCoeff(),
              1e-11);
    // A row holds 1e-16 of its largest value, 1e-5 of what has a singular value of 1e-11.
    for (int k = 0; k < kColumns; ++k) {
        EXPECT_NEAR(std::abs(found.col(k).dot(v.col(k))), 1, 1e-6) << k;
    }
    // The matrix of products alone knows nothing of the last ones.
    const Eigen::MatrixXd of_products = symmetric_eigen(gram_matrix(a)).vectors;
    EXPECT_LT(std::abs(of_products.col(0).dot(v.col(kColumns - 1))), 0.99);
}

TEST(RightSingularVectors, OfFewerDimensionsThanColumnsLeadAllOthers) {
    const RowMajorMatrix a =
        orthonormal_columns(kRows, 2, 3) * orthonormal_columns(kColumns, 2, 4).transpose();
    const Eigen::MatrixXd found = right_singular_vectors(a);
    EXPECT_LT((a * found.rightCols(kColumns - 2)).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_LT((found.transpose() * found - Eigen::MatrixXd::Identity(kColumns, kColumns))
                  .cwiseAbs()
                  .maxCoeff(),
              1e-11);
}

TEST(RightSingularVectors, OfNothingAreOrthonormal) {
    const Eigen::MatrixXd found = right_singular_vectors(RowMajorMatrix::Zero(kRows, kColumns));
    EXPECT_LT((found.transpose() * found - Eigen::MatrixXd::Identity(kColumns, kColumns))
                  .cwiseAbs()
                  .maxCoeff(),
              1e-14);
}

}  // namespace
}  // namespace nacre
