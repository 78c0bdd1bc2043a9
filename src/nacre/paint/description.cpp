#include "nacre/paint/description.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace nacre::paint {

// ------------------------------------------------------------------------------------- keys

namespace {

/// Visits the keys of an object's own table only, those of all alternatives among them.
class KeyVisitor : public Visitor {
 public:
    bool has(const Field& field, bool) override {
        other(field);
        return false;
    }
    void beside(const Field& field) override { other(field); }
    void preset(const Field& field) override { other(field); }
    bool visits_all_alternatives() const override { return true; }

 protected:
    ~KeyVisitor() = default;
};

class KeyList final : public KeyVisitor {
 public:
    void other(const Field& field) override {
        // Alternatives may have keys in common.
        if (std::find(keys.begin(), keys.end(), field.key) == keys.end()) {
            keys.emplace_back(field.key);
        }
    }
    void kind(const Field& field, const Choices&, std::size_t&) override {
        other(field);
        has_kind = true;
    }

    std::vector<std::string> keys;
    bool has_kind = false;
};

}  // namespace

std::vector<std::string> keys_of(const Described& object) {
    KeyList list;
    object.accept(list);
    return list.keys;
}

std::vector<std::string> keys_to_open(const Described& object) {
    KeyList list;
    object.accept(list);
    return list.has_kind ? std::vector<std::string>() : list.keys;
}

void PathVisitor::descend(const std::string& key, const Described& object) {
    const std::size_t length = path_.size();
    path_ += key + ".";
    object.accept(*this);
    path_.resize(length);
}

void PathVisitor::table(const Field& field, Described object) { descend(field.key, object); }

void PathVisitor::list(const Field& field, List& list) {
    for (std::size_t i = 0; i < list.size(); ++i) {
        descend(fmt::format("{}[{}]", field.key, i), list.at(i));
    }
}

void PathVisitor::named(const Field& field, NamedList& list) {
    list.for_each([&](const std::string& name, Described object) {
        descend(fmt::format("{}.{}", field.key, name), object);
    });
}

// ----------------------------------------------------------------------------------- checks

bool allows(const Field& field, double value) {
    return (field.zero && value == 0) || field.range.contains(value);
}

std::string allowed_text(const Field& field) {
    const std::string zero = field.zero ? fmt::format("0, {}, or ", field.zero) : "";
    return zero + "a number in " + field.range.text();
}

void RangeCheck::number(const Field& field, double& value) {
    if (allows(field, value)) return;
    throw DomainError(fmt::format("{} = {}: must be {}{}", path_of(field), value,
                                  field.zero ? allowed_text(field) : "in " + field.range.text(),
                                  percent_hint(field.key, value, field.range)));
}

void RangeCheck::spectrum(const Field& field, spectra::Spectrum& value) {
    double smallest = value.min(), largest = value.max();
    number(field, smallest);
    number(field, largest);
    if (value.values().size() > kMaxSpectrumSamples) {
        throw DomainError(fmt::format("{}: has {} samples; at most {} are allowed", path_of(field),
                                      value.values().size(), kMaxSpectrumSamples));
    }
}

void RangeCheck::vector(const Field& field, Vec3f& value) {
    for (double component : {value.x, value.y, value.z}) number(field, component);
}

void RangeCheck::list(const Field& field, List& list) {
    if (list.size() > field.max_size) {
        throw DomainError(fmt::format("{}: has {} entries; at most {} are allowed", path_of(field),
                                      list.size(), field.max_size));
    }
    PathVisitor::list(field, list);
}

// ---------------------------------------------------------------------------- documentation

namespace {

/// Powers of ten from 10000 on as 1e4.
std::string short_number(double x) {
    if (x < 0) return "-" + short_number(-x);
    const std::string text = fmt::format("{}", x);
    const bool power =
        text.size() > 4 && text[0] == '1' && text.find_first_not_of('0', 1) == std::string::npos;
    return power ? fmt::format("1e{}", text.size() - 1) : text;
}

std::string short_text(const Range& range) {
    return fmt::format("{}{}, {}{}", range.lo_open ? '(' : '[', short_number(range.lo),
                       short_number(range.hi), range.hi_open ? ')' : ']');
}

std::string unit_text(const Range& range) { return *range.unit ? range.unit : "1"; }

class MarkdownRows final : public KeyVisitor {
 public:
    void number(const Field& field, double& value) override {
        row(field, "number", unit_text(field.range), range_text(field), short_number(value));
    }
    void spectrum(const Field& field, spectra::Spectrum& value) override {
        row(field, field.colour ? "reflectance" : "spectrum", unit_text(field.range),
            range_text(field), short_number(value.max()));
    }
    void material(const Field& field, optics::Material& value) override {
        row(field, "material", unit_text(field.range),
            range_text(field) + (field.real ? ", k = 0" : ""), value.name());
    }
    void text(const Field& field, std::string&) override {
        row(field, "text", "", fmt::format("up to {} characters", field.max_size), "empty");
    }
    void choice(const Field& field, const Choices& choices, std::size_t& index) override {
        std::string range;
        for (const std::string& word : choices) range += (range.empty() ? "" : ", ") + quoted(word);
        row(field, "text", "", range, quoted(choices[index]));
    }
    void flag(const Field& field, bool& value) override {
        row(field, "flag", "", "true, false", value ? "true" : "false");
    }
    void vector(const Field& field, Vec3f& value) override {
        row(field, "3 numbers", unit_text(field.range), range_text(field),
            fmt::format("[{}, {}, {}]", value.x, value.y, value.z));
    }
    void path(const Field& field, std::filesystem::path&) override {
        row(field, "path", "", fmt::format("up to {} characters", field.max_size), "none");
    }
    void named(const Field& field, NamedList&) override {
        row(field, "tables with names", "", fmt::format("up to {}", field.max_size), "none");
    }
    bool visits_held() const override { return false; }
    void list(const Field& field, List&) override {
        row(field, "tables", "", fmt::format("up to {}", field.max_size), "none");
    }
    void preset(const Field& field) override {
        row(field, "text", "", fmt::format("up to {} characters", field.max_size), "none");
    }
    void other(const Field& field) override { row(field, "table", "", "", "none"); }

    std::string rows =
        "| key | type | unit | range | default | meaning |\n"
        "| --- | --- | --- | --- | --- | --- |\n";

 private:
    static std::string quoted(const std::string& word) { return "`\"" + word + "\"`"; }

    static std::string range_text(const Field& field) {
        return (field.zero ? "0 or " : "") + short_text(field.range) +
               (field.also ? fmt::format(", {}", field.also) : "");
    }

    void row(const Field& field, const char* type, const std::string& unit,
             const std::string& range, std::string otherwise) {
        if (!seen_.insert(field.key).second) return;
        if (field.required) otherwise.clear();
        if (field.otherwise) otherwise = field.otherwise;
        rows += fmt::format("| `{}` |", field.key);
        for (const std::string& cell :
             {std::string(type), unit, range, otherwise, std::string(field.meaning)}) {
            rows += cell.empty() ? " |" : " " + cell + " |";
        }
        rows += '\n';
    }

    std::set<std::string> seen_;
};

}  // namespace

std::string markdown_table(const Described& object) {
    MarkdownRows rows;
    object.accept(rows);
    return rows.rows;
}

}  // namespace nacre::paint
