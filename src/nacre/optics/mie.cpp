#include "nacre/optics/mie.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "nacre/core/error.h"

namespace nacre::optics {

namespace {

using Complex = std::complex<double>;

// D_n(z) = psi_n'(z)/psi_n(z), n = 0 ... count, by downward recurrence, which is stable for every z.
//                                                           [bohren-huffman-1983, eq. 4.89]
template <class T>
std::vector<T> logarithmic_derivatives(T z, int count) {
    // Errors of the start fade only where n is well above |z|, over some cbrt(|z|) terms.
    const double size = std::abs(z);
    const int start = std::max(count, static_cast<int>(size + 8 * std::cbrt(size))) + 16;
    std::vector<T> d(start + 1, T(0));
    for (int n = start; n > 0; --n) {
        const T n_over_z = static_cast<double>(n) / z;
        d[n - 1] = n_over_z - 1.0 / (d[n] + n_over_z);
    }
    d.resize(count + 1);
    return d;
}

}  // namespace

MieSeries::MieSeries(double x, ComplexIndex m) : size_parameter_(x) {
    require_in_range(x, kSizeParameterRange.lo, kSizeParameterRange.hi, "size_parameter");
    if (!(m.real() > 0 && m.imag() >= 0 && std::abs(m) * x <= kMaxPhaseShift)) {
        throw DomainError(fmt::format(
            "relative_index = {} + {}i at size parameter {}: n must be above 0, k at least 0 and "
            "|m| x at most {}",
            m.real(), m.imag(), x, kMaxPhaseShift));
    }
    const int count = static_cast<int>(std::ceil(x + 4.3 * std::cbrt(x) + 3));
    if (m == ComplexIndex(1)) {  // nothing is there; the recurrences would leave rounding
        electric_.assign(count, 0);
        magnetic_.assign(count, 0);
        return;
    }
    const std::vector<Complex> inside = logarithmic_derivatives(m * x, count);
    // psi and chi of the argument x, by upward recurrence. What rounding adds to psi grows like chi,
    // the small coefficients err by rounding of the large ones. For small spheres they are all
    // small: then psi comes from its own logarithmic derivative, without differences.
    const bool small = x < 0.5;
    const std::vector<double> outside =
        small ? logarithmic_derivatives(x, count) : std::vector<double>();
    double psi_before = std::sin(x), psi_before_2 = std::cos(x);
    double chi_before = std::cos(x), chi_before_2 = -std::sin(x);
    for (int n = 1; n <= count; ++n) {
        const double n_over_x = n / x;
        const double psi = small ? psi_before / (n_over_x + outside[n])
                                 : (2 * n - 1) / x * psi_before - psi_before_2;
        const double slope = small ? psi * outside[n] : psi_before - n_over_x * psi;
        const double chi = (2 * n - 1) / x * chi_before - chi_before_2;
        // Far beyond x chi overflows, and the coefficients have long been 0.
        if (!std::isfinite(chi)) break;
        const Complex xi(psi, -chi), xi_before(psi_before, -chi_before);
        const Complex a = inside[n] / m, b = m * inside[n];
        electric_.push_back((a * psi - slope) / ((a + n_over_x) * xi - xi_before));
        magnetic_.push_back((b * psi - slope) / ((b + n_over_x) * xi - xi_before));
        psi_before_2 = psi_before;
        psi_before = psi;
        chi_before_2 = chi_before;
        chi_before = chi;
    }
}

MieEfficiencies MieSeries::efficiencies() const {
    double extinction = 0, scattering = 0, turned = 0;
    for (int i = terms() - 1; i >= 0; --i) {
        const double n = i + 1;
        const Complex a = electric_[i], b = magnetic_[i];
        extinction += (2 * n + 1) * (a.real() + b.real());
        scattering += (2 * n + 1) * (std::norm(a) + std::norm(b));
        turned += (2 * n + 1) / (n * (n + 1)) * (a * std::conj(b)).real();
        if (i + 1 < terms()) {
            turned += n * (n + 2) / (n + 1) *
                      (a * std::conj(electric_[i + 1]) + b * std::conj(magnetic_[i + 1])).real();
        }
    }
    const double scale = 2 / (size_parameter_ * size_parameter_);
    return {scale * extinction, scale * scattering, scattering > 0 ? 2 * turned / scattering : 0};
}

std::vector<double> MieSeries::intensities(std::span<const double> cosines) const {
    // By cosine: the angular functions pi_n and pi_(n-1), and the amplitudes S_1 and S_2.
    struct Amplitudes {
        std::vector<double> real, imaginary;
    };
    const std::size_t count = cosines.size();
    std::vector<double> pi(count, 1.0), pi_before(count, 0.0);
    Amplitudes s_1{std::vector<double>(count), std::vector<double>(count)}, s_2 = s_1;
    for (int i = 0; i < terms(); ++i) {
        const double n = i + 1, weight = (2 * n + 1) / (n * (n + 1)), reciprocal = 1 / n;
        const Complex a = weight * electric_[i], b = weight * magnetic_[i];
        for (std::size_t k = 0; k < count; ++k) {
            const double tau = n * cosines[k] * pi[k] - (n + 1) * pi_before[k];
            s_1.real[k] += a.real() * pi[k] + b.real() * tau;
            s_1.imaginary[k] += a.imag() * pi[k] + b.imag() * tau;
            s_2.real[k] += a.real() * tau + b.real() * pi[k];
            s_2.imaginary[k] += a.imag() * tau + b.imag() * pi[k];
            const double next =
                ((2 * n + 1) * cosines[k] * pi[k] - (n + 1) * pi_before[k]) * reciprocal;
            pi_before[k] = pi[k];
            pi[k] = next;
        }
    }
    std::vector<double> intensity(count);
    for (std::size_t k = 0; k < count; ++k) {
        intensity[k] = 0.5 * (s_1.real[k] * s_1.real[k] + s_1.imaginary[k] * s_1.imaginary[k] +
                              s_2.real[k] * s_2.real[k] + s_2.imaginary[k] * s_2.imaginary[k]);
    }
    return intensity;
}

}  // namespace nacre::optics
