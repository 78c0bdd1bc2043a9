#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
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
            model.set_specimen(std::stoull(value));
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
        try {
            set_option(model, *option, value);
        } catch (const SettingError&) {
            throw;
        } catch (const DomainError& error) {
            throw SettingError(error.what());
        }
    }
    return model;
}

spectra::Illuminant illuminant(const std::string& name) {
    return named_setting("illuminant", name, spectra::parse_illuminant);
}

spectra::Observer observer(const std::string& name) {
    return named_setting("observer", name, spectra::parse_observer);
}

}  // namespace nacre::python
