#include "apps/cli/model_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <utility>

#include "apps/cli/options.h"
#include "nacre/core/error.h"
#include "nacre/core/text.h"
#include "nacre/models/traced/traced_models.h"

namespace nacre::cli {
namespace {

using bsdf::Model;
using bsdf::ModelInfo;
using bsdf::ModelOption;

/// An option and the model that has it.
struct Owned {
    const ModelInfo* model;
    const ModelOption* option;
};

/// Options in the order of the models, those of models that show single flakes last.
std::vector<Owned> all_options() {
    std::vector<Owned> options;
    for (const bool sparkle : {false, true}) {
        for (const ModelInfo* model : models::all_models()) {
            if (model->can.sparkle != sparkle) continue;
            for (const ModelOption& option : model->options) options.push_back({model, &option});
        }
    }
    return options;
}

std::string default_text(const Owned& owned) {
    return option_text(owned.model->standard(), *owned.option);
}

/// The value of an option, as set_option() takes it; its default unless it was given.
std::string value_of(const ModelOptions& options, const Owned& owned) {
    const auto given = options.values.find(std::string(owned.option->flag));
    if (given == options.values.end()) return default_text(owned);
    const ModelOption& option = *owned.option;
    const ModelOptions::Value& value = given->second;
    if (!option.names.empty()) return value.name;
    if (option.range) return fmt::format("{}", value.number);
    return value.on ? "on" : "off";
}

/// "--no-flag", which turns a switch off.
std::string negative(std::string_view flag) { return fmt::format("--no-{}", flag.substr(2)); }

void add_option(CLI::App& command, ModelOptions& options, const Owned& owned) {
    const ModelOption& option = *owned.option;
    const std::string flag(option.flag), help(option.help);
    ModelOptions::Value& value = options.values[flag];
    if (!option.names.empty()) {
        value.name = default_text(owned);
        command.add_option(flag, value.name, help)->capture_default_str();
    } else if (option.range) {
        value.number = option.get(owned.model->standard());
        command.add_option(flag, value.number, help)
            ->check(in_range(option.range->first, option.range->second))
            ->capture_default_str();
    } else {
        value.on = option.get(owned.model->standard()) != 0;
        command.add_flag(fmt::format("{},!{}", flag, negative(flag)), value.on, help);
    }
}

/// By its entry's option; empty while the command does not offer it.
std::string alternative_value(const ModelOptions& options, const bsdf::Alternative& alternative) {
    const auto found = options.values.find(std::string(alternative.flag));
    return found == options.values.end() ? std::string(alternative.usual) : found->second.name;
}

void require_owner(std::string_view flag, const ModelInfo& owner, const ModelInfo& model) {
    if (&owner != &model) {
        throw UsageError(
            fmt::format("{} belongs to --model {}, not to {}", flag, owner.name, model.name));
    }
}

/// The alternative to a model, where its option says so.
Model with_alternative(Model model, const ModelOptions& options) {
    for (const ModelInfo* traced : models::traced_models()) {
        const bsdf::Alternative& alternative = *traced->alternative;
        if (alternative.to != &model.info()) continue;
        const std::string value = alternative_value(options, alternative);
        if (value == alternative.value) return alternative.from(model);
        if (value != alternative.usual) {
            const auto [first, last] = std::minmax(alternative.usual, alternative.value);
            throw UsageError(fmt::format("{} = {}: must be one of {}, {}", alternative.flag, value,
                                         first, last));
        }
    }
    return model;
}

}  // namespace

void add_solution_options(CLI::App& command, ModelOptions& options) {
    for (const Owned& owned : all_options()) {
        if (owned.option->of_solution) add_option(command, options, owned);
    }
}

void add_model_options(CLI::App& command, ModelOptions& options) {
    command
        .add_option(
            "--model", options.model,
            fmt::format("Model of the paint: {}",
                        fmt::join(models_that([](const ModelInfo&) { return true; }), ", ")))
        ->each([&options](const std::string&) { options.model_given = true; })
        ->capture_default_str();
    const std::size_t before = command.get_options().size();
    for (const Owned& owned : all_options()) add_option(command, options, owned);
    for (const ModelInfo* model : models::traced_models()) {
        const std::string flag(model->alternative->flag);
        std::string& value = options.values[flag].name;
        value = model->alternative->usual;
        command.add_option(flag, value, std::string(model->alternative->help))
            ->capture_default_str();
    }
    command
        .add_option("--specimen", options.specimen,
                    fmt::format("{}: which panel of the batch is seen, that is which flakes there "
                                "are; in pictures also which waves an orange peel has, and where a "
                                "tinted coat is thicker; 0: the scene's, or the first",
                                fmt::join(sparkling_models(), ", ")))
        ->check(in_range(std::uint64_t{0}, bsdf::kMaxSpecimen))
        ->capture_default_str();
    const std::vector<CLI::Option*> all = command.get_options();
    for (std::size_t i = before; i < all.size(); ++i) all[i]->group("Of single models");
}

const ModelInfo& parse_model(const ModelOptions& options) {
    if (const ModelInfo* found = models::find_model(options.model)) return *found;
    const auto names = models_that([](const ModelInfo&) { return true; });
    throw UsageError(fmt::format("--model = {}: is no model{}; there are: {}", options.model,
                                 did_you_mean(options.model, names), fmt::join(names, ", ")));
}

Model parse_model_settings(const ModelOptions& options) {
    const ModelInfo& info = parse_model(options);
    std::vector<std::pair<const ModelOption*, std::string>> chosen;
    for (const Owned& owned : all_options()) {
        const std::string value = value_of(options, owned);
        if (value == default_text(owned)) continue;
        const std::string flag(owned.option->flag);
        require_owner(value == "off" ? negative(flag) : flag, *owned.model, info);
        chosen.emplace_back(owned.option, value);
    }
    for (const ModelInfo* traced : models::traced_models()) {
        const bsdf::Alternative& alternative = *traced->alternative;
        if (alternative_value(options, alternative) == alternative.usual) continue;
        require_owner(alternative.flag, *alternative.to, info);
    }
    try {
        Model model = info.standard();
        for (const auto& [option, value] : chosen) set_option(model, *option, value);
        model.set_specimen(options.specimen);
        return with_alternative(std::move(model), options);
    } catch (const DomainError& error) {
        throw UsageError(error.what());
    }
}

std::string choice_of(const ModelInfo& model) {
    return model.alternative
               ? fmt::format("{} = {}", model.alternative->flag, model.alternative->value)
               : fmt::format("--model = {}", model.name);
}

std::vector<std::string> solution_flags() {
    std::vector<std::string> flags;
    for (const Owned& owned : all_options()) {
        if (owned.option->of_solution) flags.emplace_back(owned.option->flag);
    }
    return flags;
}

void choose_by_table(ModelOptions& options) {
    if (options.model_given) return;
    for (const Owned& owned : all_options()) {
        if (!owned.option->of_solution || value_of(options, owned) == default_text(owned)) continue;
        options.model = owned.model->name;
    }
}

std::optional<Model> chosen_model(const ModelOptions& options) {
    ModelOptions without_specimen = options;
    without_specimen.specimen = 0;
    if (!choice_of_any(without_specimen)) return std::nullopt;
    return parse_model_settings(options);
}

std::optional<std::string> choice_of_any(const ModelOptions& options) {
    if (options.model_given) return "--model = " + options.model;
    for (const Owned& owned : all_options()) {
        const std::string value = value_of(options, owned);
        if (value == default_text(owned)) continue;
        const std::string flag(owned.option->flag);
        if (value == "on" || value == "off") return value == "on" ? flag : negative(flag);
        return flag + " = " + value;
    }
    for (const ModelInfo* traced : models::traced_models()) {
        const bsdf::Alternative& alternative = *traced->alternative;
        const std::string value = alternative_value(options, alternative);
        if (value != alternative.usual) return fmt::format("{} = {}", alternative.flag, value);
    }
    if (options.specimen != 0) return fmt::format("--specimen = {}", options.specimen);
    return std::nullopt;
}

std::string choice_of_table(const Model& model) {
    for (const ModelOption& option : model.info().options) {
        if (!option.of_solution) continue;
        return fmt::format("{} = {}", option.flag, option_text(model, option));
    }
    return choice_of(model.info());  // a model of nothing but tables
}

std::vector<std::string> models_that(bool (*condition)(const ModelInfo&)) {
    std::vector<std::string> names;
    for (const ModelInfo* model : models::all_models()) {
        if (condition(*model)) names.emplace_back(model->name);
    }
    return names;
}

std::vector<std::string> sparkling_models() {
    std::vector<std::string> names = models_that(
        [](const ModelInfo& model) { return model.can.sparkle && model.can.multiple_scattering; });
    for (const std::string& name : models_that([](const ModelInfo& model) {
             return model.can.sparkle && !model.can.multiple_scattering;
         })) {
        names.push_back(name);
    }
    return names;
}

std::vector<std::string> unit_square_models() {
    return models_that([](const ModelInfo& model) {
        return model.coordinates == bsdf::SurfaceCoordinates::unit_square;
    });
}

std::string by_coordinates(const std::string& in_object_space, const std::string& in_unit_square) {
    const auto object_space_models = models_that([](const ModelInfo& model) {
        return model.coordinates == bsdf::SurfaceCoordinates::object_space;
    });
    std::vector<std::string> meanings;
    for (const auto& [models, meaning] : {std::pair{object_space_models, in_object_space},
                                          std::pair{unit_square_models(), in_unit_square}}) {
        if (models.empty()) continue;
        meanings.push_back(fmt::format("{}: {}", fmt::join(models, ", "), meaning));
    }
    return fmt::format("{}", fmt::join(meanings, "; "));
}

}  // namespace nacre::cli
