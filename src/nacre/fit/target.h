#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "nacre/layers/solved_paint.h"
#include "nacre/measure/measurement.h"

// The colours that a fit is after, and how far a paint is from them.

namespace nacre::fit {

/// Under which lights, and at which angles how much, colours are to agree.
struct TargetOptions {
    /// Colours under all of them count alike. Empty: the standard's own.
    std::vector<spectra::Illuminant> illuminants;
    /// By the geometry's name, >= 0; those not named weigh 1.
    std::map<std::string, double> weights;
};

/// How closely to look, which is how well a paint must be solved: a glance to compare points far
/// apart (every 40 nm), coarse to find the way (every 20 nm), both through an ideal aperture; fine
/// for the answer, at the standard's wavelengths and through its aperture.
enum class Detail { glance, coarse, fine };

class Target {
 public:
    /// @throws DomainError if the standard has no reading, an illuminant other than its own
    ///         is asked for where it has no spectra, a weight is negative or names none of its
    ///         geometries, or all weights are 0
    Target(const measure::Measurement& standard, const TargetOptions& options);

    /// The standard under the first illuminant.
    const measure::Measurement& standard() const { return standards_.back()[0]; }
    bool has_spectra() const { return has_spectra_; }
    const std::vector<double>& wavelengths_nm(Detail detail) const;

    std::size_t residual_count() const;
    /// What the standard's instrument reads on a paint that was solved at wavelengths_nm(detail),
    /// under the first illuminant.
    measure::Measurement read(const layers::SolvedPaint& paint, Detail detail) const;
    /// For each illuminant and geometry the three components of the CIEDE2000 difference
    /// (spectra::delta_e_2000_vector), times the square root of the geometry's weight over the mean
    /// weight (of those that weigh anything) and of one over the number of illuminants: the sum of
    /// squares over the number of geometries is the weighted mean square of Delta E 2000.
    std::vector<double> residuals(const layers::SolvedPaint& paint, Detail detail) const;
    /// Root of the weighted mean square of Delta E 2000.
    double rms_delta_e(const std::vector<double>& residuals) const;

    /// Those that weigh anything.
    std::size_t geometry_count() const { return geometry_count_; }

 private:
    const std::vector<measure::Measurement>& standards(Detail detail) const {
        return standards_[static_cast<std::size_t>(detail)];
    }

    static constexpr std::size_t kDetails = 3;
    bool has_spectra_ = false;
    std::vector<measure::Geometry> geometries_;
    std::vector<double> root_weight_;  // by geometry
    std::size_t geometry_count_ = 0;   // with a weight above 0
    std::array<std::vector<double>, kDetails> wavelengths_nm_;
    std::array<std::vector<measure::Measurement>, kDetails> standards_;  // by illuminant
};

/// A measurement restated under other conditions, by its spectra.
/// @throws DomainError if it has none and the conditions differ
measure::Measurement restated(const measure::Measurement& measurement,
                              const measure::Conditions& conditions);

}  // namespace nacre::fit
