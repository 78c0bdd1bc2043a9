#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <optional>
#include <pugixml.hpp>
#include <set>
#include <utility>
#include <vector>

#include "nacre/core/csv.h"
#include "nacre/core/error.h"
#include "nacre/core/text.h"
#include "nacre/io/measurement_formats.h"
#include "nacre/io/measurement_table.h"
#include "nacre/measure/geometry.h"
#include "nacre/spectra/observer.h"

namespace nacre::io {
namespace {

constexpr std::size_t kCxfHeadBytes = 4096;

/// An element's name without the prefix of its name space, which each program chooses.
std::string_view local_name(const pugi::xml_node& node) {
    const std::string_view name = node.name();
    const std::size_t colon = name.find(':');
    return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

pugi::xml_node child(const pugi::xml_node& node, std::string_view name) {
    return node.find_child([&](const pugi::xml_node& n) { return local_name(n) == name; });
}

/// The element at the end of a way down.
pugi::xml_node below(pugi::xml_node node, std::initializer_list<std::string_view> way) {
    for (const std::string_view name : way) node = child(node, name);
    return node;
}

std::string text_of(const pugi::xml_node& node) { return std::string(trimmed(node.text().get())); }

/// What a specification says of the readings that name it.
struct CxfSpecification {
    std::map<std::string, std::string> geometries;  ///< by notation
    std::string unread;                             ///< why its readings are left out, if they are
    std::optional<int> first_nm, step_nm;
    std::optional<std::string> illuminant, observer;
};

class CxfReader {
 public:
    CxfReader(std::string_view text, const std::string& filename,
              const measure::Conditions& defaults)
        : filename_(filename), conditions_(defaults) {
        const pugi::xml_parse_result result =
            document_.load_buffer(text.data(), text.size(), pugi::parse_default);
        if (!result) {
            const auto line =
                1 + std::count(
                        text.begin(),
                        text.begin() + std::min<std::ptrdiff_t>(
                                           result.offset, static_cast<std::ptrdiff_t>(text.size())),
                        '\n');
            throw InputError(fmt::format("{}:{}: is no XML: {}", filename, line,
                                         lowercase(result.description())));
        }
        resources_ = below(document_, {"CxF", "Resources"});
    }

    MeasurementFile read() {
        read_specifications();
        const pugi::xml_node objects = child(resources_, "ObjectCollection");
        int number = 0;
        for (const pugi::xml_node& object : objects.children()) {
            if (local_name(object) != "Object") continue;
            ++number;
            std::string name = object.attribute("Name").value();
            if (trimmed(name).empty()) name = object.attribute("Id").value();
            if (name.empty()) name = fmt::format("object {}", number);
            read_object(name, child(object, "ColorValues"));
        }
        if (rows_.empty()) {
            throw InputError(fmt::format(
                "{}: has no reading that is read: reflectance spectra or CIELab of objects, at "
                "one angle of illumination and one of measurement{}",
                filename_, left_out_.empty() ? "" : fmt::format(" ({})", reasons())));
        }
        if (!left_out_.empty()) notes_.push_back(filename_ + ": left out: " + reasons());
        MeasurementFile file = read_measurement_table(
            table(), filename_, {.percent = false, .light_is_noted = true}, stated_conditions());
        file.notes.insert(file.notes.begin(), notes_.begin(), notes_.end());
        return file;
    }

 private:
    struct Row {
        std::string sample, geometry;
        std::vector<std::string> values;
        std::size_t line = 0;
    };

    [[noreturn]] void fail(const std::string& object, const std::string& why) const {
        throw InputError(fmt::format("{}: object '{}': {}", filename_, excerpt(object), why));
    }
    std::string reasons() const { return fmt::format("{}", fmt::join(left_out_, "; ")); }

    void read_specifications() {
        for (const pugi::xml_node& node :
             child(resources_, "ColorSpecificationCollection").children()) {
            CxfSpecification& spec = specifications_[node.attribute("Id").value()];
            const pugi::xml_node measured = child(node, "MeasurementSpec");
            const std::string kind = text_of(child(measured, "MeasurementType"));
            if (!kind.empty() && kind.find("Reflectance") == std::string::npos) {
                spec.unread = "values of " + excerpt(kind);
            }
            const pugi::xml_node range = child(measured, "WavelengthRange");
            if (range) {
                spec.first_nm = range.attribute("StartWL").as_int();
                spec.step_nm = range.attribute("Increment").as_int();
            }
            read_geometry(child(measured, "GeometryChoice"), spec);
            const pugi::xml_node seen = child(node, "TristimulusSpec");
            if (const auto light = child(seen, "Illuminant")) spec.illuminant = text_of(light);
            if (const auto observer = child(seen, "Observer")) spec.observer = text_of(observer);
        }
    }

    void read_geometry(const pugi::xml_node& choice, CxfSpecification& spec) {
        if (const pugi::xml_node single = child(choice, "SingleAngle")) {
            const double from = child(single, "IlluminationAngle").text().as_double();
            const double to = child(single, "MeasurementAngle").text().as_double();
            // Both from the normal, the measurement on the side of the mirror direction.
            spec.geometries[""] = fmt::format("{:g}as{:g}", from, from - to);
            return;
        }
        for (const pugi::xml_node& angle : child(choice, "MultiAngle").children()) {
            if (local_name(angle) != "BRDFAngle") continue;
            const std::string notation = angle.attribute("Notation").value();
            std::string name =
                fmt::format("{:g}as{:g}", child(angle, "IlluminationAngle").text().as_double(),
                            child(angle, "Aspecular").text().as_double());
            const double azimuth = child(angle, "Azimuth").text().as_double();
            if (azimuth != 0) name += fmt::format("az{:g}", azimuth);
            spec.geometries[notation] = std::move(name);
        }
        if (spec.geometries.empty() && spec.unread.empty()) {
            const pugi::xml_node other = choice.first_child();
            spec.unread = local_name(other) == "SphereGeometry"
                              ? "readings of a sphere, which are of no single angle"
                              : "readings of no stated geometry";
        }
    }

    /// @return null, with a reason noted, if its readings are left out
    const CxfSpecification* specification(const std::string& object, const pugi::xml_node& value) {
        const std::string id = value.attribute("ColorSpecification").value();
        const auto found = specifications_.find(id);
        if (found == specifications_.end()) {
            fail(object, fmt::format("{} names the specification '{}', which the file has not",
                                     local_name(value), excerpt(id)));
        }
        if (!found->second.geometries.empty()) return &found->second;
        left_out_.insert(found->second.unread);
        return nullptr;
    }

    /// Of several angles, the one whose notation is the value's name.
    std::string geometry_of(const std::string& object, const pugi::xml_node& value,
                            const CxfSpecification& spec) const {
        if (spec.geometries.size() == 1) return spec.geometries.begin()->second;
        const std::string name = value.attribute("Name").value();
        const auto found = spec.geometries.find(name);
        if (found != spec.geometries.end()) return found->second;
        std::vector<std::string> notations;
        for (const auto& [notation, geometry] : spec.geometries) notations.push_back(notation);
        fail(object, fmt::format("{} names none of its specification's angles; its Name = '{}' "
                                 "must be one of {}",
                                 local_name(value), excerpt(name), fmt::join(notations, ", ")));
    }

    void read_object(const std::string& name, const pugi::xml_node& values) {
        const bool spectral = static_cast<bool>(child(values, "ReflectanceSpectrum"));
        for (const pugi::xml_node& value : values.children()) {
            const std::string_view kind = local_name(value);
            if (kind != (spectral ? "ReflectanceSpectrum" : "ColorCIELab")) continue;
            const CxfSpecification* spec = specification(name, value);
            if (!spec) continue;
            note_conditions(name, *spec, spectral);
            Row row{name, geometry_of(name, value, *spec), {}, rows_.size() + 1};
            if (spectral) {
                const std::vector<std::string_view> numbers = words(value.text().get());
                row.values.assign(numbers.begin(), numbers.end());
                note_wavelengths(name, value, *spec, row.values.size());
            } else {
                for (const char* key : {"L", "A", "B"}) {
                    row.values.push_back(text_of(child(value, key)));
                }
                note_columns(name, {"l", "a", "b"});
            }
            rows_.push_back(std::move(row));
        }
    }

    void note_wavelengths(const std::string& object, const pugi::xml_node& value,
                          const CxfSpecification& spec, std::size_t count) {
        const int first = value.attribute("StartWL").as_int(spec.first_nm.value_or(0));
        const int step = spec.step_nm.value_or(0);
        constexpr int kMax_nm = 10'000;
        if (first <= 0 || step <= 0 || first > kMax_nm || step > kMax_nm) {
            fail(object, "its specification states no WavelengthRange with StartWL and Increment");
        }
        if (count > static_cast<std::size_t>(kMax_nm / step)) {
            fail(object, fmt::format("has {} values {} nm apart", count, step));
        }
        std::vector<std::string> columns;
        for (std::size_t i = 0; i < count; ++i) {
            columns.push_back(fmt::format("R{}", first + static_cast<int>(i) * step));
        }
        note_columns(object, std::move(columns));
    }

    void note_columns(const std::string& object, std::vector<std::string> columns) {
        if (columns_.empty())
            columns_ = std::move(columns);
        else if (columns != columns_) {
            fail(object,
                 fmt::format("has {} values from {} on; the objects before it have {} from {} on",
                             columns.size(), columns.empty() ? "?" : columns[0], columns_.size(),
                             columns_[0]));
        }
    }

    void note_conditions(const std::string& object, const CxfSpecification& spec, bool spectral) {
        // Spectra are free of light and observer: what is stated is what their owner looks at.
        const auto agree = [&](std::optional<std::string>& known,
                               const std::optional<std::string>& stated, const char* what) {
            if (!stated) return;
            if (!known) known = stated;
            if (known != stated && !spectral) {
                fail(object, fmt::format("is for the {} {}, the objects before it for {}", what,
                                         excerpt(*stated), excerpt(*known)));
            }
        };
        agree(illuminant_, spec.illuminant, "illuminant");
        agree(observer_, spec.observer, "observer");
    }

    measure::Conditions stated_conditions() {
        measure::Conditions conditions = conditions_;
        const auto read = [&](const std::string& text, const char* what, const auto& parse) {
            try {
                return parse(text);
            } catch (const InputError& error) {
                throw InputError(fmt::format("{}: {}: {}", filename_, what, error.what()));
            }
        };
        if (illuminant_) {
            std::string name = *illuminant_;
            // CxF counts the fluorescent lamps as F2, CIE 15 as FL2.
            if (name.size() > 1 && name[0] == 'F' && name[1] != 'L') name.insert(1, "L");
            conditions.illuminant = read(name, "Illuminant", spectra::parse_illuminant);
        }
        if (observer_) {
            conditions.observer = read(*observer_, "Observer", spectra::parse_observer);
        }
        if (const auto note = note_of_light(filename_, illuminant_.has_value(),
                                            observer_.has_value(), conditions)) {
            notes_.push_back(*note);
        }
        return conditions;
    }

    std::vector<CsvRow> table() const {
        std::vector<CsvRow> rows;
        CsvRow header{{"name", 1, 1}, {"geometry", 1, 1}};
        for (const std::string& column : columns_) header.push_back({column, 1, 1});
        rows.push_back(std::move(header));
        for (const Row& row : rows_) {
            CsvRow cells{{row.sample, row.line, 1}, {row.geometry, row.line, 1}};
            for (const std::string& value : row.values) cells.push_back({value, row.line, 1});
            rows.push_back(std::move(cells));
        }
        return rows;
    }

    const std::string& filename_;
    measure::Conditions conditions_;
    pugi::xml_document document_;
    pugi::xml_node resources_;
    std::map<std::string, CxfSpecification> specifications_;
    std::vector<std::string> columns_, notes_;
    std::set<std::string> left_out_;
    std::vector<Row> rows_;
    std::optional<std::string> illuminant_, observer_;
};

}  // namespace

bool looks_like_cxf(std::string_view text) {
    text = trimmed(without_byte_order_mark(text.substr(0, kCxfHeadBytes)));
    if (!text.starts_with('<')) return false;
    for (std::size_t at = 0; (at = text.find("CxF", at)) != std::string_view::npos; ++at) {
        const char before = text[at - 1];
        const char after = at + 3 < text.size() ? text[at + 3] : ' ';
        if ((before == '<' || before == ':') &&
            (after == ' ' || after == '>' || after == '\n' || after == '\r' || after == '\t')) {
            return true;
        }
    }
    return false;
}

MeasurementFile parse_measurement_cxf(std::string_view text, const std::string& filename,
                                      const measure::Conditions& defaults) {
    require_utf8(text, filename);
    return CxfReader(without_byte_order_mark(text), filename, defaults).read();
}

}  // namespace nacre::io
