#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/core/vec.h"
#include "nacre/optics/material.h"
#include "nacre/spectra/spectrum.h"

// One description of the keys of a file. For each struct T that a file states, a function
//
//   void describe(Visitor& visit, T& object);
//
// names its keys in order, each with unit, range, meaning and the place of its value. All that
// depends on the keys is a visitor: the reader and the writer of TOML (io/described_toml.h), the
// check of ranges and the tables of the documentation (below), the numbers by key
// (paint/recipe_parameter.h), the text of a data sheet. Descriptions: paint/recipe_description.h.

namespace nacre::paint {

/// One key: what holds for all values that it may have.
struct Field {
    const char* key = "";
    Range range = {};  ///< of a number, of each value of a spectrum, of the index of a
                       ///< material; its unit is the key's
    /// Of a number or a spectrum: what it begins with where somebody adds the key, as made paints have.
    std::optional<double> typical = {};
    const char* meaning = "";             ///< for the documentation, Markdown
    bool required = false;                ///< if not, its default is what a new object has
    const char* required_with = nullptr;  ///< required only beside this other key
    const char* zero = nullptr;           ///< of a number: 0 is allowed too and means this
    const char* also = nullptr;       ///< what else must hold, checked by the struct's validate()
    const char* otherwise = nullptr;  ///< for the documentation: the default in words
    const char* spread_of = nullptr;  ///< the number is the standard deviation of this other key
    /// On a data sheet, {} for the value with its unit and {%} for it in percent: "{} across". If
    /// empty, it is deliberately not told there.
    const char* phrase = nullptr;
    const char* zero_phrase = nullptr;  ///< the same of a 0 and of the first choice
    std::size_t max_size = 0;           ///< characters of a text, entries of a list
    bool colour = false;                ///< a spectrum that may be stated as [r, g, b]
    bool real = false;                  ///< a material that does not absorb
    bool in_line = false;               ///< tables: written as { key = value, ... }
    bool omit_default = false;  ///< a number or a choice: 0 and the first choice are not written
};

/// More samples than any instrument gives.
inline constexpr std::size_t kMaxSpectrumSamples = 10'000;
/// Characters of what people call something, and of a file's path.
inline constexpr std::size_t kMaxNameLength = 200, kMaxPathLength = 2000;

class Visitor;

/// An object with its description, its type erased.
class Described {
 public:
    template <class T>
    explicit Described(T& object)
        : object_(&object),
          describe_([](Visitor& visit, void* o) { describe(visit, *static_cast<T*>(o)); }) {}

    /// For visitors that change nothing.
    template <class T>
    static Described to_inspect(const T& object) {
        return Described(const_cast<T&>(object));
    }

    void accept(Visitor& visit) const { describe_(visit, object_); }

 private:
    void* object_;
    void (*describe_)(Visitor&, void*);
};

/// A list of described objects.
class List {
 public:
    virtual std::size_t size() const = 0;
    virtual Described at(std::size_t i) = 0;
    virtual Described add() = 0;
    virtual std::vector<std::string> keys() const = 0;  ///< keys_to_open() of an entry

 protected:
    ~List() = default;
};

/// Described objects with names of the user's own.
class NamedList {
 public:
    virtual void for_each(const std::function<void(const std::string& name, Described)>& act) = 0;
    virtual Described add(const std::string& name) = 0;

 protected:
    ~NamedList() = default;
};

/// Alternatives of which an object has one, each stated by keys of the same table. A file chooses
/// by the key that marks an alternative; without any mark it means the first.
struct Alternatives {
    struct One {
        const char* mark;
        const char* exclusion = "";  ///< why keys of the others are refused beside this one
    };
    std::vector<One> each;
    const char* both;          ///< why two marks are refused
    std::string neither = {};  ///< why none is refused, if it is
};

using Choices = std::vector<std::string>;

/// The keys of an object's own table, in order, those of all alternatives among them.
std::vector<std::string> keys_of(const Described& object);

/// The same, or none if they are not known before its kind is read: see Visitor::kind().
std::vector<std::string> keys_to_open(const Described& object);

template <class T>
std::vector<std::string> keys_of_new() {
    T object;
    return keys_of(Described(object));
}

/// Does something with each key of an object. What it does not treat by its kind of value goes to
/// other().
class Visitor {
 public:
    // How a description states a key; the kind follows from the type of the value.
    void operator()(const Field& field, double& value) { number(field, value); }
    void operator()(const Field& field, spectra::Spectrum& value) { spectrum(field, value); }
    void operator()(const Field& field, optics::Material& value) { material(field, value); }
    void operator()(const Field& field, std::string& value) { text(field, value); }
    void operator()(const Field& field, bool& value) { flag(field, value); }
    void operator()(const Field& field, Vec3f& value) { vector(field, value); }
    void operator()(const Field& field, std::filesystem::path& value) { path(field, value); }

    /// One of several words, in the order of the enumeration.
    template <class Enum>
    void operator()(const Field& field, const Choices& choices, Enum& value) {
        const auto before = static_cast<std::size_t>(value);
        std::size_t index = before;
        choice(field, choices, index);
        if (index != before) value = static_cast<Enum>(index);
    }

    template <class T>
    void operator()(const Field& field, std::optional<T>& value) {
        if (!has(field, value.has_value())) return;
        if (!value) value.emplace();
        table(field, Described(*value));
    }

    template <class T>
    void operator()(const Field& field, std::vector<T>& values) {
        VectorList<T> entries(values);
        list(field, entries);
    }

    template <class T>
    void operator()(const Field& field, std::map<std::string, T>& values) {
        NamedMap<T> entries(values);
        named(field, entries);
    }

    /// Which alternative a table states, by a word. Its own keys are described by held().
    template <class... T>
    void operator()(const Field& field, const Choices& choices, std::variant<T...>& value) {
        std::size_t index = value.index();
        kind(field, choices, index);
        if (index != value.index()) emplace(value, index);
    }
    template <class... T>
    void held(std::variant<T...>& value) {
        if (visits_held()) std::visit([&](auto& one) { describe(*this, one); }, value);
    }

    template <class... T>
    void operator()(const Alternatives& alternatives, std::variant<T...>& value) {
        if (visits_all_alternatives()) return (visit_new<T>(), ...);
        const std::size_t index = alternative(alternatives, {keys_of_new<T>...}, value.index());
        if (index != value.index()) emplace(value, index);
        std::visit([&](auto& held) { describe(*this, held); }, value);
    }

    /// A text that names keys of the same table written down elsewhere. A writer writes them out.
    virtual void preset(const Field&) {}

    /// Alternatives of which the first are keys of the object itself and the second, if it is there,
    /// stands in place of them; it is visited here.
    /// @param first  the keys of the first
    /// @return whether the first are to be visited
    template <class T>
    bool instead(const Alternatives& alternatives, std::vector<std::string> (*first)(),
                 std::optional<T>& second) {
        if (visits_all_alternatives()) {
            visit_new<T>();
            return true;
        }
        const bool chosen =
            alternative(alternatives, {first, keys_of_new<T>}, second.has_value() ? 1 : 0) == 1;
        if (!chosen) {
            second.reset();
        } else {
            if (!second) second.emplace();
            describe(*this, *second);
        }
        return !chosen;
    }

    /// A table within that of the object; if it is not required, its keys keep their values.
    virtual void table(const Field& field, Described) { other(field); }
    /// A key of the file that is no part of the object: whoever reads the file reads it.
    virtual void beside(const Field&) {}

    virtual void number(const Field& field, double&) { other(field); }
    virtual void spectrum(const Field& field, spectra::Spectrum&) { other(field); }
    virtual void material(const Field& field, optics::Material&) { other(field); }
    virtual void text(const Field& field, std::string&) { other(field); }
    virtual void flag(const Field& field, bool&) { other(field); }
    virtual void vector(const Field& field, Vec3f&) { other(field); }
    virtual void path(const Field& field, std::filesystem::path&) { other(field); }
    virtual void choice(const Field& field, const Choices&, std::size_t&) { other(field); }
    virtual void kind(const Field& field, const Choices& choices, std::size_t& index) {
        choice(field, choices, index);
    }
    virtual void list(const Field& field, List&) { other(field); }
    virtual void named(const Field& field, NamedList&) { other(field); }
    virtual void other(const Field&) {}

    /// Whether an optional table is to be visited; it is made if the object lacks it.
    virtual bool has(const Field&, bool present) { return present; }

    /// Which alternative is to be visited; it is made if the object has another.
    /// With the alternatives come the keys of each.
    virtual std::size_t alternative(const Alternatives&,
                                    const std::vector<std::vector<std::string> (*)()>& /*keys*/,
                                    std::size_t present) {
        return present;
    }
    /// For lists of keys: all alternatives are visited, in new objects.
    virtual bool visits_all_alternatives() const { return false; }
    /// Whether the keys of the alternative that a word chose are visited.
    virtual bool visits_held() const { return true; }

 protected:
    ~Visitor() = default;

 private:
    template <class T>
    class VectorList final : public List {
     public:
        explicit VectorList(std::vector<T>& values) : values_(values) {}
        std::size_t size() const override { return values_.size(); }
        Described at(std::size_t i) override { return Described(values_[i]); }
        Described add() override { return Described(values_.emplace_back()); }
        std::vector<std::string> keys() const override {
            T object;
            return keys_to_open(Described(object));
        }

     private:
        std::vector<T>& values_;
    };

    template <class T>
    class NamedMap final : public NamedList {
     public:
        explicit NamedMap(std::map<std::string, T>& values) : values_(values) {}
        void for_each(const std::function<void(const std::string& name, Described)>& act) override {
            for (auto& [name, value] : values_) act(name, Described(value));
        }
        Described add(const std::string& name) override { return Described(values_[name]); }

     private:
        std::map<std::string, T>& values_;
    };

    template <class T>
    void visit_new() {
        T object;
        describe(*this, object);
    }

    template <class... T>
    static void emplace(std::variant<T...>& value, std::size_t index) {
        std::size_t i = 0;
        ((i++ == index ? void(value.template emplace<T>()) : void()), ...);
    }
};

/// Goes into tables and lists, and knows the path to where it is: "layer[0].flakes[1].".
class PathVisitor : public Visitor {
 public:
    void table(const Field& field, Described object) override;
    void list(const Field& field, List& list) override;
    void named(const Field& field, NamedList& list) override;

 protected:
    ~PathVisitor() = default;
    std::string path_of(const Field& field) const { return path_ + field.key; }

 private:
    void descend(const std::string& key, const Described& object);

    std::string path_;
};

/// Checks every number against its range, and sizes.
/// @throws DomainError naming the key as a file spells it, its value and the allowed range
class RangeCheck : public PathVisitor {
 public:
    void number(const Field& field, double& value) override;
    void spectrum(const Field& field, spectra::Spectrum& value) override;
    void vector(const Field& field, Vec3f& value) override;
    void list(const Field& field, List& list) override;
};

/// Whether the number is in the range of the field, or a 0 that it allows besides.
bool allows(const Field& field, double value);
/// As in "0, a smooth interface, or a number in [0.01, 1]".
std::string allowed_text(const Field& field);

/// The keys of an object as a Markdown table for the documentation.
std::string markdown_table(const Described& object);

}  // namespace nacre::paint
