#include "nacre/io/measurement_columns.h"

#include <algorithm>
#include <initializer_list>
#include <span>
#include <utility>

#include "nacre/core/error.h"
#include "nacre/core/text.h"
#include "nacre/measure/geometry.h"

namespace nacre::io {

namespace {

/// Instruments and people put at most so many lines above a table.
constexpr std::size_t kMaxLinesAbove = 50;
constexpr std::size_t kMaxHeadingLength = 100;

/// Names of columns, in small letters and without spaces, signs and units, each with its column.
/// The first of a column is the one that messages name.
constexpr std::pair<std::string_view, std::string_view> kColumnNames[] = {
    {"geometry", "geometry"},
    {"geometrie", "geometry"},
    {"messgeometrie", "geometry"},
    {"angle", "geometry"},
    {"winkel", "geometry"},
    {"messwinkel", "geometry"},
    {"thetai", "theta_i"},
    {"thetaideg", "theta_i"},
    {"einfallswinkel", "theta_i"},
    {"aspeculardeg", "aspecular_deg"},
    {"aspecular", "aspecular_deg"},
    {"aspecularangle", "aspecular_deg"},
    {"glanzwinkel", "aspecular_deg"},
    {"differenzwinkel", "aspecular_deg"},
    {"thetao", "theta_o"},
    {"thetaodeg", "theta_o"},
    {"phi", "phi"},
    {"phideg", "phi"},
    {"l", "l"},
    {"labl", "l"},
    {"lightness", "l"},
    {"helligkeit", "l"},
    {"a", "a"},
    {"laba", "a"},
    {"b", "b"},
    {"labb", "b"},
    {"c", "c"},
    {"cab", "c"},
    {"labc", "c"},
    {"lchc", "c"},
    {"chroma", "c"},
    {"buntheit", "c"},
    {"h", "h"},
    {"hdeg", "h"},
    {"hab", "h"},
    {"labh", "h"},
    {"lchh", "h"},
    {"hue", "h"},
    {"hueangle", "h"},
    {"bunttonwinkel", "h"},
    {"farbtonwinkel", "h"},
    {"x", "x"},
    {"xyzx", "x"},
    {"y", "y"},
    {"xyzy", "y"},
    {"z", "z"},
    {"xyzz", "z"},
    {"lamphalfangledeg", "lamp_half_angle_deg"},
    {"detectorhalfangledeg", "detector_half_angle_deg"},
    {"illuminant", "illuminant"},
    {"lichtart", "illuminant"},
    {"observer", "observer"},
    {"beobachter", "observer"},
    {"normalbeobachter", "observer"},
    {"sample", "sample"},
    {"samplename", "sample"},
    {"panel", "sample"},
    {"name", "sample"},
    {"probe", "sample"},
    {"probenname", "sample"},
    {"muster", "sample"},
    {"sampleid", "sample_id"},
    {"sampleno", "sample_id"},
    {"id", "sample_id"},
    {"nr", "sample_id"},
    {"no", "sample_id"},
    {"probennummer", "sample_id"},
    {"probennr", "sample_id"},
    {"chip", "chip"},
};

/// What stands before a wavelength, the longest first.
constexpr std::string_view kBeforeWavelength[] = {
    "spectralnm", "spectrumnm", "reflectance", "spectral", "spectrum", "spec", "nm", "r", ""};

bool is_one_of(std::string_view text, std::initializer_list<std::string_view> words) {
    return std::find(words.begin(), words.end(), text) != words.end();
}

/// A heading in small letters, its signs and units put aside.
struct PlainHeading {
    std::string text;  ///< words between single spaces
    bool percent = false, factor = false;

    explicit PlainHeading(std::string_view heading) {
        text = lowercase(heading);
        for (const auto& [from, to] : {std::pair{"\u00b0", ""},  // degrees
                                       {"\u00a0", " "},          // a space that does not break
                                       {"\u2212", "-"},          // minus
                                       {"\u2013", "-"},          // a dash for it
                                       {"*", ""},
                                       {"_", " "}}) {
            text = replaced(text, from, to);
        }
        percent = text.find('%') != std::string::npos;
        text = replaced(text, "%", "");
        take_units();
        std::string joined;
        for (const std::string_view word : words(text)) {
            if (!joined.empty()) joined += ' ';
            joined += word;
        }
        text = joined;
    }

    std::string compact() const { return replaced(text, " ", ""); }

 private:
    /// Brackets around units go with them, others become spaces: "L [-15]" is at an angle.
    void take_units() {
        for (const auto& [open, close] : {std::pair{'(', ')'}, {'[', ']'}}) {
            for (std::size_t at = 0; (at = text.find(open, at)) != std::string::npos;) {
                const std::size_t end = text.find(close, at);
                if (end == std::string::npos) return;
                const std::string inside(
                    trimmed(std::string_view(text).substr(at + 1, end - at - 1)));
                const bool unit = is_one_of(inside, {"", "-", "1", "deg", "grad", "nm", "factor"});
                factor = factor || is_one_of(inside, {"1", "factor"});
                text.replace(at, end - at + 1, unit ? " " : " " + inside + " ");
            }
        }
    }
};

std::optional<double> number_with_point(std::string_view text) {
    if (const auto number = parse_number(text)) return number;
    return parse_number(replaced(text, ",", "."));
}

/// @param marked  only where the text says that it is a wavelength, by "R" or "nm"
std::optional<double> wavelength_of(std::string_view compact, bool marked) {
    const bool unit = compact.ends_with("nm");
    if (unit) compact.remove_suffix(2);
    for (const std::string_view before : kBeforeWavelength) {
        if (!compact.starts_with(before)) continue;
        const auto number = number_with_point(compact.substr(before.size()));
        if (number && (!marked || unit || !before.empty())) return number;
    }
    return std::nullopt;
}

/// Whether digits stand in one word alone: in "R400 15" the second is an angle.
bool has_one_number(std::string_view text) {
    const auto numbers = words(text);
    return std::count_if(numbers.begin(), numbers.end(), [](std::string_view word) {
               return word.find_first_of("0123456789") != std::string_view::npos;
           }) == 1;
}

std::optional<std::string> canonical(std::string_view text) {
    try {
        return measure::parse_geometry(text).name;
    } catch (const DomainError&) {
        return std::nullopt;
    }
}

/// The geometry that the rest of a heading names once a colour is taken off: "-15", "as15", "45as15".
std::optional<std::string> rest_geometry(std::string_view text) {
    constexpr std::string_view kSeparators = " :/@,;";
    while (!text.empty() && kSeparators.find(text.front()) != std::string_view::npos) {
        text.remove_prefix(1);
    }
    while (!text.empty() && kSeparators.find(text.back()) != std::string_view::npos) {
        text.remove_suffix(1);
    }
    return geometry_name_of(text);
}

/// "l -15", "-15 l", "as15 l", "lab l 45as15", "r400 45as15", "45as15 400nm".
std::optional<MeasurementHeading> at_one_angle(const PlainHeading& heading) {
    MeasurementHeading found;
    found.percent = heading.percent;
    found.factor = heading.factor;
    std::string text = heading.text;
    for (const char* space : {"lab ", "lch ", "xyz "}) {
        for (const char* colour : {"l", "a", "b", "c", "h", "x", "y", "z"}) {
            text = replaced(text, std::string(space) + colour, colour);
        }
    }
    const std::string_view whole = text;
    if (whole.size() < 2) return std::nullopt;
    constexpr std::string_view kColours = "labchxyz";
    for (const bool first : {true, false}) {
        const char letter = first ? whole.front() : whole.back();
        if (kColours.find(letter) == std::string_view::npos) continue;
        const auto geometry =
            rest_geometry(first ? whole.substr(1) : whole.substr(0, whole.size() - 1));
        if (!geometry) continue;
        found.column = letter;
        found.geometry = *geometry;
        return found;
    }
    for (std::size_t at = whole.find(' '); at != std::string_view::npos;
         at = whole.find(' ', at + 1)) {
        const std::string_view sides[] = {whole.substr(0, at), whole.substr(at + 1)};
        for (const int side : {0, 1}) {
            const auto wavelength = wavelength_of(replaced(sides[side], " ", ""), true);
            const auto geometry = rest_geometry(sides[1 - side]);
            if (!wavelength || !geometry) continue;
            found.column = "r";
            found.wavelength_nm = *wavelength;
            found.geometry = *geometry;
            return found;
        }
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::string> geometry_name_of(std::string_view text) {
    std::string plain = replaced(text, "\u2212", "-");  // minus
    plain = replaced(replaced(plain, "\u00b0", ""), " ", "");
    if (auto name = canonical(plain)) return name;
    plain = lowercase(plain);
    if (plain.starts_with("minus")) plain.replace(0, 5, "-");
    const auto aspecular_deg = number_with_point(plain);
    if (!aspecular_deg) return std::nullopt;
    try {
        return measure::in_plane(measure::kUsualLamp_deg, *aspecular_deg).name;
    } catch (const DomainError&) {
        return std::nullopt;
    }
}

std::optional<MeasurementHeading> heading_of(std::string_view text) {
    if (text.empty() || text.size() > kMaxHeadingLength) return std::nullopt;
    const PlainHeading plain(text);
    const std::string compact = plain.compact();
    MeasurementHeading found;
    found.percent = plain.percent;
    found.factor = plain.factor;
    for (const auto& [name, column] : kColumnNames) {
        if (compact != name) continue;
        found.column = column;
        return found;
    }
    const auto wavelength =
        has_one_number(plain.text) ? wavelength_of(compact, false) : std::nullopt;
    if (wavelength) {
        found.column = "r";
        found.wavelength_nm = *wavelength;
        return found;
    }
    return at_one_angle(plain);
}

std::optional<double> wavelength_of_heading(std::string_view text) {
    const auto heading = heading_of(text);
    if (!heading || heading->column != "r" || !heading->geometry.empty()) return std::nullopt;
    return heading->wavelength_nm;
}

bool is_measurement_header(const CsvRow& row) {
    constexpr std::size_t kSpectrum = 4;
    std::size_t geometries = 0, by_angle = 0, lab = 0, wavelengths = 0;
    for (const CsvCell& cell : std::span(row).first(std::min(row.size(), kMaxMeasuredColumns))) {
        if (is_one_of(lowercase(cell.text), {"ground", "thickness_um"})) return false;
        const auto heading = heading_of(cell.text);
        if (!heading) continue;
        const std::string& column = heading->column;
        if (!heading->geometry.empty()) {
            ++by_angle;
        } else if (is_one_of(column, {"geometry", "aspecular_deg", "theta_i"})) {
            ++geometries;
        } else if (is_one_of(column, {"l", "a", "b"})) {
            ++lab;
        } else if (column == "r") {
            ++wavelengths;
        }
    }
    return geometries > 0 || by_angle >= 3 || lab == 3 || wavelengths >= kSpectrum;
}

std::vector<std::string> known_headings() {
    return {"geometry (45as15, as15 or 15; also Winkel)",
            "theta_i and aspecular_deg",
            "L, a, b (also Helligkeit)",
            "L, C, h",
            "X, Y, Z",
            "R400, R410, ... (also 400 nm, R400 [%])",
            "L -15, a -15, b -15, ... (also 45as15 L*, as15_L)",
            "sample (also Probe)",
            "illuminant, observer"};
}

bool is_toml_line(std::string_view line) {
    line = trimmed(line);
    if (line.starts_with('[')) return true;
    const std::string_view key = trimmed(line.substr(0, line.find('=')));
    return key.size() < line.size() && line.find('=') != std::string_view::npos &&
           std::all_of(key.begin(), key.end(), [](char c) {
               return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                      std::string_view("_-.\"' \t").find(c) != std::string_view::npos;
           });
}

std::optional<MeasurementHeader> find_measurement_header(std::string_view text) {
    text = without_byte_order_mark(text);
    // Lists in a recipe may look like headers.
    if (is_toml_line(first_csv_line(text))) return std::nullopt;
    std::size_t line_number = 0, candidates = 0;
    while (!text.empty() && candidates < kMaxLinesAbove) {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(text.size(), line.size() + 1));
        ++line_number;
        const std::string_view content = trimmed(line);
        if (content.empty() || content.front() == '#') continue;
        const char separator = csv_separator(line);
        try {
            const std::vector<CsvRow> row = parse_csv(line, "", separator);
            if (!row.empty() && is_measurement_header(row[0])) {
                return MeasurementHeader{line_number, separator};
            }
        } catch (const InputError&) {
            // A line above the table, or no table.
        }
        ++candidates;
    }
    return std::nullopt;
}

}  // namespace nacre::io
