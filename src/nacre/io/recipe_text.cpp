#include "nacre/io/recipe_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>

#include "nacre/core/error.h"
#include "nacre/core/text.h"
#include "nacre/io/described_toml.h"
#include "nacre/io/pigment_file.h"
#include "nacre/io/toml_edit.h"
#include "nacre/paint/recipe_description.h"

namespace nacre::io {

namespace {

using paint::Field;
using spectra::Spectrum;

constexpr std::string_view kScaled = ".max";

bool is_scaled(std::string_view key) { return key.ends_with(kScaled); }

std::string write_whole(const RecipeFile& file) {
    return write_recipe(file.recipe, file.bounds, file.deviations, file.correlations);
}

/// The paths of all values that a recipe has, of the lists and tables that they are in, and a
/// spectrum by its path.
class ValueList final : public paint::PathVisitor {
 public:
    void number(const Field& field, double&) override { keys.push_back(path_of(field)); }
    void spectrum(const Field& field, Spectrum& value) override {
        keys.push_back(path_of(field));
        if (keys.back() == wanted) found = value;
    }
    void material(const Field& field, optics::Material&) override {
        keys.push_back(path_of(field));
    }
    void text(const Field& field, std::string&) override { keys.push_back(path_of(field)); }
    void flag(const Field& field, bool&) override { keys.push_back(path_of(field)); }
    void choice(const Field& field, const paint::Choices&, std::size_t&) override {
        keys.push_back(path_of(field));
    }
    void table(const Field& field, paint::Described object) override {
        tables.push_back(path_of(field));
        PathVisitor::table(field, object);
    }
    void list(const Field& field, paint::List& list) override {
        tables.push_back(path_of(field));
        for (std::size_t i = 0; i < list.size(); ++i) {
            tables.push_back(fmt::format("{}[{}]", path_of(field), i));
        }
        PathVisitor::list(field, list);
    }

    std::string wanted;
    std::vector<std::string> keys, tables;
    std::optional<Spectrum> found;
};

ValueList values_of(const paint::Recipe& recipe, const std::string& wanted = "") {
    ValueList list;
    list.wanted = wanted;
    paint::Described::to_inspect(recipe).accept(list);
    return list;
}

/// Writes down the keys that a pigment has from another file, if `path` is that of one of them.
void write_out_pigment(TomlEditor& editor, const paint::Recipe& recipe, const TomlPath& path) {
    // layer, i, pigment, j, key
    if (path.size() < 5 || path[0] != TomlPath::value_type("layer") ||
        path[2] != TomlPath::value_type("pigment") || editor.find(path)) {
        return;
    }
    const std::vector<std::string> beside = keys_beside_from();
    const auto* key = std::get_if<std::string>(&path[4]);
    TomlPath from(path.begin(), path.begin() + 4);
    const toml::node* table = editor.find(from);
    from.emplace_back("from");
    if (!key || std::ranges::find(beside, *key) != beside.end() || !editor.find(from)) return;
    const paint::Pigment& pigment = recipe.layers.at(std::get<std::size_t>(path[1]))
                                        .pigments.at(std::get<std::size_t>(path[3]));
    auto entries =
        TomlEditor(write_described(paint::Described::to_inspect(pigment)), "pigment").entries();
    std::erase_if(entries, [&](const auto& entry) {
        return table->as_table()->contains(entry.first) || entry.second == "\"\"";
    });
    editor.replace(from, entries);
}

/// What puts a number of the recipe (paint::recipe_parameters()) into its text.
std::vector<TomlEditor::Edit> edits_of(TomlEditor& editor, const paint::Recipe& recipe,
                                       const paint::RecipeParameter& number) {
    if (!is_scaled(number.key)) {
        const TomlPath path = parse_toml_path(number.key);
        write_out_pigment(editor, recipe, path);
        return {{path, toml_number(number.value)}};
    }
    const std::string key = number.key.substr(0, number.key.size() - kScaled.size());
    const TomlPath path = parse_toml_path(key);
    write_out_pigment(editor, recipe, path);
    const Spectrum spectrum = values_of(recipe, key).found.value();
    TomlPath samples = path;
    samples.emplace_back("values");
    const toml::node* there = editor.find(samples);
    if (!there || !there->is_array() || there->as_array()->size() != spectrum.values().size()) {
        return {{path, toml_spectrum(spectrum)}};
    }
    std::vector<TomlEditor::Edit> edits;  // one by one: comments between them stay
    for (std::size_t i = 0; i < spectrum.values().size(); ++i) {
        TomlPath sample = samples;
        sample.emplace_back(i);
        edits.push_back({std::move(sample), toml_number(spectrum.values()[i])});
    }
    return edits;
}

/// Without "file:line:column: " in front, which mean nothing in a text that nobody has seen.
std::string without_place(std::string message, const std::string& filename) {
    if (!message.starts_with(filename + ":")) return message;
    std::size_t at = filename.size() + 1;
    for (int i = 0; i < 2; ++i) {
        const std::size_t digits = at;
        while (at < message.size() && std::isdigit(static_cast<unsigned char>(message[at]))) ++at;
        if (at > digits && at < message.size() && message[at] == ':') ++at;
    }
    return std::string(trimmed(std::string_view(message).substr(at)));
}

std::string setting_text(const RecipeSetting& setting) {
    return excerpt(setting.first + "=" + setting.second);
}

/// The keys that one setting means.
std::vector<std::string> keys_of_setting(const paint::Recipe& recipe, const std::string& pattern) {
    const ValueList values = values_of(recipe);
    std::vector<std::string> keys = values.keys;
    for (const paint::RecipeParameter& number : paint::recipe_parameters(recipe)) {
        if (is_scaled(number.key)) keys.push_back(number.key);
    }
    for (const std::vector<std::string>* of : {&std::as_const(keys), &values.tables}) {
        const std::vector<std::string> found = paint::matching_keys(*of, pattern);
        if (!found.empty()) return found;
    }
    const std::vector<std::string> tables = paint::keys_of_new<paint::Recipe>();
    try {
        const TomlPath path = parse_toml_path(pattern);
        const std::string& table = std::get<std::string>(path.at(0));
        const bool is_list = std::ranges::any_of(
            keys, [&](const std::string& key) { return key.starts_with(table + "["); });
        // Of tables that the recipe may have: its reader knows their keys. Or such a table itself.
        const bool fits =
            path.size() == 1 || is_list == std::holds_alternative<std::size_t>(path[1]);
        if (fits && std::ranges::find(tables, table) != tables.end()) return {pattern};
    } catch (const DomainError&) {  // is no path either
    }
    keys.insert(keys.end(), values.tables.begin(), values.tables.end());
    std::vector<std::string> ends = keys;
    for (const std::string& key : keys) {
        for (std::size_t dot = key.find('.'); dot != std::string::npos;
             dot = key.find('.', dot + 1)) {
            ends.push_back(key.substr(dot + 1));
        }
    }
    throw DomainError("is not a key of this recipe" + did_you_mean(pattern, ends));
}

}  // namespace

RecipeText recipe_text(const RecipeFile& file, const References& there) {
    RecipeText anew{write_whole(file), ""};
    if (!file.source) return anew;
    const RecipeSource& source = *file.source;
    try {
        const RecipeFile before =
            parse_recipe_file(source.text, source.filename, source.references);
        TomlEditor editor(source.text, source.filename);
        std::vector<TomlEditor::Edit> edits;
        for (const paint::RecipeParameter& number : paint::recipe_parameters(file.recipe)) {
            if (paint::find_parameter(before.recipe, number.key).value == number.value) continue;
            for (TomlEditor::Edit& edit : edits_of(editor, file.recipe, number)) {
                edits.push_back(std::move(edit));
            }
        }
        for (const paint::ParameterDeviation& d : file.deviations) {
            if (std::ranges::find(before.deviations, d) != before.deviations.end()) continue;
            edits.push_back({{"uncertainty", d.key}, toml_deviation(d)});
        }
        if (file.correlations != before.correlations && !file.correlations.empty()) {
            edits.push_back({{"uncertainty", "correlation"}, toml_correlations(file.correlations)});
        }
        editor.set(edits);
        if (write_whole(parse_recipe_file(editor.text(), source.filename, there)) == anew.text) {
            return {editor.text(), ""};
        }
        anew.rewritten = "its text with other numbers in it is not that recipe";
    } catch (const Error& error) {
        anew.rewritten = error.what();
    }
    return anew;
}

RecipeFile with_settings(const RecipeFile& file, const std::vector<RecipeSetting>& settings) {
    const std::string filename = file.source ? file.source->filename : "recipe";
    const References references = file.source ? file.source->references : References();
    TomlEditor editor(recipe_text(file, references).text, filename);
    std::vector<TomlEditor::Edit> edits;
    std::vector<std::pair<std::string, double>> scaled;
    std::vector<std::pair<std::string, const RecipeSetting*>> origins;
    for (const RecipeSetting& setting : settings) {
        try {
            const std::string value = toml_value(setting.second);
            for (const std::string& key : keys_of_setting(file.recipe, setting.first)) {
                origins.emplace_back(key, &setting);
                if (is_scaled(key)) {
                    const auto number = parse_number(setting.second);
                    if (!number) throw DomainError(key + ": must be a number");
                    scaled.emplace_back(key, *number);
                    continue;
                }
                const TomlPath path = parse_toml_path(key);
                write_out_pigment(editor, file.recipe, path);
                edits.push_back({path, value});
            }
        } catch (const DomainError& error) {
            throw DomainError(setting_text(setting) + ": " + error.what());
        }
    }
    const auto blame = [&](const std::string& message) {
        for (const auto& [key, setting] : origins) {
            if (message.find(key) != std::string::npos) {
                return DomainError(setting_text(*setting) + ": " + message);
            }
        }
        return DomainError(setting_text(settings.back()) + ": " + message);
    };
    try {
        editor.set(edits);
        RecipeFile changed = parse_recipe_file(editor.text(), filename, references);
        if (scaled.empty()) return changed;
        for (const auto& [key, value] : scaled) paint::set_parameter(changed.recipe, key, value);
        return parse_recipe_file(recipe_text(changed, references).text, filename, references);
    } catch (const InputError& error) {
        throw blame(without_place(error.what(), filename));
    } catch (const DomainError& error) {
        throw blame(error.what());
    }
}

}  // namespace nacre::io
