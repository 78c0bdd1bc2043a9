#pragma once

#include <array>
#include <atomic>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "nacre/core/progress.h"
#include "nacre/fit/differences.h"
#include "nacre/fit/free_numbers.h"
#include "nacre/measure/difference.h"
#include "nacre/measure/measurement.h"
#include "nacre/solver/film_cache.h"
#include "nacre/solver/solved_paint.h"

// The target colours of a fit, and the residuals of a paint against them.

namespace nacre::fit {

/// The illuminants and the weights of the geometries of the comparison.
struct TargetOptions {
    /// Colours under all of them count equally. Empty: the standard's own.
    std::vector<spectra::Illuminant> illuminants;
    /// By the geometry's name, >= 0; those not named weigh 1.
    std::map<std::string, double> weights;
    /// Paints are read with the hot spot of large flakes (bsdf::HotSpotBrdf), instead of by the equation
    /// of transfer alone. Then the diameter of flakes changes colours too. Models say whether they show it:
    /// bsdf::Model::shows_hot_spot().
    bool hot_spot = false;
};

/// How accurately a paint is solved: for screening points far apart (every 40 nm), coarse for
/// descents (every 20 nm), both with point apertures; fine for the answer, at the standard's
/// wavelengths and through its aperture.
enum class Detail { screening, coarse, fine };

class Target {
 public:
    /// @throws DomainError if the standard has no reading, an illuminant other than its own
    ///         is asked for where it has no spectra, a weight is negative or names none of its
    ///         geometries, or all weights are 0
    Target(const measure::Measurement& standard, const TargetOptions& options);

    bool hot_spot() const { return hot_spot_; }
    /// The standard under the first illuminant.
    const measure::Measurement& standard() const { return standards_.back()[0]; }
    bool has_spectra() const { return has_spectra_; }
    const std::vector<double>& wavelengths_nm(Detail detail) const;

    std::size_t residual_count() const;
    /// What the standard's instrument reads on a paint that was solved at wavelengths_nm(detail),
    /// under the first illuminant.
    /// @throws DomainError, Error as bsdf::HotSpotBrdf with the hot spot
    measure::Measurement read(const solver::SolvedPaint& paint, Detail detail) const;
    /// For each illuminant and geometry the three components of the CIEDE2000 difference
    /// (spectra::delta_e_2000_vector), times the square root of the geometry's weight over the mean
    /// weight (of those above 0) and of one over the number of illuminants: the sum of
    /// squares over the number of geometries is the weighted mean square of Delta E 2000.
    std::vector<double> residuals(const solver::SolvedPaint& paint, Detail detail) const;
    /// Root of the weighted mean square of Delta E 2000.
    double rms_delta_e(const std::vector<double>& residuals) const;
    /// The same between two paints, of what read() says about them, under all illuminants.
    double rms_delta_e(const measure::Measurement& a, const measure::Measurement& b) const;

    /// Of a paint's readings from the standard, under the first illuminant, weighted.
    measure::Difference difference(const measure::Measurement& sample) const {
        return measure::difference(standard(), sample, weights_);
    }

    /// How many have a weight above 0.
    std::size_t geometry_count() const { return geometry_count_; }

 private:
    const std::vector<measure::Measurement>& standards(Detail detail) const {
        return standards_[static_cast<std::size_t>(detail)];
    }

    static constexpr std::size_t kDetails = 3;
    bool has_spectra_ = false, hot_spot_ = false;
    std::map<std::string, double> weights_;
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

/// What a fit says that was stopped.
inline constexpr const char* kStopped = "the fit was stopped before it was done";

/// From a point of the unit cube to the residuals, whose sum of squares the fit minimises. Safe to
/// call from several threads at once.
class ColourModel {
 public:
    /// @param work  asked, while paints are solved, whether to go on
    ColourModel(const FreeNumbers& numbers, const Target& target, SharedProgress& work);

    const FreeNumbers& numbers() const { return numbers_; }
    const Target& target() const { return target_; }

    /// Solves the paint at x; the values are the residuals. Empty where there is no such paint (see
    /// PointFunction; first_failure() says which was met first), and always once stop() was called.
    std::optional<Evaluation> evaluate(std::span<const double> x, Detail detail,
                                       const solver::SolverSettings* settings = nullptr) const;

    /// What the standard's instrument reads at x (Target::read()), solved finely. Empty as
    /// evaluate().
    std::optional<measure::Measurement> colours(std::span<const double> x) const;

    /// differences() of the residuals, forward (backward at the upper bound). Empty as evaluate().
    std::optional<std::vector<double>> jacobian(std::span<const double> x, const Evaluation& at_x,
                                                Detail detail) const;
    /// Central differences as far as the bounds allow, whose error is of second order: for
    /// uncertainties.
    std::optional<std::vector<double>> central_jacobian(std::span<const double> x,
                                                        const Evaluation& at_x,
                                                        Detail detail) const;

    /// Whether the caller asked to stop.
    bool stopped() const { return work_.stopped(); }
    int solves() const { return solves_; }
    std::size_t films() const;
    std::string first_failure() const;

 private:
    /// Something of the paint at x and how it was solved; empty as evaluate().
    template <class Read>
    auto solved(std::span<const double> x, Detail detail, const solver::SolverSettings* settings,
                const Read& read) const -> std::optional<decltype(read(std::declval<Solution>()))>;
    std::optional<std::vector<double>> derivatives(std::span<const double> x,
                                                   const Evaluation& at_x, Detail detail,
                                                   bool central) const;

    const FreeNumbers& numbers_;
    const Target& target_;
    SharedProgress& work_;
    mutable std::array<solver::FilmCache, 3> films_;  // by detail
    mutable std::atomic<int> solves_ = 0;
    mutable std::mutex mutex_;
    mutable std::string first_failure_;
};

}  // namespace nacre::fit
