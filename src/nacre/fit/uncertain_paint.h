#pragma once

#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/fit/differences.h"
#include "nacre/fit/uncertain_values.h"
#include "nacre/fit/uncertainty.h"

namespace nacre::fit {

/// A paint read at recipes beside its own: points in standard deviations from the recipe's numbers.
class UncertainPaint {
 public:
    /// References must outlive it.
    /// @param root  of the numbers' correlations, as Sensitivities::root
    UncertainPaint(const paint::Recipe& recipe, std::vector<double> root, const PaintReader& reader,
                   SharedProgress& work)
        : recipe_(recipe), root_(std::move(root)), reader_(reader), work_(work) {}

    void add(const UncertainNumber& number, const Range& range) {
        numbers_.push_back(number);
        ranges_.push_back(range);
    }
    std::vector<UncertainNumber>& numbers() { return numbers_; }

    /// The point of numbers that are made of independent ones: L z.
    std::vector<double> correlated(const std::vector<double>& z) const;
    paint::Recipe at(std::span<const double> point) const;
    /// Whether there is such a recipe, solvable or not.
    bool is_valid(std::span<const double> point) const;
    /// None where there is no such paint, or the work was stopped. From any thread.
    std::optional<Evaluation> evaluate(std::span<const double> point,
                                       const solver::SolverSettings* like);
    /// @throws Error if a number can be moved to neither side; Stopped
    Sensitivities moves(const Evaluation& centre);

    /// @throws Stopped
    void throw_if_stopped() const;
    std::string first_failure() const { return first_failure_; }

 private:
    /// One standard deviation to either side in each direction and in each pair of them.
    void add_wide_steps(const Evaluation& centre, Sensitivities& moves);
    /// Whether any number that is uncertain moves in a direction.
    bool moves_anything(std::size_t direction) const;

    const paint::Recipe& recipe_;
    std::vector<double> root_;
    const PaintReader& reader_;
    SharedProgress& work_;
    std::vector<UncertainNumber> numbers_;
    std::vector<Range> ranges_;
    std::mutex mutex_;
    std::string first_failure_;
};

}  // namespace nacre::fit
