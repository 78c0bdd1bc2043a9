#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "nacre/core/error.h"

namespace nacre::paint {

/// What a flake's diameter may be.
inline constexpr Range kFlakeSize_um{1e-3, 1e6, "um"};

/// Diameters of the flakes of a population, as kSizes equally probable ones.
class FlakeSizes {
 public:
    static constexpr int kSizes = 256;

    /// A normal distribution, cut off at three deviations and at a quarter of its mean and
    /// renormalised, as the medians of kSizes equally probable parts.
    /// @param mean_um, spread_um  mean and standard deviation before it is cut
    /// @throws DomainError unless mean_um is in kFlakeSize_um and 0 <= spread_um <= mean_um
    FlakeSizes(double mean_um, double spread_um);
    /// @throws DomainError unless all are in kFlakeSize_um
    explicit FlakeSizes(const std::array<double, kSizes>& diameters_um);

    /// @param size  in [0, kSizes)
    float diameter_um(std::uint32_t size) const { return diameters_um_[size]; }
    /// All kSizes, for gathering several at once.
    const float* diameters_um() const { return diameters_um_.data(); }
    /// Mean of pi/4 d^2, in um^2.
    double mean_area_um2() const { return mean_area_um2_; }
    /// Mean of d weighted by the area of the flakes, sum of d^3 over sum of d^2, in um.
    double area_weighted_mean_um() const;
    double smallest_um() const { return diameters_um_.front(); }
    double largest_um() const { return diameters_um_.back(); }

    friend bool operator==(const FlakeSizes&, const FlakeSizes&) = default;

 private:
    std::array<float, kSizes> diameters_um_;
    double mean_area_um2_;
};

/// Diameters as makers state them: a tenth, half and nine tenths of the powder's volume are in
/// flakes smaller than these.
///
/// The logarithm of the diameter has a normal law on either side of the median, so that all three
/// numbers hold; it is log-normal where d50^2 = d10 d90. The volume is that of spheres of the
/// flakes' diameters, d^3, as instruments by laser diffraction state it, whatever the shape.
struct DiameterQuantiles {
    double d10_um = 0, d50_um = 0, d90_um = 0;

    friend bool operator==(const DiameterQuantiles&, const DiameterQuantiles&) = default;
};

/// The median diameter alone, as many data sheets have it; d10 and d90 are a typical pigment's.
struct MedianDiameter {
    double d50_um = 0;

    friend bool operator==(const MedianDiameter&, const MedianDiameter&) = default;
};

/// What a data sheet says of the diameters.
using StatedQuantiles = std::variant<MedianDiameter, DiameterQuantiles>;

/// d90 / d50 and d50 / d10 of a typical pigment. Of this log-normal law 86 and 90 % of the volume
/// are within factors of 5 and 6 about the median, such as the 5 to 25 and 10 to 60 um that
/// titania on mica is sold in [pfaff-reynders-1999; buxbaum-pfaff-2005]; that such a range is to
/// hold nearly all of the volume is a reading of ours.
inline constexpr double kTypicalDecileRatio = 2;

/// The law that is meant: as stated, or with d10 = d50 / kTypicalDecileRatio and d90 = d50
/// kTypicalDecileRatio. Not checked.
DiameterQuantiles quantiles_of(const StatedQuantiles& stated);

/// A fraction of the flakes' area, and the diameters of the flakes that have it.
struct SizePart {
    double area_fraction = 1;
    FlakeSizes sizes;
};

/// The law is cut off here, in its standard deviations by volume: 0.3 % of the volume is left out.
inline constexpr double kQuantilesCut = 3;
/// d10, d50 and d90 of the parts together are those of the law within this fraction.
inline constexpr double kSizePartError = 0.02;

/// The smallest and the largest diameter, where the law is cut off.
/// @param quantiles  d10 < d50 < d90
std::array<double, 2> size_ends_um(const DiameterQuantiles& quantiles);

/// The law in parts by size, from the smallest up. By number nearly all flakes are fines that have
/// hardly any area; in a part that spans a factor of 2.5 or less every size is drawn often enough.
/// @throws DomainError unless 0 < d10 < d50 < d90, and the flakes are in kFlakeSize_um
std::vector<SizePart> size_parts(const DiameterQuantiles& quantiles);

/// The discs that remain where a rim of this width is taken off, by area of all flakes; those that
/// vanish are left out.
/// @param rim_um  below half the largest diameter
SizePart without_rim(const FlakeSizes& sizes, double rim_um);

}  // namespace nacre::paint
