#include "apps/cli/info_facts.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <span>
#include <vector>

#include "nacre/core/csv.h"
#include "nacre/core/error.h"
#include "nacre/io/drawdown_file.h"
#include "nacre/io/geometry_file.h"
#include "nacre/io/measurement_file.h"
#include "nacre/io/pigment_file.h"
#include "nacre/measure/measurement.h"
#include "nacre/nacre.h"
#include "nacre/optics/material_file.h"
#include "nacre/render/mesh_file.h"
#include "nacre/spectra/observer.h"

namespace nacre::cli {

namespace {

constexpr std::size_t kMaxListed = 20;

void add_wavelengths(Facts& facts, const std::vector<double>& nm) {
    if (nm.empty()) {
        facts.add("wavelengths", "none: colours only");
    } else {
        facts.add("wavelengths", "{} from {} to {} nm", nm.size(), nm.front(), nm.back());
    }
}

void describe_sample(Facts& facts, const std::string& title, const measure::Measurement& sample) {
    std::string readings;
    for (std::size_t i = 0; i < std::min(sample.readings.size(), kMaxListed); ++i) {
        const measure::Reading& r = sample.readings[i];
        readings += fmt::format("{}{} ({:.1f}, {:.1f}, {:.1f})", i == 0 ? "" : ", ",
                                r.geometry.name, r.lab[0], r.lab[1], r.lab[2]);
    }
    if (sample.readings.size() > kMaxListed) readings += ", ...";
    const auto flop = measure::flop_index(sample);
    facts.add(title, "{}, {} readings, L*a*b* {}{}", sample.name.empty() ? "unnamed" : sample.name,
              sample.readings.size(), readings,
              flop ? fmt::format(", flop index {:.2f}", *flop) : "");
}

void describe_drawdown(Facts& facts, std::string_view bytes, const std::string& file) {
    const measure::Drawdown drawdown = io::parse_drawdown(bytes, file);
    std::set<std::string> grounds;
    for (const measure::DrawdownReading& reading : drawdown.readings) {
        grounds.insert(reading.ground);
    }
    facts.add("grounds", "{}", fmt::join(grounds, ", "));
    add_wavelengths(facts, drawdown.wavelengths_nm);
    for (const measure::DrawdownReading& reading : drawdown.readings) {
        const auto& [low, high] =
            std::minmax_element(reading.reflectance.begin(), reading.reflectance.end());
        facts.add("reading", "over {}, {} um, {:.4g} % by volume, reflectance {:.4g} to {:.4g}",
                  reading.ground, reading.thickness_um, 100 * reading.volume_fraction, *low, *high);
    }
}

void describe_material(Facts& facts, std::string_view bytes, const std::string& file) {
    const optics::Material material = optics::parse_material(bytes, file);
    if (!material.source().empty()) facts.add("source", "{}", material.source());
    constexpr double kShown_nm = 550;
    if (!material.is_dispersive()) {
        const optics::ComplexIndex index = material.index(kShown_nm);
        facts.add("index", "{} + {}i at all wavelengths", index.real(), index.imag());
        return;
    }
    facts.add("range", "{} to {} nm", material.first_wavelength_nm(),
              material.last_wavelength_nm());
    const double shown =
        std::clamp(kShown_nm, material.first_wavelength_nm(), material.last_wavelength_nm());
    const optics::ComplexIndex index = material.index(shown);
    facts.add("index", "{:.6g} + {:.6g}i at {} nm", index.real(), index.imag(), shown);
}

void describe_geometries(Facts& facts, const io::TypedFile& file) {
    const measure::GeometrySet set = io::parse_geometry_set(file);
    facts.add("name", "{}", set.name);
    if (!set.summary.empty()) facts.add("summary", "{}", set.summary);
    for (const measure::Geometry& g : set.geometries) {
        facts.add("geometry",
                  "{} (lamp {:.6g} deg, aspecular {:.6g} deg, view theta {:.6g}, phi "
                  "{:.6g} deg)",
                  g.name, g.theta_i_deg, g.aspecular_deg, g.theta_o_deg, g.phi_deg);
    }
}

void describe_pigment(Facts& facts, const io::TypedFile& file) {
    constexpr double kVolume = 0.1;  // a file does not say how much of it there is
    const io::PigmentFile pigment = io::parse_pigment_file(file, kVolume);
    facts.add("name", "{}", pigment.pigment.name);
    if (!pigment.source.empty()) facts.add("source", "{}", pigment.source);
    const auto* particles = std::get_if<paint::PigmentParticles>(&pigment.pigment.body);
    facts.add("holds", "{}",
              particles ? "particles, whose scattering Mie's theory gives"
                        : "coefficients of scattering and absorption");
}

void describe_spectrum(Facts& facts, std::string_view bytes, const std::string& file) {
    const std::vector<CsvRow> rows = parse_csv(bytes, file);
    CsvNumbers numbers(file, csv_separator(first_csv_line(bytes)));
    std::vector<double> nm, values;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        const auto wavelength = numbers.parse(rows[i][0]);
        const auto value =
            rows[i].size() == 2 ? numbers.parse(rows[i][1]) : std::optional<double>();
        if (!wavelength || !value) {
            throw InputError(fmt::format("{}:{}: must have two numbers", file, rows[i][0].line));
        }
        nm.push_back(*wavelength);
        values.push_back(*value);
    }
    if (nm.empty()) throw InputError(file + ": has a header, but no values");
    add_wavelengths(facts, nm);
    const auto& [low, high] = std::minmax_element(values.begin(), values.end());
    facts.add("values", "{}: {:.6g} to {:.6g}", rows[0][1].text, *low, *high);
}

/// By its name, or where that says nothing by its contents.
std::string mesh_extension(std::string_view bytes, const std::filesystem::path& file) {
    const std::string extension = lowercase(file.extension().string());
    for (const char* known : {".obj", ".ply", ".stl", ".gltf", ".glb"}) {
        if (extension == known) return "";
    }
    if (bytes.starts_with("ply")) return ".ply";
    if (bytes.starts_with("glTF")) return ".glb";
    const std::string_view text = trimmed(without_byte_order_mark(bytes));
    if (text.starts_with('{')) return ".gltf";
    return text.starts_with("solid") || bytes.find('\0') != std::string_view::npos ? ".stl"
                                                                                   : ".obj";
}

void describe_mesh(Facts& facts, std::string_view bytes, const std::string& file) {
    const render::Mesh mesh =
        render::parse_mesh(bytes, render::MeshFile{.path = file + mesh_extension(bytes, file)});
    Vec3f low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
    for (const Vec3f& p : mesh.positions_mm) {
        for (int c = 0; c < 3; ++c) {
            low[c] = std::min(low[c], p[c]);
            high[c] = std::max(high[c], p[c]);
        }
    }
    facts.add("triangles", "{}, of {} vertices", mesh.triangles.size(), mesh.positions_mm.size());
    facts.add("size", "{:.6g} x {:.6g} x {:.6g} mm, as a scene reads it where it says no more",
              high.x - low.x, high.y - low.y, high.z - low.z);
    facts.add("texture coordinates", "{}", mesh.uv.empty() ? "no" : "yes");
}

void describe_result_table(Facts& facts, std::string_view bytes, const std::string& file) {
    facts.add("holds", "{}", io::result_of(bytes));
    const std::vector<CsvRow> rows = parse_csv(bytes, file);
    std::vector<std::string> columns;
    for (const CsvCell& cell : rows[0]) columns.push_back(cell.text);
    facts.add("columns", "{}", fmt::join(columns, ", "));
    facts.add("rows", "{}", rows.size() - 1);
}

/// What stands in the outermost object of a text in JSON, and how long the lists are there.
void describe_document(Facts& facts, std::string_view bytes, const std::string& file) {
    constexpr std::size_t kMaxDepth = 100;
    if (json_nesting(bytes) > kMaxDepth) {
        throw InputError(
            fmt::format("{}: lists and objects are nested deeper than {}", file, kMaxDepth));
    }
    nlohmann::json document;
    try {
        document = nlohmann::json::parse(without_byte_order_mark(bytes));
    } catch (const nlohmann::json::exception& error) {
        throw InputError(fmt::format("{}: {}", file, error.what()));
    }
    for (const auto& [key, value] : document.items()) {
        if (value.is_string()) {
            facts.add(key, "{}", excerpt(value.get<std::string>(), 200));
        } else if (value.is_number() || value.is_boolean()) {
            facts.add(key, "{}", value.dump());
        } else if (value.is_array() && value.size() > 0 && value[0].is_object()) {
            facts.add(key, "{}", value.size());
        }
    }
}

/// What stands between two texts; empty where one of them is missing.
std::string_view between(std::string_view text, std::string_view before, std::string_view after) {
    const std::size_t start = text.find(before);
    if (start == std::string_view::npos) return {};
    text.remove_prefix(start + before.size());
    const std::size_t end = text.find(after);
    return end == std::string_view::npos ? std::string_view() : text.substr(0, end);
}

/// JSON within another text; null where it is none, since somebody has changed the file.
nlohmann::json json_within(std::string_view text) {
    constexpr bool kThrow = false;
    return nlohmann::json::parse(text, nullptr, kThrow);
}

void add_text(Facts& facts, const std::string& name, const nlohmann::json& text) {
    if (text.is_string()) facts.add(name, "{}", excerpt(text.get<std::string>(), 200));
}

void describe_cycles_script(Facts& facts, std::string_view bytes) {
    add_text(facts, "name", json_within(between(bytes, "\n    \"name\": ", ",\n")));
    if (const auto maker = between(bytes, "of it, by ", ".\n"); !maker.empty()) {
        facts.add("generator", "{}", excerpt(maker));
    }
    const auto colours = between(bytes, "mean and greatest: ", " at ");
    if (!colours.empty()) {
        facts.add("colour differences from the paint", "CIEDE2000, mean and greatest {}",
                  excerpt(colours));
    }
}

void describe_threejs_module(Facts& facts, std::string_view bytes) {
    const std::string_view members = between(bytes, "\nexport const about = {", "\n};");
    const nlohmann::json about = json_within("{" + std::string(members) + "}");
    if (!about.is_object()) return;
    for (const auto& [key, name] : {std::pair{"name", "name"},
                                    {"generator", "generator"},
                                    {"recipe_sha256", "recipe SHA-256"}}) {
        if (about.contains(key)) add_text(facts, name, about[key]);
    }
    if (!about.contains("colour_differences")) return;
    const nlohmann::json& colours = about["colour_differences"];
    if (!colours.is_object()) return;
    const auto mean = colours.find("mean"), greatest = colours.find("greatest");
    if (mean == colours.end() || greatest == colours.end()) return;
    facts.add("colour differences from the paint", "CIEDE2000, mean and greatest {}, {}",
              mean->dump(), greatest->dump());
}

}  // namespace

std::vector<std::string> describe_measured_colours(Facts& facts, const io::TypedFile& file,
                                                   const std::string& sample) {
    const io::MeasurementFile colours = io::parse_measurement_file(file.bytes, file.name);
    std::size_t first = 0, last = colours.samples.size();
    if (!sample.empty()) {
        first = static_cast<std::size_t>(&io::sample_called(colours, sample, file.name) -
                                         colours.samples.data());
        last = first + 1;
    }
    const std::span samples = std::span(colours.samples).subspan(first, last - first);
    facts.add("kind", "measured colours");
    const measure::Conditions& conditions = samples[0].conditions;
    facts.add("light", "{}, {} degrees", spectra::name(conditions.illuminant),
              spectra::name(conditions.observer));
    facts.add("half angles", "lamp {} deg, detector {} deg",
              conditions.aperture.lamp_half_angle_deg, conditions.aperture.detector_half_angle_deg);
    add_wavelengths(facts, samples[0].wavelengths_nm);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        describe_sample(facts, samples.size() == 1 ? "sample" : fmt::format("sample {}", i + 1),
                        samples[i]);
    }
    for (const std::string& note : colours.notes) facts.add("note", "{}", note);
    std::vector<std::string> contradictions;
    for (std::size_t i = first; i < last; ++i) {
        contradictions.insert(contradictions.end(), colours.contradictions[i].begin(),
                              colours.contradictions[i].end());
    }
    return contradictions;
}

void describe_scene(Facts& facts, const render::SceneDescription& scene) {
    facts.add("kind", "scene");
    facts.add("name", "{}", scene.name);
    facts.add("shapes", "{}", scene.shapes.size());
    facts.add("lights", "{}", scene.lights.size());
    facts.add("environment", "{}", scene.environment ? "yes" : "no");
    for (const auto& [name, material] : scene.materials) {
        const auto* paint = std::get_if<render::PaintMaterial>(&material);
        facts.add("material " + name, "{}",
                  !paint                  ? "diffuse"
                  : paint->recipe.empty() ? "the paint that --paint names"
                                          : "paint " + paint->recipe.string());
    }
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
        const auto* mesh = std::get_if<render::MeshFile>(&scene.shapes[i].geometry);
        if (!mesh) continue;
        const render::Mesh read = render::make_mesh(*mesh);
        facts.add(fmt::format("shapes[{}]", i), "mesh {}, {} triangles, {} vertices",
                  mesh->path.string(), read.triangles.size(), read.positions_mm.size());
    }
}

void describe_other(Facts& facts, const io::TypedFile& typed) {
    using io::FileKind;
    const FileKind kind = typed.kind;
    const std::string& bytes = typed.bytes;
    const std::string& file = typed.name;
    if (kind == FileKind::other_encoding) require_utf8(bytes, file);
    if (kind == FileKind::other_table)
        io::parse_measurement_file(bytes, file);  // says what it lacks
    const std::string words = io::words_for(kind);
    if (kind >= FileKind::empty) {
        throw InputError(fmt::format("{}: is {}", file, words));
    }
    facts.add("kind", "{}", words);
    facts.add("bytes", "{}", bytes.size());
    switch (kind) {
        case FileKind::geometry_set:
            return describe_geometries(facts, typed);
        case FileKind::pigment:
            return describe_pigment(facts, typed);
        case FileKind::drawdown:
            return describe_drawdown(facts, bytes, file);
        case FileKind::material:
            return describe_material(facts, bytes, file);
        case FileKind::spectrum:
            return describe_spectrum(facts, bytes, file);
        case FileKind::mesh:
            return describe_mesh(facts, bytes, file);
        case FileKind::result_table:
            return describe_result_table(facts, bytes, file);
        case FileKind::result_document:
            facts.add("holds", "{}", io::result_of(bytes));
            return describe_document(facts, bytes, file);
        case FileKind::report:
            return describe_document(facts, bytes, file);
        case FileKind::cycles_script:
            return describe_cycles_script(facts, bytes);
        case FileKind::threejs_module:
            return describe_threejs_module(facts, bytes);
        default:
            return;  // pages, drawings and materials for others: what they are says enough
    }
}

}  // namespace nacre::cli
