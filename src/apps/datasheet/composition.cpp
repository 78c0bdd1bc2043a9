#include "apps/datasheet/composition.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <utility>

#include "apps/report/plot_frame.h"
#include "nacre/core/text.h"
#include "nacre/paint/orientation.h"
#include "nacre/paint/recipe_description.h"

namespace nacre::datasheet {

namespace {

using paint::Field;

std::string number_text(double value) {
    const double size = std::abs(value);
    return size >= 1e4 || (size > 0 && size < 1e-3) ? report::tick_text(value, size / 1000)
                                                    : fmt::format("{:.4g}", value);
}

/// A unit as it stands behind a number: " µm", " /mm", "°".
std::string unit_text(std::string_view unit) {
    if (unit.empty()) return {};
    if (unit == "deg") return "°";
    if (unit.starts_with("1/")) unit.remove_prefix(1);
    std::string text = " " + std::string(unit);
    if (unit.ends_with("um")) text.replace(text.size() - 2, 1, "µ");
    return text;
}

/// What the keys of an object say, in their order and in the phrases of their description. Tables and
/// lists that have a phrase are told with what they hold, others are left to the caller.
class Phrases final : public paint::Visitor {
 public:
    explicit Phrases(const paint::Described& object) { object.accept(*this); }
    template <class T>
    explicit Phrases(const T& object) : Phrases(paint::Described::to_inspect(object)) {}

    /// What some keys say, in the order asked for; rest() does not say it again.
    std::string take(std::initializer_list<std::string_view> keys, const char* joint = ", ") {
        std::vector<std::string> texts;
        for (const std::string_view key : keys) {
            const auto is_it = [&](const Phrase& p) { return p.key == key; };
            for (const Phrase& p : phrases_) {
                if (is_it(p)) texts.push_back(p.text);
            }
            std::erase_if(phrases_, is_it);
        }
        return fmt::format("{}", fmt::join(texts, joint));
    }

    std::string rest(const char* joint = ", ") const {
        std::vector<std::string> texts;
        for (const Phrase& p : phrases_) texts.push_back(p.text);
        return fmt::format("{}", fmt::join(texts, joint));
    }

    void number(const Field& field, double& value) override {
        if (!field.spread_of) {
            say(field, value == 0, number_text(scale(field) * value));
            return;
        }
        if (value == 0) return;
        for (Phrase& p : phrases_) {
            if (p.key == field.spread_of) p.text.insert(p.value_end, " ± " + number_text(value));
        }
    }
    void spectrum(const Field& field, spectra::Spectrum& value) override {
        const double lo = value.min(), hi = value.max();
        std::string text = number_text(scale(field) * hi);
        if (lo != hi) text = number_text(scale(field) * lo) + " to " + text;
        say(field, hi == 0, text);
    }
    void material(const Field& field, optics::Material& value) override {
        say(field, false, material_text(value));
    }
    void choice(const Field& field, const paint::Choices& choices, std::size_t& index) override {
        say(field, index == 0, choices[index]);
    }
    void table(const Field& field, paint::Described object) override {
        if (field.phrase) say(field, false, Phrases(object).rest());
    }
    void list(const Field& field, paint::List& list) override {
        if (!field.phrase || list.size() == 0) return;
        std::vector<std::string> texts;
        for (std::size_t i = 0; i < list.size(); ++i) texts.push_back(Phrases(list.at(i)).rest());
        say(field, false, fmt::format("{}", fmt::join(texts, "; then ")));
    }

 private:
    struct Phrase {
        std::string key, text;
        std::size_t value_end;
    };

    static bool in_percent(const Field& field) {
        return field.phrase && std::string_view(field.phrase).find("{%}") != std::string_view::npos;
    }
    static double scale(const Field& field) { return in_percent(field) ? 100 : 1; }

    void say(const Field& field, bool zero, const std::string& value) {
        const char* phrase = zero && field.zero_phrase ? field.zero_phrase : field.phrase;
        std::string text = phrase ? phrase : "";
        if (text.empty()) return;
        const std::size_t open = std::min(text.find('{'), text.size());
        if (open < text.size()) {
            text.replace(open, text.find('}') + 1 - open,
                         value + (in_percent(field) ? " %" : unit_text(field.range.unit)));
        }
        phrases_.push_back({field.key, text, std::min(open + value.size(), text.size())});
    }

    std::vector<Phrase> phrases_;
};

/// A species of flakes.
struct FlakeWords {
    std::string name, amount, size, build;
};

FlakeWords flake_words(const paint::FlakeSpecies& flakes, const paint::Layer& layer) {
    Phrases told(flakes);
    FlakeWords words{.name = flakes.name.empty() ? "flakes" : flakes.name,
                     .amount = told.take({"volume_fraction"}),
                     .size = {},
                     .build = told.take({"core", "coats", "reflectance", "transmittance"}, "; ")};
    words.amount +=
        fmt::format("{}flakes of {:.3g} times the area painted", words.amount.empty() ? "" : ", ",
                    flakes.area_density_per_um() * layer.thickness_um);
    words.size =
        fmt::format("{}, {:.3g} µm thick, half of them within {:.2g}° of flat", told.rest(),
                    flakes.thickness_um(), paint::median_tilt_deg(flakes.orientation));
    if (flakes.orientation.alpha_bottom > 0) {
        paint::Orientation bottom = flakes.orientation;
        bottom.beckmann_alpha = bottom.alpha_bottom;
        words.size +=
            fmt::format(" at the top, {:.2g}° at the bottom", paint::median_tilt_deg(bottom));
    }
    return words;
}

/// A pigment.
struct PigmentWords {
    std::string name, amount, size, build;
};

PigmentWords pigment_words(const paint::Pigment& pigment) {
    Phrases told(pigment);
    PigmentWords words{.name = pigment.name.empty() ? "pigment" : pigment.name,
                       .amount = told.take({"volume_fraction", "mass_fraction"}),
                       .size = told.take({"diameter_nm", "weighting", "spread"}),
                       .build = {}};
    words.build = told.rest();
    return words;
}

struct ClearcoatWords {
    std::string thickness, surface, tint;
};

ClearcoatWords clearcoat_words(const paint::Clearcoat& coat) {
    Phrases told(coat);
    ClearcoatWords words{told.take({"thickness_um"}), told.take({"roughness", "orange_peel"}), {}};
    words.tint = told.rest();
    return words;
}

report::Cell cell(std::string text) { return {.text = std::move(text)}; }

}  // namespace

std::string material_text(const optics::Material& material) {
    const std::string& name = material.name();
    std::string_view rest = name;
    if (take_number(rest)) return "n = " + name;
    const auto shipped = optics::material_names();
    if (!std::binary_search(shipped.begin(), shipped.end(), name)) return name;
    static constexpr const char* kSubscripts[] = {"₀", "₁", "₂", "₃", "₄", "₅", "₆", "₇", "₈", "₉"};
    std::string words = name;
    std::replace(words.begin(), words.end(), '_', ' ');
    if (!std::isupper(static_cast<unsigned char>(name[0]))) return words;  // "synthetic mica"
    const std::size_t form = std::min(words.find(' '), words.size());
    std::string text;
    for (const char c : words.substr(0, form)) {
        const bool digit = std::isdigit(static_cast<unsigned char>(c)) != 0;
        text += digit ? std::string(kSubscripts[c - '0']) : std::string(1, c);
    }
    if (form < words.size()) text += " (" + words.substr(form + 1) + ")";
    return text;
}

std::vector<std::string> layers_in_words(const paint::Recipe& recipe) {
    std::vector<std::string> sentences;
    if (recipe.clearcoat) {
        const ClearcoatWords coat = clearcoat_words(*recipe.clearcoat);
        sentences.push_back(fmt::format("On top a clear coat of {} with a {}: {}.", coat.thickness,
                                        coat.surface, coat.tint));
    }
    for (const paint::Layer& layer : recipe.layers) {
        std::string text = fmt::format(
            "{} a layer of {}", sentences.empty() ? "On top" : "Below it", Phrases(layer).rest());
        if (layer.flakes.empty() && layer.pigments.empty()) text += " of binder alone";
        const char* joint = " with ";
        for (const paint::FlakeSpecies& flakes : layer.flakes) {
            const FlakeWords words = flake_words(flakes, layer);
            text += fmt::format("{}{} ({}), {}, {}", joint, words.name, words.build, words.size,
                                words.amount);
            joint = "; with ";
        }
        for (const paint::Pigment& pigment : layer.pigments) {
            const PigmentWords words = pigment_words(pigment);
            const bool particles = !words.size.empty(), diluted = !words.amount.empty();
            text += fmt::format("{}{} {}{}", joint, pigment.name.empty() ? "a pigment" : words.name,
                                particles ? "of "
                                : diluted ? "that undiluted "
                                          : "that ",
                                words.build);
            if (particles) text += ", " + words.size;
            if (diluted) text += ", " + words.amount;
            joint = "; with ";
        }
        sentences.push_back(text + ".");
    }
    Phrases whole(recipe);
    const std::string ground = whole.take({"substrate"});
    sentences.push_back(fmt::format("The ground {}. {}.", ground, whole.rest(". ")));
    return sentences;
}

report::Table layers_table(const paint::Recipe& recipe) {
    report::Table table{.columns = {"Layer", "Holds", "Amount", "Size and lie", "Built of"}};
    const auto add = [&](const std::string& layer, const std::string& holds,
                         const std::string& amount, const std::string& size,
                         const std::string& built) {
        table.rows.push_back({cell(layer), cell(holds), cell(amount), cell(size), cell(built)});
    };
    if (recipe.clearcoat) {
        const ClearcoatWords coat = clearcoat_words(*recipe.clearcoat);
        add("Clear coat, " + coat.thickness, coat.tint, "", coat.surface,
            "binder, " + material_text(recipe.binder));
    }
    for (std::size_t i = 0; i < recipe.layers.size(); ++i) {
        const paint::Layer& layer = recipe.layers[i];
        std::string name = fmt::format("Layer {}, {}", i + 1, Phrases(layer).rest());
        const auto named = [&] { return std::exchange(name, std::string()); };
        for (const paint::FlakeSpecies& flakes : layer.flakes) {
            const FlakeWords words = flake_words(flakes, layer);
            add(named(), words.name, words.amount, words.size, words.build);
        }
        for (const paint::Pigment& pigment : layer.pigments) {
            const PigmentWords words = pigment_words(pigment);
            add(named(), words.name, words.amount, words.size, words.build);
        }
        if (!name.empty()) add(named(), "binder alone", "", "", material_text(recipe.binder));
    }
    if (recipe.lean) add("All layers", "", "", Phrases(recipe).take({"lean"}), "");
    add("Ground", Phrases(recipe).take({"substrate"}), "", "", "");
    return table;
}

std::vector<std::string> facets_in_words(const paint::Microfacet& microfacet) {
    Phrases told(microfacet);
    const std::string facets = told.take({"distribution", "alpha"});
    const std::string film = told.take({"film_thickness_nm", "film_ior"}, " ");
    std::vector<std::string> sentences = {fmt::format(
        "A rough surface of mirror facets ({}) under {}, {}.", facets, film, told.rest())};
    if (microfacet.facets) sentences.push_back(Phrases(*microfacet.facets).rest() + ".");
    return sentences;
}

std::string correlations_in_words(const fit::Uncertainty& uncertainty) {
    constexpr std::size_t kMaxPairsNamed = 12;
    std::vector<std::string> pairs;
    for (std::size_t i = 0; i < uncertainty.numbers.size(); ++i) {
        const std::vector<double> row = uncertainty.correlation_of(i);
        for (std::size_t j = i + 1; j < row.size(); ++j) {
            if (row[j] == 0) continue;
            pairs.push_back(fmt::format("{} and {} by {:.3g}", uncertainty.numbers[i].key,
                                        uncertainty.numbers[j].key, row[j]));
        }
    }
    if (pairs.empty()) {
        return "they are taken to be independent. By angle: which share of the variance of L*, a* "
               "and "
               "b* together is whose.";
    }
    const std::size_t named = std::min(pairs.size(), kMaxPairsNamed);
    const std::size_t more = pairs.size() - named;
    pairs.resize(named);
    return fmt::format(
        "their errors are correlated: {}{}. By angle: which share of the variance of L*, a* and b* "
        "together is whose, as the covariance of what a number changes with the colour; a negative "
        "one "
        "takes away from what the others make.",
        fmt::join(pairs, ", "), more > 0 ? fmt::format(" and {} more", more) : std::string());
}

}  // namespace nacre::datasheet
