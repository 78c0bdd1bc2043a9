#pragma once

#include <array>
#include <atomic>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "nacre/fit/free_numbers.h"
#include "nacre/fit/target.h"
#include "nacre/layers/film_cache.h"
#include "nacre/layers/solver.h"

namespace nacre::fit {

/// From a point of the unit cube to the differences from the standard: the function whose squares
/// are to be least. May be asked from several threads at once.
class ColourModel {
 public:
    struct Evaluation {
        std::vector<double> residuals;
        /// Nodes and orders that were chosen for this point: what its neighbours must be solved
        /// with, or the choice would make the function jump between them.
        layers::SolverSettings settings;
    };

    ColourModel(const FreeNumbers& numbers, const Target& target);

    const FreeNumbers& numbers() const { return numbers_; }
    const Target& target() const { return target_; }

    /// Solves the paint at x. Empty where there is no such paint (numbers that exclude each other,
    /// a lobe that the solver cannot resolve; first_failure() says which was met first), and always
    /// once stop() was called.
    std::optional<Evaluation> evaluate(std::span<const double> x, Detail detail,
                                       const layers::SolverSettings* settings = nullptr) const;

    /// Differences forward (backward at the upper bound, or where there is no paint ahead), each
    /// number's solve on a thread of its own: rows of residuals, columns of numbers. Empty as
    /// evaluate().
    std::optional<std::vector<double>> jacobian(std::span<const double> x, const Evaluation& at_x,
                                                Detail detail) const;
    /// Central differences as far as the bounds allow, whose error is of second order: for
    /// uncertainties.
    std::optional<std::vector<double>> central_jacobian(std::span<const double> x,
                                                        const Evaluation& at_x,
                                                        Detail detail) const;

    void stop() { stopped_ = true; }
    bool stopped() const { return stopped_; }
    int solves() const { return solves_; }
    std::size_t films() const;
    std::string first_failure() const;

 private:
    /// Steps from x along one axis, between the bounds, that the differences are taken over.
    struct Steps {
        double back = 0, ahead = 0;
    };
    std::optional<std::vector<double>> differences(std::span<const double> x,
                                                   const Evaluation& at_x, Detail detail,
                                                   bool central) const;
    bool column(std::span<const double> x, const Evaluation& at_x, Detail detail,
                std::size_t number, Steps steps, std::span<double> jacobian) const;

    const FreeNumbers& numbers_;
    const Target& target_;
    mutable std::array<layers::FilmCache, 3> films_;  // by detail
    mutable std::atomic<int> solves_ = 0;
    std::atomic<bool> stopped_ = false;
    mutable std::mutex mutex_;
    mutable std::string first_failure_;
};

}  // namespace nacre::fit
