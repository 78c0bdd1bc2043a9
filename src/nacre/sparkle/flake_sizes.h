#pragma once

#include <array>
#include <cstdint>

namespace nacre::sparkle {

/// Diameters of the flakes of a population: a normal distribution, cut off at three deviations and
/// at a quarter of its mean and renormalised, as the medians of kSizes equally probable parts.
class FlakeSizes {
 public:
    static constexpr int kSizes = 256;

    /// @param mean_um, spread_um  mean and standard deviation before it is cut
    /// @throws DomainError unless 0 < mean_um and 0 <= spread_um <= mean_um
    FlakeSizes(double mean_um, double spread_um);

    /// @param size  in [0, kSizes)
    float diameter_um(std::uint32_t size) const { return diameters_um_[size]; }
    /// All kSizes, for gathering several at once.
    const float* diameters_um() const { return diameters_um_.data(); }
    /// Mean of pi/4 d^2, in um^2.
    double mean_area_um2() const { return mean_area_um2_; }
    double smallest_um() const { return diameters_um_.front(); }
    double largest_um() const { return diameters_um_.back(); }

 private:
    std::array<float, kSizes> diameters_um_;
    double mean_area_um2_;
};

}  // namespace nacre::sparkle
