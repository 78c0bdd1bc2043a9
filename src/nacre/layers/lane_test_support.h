#pragma once

#include <Eigen/Core>
#include <array>
#include <random>

#include "nacre/layers/lane_matrix.h"

// What the tests of lane matrices share: eight Eigen matrices in, one buffer of lanes out, and
// back.

namespace nacre::layers::test {

using Matrices = std::array<Eigen::MatrixXd, kLanes>;

/// One matrix a lane, elements uniform in [-1, 1].
inline Matrices random_matrices(int rows, int columns, unsigned seed) {
    std::mt19937 engine(seed);
    std::uniform_real_distribution<double> element(-1, 1);
    Matrices all;
    for (Eigen::MatrixXd& m : all) {
        m = Eigen::MatrixXd::NullaryExpr(rows, columns, [&] { return element(engine); });
    }
    return all;
}

inline LaneBuffer to_lanes(const Matrices& all) {
    const Eigen::Index rows = all[0].rows(), columns = all[0].cols();
    LaneBuffer out(rows * columns);
    for (Eigen::Index i = 0; i < rows; ++i) {
        for (Eigen::Index j = 0; j < columns; ++j) {
            out[i * columns + j] =
                make_lanes<DoubleLanes>([&](int lane) { return all[lane](i, j); });
        }
    }
    return out;
}

inline Matrices from_lanes(const LaneBuffer& buffer, int rows, int columns) {
    Matrices all;
    for (int lane = 0; lane < kLanes; ++lane) {
        all[lane].resize(rows, columns);
        for (int i = 0; i < rows; ++i) {
            for (int j = 0; j < columns; ++j) all[lane](i, j) = buffer[i * columns + j][lane];
        }
    }
    return all;
}

}  // namespace nacre::layers::test
