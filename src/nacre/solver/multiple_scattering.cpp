#include "nacre/solver/multiple_scattering.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <mutex>
#include <numbers>

#include "nacre/core/dense.h"
#include "nacre/core/parallel.h"
#include "nacre/solver/lane_matrix.h"
#include "nacre/solver/lane_registers.h"

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

// For each pair, `fraction` of the smaller of the largest values that its two directions have, or
// kBlackBrdf.
std::vector<double> pair_scales(const MultipleScattering& r, const Eigen::VectorXd& largest,
                                double fraction) {
    std::vector<double> by_node(r.exit_angle.size(), 0.0), scale;
    Eigen::Index pair = 0;
    for_each_pair(r, [&](int i, int j) {
        by_node[i] = std::max(by_node[i], largest[pair]);
        by_node[j] = std::max(by_node[j], largest[pair]);
        ++pair;
    });
    scale.reserve(pair);
    for_each_pair(r, [&](int i, int j) {
        scale.push_back(std::max(fraction * std::min(by_node[i], by_node[j]), kBlackBrdf));
    });
    return scale;
}

// The largest power of two that is not above x, or 0: its multiples are floats with few significant
// bits, which compress well in a file.
double power_of_two_below(double x) { return x > 0 ? std::ldexp(1.0, std::ilogb(x)) : 0.0; }

// Pairs that a thread takes at once.
constexpr std::size_t kPairsAtOnce = 512;

// Some of the rows over their scales, of which the spectra are those of all: rows of neighbouring
// pairs and orders differ by little. Undivided, dark pairs would hardly count beside bright ones.
RowMajorMatrix typical_rows(const Eigen::Map<const RowMajorMatrix>& rows,
                            const std::vector<double>& scale) {
    constexpr Eigen::Index kAtLeast = 768, kForEachWavelength = 8;
    const Eigen::Index enough = kAtLeast + kForEachWavelength * rows.cols();
    RowMajorMatrix out(std::min(rows.rows(), enough), rows.cols());
    for (Eigen::Index i = 0; i < out.rows(); ++i) {
        const Eigen::Index from = i * rows.rows() / out.rows();
        out.row(i) = rows.row(from) / scale[from];
    }
    return out;
}

// What some directions leave of eight rows.
struct Residual {
    LaneBuffer values;  // [wavelength]
    DoubleLanes square{}, largest{};

    // Takes out what lies along `direction`, nothing if that is null, and measures what is left.
    void subtract(const double* direction) {
        // Two of each sum, as an addition waits for the one before.
        const std::size_t n = values.size(), even = n / 2 * 2;
        for (int part = 0; part < kRegisters; ++part) {
            const auto value = [&](std::size_t w) { return load(&values[w], part); };
            Register along[2] = {}, squares[2] = {}, most[2] = {};
            if (direction) {
                for (std::size_t w = 0; w < even; w += 2) {
                    for (int i = 0; i < 2; ++i) along[i] += value(w + i) * direction[w + i];
                }
                if (even < n) along[0] += value(even) * direction[even];
                along[0] += along[1];
            }
            const auto subtract_at = [&](std::size_t w, int i) {
                Register left = value(w);
                if (direction) left -= along[0] * direction[w];
                store(left, &values[w], part);
                squares[i] += left * left;
                most[i] = max_lanes(most[i], max_lanes(left, -left));
            };
            for (std::size_t w = 0; w < even; w += 2) {
                for (int i = 0; i < 2; ++i) subtract_at(w + i, i);
            }
            if (even < n) subtract_at(even, 0);
            store(squares[0] + squares[1], &square, part);
            store(max_lanes(most[0], most[1]), &largest, part);
        }
    }
};

// For each of two tolerances, the smallest number of spectra, the first ones, whose span leaves of
// no row more than the tolerance times its scale at any wavelength.
std::array<int, 2> ranks_needed(const Eigen::Map<const RowMajorMatrix>& rows,
                                const Eigen::MatrixXd& spectra,
                                const std::array<std::vector<double>, 2>& scales,
                                double tolerance) {
    const auto wavelengths = static_cast<std::size_t>(rows.cols());
    const auto count = static_cast<std::size_t>(rows.rows());
    // By number of spectra: whether they leave too much of some row.
    std::array<std::vector<char>, 2> fails;
    fails.fill(std::vector<char>(wavelengths, 0));
    std::mutex mutex;
    parallel_for_ranges(0, count, kPairsAtOnce, [&](std::size_t first, std::size_t last) {
        std::array<std::vector<char>, 2> here;
        here.fill(std::vector<char>(wavelengths, 0));
        Residual residual{LaneBuffer(wavelengths)};
        for (std::size_t p = first; p < last; p += kLanes) {
            // Beyond the last row lanes repeat it.
            const auto row = [&](int lane) { return std::min(p + lane, last - 1); };
            for (int lane = 0; lane < kLanes; ++lane) {
                const double* const from = rows.data() + row(lane) * wavelengths;
                for (std::size_t w = 0; w < wavelengths; ++w) residual.values[w][lane] = from[w];
            }
            std::array<DoubleLanes, 2> limit;
            for (int t = 0; t < 2; ++t) {
                limit[t] = make_lanes<DoubleLanes>(
                    [&](int lane) { return tolerance * scales[t][row(lane)]; });
            }
            const DoubleLanes least = min_lanes(limit[0], limit[1]);
            for (std::size_t k = 0; k < wavelengths; ++k) {
                residual.subtract(k ? spectra.col(k - 1).data() : nullptr);
                // Further directions make the norm no larger, though they may the largest value.
                if (!(lane_max(residual.square - least * least) > 0)) break;
                for (int t = 0; t < 2; ++t) here[t][k] |= lane_max(residual.largest - limit[t]) > 0;
            }
        }
        const std::lock_guard lock(mutex);
        for (int t = 0; t < 2; ++t) {
            for (std::size_t k = 0; k < wavelengths; ++k) fails[t][k] |= here[t][k];
        }
    });
    std::array<int, 2> ranks;
    for (int t = 0; t < 2; ++t) {
        ranks[t] =
            static_cast<int>(std::find(fails[t].begin(), fails[t].end(), 0) - fails[t].begin());
    }
    return ranks;
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
    Eigen::VectorXd largest(pairs);
    parallel_for_ranges(0, pairs, kPairsAtOnce, [&](std::size_t from, std::size_t to) {
        const auto at = static_cast<Eigen::Index>(from), n = static_cast<Eigen::Index>(to - from);
        largest.segment(at, n) = all.middleRows(at, n).cwiseAbs().rowwise().maxCoeff();
    });
    std::array<std::vector<double>, 2> scales = {pair_scales(out, largest, 1),
                                                 pair_scales(out, largest, kFineErrorFraction)};
    const Eigen::MatrixXd spectra = right_singular_vectors(typical_rows(all, scales[0]));
    // Half of the tolerance is for the rank, half for rounding.
    const auto [coarse, fine] = ranks_needed(all, spectra, scales, 0.5 * tolerance);
    out.table_rank = coarse;
    const int rank =
        std::max(coarse, std::min(fine, static_cast<int>(kMaxFineCoefficients / pairs)));
    const std::vector<double>& scale = scales[rank * pairs <= kMaxFineCoefficients ? 1 : 0];
    const RowMajorMatrix basis = spectra.leftCols(rank).transpose();
    for (int k = 0; k < rank; ++k) {
        for (int w = 0; w < wavelength_count; ++w) {
            out.basis.push_back(static_cast<float>(basis(k, w)));
        }
    }
    // Each coefficient errs by step / 2 at most. At one wavelength the squares of the basis sum to
    // at most 1, the magnitudes to sqrt(rank): together the terms err by tolerance / 2 at most.
    // Order 0 carries the energy and costs little: it is kept to more digits.
    const double step = tolerance / std::sqrt(std::max(rank, 1)), finer = 1.0 / 64;
    const std::size_t order_0 = triangle(out.exit_angle.size() - out.first[0]);
    out.coefficient.resize(static_cast<std::size_t>(rank) * scale.size());
    parallel_for_ranges(0, pairs, kPairsAtOnce, [&](std::size_t from, std::size_t to) {
        const auto n = static_cast<Eigen::Index>(to - from);
        const RowMajorMatrix coefficient =
            product_with_transposed(basis, all.middleRows(static_cast<Eigen::Index>(from), n));
        std::vector<double> unit;
        for (std::size_t p = from; p < to; ++p) {
            unit.push_back(power_of_two_below((p < order_0 ? finer * step : step) * scale[p]));
        }
        for (int k = 0; k < rank; ++k) {
            float* const row = out.coefficient.data() + k * scale.size() + from;
            for (Eigen::Index p = 0; p < n; ++p) row[p] = round_to(coefficient(k, p), unit[p]);
        }
    });
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
    const std::size_t row = lanes_of_terms() * kLanes;
    by_node_.assign(lanes_of_terms() * n, DoubleLanes{});
    auto* const by_node = reinterpret_cast<double*>(by_node_.data());
    const float* value = r.coefficient.data();
    std::vector<double> out(n);
    for (int k = 0; k < rank; ++k) {
        for (int l = 0; l < r.orders(); ++l) {
            const int first = r.first[l], rows = n - first;
            if (r.contributes(l, theta_i)) {
                std::fill(out.begin(), out.end(), 0.0);
                add_symmetric_product(rows, value, over_lobe.data(), first, weight.data() + first,
                                      out.data() + first);
                for (int i = first; i < n; ++i) by_node[i * row + l * rank + k] = out[i];
            }
            value += triangle(rows);
        }
    }
}

std::size_t MultipleScatteringSlice::lanes_of_terms() const {
    const std::size_t terms = static_cast<std::size_t>(rank_) * multiple_scattering_.orders();
    return (terms + kLanes - 1) / kLanes;
}

void MultipleScatteringSlice::by_order(std::span<const double> theta_o,
                                       std::span<double> out) const {
    constexpr std::size_t kAtOnce = 4;  // whose sums are in registers
    const std::size_t n = multiple_scattering_.exit_angle.size(), lanes = lanes_of_terms();
    const int orders = multiple_scattering_.orders();
    const std::size_t terms = static_cast<std::size_t>(rank_) * orders;
    std::vector<double> weight(kAtOnce * n);
    for (std::size_t done = 0; done < theta_o.size(); done += kAtOnce) {
        const std::span<const double> some =
            theta_o.subspan(done, std::min(kAtOnce, theta_o.size() - done));
        for (std::size_t i = 0; i < some.size(); ++i) {
            interpolation_.weights_at(some[i], &weight[i * n]);
            const double lobe = multiple_scattering_.lobe(theta_i_, some[i]);
            for (std::size_t j = 0; j < n; ++j) weight[i * n + j] *= lobe;
        }
        double* const to = out.data() + done * terms;
        for (std::size_t k = 0; k < lanes; ++k) {
            Register sum[kAtOnce][kRegisters] = {};
            for (std::size_t j = 0; j < n; ++j) {
                for (int part = 0; part < kRegisters; ++part) {
                    const Register from = load(&by_node_[j * lanes + k], part);
#pragma GCC unroll 4
                    for (std::size_t i = 0; i < kAtOnce; ++i)
                        sum[i][part] += weight[i * n + j] * from;
                }
            }
            for (std::size_t i = 0; i < some.size(); ++i) {
                const std::size_t count = std::min<std::size_t>(kLanes, terms - k * kLanes);
                std::memcpy(to + i * terms + k * kLanes, sum[i], count * sizeof(double));
            }
        }
        for (std::size_t i = 0; i < some.size(); ++i) {
            for (int l = 0; l < orders; ++l) {
                if (multiple_scattering_.contributes(l, some[i])) continue;
                std::fill_n(to + i * terms + static_cast<std::size_t>(l) * rank_, rank_, 0.0);
            }
        }
    }
}

void MultipleScatteringSlice::coefficients(double theta_o, double phi,
                                           std::span<double> out) const {
    const int orders = multiple_scattering_.orders();
    std::vector<double> term(static_cast<std::size_t>(rank_) * orders);
    by_order({&theta_o, 1}, term);
    std::fill(out.begin(), out.end(), 0.0);
    for (int l = 0; l < orders; ++l) {
        const double cosine = (l ? 2.0 : 1.0) * std::cos(l * (phi - std::numbers::pi));
        for (int k = 0; k < rank_; ++k) out[k] += cosine * term[l * rank_ + k];
    }
}

}  // namespace nacre::solver
