#include "nacre/optics/fresnel.h"

#include <fmt/format.h>

#include <cmath>

#include "nacre/core/error.h"

namespace nacre::optics {

namespace {

void require_passive(ComplexIndex index, const char* name) {
    if (!kRefractiveIndexRange.contains(index.real()) || !kExtinctionRange.contains(index.imag())) {
        throw DomainError(fmt::format(
            "{} = {}{:+}i is outside n in {}, k in {} (k >= 0 absorbs, gain is not modelled)", name,
            index.real(), index.imag(), kRefractiveIndexRange.text(), kExtinctionRange.text()));
    }
}

}  // namespace

std::complex<double> normal_wavevector(ComplexIndex n_i, ComplexIndex n_t, double cos_i) {
    // n_t^2 - n_i^2 sin_i^2 with the difference of squares factored: exact for equal indices.
    const ComplexIndex square = (n_t - n_i) * (n_t + n_i) + n_i * n_i * (cos_i * cos_i);
    const ComplexIndex root = std::sqrt(square);  // Re >= 0
    return root.imag() < 0 ? -root : root;
}

FresnelAmplitudes fresnel(ComplexIndex n_i, ComplexIndex n_t, double cos_i) {
    require_passive(n_i, "n_i");
    require_passive(n_t, "n_t");
    if (!(cos_i > 0 && cos_i <= 1)) {
        throw DomainError(fmt::format("cos_i = {} is outside (0, 1]", cos_i));
    }
    const auto q_i = n_i * cos_i;
    const auto q_t = normal_wavevector(n_i, n_t, cos_i);
    const auto s = q_i + q_t;
    const auto p = n_t * n_t * cos_i + n_i * q_t;
    return {(q_i - q_t) / s, (n_t * n_t * cos_i - n_i * q_t) / p, 2.0 * q_i / s,
            2.0 * n_t * q_i / p};
}

}  // namespace nacre::optics
