#include "nacre/measure/instrument.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/core/parallel.h"
#include "nacre/core/range.h"
#include "nacre/measure/cone.h"

namespace nacre::measure {

namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// Reads one geometry after the other; may be shared by threads.
class Instrument {
 public:
    Instrument(const Brdf& brdf, std::size_t wavelengths, const Aperture& aperture)
        : brdf_(brdf), wavelengths_(wavelengths), aperture_(aperture) {}

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
    const Instrument instrument(brdf, wavelengths_nm.size(), conditions.aperture);
    std::mutex mutex;
    std::atomic<bool> stopped = false;
    std::size_t done = 0;
    parallel_for(0, geometries.size(), [&](std::size_t i) {
        if (stopped) return;
        measurement.readings[i] =
            coloured(geometries[i], wavelengths_nm, instrument.read(geometries[i]), conditions);
        if (!progress) return;
        const std::scoped_lock lock(mutex);
        ++done;
        if (!stopped && !progress(static_cast<double>(done) / geometries.size())) stopped = true;
    });
    if (stopped) throw Error("the measurement was stopped before all angles were read");
    return measurement;
}

}  // namespace nacre::measure
