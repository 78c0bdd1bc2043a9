#include "nacre/bsdf/smooth_table.h"

#include <map>
#include <numbers>

#include "nacre/core/parallel.h"

namespace nacre::bsdf {

namespace {

// Lines per coordinate: a lobe of roughness alpha must span several cells. The constants keep
// kMicroflakeError (microflake_test.cpp).
SmoothGrid choose_grid(double alpha) {
    SmoothGrid grid;
    grid.a = static_cast<int>(std::min(26 + 0.5 / alpha, 56.0));
    grid.b = static_cast<int>(std::min(28 + 1.0 / alpha, 80.0));
    grid.q = static_cast<int>(std::min(26 + 1.0 / alpha, 80.0));
    return grid;
}

// Lines in q whose sums over orders run side by side.
constexpr int kLinesAtOnce = 8;

}  // namespace

SmoothTable::SmoothTable(std::span<const solver::MultipleScattering* const> tensors, double alpha,
                         double ior)
    : grid_(choose_grid(alpha)) {
    for (const solver::MultipleScattering* tensor : tensors) rank_ += tensor->table_rank;
    coefficient_.resize(grid_.cells() * rank_);
    int first_rank = 0;
    for (const solver::MultipleScattering* tensor : tensors) {
        tabulate(*tensor, ior, first_rank);
        first_rank += tensor->table_rank;
    }
}

void SmoothTable::tabulate(const solver::MultipleScattering& r, double ior, int first_rank) {
    const int orders = r.orders(), rank = r.table_rank;
    // [order][q], with room for whole groups of lines.
    const int lines = (grid_.q + kLinesAtOnce - 1) / kLinesAtOnce * kLinesAtOnce;
    std::vector<float> cosine(static_cast<std::size_t>(lines) * orders);
    for (int c = 0; c < grid_.q; ++c) {
        const double root = static_cast<double>(c) / (grid_.q - 1);
        const double phi = 2 * std::asin(root * root);
        for (int l = 0; l < orders; ++l) {
            cosine[l * lines + c] = static_cast<float>((l ? 2.0 : 1.0) * std::cos(l * phi));
        }
    }
    const int spectra = (rank + kLanes - 1) / kLanes;  // vectors of them
    parallel_for(0, grid_.a, [&](std::size_t ia) {
        const double root_a = static_cast<double>(ia) / (grid_.a - 1), a = root_a * root_a;
        const double theta_1 = 2 * std::atan(a), mu_1 = solver::inside_cosine(ior, theta_1);
        const solver::MultipleScatteringSlice slice(r, theta_1, rank);
        std::vector<double> theta_2;  // <= theta_1
        for (int ib = 0; ib < grid_.b; ++ib) {
            const double root_b = static_cast<double>(ib) / (grid_.b - 1);
            theta_2.push_back(2 * std::atan(a * (1 - root_b * root_b)));
        }
        const std::size_t terms = static_cast<std::size_t>(rank) * orders;
        std::vector<double> by_order(grid_.b * terms);
        slice.by_order(theta_2, by_order);
        std::vector<FloatLanes> value(static_cast<std::size_t>(orders) * spectra);  // [l][vector]
        for (int ib = 0; ib < grid_.b; ++ib) {
            const double* from = by_order.data() + ib * terms;
            for (int l = 0; l < orders; ++l) {
                for (int k = 0; k < rank; ++k) {
                    value[l * spectra + k / kLanes][k % kLanes] = static_cast<float>(*from++);
                }
            }
            const auto scale = static_cast<float>(mu_1 + solver::inside_cosine(ior, theta_2[ib]));
            float* const out =
                coefficient_.data() + (ia * grid_.b + ib) * grid_.q * rank_ + first_rank;
            for (int c = 0; c < grid_.q; c += kLinesAtOnce) {
                for (int s = 0; s < spectra; ++s) {
                    FloatLanes sum[kLinesAtOnce] = {};
                    for (int l = 0; l < orders; ++l) {
                        const FloatLanes of_order = value[l * spectra + s];
                        const float* const times = cosine.data() + l * lines + c;
#pragma GCC unroll 8
                        for (int i = 0; i < kLinesAtOnce; ++i) sum[i] += times[i] * of_order;
                    }
                    const int first = s * kLanes, count = std::min(kLanes, rank - first);
                    for (int i = 0; i < std::min(kLinesAtOnce, grid_.q - c); ++i) {
                        const FloatLanes line = scale * sum[i];
                        for (int k = 0; k < count; ++k) out[(c + i) * rank_ + first + k] = line[k];
                    }
                }
            }
        }
    });
}

BoundSmoothTable SmoothTable::bind(int first, std::span<const FloatLanes> basis) const {
    BoundSmoothTable bound = SmoothTableMemory::take(memory_, grid_.cells());
    const float* coefficient = coefficient_.data() + first;
    for (std::size_t cell = 0; cell < grid_.cells(); ++cell, coefficient += rank_) {
        FloatLanes sum{};
        for (std::size_t k = 0; k < basis.size(); ++k) sum += coefficient[k] * basis[k];
        bound[cell] = sum;
    }
    return bound;
}

BoundSmoothTable SmoothTableMemory::take(const std::shared_ptr<SmoothTableMemory>& from,
                                         std::size_t cells) {
    const std::lock_guard lock(from->mutex_);
    if (from->free_.empty()) {
        from->free_.reserve(from->made_ + 1);
        BoundSmoothTable fresh(new FloatLanes[cells], GiveBack{from});
        ++from->made_;
        return fresh;
    }
    BoundSmoothTable again(from->free_.back().release(), GiveBack{from});
    from->free_.pop_back();
    return again;
}

void SmoothTableMemory::GiveBack::operator()(FloatLanes* values) const {
    const std::lock_guard lock(to->mutex_);
    to->free_.emplace_back(values);  // without allocation: see take()
}

}  // namespace nacre::bsdf
