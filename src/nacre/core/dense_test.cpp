#include "nacre/core/dense.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

// Products are those of the header: Eigen's own would be compiled here once more.

namespace nacre {
namespace {

constexpr int kRows = 3000, kColumns = 12;

// The first columns of the discrete cosine transform of so many rows: orthonormal.
RowMajorMatrix cosines(int rows, int columns) {
    RowMajorMatrix out(rows, columns);
    for (int i = 0; i < rows; ++i) {
        for (int k = 0; k < columns; ++k) {
            out(i, k) = std::sqrt((k ? 2.0 : 1.0) / rows) *
                        std::cos(std::numbers::pi * (i + 0.5) * k / rows);
        }
    }
    return out;
}

double largest(const RowMajorView& a) { return a.cwiseAbs().maxCoeff(); }

// What A^T A differs from the identity by.
double error_of_orthonormal(const RowMajorView& a) {
    return largest(gram_matrix(a) - Eigen::MatrixXd::Identity(a.cols(), a.cols()));
}

TEST(RightSingularVectors, AreTrueFarBelowTheRoundingOfProducts) {
    // U S V^T with singular values 1, 0.1 and so on.
    RowMajorMatrix us = cosines(kRows, kColumns);
    const RowMajorMatrix v = cosines(kColumns, kColumns);
    for (int k = 0; k < kColumns; ++k) us.col(k) *= std::pow(0.1, k);
    const RowMajorMatrix a = product_with_transposed(us, v);

    const Eigen::MatrixXd found = right_singular_vectors(a);
    EXPECT_LT(error_of_orthonormal(found), 1e-11);
    // A row holds 1e-16 of its largest value, 1e-5 of what has a singular value of 1e-11.
    for (int k = 0; k < kColumns; ++k) {
        EXPECT_NEAR(std::abs(found.col(k).dot(v.col(k))), 1, 1e-6) << k;
    }
    // The matrix of products alone knows nothing of the last ones.
    const Eigen::MatrixXd of_products = symmetric_eigen(gram_matrix(a)).vectors;
    EXPECT_LT(std::abs(of_products.col(0).dot(v.col(kColumns - 1))), 0.99);
}

TEST(RightSingularVectors, OfFewerDimensionsThanColumnsLeadAllOthers) {
    const RowMajorMatrix a = product_with_transposed(cosines(kRows, 2), cosines(kColumns, 2));
    const Eigen::MatrixXd found = right_singular_vectors(a);
    EXPECT_LT(largest(product(a, found.rightCols(kColumns - 2))), 1e-14);
    EXPECT_LT(error_of_orthonormal(found), 1e-11);
}

TEST(RightSingularVectors, OfNothingAreOrthonormal) {
    const Eigen::MatrixXd found = right_singular_vectors(RowMajorMatrix::Zero(kRows, kColumns));
    EXPECT_LT(error_of_orthonormal(found), 1e-14);
}

}  // namespace
}  // namespace nacre
