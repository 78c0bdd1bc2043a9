#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

#include "nacre/core/error.h"
#include "nacre/optics/dispersion_formula.h"
#include "nacre/optics/material_file.h"
#include "nacre/optics/number_text.h"
#include "nacre/optics/sampled_function.h"
#include "nacre/optics/yaml_guard.h"

namespace nacre::optics {

namespace {

constexpr double kNanometresPerMicrometre = 1e3;
constexpr std::size_t kMostSamples = 100000;

/// One page while it is read: `n` and `k` fill as the DATA entries come.
class Page {
 public:
    explicit Page(const std::string& name) : name_(name) {}

    void read_entry(const YAML::Node& entry) {
        if (!entry.IsMap()) fail(entry, "an entry of DATA is not a mapping with a key \"type\"");
        const YAML::Node type_node = entry["type"];
        if (!type_node || !type_node.IsScalar()) fail(entry, "an entry of DATA has no \"type\"");
        const std::string type = type_node.Scalar();
        if (type == "tabulated nk") {
            read_table(entry, {&n_, &k_});
        } else if (type == "tabulated n") {
            read_table(entry, {&n_});
        } else if (type == "tabulated k") {
            read_table(entry, {&k_});
        } else if (const int number = formula_number(type); number > 0) {
            read_formula(entry, number);
        } else {
            fail(type_node,
                 fmt::format("type = \"{}\"; allowed are \"tabulated nk\", \"tabulated n\", "
                             "\"tabulated k\" and \"formula 1\" to \"formula {}\"",
                             excerpt(type), kDispersionFormulas));
        }
    }

    Material material(const std::string& source) const {
        if (!n_) throw InputError(fmt::format("{}: no entry of DATA gives n", name_));
        if (n_->values.size() == 1 && !k_) return Material(name_, n_->values.front(), source);
        for (const auto* samples : {&n_, &k_}) {
            if (*samples && (*samples)->values.size() == 1 && (n_->values.size() > 1 || k_)) {
                // A single row of n and k together is a constant; one row beside a longer table
                // would leave a range of one wavelength.
                if (n_->values.size() == 1 && k_->values.size() == 1 &&
                    n_->wavelengths_nm == k_->wavelengths_nm) {
                    return Material(name_, ComplexIndex(n_->values[0], k_->values[0]), source);
                }
                throw InputError(
                    fmt::format("{}: n and k together are known at one wavelength "
                                "only",
                                name_));
            }
        }
        const auto& n_range = n_->wavelengths_nm;
        const auto& k_range = k_ ? k_->wavelengths_nm : n_range;
        const double first = std::max(n_range.front(), k_range.front());
        const double last = std::min(n_range.back(), k_range.back());
        if (!(first < last)) {
            throw InputError(fmt::format(
                "{}: n is given from {} to {} nm and k from {} to {} nm, "
                "which do not overlap",
                name_, n_range.front(), n_range.back(), k_range.front(), k_range.back()));
        }
        std::vector<double> wavelengths_nm;
        std::merge(n_range.begin(), n_range.end(), k_range.begin(), k_range.end(),
                   std::back_inserter(wavelengths_nm));
        std::erase_if(wavelengths_nm, [&](double w) { return w < first || w > last; });
        wavelengths_nm.erase(std::unique(wavelengths_nm.begin(), wavelengths_nm.end()),
                             wavelengths_nm.end());
        std::vector<ComplexIndex> index;
        for (double w : wavelengths_nm) index.emplace_back(n_->at(w), k_ ? k_->at(w) : 0.0);
        return Material(name_, std::move(wavelengths_nm), std::move(index), source);
    }

 private:
    [[noreturn]] void fail(const YAML::Node& node, const std::string& what) const {
        fail(node.Mark().line + 1, what);
    }
    [[noreturn]] void fail(int line, const std::string& what) const {
        throw InputError(fmt::format("{}:{}: {}", name_, line, what));
    }

    /// 1 to 9 for "formula 1" to "formula 9", 0 for anything else.
    static int formula_number(std::string_view type) {
        constexpr std::string_view start = "formula ";
        if (!type.starts_with(start)) return 0;
        const auto number = parse_number(type.substr(start.size()));
        for (int i = 1; i <= kDispersionFormulas; ++i) {
            if (number == i) return i;
        }
        return 0;
    }

    YAML::Node require_scalar(const YAML::Node& entry, const char* key) const {
        const YAML::Node node = entry[key];
        if (!node || !node.IsScalar()) {
            fail(entry, fmt::format("the entry has no text under the key \"{}\"", key));
        }
        return node;
    }

    std::vector<double> numbers(std::string_view text, const char* key, int line) const {
        std::vector<double> values;
        for (const auto field : split(text, ' ')) {
            const auto value = parse_number(field);
            if (!value) {
                fail(line, fmt::format("{}: \"{}\" is not a finite number", key, excerpt(field)));
            }
            values.push_back(*value);
        }
        return values;
    }

    void check(const char* key, double value, const Range& range, int line) const {
        if (!range.contains(value)) {
            fail(line, fmt::format("{} = {} is outside {}", key, value, range.text()));
        }
    }

    void require_unset(const std::optional<SampledFunction>& samples,
                       const YAML::Node& entry) const {
        if (samples) fail(entry, &samples == &n_ ? "n is given twice" : "k is given twice");
    }

    void read_table(const YAML::Node& entry, std::vector<std::optional<SampledFunction>*> columns) {
        for (auto* column : columns) {
            require_unset(*column, entry);
            column->emplace();
        }
        const YAML::Node data = require_scalar(entry, "data");
        // A literal block starts on the line after its mark `|`.
        int line = data.Mark().line + 1;
        double last = 0;
        for (const auto row : split(data.Scalar(), '\n')) {
            ++line;
            if (row.empty()) continue;
            const auto values = numbers(row, "data", line);
            if (values.size() != columns.size() + 1) {
                fail(line, fmt::format("{} numbers in \"{}\"; wavelength in um and {} are expected",
                                       values.size(), excerpt(row),
                                       columns.size() == 2 ? "n, k" : "one value"));
            }
            const double wavelength_nm = values[0] * kNanometresPerMicrometre;
            if (!(wavelength_nm > last && std::isfinite(wavelength_nm))) {
                fail(line, fmt::format("wavelength {} um is not above {} um; wavelengths are "
                                       "positive and increase",
                                       values[0], last / kNanometresPerMicrometre));
            }
            last = wavelength_nm;
            for (std::size_t i = 0; i < columns.size(); ++i) {
                const bool is_n = columns[i] == &n_;
                check(is_n ? "n" : "k", values[i + 1],
                      is_n ? kRefractiveIndexRange : kExtinctionRange, line);
                (*columns[i])->wavelengths_nm.push_back(wavelength_nm);
                (*columns[i])->values.push_back(values[i + 1]);
            }
        }
        if ((*columns[0])->values.empty()) fail(data, "data holds no row");
    }

    void read_formula(const YAML::Node& entry, int number) {
        require_unset(n_, entry);
        // Older pages write "range" for "wavelength_range".
        const char* range_key = entry["wavelength_range"] ? "wavelength_range" : "range";
        const YAML::Node range_node = require_scalar(entry, range_key);
        const YAML::Node list = require_scalar(entry, "coefficients");
        const int line = range_node.Mark().line + 1;
        const auto range = numbers(range_node.Scalar(), range_key, line);
        if (range.size() != 2) {
            fail(line, fmt::format("{} holds {} numbers instead of 2", range_key, range.size()));
        }
        if (!(range[0] > 0 && range[0] < range[1] && range[1] <= kLongestWavelength_um)) {
            fail(line, fmt::format("{} = {} {} um must increase and lie in (0, {}]", range_key,
                                   range[0], range[1], kLongestWavelength_um));
        }
        const auto coefficients = numbers(list.Scalar(), "coefficients", list.Mark().line + 1);
        if (coefficients.empty() || coefficients.size() > kMostDispersionCoefficients) {
            fail(list, fmt::format("coefficients holds {} numbers instead of 1 to {}",
                                   coefficients.size(), kMostDispersionCoefficients));
        }
        const auto formula = [&](double wavelength_nm) {
            const double um = wavelength_nm / kNanometresPerMicrometre;
            const double n = dispersion_formula(number, coefficients, um);
            if (!kRefractiveIndexRange.contains(n)) {
                fail(list, fmt::format("formula {} gives n = {} at {} um, outside {}", number, n,
                                       um, kRefractiveIndexRange.text()));
            }
            return n;
        };
        try {
            n_ = sample_smooth(formula, range[0] * kNanometresPerMicrometre,
                               range[1] * kNanometresPerMicrometre, kFormulaSamplingError,
                               kMostSamples);
        } catch (const DomainError& error) {
            fail(list, error.what());
        }
    }

    static constexpr double kLongestWavelength_um = 1e6;

    const std::string& name_;
    std::optional<SampledFunction> n_, k_;
};

}  // namespace

Material parse_material_yaml(std::string_view text, const std::string& name) {
    if (text.size() > kLargestMaterialFile) {
        throw InputError(fmt::format("{}: larger than {} bytes, the most that a material may have",
                                     name, kLargestMaterialFile));
    }
    try {
        require_plain_yaml(text, name);
        const YAML::Node root = YAML::Load(std::string(text));
        if (!root.IsMap() || !root["DATA"] || !root["DATA"].IsSequence()) {
            throw InputError(
                fmt::format("{}: not a page of refractiveindex.info: there is no list "
                            "under the key DATA",
                            name));
        }
        Page page(name);
        for (const YAML::Node& entry : root["DATA"]) page.read_entry(entry);
        const YAML::Node references = root["REFERENCES"];
        return page.material(references && references.IsScalar()
                                 ? std::string(trimmed(references.Scalar()))
                                 : std::string());
    } catch (const YAML::Exception& error) {
        throw InputError(fmt::format("{}:{}: not valid YAML: {}", name, error.mark.line + 1,
                                     excerpt(error.msg)));
    }
}

}  // namespace nacre::optics
