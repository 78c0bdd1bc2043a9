#include "nacre/optics/airy.h"

#include <fmt/format.h>

#include <numbers>

#include "nacre/core/error.h"
#include "nacre/core/quadrature.h"

namespace nacre::optics {
namespace {

using Complex = std::complex<double>;

double checked(double value, const Range& range, const char* what) {
    if (range.contains(value)) return value;
    throw DomainError(fmt::format("{} = {} is outside {}", what, value, range.text()));
}

/// From the interfaces' amplitudes, r12 real.
AiryTerms::Polarised series_terms(double r12, Complex r23) {
    const double R12 = r12 * r12, R23 = std::norm(r23), T121 = 1 - R12;
    const double R_star = T121 * T121 * R23 / (1 - R12 * R23);
    return {R12 + R_star, R_star - T121, std::abs(r12) * std::abs(r23), std::arg(-r12 * r23)};
}

Complex complex_log1p(Complex w) {
    return {0.5 * std::log1p(2 * w.real() + std::norm(w)), std::atan2(w.imag(), 1 + w.real())};
}

// One polarisation's series, c0 + 2 strength Re H with H = z e / (1 - z e), e = e^(i x), averaged
// over x in [centre - half, centre + half].
struct Wave {
    double strength;
    Complex z, mean, mean_square;  // of H and H^2

    Wave(const AiryTerms::Polarised& terms, double centre, double half)
        : strength(terms.strength), z(std::polar(terms.ratio, terms.phase)) {
        const Complex middle = z * std::polar(1.0, centre);
        const Complex i(0, 1);
        if (half < 1e-14) {
            mean = middle / (1.0 - middle);
            mean_square = mean * mean;
            return;
        }
        const Complex low = middle * std::polar(1.0, -half), high = middle * std::polar(1.0, half);
        const Complex step = 2.0 * i * std::sin(half) * middle;  // high - low, all digits
        // Int H dx = i ln(1 - z e), Int z e / (1 - z e)^2 dx = -i / (1 - z e); 1 - z e stays in the
        // right half plane, so that the logarithms' difference is that of principal values.
        mean = i / (2 * half) * complex_log1p(-step / (1.0 - low));
        mean_square = -i / (2 * half) * step / ((1.0 - high) * (1.0 - low)) - mean;
    }
    /// Mean of |H|^2.
    double mean_norm() const {
        const double r2 = std::norm(z);
        return (1 + 2 * mean.real()) * r2 / (1 - r2);
    }
};

// Mean of H_a H_b and of H_a conj(H_b), by partial fractions.
Complex mean_product(const Wave& a, const Wave& b) {
    const Complex apart = a.z - b.z;
    // Symmetric in a and b: the error of taking them as equal is of second order in a.z - b.z.
    if (std::abs(apart) < 1e-5) return 0.5 * (a.mean_square + b.mean_square);
    return (b.z * a.mean - a.z * b.mean) / apart;
}
Complex mean_conjugate_product(const Wave& a, const Wave& b) {
    const Complex both = a.z * std::conj(b.z);
    return (1.0 + a.mean + std::conj(b.mean)) * both / (1.0 - both);
}

}  // namespace

AiryFilm::AiryFilm(double outside_ior, double film_ior, double base_ior, double base_extinction)
    : outside_ior_(checked(outside_ior, kAiryIndexRange, "index outside the film")),
      film_ior_(checked(film_ior, kAiryIndexRange, "index of the film")),
      base_(checked(base_ior, kAiryIndexRange, "index of the base"),
            checked(base_extinction, kAiryExtinctionRange, "extinction of the base")),
      eps_1_(outside_ior * outside_ior),
      eps_2_(film_ior * film_ior),
      eps_21_((film_ior - outside_ior) * (film_ior + outside_ior)),
      eps_3_(base_ * base_),
      eps_31_((base_ - outside_ior) * (base_ + outside_ior)) {}

std::optional<AiryTerms> AiryFilm::terms(double cosine) const {
    const double q1 = outside_ior_ * std::max(cosine, 1e-5);
    const double q2_squared = eps_21_ + q1 * q1;
    if (q2_squared <= 1e-10 * eps_2_) return std::nullopt;
    const double q2 = std::sqrt(q2_squared);
    const Complex q3 = std::sqrt(eps_31_ + q1 * q1);  // Im >= 0 as Im(eps) >= 0
    const double p_1 = eps_2_ * q1, p_2 = eps_1_ * q2;
    return AiryTerms{series_terms((q1 - q2) / (q1 + q2), (q2 - q3) / (q2 + q3)),
                     series_terms((p_2 - p_1) / (p_2 + p_1),
                                  (eps_2_ * q3 - eps_3_ * q2) / (eps_2_ * q3 + eps_3_ * q2)),
                     q2 / film_ior_, 2 * q2};
}

AiryMoments AiryFilm::moments(double cosine, ThicknessRange range, double wavelength_nm) const {
    if (const auto series = terms(cosine)) {
        const double per_nm =
            2 * std::numbers::pi * series->optical_path_per_thickness / wavelength_nm;
        const double centre = per_nm * (range.lo_nm + range.hi_nm) / 2;
        const double half = per_nm * (range.hi_nm - range.lo_nm) / 2;
        const Wave s(series->s, centre, half), p(series->p, centre, half);
        // R = c + Re F, F = strength_s H_s + strength_p H_p; (Re F)^2 = (|F|^2 + Re F^2) / 2.
        const double c = (series->s.c0 + series->p.c0) / 2;
        const double mean_f = (s.strength * s.mean + p.strength * p.mean).real();
        const double ss = s.strength * s.strength, pp = p.strength * p.strength,
                     sp = s.strength * p.strength;
        const double norm =
            ss * s.mean_norm() + pp * p.mean_norm() + 2 * sp * mean_conjugate_product(s, p).real();
        const double square =
            (ss * s.mean_square + pp * p.mean_square + 2 * sp * mean_product(s, p)).real();
        return {c + mean_f, c * c + 2 * c * mean_f + (norm + square) / 2};
    }
    // Beyond 40 decay lengths, lambda / (4 pi |q_2|), the base no longer changes the reflectance.
    const auto angle = at<double>(cosine);
    const double width = range.hi_nm - range.lo_nm;
    const double q2 = std::sqrt(std::abs(eps_21_ + std::pow(outside_ior_ * cosine, 2)));
    const double near =
        std::min(width, 40 * wavelength_nm / (4 * std::numbers::pi * std::max(q2, 1e-6)));
    constexpr int kNodes = 48;
    static_assert(kNodes % kLanes == 0);
    const Quadrature& rule = unit_gauss_legendre(kNodes);
    AiryMoments moments;
    const double fraction = width > 0 ? near / width : 1;
    for (int k = 0; k < kNodes; k += kLanes) {
        const DoubleLanes nm = range.lo_nm + near * load_lanes(&rule.nodes[k]);
        const DoubleLanes R = angle.reflectance(nm / wavelength_nm);
        const DoubleLanes weight = fraction * load_lanes(&rule.weights[k]);
        moments.mean += lane_sum(weight * R);
        moments.mean_square += lane_sum(weight * R * R);
    }
    if (fraction < 1) {
        const double R = angle.reflectance(splat(range.hi_nm / wavelength_nm))[0];
        moments.mean += (1 - fraction) * R;
        moments.mean_square += (1 - fraction) * R * R;
    }
    return moments;
}

}  // namespace nacre::optics
