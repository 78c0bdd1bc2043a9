#include "nacre/optics/particles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include "nacre/core/error.h"
#include "nacre/core/parallel.h"
#include "nacre/core/quadrature.h"
#include "nacre/optics/mie.h"

namespace nacre::optics {

namespace {

constexpr double kNmPerUm = 1000;

void require(const Range& range, double value, const char* key) {
    if (!range.contains(value)) {
        throw DomainError(fmt::format("{} = {}: must be in {}", key, value, range.text()));
    }
}

// Diameters, and the fraction of the volume in each.
struct Sizes {
    std::vector<double> diameter_nm, fraction;
};

// Diameters for kParticleError. By the midpoint rule, which converges geometrically for a Gaussian
// times what is smooth; but the larger a clear sphere, and the higher its index, the narrower its
// resonances in x. The numbers are an envelope of what rutile of 100 to 500 nm needs in a binder of
// 1.5, where its index is 3.1 and where it is 2.6.
// @param size_parameter  of the median by volume
// @param relative_index  of the spheres, over the binder's
int size_count(double size_parameter, double relative_index, double spread) {
    constexpr double kMaxSizes = 4000;
    const double x = std::min(size_parameter * std::exp(2 * spread), 40.0);
    const double sharpness =
        65 * std::exp(0.125 * relative_index * relative_index * size_parameter);
    return static_cast<int>(std::min(40 + sharpness * spread * x, kMaxSizes));
}

// @param wave_number  in the binder, 1/nm
Sizes make_sizes(const Spheres& spheres, double wave_number, double relative_index) {
    const double s = spheres.spread;
    double median_nm = spheres.diameter_nm;
    if (spheres.weighting == DiameterWeighting::number) median_nm *= std::exp(3 * s * s);
    if (s == 0) return {{median_nm}, {1.0}};
    const int count = size_count(wave_number * median_nm / 2, relative_index, s);
    Sizes sizes;
    double sum = 0;
    for (int i = 0; i < count; ++i) {
        const double t = kSpreadCut * ((2 * i + 1.0) / count - 1);
        sizes.diameter_nm.push_back(median_nm * std::exp(s * t));
        sizes.fraction.push_back(std::exp(-t * t / 2));
        sum += sizes.fraction.back();
    }
    for (double& fraction : sizes.fraction) fraction /= sum;
    return sizes;
}

struct AtWavelength {
    double scattering_per_um, absorption_per_um;
    std::vector<double> legendre;
};

AtWavelength at_wavelength(const Spheres& spheres, double volume_fraction, double binder_index,
                           ComplexIndex index, double wavelength_nm) {
    const double wave_number = 2 * std::numbers::pi * binder_index / wavelength_nm;  // 1/nm
    const Sizes sizes = make_sizes(spheres, wave_number, index.real() / binder_index);
    const auto series_of = [&](double diameter_nm) {
        return MieSeries(wave_number * diameter_nm / 2, index / binder_index);
    };
    const int terms = series_of(sizes.diameter_nm.back()).terms();  // of the largest: the most
    const bool crowded = spheres.crowding == Crowding::hard_spheres;
    // The intensity is a polynomial of degree 2 terms; the structure factor, of q^2 and so of the
    // cosine, swings about as often.
    const int nodes = (crowded ? 3 : 2) * terms + (crowded ? 32 : 1);
    const Quadrature rule = gauss_legendre(nodes, -1, 1);
    std::vector<double> turned(nodes, 0.0);  // sigma_s p, in 1/nm
    std::vector<double> q;
    for (const double mu : rule.nodes) {
        q.push_back(2 * wave_number * std::sqrt(std::max(0.0, (1 - mu) / 2)));
    }
    double absorption = 0;
    for (std::size_t i = 0; i < sizes.diameter_nm.size(); ++i) {
        const double d = sizes.diameter_nm[i];
        const MieSeries series = series_of(d);
        const double number =
            volume_fraction * sizes.fraction[i] * 6 / (std::numbers::pi * d * d * d);
        // Differences of the two sums may leave rounding of a sphere that does not absorb.
        if (index.imag() > 0) {
            absorption += number * std::numbers::pi * d * d / 4 *
                          std::max(0.0, series.efficiencies().absorption());
        }
        const std::vector<double> intensity = series.intensities(rule.nodes);
        for (int k = 0; k < nodes; ++k) {
            const double neighbours = crowded ? percus_yevick(q[k] * d, volume_fraction) : 1;
            turned[k] += number * intensity[k] * neighbours / (wave_number * wave_number);
        }
    }
    AtWavelength out;
    out.absorption_per_um = kNmPerUm * absorption;
    double total = 0;
    std::vector<double> p(nodes, 1.0), before(nodes, 0.0);
    for (int n = 0; n < nodes; ++n) {
        double sum = 0;
        for (int k = 0; k < nodes; ++k) {
            sum += rule.weights[k] * p[k] * turned[k];
            const double next = ((2.0 * n + 1) * rule.nodes[k] * p[k] - n * before[k]) / (n + 1.0);
            before[k] = p[k];
            p[k] = next;
        }
        if (n == 0) total = sum;
        // Without any contrast to the binder there is nothing to turn.
        const double chi = total > 0 ? sum / total : (n == 0 ? 1.0 : 0.0);
        out.legendre.push_back(n == 0 ? 1.0 : std::clamp(chi, -1.0, 1.0));
    }
    constexpr double kNegligible = 1e-9;
    while (out.legendre.size() > 1 &&
           (2 * out.legendre.size() - 1) * std::abs(out.legendre.back()) < kNegligible) {
        out.legendre.pop_back();
    }
    out.scattering_per_um = kNmPerUm * 2 * std::numbers::pi * total;
    return out;
}

}  // namespace

ParticleOptics particle_optics(const Spheres& spheres, double volume_fraction,
                               const Material& binder, std::span<const double> wavelengths_nm) {
    require(kDiameterRange, spheres.diameter_nm, "diameter_nm");
    require(kDiameterSpreadRange, spheres.spread, "spread");
    require(kParticleVolumeRange, volume_fraction, "volume_fraction");
    std::vector<double> binder_index;
    std::vector<ComplexIndex> index;
    for (const double wavelength : wavelengths_nm) {
        const ComplexIndex outside = binder.index(wavelength);
        if (outside.imag() != 0) {
            throw DomainError(fmt::format("binder {}: must not absorb, but has k = {} at {} nm",
                                          binder.name(), outside.imag(), wavelength));
        }
        binder_index.push_back(outside.real());
        index.push_back(spheres.material.index(wavelength));
    }
    const std::size_t count = wavelengths_nm.size();
    std::vector<double> scattering(count), absorption(count);
    std::vector<std::vector<double>> legendre(count);
    parallel_for(0, count, [&](std::size_t i) {
        AtWavelength at =
            at_wavelength(spheres, volume_fraction, binder_index[i], index[i], wavelengths_nm[i]);
        scattering[i] = at.scattering_per_um;
        absorption[i] = at.absorption_per_um;
        legendre[i] = std::move(at.legendre);
    });
    return {std::move(scattering), std::move(absorption), PhaseFunction(std::move(legendre))};
}

double percus_yevick(double q_diameter, double volume_fraction) {
    require_in_range(q_diameter, 0, std::numeric_limits<double>::max(), "q_diameter");
    require_in_range(volume_fraction, 0, 0.5, "volume_fraction");
    const double v = volume_fraction, x = q_diameter;
    const double thin = (1 - v) * (1 - v) * (1 - v) * (1 - v);
    const double alpha = (1 + 2 * v) * (1 + 2 * v) / thin;
    const double beta = -6 * v * (1 + v / 2) * (1 + v / 2) / thin;
    const double gamma = v * alpha / 2;
    // The direct correlation function is -(alpha + beta s + gamma s^3) within the diameter, s = r/d;
    // its transform times the density is -24 v g.
    double g = 0;
    if (x < 2) {
        // The closed form would lose its digits: sin(x s)/(x s) by its series, whose next term is below
        // 1e-17.
        constexpr int kTerms = 13;
        double term = 1;  // (-x^2)^j / (2 j + 1)!
        for (int j = 0; j < kTerms; ++j) {
            const double m = 2 * j;
            g += term * (alpha / (m + 3) + beta / (m + 4) + gamma / (m + 6));
            term *= -x * x / ((m + 2) * (m + 3));
        }
    } else {
        const double x2 = x * x, sine = std::sin(x), cosine = std::cos(x);
        g = alpha * (sine - x * cosine) / (x2 * x) +
            beta * (2 * x * sine + (2 - x2) * cosine - 2) / (x2 * x2) +
            gamma * (-x2 * x2 * cosine + 4 * ((3 * x2 - 6) * cosine + (x2 - 6) * x * sine + 6)) /
                (x2 * x2 * x2);
    }
    return 1 / (1 + 24 * v * g);
}

}  // namespace nacre::optics
