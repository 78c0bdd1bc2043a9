#include "nacre/fit/certainty.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "nacre/core/dense.h"
#include "nacre/core/error.h"

namespace nacre::fit {

namespace {

/// Change of the residual (root mean square of Delta E) across the whole cube that is no more than
/// the solver's own error: such a direction is taken as flat.
constexpr double kFlat_delta_e = 1e-3;
/// A coordinate is not determined if its component of a flat unit direction exceeds this.
constexpr double kPartInFlat = 0.05;

}  // namespace

Certainty certainty(std::span<const double> residuals, std::span<const double> jacobian,
                    std::size_t numbers, const CertaintyOptions& options) {
    const auto rows = static_cast<Eigen::Index>(residuals.size());
    const auto columns = static_cast<Eigen::Index>(numbers);
    if (columns == 0 || jacobian.size() != residuals.size() * numbers || options.geometries == 0) {
        throw DomainError(fmt::format("{} derivatives of {} residuals by {} numbers do not fit",
                                      jacobian.size(), residuals.size(), numbers));
    }
    const Eigen::Map<const RowMajorMatrix> j(jacobian.data(), rows, columns);
    const Eigen::Map<const Eigen::VectorXd> r(residuals.data(), rows);

    Certainty out;
    out.degrees_of_freedom =
        static_cast<int>(options.independent_values) - static_cast<int>(numbers);
    out.noise_delta_e = options.noise_delta_e;
    if (!out.noise_delta_e && out.degrees_of_freedom > 0) {
        out.noise_delta_e = r.norm() / std::sqrt(static_cast<double>(out.degrees_of_freedom));
    }

    // Eigenvalues in rising order: the weakest direction first.
    const SymmetricEigen eigen = symmetric_eigen(gram_matrix(j));
    const double flat = kFlat_delta_e * std::sqrt(static_cast<double>(options.geometries));
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(columns, columns);
    std::vector<bool> lies_flat(numbers, false);
    for (Eigen::Index k = 0; k < columns; ++k) {
        const Eigen::VectorXd axis = eigen.vectors.col(k);
        const double true_gain = std::sqrt(std::max(0.0, eigen.values[k]));
        const double gain = std::max(true_gain, flat);
        for (Eigen::Index a = 0; a < columns; ++a) {
            // A coordinate with a component along a flat direction is not determined, whatever the
            // noise.
            if (true_gain < flat && std::abs(axis[a]) > kPartInFlat) lies_flat[a] = true;
        }
        covariance += axis * axis.transpose() / (gain * gain);
        const double reach =
            options.equal_delta_e * std::sqrt(static_cast<double>(options.geometries)) / gain;
        if (reach >= Certainty::kWeak) {
            const Eigen::VectorXd step = std::min(reach, 1.0) * axis;
            out.weak.push_back({{step.begin(), step.end()}});
        }
    }

    const Eigen::VectorXd deviation = covariance.diagonal().cwiseSqrt();
    out.correlation.resize(numbers * numbers);
    for (Eigen::Index a = 0; a < columns; ++a) {
        for (Eigen::Index b = 0; b < columns; ++b) {
            out.correlation[a * columns + b] = covariance(a, b) / (deviation[a] * deviation[b]);
        }
        const double error = out.noise_delta_e.value_or(0) * deviation[a];
        const double of_uniform_law = 1 / std::sqrt(12.0);
        if (out.noise_delta_e && !lies_flat[a] && error < of_uniform_law) {
            out.standard_error.emplace_back(error);
        } else {
            out.standard_error.emplace_back(std::nullopt);
        }
    }
    return out;
}

}  // namespace nacre::fit
