#include "nacre/fit/search.h"

#include <tbb/task_arena.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <mutex>
#include <numeric>

#include "nacre/core/error.h"
#include "nacre/core/parallel.h"
#include "nacre/fit/halton.h"

namespace nacre::fit {

namespace {

/// A few steps show which way a point goes.
constexpr DescentLimits kGlanceLimits{3, 1e-2, 1e-3, 0.1};
constexpr DescentLimits kCoarseLimits{20, 1e-3, 1e-4, 1e-2};
constexpr DescentLimits kFineLimits{50, 1e-4, 1e-5, 2e-3};

/// Points that make a few steps for each one that goes on.
constexpr int kRacersPerStart = 3;

/// Points looked at for each descent: as many as help, a line being filled by fewer than a cube.
constexpr std::size_t points_per_start(std::size_t numbers) {
    return std::min<std::size_t>(16, 4 + 4 * numbers);
}
/// Points nearer than this in every coordinate lie in the same valley: one descent will do.
constexpr double kSameValley = 0.05;
/// Ends of descents nearer than this are the same minimum.
constexpr double kSameMinimum = 0.02;
/// A spread of zero is a place where its derivative vanishes: no descent starts there.
constexpr double kOffTheFloor = 0.05;
/// Ends of coarse descents are carried through if their difference is so near to the best one's.
/// Without spectra coarse colours are off by up to 1.
constexpr double kWorthDelta_e = 0.5, kWorthWithoutSpectra_delta_e = 1.5;
constexpr std::size_t kMostCarriedThrough = 3;

// Shares of the work, for the bar.
constexpr double kGlanceShare = 0.15, kRaceShare = 0.25, kCoarseShare = 0.3, kFineShare = 0.25;

/// Adds up what threads have done and tells the caller, one at a time.
class Meter {
 public:
    Meter(ColourModel& model, const Progress& progress) : model_(model), progress_(progress) {}

    void begin(double share, double units) {
        base_ += share_;
        share_ = share;
        units_ = units;
        done_ = 0;
    }
    void add(double units) {
        const std::lock_guard lock(mutex_);
        done_ = std::min(done_ + units, units_);
        if (!progress_ || model_.stopped()) return;
        if (!progress_(std::min(1.0, base_ + share_ * done_ / units_))) model_.stop();
    }

 private:
    ColourModel& model_;
    const Progress& progress_;
    std::mutex mutex_;
    double base_ = 0, share_ = 0, units_ = 1, done_ = 0;
};

double distance(const std::vector<double>& a, const std::vector<double>& b) {
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
    return most;
}

void require_going(const ColourModel& model) {
    if (model.stopped()) throw Error("the fit was stopped before it was done");
}

struct Candidate {
    std::vector<double> x;
    double rms_delta_e = std::numeric_limits<double>::infinity();
};

std::vector<Candidate> glance(const ColourModel& model, std::vector<std::vector<double>> points,
                              Meter& meter) {
    std::vector<Candidate> candidates(points.size());
    meter.begin(kGlanceShare, static_cast<double>(points.size()));
    parallel_for_ranges(0, points.size(), 1, [&](std::size_t i, std::size_t) {
        candidates[i].x = points[i];
        // Waiting for a solve, a thread must not begin another point.
        tbb::this_task_arena::isolate([&] {
            if (const auto seen = model.evaluate(points[i], Detail::glance)) {
                candidates[i].rms_delta_e = model.target().rms_delta_e(seen->residuals);
            }
        });
        meter.add(1);
    });
    require_going(model);
    return candidates;
}

/// The first one, and the best of the others that lie apart.
std::vector<std::vector<double>> choose_starts(std::vector<Candidate> candidates,
                                               std::size_t most) {
    std::vector<std::vector<double>> chosen = {candidates[0].x};
    std::stable_sort(
        candidates.begin(), candidates.end(),
        [](const Candidate& a, const Candidate& b) { return a.rms_delta_e < b.rms_delta_e; });
    for (const Candidate& candidate : candidates) {
        if (chosen.size() >= most || !std::isfinite(candidate.rms_delta_e)) break;
        if (std::all_of(chosen.begin(), chosen.end(), [&](const auto& other) {
                return distance(candidate.x, other) >= kSameValley;
            })) {
            chosen.push_back(candidate.x);
        }
    }
    return chosen;
}

std::vector<Descent> descend_from(const ColourModel& model,
                                  const std::vector<std::vector<double>>& starts, Detail detail,
                                  const DescentLimits& limits, double share, Meter& meter) {
    std::vector<Descent> ends(starts.size());
    const double units = limits.most_steps + 1;
    meter.begin(share, units * static_cast<double>(starts.size()));
    parallel_for_ranges(0, starts.size(), 1, [&](std::size_t i, std::size_t) {
        tbb::this_task_arena::isolate(
            [&] { ends[i] = descend(model, starts[i], detail, limits, [&] { meter.add(1); }); });
        meter.add(units - ends[i].steps);
    });
    require_going(model);
    std::stable_sort(ends.begin(), ends.end(), [](const Descent& a, const Descent& b) {
        return a.rms_delta_e < b.rms_delta_e;
    });
    return ends;
}

std::vector<Descent> distinct(const std::vector<Descent>& ends) {
    std::vector<Descent> kept;
    for (const Descent& end : ends) {
        if (!std::isfinite(end.rms_delta_e)) break;
        if (std::all_of(kept.begin(), kept.end(), [&](const Descent& other) {
                return distance(end.x, other.x) >= kSameMinimum;
            })) {
            kept.push_back(end);
        }
    }
    return kept;
}

}  // namespace

std::vector<Descent> search(ColourModel& model, const std::vector<double>& start, int starts,
                            std::uint64_t seed, const Progress& progress, SearchEffort& effort) {
    Meter meter(model, progress);
    std::vector<std::vector<double>> points = {start};
    for (auto& point :
         halton_points(static_cast<std::size_t>(starts - 1) * points_per_start(start.size()),
                       start.size(), seed)) {
        points.push_back(std::move(point));
    }
    for (std::size_t i = 0; i < start.size(); ++i) {
        if (model.numbers()[i].bounds.lo > 0) continue;
        for (auto& point : points) point[i] = std::max(point[i], kOffTheFloor);
    }
    effort.points = static_cast<int>(points.size());
    const auto racers = choose_starts(glance(model, std::move(points), meter),
                                      static_cast<std::size_t>(starts) * kRacersPerStart);
    std::vector<std::vector<double>> beginnings = {racers[0]};
    if (racers.size() > 1) {
        for (const Descent& end : distinct(
                 descend_from(model, racers, Detail::glance, kGlanceLimits, kRaceShare, meter))) {
            if (beginnings.size() < static_cast<std::size_t>(starts)) beginnings.push_back(end.x);
        }
    }

    effort.descents = static_cast<int>(beginnings.size());
    const std::vector<Descent> coarse = distinct(
        descend_from(model, beginnings, Detail::coarse, kCoarseLimits, kCoarseShare, meter));
    if (coarse.empty()) throw Error(model.first_failure());

    std::vector<std::vector<double>> worthy;
    const double limit =
        coarse[0].rms_delta_e +
        (model.target().has_spectra() ? kWorthDelta_e : kWorthWithoutSpectra_delta_e);
    for (const Descent& end : coarse) {
        if (worthy.size() < kMostCarriedThrough && end.rms_delta_e <= limit) {
            worthy.push_back(end.x);
        }
    }
    effort.finished = static_cast<int>(worthy.size());
    std::vector<Descent> fine =
        distinct(descend_from(model, worthy, Detail::fine, kFineLimits, kFineShare, meter));
    if (fine.empty()) throw Error(model.first_failure());
    return fine;
}

}  // namespace nacre::fit
