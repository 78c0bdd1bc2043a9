#pragma once

#include <complex>
#include <filesystem>
#include <string>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/core/references.h"

// Refractive indices with dispersion. Signs and the meaning of k: docs/conventions.md.

namespace nacre::optics {

using ComplexIndex = std::complex<double>;  // n + i k, k >= 0 absorbs

inline constexpr Range kRefractiveIndexRange{.lo = 0, .hi = 1e3, .lo_open = true};
inline constexpr Range kExtinctionRange{.lo = 0, .hi = 1e3};

/// A substance by its refractive index: a constant, or samples between which n and k are linear.
/// A value: copies are cheap enough and compare equal when they describe the same substance.
class Material {
 public:
    /// A medium without dispersion, named after its index.
    Material(ComplexIndex index = 1.0);                        // NOLINT: a number is a material
    Material(double index) : Material(ComplexIndex(index)) {}  // NOLINT: likewise
    /// @throws DomainError if sizes differ or are below 2, wavelengths do not increase, or n or k
    /// is out of range.
    Material(std::string name, std::vector<double> wavelengths_nm, std::vector<ComplexIndex> index,
             std::string source = {});
    Material(std::string name, ComplexIndex index, std::string source = {});

    /// @throws DomainError naming material, wavelength and range if the data do not reach there
    ComplexIndex index(double wavelength_nm) const;

    bool is_dispersive() const { return index_.size() > 1; }
    double first_wavelength_nm() const;  ///< 0 for a constant
    double last_wavelength_nm() const;   ///< infinity for a constant
    const std::string& name() const { return name_; }
    const std::string& source() const { return source_; }
    const std::vector<double>& wavelengths_nm() const { return wavelengths_nm_; }
    const std::vector<ComplexIndex>& samples() const { return index_; }

    friend bool operator==(const Material&, const Material&) = default;

 private:
    std::string name_, source_;
    std::vector<double> wavelengths_nm_;
    std::vector<ComplexIndex> index_;
};

/// Looks a material up: a number ("1.5", "3.18+3.33i"), a name from the shipped data
/// ("TiO2_anatase"), or the path of a user's file (.csv, or .yml of refractiveindex.info).
/// @param references  the files that it may be
/// @throws InputError with the text, what was tried and the names that exist
Material find_material(const std::string& text,
                       const References& references = References::anywhere({}));

/// Names of the shipped materials, sorted.
std::vector<std::string> material_names();

}  // namespace nacre::optics
