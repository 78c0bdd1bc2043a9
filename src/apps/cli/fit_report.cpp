#include "apps/cli/fit_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "apps/cli/difference_table.h"
#include "nacre/fit/shortfall.h"
#include "nacre/spectra/observer.h"

namespace nacre::cli {

namespace {

using fit::FittedParameter;

/// Angles that are named for one attribute of a colour, at most.
constexpr std::size_t kMaxAnglesNamed = 3;
/// The correlation of the errors of two numbers above which it is printed.
constexpr double kMinShownCorrelation = 0.9;

class Text {
 public:
    template <class... Args>
    void line(fmt::format_string<Args...> format, Args&&... args) {
        text_ += fmt::format(format, std::forward<Args>(args)...);
        text_.resize(text_.find_last_not_of(' ') + 1);
        text_ += '\n';
    }
    std::string take() && { return std::move(text_); }

 private:
    std::string text_;
};

std::string remark(const FittedParameter& parameter) {
    std::string text;
    if (parameter.at_lower_bound) text = "at its lower bound";
    if (parameter.at_upper_bound) text = "at its upper bound";
    if (!parameter.standard_error)
        text += (text.empty() ? "" : "; ") + std::string("not determined");
    return text;
}

void add_numbers(Text& text, const fit::Fit& fit) {
    std::size_t width = 6;
    for (const FittedParameter& fitted : fit.parameters)
        width = std::max(width, fitted.number.bounds.key.size());
    text.line("{:<{}}  {:>10}  {:>10}  {:>9}  {:>20}", "number", width, "start", "fitted", "+-",
              "bounds");
    for (const FittedParameter& fitted : fit.parameters) {
        const auto& [key, lo, hi] = fitted.number.bounds;
        text.line("{:<{}}  {:>10.4g}  {:>10.5g}  {:>9}  {:>20}  {}", key, width,
                  fitted.number.start, fitted.value,
                  fitted.standard_error ? fmt::format("{:.2g}", *fitted.standard_error) : "-",
                  fmt::format("[{:.4g}, {:.4g}]", lo, hi), remark(fitted));
    }
}

void add_angles(Text& text, const fit::Fit& fit) {
    std::size_t width = 8;
    for (const auto& angle : fit.difference.angles) {
        width = std::max(width, angle.geometry.name.size());
    }
    text.line("{:<{}}  {:>24}  {:>24}  {:>10}", "geometry", width, "standard L*, a*, b*",
              "fitted L*, a*, b*", "Delta E");
    for (const auto& angle : fit.difference.angles) {
        const auto lab = [](const Vec3d& c) {
            return fmt::format("{:.2f}, {:.2f}, {:.2f}", c[0], c[1], c[2]);
        };
        text.line("{:<{}}  {:>24}  {:>24}  {:>10.3f}", angle.geometry.name, width,
                  lab(angle.lab_standard), lab(angle.lab_sample), angle.delta_e_2000);
    }
}

void add_certainty(Text& text, const fit::Fit& fit) {
    const fit::Certainty& certainty = fit.certainty;
    if (certainty.noise_delta_e) {
        text.line(
            "+- is one standard error for a noise of {:.3g} Delta E in each component of a colour, "
            "{}.",
            *certainty.noise_delta_e,
            fit.noise_given ? "as given"
                            : fmt::format("as the residual has with {} degrees of freedom",
                                          certainty.degrees_of_freedom));
    } else {
        text.line("No error can be told: not more measured values than numbers; give --noise.");
    }
    for (std::size_t a = 0; a < fit.parameters.size(); ++a) {
        for (std::size_t b = a + 1; b < fit.parameters.size(); ++b) {
            const double c = certainty.correlation[a * fit.parameters.size() + b];
            if (std::abs(c) < kMinShownCorrelation) continue;
            text.line("Errors of {} and {} go {} (correlation {:.3f}).",
                      fit.parameters[a].number.bounds.key, fit.parameters[b].number.bounds.key,
                      c > 0 ? "together" : "against each other", c);
        }
    }
    for (const fit::Tradeoff& tradeoff : fit.tradeoffs) {
        std::string changes;
        for (const auto& change : tradeoff.changes) {
            changes += fmt::format("{}{} {:.4g} -> {:.4g}", changes.empty() ? "" : ", ", change.key,
                                   change.from, change.to);
        }
        text.line("Hardly seen (rms Delta E {:.2g} at the far end): {}.", tradeoff.rms_delta_e,
                  changes);
    }
}

void add_alternatives(Text& text, const fit::Fit& fit) {
    for (const fit::Minimum& minimum : fit.alternatives) {
        std::string values;
        for (std::size_t i = 0; i < fit.parameters.size(); ++i) {
            values += fmt::format("{}{} = {:.5g}", i > 0 ? ", " : "",
                                  fit.parameters[i].number.bounds.key, minimum.values[i]);
        }
        text.line("As good within {:g} (mean {:.3f}, greatest {:.3f}): {}.", fit.equal_delta_e,
                  minimum.mean_delta_e_2000, minimum.max_delta_e_2000, values);
    }
}

const char* name_of(fit::Attribute attribute) {
    if (attribute == fit::Attribute::lightness) return "lightness";
    return attribute == fit::Attribute::chroma ? "chroma" : "hue";
}

/// "too dark by 12.1 at 45as15"
std::string shortfall_at(fit::Attribute attribute, const fit::Shortfall::AtAngle& at) {
    const measure::AngleDifference& angle = *at.angle;
    if (attribute == fit::Attribute::hue) {
        return fmt::format("{:.0f} instead of {:.0f} deg (Delta H* {:+.1f}) at {}",
                           measure::hue_deg(angle.lab_sample), measure::hue_deg(angle.lab_standard),
                           at.delta, angle.geometry.name);
    }
    const bool light = attribute == fit::Attribute::lightness;
    const char* sense =
        at.delta < 0 ? (light ? "too dark" : "too dull") : (light ? "too light" : "too vivid");
    return fmt::format("{} by {:.1f} at {}", sense, std::abs(at.delta), angle.geometry.name);
}

void add_verdict(Text& text, const fit::Fit& fit) {
    if (fit.matched()) {
        text.line("Matched: the mean is within {:g}.", fit.matched_delta_e);
        return;
    }
    text.line("NOT MATCHED: the mean is above {:g} (--within). What is missing:",
              fit.matched_delta_e);
    for (const fit::Shortfall& shortfall : fit::shortfalls(fit.difference)) {
        std::string angles;
        for (std::size_t i = 0; i < std::min(shortfall.angles.size(), kMaxAnglesNamed); ++i) {
            angles += (i > 0 ? ", " : "") + shortfall_at(shortfall.attribute, shortfall.angles[i]);
        }
        if (shortfall.angles.size() > kMaxAnglesNamed) {
            angles += fmt::format(" and at {} more", shortfall.angles.size() - kMaxAnglesNamed);
        }
        text.line("  {} ({:.0f} %): {}", name_of(shortfall.attribute), 100 * shortfall.fraction,
                  angles);
    }
    if (fit.remedies.empty()) {
        text.line(
            "No other number of this recipe, tried together with the free ones, takes a tenth off: "
            "the recipe may lack something that the standard has.");
        return;
    }
    text.line("What might help, each tried together with the free numbers:");
    for (const fit::Remedy& remedy : fit.remedies) {
        const std::string then = fmt::format("mean Delta E about {:.2g} at {:.4g}",
                                             remedy.mean_delta_e_2000, remedy.value);
        if (remedy.widens) {
            text.line("  in [fit], \"{}\" = [{:.4g}, {:.4g}], as it is at its bound: {}",
                      remedy.key, remedy.bounds.lo, remedy.bounds.hi, then);
        } else {
            text.line("  free {}: {}", paint::shortest_pattern(fit.recipe, remedy.key), then);
        }
    }
}

void add_verdict(nlohmann::json& document, const fit::Fit& fit) {
    document["matched"] = fit.matched();
    document["within"] = fit.matched_delta_e;
    document["missing"] = nlohmann::json::array();
    document["remedies"] = nlohmann::json::array();
    if (fit.matched()) return;
    for (const fit::Shortfall& shortfall : fit::shortfalls(fit.difference)) {
        nlohmann::json angles = nlohmann::json::array();
        for (const auto& at : shortfall.angles) {
            angles.push_back({{"geometry", at.angle->geometry.name},
                              {"delta", at.delta},
                              {"delta_e_2000", at.delta_e_2000}});
        }
        document["missing"].push_back({{"attribute", name_of(shortfall.attribute)},
                                       {"share", shortfall.fraction},
                                       {"angles", std::move(angles)}});
    }
    for (const fit::Remedy& remedy : fit.remedies) {
        document["remedies"].push_back({{"key", remedy.key},
                                        {"action", remedy.widens ? "widen" : "free"},
                                        {"bounds", {remedy.bounds.lo, remedy.bounds.hi}},
                                        {"value", remedy.value},
                                        {"mean_delta_e_2000", remedy.mean_delta_e_2000}});
    }
}

nlohmann::json optional_number(const std::optional<double>& x) {
    return x ? nlohmann::json(*x) : nlohmann::json(nullptr);
}

}  // namespace

std::string fit_text(const fit::Fit& fit) {
    Text text;
    add_numbers(text, fit);
    text.line("");
    add_angles(text, fit);
    text.line("");
    text.line("Delta E 2000: mean {:.3f}, greatest {:.3f}; at the start {:.2f} and {:.2f}.",
              fit.difference.mean_delta_e_2000, fit.difference.max_delta_e_2000,
              fit.at_start.mean_delta_e_2000, fit.at_start.max_delta_e_2000);
    for (const auto& [light, difference] : fit.other_lights) {
        text.line("Under {}: mean {:.3f}, greatest {:.3f}.", spectra::name(light),
                  difference.mean_delta_e_2000, difference.max_delta_e_2000);
    }
    text.line("{}: {}.", fit.converged ? "Converged" : "Not converged", fit.ended);
    add_verdict(text, fit);
    add_certainty(text, fit);
    add_alternatives(text, fit);
    return std::move(text).take();
}

nlohmann::json fit_json(const fit::Fit& fit) {
    nlohmann::json document;
    for (const FittedParameter& fitted : fit.parameters) {
        document["numbers"].push_back(
            {{"key", fitted.number.bounds.key},
             {"start", fitted.number.start},
             {"value", fitted.value},
             {"standard_error", optional_number(fitted.standard_error)},
             {"bounds", {fitted.number.bounds.lo, fitted.number.bounds.hi}},
             {"bounds_given", fitted.number.bounds_given},
             {"at_lower_bound", fitted.at_lower_bound},
             {"at_upper_bound", fitted.at_upper_bound}});
    }
    document["difference"] = difference_json(fit.difference);
    document["difference_at_start"] = difference_json(fit.at_start);
    document["other_lights"] = nlohmann::json::object();
    for (const auto& [light, difference] : fit.other_lights) {
        document["other_lights"][spectra::name(light)] = difference_json(difference);
    }
    add_verdict(document, fit);
    document["converged"] = fit.converged;
    document["ended"] = fit.ended;
    document["noise_delta_e"] = optional_number(fit.certainty.noise_delta_e);
    document["noise_given"] = fit.noise_given;
    document["degrees_of_freedom"] = fit.certainty.degrees_of_freedom;
    const std::size_t count = fit.parameters.size();
    for (std::size_t a = 0; a < count; ++a) {
        const auto row = fit.certainty.correlation.begin() + static_cast<std::ptrdiff_t>(a * count);
        document["correlation"].push_back(
            std::vector<double>(row, row + static_cast<std::ptrdiff_t>(count)));
    }
    document["tradeoffs"] = nlohmann::json::array();
    for (const fit::Tradeoff& tradeoff : fit.tradeoffs) {
        nlohmann::json changes;
        for (const auto& change : tradeoff.changes) {
            changes.push_back({{"key", change.key}, {"from", change.from}, {"to", change.to}});
        }
        document["tradeoffs"].push_back(
            {{"rms_delta_e_2000", tradeoff.rms_delta_e}, {"changes", changes}});
    }
    document["equal_delta_e"] = fit.equal_delta_e;
    document["alternatives"] = nlohmann::json::array();
    for (const fit::Minimum& minimum : fit.alternatives) {
        document["alternatives"].push_back({{"values", minimum.values},
                                            {"mean_delta_e_2000", minimum.mean_delta_e_2000},
                                            {"max_delta_e_2000", minimum.max_delta_e_2000},
                                            {"converged", minimum.converged},
                                            {"ended", minimum.ended}});
    }
    document["effort"] = {{"solves", fit.effort.solves},     {"films", fit.effort.films},
                          {"points", fit.effort.points},     {"descents", fit.effort.descents},
                          {"finished", fit.effort.finished}, {"seconds", fit.effort.seconds}};
    return document;
}

}  // namespace nacre::cli
