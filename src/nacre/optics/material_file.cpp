#include "nacre/optics/material_file.h"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/core/csv.h"
#include "nacre/core/error.h"
#include "nacre/core/text.h"
#include "nacre/optics/dispersion_formula.h"

namespace nacre::optics {

// Messages give lines and numbers, but quote no text: a recipe may name any file, one that is no
// material and that the reader of the message may not be allowed to see among them.

/// A real function of wavelength, linear between its samples. Wavelengths increase.
struct SampledFunction {
    std::vector<double> wavelengths_nm, values;

    /// Needs at least two samples; beyond the first and last it goes on in a straight line.
    double at(double wavelength_nm) const;
};

/// Samples f on [first_nm, last_nm] so finely that linear interpolation errs by less than `error`,
/// by halving intervals; f is taken to be smooth on the scale of a 64th of the range.
/// @throws DomainError if that takes more than `max_values` samples; whatever f throws
SampledFunction sample_smooth(const std::function<double(double)>& f, double first_nm,
                              double last_nm, double error, std::size_t max_values);

/// Refuses YAML with anchors, aliases or deep nesting, which a page of data does not need and with
/// which a small file can expand without limit. It reads the parser's events, before any tree is
/// built.
/// @param name  of the file in messages
/// @throws InputError naming file and line; YAML::Exception where the text is not YAML
void require_plain_yaml(std::string_view text, const std::string& name);

double SampledFunction::at(double wavelength_nm) const {
    const auto above =
        std::upper_bound(wavelengths_nm.begin(), wavelengths_nm.end() - 1, wavelength_nm);
    const auto i =
        std::max<std::size_t>(1, static_cast<std::size_t>(above - wavelengths_nm.begin()));
    const double t =
        (wavelength_nm - wavelengths_nm[i - 1]) / (wavelengths_nm[i] - wavelengths_nm[i - 1]);
    return values[i - 1] * (1 - t) + values[i] * t;
}

SampledFunction sample_smooth(const std::function<double(double)>& f, double first_nm,
                              double last_nm, double error, std::size_t max_values) {
    // The error of a smooth function is largest in the middle of an interval; asking for a quarter
    // of it there leaves room for intervals that are not yet quite parabolic.
    const double allowed = error / 4;
    constexpr int start = 64;  // intervals, equal on a logarithmic scale
    struct Interval {
        double left_nm, right_nm, f_left, f_right;
    };
    std::vector<Interval> open;  // a stack, leftmost on top
    double right_nm = last_nm, f_right = f(last_nm);
    for (int i = start - 1; i >= 0; --i) {
        const double left_nm =
            i == 0 ? first_nm
                   : first_nm * std::pow(last_nm / first_nm, static_cast<double>(i) / start);
        if (!(left_nm < right_nm)) continue;  // a range of a few units in the last place
        const double f_left = f(left_nm);
        open.push_back({left_nm, right_nm, f_left, f_right});
        right_nm = left_nm;
        f_right = f_left;
    }
    SampledFunction result{{first_nm}, {f_right}};
    while (!open.empty()) {
        const Interval interval = open.back();
        open.pop_back();
        const double middle_nm = (interval.left_nm + interval.right_nm) / 2;
        const double f_middle = f(middle_nm);
        const bool divisible = middle_nm > interval.left_nm && middle_nm < interval.right_nm;
        if (divisible && std::abs(f_middle - (interval.f_left + interval.f_right) / 2) > allowed) {
            if (open.size() + result.values.size() > max_values) {
                throw DomainError(fmt::format(
                    "the function changes so fast near {} nm that {} samples do not follow it; is "
                    "there a pole in the range?",
                    middle_nm, max_values));
            }
            open.push_back({middle_nm, interval.right_nm, f_middle, interval.f_right});
            open.push_back({interval.left_nm, middle_nm, interval.f_left, f_middle});
        } else {
            result.wavelengths_nm.push_back(interval.right_nm);
            result.values.push_back(interval.f_right);
        }
    }
    return result;
}

namespace {

class PlainPageCheck : public YAML::EventHandler {
 public:
    explicit PlainPageCheck(const std::string& name) : name_(name) {}

    void OnDocumentStart(const YAML::Mark&) override {}
    void OnDocumentEnd() override {}
    void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override { refuse(mark, anchor); }
    void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override { refuse(mark, 1); }
    void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                  const std::string&) override {
        refuse(mark, anchor);
    }
    void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                         YAML::EmitterStyle::value) override {
        open(mark, anchor);
    }
    void OnSequenceEnd() override { --depth_; }
    void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                    YAML::EmitterStyle::value) override {
        open(mark, anchor);
    }
    void OnMapEnd() override { --depth_; }

 private:
    static constexpr int kDeepest = 16;

    void refuse(const YAML::Mark& mark, YAML::anchor_t anchor) const {
        if (anchor != 0) {
            throw InputError(fmt::format("{}:{}: anchors and aliases (& and *) are not allowed",
                                         name_, mark.line + 1));
        }
    }
    void open(const YAML::Mark& mark, YAML::anchor_t anchor) {
        refuse(mark, anchor);
        if (++depth_ > kDeepest) {
            throw InputError(
                fmt::format("{}:{}: nested more than {} deep", name_, mark.line + 1, kDeepest));
        }
    }

    const std::string& name_;
    int depth_ = 0;
};

}  // namespace

void require_plain_yaml(std::string_view text, const std::string& name) {
    std::istringstream stream{std::string(text)};
    PlainPageCheck check(name);
    YAML::Parser(stream).HandleNextDocument(check);
}

namespace {

constexpr std::string_view kSourceMark = "source:";

double require_number(CsvNumbers& numbers, const CsvCell& cell, const char* column,
                      const std::string& place) {
    const auto value = numbers.parse(cell);
    if (!value) {
        throw InputError(
            fmt::format("{}: {} is not a finite number{}", place, column, numbers.advice(cell)));
    }
    return *value;
}

}  // namespace

Material parse_material_csv(std::string_view text, const std::string& name) {
    std::string source;
    std::vector<std::string_view> lines = split(without_byte_order_mark(text), '\n');
    for (std::string_view& line : lines) {
        line = trimmed(line);
        if (!line.starts_with('#')) continue;
        const auto comment = trimmed(line.substr(1));
        if (comment.starts_with(kSourceMark)) source = trimmed(comment.substr(kSourceMark.size()));
    }

    std::vector<double> wavelengths_nm;
    std::vector<ComplexIndex> index;
    std::size_t columns = 0;
    const char separator = csv_separator(first_csv_line(text));
    CsvNumbers numbers(name, separator);
    for (const CsvRow& fields : parse_csv(text, name, separator)) {
        const std::string place = fmt::format("{}:{}", name, fields[0].line);
        if (columns == 0) {
            const bool with_k = fields.size() == 3 && fields[2].text == "k";
            if (!(fields[0].text == "wavelength_nm" && fields.size() >= 2 &&
                  fields[1].text == "n" && (with_k || fields.size() == 2))) {
                throw InputError(fmt::format(
                    "{}: the header must be \"wavelength_nm,n,k\" or \"wavelength_nm,n\"", place));
            }
            columns = fields.size();
            continue;
        }
        if (fields.size() != columns) {
            throw InputError(fmt::format("{}: has {} fields; the header has {}{}", place,
                                         fields.size(), columns, numbers.advice(fields, columns)));
        }
        const double wavelength_nm = require_number(numbers, fields[0], "wavelength_nm", place);
        const double n = require_number(numbers, fields[1], "n", place);
        const double k = columns == 3 ? require_number(numbers, fields[2], "k", place) : 0.0;
        if (!(wavelength_nm > (wavelengths_nm.empty() ? 0.0 : wavelengths_nm.back()))) {
            throw InputError(fmt::format(
                "{}: wavelength_nm = {} is not above {}; wavelengths are positive and increase",
                place, wavelength_nm, wavelengths_nm.empty() ? 0.0 : wavelengths_nm.back()));
        }
        if (!kRefractiveIndexRange.contains(n)) {
            throw InputError(
                fmt::format("{}: n = {} is outside {}", place, n, kRefractiveIndexRange.text()));
        }
        if (!kExtinctionRange.contains(k)) {
            throw InputError(
                fmt::format("{}: k = {} is outside {}", place, k, kExtinctionRange.text()));
        }
        wavelengths_nm.push_back(wavelength_nm);
        index.emplace_back(n, k);
    }
    if (index.empty()) {
        throw InputError(
            fmt::format("{}: no row of data after the header \"wavelength_nm,n,k\"", name));
    }
    if (index.size() == 1) return Material(name, index.front(), source);
    return Material(name, std::move(wavelengths_nm), std::move(index), source);
}

namespace {

constexpr double kNanometresPerMicrometre = 1e3;
constexpr std::size_t kMaxSamples = 100000;

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
                 fmt::format("type must be \"tabulated nk\", \"tabulated n\", \"tabulated k\" or "
                             "\"formula 1\" to \"formula {}\"",
                             kDispersionFormulas));
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
        for (const auto field : words(text)) {
            const auto value = parse_number(field);
            if (!value) {
                fail(line, fmt::format("{}: holds what is not a finite number", key));
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
        for (auto row : split(data.Scalar(), '\n')) {
            row = trimmed(row);
            ++line;
            if (row.empty()) continue;
            const auto values = numbers(row, "data", line);
            if (values.size() != columns.size() + 1) {
                fail(line, fmt::format("{} numbers; wavelength in um and {} are expected",
                                       values.size(), columns.size() == 2 ? "n, k" : "one value"));
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
        if (!(range[0] > 0 && range[0] < range[1] && range[1] <= kMaxWavelength_um)) {
            fail(line, fmt::format("{} = {} {} um must increase and lie in (0, {}]", range_key,
                                   range[0], range[1], kMaxWavelength_um));
        }
        const auto coefficients = numbers(list.Scalar(), "coefficients", list.Mark().line + 1);
        if (coefficients.empty() || coefficients.size() > kMaxDispersionCoefficients) {
            fail(list, fmt::format("coefficients holds {} numbers instead of 1 to {}",
                                   coefficients.size(), kMaxDispersionCoefficients));
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
                               kMaxSamples);
        } catch (const DomainError& error) {
            fail(list, error.what());
        }
    }

    static constexpr double kMaxWavelength_um = 1e6;

    const std::string& name_;
    std::optional<SampledFunction> n_, k_;
};

}  // namespace

Material parse_material_yaml(std::string_view text, const std::string& name) {
    if (text.size() > kMaxMaterialFileBytes) {
        throw InputError(fmt::format("{}: larger than {} bytes, the most that a material may have",
                                     name, kMaxMaterialFileBytes));
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
