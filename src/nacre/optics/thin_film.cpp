#include "nacre/optics/thin_film.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/optics/fresnel.h"

// Every half space and film has an admittance y: the tangential magnetic over the tangential
// electric field of the wave that goes down, in units in which it is q = n cos(theta) for s
// polarisation; for p, where the roles of the fields swap, q / n^2 does the same. With d the film's
// phase thickness the fields at its top follow from those at its bottom by
//     | cos d        -i sin d / y |
//     | -i y sin d    cos d       |
//                                                                   [born-wolf-1999, 1.6 eq. 33-34]
// Two changes make it hold for any film. Multiplied by e^(i d), |e^(i d)| <= 1, the elements stay
// bounded however thick and absorbing the film is; the factor returns in T only, where it may
// vanish. And sin d / y is written with sin d / d, which has a limit where q = 0, at the critical
// angle.

namespace nacre::optics {

namespace {

using Complex = std::complex<double>;

constexpr Complex kI(0, 1);

/// (e^(2 i d) - 1) / (2 i d), that is e^(i d) sin d / d.
Complex scaled_sinc(Complex d, Complex exp_2id) {
    // Below this the series up to d^3 is exact to rounding, and above it the difference loses at
    // most two digits.
    if (std::abs(d) > 1e-2) return (exp_2id - 1.0) / (2.0 * kI * d);
    const Complex x = 2.0 * kI * d;
    return 1.0 +
           x / 2.0 *
               (1.0 +
                x / 3.0 * (1.0 + x / 4.0 * (1.0 + x / 5.0 * (1.0 + x / 6.0 * (1.0 + x / 7.0)))));
}

struct Fields {
    Complex electric, magnetic;  // tangential; swapped for p
};

ReflectanceTransmittance polarized(ComplexIndex ambient, std::span<const ThinFilm> films,
                                   ComplexIndex substrate, double cos_incident,
                                   double wavelength_nm, bool is_p) {
    const auto admittance = [&](ComplexIndex n, Complex q) { return is_p ? q / (n * n) : q; };
    const double y_ambient = admittance(ambient, ambient.real() * cos_incident).real();
    const Complex y_substrate =
        admittance(substrate, normal_wavevector(ambient, substrate, cos_incident));

    // From the substrate up; the fields are rescaled film by film, so that thousands of films
    // neither overflow nor vanish. log_power remembers the square of what was divided out.
    Fields fields{1.0, y_substrate};
    double log_power = 0;
    for (auto film = films.rbegin(); film != films.rend(); ++film) {
        const Complex q = normal_wavevector(ambient, film->index, cos_incident);
        const double k_thickness = 2 * std::numbers::pi * film->thickness_nm / wavelength_nm;
        const Complex phase = q * k_thickness;
        const Complex exp_2id = std::exp(2.0 * kI * phase);
        const Complex scaled_cos = (exp_2id + 1.0) / 2.0;
        const Complex sinc = scaled_sinc(phase, exp_2id);
        // sin d / y and y sin d, with y = q or q / n^2 and sin d = q k_thickness sinc
        const Complex n2 = is_p ? film->index * film->index : Complex(1.0);
        const Complex sin_over_y = n2 * k_thickness * sinc;
        const Complex y_sin = q * q / n2 * k_thickness * sinc;
        const Fields top{scaled_cos * fields.electric - kI * sin_over_y * fields.magnetic,
                         scaled_cos * fields.magnetic - kI * y_sin * fields.electric};
        const double scale = std::abs(top.electric) + std::abs(top.magnetic);
        fields = {top.electric / scale, top.magnetic / scale};
        log_power -= 2 * (phase.imag() + std::log(scale));
    }
    const Complex incident = y_ambient * fields.electric + fields.magnetic;
    const Complex reflected = y_ambient * fields.electric - fields.magnetic;
    // 0/0 only at cos_incident = 0 in front of a substrate of the same index without films: the
    // limit is no interface at all.
    if (incident == 0.0) return {0.0, 1.0};
    return {std::norm(reflected / incident),
            4 * y_ambient * y_substrate.real() / std::norm(incident) * std::exp(log_power)};
}

void require_index(ComplexIndex index, const char* what) {
    if (!kRefractiveIndexRange.contains(index.real()) || !kExtinctionRange.contains(index.imag())) {
        throw DomainError(fmt::format("index of {} = {}{:+}i is outside n in {}, k in {}", what,
                                      index.real(), index.imag(), kRefractiveIndexRange.text(),
                                      kExtinctionRange.text()));
    }
}

}  // namespace

ReflectanceTransmittance stack_reflectance(ComplexIndex ambient, std::span<const ThinFilm> films,
                                           ComplexIndex substrate, double cos_incident,
                                           double wavelength_nm, Polarization polarization) {
    require_index(ambient, "the ambient");
    require_index(substrate, "the substrate");
    if (ambient.imag() != 0) {
        throw DomainError(
            fmt::format("index of the ambient = {}{:+}i absorbs: then there is no "
                        "reflectance, for the light never arrives",
                        ambient.real(), ambient.imag()));
    }
    require_in_range(cos_incident, 0, 1, "cos_incident");
    require_in_range(wavelength_nm, kThinFilmWavelengthRange.lo, kThinFilmWavelengthRange.hi,
                     "wavelength in nm");
    for (const ThinFilm& film : films) {
        require_index(film.index, "a film");
        require_in_range(film.thickness_nm, kFilmThicknessRange.lo, kFilmThicknessRange.hi,
                         "thickness of a film in nm");
    }
    const auto of = [&](bool is_p) {
        return polarized(ambient, films, substrate, cos_incident, wavelength_nm, is_p);
    };
    switch (polarization) {
        case Polarization::s:
            return of(false);
        case Polarization::p:
            return of(true);
        case Polarization::unpolarized:
            break;
    }
    const auto s = of(false), p = of(true);
    return {(s.reflectance + p.reflectance) / 2, (s.transmittance + p.transmittance) / 2};
}

}  // namespace nacre::optics
