#include "nacre/testing/dense.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace nacre::solver::test {

Eigen::MatrixXd inverse(const Eigen::MatrixXd& a) { return a.inverse(); }

Eigen::MatrixXd cholesky(const Eigen::MatrixXd& a) { return a.llt().matrixL(); }

Eigen::MatrixXd product(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) { return a * b; }

}  // namespace nacre::solver::test
