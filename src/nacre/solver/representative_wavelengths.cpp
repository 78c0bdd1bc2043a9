#include "nacre/solver/representative_wavelengths.h"

#include <algorithm>

#include "nacre/core/dense.h"
#include "nacre/paint/flake_table.h"

namespace nacre::solver {

namespace {

/// One wavelength in `step`, from the first.
RowMajorMatrix by_wavelength(const LaneBuffer& rows, int wavelengths, int step = 1) {
    const std::size_t blocks = paint::block_count(wavelengths);
    RowMajorMatrix a(rows.size() / blocks, (wavelengths + step - 1) / step);
    for (Eigen::Index row = 0; row < a.rows(); ++row) {
        for (int w = 0; w < wavelengths; w += step)
            a(row, w / step) = rows[row * blocks + w / kLanes][w % kLanes];
    }
    return a;
}

}  // namespace

bool may_be_represented(const LaneBuffer& rows, int wavelengths, int count) {
    // Squares of singular values, of which rounding hides those below 1e-15 of the largest.
    constexpr double kFar = 1e-12;
    // What so many do not tell of one wavelength in some, they do not tell of all.
    constexpr int kEnough = 4 * kLanes;
    const int step = std::max(wavelengths / kEnough, 1);
    const Eigen::VectorXd squares =
        symmetric_eigen(gram_matrix(by_wavelength(rows, wavelengths, step))).values;
    const Eigen::Index last = squares.size() - 1;
    return count > last || squares[last - count] < kFar * squares[last];
}

RepresentativeWavelengths::RepresentativeWavelengths(const LaneBuffer& rows, int wavelengths,
                                                     int count)
    : blocks_(paint::block_count(wavelengths)) {
    const ColumnInterpolation found =
        interpolative_decomposition(by_wavelength(rows, wavelengths), count);
    wavelengths_ = found.columns;
    weights_.resize(wavelengths_.size() * blocks_);
    for (std::size_t k = 0; k < wavelengths_.size(); ++k) {
        for (std::size_t lane = 0; lane < blocks_ * kLanes; ++lane) {
            const auto w = std::min<Eigen::Index>(lane, wavelengths - 1);
            weights_[k * blocks_ + lane / kLanes][lane % kLanes] = found.weights(k, w);
        }
    }
}

template <class Value>
OrderValues RepresentativeWavelengths::combine(std::size_t rows, const Value& value) const {
    OrderValues all(rows * blocks_);
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t k = 0; k < wavelengths_.size(); ++k) {
            const double x = value(row, k);
            for (std::size_t b = 0; b < blocks_; ++b)
                all[row * blocks_ + b] += x * weights_[k * blocks_ + b];
        }
    }
    return all;
}

OrderValues RepresentativeWavelengths::at_all(const OrderValues& few) const {
    const std::size_t blocks = paint::block_count(static_cast<int>(wavelengths_.size()));
    return combine(few.size() / blocks, [&](std::size_t row, std::size_t k) {
        return few[row * blocks + k / kLanes][k % kLanes];
    });
}

OrderValues RepresentativeWavelengths::again(const OrderValues& all) const {
    return combine(all.size() / blocks_, [&](std::size_t row, std::size_t k) {
        const auto w = static_cast<std::size_t>(wavelengths_[k]);
        return all[row * blocks_ + w / kLanes][w % kLanes];
    });
}

}  // namespace nacre::solver
