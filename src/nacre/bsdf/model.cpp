#include "nacre/bsdf/model.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <vector>

#include "nacre/core/error.h"

namespace nacre::bsdf {
namespace {

void require_ingredients(const ModelInfo& model, const paint::Recipe& recipe) {
    if (model.ingredients == Ingredients::layers) {
        if (!recipe.layers.empty()) return;
        throw DomainError(fmt::format(
            "layer: is missing; the model {} needs at least one [[layer]]", model.name));
    }
    if (!recipe.microfacet) {
        throw DomainError(fmt::format(
            "microfacet: is missing; the model {} needs the table [microfacet]", model.name));
    }
    if (model.ingredients == Ingredients::facets && !recipe.microfacet->facets) {
        throw DomainError(fmt::format(
            "microfacet.facets: is missing; the model {} needs the table [microfacet.facets]",
            model.name));
    }
}

[[noreturn]] void refuse(const ModelOption& option, std::string_view text,
                         const std::string& allowed) {
    throw DomainError(fmt::format("{} = {}: must be {}", option.flag, text, allowed));
}

int parse(const ModelOption& option, std::string_view text) {
    if (!option.names.empty()) {
        const auto found = std::find(option.names.begin(), option.names.end(), text);
        if (found != option.names.end()) return static_cast<int>(found - option.names.begin());
        std::vector<std::string_view> names(option.names.begin(), option.names.end());
        std::sort(names.begin(), names.end());
        refuse(option, text, fmt::format("one of {}", fmt::join(names, ", ")));
    }
    if (option.range) {
        const auto [lo, hi] = *option.range;
        int value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error == std::errc() && end == text.data() + text.size() && value >= lo && value <= hi)
            return value;
        refuse(option, text, fmt::format("a whole number in [{}, {}]", lo, hi));
    }
    if (text == "on") return 1;
    if (text == "off") return 0;
    refuse(option, text, "on or off");
}

}  // namespace

std::shared_ptr<const Bsdf> Model::make(const ModelInput& input, const Progress& progress) const {
    const ModelInfo& model = info();
    if (input.table && model.solution != Solution::table) {
        throw DomainError(fmt::format("the model {} is not made of a table", model.name));
    }
    if (!input.table) {
        require_ingredients(model, input.recipe);
        if (model.solution != Solution::none && !input.solved) {
            throw DomainError(fmt::format("the model {} needs a solved paint", model.name));
        }
    }
    return operations_->make(settings_, input, progress);
}

std::optional<std::uint64_t> Model::specimen() const {
    if (!operations_->specimen) return std::nullopt;
    return operations_->specimen(settings_);
}

void Model::set_specimen(std::uint64_t specimen) {
    if (operations_->set_specimen) operations_->set_specimen(settings_, specimen);
}

void Model::lie_on(const std::string& material, std::span<const PaintedShape> shapes) {
    if (operations_->lie_on) operations_->lie_on(settings_, material, shapes);
}

bool Model::makes_table() const {
    return operations_->makes_table && operations_->makes_table(settings_);
}

std::optional<BrdfTable> Model::make_table(const solver::SolvedPaint& paint,
                                           const Progress& progress) const {
    if (!operations_->make_table) return std::nullopt;
    return operations_->make_table(settings_, paint, progress);
}

void Model::require_kind(const BrdfTable& table, const std::string& file) const {
    if (operations_->require_kind) operations_->require_kind(settings_, table, file);
}

std::shared_ptr<const Bsdf> Model::make_mean(std::shared_ptr<const solver::SolvedPaint> paint,
                                             const Progress& progress) const {
    return operations_->make_mean(settings_, std::move(paint), progress);
}

bool Model::makes_arrays() const {
    return operations_->makes_arrays && operations_->makes_arrays(settings_);
}

std::shared_ptr<NacreArrays> Model::make_arrays(
    const std::shared_ptr<const solver::SolvedPaint>& paint, ArrayParts parts,
    const Progress& progress) const {
    return operations_->make_arrays(settings_, paint, parts, progress);
}

bool Model::shows_hot_spot() const {
    return operations_->shows_hot_spot && operations_->shows_hot_spot(settings_);
}

std::string Model::text() const {
    return fmt::format("{} {}", info().name, operations_->text(settings_));
}

std::string option_text(const Model& model, const ModelOption& option) {
    const int value = option.get(model);
    if (!option.names.empty()) return std::string(option.names[static_cast<std::size_t>(value)]);
    if (option.range) return fmt::format("{}", value);
    return value ? "on" : "off";
}

void set_option(Model& model, const ModelOption& option, std::string_view text) {
    option.set(model, parse(option, text));
}

}  // namespace nacre::bsdf
