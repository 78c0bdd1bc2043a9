#include "nacre/layers/remainder.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

namespace nacre::layers {

std::size_t Remainder::pair_count() const {
    std::size_t count = 0;
    for (int f : first) {
        const std::size_t rows = exit_angle.size() - f;
        count += rows * (rows + 1) / 2;
    }
    return count;
}

Remainder compress(std::vector<double> exit_angle, std::vector<int> first, int wavelength_count,
                   std::span<const double> values, double tolerance) {
    using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    Remainder out;
    out.exit_angle = std::move(exit_angle);
    out.first = std::move(first);
    out.wavelength_count = wavelength_count;
    const auto pairs = static_cast<Eigen::Index>(values.size()) / std::max(wavelength_count, 1);
    const Eigen::Map<const Matrix> all(values.data(), pairs, wavelength_count);
    const double peak = pairs ? all.cwiseAbs().maxCoeff() : 0.0;

    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(all.transpose() * all);
    int rank = 0;
    Matrix residual = all;
    Matrix basis, coefficient;
    // Largest eigenvalues come last.
    while (peak > 0 && rank < wavelength_count) {
        const Eigen::VectorXd direction = eigen.eigenvectors().col(wavelength_count - 1 - rank);
        const Eigen::VectorXd projected = all * direction;
        residual -= projected * direction.transpose();
        ++rank;
        if (residual.cwiseAbs().maxCoeff() < tolerance * peak) break;
    }
    basis = eigen.eigenvectors().rightCols(rank).rowwise().reverse().transpose();
    coefficient = (all * basis.transpose()).transpose();
    for (int k = 0; k < rank; ++k) {
        for (int w = 0; w < wavelength_count; ++w) {
            out.basis.push_back(static_cast<float>(basis(k, w)));
        }
        for (Eigen::Index p = 0; p < pairs; ++p) {
            out.coefficient.push_back(static_cast<float>(coefficient(k, p)));
        }
    }
    return out;
}

RemainderSlice::RemainderSlice(const Remainder& r, double theta_i)
    : remainder_(r), interpolation_(r.exit_angle) {
    const int n = static_cast<int>(r.exit_angle.size());
    std::vector<double> weight(n);
    interpolation_.weights_at(theta_i, weight.data());
    by_node_.assign(static_cast<std::size_t>(r.rank()) * r.orders() * n, 0.0);
    const float* value = r.coefficient.data();
    for (int k = 0; k < r.rank(); ++k) {
        for (int l = 0; l < r.orders(); ++l) {
            double* out = by_node_.data() + (static_cast<std::size_t>(k) * r.orders() + l) * n;
            if (!r.takes_part(l, theta_i)) {
                const int rows = n - r.first[l];
                value += rows * (rows + 1) / 2;
                continue;
            }
            for (int i = r.first[l]; i < n; ++i) {
                for (int j = r.first[l]; j < i; ++j, ++value) {
                    out[i] += *value * weight[j];
                    out[j] += *value * weight[i];
                }
                out[i] += *value++ * weight[i];
            }
        }
    }
}

void RemainderSlice::coefficients(double theta_o, double phi, std::span<double> out) const {
    const int n = static_cast<int>(remainder_.exit_angle.size());
    std::vector<double> weight(n), cosine(remainder_.orders());
    interpolation_.weights_at(theta_o, weight.data());
    for (int l = 0; l < remainder_.orders(); ++l) {
        cosine[l] = (l ? 2.0 : 1.0) * std::cos(l * (phi - std::numbers::pi));
    }
    for (int k = 0; k < remainder_.rank(); ++k) {
        double sum = 0;
        for (int l = 0; l < remainder_.orders(); ++l) {
            if (!remainder_.takes_part(l, theta_o)) continue;
            const double* row =
                by_node_.data() + (static_cast<std::size_t>(k) * remainder_.orders() + l) * n;
            double order = 0;
            for (int j = remainder_.first[l]; j < n; ++j) order += row[j] * weight[j];
            sum += cosine[l] * order;
        }
        out[k] = sum;
    }
}

}  // namespace nacre::layers
