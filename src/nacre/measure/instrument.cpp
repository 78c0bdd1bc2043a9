#include "nacre/measure/instrument.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/core/math.h"
#include "nacre/core/parallel.h"
#include "nacre/core/progress.h"
#include "nacre/core/quadrature.h"
#include "nacre/spectra/rgb.h"

namespace nacre::measure {

std::vector<ConeNode> cone_rule(double theta, double phi, double half_angle, int rings) {
    if (half_angle == 0) return {{theta, phi, 1.0}};
    const int around = 4 * rings;
    const Quadrature& rule = unit_gauss_legendre(rings);
    const double sine = std::sin(theta), cosine = std::cos(theta);
    // 1 - cos by the half angle: no digits are lost in a narrow cone.
    const double whole = 2 * std::pow(std::sin(half_angle / 2), 2);
    std::vector<ConeNode> nodes;
    double sum = 0;
    for (int ring = 0; ring < rings; ++ring) {
        const double fall = whole * rule.nodes[ring];  // 1 - cos of the angle to the axis
        const double along = 1 - fall, across = std::sqrt(fall * (2 - fall));
        for (int step = 0; step < around; ++step) {
            const double turn = 2 * std::numbers::pi * (step + 0.5) / around;
            // Components across the axis: away from the normal, and off its plane.
            const double away = across * std::cos(turn), aside = across * std::sin(turn);
            const double x = along * sine + away * cosine, z = along * cosine - away * sine;
            if (!(z > 1e-12)) continue;
            const double weight = rule.weights[ring] * z;
            nodes.push_back(
                {std::atan2(std::hypot(x, aside), z), phi + std::atan2(aside, x), weight});
            sum += weight;
        }
    }
    for (ConeNode& node : nodes) node.weight /= sum;
    return nodes;
}

SpectrumColour::SpectrumColour(const std::vector<double>& wavelengths_nm)
    : weights_(spectra::rec709_weights(wavelengths_nm)) {}

Vec3d SpectrumColour::sum(const std::vector<double>& values) const {
    if (values.size() != weights_.size()) {
        throw DomainError(fmt::format("a BRDF gives {} values at {} wavelengths", values.size(),
                                      weights_.size()));
    }
    // Within the range of files in single precision.
    constexpr Range kValue{0, 1e30, "1/sr"};
    Vec3d rgb{};
    for (std::size_t w = 0; w < values.size(); ++w) {
        if (!kValue.contains(values[w])) {
            throw DomainError(
                fmt::format("a BRDF gives {}: must be a number in {}", values[w], kValue.text()));
        }
        for (int c = 0; c < 3; ++c) rgb[c] += weights_[w][c] * values[w];
    }
    return rgb;
}

std::vector<double> SpectrumColour::rgb(const std::vector<double>& values) const {
    const Vec3d rgb = sum(values);
    return {std::max(0.0, rgb[0]), std::max(0.0, rgb[1]), std::max(0.0, rgb[2])};
}

double SpectrumColour::luminance(const std::vector<double>& values) const {
    return std::max(0.0, spectra::linear_rec709_to_xyz(sum(values))[1]);
}

namespace {

constexpr const char* kReading = "the measurement";

/// Reads single geometries; may be shared by threads.
class Instrument {
 public:
    Instrument(const Brdf& brdf, std::size_t wavelengths, const Aperture& aperture,
               SharedProgress& work)
        : brdf_(brdf), wavelengths_(wavelengths), aperture_(aperture), work_(work) {}

    /// Reflectance factor at each wavelength.
    std::vector<double> read(const Geometry& geometry) const {
        if (aperture_ == Aperture{}) return mean(geometry, 1);
        constexpr int kRings[] = {2, 3, 4, 6, 8, 12};
        std::vector<double> coarse = mean(geometry, 1);
        for (int rings : kRings) {
            std::vector<double> fine = mean(geometry, rings);
            if (agree(coarse, fine)) return fine;
            coarse = std::move(fine);
        }
        throw Error(fmt::format(
            "{}: the mean over the cones (half angles {} and {} deg) has not settled to {} of its "
            "value: the surface has a lobe far narrower than they are, or the horizon cuts them",
            geometry.name, aperture_.lamp_half_angle_deg, aperture_.detector_half_angle_deg,
            kApertureTolerance));
    }

 private:
    /// pi f, averaged by a rule over both cones.
    std::vector<double> mean(const Geometry& geometry, int rings) const {
        const auto lamp = cone_rule(geometry.theta_i_deg * kDegree, 0,
                                    aperture_.lamp_half_angle_deg * kDegree, rings);
        const auto detector = cone_rule(geometry.theta_o_deg * kDegree, geometry.phi_deg * kDegree,
                                        aperture_.detector_half_angle_deg * kDegree, rings);
        std::vector<double> sum(wavelengths_, 0.0);
        for (const ConeNode& in : lamp) {
            for (const ConeNode& out : detector) {
                work_.throw_if_stopped(kReading);
                const std::vector<double> f = brdf_(in.theta, out.theta, out.phi - in.phi);
                if (f.size() != wavelengths_) {
                    throw DomainError(fmt::format("the BRDF has {} values for {} wavelengths",
                                                  f.size(), wavelengths_));
                }
                const double weight = std::numbers::pi * in.weight * out.weight;
                for (std::size_t i = 0; i < wavelengths_; ++i) sum[i] += weight * f[i];
            }
        }
        return sum;
    }

    static bool agree(const std::vector<double>& coarse, const std::vector<double>& fine) {
        double scale = 0, difference = 0;
        for (std::size_t i = 0; i < fine.size(); ++i) {
            scale = std::max(scale, std::abs(fine[i]));
            difference = std::max(difference, std::abs(fine[i] - coarse[i]));
        }
        return difference <= kApertureTolerance * scale;
    }

    const Brdf& brdf_;
    std::size_t wavelengths_;
    Aperture aperture_;
    SharedProgress& work_;
};

void require_aperture(double half_angle_deg, const char* what) {
    if (!kHalfAngle.contains(half_angle_deg)) {
        throw DomainError(fmt::format("half angle of the {} = {}: must be in {}", what,
                                      half_angle_deg, kHalfAngle.text()));
    }
}

}  // namespace

Measurement measure(const std::string& name, const Brdf& brdf,
                    const std::vector<double>& wavelengths_nm, std::span<const Geometry> geometries,
                    const Conditions& conditions, const Progress& progress) {
    require_aperture(conditions.aperture.lamp_half_angle_deg, "lamp");
    require_aperture(conditions.aperture.detector_half_angle_deg, "detector");
    for (const Geometry& g : geometries) towards(g.theta_i_deg, g.theta_o_deg, g.phi_deg);

    Measurement measurement{name, conditions, wavelengths_nm, {}};
    measurement.readings.resize(geometries.size());
    SharedProgress counter(progress, static_cast<double>(geometries.size()));
    counter.add(0);
    const Instrument instrument(brdf, wavelengths_nm.size(), conditions.aperture, counter);
    parallel_for(0, geometries.size(), [&](std::size_t i) {
        counter.throw_if_stopped(kReading);
        measurement.readings[i] =
            coloured(geometries[i], wavelengths_nm, instrument.read(geometries[i]), conditions);
        counter.add();
    });
    counter.throw_if_stopped(kReading);
    return measurement;
}

}  // namespace nacre::measure
