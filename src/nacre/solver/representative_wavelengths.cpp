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
    // If `count` wavelengths cannot reproduce every step-th wavelength, they cannot reproduce all.
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

void RepresentativeWavelengths::at_all(const DoubleLanes* few, DoubleLanes* all) const {
    std::fill_n(all, blocks_, DoubleLanes{});
    for (std::size_t k = 0; k < wavelengths_.size(); ++k) {
        const double x = few[k / kLanes][k % kLanes];
        for (std::size_t b = 0; b < blocks_; ++b) all[b] += x * weights_[k * blocks_ + b];
    }
}

OrderValues RepresentativeWavelengths::chosen(const OrderValues& all) const {
    const auto count = static_cast<int>(wavelengths_.size());
    const std::size_t rows = all.size() / blocks_, blocks = paint::block_count(count);
    OrderValues few(rows * blocks);
    for (std::size_t row = 0; row < rows; ++row) {
        for (std::size_t lane = 0; lane < blocks * kLanes; ++lane) {
            const int w = wavelengths_[std::min<std::size_t>(lane, count - 1)];
            few[row * blocks + lane / kLanes][lane % kLanes] =
                all[row * blocks_ + w / kLanes][w % kLanes];
        }
    }
    return few;
}

OrderValues RepresentativeWavelengths::again(const OrderValues& all) const {
    const OrderValues few = chosen(all);
    OrderValues out(all.size());
    const std::size_t rows = all.size() / blocks_;
    for (std::size_t row = 0; row < rows; ++row)
        at_all(&few[row * (few.size() / rows)], &out[row * blocks_]);
    return out;
}

}  // namespace nacre::solver
