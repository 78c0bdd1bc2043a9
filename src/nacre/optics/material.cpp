#include "nacre/optics/material.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "nacre/core/error.h"

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

}  // namespace nacre::optics
