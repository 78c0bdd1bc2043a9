#include "nacre/io/toml_edit.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>

#include "nacre/core/error.h"
#include "nacre/core/text.h"
#include "nacre/io/described_toml.h"

namespace nacre::io {

namespace {

std::string path_text(const TomlPath& path) {
    std::string text;
    for (const auto& part : path) {
        if (const auto* place = std::get_if<std::size_t>(&part)) {
            text += fmt::format("[{}]", *place);
        } else {
            text += (text.empty() ? "" : ".") + toml_key(std::get<std::string>(part));
        }
    }
    return text;
}

[[noreturn]] void refuse_path(const TomlPath& path, std::string_view why) {
    throw DomainError(fmt::format("{}: {}", path_text(path), why));
}

/// Bytes of a text by its lines and columns, which count characters from 1.
class Offsets {
 public:
    explicit Offsets(std::string_view text) : text_(text) {
        lines_.push_back(text.size() - without_byte_order_mark(text).size());
        for (std::size_t i = 0; i < text.size(); ++i) {
            if (text[i] == '\n') lines_.push_back(i + 1);
        }
    }

    std::size_t operator()(const toml::source_position& at) const {
        if (at.line < 1 || at.line > lines_.size()) return text_.size();
        std::size_t i = lines_[at.line - 1];
        for (std::uint32_t column = 1; column < at.column && i < text_.size(); ++column) {
            for (++i; i < text_.size() && (text_[i] & 0xc0) == 0x80; ++i) {
            }
        }
        return i;
    }

 private:
    std::string_view text_;
    std::vector<std::size_t> lines_;  // where each begins
};

/// Whether a table or a list is written with headers, [table] or [[list]], or was made by those of
/// what lies in it.
bool has_header(const toml::node& node, std::string_view text, const Offsets& offset) {
    if (const toml::array* list = node.as_array()) {
        return !list->empty() && list->front().is_table() && !list->front().as_table()->is_inline();
    }
    if (!node.is_table() || node.as_table()->is_inline()) return false;
    const std::size_t begin = offset(node.source().begin);
    return begin < text.size() && text[begin] == '[';  // else it is named by dotted keys
}

/// A table that only the headers of what lies in it name has no lines of its own.
bool is_implicit(const toml::table& table) {
    return std::any_of(table.begin(), table.end(), [&](const auto& entry) {
        return (entry.second.is_table() || entry.second.is_array()) &&
               entry.second.source().begin == table.source().begin;
    });
}

struct Span {
    std::size_t begin = 0, end = 0;
};

/// The last of the values that stand in a table's own lines.
std::optional<Span> last_value(const toml::table& table, std::string_view text,
                               const Offsets& offset) {
    std::optional<Span> last;
    for (auto&& [key, node] : table) {
        if (has_header(node, text, offset)) continue;
        const toml::table* inner = node.as_table();
        const std::optional<Span> here =
            inner && !inner->is_inline()
                ? last_value(*inner, text, offset)
                : Span{offset(node.source().begin), offset(node.source().end)};
        if (here && (!last || here->end > last->end)) last = here;
    }
    return last;
}

std::string_view line_end_of(std::string_view text, std::size_t at) {
    const std::size_t end = text.find('\n', at);
    const bool crlf = end == std::string_view::npos ? text.find("\r\n") != std::string_view::npos
                                                    : end > 0 && text[end - 1] == '\r';
    return crlf ? "\r\n" : "\n";
}

/// The spaces with which the line of a character begins.
std::string_view indent_of(std::string_view text, std::size_t at) {
    const std::size_t newline = text.substr(0, at).rfind('\n');
    const std::size_t begin = newline == std::string_view::npos ? 0 : newline + 1;
    const std::size_t end = std::min(text.find_first_not_of(" \t", begin), at);
    return text.substr(begin, end - begin);
}

/// A line below that in which `at` stands.
std::string with_line_below(std::string text, std::size_t at, std::string_view indent,
                            const std::string& line) {
    const std::string newline(line_end_of(text, at));
    const std::size_t end = text.find('\n', at);
    if (end == std::string::npos) return text + newline + std::string(indent) + line;
    return text.insert(end + 1, std::string(indent) + line + newline);
}

}  // namespace

TomlPath parse_toml_path(std::string_view text) {
    const auto refuse = [&] {
        throw DomainError(fmt::format(
            "{}: is no key; it must be like layer[0].flakes[0].core.thickness_nm", excerpt(text)));
    };
    TomlPath path;
    for (const std::string_view part : split(text, '.')) {
        const std::size_t bracket = std::min(part.find('['), part.size());
        if (!is_bare_toml_key(part.substr(0, bracket))) refuse();
        path.emplace_back(std::string(part.substr(0, bracket)));
        for (std::string_view rest = part.substr(bracket); !rest.empty();) {
            std::size_t place = 0;
            const char* const end = rest.data() + rest.size();
            const auto [stop, error] = std::from_chars(rest.data() + 1, end, place);
            if (rest[0] != '[' || error != std::errc() || stop == end || *stop != ']') refuse();
            path.emplace_back(place);
            rest = {stop + 1, static_cast<std::size_t>(end - stop - 1)};
        }
    }
    return path;
}

std::string toml_value(std::string_view text) {
    text = trimmed(text);
    const std::string line = "x = " + std::string(text);
    std::string why = "must be one value";
    try {
        const TomlDocument document(line, "value", {});
        const toml::node* node = document.root().get("x");
        if (document.root().size() == 1 && node &&
            !(node->is_table() && !node->as_table()->is_inline())) {
            const Offsets offset(line);
            const std::size_t begin = offset(node->source().begin);
            return line.substr(begin, offset(node->source().end) - begin);
        }
    } catch (const InputError&) {
        const bool is_text = !text.empty() &&
                             text.find_first_of("\n\r") == std::string_view::npos &&
                             std::string_view("\"'[{").find(text[0]) == std::string_view::npos;
        if (is_text) return toml_text(std::string(text));
        why = "must be a value of TOML: a number, \"text\", true, [list] or { table }";
    }
    throw DomainError(fmt::format("'{}': {}", excerpt(text), why));
}

TomlEditor::TomlEditor(std::string text, std::string filename)
    : text_(std::move(text)), filename_(std::move(filename)), document_(text_, filename_, {}) {}

void TomlEditor::become(std::string text) {
    document_ = TomlDocument(text, filename_, {});
    text_ = std::move(text);
}

const toml::node* TomlEditor::find(const TomlPath& path) const {
    const toml::node* node = &document_.root();
    for (const auto& part : path) {
        if (const auto* place = std::get_if<std::size_t>(&part)) {
            const toml::array* list = node->as_array();
            node = list && *place < list->size() ? &(*list)[*place] : nullptr;
        } else {
            const toml::table* table = node->as_table();
            node = table ? table->get(std::get<std::string>(part)) : nullptr;
        }
        if (!node) return nullptr;
    }
    return node;
}

std::vector<std::pair<std::string, std::string>> TomlEditor::entries() const {
    const Offsets offset(text_);
    std::map<std::size_t, std::pair<std::string, std::string>> by_place;
    for (auto&& [key, node] : root()) {
        if (has_header(node, text_, offset)) continue;
        const std::size_t begin = offset(node.source().begin), end = offset(node.source().end);
        by_place[begin] = {std::string(key.str()), text_.substr(begin, end - begin)};
    }
    std::vector<std::pair<std::string, std::string>> entries;
    for (auto& [place, entry] : by_place) entries.push_back(std::move(entry));
    return entries;
}

void TomlEditor::set(const std::vector<Edit>& edits) {
    struct Replacement {
        Span span;
        const Edit* edit;
    };
    const Offsets offset(text_);
    std::vector<Replacement> replacements;
    std::vector<const Edit*> additions;
    for (const Edit& edit : edits) {
        if (const toml::node* node = find(edit.path)) {
            const toml::table* table = node->as_table();
            if (has_header(*node, text_, offset) || (table && !table->is_inline())) {
                refuse_path(edit.path,
                            "is written over several lines of the file; name a value in it");
            }
            replacements.push_back(
                {{offset(node->source().begin), offset(node->source().end)}, &edit});
        } else {
            additions.push_back(&edit);
        }
    }
    // From the end on, so that what comes before keeps its place.
    std::sort(replacements.begin(), replacements.end(),
              [](const auto& a, const auto& b) { return a.span.begin > b.span.begin; });
    std::string text = text_;
    for (std::size_t i = 0; i < replacements.size(); ++i) {
        const auto& [span, edit] = replacements[i];
        if (i > 0 && span.end > replacements[i - 1].span.begin) {
            refuse_path(edit->path, "is set twice");
        }
        text.replace(span.begin, span.end - span.begin, edit->value);
    }
    // A copy of a document would not know where its values stand.
    TomlEditor changed(std::move(text), filename_);
    for (const Edit* edit : additions) {
        if (changed.find(edit->path)) refuse_path(edit->path, "is set twice");
        changed.add(*edit);
    }
    *this = std::move(changed);
}

void TomlEditor::add(const Edit& edit) {
    const Offsets offset(text_);
    // The tables on the way that there are. A key is added to the innermost of them that is written
    // as one, with what follows as dotted keys.
    const toml::table* table = &document_.root();
    std::size_t depth = 0;
    bool is_root = true;
    const toml::node* node = table;
    for (std::size_t i = 0; i < edit.path.size(); ++i) {
        const TomlPath so_far(edit.path.begin(),
                              edit.path.begin() + static_cast<std::ptrdiff_t>(i) + 1);
        node = find(so_far);
        if (!node) {
            if (std::holds_alternative<std::size_t>(edit.path[i])) {
                refuse_path(so_far, "there is no such entry in the file");
            }
            break;
        }
        if (const toml::table* inner = node->as_table();
            inner && (inner->is_inline() || has_header(*inner, text_, offset))) {
            table = inner;
            depth = i + 1;
            is_root = false;
        } else if (!inner && !node->is_array()) {
            refuse_path(so_far, "is a value without keys");
        }
    }
    std::string key, header;
    for (std::size_t i = depth; i < edit.path.size(); ++i) {
        const auto* part = std::get_if<std::string>(&edit.path[i]);
        if (!part) refuse_path(edit.path, "there is no such entry in the file");
        if (i + 1 == edit.path.size()) header = key;
        key += (key.empty() ? "" : ".") + toml_key(*part);
    }
    const std::string entry = key + " = " + edit.value;
    const std::optional<Span> last = last_value(*table, text_, offset);
    std::string text = text_;
    if (table->is_inline()) {
        const std::size_t brace = offset(table->source().end) - 1;
        const std::size_t before = text.find_last_not_of(" \t", brace - 1) + 1;
        const char* after = table->empty() && before == brace ? " " : "";
        text.insert(before, (table->empty() ? " " : ", ") + entry + after);
    } else if (is_root && !header.empty() && !find({edit.path[0]})) {
        const std::string newline(line_end_of(text, text.size()));
        if (!text.empty() && text.back() != '\n') text += newline;
        text += fmt::format("{}[{}]{}{} = {}{}", text.empty() ? "" : newline, header, newline,
                            key.substr(header.size() + 1), edit.value, newline);
    } else if (last) {
        text = with_line_below(std::move(text), last->end, indent_of(text_, last->begin), entry);
    } else if (is_root) {
        const std::size_t mark = text.size() - without_byte_order_mark(text).size();
        text.insert(mark, entry + std::string(line_end_of(text, 0)));
    } else {
        if (is_implicit(*table)) refuse_path(edit.path, "its table has no line of its own");
        const std::size_t header_end = offset(table->source().end);
        text = with_line_below(std::move(text), header_end,
                               indent_of(text_, offset(table->source().begin)), entry);
    }
    become(std::move(text));
}

void TomlEditor::replace(const TomlPath& path,
                         const std::vector<std::pair<std::string, std::string>>& entries) {
    const toml::node* node = find(path);
    const auto* key = path.empty() ? nullptr : std::get_if<std::string>(&path.back());
    if (!node || !key) refuse_path(path, "there is no such entry in the file");
    const TomlPath above(path.begin(), path.end() - 1);
    const toml::table& table = *find(above)->as_table();
    const Offsets offset(text_);
    const std::size_t begin = offset(table.find(*key)->first.source().begin),
                      end = offset(node->source().end);
    const std::string between = table.is_inline() ? ", "
                                                  : std::string(line_end_of(text_, begin)) +
                                                        std::string(indent_of(text_, begin));
    std::string lines;
    for (const auto& [name, value] : entries) {
        lines += fmt::format("{}{} = {}", lines.empty() ? "" : between, toml_key(name), value);
    }
    std::string text = text_;
    become(text.replace(begin, end - begin, lines));
}

}  // namespace nacre::io
