#include "nacre/io/file_kind.h"

#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>
#include <vector>

#include "nacre/core/csv.h"
#include "nacre/core/error.h"
#include "nacre/core/text.h"
#include "nacre/io/brdf_table_file.h"
#include "nacre/io/image.h"
#include "nacre/io/measured_brdf_file.h"
#include "nacre/io/measurement_columns.h"
#include "nacre/io/measurement_file.h"
#include "nacre/io/measurement_formats.h"
#include "nacre/io/pigment_file.h"
#include "nacre/io/solved_paint_file.h"
#include "nacre/io/toml_document.h"

namespace nacre::io {

namespace {

/// Enough of a text to tell what it is.
constexpr std::size_t kKindHeadBytes = std::size_t{1} << 16;

constexpr std::pair<FileKind, const char*> kKindWords[] = {
    {FileKind::recipe, "a recipe"},
    {FileKind::scene, "a scene"},
    {FileKind::geometry_set, "a set of geometries"},
    {FileKind::pigment, "a pigment"},
    {FileKind::solved_paint, "a solved paint"},
    {FileKind::brdf_table, "a table of a BRDF"},
    {FileKind::picture_shard, "a shard of a picture; nacre merge puts the shards together"},
    {FileKind::rgl, "a measured BRDF (RGL, .bsdf)"},
    {FileKind::merl, "a measured BRDF (MERL, .binary)"},
    {FileKind::measured_colours, "measured colours"},
    {FileKind::drawdown, "a drawdown"},
    {FileKind::material, "a file of optical constants"},
    {FileKind::spectrum, "a spectrum"},
    {FileKind::mesh, "a mesh"},
    {FileKind::picture, "a picture"},
    {FileKind::result_table, "a table that Nacre writes and does not read"},
    {FileKind::result_document, "a result (JSON) that Nacre writes and does not read"},
    {FileKind::report, "a report about a run of Nacre"},
    {FileKind::materialx, "a material for other renderers (MaterialX)"},
    {FileKind::cycles_script, "a material for Blender's Cycles (a script in Python)"},
    {FileKind::threejs_module, "a material for three.js (a module in JavaScript)"},
    {FileKind::page, "a page (HTML)"},
    {FileKind::plot, "a drawing (SVG)"},
    {FileKind::empty, "empty"},
    {FileKind::other_table, "a table (CSV) whose header is not known"},
    {FileKind::other_json, "JSON that Nacre does not know"},
    {FileKind::other_xml, "XML that is not read; export measured colours as CxF3, CSV or CGATS"},
    {FileKind::other_hdf5, "HDF5 that Nacre did not write"},
    {FileKind::other_picture, "a picture in a format that is not read; save it as EXR, HDR or PNG"},
    {FileKind::spreadsheet, "a spreadsheet or another archive; save the table in it as CSV"},
    {FileKind::document, "a document (PDF)"},
    {FileKind::other_encoding, "a text that is not UTF-8; save it as UTF-8"},
    {FileKind::binary, "binary data of no kind that is read here"},
    {FileKind::text, "a text of no kind that is read here"},
};

constexpr std::string_view kColourDifferences = "colour differences (nacre measure --versus)";
constexpr std::string_view kSparkle = "sparkle and graininess (nacre sparkle)";

/// Headers of the tables that commands write, as far as they tell, and what stands under them.
constexpr std::pair<std::string_view, std::string_view> kResultTables[] = {
    {"wavelength_nm,angle_deg,polarization,R,T",
     "reflectance and transmittance of films (nacre film)"},
    {"theta_i,phi_i,theta_o,phi_o,wavelength_nm,brdf",
     "values of a BRDF (nacre eval, nacre reference)"},
    {"geometry,theta_i,aspecular_deg,L_standard", kColourDifferences},
    {"geometry,quantity,number,value,sd", "contributions to uncertainties (nacre measure)"},
    {"geometry,theta_i,Y,background_Y", kSparkle},
    {"geometry,quantity,standard,standard_se", "differences of sparkle (nacre sparkle --versus)"},
    {"name,from_nm,to_nm,n_550", "the materials that ship (nacre materials)"},
    {"name,title,kind,from_nm", "the pigments that ship (nacre pigments)"},
    {"wavelength_nm,scattering_per_mm,scattering_error",
     "coefficients of a pigment (nacre pigment)"},
};
constexpr std::string_view kAtlasColumns = ",theta_i,aspecular_deg,L,a,b,C,h,chip";
/// Other programs' tables have such a header too: the first row tells.
constexpr std::string_view kPictureDifferenceHeader = "quantity,value",
                           kPictureDifferenceRow = "mse";

/// How the files begin that exchange/ writes, a room above this one.
constexpr std::string_view kCyclesScriptStart = "\"\"\"A paint for Blender's Cycles";
constexpr std::string_view kThreejsModuleStart = "// A paint as a material of three.js";

bool starts_with_any(std::string_view text, std::initializer_list<std::string_view> starts) {
    return std::any_of(starts.begin(), starts.end(),
                       [&](std::string_view start) { return text.starts_with(start); });
}

/// What follows the line that first_csv_line() finds.
std::string_view after_first_csv_line(std::string_view text) {
    const std::string_view first = first_csv_line(text);
    if (first.empty()) return {};
    return text.substr(static_cast<std::size_t>(first.data() + first.size() - text.data()));
}

/// The header, as if commas stood between its cells.
std::string header_of(std::string_view text) {
    const std::string_view line = first_csv_line(text);
    const char separator = csv_separator(line);
    return replaced(trimmed(line), std::string_view(&separator, 1), ",");
}

std::uint32_t number_at(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 4; i-- > 0;)
        value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    return value;
}

bool is_binary_stl(std::string_view bytes) {
    constexpr std::size_t kHeader = 80, kTriangle = 50;
    return bytes.size() >= kHeader + 4 &&
           bytes.size() == kHeader + 4 + kTriangle * std::size_t{number_at(bytes, kHeader)};
}

/// Lines of OBJ's keywords, with a vertex among them.
bool is_obj(std::string_view head, bool cut) {
    constexpr std::string_view kKeywords[] = {"v", "vn", "vt", "vp", "f",      "l",
                                              "p", "o",  "g",  "s",  "mtllib", "usemtl"};
    std::vector<std::string_view> lines = split(head, '\n');
    if (cut) lines.pop_back();
    bool vertex = false;
    for (const std::string_view line : lines) {
        const std::string_view content = trimmed(line);
        if (content.empty() || content.front() == '#') continue;
        const std::string_view word = content.substr(0, content.find_first_of(" \t"));
        if (std::ranges::find(kKeywords, word) == std::end(kKeywords)) return false;
        vertex = vertex || word == "v";
        if (word == "v" && words(content).size() < 4) return false;
    }
    return vertex;
}

/// Keys that only scenes have.
bool has_scene_key(const TomlDocument& document) {
    constexpr const char* kKeys[] = {"camera", "materials", "shapes", "lights", "environment"};
    return std::ranges::any_of(kKeys,
                               [&](const char* key) { return document.root().contains(key); });
}

/// @param text  of kind_of_bytes() `text`
/// @return null if it is not TOML; its reader says why
std::shared_ptr<TomlDocument> toml_of(std::string_view text, const std::string& name,
                                      const References& references) {
    try {
        return std::make_shared<TomlDocument>(text, name, references, FileKind::text);
    } catch (const InputError&) {
        return nullptr;
    }
}

FileKind kind_of_toml(const TomlDocument* document) {
    if (document == nullptr) return FileKind::recipe;
    if (has_scene_key(*document)) return FileKind::scene;
    if (document->root().contains("geometry")) return FileKind::geometry_set;
    return looks_like_pigment(*document) ? FileKind::pigment : FileKind::recipe;
}

/// What the outermost object of a text in JSON says of itself, up to where the text ends or is wrong.
struct JsonOutline {
    std::set<std::string> keys;
    std::string format;  ///< value of the key "format"; empty: there is none
};

JsonOutline json_outline(std::string_view text) {
    using nlohmann::json;
    using Event = json::parse_event_t;
    JsonOutline outline;
    std::string key;
    const auto keep = [&](int depth, Event event, json& parsed) {
        if (depth == 1 && event == Event::key) {
            key = parsed.get<std::string>();
            outline.keys.insert(key);
        } else if (depth == 1 && event == Event::value && key == "format" && parsed.is_string()) {
            outline.format = parsed.get<std::string>();
        }
        return depth == 0;  // nothing is kept of what may be large or nested deep
    };
    constexpr bool kThrow = false;
    [[maybe_unused]] const json kept = json::parse(text, keep, kThrow);
    return outline;
}

/// @param text  all of it: what tells may stand behind long lists
FileKind kind_of_json(std::string_view text) {
    const JsonOutline outline = json_outline(text);
    const auto has = [&](const char* key) { return outline.keys.contains(key); };
    if (outline.format == kMeasurementFormat) return FileKind::measured_colours;
    if (has("command") && has("version")) return FileKind::report;
    if (outline.format == kDifferenceFormat || outline.format == kSparkleFormat) {
        return FileKind::result_document;
    }
    return has("asset") || has("meshes") ? FileKind::mesh : FileKind::other_json;
}

FileKind kind_of_xml(std::string_view head) {
    const std::string small = lowercase(head);
    const auto has = [&](std::string_view text) { return small.find(text) != std::string::npos; };
    if (has("<materialx")) return FileKind::materialx;
    if (has("<html") || has("<!doctype html")) return FileKind::page;
    if (has("<svg")) return FileKind::plot;
    return looks_like_cxf(head) ? FileKind::measured_colours : FileKind::other_xml;
}

/// Whether the first two rows of a text have cells, so that it is no TOML gone wrong.
bool is_other_table(std::string_view head) {
    const std::string_view first = first_csv_line(head);
    if (first.empty() || is_toml_line(first)) return false;
    const char separator = csv_separator(first);
    const std::string_view second = first_csv_line(after_first_csv_line(head));
    return first.find(separator) != std::string_view::npos &&
           (second.empty() || second.find(separator) != std::string_view::npos);
}

FileKind kind_of_table(std::string_view head) {
    const std::string header = header_of(head);
    const auto columns = split(header, ',');
    if (!result_of(head).empty()) return FileKind::result_table;
    if (header == "wavelength_nm,n" || header == "wavelength_nm,n,k") return FileKind::material;
    if (columns.size() == 2 && lowercase(trimmed(columns[0])) == "wavelength_nm") {
        return FileKind::spectrum;
    }
    const std::string small = lowercase(header);
    if (small.find("ground") != std::string::npos &&
        small.find("thickness_um") != std::string::npos) {
        return FileKind::drawdown;
    }
    if (looks_like_measurement(head)) return FileKind::measured_colours;
    return is_other_table(head) ? FileKind::other_table : FileKind::text;
}

FileKind kind_of_text(std::string_view text, std::string_view head) {
    const bool cut = head.size() < text.size();
    const std::string_view content = trimmed(without_byte_order_mark(head));
    if (content.starts_with('{')) return kind_of_json(text);
    if (content.starts_with(kCyclesScriptStart)) return FileKind::cycles_script;
    if (content.starts_with(kThreejsModuleStart)) return FileKind::threejs_module;
    if (content.starts_with('<')) return kind_of_xml(content);
    if (content.starts_with("solid") && content.find("facet") != std::string_view::npos) {
        return FileKind::mesh;
    }
    if (is_obj(content, cut)) return FileKind::mesh;
    if (starts_with_any(content, {"DATA:", "REFERENCES:", "COMMENTS:"}) ||
        content.find("\nDATA:") != std::string_view::npos) {
        return FileKind::material;
    }
    return kind_of_table(head);
}

}  // namespace

std::string words_for(FileKind kind) {
    const auto found =
        std::ranges::find(kKindWords, kind, &std::pair<FileKind, const char*>::first);
    return found->second;
}

std::string_view result_of(std::string_view text) {
    if (trimmed(without_byte_order_mark(text)).starts_with('{')) {
        const std::string format = json_outline(text).format;
        return format == kDifferenceFormat ? kColourDifferences
               : format == kSparkleFormat  ? kSparkle
                                           : "";
    }
    const std::string header = header_of(text);
    if (header == kPictureDifferenceHeader &&
        header_of(after_first_csv_line(text)).starts_with(kPictureDifferenceRow)) {
        return "the difference of two pictures (nacre diff)";
    }
    for (const auto& [start, what] : kResultTables) {
        if (header.starts_with(start)) return what;
    }
    return header.find(',') != std::string::npos && header.ends_with(kAtlasColumns) &&
                   header.find(',') + kAtlasColumns.size() == header.size()
               ? "colours of a film or paint (nacre atlas)"
               : "";
}

FileKind kind_of_bytes(std::string_view bytes) {
    if (bytes.empty()) return FileKind::empty;
    if (looks_like_image(bytes)) return FileKind::picture;
    if (looks_like_solved_paint(bytes)) return FileKind::solved_paint;
    if (looks_like_brdf_table(bytes)) return FileKind::brdf_table;
    if (bytes.starts_with(std::string(kPictureShardName) + "\n")) return FileKind::picture_shard;
    if (looks_like_rgl(bytes)) return FileKind::rgl;
    if (looks_like_merl(bytes)) return FileKind::merl;
    if (bytes.starts_with("\x89HDF\r\n\x1a\n")) return FileKind::other_hdf5;
    if (starts_with_any(bytes, {"ply\n", "ply\r", "glTF"}) || is_binary_stl(bytes)) {
        return FileKind::mesh;
    }
    if (starts_with_any(bytes, {"PK\x03\x04", "\xD0\xCF\x11\xE0"})) return FileKind::spreadsheet;
    if (bytes.starts_with("%PDF")) return FileKind::document;
    if (starts_with_any(
            bytes, {"\xFF\xD8\xFF", std::string_view("II*\0", 4), std::string_view("MM\0*", 4)})) {
        return FileKind::other_picture;
    }
    if (looks_like_utf16(bytes)) return FileKind::other_encoding;
    const std::string_view head = bytes.substr(0, kKindHeadBytes);
    const bool cut = head.size() < bytes.size();
    if (head.find('\0') != std::string_view::npos) return FileKind::binary;
    const FileKind kind = kind_of_text(bytes, head);
    const auto odd = first_not_utf8(head);  // which may be half of a character at the end
    const bool encoded = !odd || (cut && *odd + 4 > head.size());
    return encoded || kind == FileKind::mesh ? kind : FileKind::other_encoding;
}

FileKind file_kind(std::string_view bytes) {
    const FileKind kind = kind_of_bytes(bytes);
    return kind == FileKind::text ? kind_of_toml(toml_of(bytes, "", {}).get()) : kind;
}

TypedFile typed_file(std::string bytes, std::string name, const References& references) {
    TypedFile file{std::move(name), std::move(bytes), references, FileKind::empty};
    file.kind = kind_of_bytes(file.bytes);
    if (file.kind != FileKind::text) return file;
    file.toml = toml_of(file.bytes, file.name, references);
    file.kind = kind_of_toml(file.toml.get());
    return file;
}

}  // namespace nacre::io
