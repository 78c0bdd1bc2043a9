#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include "nacre/bsdf/bsdf.h"
#include "nacre/core/progress.h"
#include "nacre/core/vec.h"

// A measured isotropic BRDF over half and difference angles, as the MERL database keeps it.
//                                                          [matusik-2003; rusinkiewicz-1998]

namespace nacre::bsdf {

/// Directions as half vector and difference vector. An isotropic BRDF does not depend on the
/// azimuth of the first; exchanging the directions adds pi to phi_d, so that a reciprocal one is
/// known from [0, pi).
struct HalfDifference {
    double theta_half, theta_difference, phi_difference;  ///< rad
};

/// Values by cell. Cell k of n along theta_half lies at theta_half = (pi/2) ((k + 1/2)/n)^2, cells
/// along theta_difference and phi_difference at (pi/2) (k + 1/2)/n and pi (k + 1/2)/n.
struct MerlTable {
    static constexpr int kHalf = 90, kDifference = 90, kAzimuths = 180;
    /// Red, green, blue: factors from a number of the file to 1/sr. [the database's reading code]
    static constexpr std::array<double, 3> kScale = {1.0 / 1500, 1.15 / 1500, 1.66 / 1500};

    int half = kHalf, difference = kDifference, azimuths = kAzimuths;
    /// [channel][half][difference][azimuth], as in the file; negative: not measured.
    std::vector<double> values;

    std::size_t cells() const { return static_cast<std::size_t>(half) * difference * azimuths; }
    std::size_t cell(int h, int d, int a) const {
        return (static_cast<std::size_t>(h) * difference + d) * azimuths + a;
    }
    /// The angles in the middle of a cell.
    HalfDifference middle(int h, int d, int a) const;

    friend bool operator==(const MerlTable&, const MerlTable&) = default;
};

/// Cells along one of the angles.
inline constexpr int kMaxMerlCells = 1024, kMinMerlCells = 2;

/// @throws DomainError naming what is wrong: a size out of range, values that do not fit the sizes
/// or are not finite
void validate(const MerlTable& table);

/// Of two directions above the surface.
HalfDifference half_difference(Vec3f wi, Vec3f wo);

struct DirectionPair {
    Vec3d wi, wo;  ///< the half vector in the plane of x and z, towards +x
};
DirectionPair directions_of(const HalfDifference& angles);

/// An isotropic BRDF measured over half and difference angles, in RGB.
///                                                         [matusik-2003; rusinkiewicz-1998]
/// Evaluation interpolates linearly between the middles of the eight nearest cells: in
/// sqrt(theta_half), theta_difference and phi_difference, the last of which is periodic. Cells that
/// were not measured do not take part; where all eight were not, the surface is black. The
/// database's own reading code takes the cell in which the angles lie: in the middle of a cell both
/// give the same. RGB becomes a spectrum by spectra::linear_rec709_basis().
///
/// Reciprocal by construction. Energy is as measured: the database has materials that reflect more
/// than they receive near grazing.
///
/// Samples come from a cosine lobe and lobes of four roughnesses, their probability fitted to the
/// table for each incident angle; the density is exact, weights may vary where no mixture of those
/// fits.
class MeasuredMerl final : public Bsdf {
 public:
    /// @throws DomainError as validate(table); Stopped if `work`, which is asked where it is not
    ///         null, says so
    explicit MeasuredMerl(const MerlTable& table, SharedProgress* work = nullptr);
    ~MeasuredMerl() override;

    std::unique_ptr<const BoundBsdf> bind(const Wavelengths& wavelengths_nm) const override;

    struct Tables;

 private:
    std::shared_ptr<const Tables> tables_;
};

}  // namespace nacre::bsdf
