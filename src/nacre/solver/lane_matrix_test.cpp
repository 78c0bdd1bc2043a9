#include "nacre/solver/lane_matrix.h"

#include <gtest/gtest.h>

#include <Eigen/Core>

#include "nacre/testing/dense.h"
#include "nacre/testing/layers.h"

namespace nacre::solver {
namespace {

using test::Matrices;

// Eight symmetric positive definite matrices, each with a condition number of its own.
Matrices random_spd(int n, unsigned seed) {
    Matrices all = test::random_matrices(n, n, seed);
    for (int lane = 0; lane < kLanes; ++lane) {
        all[lane] = test::product(all[lane], all[lane].transpose()) / n;
        all[lane].diagonal().array() += std::pow(10.0, -lane);
    }
    return all;
}

class LaneMatrix : public testing::TestWithParam<int> {};

TEST_P(LaneMatrix, CholeskyMatchesEigenInEveryLane) {
    const int n = GetParam();
    const Matrices a = random_spd(n, 1);
    LaneBuffer factor = test::to_lanes(a);
    cholesky(factor.data(), n);
    const Matrices found = test::from_lanes(factor, n, n);
    for (int lane = 0; lane < kLanes; ++lane) {
        Eigen::MatrixXd l = test::cholesky(a[lane]);
        l.diagonal() = l.diagonal().cwiseInverse().eval();  // the header: 1/L_ii is stored
        const Eigen::MatrixXd lower = found[lane].triangularView<Eigen::Lower>();
        // Rounding grows with the condition number, up to 1e8 in the last lane.
        EXPECT_LT((lower - l).norm(), 1e-14 * n * std::pow(10.0, lane) * l.norm()) << lane;
    }
}

TEST_P(LaneMatrix, ForwardSolveUndoesTheFactor) {
    const int n = GetParam(), m = n + kTile;
    const Matrices a = random_spd(n, 2), b = test::random_matrices(n, m, 3);
    LaneBuffer factor = test::to_lanes(a), x = test::to_lanes(b);
    cholesky(factor.data(), n);
    forward_solve(factor.data(), x.data(), x.data(), n, m);
    const Matrices found = test::from_lanes(x, n, m);
    for (int lane = 0; lane < kLanes; ++lane) {
        const Eigen::MatrixXd l = test::cholesky(a[lane]);
        // Backward stable: the residual is rounding times the size of the terms.
        EXPECT_LT((test::product(l, found[lane]) - b[lane]).norm(),
                  1e-14 * n * l.norm() * found[lane].norm());
    }
}

TEST_P(LaneMatrix, GramProductAddsBothTriangles) {
    const int n = GetParam(), m = n + 2 * kTile;
    const Matrices w = test::random_matrices(n, m, 4), c = random_spd(m, 5);
    for (const double a : {0.0, 1.0, -2.0}) {
        LaneBuffer sum = test::to_lanes(c);
        add_gram(a, sum.data(), -0.5, test::to_lanes(w).data(), n, m);
        const Matrices found = test::from_lanes(sum, m, m);
        for (int lane = 0; lane < kLanes; ++lane) {
            const Eigen::MatrixXd gram = test::product(w[lane].transpose(), w[lane]);
            const Eigen::MatrixXd expected = a * c[lane] - 0.5 * gram;
            EXPECT_LT((found[lane] - expected).norm(), 1e-14 * n * (1 + expected.norm()));
            EXPECT_EQ((found[lane] - found[lane].transpose()).norm(), 0);  // exactly symmetric
        }
    }
}

TEST_P(LaneMatrix, ProductsWithNumbersOfAllLanes) {
    const int n = GetParam(), m = n + 2 * kTile;
    const Matrices s = random_spd(n, 7);
    const Eigen::MatrixXd b = test::random_matrices(n, m, 8)[0];
    std::vector<double> numbers;
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < m; ++j) numbers.push_back(b(i, j));
    }
    LaneBuffer half(static_cast<std::size_t>(n) * m), both(static_cast<std::size_t>(m) * m);
    multiply(test::to_lanes(s).data(), numbers.data(), half.data(), n, m);
    multiply_transposed(numbers.data(), half.data(), both.data(), n, m);
    const Matrices found_half = test::from_lanes(half, n, m),
                   found_both = test::from_lanes(both, m, m);
    for (int lane = 0; lane < kLanes; ++lane) {
        const Eigen::MatrixXd expected = test::product(s[lane], b);
        EXPECT_LT((found_half[lane] - expected).norm(), 1e-14 * n * (1 + expected.norm()));
        const Eigen::MatrixXd whole = test::product(b.transpose(), expected),
                              lower = whole.triangularView<Eigen::Lower>(),
                              found = found_both[lane].triangularView<Eigen::Lower>();
        EXPECT_LT((found - lower).norm(), 1e-14 * n * (1 + lower.norm()));
    }
}

TEST_P(LaneMatrix, InverseOfPositiveDefinite) {
    const int n = GetParam();
    const Matrices a = random_spd(n, 6);
    LaneBuffer inverse = test::to_lanes(a), work(n * n);
    invert_spd(inverse.data(), work.data(), n);
    const Matrices found = test::from_lanes(inverse, n, n);
    for (int lane = 0; lane < kLanes; ++lane) {
        const Eigen::MatrixXd expected = test::inverse(a[lane]);
        EXPECT_LT((found[lane] - expected).norm(),
                  1e-14 * n * std::pow(10.0, lane) * expected.norm())
            << lane;
        EXPECT_EQ((found[lane] - found[lane].transpose()).norm(), 0);
    }
}

INSTANTIATE_TEST_SUITE_P(Sizes, LaneMatrix, testing::Values(4, 8, 12, 28));

}  // namespace
}  // namespace nacre::solver
