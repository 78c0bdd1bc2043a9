#include "nacre/fit/first_order.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "nacre/core/error.h"
#include "nacre/core/math.h"

namespace nacre::fit {
namespace {

/// Next terms of a variance below this fraction of it are not worth a remark.
constexpr double kBeyondFirstOrder = 0.1;

/// The spread of a*b* is too wide for chroma and hue if so many of its standard deviations reach
/// grey.
constexpr double kSigmasToGrey = 3;

/// Standard deviations below this are those of rounding, as a* of a grey paint has; so is chroma.
constexpr double kRounding = 1e-9;

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
/// f_i f_iii s_i^4 of each direction, and f_ij^2 s_i^2 s_j^2 of each pair; of the terms of that order
/// f_i f_ijj s_i^2 s_j^2 is left out. Directions are independent, also where numbers are not: with
/// the second derivatives F by numbers those by directions are G = L^T F L, and the sums over G those
/// over numbers, tr(G) = tr(F R) and tr(G G) = tr(F R F R).
/// @param first   f_i s_i by direction
/// @param change  of the quantity from the centre to some values
template <class Change>
NextTerms next_terms(const std::vector<double>& first, const Sensitivities& moves,
                     const Change& change) {
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
        next += 2 * square(even[i]) + std::abs(6 * first[i] * (odd - first[i]));
    }
    out.mean_shift = sum_of(even);
    std::size_t pair = 0;
    for (std::size_t i = 0; i < moves.numbers; ++i) {
        for (std::size_t j = i + 1; j < moves.numbers; ++j, ++pair) {
            const BothSides& sides = moves.pairs[pair];
            if (sides.up && sides.down) next += square(even_part(sides) - even[i] - even[j]);
        }
    }
    const double variance = sum_of_squares(first);
    if (next > 0) out.linearity.beyond = std::sqrt(next / variance);
    out.linearity.fails = out.linearity.unknown ||
                          (next > kBeyondFirstOrder * variance &&
                           std::sqrt(variance + next) - std::sqrt(variance) > Linearity::kNoticed);
    return out;
}

/// The definition of variance_fractions(), from the products of the changes of two numbers.
template <class Product>
std::vector<double> covariances_over_variance(std::size_t numbers,
                                              const std::vector<double>& correlation,
                                              const Product& product) {
    std::vector<double> out(numbers, 0.0);
    for (std::size_t i = 0; i < numbers; ++i) {
        if (correlation.empty()) {
            out[i] = product(i, i);
            continue;
        }
        for (std::size_t j = 0; j < numbers; ++j) {
            out[i] += correlation[i * numbers + j] * product(i, j);
        }
    }
    const double variance = sum_of(out);
    if (!(variance > square(kRounding))) return std::vector<double>(numbers, 0.0);
    for (double& fraction : out) fraction /= variance;
    return out;
}

}  // namespace

double hue_between_deg(const Vec3d& from, const Vec3d& to) {
    return std::remainder(measure::hue_deg(to) - measure::hue_deg(from), 360);
}

void add_chroma_and_hue(Spread& spread, const Vec3d& lab) {
    const double chroma = measure::chroma(lab);
    const Ellipse one_sigma = ab_ellipse(spread, 1 - std::exp(-0.5));
    const double to_grey = std::hypot(one_sigma.major[0], one_sigma.major[1]) * kSigmasToGrey;
    if (!(std::max(to_grey, kRounding) < chroma)) return;
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
                              std::size_t spectrum, const Sensitivities& moves) {
    ReadingUncertainty out;
    out.reading = reading;
    out.change.resize(moves.numbers);
    out.first_order.mean = reading.lab;
    for (int c = 0; c < 3; ++c) {
        const std::vector<double> row = moves.of(lab + static_cast<std::size_t>(c));
        for (std::size_t i = 0; i < moves.numbers; ++i) out.change[i][c] = row[i];
    }
    for (const Vec3d& change : moves.along(out.change)) {
        for (int r = 0; r < 3; ++r) {
            for (int c = 0; c < 3; ++c) out.first_order.covariance[r][c] += change[r] * change[c];
        }
    }
    for (std::size_t k = 0; k < reading.reflectance_factor.size(); ++k) {
        out.first_order.reflectance_factor.push_back(
            std::sqrt(sum_of_squares(moves.along(moves.of(spectrum + k)))));
    }
    add_chroma_and_hue(out.first_order, reading.lab);
    for (const Quantity quantity : kQuantities) {
        const auto q = static_cast<std::size_t>(quantity);
        const std::vector<double> by_number = out.change_of(quantity);
        if (by_number.empty()) continue;
        const std::vector<double> first = moves.along(by_number);
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

std::optional<MetricUncertainty> metric_of(std::size_t position, const Sensitivities& moves) {
    MetricUncertainty out;
    out.value = moves.centre[position];
    out.change = moves.of(position);
    const std::vector<double> first = moves.along(out.change);
    out.first_order = std::sqrt(sum_of_squares(first));
    if (!std::isfinite(out.value) || !std::isfinite(out.first_order)) return std::nullopt;
    const NextTerms next = next_terms(first, moves, [&](const Values& values) {
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

std::vector<double> variance_fractions(const std::vector<double>& change,
                                       const std::vector<double>& correlation) {
    return covariances_over_variance(change.size(), correlation, [&](std::size_t i, std::size_t j) {
        return change[i] * change[j];
    });
}

std::vector<double> variance_fractions(const std::vector<Vec3d>& change,
                                       const std::vector<double>& correlation) {
    return covariances_over_variance(change.size(), correlation, [&](std::size_t i, std::size_t j) {
        return i == j ? square(std::hypot(change[i][0], change[i][1], change[i][2]))
                      : dot(change[i], change[j]);
    });
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

std::vector<double> Uncertainty::correlation_of(std::size_t number) const {
    std::vector<double> row(numbers.size(), 0.0);
    if (correlation.empty()) {
        row[number] = 1;
        return row;
    }
    for (std::size_t i = 0; i < row.size(); ++i) row[i] = correlation[number * row.size() + i];
    return row;
}

bool Uncertainty::first_order_fails() const {
    return std::any_of(numbers.begin(), numbers.end(),
                       [](const UncertainNumber& number) { return number.meets_range; }) ||
           std::any_of(readings.begin(), readings.end(),
                       [](const ReadingUncertainty& r) { return !r.doubtful().empty(); }) ||
           (flop_index && flop_index->linearity.fails) ||
           (colour_travel && colour_travel->linearity.fails);
}

}  // namespace nacre::fit
