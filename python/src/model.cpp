#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "bind.h"
#include "nacre/core/text.h"
#include "nacre/models/models.h"
#include "nacre/nacre.h"

namespace nacre::python {

namespace {

/// "--hot-spot" as "hot_spot".
std::string keyword(std::string_view flag) {
    std::string name(flag.substr(2));
    for (char& c : name) {
        if (c == '-') c = '_';
    }
    return name;
}

/// Which panel of the batch. @throws SettingError
std::uint64_t specimen_of(const std::string& text) {
    std::uint64_t number = 0;
    const char* const end = text.data() + text.size();
    const auto [last, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc() || last != end || number > bsdf::kMaxSpecimen) {
        throw SettingError("specimen",
                           fmt::format("must be a whole number in [0, {}]", bsdf::kMaxSpecimen),
                           text.empty() ? "\"\"" : text);
    }
    return number;
}

/// An option as Python spells it. @throws SettingError
void choose(bsdf::Model& model, const bsdf::ModelOption& option, const std::string& key,
            const std::string& value) {
    try {
        set_option(model, option, value);
    } catch (const SettingError& error) {
        throw SettingError(key, error.reason(), value);
    } catch (const DomainError& error) {
        // "--hot-spot = 2: must be on or off"
        const std::string_view message = error.what();
        const std::string start = fmt::format("{} = {}: ", option.flag, value);
        throw SettingError(
            key, std::string(message.substr(message.starts_with(start) ? start.size() : 0)), value);
    }
}

template <class Parse>
auto named_setting(const char* setting, const std::string& text, const Parse& parse) {
    try {
        return parse(text);
    } catch (const InputError& error) {
        throw SettingError(setting, error.what(), text);
    }
}

}  // namespace

bsdf::Model configured_model(const std::string& name, const ModelChoices& options) {
    const bsdf::ModelInfo* info = models::find_model(name);
    if (!info) {
        std::vector<std::string> names;
        for (const bsdf::ModelInfo* known : models::all_models()) names.emplace_back(known->name);
        throw SettingError("model",
                           fmt::format("is no model{}; there are: {}", did_you_mean(name, names),
                                       fmt::join(names, ", ")),
                           name);
    }
    bsdf::Model model = info->standard();
    for (const auto& [key, value] : options) {
        if (key == "specimen" && model.specimen()) {
            model.set_specimen(specimen_of(value));
            continue;
        }
        const bsdf::ModelOption* option = nullptr;
        std::vector<std::string> names;
        if (model.specimen()) names.emplace_back("specimen");
        for (const bsdf::ModelOption& known : info->options) {
            names.push_back(keyword(known.flag));
            if (names.back() == key) option = &known;
        }
        if (!option) {
            throw SettingError(
                key,
                fmt::format("the model {} has no such option{}; it has {}", name,
                            did_you_mean(key, names),
                            names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "))));
        }
        choose(model, *option, key, value);
    }
    return model;
}

std::map<std::string, bool> model_switches(const std::string& name) {
    std::map<std::string, bool> switches;
    const bsdf::ModelInfo* info = models::find_model(name);
    if (!info) return switches;
    for (const bsdf::ModelOption& option : info->options) {
        if (!option.names.empty() || option.range) continue;
        switches[keyword(option.flag)] = option.get(info->standard()) != 0;
    }
    return switches;
}

spectra::Illuminant illuminant(const std::string& name) {
    return named_setting("illuminant", name, spectra::parse_illuminant);
}

spectra::Observer observer(const std::string& name) {
    return named_setting("observer", name, spectra::parse_observer);
}

}  // namespace nacre::python
