#include "apps/cli/uncertainty_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "nacre/core/csv.h"
#include "nacre/core/progress.h"

namespace nacre::cli {

namespace {

using fit::MetricUncertainty;
using fit::ReadingUncertainty;
using fit::Spread;
using fit::UncertainNumber;

/// "layer[0].thickness_um=5%".
std::vector<paint::ParameterDeviation> parse_deviations(const std::vector<std::string>& texts) {
    std::vector<paint::ParameterDeviation> deviations;
    for (const std::string& text : texts) {
        const std::size_t equals = text.rfind('=');
        if (equals == std::string::npos || equals == 0) {
            throw UsageError(fmt::format(
                "--uncertainty = {}: is not KEY=SD, as in 'layer[0].thickness_um=5%'", text));
        }
        try {
            paint::ParameterDeviation deviation =
                paint::parse_deviation(text.substr(0, equals), text.substr(equals + 1));
            if (std::ranges::find(deviations, deviation.key, &paint::ParameterDeviation::key) !=
                deviations.end()) {
                throw UsageError(
                    fmt::format("--uncertainty = {}: {} appears twice", text, deviation.key));
            }
            deviations.push_back(std::move(deviation));
        } catch (const DomainError& error) {
            throw UsageError(fmt::format("--uncertainty: {}", error.what()));
        }
    }
    return deviations;
}

/// "layer[0].thickness_um,layer[1].thickness_um=0.8".
std::vector<paint::ParameterCorrelation> parse_correlations(const std::vector<std::string>& texts) {
    std::vector<paint::ParameterCorrelation> correlations;
    for (const std::string& text : texts) {
        try {
            correlations.push_back(paint::parse_correlation(text));
        } catch (const DomainError& error) {
            throw UsageError(fmt::format("--correlation = {}", error.what()));
        }
    }
    return correlations;
}

/// The number with the largest share of a variance; none where there is no variance.
std::optional<std::size_t> greatest(const std::vector<double>& shares) {
    const auto found = std::max_element(shares.begin(), shares.end());
    if (found == shares.end() || !(*found > 0)) return std::nullopt;
    return static_cast<std::size_t>(found - shares.begin());
}

std::string main_cause(const Uncertainty& u, const std::vector<double>& shares) {
    const auto number = greatest(shares);
    if (!number) return {};
    return fmt::format("{:.0f} % of the variance from {}", 100 * shares[*number],
                       u.numbers[*number].key);
}

void say_spread(const CommonOptions& options, const Uncertainty& u) {
    const auto metric = [&](const char* name, const std::optional<MetricUncertainty>& m) {
        if (!m) return;
        const std::string cause = main_cause(u, fit::variance_fractions(m->change, u.correlation));
        say(options, fmt::format("{} {:.2f} +- {:.2g}{}", name, m->value, m->best(),
                                 cause.empty() ? "" : ", " + cause));
    };
    metric("flop index", u.flop_index);
    metric("colour travel", u.colour_travel);
    const auto total = [](const ReadingUncertainty& r) {
        const fit::LabCovariance& s = r.best().covariance;
        return s[0][0] + s[1][1] + s[2][2];
    };
    const auto widest =
        std::max_element(u.readings.begin(), u.readings.end(),
                         [&](const auto& a, const auto& b) { return total(a) < total(b); });
    if (widest == u.readings.end()) return;
    const Vec3d& lab = widest->reading.lab;
    const Vec3d sd = widest->best().lab();
    const std::string cause = main_cause(u, fit::variance_fractions(widest->change, u.correlation));
    say(options, fmt::format("widest at {}: L* {:.1f} +- {:.2g}, a* {:.1f} +- {:.2g}, b* {:.1f} +- "
                             "{:.2g}{}",
                             widest->reading.geometry.name, lab[0], sd[0], lab[1], sd[1], lab[2],
                             sd[2], cause.empty() ? "" : "; " + cause));
}

/// "a C".
std::string doubtful_text(const ReadingUncertainty& reading) {
    std::vector<const char*> names;
    for (const fit::Quantity quantity : reading.doubtful()) names.push_back(name_of(quantity));
    return fmt::format("{}", fmt::join(names, " "));
}

/// Where first order is doubtful.
void print_warnings(const CommonOptions& options, const Uncertainty& u) {
    for (const UncertainNumber& number : u.numbers) {
        if (!number.meets_range) continue;
        say(options,
            fmt::format("nacre: warning: {} = {:g} +- {:.3g}: reaches values that no recipe may "
                        "have within {:g} standard deviations; it cannot be normal",
                        number.key, number.value, number.standard_deviation,
                        UncertainNumber::kSigmasOfRange));
    }
    std::vector<std::string> where;
    for (const ReadingUncertainty& r : u.readings) {
        const std::string quantities = doubtful_text(r);
        if (!quantities.empty()) {
            where.push_back(fmt::format("{} ({})", r.reading.geometry.name, quantities));
        }
    }
    if (u.flop_index && u.flop_index->linearity.fails) where.emplace_back("the flop index");
    if (u.colour_travel && u.colour_travel->linearity.fails) {
        where.emplace_back("the colour travel");
    }
    if (!where.empty() && u.samples == 0) {
        say(options, fmt::format("nacre: warning: first order is not enough at {}: the next terms "
                                 "change standard deviations by more than 5 %; "
                                 "--uncertainty-samples 400 draws recipes instead",
                                 fmt::join(where, ", ")));
    }
    if (u.redrawn > 0) {
        say(options, fmt::format("nacre: warning: {} draws made no valid recipe and were drawn "
                                 "again: the laws are cut off there",
                                 u.redrawn));
    }
}

}  // namespace

void say_uncertainty(const CommonOptions& options, const Uncertainty& uncertainty) {
    say_spread(options, uncertainty);
    print_warnings(options, uncertainty);
}

namespace {

std::string number_or_nothing(const std::optional<double>& x) {
    return x ? fmt::format("{}", *x) : std::string();
}

nlohmann::json json_or_null(const std::optional<double>& x) {
    return x ? nlohmann::json(*x) : nlohmann::json(nullptr);
}

nlohmann::json spread_json(const Spread& spread) {
    nlohmann::json json = {{"mean_lab", spread.mean},
                           {"lab_sd", spread.lab()},
                           {"lab_covariance", spread.covariance},
                           {"chroma_sd", json_or_null(spread.chroma)},
                           {"hue_sd_deg", json_or_null(spread.hue_deg)}};
    if (!spread.reflectance_factor.empty()) {
        json["reflectance_factor_sd"] = spread.reflectance_factor;
    }
    return json;
}

nlohmann::json linearity_json(const fit::Linearity& linearity) {
    return {{"beyond_first_order",
             std::isfinite(linearity.beyond) ? nlohmann::json(linearity.beyond) : nullptr},
            {"first_order_holds", !linearity.fails}};
}

nlohmann::json metric_json(const std::optional<MetricUncertainty>& metric,
                           const std::vector<double>& correlation) {
    if (!metric) return nullptr;
    nlohmann::json json = {{"value", metric->value},
                           {"sd", metric->best()},
                           {"first_order_sd", metric->first_order},
                           {"mean_shift", metric->mean_shift},
                           {"change", metric->change},
                           {"share", fit::variance_fractions(metric->change, correlation)}};
    json.update(linearity_json(metric->linearity));
    return json;
}

}  // namespace

void add_uncertainty_options(CLI::App& command, UncertaintyRequest& request) {
    command
        .add_option("--uncertainty", request.deviations,
                    "Standard deviation of a number of the recipe, in its unit or of it: "
                    "'layer[0].thickness_um=5%'; repeat it. Adds to the recipe's table "
                    "[uncertainty] or replaces it there")
        ->type_name("KEY=SD")
        ->group("Uncertainty")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command
        .add_option("--correlation", request.correlations,
                    "Coefficient in [-1, 1] by which numbers with a standard deviation are wrong "
                    "together, each two of those named: "
                    "'layer[0].thickness_um,layer[1].thickness_um=0.8'; repeat it. Adds to the "
                    "recipe's [[uncertainty.correlation]] or replaces it there")
        ->type_name("A,B=COEFFICIENT")
        ->group("Uncertainty")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    command
        .add_option("--uncertainty-samples", request.samples,
                    "Recipes to draw, in place of first order")
        ->group("Uncertainty")
        ->check(
            in_range(fit::UncertaintyOptions::kMinSamples, fit::UncertaintyOptions::kMaxSamples));
    command.add_flag("--no-uncertainty", request.none, "Leave out the recipe's [uncertainty]")
        ->group("Uncertainty");
}

std::optional<Uncertainty> uncertainty_of(const CommonOptions& options,
                                          const UncertaintyRequest& request, const Paint& paint,
                                          const std::vector<Geometry>& geometries,
                                          const MeasureSettings& settings) {
    if (request.none && request.asks()) {
        throw UsageError(
            "--no-uncertainty and --uncertainty, --correlation or --uncertainty-samples exclude "
            "each other");
    }
    const UncertaintySettings wanted{parse_deviations(request.deviations),
                                     request.samples.value_or(0), options.seed,
                                     parse_correlations(request.correlations)};
    if (request.none || (!request.asks() && paint.deviations().empty())) return std::nullopt;
    if (!paint.has_recipe()) {
        throw UsageError(
            fmt::format("--uncertainty: {} holds no recipe, of which numbers could be "
                        "uncertain",
                        paint.file()));
    }
    if (!request.asks() && settings.model && !has_uncertainty(*settings.model)) {
        say(options, fmt::format("nacre: warning: {}: its table [uncertainty] is passed over: the "
                                 "model {} has no exact values",
                                 paint.file(), settings.model->info().name));
        return std::nullopt;
    }
    ProgressBar bar("uncertainty", options.quiet);
    std::optional<Uncertainty> found;
    try {
        found = paint.measure_uncertainty(geometries, settings, wanted, bar.callback());
    } catch (const SettingError& error) {
        // Other settings were understood before.
        const bool own = error.setting() == "correlation" || error.setting() == "uncertainty";
        throw InputError(
            fmt::format("{}: {}--{}", paint.file(), own ? "" : "--uncertainty: ", error.what()));
    } catch (const DomainError& error) {
        throw InputError(fmt::format("--uncertainty: {}: {}", paint.file(), error.what()));
    }
    return found;
}

std::vector<io::MeasurementColumn> uncertainty_columns(const Uncertainty& u) {
    std::vector<io::MeasurementColumn> columns;
    const auto add = [&](const std::string& name, const auto& cell) {
        io::MeasurementColumn column{name, {}};
        for (const ReadingUncertainty& r : u.readings) column.cells.push_back(cell(r));
        columns.push_back(std::move(column));
    };
    const auto number = [](double x) { return fmt::format("{}", x); };
    for (const fit::Quantity quantity : fit::kQuantities) {
        add(name_of(quantity) + std::string("_sd"),
            [&](const ReadingUncertainty& r) { return number_or_nothing(r.deviation(quantity)); });
    }
    add("cov_La", [&](const auto& r) { return number(r.best().covariance[0][1]); });
    add("cov_Lb", [&](const auto& r) { return number(r.best().covariance[0][2]); });
    add("cov_ab", [&](const auto& r) { return number(r.best().covariance[1][2]); });
    add("sd_by", [&](const auto&) { return u.samples > 0 ? "sampling" : "first order"; });
    add("first_order_fails", doubtful_text);
    add("most_from", [&](const auto& r) {
        const auto most = greatest(fit::variance_fractions(r.change, u.correlation));
        return most ? u.numbers[*most].key : std::string();
    });
    add("most_share", [&](const auto& r) {
        const std::vector<double> all = fit::variance_fractions(r.change, u.correlation);
        const auto most = greatest(all);
        return most ? number(all[*most]) : std::string();
    });
    for (std::size_t k = 0; k < u.measurement.wavelengths_nm.size(); ++k) {
        add(fmt::format("SD{}", u.measurement.wavelengths_nm[k]), [&](const auto& r) {
            const std::vector<double>& sd = r.best().reflectance_factor;
            return sd.empty() ? std::string() : number(sd[k]);
        });
    }
    return columns;
}

std::string contributions_csv(const Uncertainty& u) {
    std::string csv = "geometry,quantity,number,value,sd,change,share\n";
    const auto add = [&](const std::string& geometry, const char* quantity,
                         const std::vector<double>& change) {
        const std::vector<double> all = fit::variance_fractions(change, u.correlation);
        for (std::size_t i = 0; i < u.numbers.size(); ++i) {
            csv += fmt::format("{},{},{},{},{},{},{}\n", csv_cell(geometry), quantity,
                               csv_cell(u.numbers[i].key), u.numbers[i].value,
                               u.numbers[i].standard_deviation, change[i], all[i]);
        }
    };
    for (const ReadingUncertainty& r : u.readings) {
        for (const fit::Quantity quantity : fit::kQuantities) {
            const std::vector<double> change = r.change_of(quantity);
            if (!change.empty()) add(r.reading.geometry.name, name_of(quantity), change);
        }
    }
    if (u.flop_index) add("", "flop_index", u.flop_index->change);
    if (u.colour_travel) add("", "colour_travel", u.colour_travel->change);
    return csv;
}

nlohmann::json uncertainty_json(const Uncertainty& u) {
    nlohmann::json numbers = nlohmann::json::array(), readings = nlohmann::json::array();
    for (const UncertainNumber& number : u.numbers) {
        numbers.push_back({{"key", number.key},
                           {"value", number.value},
                           {"sd", number.standard_deviation},
                           {"meets_range", number.meets_range}});
    }
    for (const ReadingUncertainty& r : u.readings) {
        nlohmann::json reading = {{"geometry", r.reading.geometry.name},
                                  {"first_order", spread_json(r.first_order)},
                                  {"change", r.change},
                                  {"share", fit::variance_fractions(r.change, u.correlation)},
                                  {"mean_shift", r.mean_shift}};
        if (r.sampled) reading["sampled"] = spread_json(*r.sampled);
        for (const fit::Quantity quantity : fit::kQuantities) {
            reading["linearity"][name_of(quantity)] =
                linearity_json(r.linearity[static_cast<std::size_t>(quantity)]);
        }
        readings.push_back(std::move(reading));
    }
    nlohmann::json correlation = nlohmann::json::array();
    for (std::size_t i = 0; i < u.numbers.size(); ++i) {
        correlation.push_back(u.correlation_of(i));
    }
    return {{"numbers", std::move(numbers)},
            {"correlation", std::move(correlation)},
            {"readings", std::move(readings)},
            {"flop_index", metric_json(u.flop_index, u.correlation)},
            {"colour_travel", metric_json(u.colour_travel, u.correlation)},
            {"samples", u.samples},
            {"redrawn", u.redrawn},
            {"first_order_holds", !u.first_order_fails()}};
}

}  // namespace nacre::cli
