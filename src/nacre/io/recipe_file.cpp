#include "nacre/io/recipe_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <string>

#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/core/sha256.h"
#include "nacre/io/described_toml.h"
#include "nacre/io/table_reader.h"
#include "nacre/paint/recipe_description.h"

namespace nacre::io {

namespace {

constexpr std::size_t kMaxShownKeyLength = 200;
constexpr std::size_t kMaxDeviationLength = 40;
constexpr const char* kUncertaintyKey = "uncertainty";
/// The key of [uncertainty] that is not the name of a number.
constexpr const char* kCorrelationKey = "correlation";

/// Whether a key of [fit] or [uncertainty] can stand in a message as it is.
bool is_plain(const std::string& key) {
    return !key.empty() && key.size() <= kMaxShownKeyLength &&
           std::all_of(key.begin(), key.end(), [](char c) { return c >= 0x20 && c < 0x7f; });
}

/// A table whose keys are those of the recipe's numbers, in the order of those.
/// @param read   from the table and a key, throwing DomainError "key = value: ..."
/// @param wrong  what is said of a table that may not be quoted
/// @param other  a key that names no number and is read elsewhere
template <class Entry, class Read>
std::vector<Entry> read_by_number(const TableReader& recipe_table, const char* name,
                                  const paint::Recipe& recipe, const std::string& wrong,
                                  const Read& read, const char* other = "") {
    std::vector<Entry> entries;
    const auto table = recipe_table.table_if_present(name, {});
    if (!table) return entries;
    std::map<std::string, Entry> by_key;
    for (const std::string& key : table->keys()) {
        if (key == other) continue;
        if (!is_plain(key)) {
            table->fail("has a key that is not the name of a number of this recipe");
        }
        const std::string place = table->document().location(table->path_of(key));
        try {
            paint::find_parameter(recipe, key);
            by_key[key] = read(*table, key);
        } catch (const DomainError& error) {
            if (!table->document().references().may_quote()) {
                throw InputError(place + name + ": " + wrong);
            }
            throw InputError(place + name + "." + error.what());
        }
    }
    for (const paint::RecipeParameter& parameter : paint::recipe_parameters(recipe)) {
        const auto found = by_key.find(parameter.key);
        if (found != by_key.end()) entries.push_back(found->second);
    }
    return entries;
}

/// [fit]: each number with a list of two ends.
std::vector<paint::ParameterBounds> read_bounds(const TableReader& table,
                                                const paint::Recipe& recipe) {
    return read_by_number<paint::ParameterBounds>(
        table, "fit", recipe, "bounds no number of this recipe by two in its range",
        [&](const TableReader& fit, const std::string& key) {
            const std::vector<double> ends = fit.numbers(key, {}, 2, 2);
            const paint::ParameterBounds bounds{key, ends[0], ends[1]};
            paint::check_bounds(recipe, bounds);
            return bounds;
        });
}

/// [uncertainty]: each number with a standard deviation, 0.002 or "5 %".
std::vector<paint::ParameterDeviation> read_deviations(const TableReader& table,
                                                       const paint::Recipe& recipe) {
    return read_by_number<paint::ParameterDeviation>(
        table, kUncertaintyKey, recipe,
        "gives no number of this recipe a standard deviation in its range",
        [&](const TableReader& uncertainty, const std::string& key) {
            paint::ParameterDeviation deviation{key};
            if (uncertainty.is_text(key)) {
                deviation = paint::parse_deviation(key, uncertainty.text(key, kMaxDeviationLength));
                if (!deviation.relative) {
                    uncertainty.fail(key,
                                     "must be a number without quotes, or a percentage as in "
                                     "\"5 %\"");
                }
            } else {
                deviation.amount = uncertainty.number(key, Range{});
            }
            paint::check_deviation(recipe, deviation);
            return deviation;
        },
        kCorrelationKey);
}

/// [[uncertainty.correlation]]: numbers with a standard deviation, and a coefficient.
std::vector<paint::ParameterCorrelation> read_correlations(
    const TableReader& table, const paint::Recipe& recipe,
    const std::vector<paint::ParameterDeviation>& deviations) {
    using paint::ParameterCorrelation;
    std::vector<ParameterCorrelation> correlations;
    const auto uncertainty = table.table_if_present(kUncertaintyKey, {});
    if (!uncertainty) return correlations;
    const TomlDocument& document = uncertainty->document();
    const std::string all = uncertainty->path_of(kCorrelationKey);
    const auto refuse = [&](const std::string& place, const std::string& message) {
        if (document.references().may_quote()) throw InputError(place + message);
        throw InputError(place + all +
                         ": correlates no two numbers that have a standard deviation by "
                         "coefficients that can be together, each in " +
                         ParameterCorrelation::kCoefficient.text());
    };
    for (const TableReader& entry : uncertainty->tables(
             kCorrelationKey, ParameterCorrelation::kMaxStated, {"of", "coefficient"})) {
        ParameterCorrelation correlation;
        correlation.keys = entry.texts("of", kMaxShownKeyLength, 2, ParameterCorrelation::kMaxKeys);
        correlation.coefficient = entry.number("coefficient", ParameterCorrelation::kCoefficient);
        for (const std::string& key : correlation.keys) {
            if (!is_plain(key)) entry.fail("of", "has a text that is not the name of a number");
        }
        try {
            paint::check_correlation(recipe, deviations, correlation);
        } catch (const DomainError& error) {
            refuse(document.location(entry.path_of("of")), entry.path_of(error.what()));
        }
        correlations.push_back(std::move(correlation));
    }
    try {
        paint::check_correlations(recipe, deviations, correlations);
    } catch (const DomainError& error) {
        refuse(document.location(all), uncertainty->path_of(error.what()));
    }
    return correlations;
}

RecipeFile read_recipe_file(TomlDocument& document, std::string_view text) {
    paint::Recipe recipe;
    const paint::Described described(recipe);
    const TableReader table(document, keys_of(described));
    read_described(table, described);
    if (recipe.layers.empty() && !recipe.microfacet) {
        table.fail(
            "layer",
            fmt::format("is missing; a paint needs 1 to {} tables [[layer]], or [microfacet]",
                        paint::limits::kMaxLayers));
    }
    try {
        validate(recipe, {});  // what concerns several keys at once, as R + T <= 1
    } catch (const DomainError& error) {
        rethrow_with_location(document, error.what());
    }
    RecipeFile file{std::move(recipe), {}};
    file.bounds = read_bounds(table, file.recipe);
    file.deviations = read_deviations(table, file.recipe);
    file.correlations = read_correlations(table, file.recipe, file.deviations);
    file.source = std::make_shared<const RecipeSource>(
        RecipeSource{std::string(text), document.filename(), document.references()});
    return file;
}

}  // namespace

RecipeFile parse_recipe_file(std::string_view text, const std::string& filename,
                             const References& references) {
    TomlDocument document(text, filename, references);
    return read_recipe_file(document, text);
}

RecipeFile parse_recipe_file(const TypedFile& file) {
    return read_recipe_file(*TomlDocument::of(file), file.bytes);
}

RecipeFile read_recipe_file(const std::filesystem::path& path) {
    return parse_recipe_file(read_file(path, kMaxTextBytes), path.string(),
                             References::of_file(path));
}

paint::Recipe parse_recipe(std::string_view text, const std::string& filename,
                           const References& references) {
    return parse_recipe_file(text, filename, references).recipe;
}

paint::Recipe read_recipe(const std::filesystem::path& path) {
    return read_recipe_file(path).recipe;
}

std::string write_recipe(const paint::Recipe& recipe,
                         const std::vector<paint::ParameterBounds>& bounds,
                         const std::vector<paint::ParameterDeviation>& deviations,
                         const std::vector<paint::ParameterCorrelation>& correlations) {
    std::string out = write_described(paint::Described::to_inspect(recipe));
    if (!bounds.empty()) out += "\n[fit]\n";
    for (const paint::ParameterBounds& b : bounds) {
        out += fmt::format("{} = {}\n", toml_text(b.key), toml_list({b.lo, b.hi}));
    }
    if (!deviations.empty()) out += fmt::format("\n[{}]\n", kUncertaintyKey);
    for (const paint::ParameterDeviation& d : deviations) {
        out += fmt::format("{} = {}\n", toml_text(d.key), toml_deviation(d));
    }
    if (!correlations.empty()) {
        out += fmt::format("{} = {}\n", kCorrelationKey, toml_correlations(correlations));
    }
    return out;
}

std::string toml_deviation(const paint::ParameterDeviation& deviation) {
    const std::string text = paint::deviation_text(deviation);
    return deviation.relative ? toml_text(text) : text;
}

std::string toml_correlations(const std::vector<paint::ParameterCorrelation>& correlations) {
    std::string out = "[\n";
    for (const paint::ParameterCorrelation& c : correlations) {
        std::vector<std::string> keys;
        for (const std::string& key : c.keys) keys.push_back(toml_text(key));
        out += fmt::format("    {{ of = [{}], coefficient = {} }},\n", fmt::join(keys, ", "),
                           toml_number(c.coefficient));
    }
    return out + "]";
}

std::string recipe_hash(const paint::Recipe& recipe) { return sha256_hex(write_recipe(recipe)); }

}  // namespace nacre::io
