#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "nacre/core/progress.h"
#include "nacre/fit/differences.h"
#include "nacre/measure/measurement.h"
#include "nacre/paint/parameter_correlation.h"
#include "nacre/paint/parameter_deviation.h"

// From how well the numbers of a recipe are known to how well its colours are: docs/uncertainty.md.

namespace nacre::fit {

/// A number of a recipe that is known to a standard deviation only.
struct UncertainNumber {
    std::string key;
    double value = 0, standard_deviation = 0;
    /// Whether some number within kSigmasOfRange deviations makes no valid recipe: it is then not
    /// normal, whatever was said.
    bool meets_range = false;

    static constexpr double kSigmasOfRange = 3;
};

/// Covariances of L*, a* and b*.
using LabCovariance = std::array<Vec3d, 3>;

/// How far one reading is spread.
struct Spread {
    Vec3d mean{};  ///< of L*, a*, b*
    LabCovariance covariance{};
    /// Standard deviation of C*; none where the spread of a*b* reaches a third of the way to grey,
    /// as chroma has a corner there.
    std::optional<double> chroma;
    std::optional<double> hue_deg;             ///< likewise; grey has no hue
    std::vector<double> reflectance_factor{};  ///< by wavelength; empty without spectra

    Vec3d lab() const;  ///< standard deviations of L*, a*, b*
};

/// The ellipse in the a*b* plane that holds a normal colour with some probability.
struct Ellipse {
    std::array<double, 2> centre{};          ///< a*, b*
    std::array<double, 2> major{}, minor{};  ///< semi-axes
};
/// @param probability  in (0, 1): 0.95 is 2.45 standard deviations of each axis
/// @throws DomainError if it is not
Ellipse ab_ellipse(const Spread& spread, double probability);

/// How well first order describes a quantity: what the next terms of its variance amount to.
struct Linearity {
    /// Standard deviation that the next terms stand for, over that of first order; infinite where
    /// that is 0.
    double beyond = 0;
    /// Whether a number could not be moved by its standard deviation to either side.
    bool unknown = false;
    /// Whether the next terms change the standard deviation by more than 5 % of itself (a tenth of
    /// the variance) and by more than kNoticed, in units of the quantity; or are unknown.
    bool fails = false;

    static constexpr double kNoticed = 0.02;
};

/// What is reported of a colour.
enum class Quantity { lightness, a, b, chroma, hue };
inline constexpr std::array kQuantities = {Quantity::lightness, Quantity::a, Quantity::b,
                                           Quantity::chroma, Quantity::hue};
/// L, a, b, C, h.
const char* name_of(Quantity quantity);

struct ReadingUncertainty {
    measure::Reading reading;  ///< of the recipe as it is
    Spread first_order;
    std::optional<Spread> sampled;
    /// By number: the change of L*, a*, b* with one standard deviation of it, to first order. With
    /// C of these rows and the numbers' correlations R the covariance is C^T R C.
    std::vector<Vec3d> change;
    /// The mean less the reading, to second order.
    Vec3d mean_shift{};
    /// By Quantity, hue in degrees; nothing is said of chroma and hue where they have no spread.
    std::array<Linearity, kQuantities.size()> linearity{};

    const Spread& best() const { return sampled ? *sampled : first_order; }
    /// The standard deviation of a quantity, by best(). None as Spread::chroma.
    std::optional<double> deviation(Quantity quantity) const;
    /// The change of a quantity with one standard deviation of each number, to first order; empty
    /// where it has no spread.
    std::vector<double> change_of(Quantity quantity) const;
    /// The quantities for which first order is not enough.
    std::vector<Quantity> doubtful() const;
};

/// Of a quantity that several readings make.
struct MetricUncertainty {
    double value = 0;
    double first_order = 0;  ///< standard deviation
    std::optional<double> sampled;
    std::vector<double> change;  ///< as ReadingUncertainty::change
    double mean_shift = 0;
    Linearity linearity;

    double best() const { return sampled.value_or(first_order); }
};

/// Which part of a quantity's variance each number makes, in first order: the covariance of what it
/// changes with the quantity, c_i sum_j r_ij c_j, over the variance. They sum to 1, or are all 0 if
/// there is no variance but that of rounding. Of independent numbers none is negative; of correlated
/// ones each has half of what it and another make together, and is negative where it cancels more
/// than it adds.                                                                  [li-2010]
/// Those of all of L*, a* and b* together for Vec3d.
/// @param change       by number, with one standard deviation of it
/// @param correlation  of the numbers, row by row; empty: they are independent
std::vector<double> variance_fractions(const std::vector<double>& change,
                                       const std::vector<double>& correlation = {});
std::vector<double> variance_fractions(const std::vector<Vec3d>& change,
                                       const std::vector<double>& correlation = {});

struct Uncertainty {
    measure::Measurement measurement;  ///< of the recipe as it is
    std::vector<UncertainNumber> numbers;
    /// Of the numbers, row by row; empty where all are independent.
    std::vector<double> correlation;
    std::vector<ReadingUncertainty> readings;  ///< in the order of the measurement's
    /// None where the measurement has no such number.
    std::optional<MetricUncertainty> flop_index, colour_travel;
    int samples = 0;  ///< 0: no sampling
    /// Draws that made no valid recipe and were drawn again: normal laws are cut off there.
    int redrawn = 0;

    /// The coefficients of one number with all.
    std::vector<double> correlation_of(std::size_t number) const;
    /// Whether first order is doubtful anywhere: a quantity's linearity fails, or a number meets the
    /// end of its range.
    bool first_order_fails() const;
};

/// Reads a paint as an instrument does. Must give the same for the same recipe, whatever the thread.
/// @param like  as solve_alike(); ignored by what solves nothing
/// @throws DomainError, Error where there is no such paint
struct PaintReading {
    measure::Measurement measurement;
    solver::SolverSettings settings;
};
using PaintReader = std::function<PaintReading(
    const paint::Recipe& recipe, const solver::SolverSettings* like, SharedProgress& work)>;

/// By solving paints as a fit does. The reader may be called from several threads at once.
PaintReader solution_reader(std::vector<double> wavelengths_nm,
                            std::vector<measure::Geometry> geometries,
                            const measure::Conditions& conditions, bool hot_spot);

struct UncertaintyOptions {
    /// 0: first order alone. Else so many recipes are drawn and read besides.
    int samples = 0;
    std::uint64_t seed = 0;  ///< of the draws
    /// Which numbers are wrong together; others are independent.
    std::vector<paint::ParameterCorrelation> correlations = {};

    static constexpr int kMinSamples = 10, kMaxSamples = 1'000'000;
};

/// Carries standard deviations of numbers of a recipe to its colours.
///
/// First order: with the Jacobian J of the readings and the covariance S of the numbers,
/// S_ij = s_i s_j r_ij, that of the readings is J S J^T.                  [jcgm-100-2008, eq. 13]
/// J is that of central differences over 0.4 % of each number (or of its deviation, if that is
/// more); a number at the end of its range has a one-sided one. The next terms, of all second
/// derivatives and of the third ones along a single direction, are those of readings one standard
/// deviation to either side of each number and each pair.               [jcgm-100-2008, 5.1.2, note]
/// For n numbers the paint is read 1 + 3 n + n^2 times. Where numbers are correlated, numbers of the
/// next terms are the independent ones of which they are made, x = L z with the Cholesky root L of R.
///
/// Sampling: numbers are drawn from the joint normal law about the recipe's, as L z; draws that make
/// no valid recipe are drawn again.                  [jcgm-101-2008, clause 7 and 6.4.8]
///
/// The answer does not depend on the number of threads.
/// @param deviations  each of another number; those of 0 are carried along as zeros
/// @throws DomainError as paint::check_deviation() and paint::check_correlations(), if there are no
///         deviations, one is named twice, or the number of samples is out of range
/// @throws Error as the reader throws for the recipe as it is; if a number can be moved to neither
///         side, or none of 1000 draws in a row makes a valid recipe; Stopped if `progress` asks to
///         stop
Uncertainty uncertainty(const paint::Recipe& recipe,
                        const std::vector<paint::ParameterDeviation>& deviations,
                        const PaintReader& reader, const UncertaintyOptions& options = {},
                        const Progress& progress = {});

}  // namespace nacre::fit
