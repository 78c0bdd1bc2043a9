#include "nacre/fit/uncertainty.h"

#include <fmt/format.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <mutex>
#include <numbers>
#include <numeric>

#include "nacre/core/error.h"
#include "nacre/core/parallel.h"
#include "nacre/core/random.h"
#include "nacre/paint/recipe_parameter.h"

namespace nacre::fit {

namespace {

constexpr const char* kUncertaintyStopped = "the uncertainties were stopped before they were done";

/// Step of the derivatives, as a fraction of a number or of its deviation if that is more. As wide
/// as those of a fit: 2e-3 of its default bounds, over the logarithm of a ninefold range.
constexpr double kRelativeStep = 4e-3;

/// Next terms of a variance below this fraction of it are not worth a remark.
constexpr double kBeyondFirstOrder = 0.1;

/// The spread of a*b* is too wide for chroma and hue if so many of its standard deviations reach
/// grey.
constexpr double kSigmasToGrey = 3;

/// Standard deviations below this are those of rounding, as a* of a grey paint has.
constexpr double kRounding = 1e-9;

double squared(double x) { return x * x; }

// ------------------------------------------------------------------------------ quantities

/// All that is reported of a measurement in a row: L*, a*, b* of each reading, its spectrum, and
/// then the metrics, which are NaN where there are none.
struct Layout {
    std::size_t readings = 0, wavelengths = 0;

    std::size_t lab(std::size_t reading) const { return reading * (3 + wavelengths); }
    std::size_t spectrum(std::size_t reading) const { return lab(reading) + 3; }
    std::size_t flop() const { return lab(readings); }
    std::size_t travel() const { return flop() + 1; }
    std::size_t size() const { return travel() + 1; }
};

std::vector<double> values_of(const measure::Measurement& measurement) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> values;
    for (const measure::Reading& reading : measurement.readings) {
        for (int c = 0; c < 3; ++c) values.push_back(reading.lab[c]);
        values.insert(values.end(), reading.reflectance_factor.begin(),
                      reading.reflectance_factor.end());
    }
    values.push_back(measure::flop_index(measurement).value_or(kNone));
    const measure::ColourTravel travel = measure::colour_travel(measurement);
    values.push_back(travel.path.size() > 1 ? travel.length : kNone);
    return values;
}

using Values = std::vector<double>;

/// Values one standard deviation to either side of a number, or of two at once; none where there is
/// no paint.
struct BothSides {
    std::optional<Values> up, down;
};

/// Several values and how the numbers move them.
struct Moves {
    Values centre;
    std::vector<double>
        first;  ///< by value and number: with one standard deviation, to first order
    std::vector<BothSides> alone;  ///< by number
    std::vector<BothSides> pairs;  ///< by pair (0, 1), (0, 2), ..., (1, 2), ...
    std::size_t numbers = 0;

    std::vector<double> of(std::size_t value) const {
        return {first.begin() + static_cast<std::ptrdiff_t>(value * numbers),
                first.begin() + static_cast<std::ptrdiff_t>((value + 1) * numbers)};
    }
};

double sum_of(const std::vector<double>& x) { return std::accumulate(x.begin(), x.end(), 0.0); }
double sum_of_squares(const std::vector<double>& x) {
    return std::inner_product(x.begin(), x.end(), x.begin(), 0.0);
}

/// What follows first order in one quantity.
struct NextTerms {
    double mean_shift = 0;
    Linearity linearity;
};

/// The terms of the mean and of the variance that follow those of first order. With standard
/// deviations s the mean's is the sum of f_ii s_i^2 / 2, the variance's are f_ii^2 s_i^4 / 2 and
/// f_i f_iii s_i^4 of each number, and f_ij^2 s_i^2 s_j^2 of each pair; of the terms of that order
/// f_i f_ijj s_i^2 s_j^2 is left out.
/// @param first   f_i s_i
/// @param change  of the quantity from the centre to some values
template <class Change>
NextTerms next_terms(const std::vector<double>& first, const Moves& moves, const Change& change) {
    NextTerms out;
    double next = 0;
    const auto even_part = [&](const BothSides& sides) {
        return (change(*sides.up) + change(*sides.down)) / 2;
    };
    std::vector<double> even(moves.numbers, 0.0);  // f_ii s_i^2 / 2
    for (std::size_t i = 0; i < moves.numbers; ++i) {
        const BothSides& sides = moves.alone[i];
        if (!sides.up || !sides.down) {
            out.linearity.unknown = true;
            continue;
        }
        even[i] = even_part(sides);
        const double odd = (change(*sides.up) - change(*sides.down)) / 2;
        next += 2 * squared(even[i]) + std::abs(6 * first[i] * (odd - first[i]));
    }
    out.mean_shift = sum_of(even);
    std::size_t pair = 0;
    for (std::size_t i = 0; i < moves.numbers; ++i) {
        for (std::size_t j = i + 1; j < moves.numbers; ++j, ++pair) {
            const BothSides& sides = moves.pairs[pair];
            if (sides.up && sides.down) next += squared(even_part(sides) - even[i] - even[j]);
        }
    }
    const double variance = sum_of_squares(first);
    if (next > 0) out.linearity.beyond = std::sqrt(next / variance);
    out.linearity.fails = out.linearity.unknown ||
                          (next > kBeyondFirstOrder * variance &&
                           std::sqrt(variance + next) - std::sqrt(variance) > Linearity::kNoticed);
    return out;
}

double hue_between_deg(const Vec3d& from, const Vec3d& to) {
    return std::remainder(measure::hue_deg(to) - measure::hue_deg(from), 360);
}

// ------------------------------------------------------------------------------ first order

void add_chroma_and_hue(Spread& spread, const Vec3d& lab) {
    const double chroma = measure::chroma(lab);
    const Ellipse one_sigma = ab_ellipse(spread, 1 - std::exp(-0.5));
    if (!(std::hypot(one_sigma.major[0], one_sigma.major[1]) * kSigmasToGrey < chroma)) return;
    const auto along = [&](double da, double db) {
        const LabCovariance& s = spread.covariance;
        return std::sqrt(
            std::max(0.0, da * da * s[1][1] + 2 * da * db * s[1][2] + db * db * s[2][2]));
    };
    const double a = lab[1] / chroma, b = lab[2] / chroma;
    spread.chroma = along(a, b);
    spread.hue_deg = along(-b, a) / chroma * 180 / std::numbers::pi;
}

ReadingUncertainty reading_of(const measure::Reading& reading, std::size_t lab,
                              std::size_t spectrum, const Moves& moves) {
    ReadingUncertainty out;
    out.reading = reading;
    out.change.resize(moves.numbers);
    out.first_order.mean = reading.lab;
    for (int c = 0; c < 3; ++c) {
        const std::vector<double> row = moves.of(lab + static_cast<std::size_t>(c));
        for (std::size_t i = 0; i < moves.numbers; ++i) out.change[i][c] = row[i];
    }
    for (const Vec3d& change : out.change) {
        for (int r = 0; r < 3; ++r) {
            for (int c = 0; c < 3; ++c) out.first_order.covariance[r][c] += change[r] * change[c];
        }
    }
    for (std::size_t k = 0; k < reading.reflectance_factor.size(); ++k) {
        out.first_order.reflectance_factor.push_back(
            std::sqrt(sum_of_squares(moves.of(spectrum + k))));
    }
    add_chroma_and_hue(out.first_order, reading.lab);
    for (const Quantity quantity : kQuantities) {
        const auto q = static_cast<std::size_t>(quantity);
        const std::vector<double> first = out.change_of(quantity);
        if (first.empty()) continue;
        const NextTerms next = next_terms(first, moves, [&](const Values& values) {
            const Vec3d to{values[lab], values[lab + 1], values[lab + 2]};
            if (quantity == Quantity::hue) return hue_between_deg(reading.lab, to);
            if (quantity == Quantity::chroma) {
                return measure::chroma(to) - measure::chroma(reading.lab);
            }
            return values[lab + q] - moves.centre[lab + q];
        });
        out.linearity[q] = next.linearity;
        if (q < 3) out.mean_shift[static_cast<int>(q)] = next.mean_shift;
    }
    return out;
}

std::optional<MetricUncertainty> metric_of(std::size_t position, const Moves& moves) {
    MetricUncertainty out;
    out.value = moves.centre[position];
    out.change = moves.of(position);
    out.first_order = std::sqrt(sum_of_squares(out.change));
    if (!std::isfinite(out.value) || !std::isfinite(out.first_order)) return std::nullopt;
    const NextTerms next = next_terms(out.change, moves, [&](const Values& values) {
        return values[position] - moves.centre[position];
    });
    // Not finite where a number takes the metric to where it has no value.
    if (std::isfinite(next.mean_shift) && !std::isnan(next.linearity.beyond)) {
        out.mean_shift = next.mean_shift;
        out.linearity = next.linearity;
    } else {
        out.linearity = {0, true, true};
    }
    return out;
}

// ------------------------------------------------------------------------------ the paints

class UncertainPaint {
 public:
    UncertainPaint(const paint::Recipe& recipe, const PaintReader& reader, SharedProgress& work)
        : recipe_(recipe), reader_(reader), work_(work) {}

    void add(const UncertainNumber& number, const Range& range) {
        numbers_.push_back(number);
        ranges_.push_back(range);
    }
    std::vector<UncertainNumber>& numbers() { return numbers_; }

    /// In standard deviations from the recipe's own numbers.
    paint::Recipe at(std::span<const double> point) const {
        paint::Recipe recipe = recipe_;
        for (std::size_t i = 0; i < numbers_.size(); ++i) {
            if (point[i] == 0) continue;
            paint::set_parameter(recipe, numbers_[i].key,
                                 numbers_[i].value + numbers_[i].standard_deviation * point[i]);
        }
        return recipe;
    }

    /// Whether there is such a recipe, solvable or not.
    bool is_valid(std::span<const double> point) const {
        try {
            paint::validate(at(point), {});
            return true;
        } catch (const DomainError&) {
            return false;
        }
    }

    std::optional<Evaluation> evaluate(std::span<const double> point,
                                       const solver::SolverSettings* like) {
        if (work_.stopped()) return std::nullopt;
        std::optional<Evaluation> out;
        try {
            // Waiting for parts of a solve, a thread must not begin another paint.
            tbb::this_task_arena::isolate([&] {
                const PaintReading read = reader_(at(point), like, work_);
                out = Evaluation{values_of(read.measurement), read.settings};
            });
        } catch (const Error& error) {
            const std::lock_guard lock(mutex_);
            if (first_failure_.empty()) first_failure_ = error.what();
            return std::nullopt;
        }
        work_.add();
        return out;
    }

    Moves moves(const Evaluation& centre) {
        const std::vector<double> origin(numbers_.size(), 0.0);
        std::vector<StepAlong> steps;
        for (std::size_t i = 0; i < numbers_.size(); ++i) {
            const double value = numbers_[i].value, sigma = numbers_[i].standard_deviation;
            if (sigma == 0) {
                steps.emplace_back();
                continue;
            }
            steps.push_back({kRelativeStep * std::max(std::abs(value) / sigma, 1.0),
                             (value - ranges_[i].lo) / sigma, (ranges_[i].hi - value) / sigma});
        }
        const auto function = [&](std::span<const double> point,
                                  const solver::SolverSettings* like) {
            return evaluate(point, like);
        };
        auto jacobian = differences(function, origin, centre, steps, true);
        require_going();
        if (!jacobian) {
            throw Error("a number can be moved to neither side: " + first_failure_);
        }
        Moves moves{centre.values, std::move(*jacobian), {}, {}, numbers_.size()};
        add_wide_steps(centre, moves);
        return moves;
    }

    void require_going() const {
        if (work_.stopped()) throw Stopped(kUncertaintyStopped);
    }
    std::string first_failure() const { return first_failure_; }

 private:
    /// One standard deviation to either side of each number and of each pair.
    void add_wide_steps(const Evaluation& centre, Moves& moves) {
        const std::size_t count = numbers_.size();
        std::vector<std::vector<std::size_t>> moved;  // at once
        for (std::size_t i = 0; i < count; ++i) moved.push_back({i});
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t j = i + 1; j < count; ++j) moved.push_back({i, j});
        }
        std::vector<std::optional<Values>> values(2 * moved.size());
        parallel_for_ranges(0, values.size(), 1, [&](std::size_t k, std::size_t) {
            std::vector<double> point(count, 0.0);
            bool uncertain = true;
            for (const std::size_t i : moved[k / 2]) {
                point[i] = k % 2 == 0 ? 1 : -1;
                uncertain = uncertain && numbers_[i].standard_deviation > 0;
            }
            if (!uncertain) {
                if (moved[k / 2].size() == 1) values[k] = centre.values;
                return;
            }
            if (auto beside = evaluate(point, &centre.settings)) {
                values[k] = std::move(beside->values);
            }
        });
        require_going();
        for (std::size_t m = 0; m < moved.size(); ++m) {
            (m < count ? moves.alone : moves.pairs)
                .push_back({std::move(values[2 * m]), std::move(values[2 * m + 1])});
        }
    }

    const paint::Recipe& recipe_;
    const PaintReader& reader_;
    SharedProgress& work_;
    std::vector<UncertainNumber> numbers_;
    std::vector<Range> ranges_;
    std::mutex mutex_;
    std::string first_failure_;
};

// ------------------------------------------------------------------------------ sampling

/// Two of a normal law with standard deviation 1, by Box and Muller's transform.
std::array<double, 2> normal_pair(Rng& rng) {
    const double radius = std::sqrt(-2 * std::log(1 - rng.uniform_double()));
    const double angle = 2 * std::numbers::pi * rng.uniform_double();
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

constexpr int kMaxRedraws = 1000;  // of one sample
constexpr std::size_t kSamplesAtOnce = 256;

/// Sums over samples of what is spread, less its value at the recipe, so that they stay small.
struct SampledSums {
    explicit SampledSums(const Layout& l)
        : layout(l),
          sum(l.size()),
          squares(l.size()),
          products(3 * l.readings),
          chroma(2 * l.readings),
          hue(2 * l.readings) {}

    void add(const std::vector<double>& centre, const std::vector<double>& values) {
        ++count;
        for (std::size_t i = 0; i < values.size(); ++i) {
            const double d = values[i] - centre[i];
            sum[i] += d;
            squares[i] += d * d;
        }
        for (std::size_t r = 0; r < layout.readings; ++r) {
            const std::size_t at = layout.lab(r);
            const auto d = [&](std::size_t c) { return values[at + c] - centre[at + c]; };
            products[3 * r] += d(0) * d(1);
            products[3 * r + 1] += d(0) * d(2);
            products[3 * r + 2] += d(1) * d(2);
            const Vec3d here{values[at], values[at + 1], values[at + 2]};
            const Vec3d there{centre[at], centre[at + 1], centre[at + 2]};
            add_to(chroma, r, measure::chroma(here) - measure::chroma(there));
            add_to(hue, r, hue_between_deg(there, here));
        }
    }

    double covariance(double sum_of_products, double sum_a, double sum_b) const {
        return (sum_of_products - sum_a * sum_b / count) / (count - 1);
    }
    double deviation(std::size_t i) const {
        return std::sqrt(std::max(0.0, covariance(squares[i], sum[i], sum[i])));
    }

    Spread spread(std::size_t r, const std::vector<double>& centre) const {
        Spread out;
        const std::size_t at = layout.lab(r);
        for (std::size_t c = 0; c < 3; ++c) {
            out.mean[static_cast<int>(c)] = centre[at + c] + sum[at + c] / count;
            out.covariance[c][static_cast<int>(c)] = squared(deviation(at + c));
        }
        constexpr std::size_t kPairs[3][2] = {{0, 1}, {0, 2}, {1, 2}};
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [i, j] = kPairs[k];
            const double c = covariance(products[3 * r + k], sum[at + i], sum[at + j]);
            out.covariance[i][static_cast<int>(j)] = out.covariance[j][static_cast<int>(i)] = c;
        }
        for (std::size_t k = 0; k < layout.wavelengths; ++k) {
            out.reflectance_factor.push_back(deviation(layout.spectrum(r) + k));
        }
        add_chroma_and_hue(out, out.mean);  // says whether they are determined
        const auto own = [&](const std::vector<double>& sums) {
            return std::sqrt(std::max(0.0, covariance(sums[2 * r + 1], sums[2 * r], sums[2 * r])));
        };
        if (out.chroma) out.chroma = own(chroma);
        if (out.hue_deg) out.hue_deg = own(hue);
        return out;
    }

    Layout layout;
    double count = 0;
    std::vector<double> sum, squares, products, chroma, hue;

 private:
    static void add_to(std::vector<double>& sums, std::size_t r, double d) {
        sums[2 * r] += d;
        sums[2 * r + 1] += d * d;
    }
};

struct Draw {
    std::optional<std::vector<double>> values;
    int redrawn = 0;
};

/// One paint whose numbers are drawn from their laws, from a stream of its own.
Draw draw_paint(UncertainPaint& paint, std::uint64_t seed, std::size_t sample) {
    Rng rng(seed, sample);
    Draw draw;
    std::vector<double> point(paint.numbers().size());
    for (; draw.redrawn < kMaxRedraws; ++draw.redrawn) {
        for (std::size_t i = 0; i < point.size(); i += 2) {
            const auto [first, second] = normal_pair(rng);
            point[i] = first;
            if (i + 1 < point.size()) point[i + 1] = second;
        }
        if (paint.is_valid(point)) break;
    }
    if (draw.redrawn == kMaxRedraws) return draw;
    if (auto read = paint.evaluate(point, nullptr)) draw.values = std::move(read->values);
    return draw;
}

SampledSums sampled_sums(UncertainPaint& paint, const Layout& layout,
                         const std::vector<double>& centre, const UncertaintyOptions& options,
                         int& redrawn) {
    SampledSums sums(layout);
    const auto total = static_cast<std::size_t>(options.samples);
    for (std::size_t first = 0; first < total; first += kSamplesAtOnce) {
        const std::size_t count = std::min(kSamplesAtOnce, total - first);
        std::vector<Draw> draws(count);
        parallel_for_ranges(0, count, 1, [&](std::size_t i, std::size_t) {
            draws[i] = draw_paint(paint, options.seed, first + i);
        });
        paint.require_going();
        for (const Draw& draw : draws) {
            redrawn += draw.redrawn;
            if (!draw.values) {
                throw Error(fmt::format(
                    "a paint that was drawn from the standard deviations has no colours: {}",
                    draw.redrawn == kMaxRedraws
                        ? fmt::format("none of {} draws was a valid recipe", kMaxRedraws)
                        : paint.first_failure()));
            }
            sums.add(centre, *draw.values);
        }
    }
    return sums;
}

void check(const std::vector<paint::ParameterDeviation>& deviations,
           const UncertaintyOptions& options) {
    if (deviations.empty()) {
        throw DomainError(
            "no number of the recipe has a standard deviation: there is nothing to "
            "carry through");
    }
    for (std::size_t i = 0; i < deviations.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (deviations[i].key != deviations[j].key) continue;
            throw DomainError(
                fmt::format("{}: is named twice among the uncertain numbers", deviations[i].key));
        }
    }
    if (options.samples == 0) return;
    require_in_range(options.samples, UncertaintyOptions::kMinSamples,
                     UncertaintyOptions::kMaxSamples, "samples of the uncertainty");
}

}  // namespace

Vec3d Spread::lab() const {
    return {std::sqrt(covariance[0][0]), std::sqrt(covariance[1][1]), std::sqrt(covariance[2][2])};
}

Ellipse ab_ellipse(const Spread& spread, double probability) {
    if (!(probability > 0 && probability < 1)) {
        throw DomainError(
            fmt::format("probability of an ellipse = {}: must be in (0, 1)", probability));
    }
    const double aa = spread.covariance[1][1], bb = spread.covariance[2][2];
    const double ab = spread.covariance[1][2];
    // Eigenvalues and directions of the symmetric matrix ((aa, ab), (ab, bb)).
    const double mean = (aa + bb) / 2, radius = std::hypot((aa - bb) / 2, ab);
    const double angle = std::atan2(2 * ab, aa - bb) / 2;
    // The square of a normal vector's length in standard deviations is exponential, of mean 2.
    const double scale = std::sqrt(-2 * std::log1p(-probability));
    const double major = scale * std::sqrt(mean + radius);
    const double minor = scale * std::sqrt(std::max(0.0, mean - radius));
    return {{spread.mean[1], spread.mean[2]},
            {major * std::cos(angle), major * std::sin(angle)},
            {-minor * std::sin(angle), minor * std::cos(angle)}};
}

std::vector<double> shares(const std::vector<double>& change) {
    const double variance = sum_of_squares(change);
    std::vector<double> out(change.size(), 0.0);
    if (!(variance > squared(kRounding))) return out;
    for (std::size_t i = 0; i < change.size(); ++i) out[i] = squared(change[i]) / variance;
    return out;
}

std::vector<double> shares(const std::vector<Vec3d>& change) {
    std::vector<double> lengths;
    for (const Vec3d& c : change) lengths.push_back(std::hypot(c[0], c[1], c[2]));
    return shares(lengths);
}

const char* name_of(Quantity quantity) {
    constexpr const char* kNames[] = {"L", "a", "b", "C", "h"};
    return kNames[static_cast<int>(quantity)];
}

std::optional<double> ReadingUncertainty::deviation(Quantity quantity) const {
    if (quantity == Quantity::chroma) return best().chroma;
    if (quantity == Quantity::hue) return best().hue_deg;
    return best().lab()[static_cast<int>(quantity)];
}

std::vector<double> ReadingUncertainty::change_of(Quantity quantity) const {
    std::vector<double> out;
    if (quantity != Quantity::chroma && quantity != Quantity::hue) {
        for (const Vec3d& c : change) out.push_back(c[static_cast<int>(quantity)]);
        return out;
    }
    if (!first_order.chroma) return out;
    const double chroma = measure::chroma(reading.lab);
    const double cosine = reading.lab[1] / chroma, sine = reading.lab[2] / chroma;
    for (const Vec3d& c : change) {
        out.push_back(quantity == Quantity::chroma
                          ? cosine * c[1] + sine * c[2]
                          : (cosine * c[2] - sine * c[1]) / chroma * 180 / std::numbers::pi);
    }
    return out;
}

std::vector<Quantity> ReadingUncertainty::doubtful() const {
    std::vector<Quantity> out;
    for (const Quantity quantity : kQuantities) {
        if (linearity[static_cast<std::size_t>(quantity)].fails) out.push_back(quantity);
    }
    return out;
}

bool Uncertainty::first_order_fails() const {
    return std::any_of(numbers.begin(), numbers.end(),
                       [](const UncertainNumber& number) { return number.meets_range; }) ||
           std::any_of(readings.begin(), readings.end(),
                       [](const ReadingUncertainty& r) { return !r.doubtful().empty(); }) ||
           (flop_index && flop_index->linearity.fails) ||
           (colour_travel && colour_travel->linearity.fails);
}

PaintReader solution_reader(std::vector<double> wavelengths_nm,
                            std::vector<measure::Geometry> geometries,
                            const measure::Conditions& conditions, bool hot_spot) {
    constexpr std::size_t kFilmsKept = 64;
    const auto films = std::make_shared<solver::FilmCache>(kFilmsKept, kFineCosines);
    return
        [=](const paint::Recipe& recipe, const solver::SolverSettings* like, SharedProgress& work) {
            const Solution solution =
                solve_alike(recipe, wavelengths_nm, kFineTolerance, like, *films, work);
            return PaintReading{read_solution(solution.paint, hot_spot, geometries, conditions),
                                solution.settings};
        };
}

Uncertainty uncertainty(const paint::Recipe& recipe,
                        const std::vector<paint::ParameterDeviation>& deviations,
                        const PaintReader& reader, const UncertaintyOptions& options,
                        const Progress& progress) {
    check(deviations, options);
    std::size_t active = 0;
    for (const paint::ParameterDeviation& deviation : deviations) {
        active += paint::standard_deviation(recipe, deviation) > 0;
    }
    SharedProgress work(progress, static_cast<double>(1 + active * (3 + active)) + options.samples);
    UncertainPaint paint(recipe, reader, work);
    for (const paint::ParameterDeviation& deviation : deviations) {
        const paint::RecipeParameter parameter = paint::find_parameter(recipe, deviation.key);
        paint.add({parameter.key, parameter.value, paint::standard_deviation(recipe, deviation)},
                  parameter.range);
    }
    for (std::size_t i = 0; i < paint.numbers().size(); ++i) {
        std::vector<double> point(paint.numbers().size(), 0.0);
        for (const double side : {-1.0, 1.0}) {
            point[i] = side * UncertainNumber::kSigmasOfRange;
            if (!paint.is_valid(point)) paint.numbers()[i].meets_range = true;
        }
    }

    // Errors of the recipe are thrown here.
    const PaintReading here = reader(recipe, nullptr, work);
    work.add();
    paint.require_going();
    const Evaluation centre{values_of(here.measurement), here.settings};
    const Layout layout{here.measurement.readings.size(), here.measurement.wavelengths_nm.size()};
    const Moves moves = paint.moves(centre);

    Uncertainty out;
    out.measurement = here.measurement;
    out.numbers = paint.numbers();
    for (std::size_t r = 0; r < layout.readings; ++r) {
        out.readings.push_back(
            reading_of(here.measurement.readings[r], layout.lab(r), layout.spectrum(r), moves));
    }
    out.flop_index = metric_of(layout.flop(), moves);
    out.colour_travel = metric_of(layout.travel(), moves);
    if (options.samples == 0) return out;

    out.samples = options.samples;
    const SampledSums sums = sampled_sums(paint, layout, centre.values, options, out.redrawn);
    for (std::size_t r = 0; r < layout.readings; ++r) {
        out.readings[r].sampled = sums.spread(r, centre.values);
    }
    const auto add_sampled = [&](std::optional<MetricUncertainty>& metric, std::size_t position) {
        if (!metric) return;
        const double deviation = sums.deviation(position);
        if (std::isfinite(deviation)) metric->sampled = deviation;
    };
    add_sampled(out.flop_index, layout.flop());
    add_sampled(out.colour_travel, layout.travel());
    return out;
}

}  // namespace nacre::fit
