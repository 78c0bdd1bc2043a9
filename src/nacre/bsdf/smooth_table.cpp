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

// Products w_i(theta_1) w_j(theta_2) + w_j(theta_1) w_i(theta_2) over the node pairs i >= j >=
// first, in the order in which MultipleScattering stores them.
void pair_weights(const std::vector<double>& w1, const std::vector<double>& w2, int first,
                  std::vector<float>& out) {
    out.clear();
    for (int i = first; i < static_cast<int>(w1.size()); ++i) {
        for (int j = first; j < i; ++j) {
            out.push_back(static_cast<float>(w1[i] * w2[j] + w1[j] * w2[i]));
        }
        out.push_back(static_cast<float>(w1[i] * w2[i]));
    }
}

}  // namespace

SmoothTable::SmoothTable(std::span<const solver::MultipleScattering* const> tensors, double alpha,
                         double ior)
    : grid_(choose_grid(alpha)) {
    for (const solver::MultipleScattering* tensor : tensors) rank_ += tensor->rank();
    coefficient_.resize(grid_.cells() * rank_);
    int first_rank = 0;
    for (const solver::MultipleScattering* tensor : tensors) {
        tabulate(*tensor, ior, first_rank);
        first_rank += tensor->rank();
    }
}

void SmoothTable::tabulate(const solver::MultipleScattering& r, double ior, int first_rank) {
    const int orders = r.orders(), nodes = static_cast<int>(r.exit_angle.size());
    const int rank = r.rank();
    const solver::ExitInterpolation interpolation(r.exit_angle);
    std::vector<float> cosine(static_cast<std::size_t>(grid_.q) * orders);
    for (int c = 0; c < grid_.q; ++c) {
        const double root = static_cast<double>(c) / (grid_.q - 1);
        const double phi = 2 * std::asin(root * root);
        for (int l = 0; l < orders; ++l) {
            cosine[c * orders + l] = static_cast<float>((l ? 2.0 : 1.0) * std::cos(l * phi));
        }
    }
    const std::size_t pairs = r.pair_count();
    parallel_for(0, static_cast<std::size_t>(grid_.a) * grid_.b, [&](std::size_t ab) {
        const double root_a = static_cast<double>(ab / grid_.b) / (grid_.a - 1);
        const double root_b = static_cast<double>(ab % grid_.b) / (grid_.b - 1);
        const double a = root_a * root_a, smaller = a * (1 - root_b * root_b);
        std::vector<double> w1(nodes), w2(nodes);
        const double theta_1 = 2 * std::atan(a), theta_2 = 2 * std::atan(smaller);
        interpolation.weights_at(theta_1, w1.data());
        interpolation.weights_at(theta_2, w2.data());
        const double scale =
            solver::inside_cosine(ior, theta_1) + solver::inside_cosine(ior, theta_2);
        std::vector<float> weight, by_order(static_cast<std::size_t>(rank) * orders);
        std::size_t at = 0;
        for (int l = 0; l < orders; ++l) {
            if (l == 0 || r.first[l] != r.first[l - 1]) pair_weights(w1, w2, r.first[l], weight);
            if (!r.takes_part(l, theta_2)) {  // theta_2 <= theta_1
                at += weight.size();
                continue;
            }
            for (int k = 0; k < rank; ++k) {
                const float* value = r.coefficient.data() + k * pairs + at;
                FloatLanes sum{};
                std::size_t p = 0;
                for (; p + kLanes <= weight.size(); p += kLanes) {
                    sum += load_lanes(value + p) * load_lanes(weight.data() + p);
                }
                float total = lane_sum(sum);
                for (; p < weight.size(); ++p) total += value[p] * weight[p];
                by_order[k * orders + l] = total;
            }
            at += weight.size();
        }
        for (int c = 0; c < grid_.q; ++c) {
            float* out = coefficient_.data() + (ab * grid_.q + c) * rank_ + first_rank;
            for (int k = 0; k < rank; ++k) {
                float sum = 0;
                for (int l = 0; l < orders; ++l) {
                    sum += cosine[c * orders + l] * by_order[k * orders + l];
                }
                out[k] = static_cast<float>(scale) * sum;
            }
        }
    });
}

void SmoothTable::bind(std::span<const FloatLanes> basis, FloatLanes* out) const {
    const float* coefficient = coefficient_.data();
    for (std::size_t cell = 0; cell < grid_.cells(); ++cell, coefficient += rank_) {
        FloatLanes sum = out[cell];
        for (int k = 0; k < rank_; ++k) sum += coefficient[k] * basis[k];
        out[cell] = sum;
    }
}

}  // namespace nacre::bsdf
