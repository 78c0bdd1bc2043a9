#include "nacre/io/described_toml.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "nacre/core/error.h"
#include "nacre/io/pigment_file.h"
#include "nacre/paint/recipe_description.h"
#include "nacre/spectra/colour.h"

namespace nacre::io {

namespace {

using optics::Material;
using paint::Described;
using paint::Field;
using spectra::Spectrum;

constexpr std::size_t kMaxMaterialNameLength = 200;
constexpr std::size_t kMaxMaterialTextLength = 2000;  // of a source, or of a path

/// For a kind of value that has no form in TOML.
[[noreturn]] void refuse_kind(const Field& field) {
    throw std::logic_error(fmt::format("no TOML for the value of {}", field.key));
}

// ---------------------------------------------------------------------------------- reading

/// The path of a file that a text of the table names.
std::filesystem::path resolved(const TableReader& table, const Field& field,
                               const std::string& name) {
    try {
        return table.document().references().resolve(name);
    } catch (const InputError& error) {
        table.fail(field.key, error.what());
    }
}

Material find_named_material(const TableReader& table, const Field& field) {
    const std::string text = table.text(field.key, kMaxMaterialTextLength);
    const References& references = table.document().references();
    try {
        return optics::find_material(text, references);
    } catch (const Error& error) {
        if (references.may_quote()) table.fail(field.key, error.what());
    }
    resolved(table, field, text);  // complains of what is outside of the folder
    table.fail(field.key, "is no index, and names no material that can be read");
}

/// { name = "...", wavelengths_nm = [...], n = [...], k = [...] }: a material by its samples, or
/// without wavelengths_nm a constant.
Material read_sampled_material(const TableReader& table) {
    const std::string name = table.text_or("name", "", kMaxMaterialNameLength);
    const std::string source = table.text_or("source", "", kMaxMaterialTextLength);
    const bool constant = !table.has("wavelengths_nm");
    const std::vector<double> wavelengths =
        constant ? std::vector<double>{} : read_wavelengths(table, "wavelengths_nm");
    const std::size_t samples = constant ? 1 : wavelengths.size();
    const std::vector<double> n =
        table.numbers("n", optics::kRefractiveIndexRange, samples, samples);
    const std::vector<double> k =
        table.has("k") ? table.numbers("k", optics::kExtinctionRange, samples, samples)
                       : std::vector<double>(samples, 0.0);
    std::vector<optics::ComplexIndex> index(samples);
    for (std::size_t i = 0; i < samples; ++i) index[i] = {n[i], k[i]};
    try {
        if (constant) return Material(name, index[0], source);
        return Material(name, wavelengths, index, source);
    } catch (const DomainError& error) {
        table.fail(error.what());
    }
}

/// Settles which alternatives a table states by a word.
class KindReader final : public paint::Visitor {
 public:
    explicit KindReader(const TableReader& table) : table_(table) {}

    void kind(const Field& field, const paint::Choices& choices, std::size_t& index) override {
        index = table_.choice(field.key, choices);
        found = true;
    }
    bool has(const Field&, bool) override { return false; }
    bool visits_held() const override { return false; }

    bool found = false;

 private:
    const TableReader& table_;
};

class Reader final : public paint::Visitor {
 public:
    explicit Reader(TableReader table) : table_(std::move(table)) {}

    void number(const Field& field, double& value) override {
        if (!wanted(field)) return;
        if (!field.zero) {
            value = table_.number(field.key, field.range);
            return;
        }
        const std::string allowed = allowed_text(field);
        value = table_.number(field.key, allowed);
        if (!allows(field, value)) table_.fail(field.key, "must be " + allowed);
    }

    void spectrum(const Field& field, Spectrum& value) override {
        if (!wanted(field)) return;
        value = field.colour ? read_reflectance(table_, field.key)
                             : read_spectrum(table_, field.key, field.range);
    }

    void material(const Field& field, Material& value) override {
        if (!wanted(field)) return;
        if (table_.is_text(field.key)) {
            value = find_named_material(table_, field);
        } else if (table_.is_table(field.key)) {
            value = read_sampled_material(
                table_.table(field.key, {"name", "source", "wavelengths_nm", "n", "k"}));
        } else if (table_.has(field.key)) {
            value = Material(table_.number(field.key, field.range));
        } else {
            table_.fail(field.key, "is missing; it must be an index or a material's name");
        }
    }

    void text(const Field& field, std::string& value) override {
        value = field.required ? table_.text(field.key, field.max_size)
                               : table_.text_or(field.key, value, field.max_size);
    }

    void flag(const Field& field, bool& value) override {
        value = table_.flag_or(field.key, value);
    }

    void vector(const Field& field, Vec3f& value) override {
        if (!wanted(field)) return;
        const std::vector<double> v = table_.numbers(field.key, field.range, 3, 3);
        value = {static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
    }

    void path(const Field& field, std::filesystem::path& value) override {
        if (!wanted(field)) return;
        value = resolved(table_, field, table_.text(field.key, field.max_size));
    }

    void choice(const Field& field, const paint::Choices& choices, std::size_t& index) override {
        if (wanted(field)) index = table_.choice(field.key, choices);
    }

    bool has(const Field& field, bool) override { return table_.has(field.key); }

    void preset(const Field& field) override {
        if (!table_.has(field.key)) return;
        contents_ = with_keys_from(table_, field.key);
        table_ = table_.on(*contents_, paint::keys_of_new<paint::Pigment>());
    }

    void table(const Field& field, Described object) override {
        if (wanted(field)) read_described(table_.table(field.key, keys_to_open(object)), object);
    }

    void list(const Field& field, paint::List& list) override {
        for (const TableReader& entry : table_.tables(field.key, field.max_size, list.keys())) {
            read_described(entry, list.add());
        }
    }

    void named(const Field& field, paint::NamedList& list) override {
        const auto table = table_.table_if_present(field.key, {});
        if (!table) return;
        const std::vector<std::string> names = table->keys();
        if (names.size() > field.max_size) {
            table_.fail(field.key, fmt::format("has {} entries; at most {} are allowed",
                                               names.size(), field.max_size));
        }
        for (const std::string& name : names) {
            const Described object = list.add(name);
            read_described(table->table(name, keys_to_open(object)), object);
        }
    }

    std::size_t alternative(const paint::Alternatives& alternatives,
                            const std::vector<std::vector<std::string> (*)()>& keys,
                            std::size_t) override {
        std::optional<std::size_t> chosen;
        for (std::size_t i = 0; i < alternatives.each.size(); ++i) {
            const char* mark = alternatives.each[i].mark;
            if (!*mark || !table_.has(mark)) continue;
            if (chosen) table_.fail(mark, alternatives.both);
            chosen = i;
        }
        if (!chosen && !alternatives.neither.empty()) {
            table_.fail(alternatives.each[0].mark, alternatives.neither);
        }
        const std::size_t one = chosen.value_or(0);
        const std::vector<std::string> own = keys[one]();
        for (const auto& keys_of_one : keys) {
            for (const std::string& key : keys_of_one()) {
                const bool is_excluded = std::find(own.begin(), own.end(), key) == own.end();
                if (is_excluded && table_.has(key))
                    table_.fail(key, alternatives.each[one].exclusion);
            }
        }
        return one;
    }

    void other(const Field& field) override { refuse_kind(field); }

 private:
    /// Whether the key is there, or must be.
    bool wanted(const Field& field) const {
        return field.required || table_.has(field.key) ||
               (field.required_with && table_.has(field.required_with));
    }

    TableReader table_;
    std::shared_ptr<const toml::table> contents_;  // of table_, where a preset adds to them
};

// ---------------------------------------------------------------------------------- writing

/// Whether a recipe that only names the material, in any folder, gets this one.
bool is_shipped(const Material& material) {
    if (material.name().empty()) return false;
    try {
        for (const std::string& name : optics::material_names()) {
            if (name == material.name()) return optics::find_material(name) == material;
        }
    } catch (const Error&) {  // the shipped data cannot be found: write the samples out
    }
    return false;
}

std::string material_text(const Material& material) {
    if (!material.is_dispersive() && material == Material(material.samples()[0].real())) {
        return toml_number(material.samples()[0].real());
    }
    if (is_shipped(material)) return toml_text(material.name());
    std::vector<double> n, k;
    for (const optics::ComplexIndex& index : material.samples()) {
        n.push_back(index.real());
        k.push_back(index.imag());
    }
    std::string out = fmt::format("{{ name = {}, source = {}, ", toml_text(material.name()),
                                  toml_text(material.source()));
    if (!material.wavelengths_nm().empty()) {
        out += fmt::format("wavelengths_nm = {}, ", toml_list(material.wavelengths_nm()));
    }
    return out + fmt::format("n = {}, k = {} }}", toml_list(n), toml_list(k));
}

/// Writes keys either a line each, or as { key = value, ... }.
class Writer final : public paint::Visitor {
 public:
    /// @param path  of the table that is written, as headers name it
    explicit Writer(std::string path, bool in_line = false)
        : path_(std::move(path)), in_line_(in_line) {}

    void number(const Field& field, double& x) override {
        if (!field.omit_default || x != 0) add(field, toml_number(x));
    }
    void spectrum(const Field& field, Spectrum& s) override { add(field, toml_spectrum(s)); }
    void material(const Field& field, Material& m) override { add(field, material_text(m)); }
    void text(const Field& field, std::string& text) override { add(field, toml_text(text)); }
    void choice(const Field& field, const paint::Choices& choices, std::size_t& index) override {
        if (!field.omit_default || index != 0) add(field, toml_text(choices[index]));
    }
    void flag(const Field& field, bool& value) override { add(field, value ? "true" : "false"); }
    void vector(const Field& field, Vec3f& v) override {
        add(field, fmt::format("[{}, {}, {}]", v.x, v.y, v.z));
    }
    void path(const Field& field, std::filesystem::path& path) override {
        if (!path.empty()) add(field, toml_text(path.string()));
    }

    void table(const Field& field, Described object) override {
        if (in_line_ || field.in_line) {
            add(field, in_line_text(object));
        } else {
            add_section("\n[{}]\n", path_of(field.key), object);
        }
    }

    void list(const Field& field, paint::List& list) override {
        if (list.size() == 0) return;
        if (!in_line_ && !field.in_line) {
            for (std::size_t i = 0; i < list.size(); ++i) {
                add_section("\n[[{}]]\n", path_of(field.key), list.at(i));
            }
            return;
        }
        std::string entries = "[\n";
        for (std::size_t i = 0; i < list.size(); ++i) {
            entries += "    " + in_line_text(list.at(i)) + ",\n";
        }
        add(field, entries + "]");
    }

    void named(const Field& field, paint::NamedList& list) override {
        list.for_each([&](const std::string& name, Described object) {
            add_section("\n[{}]\n", path_of(field.key) + "." + toml_text(name), object);
        });
    }

    void other(const Field& field) override { refuse_kind(field); }

    std::string text() const { return text_ + sections_; }

 private:
    std::string path_of(const char* key) const { return path_.empty() ? key : path_ + "." + key; }

    static std::string in_line_text(const Described& object) {
        Writer writer("", true);
        object.accept(writer);
        return "{ " + writer.text_ + " }";
    }

    void add(const Field& field, const std::string& value) {
        if (in_line_ && !text_.empty()) text_ += ", ";
        text_ += fmt::format("{} = {}", field.key, value);
        if (!in_line_) text_ += '\n';
    }

    /// Tables stand below all keys of the table that they are in.
    void add_section(fmt::format_string<const std::string&> header, const std::string& path,
                     const Described& object) {
        Writer writer(path);
        object.accept(writer);
        sections_ += fmt::format(header, path) + writer.text();
    }

    std::string path_;
    bool in_line_;
    std::string text_, sections_;
};

}  // namespace

std::string toml_text(const std::string& text) {
    std::string out = "\"";
    for (char c : text) {
        if (c == '"' || c == '\\') {
            out += '\\';
            out += c;
        } else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) {
            out += fmt::format("\\u{:04x}", static_cast<unsigned char>(c));
        } else {
            out += c;
        }
    }
    return out + "\"";
}

bool is_bare_toml_key(std::string_view key) {
    return !key.empty() && std::all_of(key.begin(), key.end(), [](unsigned char c) {
        return std::isalnum(c) || c == '_' || c == '-';
    });
}

std::string toml_key(const std::string& key) {
    return is_bare_toml_key(key) ? key : toml_text(key);
}

std::string toml_number(double x) { return fmt::format("{}", x); }

std::string toml_spectrum(const Spectrum& s) {
    // A single sample at a wavelength is constant too, but another value: it is written in full.
    if (s == Spectrum(s.values()[0])) return toml_number(s.values()[0]);
    return fmt::format("{{ wavelengths_nm = {}, values = {} }}", toml_list(s.wavelengths_nm()),
                       toml_list(s.values()));
}

std::string toml_list(const std::vector<double>& values) {
    std::string out = "[";
    for (double value : values) out += (out.size() > 1 ? ", " : "") + toml_number(value);
    return out + "]";
}

void read_described(const TableReader& table, const Described& object) {
    KindReader kind(table);
    object.accept(kind);
    Reader reader(kind.found ? table.narrowed(keys_of(object)) : table);
    object.accept(reader);
}

std::string write_described(const Described& object) {
    Writer writer("");
    object.accept(writer);
    return writer.text();
}

}  // namespace nacre::io
