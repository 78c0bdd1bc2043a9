#include "nacre/io/recipe_file.h"

#include <fmt/format.h>

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

/// Whether a key of [fit] can stand in a message as it is.
bool is_plain(const std::string& key) {
    return !key.empty() && key.size() <= kMaxShownKeyLength &&
           std::all_of(key.begin(), key.end(), [](char c) { return c >= 0x20 && c < 0x7f; });
}

/// [fit]: keys of the recipe's numbers, each with a list of two ends.
std::vector<paint::ParameterBounds> read_bounds(const TableReader& table,
                                                const paint::Recipe& recipe) {
    std::vector<paint::ParameterBounds> bounds;
    const auto fit = table.table_if_present("fit", {});
    if (!fit) return bounds;
    std::map<std::string, paint::ParameterBounds> by_key;
    for (const std::string& key : fit->keys()) {
        if (!is_plain(key)) fit->fail("has a key that is not the name of a number of this recipe");
        const std::string place = table.document().location(fit->path_of(key));
        try {
            paint::find_parameter(recipe, key);
            const std::vector<double> ends = fit->numbers(key, {}, 2, 2);
            paint::check_bounds(recipe, {key, ends[0], ends[1]});
            by_key[key] = {key, ends[0], ends[1]};
        } catch (const DomainError& error) {
            if (!table.document().references().may_quote()) {
                throw InputError(place +
                                 "fit: bounds no number of this recipe by two in its range");
            }
            throw InputError(place + "fit." + error.what());
        }
    }
    for (const paint::RecipeParameter& parameter : paint::recipe_parameters(recipe)) {
        const auto found = by_key.find(parameter.key);
        if (found != by_key.end()) bounds.push_back(found->second);
    }
    return bounds;
}

}  // namespace

RecipeFile parse_recipe_file(std::string_view text, const std::string& filename,
                             const References& references) {
    TomlDocument document(text, filename, references);
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
    return {recipe, read_bounds(table, recipe)};
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
                         const std::vector<paint::ParameterBounds>& bounds) {
    std::string out = write_described(paint::Described::to_inspect(recipe));
    if (!bounds.empty()) out += "\n[fit]\n";
    for (const paint::ParameterBounds& b : bounds) {
        out += fmt::format("{} = {}\n", toml_text(b.key), toml_list({b.lo, b.hi}));
    }
    return out;
}

std::string recipe_hash(const paint::Recipe& recipe) { return sha256_hex(write_recipe(recipe)); }

}  // namespace nacre::io
