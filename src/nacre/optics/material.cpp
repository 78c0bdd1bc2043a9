#include "nacre/optics/material.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/core/text.h"
#include "nacre/optics/material_file.h"

namespace nacre::optics {

namespace {

std::string index_name(ComplexIndex index) {
    return index.imag() == 0 ? fmt::format("{}", index.real())
                             : fmt::format("{}{:+}i", index.real(), index.imag());
}

void require_valid_index(ComplexIndex index, const std::string& name) {
    if (!kRefractiveIndexRange.contains(index.real())) {
        throw DomainError(fmt::format("material \"{}\": n = {} is outside {}", name, index.real(),
                                      kRefractiveIndexRange.text()));
    }
    if (!kExtinctionRange.contains(index.imag())) {
        throw DomainError(
            fmt::format("material \"{}\": k = {} is outside {} (k >= 0 absorbs, gain "
                        "is not modelled)",
                        name, index.imag(), kExtinctionRange.text()));
    }
}

}  // namespace

Material::Material(ComplexIndex index) : Material(index_name(index), index) {}

Material::Material(std::string name, ComplexIndex index, std::string source)
    : name_(std::move(name)), source_(std::move(source)), index_{index} {
    require_valid_index(index, name_);
}

Material::Material(std::string name, std::vector<double> wavelengths_nm,
                   std::vector<ComplexIndex> index, std::string source)
    : name_(std::move(name)),
      source_(std::move(source)),
      wavelengths_nm_(std::move(wavelengths_nm)),
      index_(std::move(index)) {
    if (wavelengths_nm_.size() != index_.size() || index_.size() < 2) {
        throw DomainError(
            fmt::format("material \"{}\": {} wavelengths and {} indices; a dispersive material has "
                        "as many of both, at least 2",
                        name_, wavelengths_nm_.size(), index_.size()));
    }
    for (std::size_t i = 0; i < index_.size(); ++i) {
        const double w = wavelengths_nm_[i];
        if (!(std::isfinite(w) && w > (i == 0 ? 0.0 : wavelengths_nm_[i - 1]))) {
            throw DomainError(fmt::format(
                "material \"{}\": wavelength {} nm is not above {} nm; wavelengths must increase",
                name_, w, i == 0 ? 0.0 : wavelengths_nm_[i - 1]));
        }
        require_valid_index(index_[i], name_);
    }
}

double Material::first_wavelength_nm() const {
    return is_dispersive() ? wavelengths_nm_.front() : 0.0;
}

double Material::last_wavelength_nm() const {
    return is_dispersive() ? wavelengths_nm_.back() : std::numeric_limits<double>::infinity();
}

ComplexIndex Material::index(double wavelength_nm) const {
    if (!(wavelength_nm > 0 && wavelength_nm >= first_wavelength_nm() &&
          wavelength_nm <= last_wavelength_nm())) {
        throw DomainError(fmt::format("material \"{}\" has no data at {} nm, only from {} to {} nm",
                                      name_, wavelength_nm, first_wavelength_nm(),
                                      last_wavelength_nm()));
    }
    if (!is_dispersive()) return index_.front();
    const auto above =
        std::upper_bound(wavelengths_nm_.begin(), wavelengths_nm_.end() - 1, wavelength_nm);
    const auto i = static_cast<std::size_t>(above - wavelengths_nm_.begin());
    const double t =
        (wavelength_nm - wavelengths_nm_[i - 1]) / (wavelengths_nm_[i] - wavelengths_nm_[i - 1]);
    return index_[i - 1] * (1 - t) + index_[i] * t;
}

namespace {

const std::map<std::string, Material>& catalogue() {
    static const std::map<std::string, Material> materials = [] {
        std::map<std::string, Material> all;
        for (const ShippedMaterial& shipped : shipped_materials()) {
            const std::string name(shipped.name);
            all.emplace(name, parse_material_csv(shipped.csv, name));
        }
        return all;
    }();
    return materials;
}

/// "n", "n+ki" or "n-ki".
std::optional<ComplexIndex> parse_index(std::string_view text) {
    const auto n = take_number(text);
    if (!n) return std::nullopt;
    if (text.empty()) return ComplexIndex(*n, 0);
    if (text.front() != '+' && text.front() != '-') return std::nullopt;
    const auto k = take_number(text);
    if (!k || text != "i") return std::nullopt;
    return ComplexIndex(*n, *k);
}

bool is_material_file(const std::filesystem::path& path) {
    const std::string extension = lowercase(path.extension().string());
    return extension == ".csv" || extension == ".yml" || extension == ".yaml";
}

/// Whether the first line that is neither empty nor a comment is the header of a table.
bool has_material_header(std::string_view text) {
    for (const std::string_view line : split(without_byte_order_mark(text), '\n')) {
        const std::string_view content = trimmed(line);
        if (!content.empty() && content.front() != '#') return content.starts_with("wavelength_nm");
    }
    return false;
}

/// Where a material's file is.
std::filesystem::path material_path(const std::filesystem::path& name,
                                    const References& references) {
    try {
        return references.resolve(name);
    } catch (const InputError& error) {
        throw InputError(fmt::format("material \"{}\" {}", excerpt(name.string()), error.what()));
    }
}

}  // namespace

Material parse_material(std::string_view text, const std::string& name) {
    return has_material_header(text) ? parse_material_csv(text, name)
                                     : parse_material_yaml(text, name);
}

Material parse_material_file(std::string_view text, const std::filesystem::path& path) {
    const std::string name = path.string();
    if (is_stream(path)) return parse_material(text, name);
    const bool csv = lowercase(path.extension().string()) == ".csv";
    return csv ? parse_material_csv(text, name) : parse_material_yaml(text, name);
}

Material read_material_file(const std::filesystem::path& path) {
    return parse_material_file(read_file(path, kMaxMaterialFileBytes), path);
}

Material find_material(const std::string& text, const References& references) {
    const std::string_view wanted = trimmed(text);
    if (const auto index = parse_index(wanted)) {
        try {
            return Material(*index);
        } catch (const DomainError& error) {
            throw InputError(error.what());
        }
    }
    if (const auto found = catalogue().find(std::string(wanted)); found != catalogue().end()) {
        return found->second;
    }
    if (const std::filesystem::path path(wanted); is_material_file(path)) {
        const std::filesystem::path file = material_path(path, references);
        return parse_material_file(*references.read(file, kMaxMaterialFileBytes), file);
    }
    throw InputError(fmt::format(
        "material \"{}\" is not an index (as 1.5 or 3.18+3.33i), not the path of a .csv, .yml or "
        ".yaml file, and not a shipped material{}; those are: {}",
        excerpt(wanted), did_you_mean(excerpt(wanted), material_names()),
        fmt::join(material_names(), ", ")));
}

std::vector<std::string> material_names() {
    std::vector<std::string> names;
    for (const auto& [name, material] : catalogue()) names.push_back(name);
    return names;
}

}  // namespace nacre::optics
