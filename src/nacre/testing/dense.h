#pragma once

#include <Eigen/Core>

// Only for tests: decompositions by Eigen, against which the solver's own are held. Compiled once,
// as they take the compiler seconds.

namespace nacre::solver::test {

Eigen::MatrixXd inverse(const Eigen::MatrixXd& a);

/// The lower triangular L of a = L L^T; `a` must be symmetric and positive definite.
Eigen::MatrixXd cholesky(const Eigen::MatrixXd& a);

Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

}  // namespace nacre::solver::test
