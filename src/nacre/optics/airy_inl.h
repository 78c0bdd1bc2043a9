#pragma once

#include <algorithm>
#include <cmath>

#include "nacre/optics/airy.h"
#include "nacre/optics/airy_lanes.h"

namespace nacre::optics {

template <class Real>
AiryAngle<Real> AiryFilm::at(Real cosine) const {
    // Normal components of the wave vectors, q_j = n_j cos(theta_j), from q_1 without the sine,
    // which keeps all digits near grazing incidence and for equal indices. Amplitudes below are
    // those of the characteristic matrix, multiplied by q's so that nothing is divided by them.
    const Real n1 = static_cast<Real>(outside_ior_);
    const Real q1 = n1 * std::max(cosine, Real(1e-5)), q1_squared = q1 * q1;
    const Real q2_squared = static_cast<Real>(eps_21_) + q1_squared;
    const Real x = static_cast<Real>(eps_31_.real()) + q1_squared;
    const Real y = static_cast<Real>(eps_31_.imag());
    // sqrt(x + i y), y >= 0: the root in the first quadrant, without cancellation.
    const Real large = std::sqrt((std::sqrt(x * x + y * y) + std::abs(x)) / 2);
    const Real small = large > 0 ? y / (2 * large) : Real(0);
    const Real a = x > 0 ? large : small, b = x > 0 ? small : large;

    AiryAngle<Real> angle;
    angle.evanescent_ = q2_squared < 0;
    angle.q_ = std::max(std::sqrt(std::abs(q2_squared)), Real(1e-6));
    // s: u = q1 - q3, v = -i (q1 q3 - q2^2).
    angle.s_ = {q1 - a, -b, q1 * b, q2_squared - q1 * a, 4 * q1 * a};
    // p: u = eps1 q3 - eps3 q1, v = -i (eps1 eps3 q2^2/eps2 - eps2 q1 q3).
    const Real e1 = static_cast<Real>(eps_1_), e2 = static_cast<Real>(eps_2_);
    const Real e3 = static_cast<Real>(eps_3_.real()), f3 = static_cast<Real>(eps_3_.imag());
    const Real g = e1 * q2_squared / e2, h = e2 * q1;
    angle.p_ = {e1 * a - e3 * q1, e1 * b - f3 * q1, g * f3 - h * b, h * a - g * e3,
                4 * e1 * q1 * (e3 * a + f3 * b)};
    return angle;
}

template <class Real>
template <class V>
typename AiryAngle<Real>::template Pair<V> AiryAngle<Real>::polarised_reflectance(
    V thickness_over_wavelength) const {
    V cosine, sine_over_q;
    V scale = V{} + Real(1);  // of N: 1, or e^(-2 |delta|) that keeps hyperbolic functions finite
    if (!evanescent_) [[likely]] {
        const auto wave = cos_sin_turns(q_ * thickness_over_wavelength);
        cosine = wave.cosine;
        sine_over_q = wave.sine * (1 / q_);
    } else {
        constexpr Real two_pi = Real(6.283185307179586476925);
        const V twice = (2 * two_pi * q_) * thickness_over_wavelength;
        const auto wave = decay(twice);
        cosine = Real(0.5) + Real(0.5) * wave.left;
        sine_over_q = two_pi * thickness_over_wavelength * wave.mean;
        scale = wave.left;
    }
    const auto reflectance = [&](const Polarised& w) {
        const V re = w.u_re * cosine + w.v_re * sine_over_q;
        const V im = w.u_im * cosine + w.v_im * sine_over_q;
        const V n = re * re + im * im;
        return n / (n + w.k * scale);
    };
    return {reflectance(s_), reflectance(p_)};
}

template <class Real>
template <class V>
V AiryAngle<Real>::reflectance(V thickness_over_wavelength) const {
    const auto pair = polarised_reflectance(thickness_over_wavelength);
    return Real(0.5) * (pair.s + pair.p);
}

}  // namespace nacre::optics
