#pragma once

#include <cstddef>
#include <string>
#include <vector>

// A measured BRDF in the adaptive parameterization of the RGL material database, as plain arrays
// with the names of the file format (io/rgl_file.h reads and writes it; measured_rgl.h renders it;
// docs/measured.md explains it).                                          [dupuy-jakob-2018]

namespace nacre::bsdf {

/// Values over the unit square, rows along phi and columns along theta, at equal steps from edge to
/// edge, bilinear between:  theta = (pi/2) x^2,  phi = (2 y - 1) pi.
struct SquareTable {
    int rows = 2, columns = 2;  ///< at least 2 of each
    std::vector<float> values;  ///< [row][column]

    friend bool operator==(const SquareTable&, const SquareTable&) = default;
};

/// The incident direction (phi_i, theta_i) chooses a slice; between slices everything is linear,
/// beyond the first and the last it is constant.
///
/// A point of the unit square stands for a half vector m through the inverse of the distribution
/// function of `vndf`, rows first. There the file holds the measurement
///
///     spectra = f cos(theta_o) 4 sigma(w_i) / D(m)        (jacobian set)
///     spectra = f cos(theta_o)                            (else)
///
/// with the BRDF f in 1/sr: light goes where facets are, so that few points of the square suffice.
/// Azimuths of m count from that of w_i where the surface is isotropic.
struct RglTable {
    std::string description;
    bool jacobian = true;
    std::vector<float> phi_i;      ///< rad, increasing; one or two of them: isotropic
    std::vector<float> theta_i;    ///< rad, increasing, in [0, pi/2]
    SquareTable ndf;               ///< D(m) >= 0, in 1/sr, to a factor that sigma shares
    SquareTable sigma;             ///< projected area of the facets seen from a direction, >= 1e-9
    int vndf_rows = 2;             ///< along phi_m
    int vndf_columns = 2;          ///< along theta_m
    std::vector<float> vndf;       ///< [phi_i][theta_i][row][column] >= 0
    int resolution = 2;            ///< rows and columns of the two below
    std::vector<float> luminance;  ///< [phi_i][theta_i][row][column] >= 0: steers sampling only
    std::vector<float> wavelengths;  ///< nm, increasing; none: linear Rec. 709 in three channels
    std::vector<float> spectra;      ///< [phi_i][theta_i][channel][row][column]

    bool isotropic() const { return phi_i.size() <= 2; }
    bool is_rgb() const { return wavelengths.empty(); }
    std::size_t channels() const { return is_rgb() ? 3 : wavelengths.size(); }
    std::size_t slices() const { return phi_i.size() * theta_i.size(); }

    friend bool operator==(const RglTable&, const RglTable&) = default;
};

/// More than any spectrometer has; the albedo is found for each.
inline constexpr std::size_t kMostRglWavelengths = 4096;

/// @throws DomainError naming the field, its value and what is allowed: sizes that do not fit
/// together, values that are not finite or negative where they must not be (spectra may be: noise),
/// angles or wavelengths that do not increase or leave their range, too many wavelengths, azimuths
/// of an anisotropic surface that span neither 90 nor 180 nor 360 deg or do not begin at -180 deg
void validate(const RglTable& table);

}  // namespace nacre::bsdf
