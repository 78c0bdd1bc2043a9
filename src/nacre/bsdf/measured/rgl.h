#pragma once

#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "nacre/bsdf/bsdf.h"
#include "nacre/bsdf/warp.h"
#include "nacre/core/math.h"

// A measured BRDF in the adaptive parameterization of the RGL material database: plain arrays with
// the names of the file format (read and written by io/measured_brdf_file.h), and the surface that
// evaluates and samples them. docs/measured.md explains it.                     [dupuy-jakob-2018]

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
/// A point of the unit square corresponds to a half vector m by the inverse of the distribution
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
inline constexpr std::size_t kMaxRglWavelengths = 4096;

/// @throws DomainError naming the field, its value and what is allowed: sizes that do not fit
/// together, values that are not finite or negative where they must not be (spectra may be: noise),
/// angles or wavelengths that do not increase or leave their range, too many wavelengths, azimuths
/// of an anisotropic surface that span neither 90 nor 180 nor 360 deg or do not begin at -180 deg
void validate(const RglTable& table);

// From directions to the unit square of an adaptive measurement, and back.   [dupuy-jakob-2018]

/// Angle from the normal, without the loss of digits that acos has near it.
inline float polar_angle(Vec3f w) {
    const float chord = std::sqrt(w.x * w.x + w.y * w.y + (w.z - 1) * (w.z - 1));
    return 2 * std::asin(std::min(1.0f, 0.5f * chord));
}

/// theta = (pi/2) x^2, phi = (2 y - 1) pi.
inline Vec2f square_point(float theta, float phi) {
    const float y = (phi + kPiF) * (0.5f / kPiF);
    return {std::sqrt(theta * (2 / kPiF)), y - std::floor(y)};
}

/// The incident side of a lookup.
struct RglIncident {
    Vec3f direction;       ///< turned into the part of the hemisphere that was measured
    float flip_x, flip_y;  ///< what turned it: factors of 1 or -1
    float phi;             ///< azimuth from which those of half vectors count
    float inverse_sigma;
    SliceMix mix;
};

/// A half vector and the point of the square that corresponds to it; or eight.
template <class T>
struct RglPointOf {
    Vec2<T> sample;  ///< where the measurement is read
    Vec2<T> half;    ///< theta and phi of the half vector in the square of ndf and vndf
    Vec3<T> normal;  ///< the half vector
    T density;       ///< of `half` by vndf
};
using RglPoint = RglPointOf<float>;

class RglMap {
 public:
    explicit RglMap(const RglTable& table, SharedProgress* work = nullptr);

    RglIncident incident(Vec3f wi) const;
    /// The point for a pair of directions; wo in the same frame as i.direction.
    RglPoint towards(const RglIncident& i, Vec3f wo) const;
    RglPointOf<FloatLanes> towards(const RglIncident& i, const Vec3Lanes& wo) const;
    /// The half vector for a point at which the measurement is read.
    RglPoint at(const RglIncident& i, Vec2f sample) const;
    /// Factor from a value of the table to f cos(theta_o).
    float scale(const RglIncident& i, const RglPoint& point) const;
    /// Density per solid angle of wo, if `sample` is uniform.
    template <class T>
    T solid_angle_density(const RglIncident& i, const RglPointOf<T>& point) const;

    const SliceGrid& grid() const { return grid_; }

 private:
    bool isotropic_, jacobian_;
    int parts_;  ///< how often the measured azimuths fit into the circle; 1: no symmetry
    SliceGrid grid_;
    SquareTable ndf_, sigma_;
    SquareWarp vndf_;
};

/// Bilinear.
float read_square(const SquareTable& table, Vec2f point);

/// A BRDF measured in the adaptive parameterization, isotropic or anisotropic, spectral or RGB.
///                                                      [dupuy-jakob-2018, section 4]
/// Evaluation is that of the format: the half vector goes back through the visible-normal map to a
/// point of the unit square, where the table is read bilinearly; linear between incident
/// directions; linear between wavelengths and constant beyond their ends. RGB becomes a spectrum by
/// spectra::linear_rec709_basis(). Negative values (noise) are cut off at zero.
///
/// Sampling follows the luminance table and then the visible normals; the density is exact, and
/// samples that leave below the horizon are lost, so that it integrates to less than 1. Where both
/// tables come from the same measurement, weights are near the albedo.
///
/// Measured data, and their interpolation, conserve neither energy nor reciprocity: wi plays the
/// part of the lamp in the measurement, whichever way the light goes. There is no specular lobe.
class MeasuredRgl final : public Bsdf {
 public:
    /// @throws DomainError as validate(table); Stopped if `work`, which is asked where it is not
    ///         null, says so
    explicit MeasuredRgl(const RglTable& table, SharedProgress* work = nullptr);
    ~MeasuredRgl() override;

    std::unique_ptr<const BoundBsdf> bind(const Wavelengths& wavelengths_nm) const override;

    struct Tables;

 private:
    std::shared_ptr<const Tables> tables_;
};

}  // namespace nacre::bsdf
