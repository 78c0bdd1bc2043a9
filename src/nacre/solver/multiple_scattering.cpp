#include "nacre/solver/multiple_scattering.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/core/dense.h"

namespace nacre::solver {

std::size_t MultipleScattering::pair_count() const {
    std::size_t count = 0;
    for (int f : first) count += triangle(exit_angle.size() - f);
    return count;
}

namespace {

double lobe_of_sines(double width, double sine_i, double sine_o) {
    if (!(width > 0)) return 1;
    const double distance = (sine_i - sine_o) / width;
    return std::exp(-distance * distance) + kLobeFloor;
}

}  // namespace

double MultipleScattering::lobe(double theta_i, double theta_o) const {
    return lobe_of_sines(lobe_width, std::sin(theta_i), std::sin(theta_o));
}

namespace {

// Calls visit(i, j) for all pairs of all orders, in the order in which they are stored.
template <class Visit>
void for_each_pair(const MultipleScattering& r, Visit&& visit) {
    for (int first : r.first) {
        for (int i = first; i < static_cast<int>(r.exit_angle.size()); ++i) {
            for (int j = first; j <= i; ++j) visit(i, j);
        }
    }
}

// For each pair, `share` of the smaller of the largest values that its two directions have, or
// kBlackBrdf.
std::vector<double> pair_scales(const MultipleScattering& r, const Eigen::VectorXd& largest,
                                double share) {
    std::vector<double> by_node(r.exit_angle.size(), 0.0), scale;
    Eigen::Index pair = 0;
    for_each_pair(r, [&](int i, int j) {
        by_node[i] = std::max(by_node[i], largest[pair]);
        by_node[j] = std::max(by_node[j], largest[pair]);
        ++pair;
    });
    scale.reserve(pair);
    for_each_pair(r, [&](int i, int j) {
        scale.push_back(std::max(share * std::min(by_node[i], by_node[j]), kBlackBrdf));
    });
    return scale;
}

// The largest power of two that is not above x, or 0: its multiples are floats with few significant
// bits, which compress well in a file.
double power_of_two_below(double x) { return x > 0 ? std::ldexp(1.0, std::ilogb(x)) : 0.0; }

// The smallest number of eigenvectors, those of the largest eigenvalues, whose span leaves of no row
// more than `tolerance` times its scale at any wavelength.
int rank_needed(const Eigen::Map<const RowMajorMatrix>& rows, const SymmetricEigen& eigen,
                const std::vector<double>& scale, double tolerance) {
    const auto wavelengths = static_cast<int>(rows.cols());
    Eigen::VectorXd row(wavelengths), residual(wavelengths);
    int rank = 0;
    for (int checked = -1; checked != rank;) {  // a rank that one row raised is checked by all
        checked = rank;
        for (Eigen::Index p = 0; p < rows.rows(); ++p) {
            const double limit = tolerance * scale[static_cast<std::size_t>(p)];
            residual = row = rows.row(p).transpose();
            const auto subtract = [&](int k) {
                const auto direction = eigen.vectors.col(wavelengths - 1 - k);  // largest last
                residual -= row.dot(direction) * direction;
            };
            // Further directions make the norm no larger, though they may the largest value.
            int k = 0;
            while (k < rank && residual.squaredNorm() > limit * limit) subtract(k++);
            while (rank < wavelengths && residual.cwiseAbs().maxCoeff() > limit) subtract(rank++);
        }
    }
    return rank;
}

float round_to(double value, double unit) {
    return static_cast<float>(unit > 0 ? std::round(value / unit) * unit : value);
}

// Adds A x to y, A being symmetric: `row` times `scale`, element by element. Of the rows of both those
// parts are given that end at the diagonal; those of the scale begin with `skipped` elements, and as
// many rows before the first, that are not used.
void add_symmetric_product(int n, const float* row, const double* scale, int skipped,
                           const double* x, double* y) {
    constexpr int kParts = 8;  // of a sum, which vectors hold
    for (int i = 0; i < n; ++i) {
        double part[kParts] = {};
        const double* const times = scale + triangle(skipped + i) + skipped;
        int j = 0;
        for (; j + kParts <= i; j += kParts) {
            for (int p = 0; p < kParts; ++p) {
                const double a = row[j + p] * times[j + p];
                y[j + p] += a * x[i];
                part[p] += a * x[j + p];
            }
        }
        for (; j < i; ++j) {
            const double a = row[j] * times[j];
            y[j] += a * x[i];
            part[0] += a * x[j];
        }
        y[i] += row[i] * times[i] * x[i];
        for (const double sum : part) y[i] += sum;
        row += i + 1;
    }
}

}  // namespace

MultipleScattering compress(std::vector<double> exit_angle, std::vector<int> first,
                            int wavelength_count, std::span<const double> values,
                            double tolerance) {
    MultipleScattering out;
    out.exit_angle = std::move(exit_angle);
    out.first = std::move(first);
    out.wavelength_count = wavelength_count;
    const auto pairs = static_cast<Eigen::Index>(values.size()) / std::max(wavelength_count, 1);
    if (pairs == 0) return out;
    const Eigen::Map<const RowMajorMatrix> all(values.data(), pairs, wavelength_count);
    const Eigen::VectorXd largest = all.cwiseAbs().rowwise().maxCoeff();
    const SymmetricEigen eigen = symmetric_eigen(gram_matrix(all));
    // Half of the tolerance is for the rank, half for rounding.
    const auto needed = [&](const std::vector<double>& scale) {
        return rank_needed(all, eigen, scale, 0.5 * tolerance);
    };
    std::vector<double> scale = pair_scales(out, largest, 1);
    out.table_rank = needed(scale);
    int rank = out.table_rank;
    std::vector<double> fine_scale = pair_scales(out, largest, kFineShare);
    if (const int fine = needed(fine_scale); fine * pairs <= kMaxFineCoefficients) {
        rank = fine;
        scale = std::move(fine_scale);
    }
    const RowMajorMatrix basis = eigen.vectors.rightCols(rank).rowwise().reverse().transpose();
    const RowMajorMatrix coefficient = (all * basis.transpose()).transpose();
    // Each coefficient errs by step / 2 at most. At one wavelength the squares of the basis sum to
    // at most 1, the magnitudes to sqrt(rank): together the terms err by tolerance / 2 at most.
    // Order 0 carries the energy and costs little: it is kept to more digits.
    const double step = tolerance / std::sqrt(std::max(rank, 1)), finer = 1.0 / 64;
    const std::size_t order_0 = triangle(out.exit_angle.size() - out.first[0]);
    std::vector<double> unit;
    for (std::size_t p = 0; p < scale.size(); ++p) {
        unit.push_back(power_of_two_below((p < order_0 ? finer * step : step) * scale[p]));
    }
    out.coefficient.reserve(static_cast<std::size_t>(rank) * unit.size());
    for (int k = 0; k < rank; ++k) {
        for (int w = 0; w < wavelength_count; ++w) {
            out.basis.push_back(static_cast<float>(basis(k, w)));
        }
        for (Eigen::Index p = 0; p < pairs; ++p) {
            out.coefficient.push_back(round_to(coefficient(k, p), unit[p]));
        }
    }
    return out;
}

MultipleScatteringSlice::MultipleScatteringSlice(const MultipleScattering& r, double theta_i,
                                                 int rank)
    : multiple_scattering_(r), interpolation_(r.exit_angle), theta_i_(theta_i), rank_(rank) {
    const int n = static_cast<int>(r.exit_angle.size());
    std::vector<double> sine, over_lobe(triangle(n));
    for (int i = 0; i < n; ++i) {
        sine.push_back(std::sin(r.exit_angle[i]));
        for (int j = 0; j <= i; ++j) {
            over_lobe[triangle(i) + j] = 1 / lobe_of_sines(r.lobe_width, sine[i], sine[j]);
        }
    }
    std::vector<double> weight(n);
    interpolation_.weights_at(theta_i, weight.data());
    const std::size_t terms = static_cast<std::size_t>(rank) * r.orders();
    by_node_.assign(terms * n, 0.0);
    const float* value = r.coefficient.data();
    std::vector<double> out(n);
    for (int k = 0; k < rank; ++k) {
        for (int l = 0; l < r.orders(); ++l) {
            const int first = r.first[l], rows = n - first;
            if (r.takes_part(l, theta_i)) {
                std::fill(out.begin(), out.end(), 0.0);
                add_symmetric_product(rows, value, over_lobe.data(), first, weight.data() + first,
                                      out.data() + first);
                double* to = by_node_.data() + static_cast<std::size_t>(k) * r.orders() + l;
                for (int i = first; i < n; ++i) to[i * terms] = out[i];
            }
            value += triangle(rows);
        }
    }
}

void MultipleScatteringSlice::by_order(double theta_o, std::span<double> out) const {
    const int n = static_cast<int>(multiple_scattering_.exit_angle.size());
    std::vector<double> weight(n);
    interpolation_.weights_at(theta_o, weight.data());
    const int orders = multiple_scattering_.orders();
    const std::size_t terms = static_cast<std::size_t>(rank_) * orders;
    std::fill_n(out.begin(), terms, 0.0);
    double* const sum = out.data();
    const double lobe = multiple_scattering_.lobe(theta_i_, theta_o);
    for (int j = 0; j < n; ++j) {
        const double* from = by_node_.data() + j * terms;
        const double w = lobe * weight[j];
        for (std::size_t t = 0; t < terms; ++t) sum[t] += from[t] * w;
    }
    for (int l = 0; l < orders; ++l) {
        if (multiple_scattering_.takes_part(l, theta_o)) continue;
        for (int k = 0; k < rank_; ++k) sum[k * orders + l] = 0;
    }
}

void MultipleScatteringSlice::coefficients(double theta_o, double phi,
                                           std::span<double> out) const {
    const int orders = multiple_scattering_.orders();
    std::vector<double> term(static_cast<std::size_t>(rank_) * orders);
    by_order(theta_o, term);
    std::fill(out.begin(), out.end(), 0.0);
    for (int l = 0; l < orders; ++l) {
        const double cosine = (l ? 2.0 : 1.0) * std::cos(l * (phi - std::numbers::pi));
        for (int k = 0; k < rank_; ++k) out[k] += cosine * term[k * orders + l];
    }
}

}  // namespace nacre::solver
