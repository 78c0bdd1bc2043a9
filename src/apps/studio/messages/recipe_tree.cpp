#include "apps/studio/messages/recipe_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/io/described_toml.h"
#include "nacre/io/toml_edit.h"
#include "nacre/paint/recipe_description.h"

namespace nacre::studio {

namespace {

// ------------------------------------------------------------------------------ TOML to tree

Tree tree_of_node(const toml::node& node);

Tree tree_of_table(const toml::table& table) {
    std::vector<std::pair<const toml::key*, const toml::node*>> entries;
    for (auto&& [key, node] : table) entries.emplace_back(&key, &node);
    std::ranges::stable_sort(entries, [](const auto& a, const auto& b) {
        return a.first->source().begin < b.first->source().begin;
    });
    Tree tree = Tree::object();
    for (const auto& [key, node] : entries) {
        tree[std::string(key->str())] = tree_of_node(*node);
    }
    return tree;
}

Tree tree_of_node(const toml::node& node) {
    if (const auto* table = node.as_table()) return tree_of_table(*table);
    if (const auto* array = node.as_array()) {
        Tree list = Tree::array();
        for (const toml::node& entry : *array) list.push_back(tree_of_node(entry));
        return list;
    }
    if (const auto* text = node.as_string()) return text->get();
    if (const auto* whole = node.as_integer()) return whole->get();
    if (const auto* number = node.as_floating_point()) return number->get();
    if (const auto* flag = node.as_boolean()) return flag->get();
    return nullptr;  // a date, which no recipe has
}

// ------------------------------------------------------------------------------ tree to TOML

/// The tables of a recipe that have headers, as "layer.flakes", whether one or a list.
class HeaderVisitor final : public paint::Visitor {
 public:
    std::set<std::string> paths;

    void table(const paint::Field& field, paint::Described object) override {
        if (!field.in_line) descend(field.key, object);
    }
    void list(const paint::Field& field, paint::List& list) override {
        if (!field.in_line) descend(field.key, list.add());
    }
    void beside(const paint::Field& field) override { paths.insert(path_ + field.key); }
    bool has(const paint::Field&, bool) override { return true; }

 private:
    void descend(const char* key, paint::Described object) {
        const std::size_t length = path_.size();
        paths.insert(path_ + key);
        path_ += std::string(key) + ".";
        object.accept(*this);
        path_.resize(length);
    }

    std::string path_;
};

const std::set<std::string>& header_paths() {
    static const std::set<std::string> paths = [] {
        paint::Recipe recipe;
        HeaderVisitor visitor;
        paint::Described(recipe).accept(visitor);
        return visitor.paths;
    }();
    return paths;
}

class TreeWriter {
 public:
    std::string take() && { return std::move(text_); }

    void write_table(const Tree& table, const std::string& path, int depth) {
        check_depth(path, depth);
        for (const auto& [key, value] : table.items()) {
            if (!has_header(join(path, key), value)) {
                text_ +=
                    io::toml_key(key) + " = " + in_line(value, join(path, key), depth + 1) + "\n";
            }
        }
        for (const auto& [key, value] : table.items()) {
            const std::string own = join(path, key);
            if (!has_header(own, value)) continue;
            if (value.is_object()) {
                add_section("[" + own + "]", value, own, depth);
            } else {
                for (const Tree& entry : value) {
                    add_section("[[" + own + "]]", entry, own, depth);
                }
            }
        }
    }

    static std::string in_line(const Tree& value, const std::string& path, int depth) {
        check_depth(path, depth);
        if (value.is_string()) return io::toml_text(value.get_ref<const std::string&>());
        if (value.is_boolean()) return value.get<bool>() ? "true" : "false";
        if (value.is_number_integer()) return value.dump();
        if (value.is_number_float()) return io::toml_number(value.get<double>());
        std::string entries;
        if (value.is_object()) {
            for (const auto& [key, entry] : value.items()) {
                entries += (entries.empty() ? " " : ", ") + io::toml_key(key) + " = " +
                           in_line(entry, join(path, key), depth + 1);
            }
            return entries.empty() ? "{}" : "{" + entries + " }";
        }
        if (value.is_array()) {
            const bool tables = !value.empty() && std::ranges::all_of(value, [](const Tree& entry) {
                return entry.is_object();
            });
            for (const Tree& entry : value) {
                const std::string text = in_line(entry, path, depth + 1);
                entries += tables ? "\n    " + text + "," : (entries.empty() ? "" : ", ") + text;
            }
            return "[" + entries + (tables ? "\n]" : "]");
        }
        throw InputError(path + ": must be a number, a text, true or false, a list or a table");
    }

 private:
    static std::string join(const std::string& path, const std::string& key) {
        return path.empty() ? key : path + "." + key;
    }

    static void check_depth(const std::string& path, int depth) {
        if (depth < io::kMaxTomlNesting) return;
        throw InputError(fmt::format("{}: nests deeper than {} levels", path, io::kMaxTomlNesting));
    }

    /// Only what can be written so: what is of another kind is for the reader to refuse.
    static bool has_header(const std::string& path, const Tree& value) {
        if (!header_paths().contains(path)) return false;
        if (value.is_object()) return true;
        return value.is_array() && !value.empty() &&
               std::ranges::all_of(value, [](const Tree& entry) { return entry.is_object(); });
    }

    void add_section(const std::string& header, const Tree& table, const std::string& path,
                     int depth) {
        text_ += (text_.empty() ? "" : "\n") + header + "\n";
        write_table(table, path, depth + 1);
    }

    std::string text_;
};

// --------------------------------------------------------------------------- changes of values

/// A list without tables in it, which is changed as a whole.
bool is_plain_list(const Tree& value) {
    return value.is_array() &&
           std::ranges::none_of(value, [](const Tree& entry) { return entry.is_structured(); });
}

/// Adds what turns one tree into another, where values differ and keys do not.
/// @return false where more differs
bool add_edits(const Tree& from, const Tree& to, io::TomlPath& path,
               std::vector<io::TomlEditor::Edit>& edits) {
    if (from == to) return true;
    if (from.is_object() && to.is_object()) {
        if (from.size() != to.size()) return false;
        for (const auto& [key, value] : to.items()) {
            const auto found = from.find(key);
            if (found == from.end()) return false;
            path.emplace_back(key);
            const bool same_keys = add_edits(*found, value, path, edits);
            path.pop_back();
            if (!same_keys) return false;
        }
        return true;
    }
    const bool plain = is_plain_list(from) && is_plain_list(to);
    if (from.is_array() && to.is_array() && !plain) {
        if (from.size() != to.size()) return false;
        for (std::size_t i = 0; i < to.size(); ++i) {
            path.emplace_back(i);
            const bool same_keys = add_edits(from[i], to[i], path, edits);
            path.pop_back();
            if (!same_keys) return false;
        }
        return true;
    }
    if (!plain && (from.is_structured() || to.is_structured())) return false;
    edits.push_back({path, TreeWriter::in_line(to, "", 0)});
    return true;
}

std::optional<std::string> with_values(const std::string& before, const Tree& tree) {
    try {
        const Tree from = tree_of_toml(before, "recipe");
        io::TomlPath path;
        std::vector<io::TomlEditor::Edit> edits;
        if (!add_edits(from, tree, path, edits)) return std::nullopt;
        if (edits.empty()) return before;
        io::TomlEditor editor(before, "recipe");
        editor.set(edits);
        edits.clear();
        const bool alike = add_edits(tree_of_toml(editor.text(), "recipe"), tree, path, edits);
        if (!alike || !edits.empty()) return std::nullopt;
        return editor.text();
    } catch (const Error&) {  // not to be changed in its place: written anew
        return std::nullopt;
    }
}

}  // namespace

Tree tree_of_toml(const std::string& text, const std::string& filename) {
    return tree_of_table(io::TomlDocument(text, filename, {}).root());
}

std::string toml_of_tree(const Tree& tree) {
    if (!tree.is_object()) throw InputError("recipe: must be an object of its keys");
    TreeWriter writer;
    writer.write_table(tree, "", 0);
    return std::move(writer).take();
}

std::string toml_of_tree(const Tree& tree, const std::string& before) {
    std::string anew = toml_of_tree(tree);
    if (before.empty()) return anew;
    return with_values(before, tree).value_or(std::move(anew));
}

}  // namespace nacre::studio
