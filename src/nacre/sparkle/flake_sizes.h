#pragma once

#include <array>
#include <cstdint>

namespace nacre::sparkle {

/// Diameters of the flakes of a population: a normal distribution, cut off at three deviations and
/// at a quarter of its mean and renormalised, from 16 bits of a hash.
class FlakeSizes {
 public:
    /// @param mean_um, spread_um  mean and standard deviation before it is cut
    /// @throws DomainError unless 0 < mean_um and 0 <= spread_um <= mean_um
    FlakeSizes(double mean_um, double spread_um);

    float diameter_um(std::uint32_t bits) const {
        constexpr std::uint32_t kStep = 65536 / kIntervals;
        const std::uint32_t i = bits / kStep;
        const float f = (static_cast<float>(bits % kStep) + 0.5f) / kStep;
        return quantiles_[i] + f * (quantiles_[i + 1] - quantiles_[i]);
    }
    /// Mean of pi/4 d^2 over the law of diameter_um(), in um^2.
    double mean_area_um2() const { return mean_area_um2_; }
    double smallest_um() const { return quantiles_.front(); }
    double largest_um() const { return quantiles_.back(); }

 private:
    static constexpr int kIntervals = 256;
    std::array<float, kIntervals + 1> quantiles_;
    double mean_area_um2_;
};

}  // namespace nacre::sparkle
