#include "apps/studio/schema.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "apps/datasheet/catalogue.h"
#include "apps/datasheet/composition.h"
#include "apps/studio/messages/stage.h"
#include "nacre/core/csv.h"
#include "nacre/core/error.h"
#include "nacre/core/text.h"
#include "nacre/core/version.h"
#include "nacre/io/recipe_text.h"
#include "nacre/measure/geometry.h"
#include "nacre/models/models.h"
#include "nacre/nacre.h"
#include "nacre/optics/material.h"
#include "nacre/paint/recipe_description.h"

namespace nacre::studio {

namespace {

/// Keys whose ends are further apart are better set by their ratios.
constexpr double kLogarithmicRatio = 1e3;

Tree number_or_null(double x) { return std::isfinite(x) ? Tree(x) : Tree(nullptr); }

/// Collects the keys of one table, and the tables in it behind it. A table with alternatives is
/// visited again and again, until each has stood in it.
class TableVisitor final : public paint::Visitor {
 public:
    /// @param path  of the table, as "layer[].flakes[]"; "" is the outermost
    TableVisitor(Tree& tables, std::string path, bool ordered)
        : tables_(tables), path_(std::move(path)), ordered_(ordered) {}

    /// @param object  a new one
    void collect(const paint::Described& object) {
        do {
            choices_ = 1;
            object.accept(*this);
            rounds_ = std::max(rounds_, choices_);
            ++round_;
        } while (round_ < rounds_);
        // As they are described.
        const std::vector<std::string> order = paint::keys_of(object);
        Tree sorted = Tree::array();
        for (const std::string& name : order) {
            for (const Tree& key : keys_) {
                if (key["key"] == name) sorted.push_back(key);
            }
        }
        Tree table = {{"path", path_},
                      {"title", title()},
                      {"doc", ""},
                      {"ordered", ordered_},
                      {"keys", std::move(sorted)},
                      {"alternatives", std::move(alternatives_)}};
        tables_.push_back(std::move(table));
        for (Tree& inner : inner_) tables_.push_back(std::move(inner));
    }

    void number(const paint::Field& field, double& value) override {
        Tree& key = add(field, "number");
        key["default"] = field.required ? Tree(nullptr) : Tree(value);
    }
    void spectrum(const paint::Field& field, spectra::Spectrum& value) override {
        Tree& key = add(field, "spectrum");
        key["default"] = field.required ? Tree(nullptr) : Tree(value.max());
        if (field.colour) key["rgb"] = true;
    }
    void material(const paint::Field& field, optics::Material&) override {
        Tree& key = add(field, "material");
        // Of an index that stands in place of a name.
        tell_range(key,
                   std::isfinite(field.range.lo) ? field.range : optics::kRefractiveIndexRange);
        key["choices"] = "materials";
        if (field.real) key["transparent"] = true;
    }
    void text(const paint::Field& field, std::string& value) override {
        add(field, "text")["default"] = value;
    }
    void choice(const paint::Field& field, const paint::Choices& choices,
                std::size_t& index) override {
        Tree& key = add(field, "choice");
        key["choices"] = choices;
        key["default"] = field.required ? Tree(nullptr) : Tree(choices[index]);
    }
    void flag(const paint::Field& field, bool& value) override {
        add(field, "flag")["default"] = value;
    }
    void preset(const paint::Field& field) override { add(field, "text")["choices"] = "pigments"; }
    void beside(const paint::Field& field) override { add(field, "table"); }
    bool has(const paint::Field&, bool) override { return true; }

    void table(const paint::Field& field, paint::Described object) override {
        if (!add_once(field, "table")) return;
        add_inner(field, "", false, object);
    }
    void list(const paint::Field& field, paint::List& list) override {
        if (!add_once(field, "list")) return;
        add_inner(field, "[]", true, list.add());
    }
    void other(const paint::Field& field) override {
        throw std::logic_error(std::string("no schema for the value of ") + field.key);
    }

    std::size_t alternative(const paint::Alternatives& alternatives,
                            const std::vector<std::vector<std::string> (*)()>& keys,
                            std::size_t) override {
        Tree each = Tree::array();
        for (std::size_t i = 0; i < keys.size(); ++i) {
            each.push_back({{"mark", alternatives.each[i].mark}, {"keys", keys[i]()}});
        }
        const Tree group = {{"required", !alternatives.neither.empty()}, {"each", std::move(each)}};
        if (std::ranges::find(alternatives_, group) == alternatives_.end()) {
            alternatives_.push_back(group);
        }
        // The digits of the round's number: every choice meets every other.
        const std::size_t index = round_ / choices_ % keys.size();
        choices_ *= keys.size();
        return index;
    }

 private:
    std::string title() const {
        std::string name = path_.substr(path_.rfind('.') + 1);  // all of it without a dot
        std::erase_if(name, [](char c) { return c == '[' || c == ']'; });
        std::ranges::replace(name, '_', ' ');
        return name.empty() ? "recipe" : name;
    }

    static void tell_range(Tree& key, const Range& range) {
        key["min"] = number_or_null(range.lo);
        key["max"] = number_or_null(range.hi);
        key["min_excluded"] = range.lo_open;
        key["max_excluded"] = range.hi_open;
    }

    Tree* find(const paint::Field& field) {
        const auto found =
            std::ranges::find_if(keys_, [&](const Tree& key) { return key["key"] == field.key; });
        return found == keys_.end() ? nullptr : &*found;
    }

    /// The entry of a key, made when it is first visited.
    Tree& add(const paint::Field& field, const char* kind) {
        if (Tree* known = find(field)) return *known;
        const Range& range = field.range;
        const bool number = kind == std::string("number") || kind == std::string("spectrum");
        Tree key = {{"key", field.key},
                    {"kind", kind},
                    {"unit", range.unit},
                    {"doc", field.meaning},
                    {"required", field.required}};
        if (number) {
            tell_range(key, range);
            key["log"] = range.lo >= 0 && range.hi > kLogarithmicRatio * std::max(range.lo, 1.0);
            if (field.typical) key["typical"] = *field.typical;
            if (field.zero) key["zero"] = field.zero;
        }
        if (field.required_with) key["required_with"] = field.required_with;
        if (field.also) key["also"] = field.also;
        if (field.spread_of) key["spread_of"] = field.spread_of;
        if (field.max_size > 0) key["max_size"] = field.max_size;
        keys_.push_back(std::move(key));
        return keys_.back();
    }

    bool add_once(const paint::Field& field, const char* kind) {
        if (find(field)) return false;
        add(field, kind);
        return true;
    }

    void add_inner(const paint::Field& field, const char* suffix, bool ordered,
                   paint::Described object) {
        TableVisitor visitor(inner_, (path_.empty() ? "" : path_ + ".") + field.key + suffix,
                             ordered);
        visitor.collect(object);
    }

    Tree& tables_;
    std::string path_;
    bool ordered_;
    Tree keys_ = Tree::array(), alternatives_ = Tree::array(), inner_ = Tree::array();
    std::size_t round_ = 0, rounds_ = 1, choices_ = 1;
};

/// "#rrggbb" as three numbers in [0, 1]; null for an empty text.
Tree rgb_of(const std::string& css) {
    if (css.size() != 7) return nullptr;
    Tree rgb = Tree::array();
    for (int c = 0; c < 3; ++c)
        rgb.push_back(std::stoi(css.substr(1 + 2 * c, 2), nullptr, 16) / 255.0);
    return rgb;
}

Tree number_of(const std::string& cell) {
    return cell.empty() ? Tree(nullptr) : Tree(std::stod(cell));
}

/// The rows of a table by the names of its columns.
std::vector<std::map<std::string, std::string>> rows_of(const std::string& csv) {
    const std::vector<CsvRow> rows = parse_csv(csv, "table", ',');
    std::vector<std::map<std::string, std::string>> named;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        auto& row = named.emplace_back();
        for (std::size_t c = 0; c < rows[0].size(); ++c) row[rows[0][c].text] = rows[i].at(c).text;
    }
    return named;
}

Tree materials_json() {
    Tree all = Tree::array();
    for (const auto& row : rows_of(datasheet::materials_csv())) {
        const std::string& name = row.at("name");
        all.push_back({{"name", name},
                       {"summary", datasheet::material_text(optics::find_material(name, {}))},
                       {"source", row.at("source")},
                       {"first_nm", number_of(row.at("from_nm"))},
                       {"last_nm", number_of(row.at("to_nm"))},
                       {"n_550", number_of(row.at("n_550"))},
                       {"k_550", number_of(row.at("k_550"))},
                       {"rgb", rgb_of(row.at("chip"))}});
    }
    return all;
}

Tree pigments_json(const Progress& progress) {
    Tree all = Tree::array();
    for (const auto& row : rows_of(datasheet::pigments_csv(progress))) {
        all.push_back({{"name", row.at("name")},
                       {"summary", row.at("title")},
                       {"kind", row.at("kind")},
                       {"source", row.at("source")},
                       {"rgb", rgb_of(row.at("over_white"))},
                       {"rgb_over_black", rgb_of(row.at("over_black"))}});
    }
    return all;
}

/// The recipes that ship, each by itself: without need of any other file.
Tree paints_json() {
    Tree all = Tree::array();
    for (const std::string& name : shipped_paints()) {
        const Paint paint = open(find_paint(name));
        all.push_back({{"name", name},
                       {"title", paint.name()},
                       {"toml", paint.recipe_text(References()).text}});
    }
    return all;
}

/// The flakes of the paints, as entries of a layer's list: called as their paint where they are its only
/// ones.
Tree flakes_json(const Tree& paints) {
    Tree all = Tree::array();
    for (const Tree& paint : paints) {
        const std::string title = paint["title"];
        const Tree recipe = tree_of_toml(paint["toml"], title);
        Tree own = Tree::array();
        for (const Tree& layer : recipe.value("layer", Tree::array())) {
            for (const Tree& flakes : layer.value("flakes", Tree::array())) {
                own.push_back({{"name", title}, {"summary", ""}, {"value", flakes}});
            }
        }
        for (std::size_t i = 0; i < own.size(); ++i) {
            const std::string name = own[i]["value"].value("name", "");
            if (own.size() > 1) own[i]["name"] = fmt::format("{}, flakes {}", title, i + 1);
            if (lowercase(name) != lowercase(title)) own[i]["summary"] = name;
            all.push_back(std::move(own[i]));
        }
    }
    return all;
}

Tree geometry_sets_json() {
    Tree all = Tree::array();
    for (const measure::GeometrySet& set : measure::geometry_sets()) {
        Tree names = Tree::array();
        for (const Geometry& geometry : set.geometries) names.push_back(geometry.name);
        all.push_back({{"name", set.name}, {"summary", set.summary}, {"geometries", names}});
    }
    return all;
}

Tree reading_models_json() {
    Tree all = Tree::array();
    const std::string_view of_pictures = models::default_picture_model().info().name;
    for (const std::string_view name : models::names_of_fitted()) {
        std::string title(name);
        if (name == of_pictures) title += ", as the picture";
        all.push_back({{"name", name}, {"title", std::move(title)}});
    }
    return all;
}

}  // namespace

Tree recipe_schema() {
    Tree tables = Tree::array();
    TableVisitor visitor(tables, "", false);
    paint::Recipe recipe;
    visitor.collect(paint::Described(recipe));
    return {{"tables", std::move(tables)}};
}

Tree schema(const Progress& progress) {
    Tree illuminants = Tree::array(), observers = Tree::array();
    for (const Illuminant i : {Illuminant::A, Illuminant::D50, Illuminant::D65, Illuminant::FL2,
                               Illuminant::FL11, Illuminant::E}) {
        illuminants.push_back(spectra::name(i));
    }
    for (const Observer o : {Observer::cie1931_2deg, Observer::cie1964_10deg}) {
        observers.push_back(spectra::name(o));
    }
    Tree paints = paints_json();
    Tree flakes = flakes_json(paints);
    return {{"version", version()},
            {"api", kApiVersion},
            {"recipe", recipe_schema()},
            {"materials", materials_json()},
            {"pigments", pigments_json(progress)},
            {"flakes", std::move(flakes)},
            {"paints", std::move(paints)},
            {"geometry_sets", geometry_sets_json()},
            {"illuminants", std::move(illuminants)},
            {"observers", std::move(observers)},
            {"reading_models", reading_models_json()},
            {"shapes", shapes_json()},
            {"lights", lights_json()},
            {"mean_model", models::default_model().info().name}};
}

}  // namespace nacre::studio
