#include "nacre/paint/recipe_parameter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <variant>

#include "nacre/core/error.h"
#include "nacre/core/text.h"
#include "nacre/paint/recipe_description.h"

namespace nacre::paint {

namespace {

using optics::Material;
using spectra::Spectrum;

/// Keys that a message lists at most.
constexpr std::size_t kMaxListed = 12;

/// Where a number of a recipe is kept.
struct Slot {
    std::string key;
    Range range;
    std::variant<double*, Spectrum*, Material*> place;

    double get() const {
        if (const auto* number = std::get_if<double*>(&place)) return **number;
        if (const auto* spectrum = std::get_if<Spectrum*>(&place)) return (*spectrum)->max();
        return std::get<Material*>(place)->samples()[0].real();
    }

    void set(double value) const {
        if (const auto* number = std::get_if<double*>(&place)) {
            **number = value;
        } else if (const auto* material = std::get_if<Material*>(&place)) {
            **material = Material(value);
        } else {
            Spectrum& spectrum = *std::get<Spectrum*>(place);
            if (spectrum == Spectrum(spectrum.values()[0])) {
                spectrum = Spectrum(value);
                return;
            }
            const double largest = spectrum.max();
            if (value == largest) return;  // the other samples keep their last bits too
            std::vector<double> values = spectrum.values();
            // The largest sample itself gets the value, to the last bit.
            for (double& x : values) x = x == largest ? value : value * (x / largest);
            spectrum = Spectrum(spectrum.wavelengths_nm(), std::move(values));
        }
    }
};

/// Gathers the numbers in the order of a recipe file.
class SlotList final : public PathVisitor {
 public:
    void number(const Field& field, double& value) override {
        if (field.zero && value == 0) return;  // 0 is outside the range: it cannot be varied
        slots.push_back({path_of(field), field.range, &value});
    }

    void spectrum(const Field& field, Spectrum& value) override {
        std::string key = path_of(field);
        Range range = field.range;
        if (value != Spectrum(value.values()[0])) {
            if (!(value.max() > 0)) return;
            key += ".max";
            range.lo_open = true;  // at zero the shape of the spectrum would be lost
        }
        slots.push_back({std::move(key), range, &value});
    }

    /// Where only a real index can stand, one that is stated as a plain number is a number.
    void material(const Field& field, Material& value) override {
        if (!field.real || value.is_dispersive()) return;
        if (value == Material(value.samples()[0].real())) {
            slots.push_back({path_of(field), field.range, &value});
        }
    }

    std::vector<Slot> slots;
};

std::vector<Slot> slots_of(Recipe& recipe) {
    SlotList list;
    describe(list, recipe);
    return std::move(list.slots);
}

/// The same to look at: what the slots point to must stay as it is.
std::vector<Slot> slots_of(const Recipe& recipe) {
    SlotList list;
    Described::to_inspect(recipe).accept(list);
    return std::move(list.slots);
}

template <class Entries>
std::vector<std::string> names_of(const Entries& entries) {
    std::vector<std::string> keys;
    for (const auto& entry : entries) keys.push_back(entry.key);
    return keys;
}

std::string listed(const std::vector<std::string>& keys) {
    std::string text;
    for (std::size_t i = 0; i < keys.size() && i < kMaxListed; ++i) {
        text += (i > 0 ? ", " : "") + keys[i];
    }
    if (keys.size() > kMaxListed) {
        text += fmt::format(" and {} more", keys.size() - kMaxListed);
    }
    return text;
}

[[noreturn]] void refuse_unknown(std::string_view key, const std::vector<std::string>& keys) {
    const std::string suggestion = did_you_mean(key, keys);
    throw DomainError(
        fmt::format("{}: is not a number of this recipe{}", key,
                    suggestion.empty() ? "; its numbers are " + listed(keys) : suggestion));
}

const Slot& find(const std::vector<Slot>& slots, std::string_view key) {
    for (const Slot& slot : slots) {
        if (slot.key == key) return slot;
    }
    refuse_unknown(key, names_of(slots));
}

/// Whether the pattern, in which `*` stands for any text, describes all of `text`. Goes back only
/// to the last `*`, so that its cost is the product of the lengths at most.
bool matches(std::string_view pattern, std::string_view text) {
    std::size_t p = 0, t = 0, star = std::string_view::npos, resume = 0;
    while (t < text.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            resume = t;
        } else if (p < pattern.size() && pattern[p] == text[t]) {
            ++p;
            ++t;
        } else if (star != std::string_view::npos) {
            p = star + 1;
            t = ++resume;
        } else {
            return false;
        }
    }
    while (p < pattern.size() && pattern[p] == '*') ++p;
    return p == pattern.size();
}

bool matches_end(std::string_view pattern, const std::string& key) {
    if (matches(pattern, key)) return true;
    for (std::size_t dot = key.find('.'); dot != std::string::npos; dot = key.find('.', dot + 1)) {
        if (matches(pattern, std::string_view(key).substr(dot + 1))) return true;
    }
    return false;
}

}  // namespace

std::vector<RecipeParameter> recipe_parameters(const Recipe& recipe) {
    std::vector<RecipeParameter> parameters;
    for (const Slot& slot : slots_of(recipe)) {
        parameters.push_back({slot.key, slot.get(), slot.range});
    }
    return parameters;
}

RecipeParameter find_parameter(const Recipe& recipe, std::string_view key) {
    const std::vector<Slot> slots = slots_of(recipe);
    const Slot& slot = find(slots, key);
    return {slot.key, slot.get(), slot.range};
}

void set_parameter(Recipe& recipe, std::string_view key, double value) {
    const std::vector<Slot> slots = slots_of(recipe);
    const Slot& slot = find(slots, key);
    if (!slot.range.contains(value)) {
        throw DomainError(fmt::format("{} = {}: must be in {}{}", key, value, slot.range.text(),
                                      percent_hint(key, value, slot.range)));
    }
    slot.set(value);
}

std::vector<std::string> matching_keys(const std::vector<std::string>& keys,
                                       std::string_view pattern) {
    std::vector<std::string> found;
    for (const std::string& key : keys) {
        if (key == pattern) return {key};
        if (!pattern.empty() && matches_end(pattern, key)) found.push_back(key);
    }
    if (found.size() > 1 && pattern.find('*') == std::string_view::npos) {
        throw DomainError(
            fmt::format("{}: may mean {}; write more of the key, or *{} for all of "
                        "them",
                        pattern, listed(found), pattern));
    }
    return found;
}

std::vector<std::string> matching_parameters(const Recipe& recipe, std::string_view pattern) {
    const std::vector<std::string> keys = names_of(recipe_parameters(recipe));
    std::vector<std::string> found = matching_keys(keys, pattern);
    if (found.empty()) refuse_unknown(pattern, keys);
    return found;
}

std::string shortest_pattern(const Recipe& recipe, const std::string& key) {
    const std::vector<std::string> keys = names_of(recipe_parameters(recipe));
    for (std::size_t dot = key.rfind('.'); dot != std::string::npos && dot > 0;
         dot = key.rfind('.', dot - 1)) {
        const std::string end = key.substr(dot + 1);
        if (end == "max") continue;  // says nothing
        if (std::count_if(keys.begin(), keys.end(),
                          [&](const std::string& k) { return matches_end(end, k); }) == 1) {
            return end;
        }
    }
    return key;
}

void check_bounds(const Recipe& recipe, const ParameterBounds& bounds) {
    const RecipeParameter parameter = find_parameter(recipe, bounds.key);
    for (double end : {bounds.lo, bounds.hi}) {
        if (!parameter.range.contains(end)) {
            throw DomainError(fmt::format("{} = [{}, {}]: both ends must be in {}", bounds.key,
                                          bounds.lo, bounds.hi, parameter.range.text()));
        }
    }
    if (!(bounds.lo < bounds.hi)) {
        throw DomainError(fmt::format("{} = [{}, {}]: the first end must be below the second",
                                      bounds.key, bounds.lo, bounds.hi));
    }
    if (!(parameter.value >= bounds.lo && parameter.value <= bounds.hi)) {
        throw DomainError(fmt::format("{} = [{}, {}]: the recipe's own {} is not between them",
                                      bounds.key, bounds.lo, bounds.hi, parameter.value));
    }
}

}  // namespace nacre::paint
